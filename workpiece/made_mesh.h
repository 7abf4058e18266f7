// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fill/part_filling.h"
#include "imprint/imprint.h"
#include "surface/surface.h"

#include <memory>
#include <span>
#include <vector>

namespace bspline_curve {

/// A mesh that was made from a workpiece's by imprinting curves, and where all of it comes from, so
/// that hosts can carry over what goes with that. Shares the imprint with other parts of it.
class MadeMesh {
public:
    /// `surface`, `joined` and `imprint`: see Imprint; `taken`: of the latter.
    MadeMesh(
        std::shared_ptr<const Surface> surface,
        std::shared_ptr<const ImprintedMesh> joined,
        std::shared_ptr<const ImprintedMesh> imprint,
        FilledParts taken
    );

    [[nodiscard]] const TriangleMesh& mesh() const { return taken_.mesh; }

    [[nodiscard]] const FilledParts& parts() const { return taken_; }

    /// For each face its part; -1: it fills a hole.
    [[nodiscard]] const std::vector<int>& labels() const { return taken_.labels; }

    /// The workpiece's vertex that a vertex is, at the same place; -1: it is new. Several vertices
    /// may be one that mending doubled.
    [[nodiscard]] int vertexOf(int vertex) const;
    /// The workpiece's face that a face is part of; -1: it fills a hole.
    [[nodiscard]] int faceOf(int face) const;
    /// Barycentric coordinates of a corner of a face in the workpiece's face that it is part of.
    /// Expects a face that is part of one.
    [[nodiscard]] Vec3 placeOf(int face, int corner) const;
    /// Values at the vertices, from those at the workpiece's: linear in each face; harmonic
    /// in a filled hole.
    [[nodiscard]] std::vector<double> carried(std::span<const double> values) const;
    /// 1 for each vertex on a curve, else 0.
    [[nodiscard]] std::vector<double> curveFlags() const;

private:
    std::shared_ptr<const Surface> surface_;
    std::shared_ptr<const ImprintedMesh> joined_;
    std::shared_ptr<const ImprintedMesh> imprint_;
    FilledParts taken_;
};

}  // namespace bspline_curve

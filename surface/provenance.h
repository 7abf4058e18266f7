// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "bspline_curve/error.h"
#include "surface/repair.h"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace bspline_curve {

/// From the vertices and faces of a surface to those of its input, the mesh that it was made from,
/// and back. Everything that users hold (ids, points, values) belongs to the input; what mending
/// changed stays between a surface and the algorithms that run on it. Copies share all data.
class Provenance {
public:
    /// Nothing was mended: the surface's ids are those of the input.
    Provenance() = default;

    /// `repair`: how `input` was mended; its own mesh is not looked at. `refusal`: what `input` was
    /// refused for.
    Provenance(TriangleMesh input, MeshRepair repair, std::optional<InputError> refusal);

    /// For a mesh that was made of a surface's own, `between`, by a further repair: from there to
    /// the surface's input. Only points, faces and corners have a place there.
    Provenance(const Provenance& before, const TriangleMesh& between, const MeshRepair& repair);

    [[nodiscard]] bool isIdentity() const { return data_ == nullptr; }

    /// The input; null where nothing was mended.
    [[nodiscard]] const TriangleMesh* input() const;
    /// What was mended; null: nothing.
    [[nodiscard]] const RepairReport* report() const;
    /// What was wrong with the input, with its ids, and that mending helps; none also where it was
    /// welded.
    [[nodiscard]] std::optional<InputError> refusal() const;
    /// Whether faces were parted since their sides disagree however they are turned.
    [[nodiscard]] bool isOneSided() const;
    /// For users: "the mesh was mended: 1 vertex duplicated"; empty where nothing was.
    [[nodiscard]] std::string note() const;

    /// The input's vertex that a vertex is, at the same place. Mending may have doubled it.
    [[nodiscard]] int inputVertex(int vertex) const;

    /// For each face the input's vertices at its corners, where these are not all those of
    /// inputVertex(): along seams that were open in the input the faces on either side have their
    /// own, and after a further repair inputVertex() knows none. -1: the input has no vertex at the
    /// corner. Else empty.
    [[nodiscard]] std::span<const Triangle> inputCorners() const;

    [[nodiscard]] bool hasInputCorners() const { return !inputCorners().empty(); }

    /// One number for all vertices that are one in the input or along seams, see PartedEdges; empty
    /// where nothing was mended.
    [[nodiscard]] std::vector<int> vertexRoots() const;
    /// The input's face that a face is, or is a part of.
    [[nodiscard]] int inputFace(int face) const;
    /// The same point as a face and barycentric coordinates of the input.
    [[nodiscard]] SurfacePoint toInput(const SurfacePoint& point) const;
    void bringToInput(SurfacePolyline& line) const;
    /// The polyline, and the faces that the report names.
    void bringToInput(Curve& curve) const;
    /// A flag per face as one per face of the input: set where that of one of its parts is.
    [[nodiscard]] std::vector<char> flagsOfInput(std::vector<char> flags) const;
    /// A value per vertex as one per vertex of the input: vertices that were merged have the value
    /// of what they became.
    [[nodiscard]] std::vector<double> valuesOfInput(std::vector<double> values) const;

    /// A point of the input on the surface; none where its face was removed. In a face that was
    /// split, points up to kSnapBarycentric from the edge between its parts come onto it. O(log n).
    [[nodiscard]] std::optional<SurfacePoint> fromInput(const SurfacePoint& point) const;
    /// The faces that come from some faces of the input, ascending.
    [[nodiscard]] std::vector<int> facesFromInput(std::span<const int> faces) const;
    /// A value per vertex of the input, at the vertices of the surface.
    [[nodiscard]] std::vector<double> valuesFromInput(std::span<const double> values) const;

    /// By which a surface that was mended is known again; null: it was not.
    [[nodiscard]] std::shared_ptr<const void> key() const { return data_; }

private:
    struct Data;
    std::shared_ptr<const Data> data_;  // null: the identity
};

}  // namespace bspline_curve

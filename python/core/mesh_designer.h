// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/designer.h"
#include "bspline_curve/field.h"
#include "surface/mending.h"
#include "surface/triangle_tree.h"

#include <deque>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

// Curves on a mesh as the caller gave it, whether or not it had to be mended for them.
namespace bspline_curve::python {

/// CurveInputs of a mesh that curves are drawn on.
struct CarriedInputs {
    std::vector<double> field;
    std::vector<int> avoid;
};

/// A designer, and the way from its mesh to the given one. Faces and vertices are everywhere those
/// of the given mesh.
class MeshDesigner {
public:
    /// `given` is kept where the mesh was mended, and not used else.
    MeshDesigner(Mended<CurveDesigner> made, TriangleMesh given)
        : made_(std::move(made)), given_(std::move(given)) {}

    [[nodiscard]] const TriangleMesh& mesh() const {
        return made_.mending ? given_ : made_.made.mesh();
    }

    [[nodiscard]] const CurveDesigner& designer() const { return made_.made; }

    /// What was mended; empty where nothing was.
    [[nodiscard]] std::string mendingNote() const {
        return made_.mending ? made_.mending->note() : std::string();
    }

    /// Throws as CurveDesigner::design(). A curve on a mended mesh starts from scratch, since the
    /// points of `inputs.start` are on the given one.
    [[nodiscard]] Curve design(
        const std::vector<Vec3>& picks,
        const SolverOptions& solver,
        const SamplingOptions& sampling,
        const CurveInputs& inputs,
        const Progress& progress
    ) const;

    /// Throws as makeField(). Where the mesh was mended, a vertex that became several has the value
    /// of one of them; curves under the field have all, see carried().
    [[nodiscard]] std::vector<double> field(
        const FieldOptions& options, const FieldInputs& inputs, const Progress& progress
    ) const;

    /// Field and avoided faces of the given mesh as those of designer().mesh(). A field that
    /// field() made lately is as it was made there.
    [[nodiscard]] CarriedInputs carried(const CurveInputs& inputs) const;

    /// Curves of the given mesh on designer().mesh(). Throws InputError (NoPath) where one passes
    /// from sheet to sheet at an edge where mending parts them.
    [[nodiscard]] std::vector<SurfacePolyline> carried(
        const std::vector<const Curve*>& curves
    ) const;

    /// How the mesh was mended; null: it was not.
    [[nodiscard]] const MeshRepair* repair() const { return made_.repair(); }

    [[nodiscard]] TriangleTree::Closest closestPoint(const Vec3& query) const;

private:
    /// A field of the given mesh, and as it was made on the mended one.
    struct MadeField {
        std::vector<double> given, mended;
    };

    [[nodiscard]] std::vector<double> fieldOnMended(
        std::span<const double> given, const MeshRepair& repair
    ) const;

    Mended<CurveDesigner> made_;
    TriangleMesh given_;
    mutable std::mutex fieldsMutex_;
    mutable std::deque<MadeField> fields_;  ///< the last ones, where the mesh was mended
};

}  // namespace bspline_curve::python

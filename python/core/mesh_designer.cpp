// SPDX-License-Identifier: GPL-3.0-or-later
#include "python/core/mesh_designer.h"

#include "design/curve_on_given_mesh.h"
#include "design/designer_surface.h"
#include "design/strict_polyline.h"
#include "field/make_field.h"
#include "surface/points_on_mended.h"

#include <algorithm>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace bspline_curve::python {

namespace {

constexpr std::size_t kKeptFields = 8;  // one of each kind

std::vector<double> onMended(std::span<const double> values, const MeshRepair& repair) {
    return values.empty() ? std::vector<double>()
                          : repair.carriedOver(std::vector(values.begin(), values.end()));
}

}  // namespace

Curve MeshDesigner::design(
    const std::vector<Vec3>& picks,
    const SolverOptions& solver,
    const SamplingOptions& sampling,
    const CurveInputs& inputs,
    const Progress& progress
) const {
    if (!made_.mending) {
        return made_.made.design(picks, solver, sampling, inputs, progress);
    }
    const CarriedInputs on = carried(inputs);
    const CurveInputs there{.field = on.field, .avoid = on.avoid};
    Curve curve = made_.made.design(picks, solver, sampling, there, progress);
    bringBack(curve, repair());
    return curve;
}

std::vector<double> MeshDesigner::field(
    const FieldOptions& options, const FieldInputs& inputs, const Progress& progress
) const {
    const Surface& surface = surfaceOf(made_.made);
    if (!made_.mending) {
        return makeField(surface, options, inputs, progress);
    }
    const std::vector<double> quality = onMended(inputs.quality, made_.mending->repair);
    const std::vector<int> region = facesOfMended(inputs.region, made_.mending->repair);
    const FieldInputs carried{.quality = quality, .region = region};
    std::vector<double> mended = makeField(surface, options, carried, progress);
    std::vector<double> given = made_.mending->toOrigin(mended);
    const std::scoped_lock lock(fieldsMutex_);
    fields_.push_back({.given = given, .mended = std::move(mended)});
    if (fields_.size() > kKeptFields) {
        fields_.pop_front();
    }
    return given;
}

std::vector<double> MeshDesigner::fieldOnMended(
    std::span<const double> given, const MeshRepair& repair
) const {
    {
        const std::scoped_lock lock(fieldsMutex_);
        for (const MadeField& field : fields_) {
            if (std::ranges::equal(field.given, given)) {
                return field.mended;
            }
        }
    }
    return onMended(given, repair);
}

CarriedInputs MeshDesigner::carried(const CurveInputs& inputs) const {
    if (!made_.mending) {
        return {
            {inputs.field.begin(), inputs.field.end()}, {inputs.avoid.begin(), inputs.avoid.end()}
        };
    }
    const MeshRepair& repair = made_.mending->repair;
    return {fieldOnMended(inputs.field, repair), facesOfMended(inputs.avoid, repair)};
}

std::vector<SurfacePolyline> MeshDesigner::carried(const std::vector<const Curve*>& curves) const {
    std::vector<SurfacePolyline> lines;
    lines.reserve(curves.size());
    if (repair() == nullptr) {
        for (const Curve* curve : curves) {
            lines.push_back(curve->polyline);
        }
        return lines;
    }
    const PointsOnMended there(*repair());
    for (std::size_t i = 0; i < curves.size(); ++i) {
        lines.push_back(there.lineAt(curves[i]->polyline));
        checkUnparted(surfaceOf(made_.made), lines.back(), "curve " + std::to_string(i));
    }
    return lines;
}

TriangleTree::Closest MeshDesigner::closestPoint(const Vec3& query) const {
    TriangleTree::Closest closest = treeOf(made_.made).closestPoint(query);
    if (made_.mending) {
        closest.point = made_.mending->repair.toOrigin(closest.point);
    }
    return closest;
}

}  // namespace bspline_curve::python

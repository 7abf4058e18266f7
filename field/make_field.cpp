// SPDX-License-Identifier: GPL-3.0-or-later
#include "field/make_field.h"

#include "bspline_curve/error.h"
#include "bspline_curve/mesh.h"
#include "bspline_curve/progress.h"
#include "field/curvature_field.h"
#include "field/feature_distance.h"
#include "field/normal_variation.h"
#include "field/obstacle_field.h"
#include "field/surface_diffusion.h"
#include "field/value_range.h"
#include "surface/field_on_surface.h"
#include "text/error_messages.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace bspline_curve {

namespace {

std::vector<double> valuesOf(
    const std::vector<PrincipalCurvatures>& curvatures, double (*value)(const PrincipalCurvatures&)
) {
    std::vector<double> values;
    values.reserve(curvatures.size());
    for (const PrincipalCurvatures& ofVertex : curvatures) {
        values.push_back(value(ofVertex));
    }
    return values;
}

/// Distances to sources as shares of the reach, 1 beyond.
std::vector<double> distanceField(
    const Surface& surface,
    const FieldOptions& options,
    const std::vector<int>& sources,
    const std::string& nothingThere
) {
    if (sources.empty()) {
        throw InputError(
            InputErrorCode::BadField,
            std::string("the field ") + name(options.kind) +
                " has nothing to measure from: " + nothingThere
        );
    }
    const double reach = options.reach * surface.diagonal();
    std::vector<double> values = distancesTo(surface, sources, reach);
    for (double& value : values) {
        value = std::min(value / reach, 1.0);
    }
    return values;
}

std::vector<double> creaseDistance(const Surface& surface, const FieldOptions& options) {
    return distanceField(
        surface,
        options,
        creaseVertices(surface, options.creaseAngle),
        "no edge of the mesh turns by more than the crease angle, " +
            describeNumber(options.creaseAngle) + " degrees; choose a smaller one"
    );
}

std::vector<double> boundaryDistance(const Surface& surface, const FieldOptions& options) {
    return distanceField(
        surface, options, boundaryVertices(surface), "the mesh is closed, without a boundary"
    );
}

std::vector<double> checkedQuality(const Surface& surface, std::span<const double> quality) {
    if (quality.size() != surface.input().vertices.size()) {
        throw InputError(
            InputErrorCode::BadField,
            "the quality has " + std::to_string(quality.size()) + " values, the mesh " +
                std::to_string(surface.input().vertices.size()) + " vertices"
        );
    }
    std::vector<std::int64_t> bad;
    for (std::size_t v = 0; v < quality.size(); ++v) {
        if (!std::isfinite(quality[v])) {
            bad.push_back(static_cast<std::int64_t>(v));
        }
    }
    if (!bad.empty()) {
        refuseElements(
            InputErrorCode::BadField,
            describeCount(bad.size(), "value of the quality is", "values of the quality are") +
                " not finite",
            "vertices",
            bad,
            "give every vertex a number"
        );
    }
    return surface.provenance().valuesFromInput(quality);
}

/// The field of a kind, before what every kind has.
std::vector<double> fieldOfKind(
    const Surface& surface,
    const FieldOptions& options,
    const FieldInputs& inputs,
    const Progress& progress
) {
    const auto curvatures = [&] {
        return principalCurvatures(surface, options.curvatureScale, progress);
    };
    switch (options.kind) {
        case FieldKind::NormalVariation:
            return normalVariation(surface);
        case FieldKind::Ridge:
            return valuesOf(curvatures(), ridgeStrength);
        case FieldKind::Valley:
            return valuesOf(curvatures(), valleyStrength);
        case FieldKind::CreaseDistance:
            return creaseDistance(surface, options);
        case FieldKind::BoundaryDistance:
            return boundaryDistance(surface, options);
        case FieldKind::Quality:
            return checkedQuality(surface, inputs.quality);
        case FieldKind::Obstacle:
            return obstacleField(
                surface,
                surface.provenance().facesFromInput(makeRegion(
                    surface.input(),
                    std::vector<std::int64_t>(inputs.region.begin(), inputs.region.end())
                )),
                options.obstacleValue,
                options.obstacleSlope
            );
        case FieldKind::MaximalCurvature:
            break;
    }
    return valuesOf(curvatures(), maximalCurvature);
}

void smooth(
    std::vector<double>& values,
    const Surface& surface,
    double radiusRelative,
    const Progress& progress
) {
    if (radiusRelative == 0.0) {
        return;
    }
    Eigen::Map<Eigen::VectorXd> mapped(values.data(), static_cast<Eigen::Index>(values.size()));
    // Means lie between what they are of; the solver's tolerance must not show.
    const double low = mapped.minCoeff();
    const double high = mapped.maxCoeff();
    const SurfaceDiffusion diffusion(surface, partOf(progress, 0.0, 0.5));
    const double radius = radiusRelative * surface.diagonal();
    mapped = diffusion.smoothed<1>(mapped, radius, partOf(progress, 0.5, 1.0))
                 .cwiseMax(low)
                 .cwiseMin(high);
}

}  // namespace

ScalarField makeField(
    const Surface& surface,
    const FieldOptions& options,
    const FieldInputs& inputs,
    const Progress& progress
) {
    constexpr double kKindShare = 0.9;  // of the time
    options.validate();
    report(progress, 0.0, "field");
    std::vector<double> values =
        fieldOfKind(surface, options, inputs, partOf(progress, 0.0, kKindShare));
    report(progress, kKindShare, "smoothing");
    smooth(values, surface, options.smoothing, partOf(progress, kKindShare, 1.0));
    if (options.normalised) {
        normalise(values);
    }
    if (options.inverted) {
        invert(values);
    }
    report(progress, 1.0, "field");
    ScalarField field = fieldOf(surface, std::move(values));
    field.setNaturalCost(naturalCost(options.kind));
    return field;
}

ScalarField makeField(
    const TriangleMesh& mesh,
    const FieldOptions& options,
    const FieldInputs& inputs,
    const Progress& progress
) {
    return makeField(Surface(mesh, MendingOptions()), options, inputs, progress);
}

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#include "field/make_field.h"

#include "field/curvature_field.h"
#include "field/normal_variation.h"
#include "field/surface_diffusion.h"

#include <Eigen/Core>

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

/// The field of a kind, before what every kind has.
std::vector<double> fieldOfKind(
    const Surface& surface, const FieldOptions& options, const Progress& progress
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
        case FieldKind::MaximalCurvature:
            break;
    }
    return valuesOf(curvatures(), maximalCurvature);
}

void smooth(std::vector<double>& values, const Surface& surface, double radiusRelative) {
    if (radiusRelative == 0.0) {
        return;
    }
    Eigen::Map<Eigen::VectorXd> mapped(values.data(), static_cast<Eigen::Index>(values.size()));
    // Means lie between what they are of; the solver's tolerance must not show.
    const double low = mapped.minCoeff();
    const double high = mapped.maxCoeff();
    mapped = SurfaceDiffusion(surface)
                 .smoothed<1>(mapped, radiusRelative * surface.diagonal())
                 .cwiseMax(low)
                 .cwiseMin(high);
}

}  // namespace

std::vector<double> makeField(
    const Surface& surface, const FieldOptions& options, const Progress& progress
) {
    constexpr double kKindShare = 0.9;  // of the time
    options.validate();
    std::vector<double> values = fieldOfKind(surface, options, partOf(progress, 0.0, kKindShare));
    report(progress, kKindShare, "smoothing");
    smooth(values, surface, options.smoothing);
    report(progress, 1.0, "field");
    return values;
}

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#include "field/make_field.h"

#include "field/curvature_field.h"
#include "field/surface_diffusion.h"

#include <Eigen/Core>

namespace bspline_curve {

namespace {

using Strength = double (*)(const PrincipalCurvatures&);

Strength strengthOf(FieldKind kind) {
    switch (kind) {
        case FieldKind::Ridge:
            return ridgeStrength;
        case FieldKind::Valley:
            return valleyStrength;
        case FieldKind::MaximalCurvature:
            break;
    }
    return maximalCurvature;
}

std::vector<double> curvatureField(
    const Surface& surface, const FieldOptions& options, const Progress& progress
) {
    const Strength strength = strengthOf(options.kind);
    std::vector<double> values;
    values.reserve(surface.vertices().size());
    for (const PrincipalCurvatures& curvatures :
         principalCurvatures(surface, options.curvatureScale, progress)) {
        values.push_back(strength(curvatures));
    }
    return values;
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
    std::vector<double> values =
        curvatureField(surface, options, partOf(progress, 0.0, kKindShare));
    report(progress, kKindShare, "smoothing");
    smooth(values, surface, options.smoothing);
    report(progress, 1.0, "field");
    return values;
}

}  // namespace bspline_curve

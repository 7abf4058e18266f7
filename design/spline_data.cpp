// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/spline_data.h"

#include <utility>

namespace bspline_curve {

SplineData splineDataOf(
    const SplineCurve& curve, const ShellFrame& frame, std::vector<double> pickParameters
) {
    const auto& [space, controls] = curve;
    SplineData data{
        space.degree(), space.closed(), space.knotVector(), {}, std::move(pickParameters)
    };
    const int repeated = data.closed ? data.degree : 0;
    for (int i = 0; i < space.controlCount() + repeated; ++i) {
        const int c = i % space.controlCount();
        data.controlPoints.push_back(frame.toUser(controls.row(c).transpose()));
    }
    return data;
}

}  // namespace bspline_curve

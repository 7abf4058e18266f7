// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/options.h"

#include "bspline_curve/error.h"

#include <cmath>
#include <sstream>

namespace bspline_curve {
namespace {

template <class Value>
void require(bool holds, const char* field, Value value, const char* rule) {
    if (!holds) {
        std::ostringstream message;
        message << field << " is " << value << ", but must be " << rule;
        throw InputError(InputErrorCode::BadOption, message.str());
    }
}

}  // namespace

void SolverOptions::validate() const {
    require(degree >= 2 && degree <= 4, "degree", degree, "2, 3 or 4");
    require(tension >= 0.0 && tension <= 1.0, "tension", tension, "in [0, 1]");
    require(
        fieldWeight >= 0.0 && std::isfinite(fieldWeight),
        "field weight",
        fieldWeight,
        "finite and not negative"
    );
    require(
        avoidMargin > 0.0 && avoidMargin <= 1.0,
        "avoid margin",
        avoidMargin,
        "in (0, 1], of the diagonal"
    );
    require(
        distanceTolerance > 0.0 && std::isfinite(distanceTolerance),
        "distance tolerance",
        distanceTolerance,
        "above 0 (average edge lengths)"
    );
    require(
        normalBendingWeight > 0.0 && normalBendingWeight <= 1.0,
        "normal bending weight",
        normalBendingWeight,
        "in (0, 1]"
    );
    require(samplesPerSpan >= 4, "samples per span", samplesPerSpan, "at least 4");
    require(maxRounds >= 1, "maximal rounds", maxRounds, "at least 1");
    require(maxIterations >= 1, "maximal iterations", maxIterations, "at least 1");
    require(minimumSpan > 0.0 && minimumSpan <= 0.1, "minimum span", minimumSpan, "in (0, 0.1]");
}

SolverOptions paperPreset() {
    SolverOptions options;
    options.bending = Bending::Ambient;
    options.initialCurve = InitialCurve::ControlPolygon;
    options.fieldGuidesPath = false;
    options.quadrature = Quadrature::Samples;
    options.barrierWidth = BarrierWidth::Tight;
    options.distanceWeight = DistanceWeight::Adaptive;
    options.interpolation = Interpolation::Penalty;
    options.knotRule = KnotRule::FeatureFunction;
    return options;
}

}  // namespace bspline_curve

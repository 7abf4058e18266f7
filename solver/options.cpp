// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/options.h"

#include "bspline_curve/error.h"
#include "spline/gauss_rule.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <sstream>
#include <string_view>

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

void requirePositive(const char* field, double value) {
    require(value > 0.0 && std::isfinite(value), field, value, "finite and above 0");
}

void validatePaper(const PaperOptions& paper) {
    constexpr int kMostSegments = 10000;
    require(
        paper.curveSegments >= 1 && paper.curveSegments <= kMostSegments,
        "curve segments",
        paper.curveSegments,
        "in [1, 10000]"
    );
    require(
        paper.gaussPoints >= 1 && paper.gaussPoints <= kMostGaussPoints,
        "Gauss points",
        paper.gaussPoints,
        "1, 2, 3 or 4"
    );
    require(
        paper.barrierMargin > 0.0 && paper.barrierMargin <= 1.0,
        "barrier margin",
        paper.barrierMargin,
        "in (0, 1]"
    );
    require(
        paper.heightScale > 0.0 && paper.heightScale <= 1.0,
        "height scale",
        paper.heightScale,
        "in (0, 1]"
    );
    requirePositive("alpha min", paper.alphaMin);
    requirePositive("alpha max", paper.alphaMax);
    requirePositive("beta first", paper.betaFirst);
    requirePositive("beta min", paper.betaMin);
    requirePositive("beta max", paper.betaMax);
    requirePositive("knot ratio", paper.knotRatio);
    require(
        paper.featureTolerance >= 0.0 && std::isfinite(paper.featureTolerance),
        "feature tolerance",
        paper.featureTolerance,
        "finite and not negative"
    );
}

}  // namespace

MeshLength parseLength(const std::string& text, const std::string& name) {
    std::string_view rest = text;
    const auto skipBlanks = [&] {
        rest.remove_prefix(std::min(rest.find_first_not_of(" \t"), rest.size()));
    };
    skipBlanks();
    MeshLength length;
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), length.value);
    bool isLength = error == std::errc() && std::isfinite(length.value) && length.value >= 0.0;
    if (isLength) {
        rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
        skipBlanks();
        for (const std::string_view unit : {"edges", "edge"}) {
            if (!length.isInEdges && rest.starts_with(unit)) {
                length.isInEdges = true;
                rest.remove_prefix(unit.size());
            }
        }
        skipBlanks();
        isLength = rest.empty();
    }
    if (!isLength) {
        throw InputError(
            InputErrorCode::BadOption,
            name + " is \"" + text +
                "\", but must be a length that is not negative, as 0.4, or in mean edges, as "
                "\"1.5 edges\""
        );
    }
    return length;
}

std::string describe(const MeshLength& length) {
    std::ostringstream text;
    text.precision(std::numeric_limits<double>::max_digits10);
    text << length.value << (length.isInEdges ? " edges" : "");
    return text.str();
}

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
        pickTolerance.value >= 0.0 && std::isfinite(pickTolerance.value),
        "pick tolerance",
        pickTolerance.value,
        "finite and not negative"
    );
    require(
        pickDistance >= 0.0 && std::isfinite(pickDistance),
        "pick distance",
        pickDistance,
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
    require(maxRounds >= 1, "max rounds", maxRounds, "at least 1");
    require(maxIterations >= 1, "max iterations", maxIterations, "at least 1");
    require(minimumSpan > 0.0 && minimumSpan <= 0.1, "minimum span", minimumSpan, "in (0, 0.1]");
    validatePaper(paper);
}

SolverOptions paperPreset() {
    SolverOptions options;
    options.fairness = Fairness::Parametric;
    options.bending = Bending::Ambient;
    options.initialCurve = InitialCurve::ControlPolygon;
    options.fieldGuidesPath = false;
    options.quadrature = Quadrature::Samples;
    options.barrierWidth = BarrierWidth::Tight;
    options.distanceWeight = DistanceWeight::Adaptive;
    options.interpolation = Interpolation::Penalty;
    options.knotRule = KnotRule::FeatureFunction;
    options.relativeHeight = RelativeHeight::Linear;
    options.fieldWeight = 1.0;
    options.minimumSpan = 0.005;
    return options;
}

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/options.h"

#include "bspline_curve/error.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace bspline_curve {
namespace {

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Expects that a value is refused by a message that names field and value.
template <class Value>
void expectRefused(
    Value SolverOptions::* field, Value value, const std::string& name, const std::string& shown
) {
    SolverOptions options;
    options.*field = value;
    try {
        options.validate();
        ADD_FAILURE() << name << " = " << value << " was accepted";
    } catch (const InputError& error) {
        EXPECT_EQ(error.code(), InputErrorCode::BadOption);
        EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find(shown), std::string::npos) << error.what();
    }
}

template <class Value>
void expectPaperRefused(
    Value PaperOptions::* field, Value value, const std::string& name, const std::string& shown
) {
    SolverOptions options;
    options.paper.*field = value;
    try {
        options.validate();
        ADD_FAILURE() << name << " = " << value << " was accepted";
    } catch (const InputError& error) {
        EXPECT_EQ(error.code(), InputErrorCode::BadOption);
        EXPECT_NE(std::string(error.what()).find(name + " is " + shown), std::string::npos)
            << error.what();
    }
}

template <class Value>
void expectAccepted(Value SolverOptions::* field, Value value) {
    SolverOptions options;
    options.*field = value;
    EXPECT_NO_THROW(options.validate()) << value;
}

TEST(SolverOptionsValidation, AcceptsDefaultsAndThePaper) {
    EXPECT_NO_THROW(SolverOptions().validate());
    EXPECT_NO_THROW(paperPreset().validate());
}

TEST(PaperPreset, StartsFromGeodesicsWhateverTheField) {
    EXPECT_TRUE(SolverOptions().fieldGuidesPath);
    EXPECT_FALSE(paperPreset().fieldGuidesPath);
}

TEST(SolverOptionsValidation, ChecksWholeNumbers) {
    for (const int degree : {2, 3, 4}) {
        expectAccepted(&SolverOptions::degree, degree);
    }
    for (const int degree : {-3, 0, 1, 5}) {
        expectRefused(&SolverOptions::degree, degree, "degree", std::to_string(degree));
    }
    expectAccepted(&SolverOptions::maxRounds, 1);
    expectRefused(&SolverOptions::maxRounds, 0, "max rounds", "0");
    expectAccepted(&SolverOptions::maxIterations, 1);
    expectRefused(&SolverOptions::maxIterations, -1, "max iterations", "-1");
}

TEST(SolverOptionsValidation, ChecksNumbers) {
    expectAccepted(&SolverOptions::tension, 0.0);
    expectAccepted(&SolverOptions::tension, 1.0);
    expectRefused(&SolverOptions::tension, -0.5, "tension", "-0.5");
    expectRefused(&SolverOptions::tension, 1.5, "tension", "1.5");
    expectAccepted(&SolverOptions::fieldWeight, 0.0);
    expectRefused(&SolverOptions::fieldWeight, -2.0, "field weight", "-2");
    expectRefused(&SolverOptions::fieldWeight, kInfinity, "field weight", "inf");
    expectRefused(&SolverOptions::distanceTolerance, 0.0, "distance tolerance", "0");
    expectRefused(&SolverOptions::distanceTolerance, kInfinity, "distance tolerance", "inf");
    expectAccepted(&SolverOptions::normalBendingWeight, 1.0);
    expectRefused(&SolverOptions::normalBendingWeight, 0.0, "normal bending weight", "0");
    expectRefused(&SolverOptions::normalBendingWeight, 1.25, "normal bending weight", "1.25");
    expectAccepted(&SolverOptions::minimumSpan, 0.1);
    expectRefused(&SolverOptions::minimumSpan, 0.0, "minimum span", "0");
    expectRefused(&SolverOptions::minimumSpan, 0.25, "minimum span", "0.25");
}

TEST(SolverOptionsValidation, ChecksTheNumbersOfThePaper) {
    using P = PaperOptions;
    expectPaperRefused(&P::curveSegments, 0, "curve segments", "0");
    expectPaperRefused(&P::curveSegments, 10001, "curve segments", "10001");
    expectPaperRefused(&P::gaussPoints, 5, "Gauss points", "5");
    expectPaperRefused(&P::barrierMargin, 0.0, "barrier margin", "0");
    expectPaperRefused(&P::heightScale, 1.5, "height scale", "1.5");
    expectPaperRefused(&P::alphaMin, 0.0, "alpha min", "0");
    expectPaperRefused(&P::alphaMax, 0.0, "alpha max", "0");
    expectPaperRefused(&P::betaFirst, -1.0, "beta first", "-1");
    expectPaperRefused(&P::betaMin, kInfinity, "beta min", "inf");
    expectPaperRefused(&P::betaMax, -2.0, "beta max", "-2");
    expectPaperRefused(&P::knotRatio, 0.0, "knot ratio", "0");
    expectPaperRefused(&P::featureTolerance, kNotANumber, "feature tolerance", "nan");
}

TEST(SolverOptionsValidation, RefusesNotANumber) {
    expectRefused(&SolverOptions::tension, kNotANumber, "tension", "nan");
    expectRefused(&SolverOptions::fieldWeight, kNotANumber, "field weight", "nan");
    expectRefused(&SolverOptions::distanceTolerance, kNotANumber, "distance tolerance", "nan");
    expectRefused(&SolverOptions::normalBendingWeight, kNotANumber, "normal bending weight", "nan");
    expectRefused(&SolverOptions::minimumSpan, kNotANumber, "minimum span", "nan");
}

}  // namespace
}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
// Bad input is refused by name; progress only rises and cancels at once.
#include "bspline_curve/error.h"
#include "curve_checks.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <optional>
#include <string>

namespace bspline_curve {
namespace {

using namespace test_support;

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

std::optional<InputError> refusal(const std::function<void()>& call) {
    try {
        call();
    } catch (const InputError& error) {
        return error;
    }
    return std::nullopt;
}

class Refusals : public testing::Test {
protected:
    void expectRefused(
        InputErrorCode code,
        const std::vector<double>& field,
        const SolverOptions& options = {},
        const SamplingOptions& sampling = {}
    ) const {
        const auto error = refusal([&] {
            static_cast<void>(designer_.design(picks_, options, sampling, {.field = field}));
        });
        ASSERT_TRUE(error.has_value());
        EXPECT_EQ(error->code(), code) << error->what();
    }

    CurveDesigner designer_{plate(4, 4)};
    std::vector<Vec3> picks_ = {{0.1, 0.2, 0}, {0.9, 0.7, 0}};
};

TEST_F(Refusals, FieldsOfAnotherSizeAreRefused) {
    expectRefused(InputErrorCode::BadField, std::vector<double>(24, 1.0));
    expectRefused(InputErrorCode::BadField, std::vector<double>(26, 1.0));
}

TEST_F(Refusals, FieldsThatAreNotFiniteAreRefusedWithTheirVertices) {
    std::vector<double> field(25, 1.0);
    field[7] = kNotANumber;
    field[11] = std::numeric_limits<double>::infinity();
    const auto error =
        refusal([&] { static_cast<void>(designer_.design(picks_, {}, {}, {.field = field})); });
    ASSERT_TRUE(error.has_value());
    EXPECT_EQ(error->code(), InputErrorCode::BadField);
    EXPECT_EQ(error->elements(), (std::vector<std::int64_t>{7, 11}));
}

TEST_F(Refusals, FieldsWhoseCostIsNotFiniteAreRefusedWithTheirVertices) {
    std::vector<double> field(25, 1.0);
    field[7] = -1000.0;
    SolverOptions options;
    options.fieldCost = FieldCost::ExpMinus;
    const auto error = refusal([&] {
        static_cast<void>(designer_.design(picks_, options, {}, {.field = field}));
    });
    ASSERT_TRUE(error.has_value());
    EXPECT_EQ(error->code(), InputErrorCode::BadField);
    EXPECT_EQ(error->elements(), std::vector<std::int64_t>{7});
    EXPECT_NO_THROW(static_cast<void>(designer_.design(picks_, {}, {}, {.field = field})));
}

TEST_F(Refusals, OptionsOutOfRangeAreRefused) {
    SolverOptions options;
    options.degree = 5;
    expectRefused(InputErrorCode::BadOption, {}, options);
    options = {};
    options.tension = kNotANumber;
    expectRefused(InputErrorCode::BadOption, {}, options);
    expectRefused(InputErrorCode::BadOption, {}, {}, {-1, 0.0});
    expectRefused(InputErrorCode::BadOption, {}, {}, {10, -1.0});
    expectRefused(InputErrorCode::BadOption, {}, {}, {10, kNotANumber});
}

TEST_F(Refusals, ShellOptionsOutOfRangeAreRefused) {
    std::vector<ShellOptions> wrong(9);
    wrong[0].thickness = 0.0;
    wrong[1].thickness = -1.0;
    wrong[2].thickness = kNotANumber;
    wrong[3].smoothingPasses = -1;
    for (std::size_t i = 4; i < wrong.size(); ++i) {
        wrong[i].kind = ShellKind::Simplified;
    }
    wrong[4].targetThickness = 0.0;
    wrong[5].targetThickness = kNotANumber;
    wrong[6].targetEdgeLength = -1.0;
    wrong[7].targetEdgeLength = kNotANumber;
    wrong[8].smoothingPasses = -1;
    for (std::size_t i = 0; i < wrong.size(); ++i) {
        const auto error = refusal([&] { const CurveDesigner d(plate(4, 4), wrong[i]); });
        ASSERT_TRUE(error.has_value()) << i;
        EXPECT_EQ(error->code(), InputErrorCode::BadOption) << i << ": " << error->what();
    }
}

TEST_F(Refusals, TooFewPicksAreRefused) {
    const auto open = refusal([&] { static_cast<void>(designer_.design({{0.1, 0.2, 0}})); });
    ASSERT_TRUE(open.has_value());
    EXPECT_EQ(open->code(), InputErrorCode::TooFewPicks);
    const auto closed =
        refusal([&] { static_cast<void>(designer_.design(picks_, closedOptions())); });
    ASSERT_TRUE(closed.has_value());
    EXPECT_EQ(closed->code(), InputErrorCode::TooFewPicks);
}

TEST(RefusalsOfCrossings, PicksWhereTheSurfaceCrossesItselfAreRefused) {
    const CurveDesigner designer(crossingPlates());
    const auto error =
        refusal([&] { static_cast<void>(designer.design({{0.3, 0.1, 0}, {0.5, 0.55, 0}})); });
    ASSERT_TRUE(error.has_value());
    EXPECT_EQ(error->code(), InputErrorCode::SelfIntersection);
    EXPECT_NE(std::string(error->what()).find("pick 1"), std::string::npos) << error->what();
    EXPECT_EQ(error->elements().size(), 1U);
}

TEST(RefusalsOfCrossings, CurvesThatWouldHaveToPassACrossingAreRefused) {
    const CurveDesigner designer(crossingPlates());
    const auto error =
        refusal([&] { static_cast<void>(designer.design({{0.5, 0.1, 0}, {0.5, 0.9, 0}})); });
    ASSERT_TRUE(error.has_value());
    EXPECT_EQ(error->code(), InputErrorCode::SelfIntersection);
    EXPECT_FALSE(error->elements().empty());
}

TEST(RefusalsOfCrossings, CurvesBesideACrossingAreDrawn) {
    const CurveDesigner designer(crossingPlates());
    static_cast<void>(goodCurve(designer, {{0.1, 0.1, 0}, {0.5, 0.3, 0}, {0.9, 0.1, 0}}));
}

struct Calls {
    std::vector<double> fractions;
    int allowed = 1 << 30;

    Progress callback() {
        return [this](double fraction, const char*) {
            fractions.push_back(fraction);
            return static_cast<int>(fractions.size()) < allowed;
        };
    }
};

void expectRising(const std::vector<double>& fractions) {
    double before = 0.0;
    for (const double fraction : fractions) {
        EXPECT_GE(fraction, before);
        EXPECT_LE(fraction, 1.0);
        before = fraction;
    }
}

TEST(ProgressReports, RiseToOneAndCancelAtEveryCall) {
    const TriangleMesh mesh = withNoise(icosphere(3), 0.01, 43);
    const std::vector<Vec3> picks = {mesh.vertices[5], mesh.vertices[100], mesh.vertices[400]};
    Calls shell;
    const CurveDesigner designer(mesh, {}, shell.callback());
    EXPECT_FALSE(shell.fractions.empty());
    expectRising(shell.fractions);
    Calls curve;
    static_cast<void>(designer.design(picks, {}, {}, {}, curve.callback()));
    ASSERT_FALSE(curve.fractions.empty());
    expectRising(curve.fractions);
    EXPECT_EQ(curve.fractions.back(), 1.0);

    for (std::size_t call = 1; call <= shell.fractions.size(); ++call) {
        Calls cancelled{.fractions = {}, .allowed = static_cast<int>(call)};
        EXPECT_THROW(CurveDesigner(mesh, {}, cancelled.callback()), Cancelled) << call;
        EXPECT_EQ(cancelled.fractions.size(), call);
    }
    for (std::size_t call = 1; call <= curve.fractions.size(); ++call) {
        Calls cancelled{.fractions = {}, .allowed = static_cast<int>(call)};
        EXPECT_THROW(
            static_cast<void>(designer.design(picks, {}, {}, {}, cancelled.callback())), Cancelled
        ) << call;
        EXPECT_EQ(cancelled.fractions.size(), call);
    }
    // A cancelled call leaves nothing behind.
    const Curve after = designer.design(picks);
    EXPECT_TRUE(after.report.usable);
}

}  // namespace
}  // namespace bspline_curve

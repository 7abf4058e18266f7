// SPDX-License-Identifier: GPL-3.0-or-later
// Curves with given directions at their picks, judged from the outside.
#include "bspline_curve/error.h"
#include "bspline_curve/spline.h"
#include "design/curve_checks.h"
#include "support/many_cases.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

constexpr double kMetTangent = 1e-6;  // radians
constexpr double kFromLoxodrome = 2e-3;

/// The exported spline's derivative at t, by differences, one-sided at the ends of an open one.
Vec3 slopeOf(const SplineData& spline, double t) {
    constexpr double kStep = 1e-6;
    const double low = spline.closed ? t - kStep : std::max(0.0, t - kStep);
    const double high = spline.closed ? t + kStep : std::min(1.0, t + kStep);
    const auto at = [&](double s) { return pointOfSpline(spline, s - std::floor(s)); };
    const Vec3 top = high == 1.0 ? pointOfSpline(spline, 1.0) : at(high);
    return (top - at(low)) / (high - low);
}

double angleOf(const Vec3& a, const Vec3& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// The same on both sides of each pick.
std::vector<PickTangent> onBothSides(const std::vector<Vec3>& directions) {
    std::vector<PickTangent> tangents;
    for (const Vec3& direction : directions) {
        tangents.push_back(PickTangent::along(direction));
    }
    return tangents;
}

Curve withTangents(
    const CurveDesigner& designer,
    const std::vector<Vec3>& picks,
    const std::vector<Vec3>& directions,
    const SolverOptions& options = {},
    CurveInputs inputs = {}
) {
    const std::vector<PickTangent> tangents = onBothSides(directions);
    inputs.tangents = tangents;
    return goodCurve(designer, picks, options, inputs);
}

/// Expects directions to be met; `tangents`: in the tangent planes.
void expectMet(const Curve& curve, const std::vector<Vec3>& tangents, double tolerance) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < tangents.size(); ++i) {
        if (tangents[i].isZero(0.0)) {
            continue;
        }
        ASSERT_LT(count, curve.report.tangents.size());
        const MetTangent& met = curve.report.tangents[count++];
        EXPECT_EQ(met.pick, static_cast<int>(i));
        EXPECT_LT(met.ofSpline, kMetTangent) << "pick " << i;
        const Vec3 slope = slopeOf(curve.spline, curve.spline.pickParameters[i]);
        EXPECT_LT(angleOf(slope, tangents[i]), 1e-3) << "pick " << i;
        EXPECT_LT(met.ofPolyline, tolerance) << "pick " << i;
    }
    EXPECT_EQ(count, curve.report.tangents.size());
}

const std::vector<Vec3> kWave = {
    {0.1, 0.4, 0.0}, {0.35, 0.6, 0.0}, {0.6, 0.45, 0.0}, {0.9, 0.55, 0.0}
};

TEST(Tangents, AreMetAtTheEnds) {
    const CurveDesigner designer(jitteredPlate(40, 40, 0.2, 3));
    const std::vector<Vec3> tangents = {
        {0.0, 3.0, 0.0}, Vec3::Zero(), Vec3::Zero(), {0.0, -0.1, 0.0}
    };
    const Curve curve = withTangents(designer, kWave, tangents);
    expectMet(curve, tangents, 0.2);
    EXPECT_EQ(curve.report.status, SolveStatus::Converged);
}

TEST(Tangents, AreMetInside) {
    const CurveDesigner designer(jitteredPlate(40, 40, 0.2, 3));
    for (const int degree : {2, 3, 4}) {
        SCOPED_TRACE(degree);
        const std::vector<Vec3> tangents = {
            Vec3::Zero(), {1.0, -0.5, 0.0}, {0.2, 1.0, 0.0}, Vec3::Zero()
        };
        const Curve curve = withTangents(designer, kWave, tangents, {.degree = degree});
        expectMet(curve, tangents, 0.3);
        EXPECT_TRUE(cornersOf(curve.spline).empty());
    }
}

TEST(Tangents, MayTurnACurveBackwards) {
    const CurveDesigner designer(jitteredPlate(40, 40, 0.2, 3));
    const std::vector<Vec3> picks = {{0.4, 0.5, 0.0}, {0.7, 0.5, 0.0}};
    const std::vector<Vec3> tangents = {{-1.0, 0.3, 0.0}, Vec3::Zero()};
    const Curve curve = withTangents(designer, picks, tangents);
    expectMet(curve, tangents, 0.5);
}

/// The clamped cubic: on a plane the one of least bending between two points with small slopes at
/// both ends is y = m x (1 - x)^2 + n x^2 (x - 1).
TEST(Tangents, OfAFlatCurveGiveTheClampedCubic) {
    const CurveDesigner designer(jitteredPlate(40, 40, 0.2, 3));
    const double slope = 0.05;
    const std::vector<Vec3> picks = {{0.1, 0.5, 0.0}, {0.9, 0.5, 0.0}};
    const std::vector<Vec3> tangents = {{1.0, slope, 0.0}, {1.0, -2.0 * slope, 0.0}};
    const Curve curve = withTangents(designer, picks, tangents);
    expectMet(curve, tangents, 0.05);
    const double length = 0.8;
    for (int i = 0; i <= 50; ++i) {
        const Vec3 point = pointOfSpline(curve.spline, i / 50.0);
        const double x = (point.x() - 0.1) / length;
        const double y = length * slope * (x * (1.0 - x) * (1.0 - x) - 2.0 * x * x * (x - 1.0));
        EXPECT_NEAR(point.y() - 0.5, y, 5e-4) << x;
    }
}

TEST(Tangents, AlongAGreatCircleKeepToIt) {
    const CurveDesigner designer(icosphere(5));
    std::vector<Vec3> picks;
    std::vector<Vec3> tangents;
    const Vec3 e1 = Vec3(1.0, 0.2, 0.1).normalized();
    const Vec3 e2 = (Vec3(0.1, 0.8, 0.5) - Vec3(0.1, 0.8, 0.5).dot(e1) * e1).normalized();
    for (const double angle : {0.0, 0.9, 2.0}) {
        picks.push_back(
            designer.tree().closestPoint(std::cos(angle) * e1 + std::sin(angle) * e2).position
        );
        tangents.emplace_back(std::cos(angle) * e2 - std::sin(angle) * e1);
    }
    const Curve curve = withTangents(designer, picks, tangents);
    const Vec3 normal = e1.cross(e2);
    for (const Vec3& point : curve.polyline.points) {
        EXPECT_LT(std::abs(point.dot(normal)), 2e-3);
    }
    ASSERT_EQ(curve.report.tangents.size(), 3U);
    for (const MetTangent& met : curve.report.tangents) {
        EXPECT_LT(met.ofSpline, kMetTangent);
        EXPECT_LT(met.ofPolyline, 0.02);
    }
}

/// On the unit sphere, at a latitude, the line that crosses all meridians at one angle.
class Loxodrome {
public:
    explicit Loxodrome(double angle) : slope_(std::tan(angle)) {}

    [[nodiscard]] Vec3 at(double latitude) const {
        const double longitude = longitudeAt(latitude);
        return {
            std::cos(latitude) * std::cos(longitude),
            std::cos(latitude) * std::sin(longitude),
            std::sin(latitude)
        };
    }

    [[nodiscard]] Vec3 directionAt(double latitude) const {
        const double longitude = longitudeAt(latitude);
        const Vec3 north(
            -std::sin(latitude) * std::cos(longitude),
            -std::sin(latitude) * std::sin(longitude),
            std::cos(latitude)
        );
        const Vec3 east(-std::sin(longitude), std::cos(longitude), 0.0);
        return (north + slope_ * east).normalized();
    }

private:
    [[nodiscard]] double longitudeAt(double latitude) const {
        return slope_ * std::log(std::tan(0.25 * std::numbers::pi + 0.5 * latitude));
    }

    double slope_;
};

TEST(Tangents, OfALoxodromeDrawIt) {
    const CurveDesigner designer(icosphere(6));
    for (const double angle : {0.3, 0.9, 1.2}) {
        const Loxodrome loxodrome(angle);
        std::vector<Vec3> picks;
        std::vector<Vec3> tangents;
        for (int i = 0; i <= 6; ++i) {
            const double latitude = -0.9 + 0.3 * i;
            picks.push_back(designer.tree().closestPoint(loxodrome.at(latitude)).position);
            tangents.push_back(loxodrome.directionAt(latitude));
        }
        const Curve curve = withTangents(designer, picks, tangents);
        ASSERT_EQ(curve.report.tangents.size(), picks.size());
        double largest = 0.0;
        for (const Vec3& point : curve.polyline.points) {
            const Vec3 unit = point.normalized();
            const Vec3 beside = loxodrome.at(std::asin(unit.z()));
            // Along the parallel, which the line crosses at that angle.
            largest = std::max(largest, (unit - beside).norm() * std::cos(angle));
        }
        EXPECT_LT(largest, kFromLoxodrome) << angle;
        for (const MetTangent& met : curve.report.tangents) {
            EXPECT_LT(met.ofSpline, kMetTangent);
        }
    }
}

TEST(Tangents, AreMetOnRandomCurves) {
    const int sets = caseCount(67, 5);  // of picks: with three degrees 201 curves
    const CurveDesigner designer(withNoise(icosphere(4), 0.002, 5));
    std::mt19937 random(21);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    for (int i = 0; i < sets; ++i) {
        const bool closed = i % 2 == 0;
        const int count = 4 + i % 4;
        std::vector<Vec3> picks;
        std::vector<Vec3> tangents;
        for (int k = 0; k < count; ++k) {
            const double angle = 2.0 * std::numbers::pi * (k + 0.2 * uniform(random)) / count;
            const Vec3 direction(std::cos(angle), std::sin(angle), 0.3 * uniform(random));
            picks.push_back(designer.tree().closestPoint(direction.normalized()).position);
            const Vec3 forward(-std::sin(angle), std::cos(angle), 0.7 * uniform(random));
            tangents.emplace_back(uniform(random) > 0.0 ? forward : Vec3(Vec3::Zero()));
        }
        tangents[1] = Vec3(-picks[1].y(), picks[1].x(), 0.5);
        for (const int degree : {2, 3, 4}) {
            SCOPED_TRACE(testing::Message() << "curve " << i << ", degree " << degree);
            const Curve curve =
                withTangents(designer, picks, tangents, {.degree = degree, .closed = closed});
            EXPECT_GE(curve.report.tangents.size(), 1U);
            for (const MetTangent& met : curve.report.tangents) {
                EXPECT_LT(met.ofSpline, kMetTangent);
                EXPECT_LT(met.ofPolyline, 0.3);
            }
        }
    }
}

TEST(Tangents, LeaveABoundaryAtRightAngles) {
    const CurveDesigner designer(jitteredPlate(40, 40, 0.2, 3));
    const std::vector<Vec3> picks = {{0.0, 0.3, 0.0}, {0.5, 0.5, 0.0}, {0.6, 1.0, 0.0}};
    const std::vector<Vec3> tangents = {{1.0, 0.0, 0.0}, Vec3::Zero(), {0.0, 1.0, 0.0}};
    expectMet(withTangents(designer, picks, tangents), tangents, 0.1);
}

TEST(Tangents, GoWithCornersOfOtherPicks) {
    const CurveDesigner designer(jitteredPlate(40, 40, 0.2, 3));
    CurveInputs inputs;
    const std::vector<int> corners = {0, 2};
    inputs.corners = corners;
    const std::vector<Vec3> tangents = {
        {0.0, 1.0, 0.0}, {1.0, 0.0, 0.0}, Vec3::Zero(), {0.0, -1.0, 0.0}
    };
    const Curve curve = withTangents(designer, kWave, tangents, {}, inputs);
    expectMet(curve, tangents, 0.3);
    EXPECT_EQ(cornersOf(curve.spline), std::vector<int>{2});
}

// Each side is the curve that ends there in its direction.
TEST(Tangents, OfACornerAreThoseOfItsSides) {
    const CurveDesigner designer(jitteredPlate(40, 40, 0.2, 3));
    const std::vector<PickTangent> tangents = {
        {}, {}, {Vec3(1.0, -1.0, 0.3), Vec3(0.2, 1.0, 0.0)}, {}
    };
    const std::vector<int> corners = {2};
    for (const int degree : {2, 3, 4}) {
        const SolverOptions options{.degree = degree};
        const CurveInputs inputs{.corners = corners, .tangents = tangents};
        const Curve curve = goodCurve(designer, kWave, options, inputs);
        ASSERT_EQ(curve.report.tangents.size(), 1U);
        EXPECT_LT(curve.report.tangents[0].ofSpline, kMetTangent);
        EXPECT_LT(curve.report.tangents[0].ofPolyline, 0.3);
        const PickTangent drawn = directionsAtPick(curve.spline, 2);
        EXPECT_LT(angleOf(drawn.before, {1.0, -1.0, 0.0}), 1e-3);
        EXPECT_LT(angleOf(drawn.after, {0.2, 1.0, 0.0}), 1e-3);
        EXPECT_EQ(cornersOf(curve.spline), corners);
        const std::vector<Vec3> first(kWave.begin(), kWave.begin() + 3);
        const std::vector<Vec3> second(kWave.begin() + 2, kWave.end());
        const Curve before = withTangents(
            designer, first, {Vec3::Zero(), Vec3::Zero(), tangents[2].before}, options
        );
        const Curve after =
            withTangents(designer, second, {tangents[2].after, Vec3::Zero()}, options);
        const double length = lengthOf(before.polyline) + lengthOf(after.polyline);
        EXPECT_NEAR(lengthOf(curve.polyline), length, 1e-9 * length);
    }
}

TEST(Tangents, OfACornerCanBeOfOneSideAlone) {
    const CurveDesigner designer(jitteredPlate(40, 40, 0.2, 3));
    const std::vector<int> corners = {0, 2};
    const std::vector<PickTangent> tangents = {
        {Vec3::Zero(), Vec3(0.3, 1.0, 0.0)}, {}, {Vec3(1.0, 0.5, 0.0), Vec3::Zero()}, {}
    };
    const CurveInputs inputs{.corners = corners, .tangents = tangents};
    const Curve curve = goodCurve(designer, kWave, {.closed = true}, inputs);
    const std::vector<std::pair<int, PickTangent>> met = tangentsAtPicks(curve);
    ASSERT_EQ(met.size(), 2U);
    EXPECT_LT(curve.report.tangents[0].ofSpline, kMetTangent);
    EXPECT_LT(curve.report.tangents[1].ofSpline, kMetTangent);
    EXPECT_EQ(met[0].second.before, Vec3::Zero());
    EXPECT_LT(angleOf(met[0].second.after, {0.3, 1.0, 0.0}), 1e-3);
    EXPECT_LT(angleOf(met[1].second.before, {1.0, 0.5, 0.0}), 1e-3);
    EXPECT_EQ(met[1].second.after, Vec3::Zero());
}

TEST(Tangents, ArePassedExactlyAmongPicksWithATolerance) {
    const CurveDesigner designer(jitteredPlate(40, 40, 0.2, 3));
    CurveInputs inputs;
    const std::vector<Vec3> tangents = {Vec3::Zero(), {1.0, 0.0, 0.0}, Vec3::Zero(), Vec3::Zero()};
    const std::vector<PickTangent> both = onBothSides(tangents);
    inputs.tangents = both;
    const Curve curve = designer.design(kWave, {.pickTolerance = {.value = 0.03}}, {}, inputs);
    ASSERT_TRUE(curve.report.usable);
    expectMet(curve, tangents, 0.3);
    EXPECT_LT(curve.report.pickDistances[1], 1e-12);
    EXPECT_LE(*std::ranges::max_element(curve.report.pickDistances), 0.03);
}

TEST(Tangents, StayWhereACurveStartsFromAnother) {
    const CurveDesigner designer(jitteredPlate(40, 40, 0.2, 3));
    const std::vector<Vec3> tangents = {
        {0.0, 1.0, 0.0}, Vec3::Zero(), {1.0, 1.0, 0.0}, Vec3::Zero()
    };
    const Curve before = withTangents(designer, kWave, tangents);
    std::vector<Vec3> moved = kWave;
    moved[1] += Vec3(0.02, 0.01, 0.0);
    CurveInputs inputs;
    inputs.start = &before;
    const Curve after = withTangents(designer, moved, tangents, {}, inputs);
    expectMet(after, tangents, 0.3);
    EXPECT_LT(
        largestDistance(after.polyline, withTangents(designer, moved, tangents).polyline), 1e-2
    );
}

TEST(Tangents, ThatAreZeroChangeNothing) {
    const CurveDesigner designer(jitteredPlate(20, 20, 0.2, 3));
    const std::vector<Vec3> none(kWave.size(), Vec3::Zero());
    expectSameBits(withTangents(designer, kWave, none), goodCurve(designer, kWave));
}

TEST(Tangents, OfMendedMeshesAreMet) {
    const CurveDesigner designer(withFaceReversed(jitteredPlate(20, 20, 0.2, 3), 100));
    const std::vector<Vec3> tangents = {{0.0, 1.0, 0.0}, Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
    CurveInputs inputs;
    const std::vector<PickTangent> both = onBothSides(tangents);
    inputs.tangents = both;
    expectMet(designer.design(kWave, {}, {}, inputs), tangents, 0.3);
}

TEST(Tangents, ThatCannotBeMetAreRefused) {
    const CurveDesigner designer(plate(8, 8));
    const auto refusal = [&](const std::vector<PickTangent>& tangents,
                             const std::vector<int>& corners = {},
                             const SolverOptions& options = {}) -> std::string {
        CurveInputs inputs;
        inputs.tangents = tangents;
        inputs.corners = corners;
        try {
            static_cast<void>(designer.design(kWave, options, {}, inputs));
        } catch (const InputError& error) {
            EXPECT_EQ(error.code(), InputErrorCode::BadOption);
            return error.what();
        }
        return "none";
    };
    const PickTangent free;
    const PickTangent along = PickTangent::along(Vec3::UnitX());
    const auto alongOne = [](const Vec3& direction) { return PickTangent::along(direction); };
    EXPECT_EQ(refusal({along}), "there are 1 tangents for 4 picks: give one for each");
    EXPECT_EQ(
        refusal({free, alongOne({0.0, 0.0, 2.0}), free, free}),
        "the tangent of pick 2 is normal to the surface"
    );
    EXPECT_EQ(
        refusal({free, alongOne({std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0}), free, free}),
        "the tangent of pick 2 is not finite"
    );
    EXPECT_EQ(
        refusal({free, {Vec3::UnitX(), Vec3::UnitY()}, free, free}, {2}),
        "the tangent of pick 2 has two directions, which only a corner can have"
    );
    EXPECT_EQ(
        refusal({free, {Vec3::UnitX(), Vec3::UnitZ()}, free, free}, {1}),
        "the tangent of pick 2 is normal to the surface"
    );
    EXPECT_NE(refusal({along, free, free, free}, {}, paperPreset()), "none");
}

}  // namespace
}  // namespace bspline_curve

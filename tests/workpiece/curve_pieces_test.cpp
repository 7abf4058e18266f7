// SPDX-License-Identifier: GPL-3.0-or-later
// Curves turned round, cut, joined and made longer, judged by spline and polyline alone.
#include "bspline_curve/bspline_curve.h"
#include "spline/spline_sections.h"
#include "support/meshes.h"
#include "surface/strict_line.h"
#include "workpiece/workpiece_parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

namespace bspline_curve::workpiece_tests {

namespace {

using test_support::icosphere;
using test_support::jitteredPlate;

const std::vector<Vec3> kOpenPicks = {
    {0.1, 0.4, 0.0}, {0.35, 0.6, 0.0}, {0.6, 0.45, 0.0}, {0.9, 0.55, 0.0}
};

Curve drawnOn(
    const Workpiece& workpiece,
    const std::vector<Vec3>& picks,
    bool closed = false,
    int degree = 3,
    std::vector<int> corners = {}
) {
    CurveInputs inputs;
    inputs.corners = corners;
    return workpiece.draw(picks, {.degree = degree, .closed = closed}, {}, inputs).curve;
}

double angleOf(const Vec3& a, const Vec3& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// What is asked of every curve that is made of others.
void expectWhole(const Workpiece& workpiece, const Curve& curve) {
    const SplineData& spline = curve.spline;
    const SurfacePolyline& line = curve.polyline;
    EXPECT_EQ(spline.knots.size(), spline.controlPoints.size() + spline.degree + 1);
    EXPECT_TRUE(std::ranges::is_sorted(spline.knots));
    EXPECT_TRUE(std::ranges::is_sorted(line.parameters));
    EXPECT_EQ(std::ranges::adjacent_find(line.parameters), line.parameters.end());
    EXPECT_TRUE(
        isStrict(surfaceOf(workpiece), strictLine(surfaceOf(workpiece), line, "the curve"))
    );
    ASSERT_EQ(line.points.size(), line.parameters.size());
    const double allowed = SolverOptions{}.distanceTolerance * workpiece.meanEdgeLength();
    for (std::size_t i = 0; i < line.points.size(); ++i) {
        EXPECT_LT((line.points[i] - positionOf(spline, line.parameters[i])).norm(), allowed) << i;
        EXPECT_LT(
            (line.points[i] - positionOf(workpiece.mesh(), line.surfacePoints[i])).norm(), 1e-12
        );
    }
    if (line.picks.size() == spline.pickParameters.size()) {
        for (std::size_t i = 0; i < line.picks.size(); ++i) {
            EXPECT_NEAR(line.parameters[line.picks[i]], spline.pickParameters[i], 1e-12);
        }
    }
}

/// The largest turn of a spline at one of its knots, in radians.
double largestTurn(const SplineData& spline) {
    double largest = 0.0;
    const std::vector<SplineSection> sections = sectionsOf(spline);
    for (std::size_t i = 1; i < sections.size(); ++i) {
        const SplineData& before = sections[i - 1].spline;
        const SplineData& after = sections[i].spline;
        const auto last = before.controlPoints.size() - 1;
        largest = std::max(
            largest,
            angleOf(
                before.controlPoints[last] - before.controlPoints[last - 1],
                after.controlPoints[1] - after.controlPoints[0]
            )
        );
    }
    return largest;
}

TEST(PiecesOfCurves, ThatAreReversedAreTheSameCurve) {
    const Workpiece workpiece(jitteredPlate(30, 30, 0.2, 3));
    for (const bool closed : {false, true}) {
        for (const std::vector<int>& corners :
             {std::vector<int>{}, std::vector<int>{0, 2}, std::vector<int>{1}}) {
            const Curve curve = drawnOn(workpiece, kOpenPicks, closed, 3, corners);
            std::vector<int> picks;
            const Curve turned = reversedCurve(curve, &picks);
            expectWhole(workpiece, turned);
            EXPECT_EQ(
                picks, closed ? std::vector<int>({0, 3, 2, 1}) : std::vector<int>({3, 2, 1, 0})
            );
            for (int i = 1; i < 100; ++i) {
                const double t = i / 100.0;
                EXPECT_LT(
                    (positionOf(turned.spline, t) - positionOf(curve.spline, 1.0 - t)).norm(), 1e-12
                );
            }
            const Curve again = reversedCurve(turned);
            EXPECT_EQ(again.polyline.points, curve.polyline.points);
            EXPECT_EQ(again.polyline.picks, curve.polyline.picks);
            EXPECT_EQ(cornersOf(again.spline), cornersOf(curve.spline));
            EXPECT_EQ(cornersOf(turned.spline).size(), cornersOf(curve.spline).size());
        }
    }
}

TEST(PiecesOfCurves, TellWhichPicksTheyHave) {
    const Workpiece workpiece(jitteredPlate(30, 30, 0.2, 3));
    const Curve curve = drawnOn(workpiece, kOpenPicks, true);
    const std::vector<double>& at = curve.spline.pickParameters;
    std::vector<int> picks;
    static_cast<void>(partOfCurve(workpiece, curve, at[2], at[1], &picks));
    EXPECT_EQ(picks, (std::vector<int>{2, 3, 0, 1}));
    static_cast<void>(partOfCurve(workpiece, curve, 0.0, 1.0, &picks));
    EXPECT_EQ(picks, (std::vector<int>{0, 1, 2, 3, 0}));
    std::vector<std::vector<int>> ofEach;
    const std::vector<double> cuts = {at[1], 0.5 * (at[2] + at[3])};
    const std::vector<Curve> parts = partsOfCurve(workpiece, curve, cuts, &ofEach);
    EXPECT_EQ(ofEach, (std::vector<std::vector<int>>{{1, 2}, {3, 0, 1}}));
    for (std::size_t i = 0; i < parts.size(); ++i) {
        ASSERT_EQ(parts[i].polyline.picks.size(), ofEach[i].size());
        for (std::size_t k = 0; k < ofEach[i].size(); ++k) {
            const Vec3& there = parts[i].polyline.points[parts[i].polyline.picks[k]];
            EXPECT_LT((there - kOpenPicks[ofEach[i][k]]).norm(), 1e-9);
        }
    }
}

TEST(PiecesOfCurves, AreTheSameSplineBetweenParameters) {
    const Workpiece workpiece(jitteredPlate(30, 30, 0.2, 3));
    for (const int degree : {2, 3, 4}) {
        for (const bool closed : {false, true}) {
            const Curve curve = drawnOn(workpiece, kOpenPicks, closed, degree, {2});
            const double knot = curve.spline.knots[curve.spline.knots.size() / 2];
            for (const auto& [from, to] :
                 {std::pair(0.2, 0.7),
                  std::pair(0.0, knot),
                  std::pair(knot, 1.0),
                  std::pair(0.8, 0.3)}) {
                if (to < from && !closed) {
                    continue;
                }
                const Curve part = partOfCurve(workpiece, curve, from, to);
                SCOPED_TRACE(testing::Message() << degree << closed << from << " " << to);
                expectWhole(workpiece, part);
                const double length = (to < from ? to + 1.0 : to) - from;
                for (int i = 0; i <= 100; ++i) {
                    const double t = from + length * i / 100.0;
                    const double on = t > 1.0 ? t - 1.0 : t;
                    EXPECT_LT(
                        (positionOf(part.spline, i / 100.0) - positionOf(curve.spline, on)).norm(),
                        1e-12
                    );
                }
            }
        }
    }
}

TEST(PiecesOfCurves, AreTogetherAsLongAsTheWhole) {
    const Workpiece workpiece(icosphere(4));
    const std::vector<Vec3> ring = {{1, 0, 0.2}, {0, 1, -0.1}, {-1, 0, 0.3}, {0, -1, 0.0}};
    for (const bool closed : {false, true}) {
        std::vector<Vec3> picks;
        for (const Vec3& pick : ring) {
            picks.push_back(pick.normalized());
        }
        const Curve curve = drawnOn(workpiece, picks, closed);
        const std::array cuts{0.7, 0.25, curve.spline.pickParameters[1]};
        const std::vector<Curve> parts = partsOfCurve(workpiece, curve, cuts);
        EXPECT_EQ(parts.size(), closed ? 3U : 4U);
        double length = 0.0;
        for (const Curve& part : parts) {
            expectWhole(workpiece, part);
            length += lengthOf(part.polyline);
        }
        EXPECT_NEAR(length, lengthOf(curve.polyline), 1e-12);
        Curve whole = parts.front();
        for (std::size_t i = 1; i < parts.size(); ++i) {
            whole = joinedCurves(workpiece, whole, parts[i], {.isSmooth = true});
        }
        expectWhole(workpiece, whole);
        EXPECT_NEAR(lengthOf(whole.polyline), length, 1e-12);
        EXPECT_LT(largestTurn(whole.spline), 1e-6);
        EXPECT_TRUE(cornersOf(whole.spline).empty());
    }
}

TEST(JoinedCurves, MeetAtACornerInTheOrderOfTheFirst) {
    const Workpiece workpiece(jitteredPlate(30, 30, 0.2, 3));
    const std::vector<Vec3> bend = {{0.9, 0.55, 0.0}, {0.8, 0.8, 0.0}, {0.5, 0.9, 0.0}};
    for (const int degree : {2, 3, 4}) {
        const Curve first = drawnOn(workpiece, kOpenPicks, false, degree);
        const Curve second = drawnOn(workpiece, bend, false, degree);
        for (const Curve& other : {second, reversedCurve(second)}) {
            const Curve joined = joinedCurves(workpiece, first, other);
            expectWhole(workpiece, joined);
            EXPECT_EQ(joined.polyline.points.front(), first.polyline.points.front());
            EXPECT_EQ(joined.polyline.points.back(), second.polyline.points.back());
            EXPECT_EQ(cornersOf(joined.spline), std::vector<int>{3});
            EXPECT_EQ(joined.spline.pickParameters.size(), 6U);
            EXPECT_NEAR(
                lengthOf(joined.polyline),
                lengthOf(first.polyline) + lengthOf(second.polyline),
                1e-12
            );
        }
        // The second one is before the first where the first one begins there.
        const Curve before = joinedCurves(workpiece, reversedCurve(first), second);
        EXPECT_EQ(before.polyline.points.front(), second.polyline.points.back());
        EXPECT_EQ(before.polyline.points.back(), first.polyline.points.front());
    }
}

TEST(JoinedCurves, MeetSmoothlyWhereThatIsAskedFor) {
    const Workpiece workpiece(jitteredPlate(40, 40, 0.2, 3));
    const double edge = workpiece.meanEdgeLength();
    const std::vector<Vec3> bend = {{0.9, 0.55, 0.0}, {0.8, 0.8, 0.0}, {0.5, 0.9, 0.0}};
    for (const int degree : {2, 3, 4}) {
        SCOPED_TRACE(degree);
        const Curve first = drawnOn(workpiece, kOpenPicks, false, degree);
        const Curve second = drawnOn(workpiece, bend, false, degree);
        const Curve joined = joinedCurves(workpiece, first, second, {.isSmooth = true});
        expectWhole(workpiece, joined);
        EXPECT_LT(largestTurn(joined.spline), 1e-9);
        EXPECT_TRUE(cornersOf(joined.spline).empty());
        // Beyond the passage all is as it was.
        const Vec3 meeting = first.polyline.points.back();
        for (const Curve& part : {first, second}) {
            for (const Vec3& point : part.polyline.points) {
                if ((point - meeting).norm() > 3.1 * edge) {
                    EXPECT_NE(
                        std::ranges::find(joined.polyline.points, point),
                        joined.polyline.points.end()
                    );
                }
            }
        }
    }
}

TEST(JoinedCurves, BridgeAGapThatIsAllowed) {
    const Workpiece workpiece(icosphere(4));
    const auto at = [](double angle, double height) {
        return Vec3(Vec3(std::cos(angle), std::sin(angle), height).normalized());
    };
    const Curve first = drawnOn(workpiece, {at(0.0, 0.0), at(0.5, 0.1), at(1.0, 0.0)});
    const Curve second = drawnOn(workpiece, {at(1.1, 0.05), at(1.6, 0.2), at(2.0, 0.0)});
    const double gap = (first.polyline.points.back() - second.polyline.points.front()).norm();
    for (const bool isSmooth : {false, true}) {
        const JoinOptions options{.isSmooth = isSmooth, .gap = {.value = 1.01 * gap}};
        const Curve joined = joinedCurves(workpiece, first, second, options);
        expectWhole(workpiece, joined);
        if (isSmooth) {
            EXPECT_LT(largestTurn(joined.spline), 1e-9);
        } else {
            EXPECT_EQ(cornersOf(joined.spline), (std::vector<int>{2, 3}));
        }
    }
    EXPECT_THROW(
        static_cast<void>(joinedCurves(workpiece, first, second, {.gap = {.value = 0.99 * gap}})),
        InputError
    );
}

TEST(JoinedCurves, MayBePolylines) {
    const Workpiece workpiece(jitteredPlate(20, 20, 0.2, 3));
    std::vector<Curve> curves;
    for (const double y : {0.3, 0.34}) {
        Curve& curve = curves.emplace_back();
        curve.polyline = projectedPolyline(
            workpiece, {.points = {{y, 0.1, 0.0}, {y, 0.9, 0.0}}, .closed = false}, 0.1
        );
        curve.spline = polygonSpline(curve.polyline);
        curve.report.usable = true;
    }
    const Curve joined = joinedCurves(workpiece, curves[0], curves[1]);
    expectWhole(workpiece, joined);
    EXPECT_NEAR(lengthOf(joined.polyline), 1.64, 0.005);
}

TEST(JoinedCurves, SayWhatCannotBeJoined) {
    const Workpiece workpiece(jitteredPlate(20, 20, 0.2, 3));
    const Curve open = drawnOn(workpiece, kOpenPicks);
    const auto refusal = [&](const Curve& other, const JoinOptions& options = {}) -> std::string {
        try {
            static_cast<void>(joinedCurves(workpiece, open, other, options));
        } catch (const InputError& error) {
            return error.what();
        }
        return "none";
    };
    EXPECT_EQ(
        refusal(drawnOn(workpiece, kOpenPicks, true)), "a closed curve has no ends to be joined"
    );
    EXPECT_EQ(
        refusal(drawnOn(workpiece, kOpenPicks, false, 2)),
        "the splines have the degrees 3 and 2; curves of one degree can be joined"
    );
    EXPECT_NE(refusal(open, {.gap = {.value = -1.0}}).find("gap"), std::string::npos);
    const std::vector<Vec3> bend = {{0.9, 0.55, 0.0}, {0.8, 0.8, 0.0}, {0.5, 0.9, 0.0}};
    const JoinOptions none{.isSmooth = true, .blend = {.value = 0.0}};
    EXPECT_EQ(
        refusal(drawnOn(workpiece, bend), none),
        "blend is 0, but curves that meet at an angle need room to become smooth"
    );
    EXPECT_THROW(static_cast<void>(partOfCurve(workpiece, open, 0.5, 0.5)), InputError);
    EXPECT_THROW(static_cast<void>(partOfCurve(workpiece, open, 0.0, 1.5)), InputError);
    EXPECT_THROW(static_cast<void>(partsOfCurve(workpiece, open, {})), InputError);
}

TEST(ExtendedCurves, GoOnStraightOnAPlate) {
    const Workpiece workpiece(jitteredPlate(40, 40, 0.2, 3));
    for (const int degree : {2, 3, 4}) {
        SCOPED_TRACE(degree);
        const Curve curve =
            drawnOn(workpiece, {{0.3, 0.4, 0.0}, {0.5, 0.6, 0.0}, {0.7, 0.5, 0.0}}, false, degree);
        const Curve longer = extendedCurve(workpiece, curve, 0.15, 0.2);
        expectWhole(workpiece, longer);
        EXPECT_LT(largestTurn(longer.spline), 1e-9);
        EXPECT_NEAR(lengthOf(longer.polyline), lengthOf(curve.polyline) + 0.35, 1e-6);
        const Vec3 end =
            curve.polyline.points.back() + 0.2 * derivativeOf(curve.spline, 1.0).normalized();
        EXPECT_LT((longer.polyline.points.back() - end).norm(), 1e-9);
        const Vec3 start =
            curve.polyline.points.front() - 0.15 * derivativeOf(curve.spline, 0.0).normalized();
        EXPECT_LT((longer.polyline.points.front() - start).norm(), 1e-9);
        EXPECT_EQ(extendedCurve(workpiece, curve, 0.0, 0.0).polyline.points, curve.polyline.points);
    }
}

TEST(ExtendedCurves, FollowAGreatCircle) {
    const Workpiece workpiece(icosphere(5));
    const Curve curve =
        drawnOn(workpiece, {Vec3(1.0, 0.0, 0.0), Vec3(std::cos(0.5), 0.0, std::sin(0.5))});
    const Curve longer = extendedCurve(workpiece, curve, 0.0, 4.0);
    expectWhole(workpiece, longer);
    EXPECT_NEAR(lengthOf(longer.polyline), 4.5, 0.01);
    for (const Vec3& point : longer.polyline.points) {
        EXPECT_LT(std::abs(point.y()), 0.02);
    }
    EXPECT_NEAR(
        std::atan2(longer.polyline.points.back().z(), longer.polyline.points.back().x()),
        4.5 - 2.0 * std::numbers::pi,
        0.01
    );
}

TEST(ExtendedCurves, EndAtABoundary) {
    const Workpiece workpiece(jitteredPlate(20, 20, 0.2, 3));
    const Curve curve = drawnOn(workpiece, {{0.3, 0.5, 0.0}, {0.6, 0.5, 0.0}});
    const Curve longer = extendedCurve(workpiece, curve, 0.0, 5.0);
    expectWhole(workpiece, longer);
    EXPECT_LT((longer.polyline.points.back() - Vec3(1.0, 0.5, 0.0)).norm(), 1e-6);
    EXPECT_THROW(static_cast<void>(extendedCurve(workpiece, longer, 0.0, 0.1)), InputError);
    EXPECT_THROW(static_cast<void>(extendedCurve(workpiece, curve, 0.0, -0.1)), InputError);
    const Curve closed = drawnOn(workpiece, kOpenPicks, true);
    EXPECT_THROW(static_cast<void>(extendedCurve(workpiece, closed, 0.0, 0.1)), InputError);
}

}  // namespace

}  // namespace bspline_curve::workpiece_tests

// SPDX-License-Identifier: GPL-3.0-or-later
// Curves with corners, judged from the outside: each section is the open curve of its own picks.
#include "bspline_curve/error.h"
#include "bspline_curve/spline.h"
#include "design/curve_checks.h"
#include "offset/offset_curves.h"
#include "support/many_cases.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <span>
#include <string>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

/// A heart round the middle of the unit plate: pick 0 is its notch, pick 6 its tip.
std::vector<Vec3> heart() {
    std::vector<Vec3> picks;
    for (int i = 0; i < 12; ++i) {
        const double t = std::numbers::pi * i / 6.0;
        const double x = 16.0 * std::pow(std::sin(t), 3);
        const double y = 13.0 * std::cos(t) - 5.0 * std::cos(2.0 * t) - 2.0 * std::cos(3.0 * t) -
                         std::cos(4.0 * t);
        picks.emplace_back(0.5 + x / 50.0, 0.52 + y / 50.0, 0.0);
    }
    return picks;
}

Curve cornered(
    const CurveDesigner& designer,
    const std::vector<Vec3>& picks,
    const std::vector<int>& corners,
    const SolverOptions& options = {},
    CurveInputs inputs = {}
) {
    inputs.corners = corners;
    return goodCurve(designer, picks, options, inputs);
}

/// The picks of each section; the first one begins at pick 0, or passes it.
std::vector<std::vector<int>> sectionsBetween(int count, std::vector<int> corners, bool closed) {
    std::ranges::sort(corners);
    if (!closed) {
        std::erase_if(corners, [&](int c) { return c == 0 || c == count - 1; });
        corners.insert(corners.begin(), 0);
        corners.push_back(count - 1);
    } else if (corners.front() == 0) {
        corners.push_back(count);
    } else {
        corners.insert(corners.begin(), corners.back() - count);
    }
    std::vector<std::vector<int>> sections;
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
        std::vector<int>& picks = sections.emplace_back();
        for (int p = corners[i]; p <= corners[i + 1]; ++p) {
            picks.push_back((p + count) % count);
        }
    }
    return sections;
}

template <class Value>
std::vector<Value> ofIndices(const std::vector<Value>& values, const std::vector<int>& indices) {
    std::vector<Value> chosen;
    for (const int i : indices) {
        chosen.push_back(values[i]);
    }
    return chosen;
}

/// Expects full knots at the corners, simple ones elsewhere, and a control point at each corner.
void expectKnots(const Curve& curve, const std::vector<int>& corners) {
    const SplineData& spline = curve.spline;
    std::vector<int> inner = corners;
    std::ranges::sort(inner);
    if (!spline.closed) {
        std::erase_if(inner, [&](int c) {
            return c == 0 || c + 1 == std::ssize(spline.pickParameters);
        });
    }
    EXPECT_EQ(cornersOf(spline), inner);
    for (const int c : inner) {
        EXPECT_EQ(std::ranges::count(spline.knots, spline.pickParameters[c]), spline.degree);
    }
    for (std::size_t i = 0; i < spline.knots.size(); ++i) {
        const double t = spline.knots[i];
        const auto isAt = [&](int c) { return spline.pickParameters[c] == t; };
        if (t > 0.0 && t < 1.0 && std::ranges::none_of(inner, isAt)) {
            EXPECT_EQ(std::ranges::count(spline.knots, t), 1) << t;
        }
    }
    EXPECT_EQ(spline.knots.size(), spline.controlPoints.size() + spline.degree + 1);
    EXPECT_EQ(curve.report.knotsLast, std::ssize(spline.knots));
    EXPECT_GT(curve.report.knotsFirst, 0);
}

/// Expects that each section is the open curve through its picks.
void expectSections(
    const CurveDesigner& designer,
    const Curve& curve,
    const std::vector<Vec3>& picks,
    const std::vector<int>& corners,
    const SolverOptions& options
) {
    SolverOptions open = options;
    open.closed = false;
    const auto count = static_cast<int>(curve.polyline.points.size());
    for (const std::vector<int>& points :
         sectionsBetween(static_cast<int>(picks.size()), corners, options.closed)) {
        const Curve alone = designer.design(ofIndices(picks, points), open);
        const int from = curve.polyline.picks[points.front()];
        for (std::size_t i = 0; i < alone.polyline.points.size(); ++i) {
            const int vertex = (from + static_cast<int>(i)) % count;
            ASSERT_EQ(curve.polyline.points[vertex], alone.polyline.points[i]) << i;
        }
        const double t0 = curve.polyline.parameters[from];
        const double t1 = curve.spline.pickParameters[points.back()];
        const double length = t1 > t0 ? t1 - t0 : t1 + 1.0 - t0;
        for (int i = 1; i < 100; ++i) {
            const double t = t0 + length * i / 100.0;
            const Vec3 whole = pointOfSpline(curve.spline, t < 1.0 ? t : t - 1.0);
            EXPECT_LT((whole - pointOfSpline(alone.spline, i / 100.0)).norm(), 1e-12);
        }
    }
}

TEST(Corners, MakeAHeart) {
    const CurveDesigner designer(jitteredPlate(40, 40, 0.2, 3));
    const std::vector<Vec3> picks = heart();
    const std::vector<int> corners = {6, 0};
    const SolverOptions options{.closed = true};
    const Curve curve = cornered(designer, picks, corners, options);
    expectKnots(curve, corners);
    expectSections(designer, curve, picks, corners, options);
    EXPECT_EQ(curve.report.status, SolveStatus::Converged);
}

TEST(Corners, MayBeTheOnlyOneOfAClosedCurve) {
    const CurveDesigner designer(jitteredPlate(40, 40, 0.2, 3));
    const std::vector<Vec3> picks = heart();
    for (const int corner : {0, 6, 11}) {
        SCOPED_TRACE(corner);
        const SolverOptions options{.closed = true};
        const Curve curve = cornered(designer, picks, {corner}, options);
        expectKnots(curve, {corner});
        expectSections(designer, curve, picks, {corner}, options);
    }
}

TEST(Corners, AreExactOnRandomCurves) {
    const int sets = caseCount(67, 6);  // of picks: with three degrees 201 curves
    const CurveDesigner designer(withNoise(icosphere(4), 0.002, 5));
    const TriangleTree& tree = designer.tree();
    std::mt19937 random(17);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (int i = 0; i < sets; ++i) {
        const bool closed = i % 2 == 0;
        const int count = 4 + i % 5;
        std::vector<Vec3> picks;
        for (int k = 0; k < count; ++k) {
            const double angle = 2.0 * std::numbers::pi * (k + 0.4 * uniform(random)) / count;
            const double height = 0.8 * (uniform(random) - 0.5);
            picks.push_back(
                tree.closestPoint(Vec3(std::cos(angle), std::sin(angle), height).normalized())
                    .position
            );
        }
        std::vector<int> corners;
        for (int k = count - 1; k >= 0; --k) {
            if (uniform(random) < 0.4) {
                corners.push_back(k);
            }
        }
        if (corners.empty()) {
            corners.push_back(count / 2);
        }
        for (const int degree : {2, 3, 4}) {
            SCOPED_TRACE(testing::Message() << "curve " << i << ", degree " << degree);
            const SolverOptions options{.degree = degree, .closed = closed};
            const Curve curve = cornered(designer, picks, corners, options);
            expectKnots(curve, corners);
            expectSections(designer, curve, picks, corners, options);
        }
    }
}

TEST(Corners, OfATriangleOnASphereAreJoinedByGreatCircles) {
    const CurveDesigner designer(icosphere(5));
    std::vector<Vec3> picks;
    for (const double angle : {0.1, 2.2, 4.3}) {
        picks.push_back(designer.tree()
                            .closestPoint(Vec3(0.8 * std::cos(angle), 0.8 * std::sin(angle), 0.6))
                            .position);
    }
    const Curve curve = cornered(designer, picks, {0, 1, 2}, {.closed = true});
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 normal = picks[i].cross(picks[(i + 1) % 3]).normalized();
        const int from = curve.polyline.picks[i];
        const int to =
            i < 2 ? curve.polyline.picks[i + 1] : static_cast<int>(curve.polyline.points.size());
        for (int vertex = from; vertex < to; ++vertex) {
            EXPECT_LT(std::abs(curve.polyline.points[vertex].dot(normal)), 2e-3) << vertex;
        }
    }
}

TEST(Corners, AtTheEndsOfAnOpenCurveChangeNothing) {
    const CurveDesigner designer(jitteredPlate(20, 20, 0.2, 3));
    const std::vector<Vec3> picks = {{0.1, 0.2, 0.0}, {0.5, 0.7, 0.0}, {0.9, 0.4, 0.0}};
    expectSameBits(cornered(designer, picks, {2, 0}), goodCurve(designer, picks));
}

TEST(Corners, OfRepeatedPicksAreThoseOfTheirPoint) {
    const CurveDesigner designer(jitteredPlate(20, 20, 0.2, 3));
    const std::vector<Vec3> once = {{0.1, 0.2, 0.0}, {0.5, 0.7, 0.0}, {0.9, 0.4, 0.0}};
    const std::vector<Vec3> twice = {once[0], once[1], once[1], once[2]};
    CurveInputs inputs;
    const std::vector<int> corners = {2};
    inputs.corners = corners;
    const Curve curve = designer.design(twice, {}, {}, inputs);
    EXPECT_EQ(curve.polyline.points, cornered(designer, once, {1}).polyline.points);
    EXPECT_EQ(curve.polyline.picks[1], curve.polyline.picks[2]);
    EXPECT_EQ(curve.report.repeatedPicks, std::vector<int>{2});
    EXPECT_EQ(cornersOf(curve.spline), (std::vector<int>{1, 2}));
}

TEST(Corners, ArePassedWhateverTheirTolerance) {
    const CurveDesigner designer(jitteredPlate(40, 40, 0.2, 3));
    const std::vector<Vec3> picks = heart();
    const std::vector<int> corners = {0, 6};
    CurveInputs inputs;
    inputs.corners = corners;
    const Curve curve =
        designer.design(picks, {.closed = true, .pickTolerance = {.value = 0.02}}, {}, inputs);
    ASSERT_TRUE(curve.report.usable);
    expectStrict(designer.surface(), curve.polyline);
    expectKnots(curve, corners);
    ASSERT_EQ(curve.report.pickDistances.size(), picks.size());
    double most = 0.0;
    for (std::size_t i = 0; i < picks.size(); ++i) {
        const double distance = distanceToPolyline(picks[i], curve.polyline);
        EXPECT_LE(distance, i % 6 == 0 ? 1e-12 : 0.02) << i;
        EXPECT_NEAR(distance, curve.report.pickDistances[i], 1e-9) << i;
        most = std::max(most, distance);
    }
    EXPECT_GT(most, 1e-3);  // the others are not
}

TEST(Corners, MayBeDrawnUnderAField) {
    const TriangleMesh mesh = jitteredPlate(40, 40, 0.2, 3);
    CurveInputs inputs;
    inputs.field = ScalarField(sampled(mesh, [](const Vec3& p) {
        return std::min(1.0, 4.0 * std::abs(p.y() - 0.5));
    }));
    const CurveDesigner designer(mesh);
    const std::vector<Vec3> picks = {{0.1, 0.5, 0.0}, {0.5, 0.8, 0.0}, {0.9, 0.5, 0.0}};
    const Curve curve = cornered(designer, picks, {1}, {}, inputs);
    double mean = 0.0;
    for (const auto& [from, to] : {std::pair(0, 1), std::pair(1, 2)}) {
        CurveInputs alone = inputs;
        const double share = curve.spline.pickParameters[to] - curve.spline.pickParameters[from];
        mean += share * designer.design({picks[from], picks[to]}, {}, {}, alone).report.fieldCost;
    }
    EXPECT_NEAR(curve.report.fieldCost, mean, 1e-12);
}

TEST(Corners, KeepOutOfFacesToAvoid) {
    const TriangleMesh mesh = jitteredPlate(30, 30, 0.2, 3);
    std::vector<int> avoid;
    for (int f = 0; f < std::ssize(mesh.faces); ++f) {
        const Triangle& face = mesh.faces[f];
        const Vec3 centre =
            (mesh.vertices[face[0]] + mesh.vertices[face[1]] + mesh.vertices[face[2]]) / 3.0;
        if ((centre - Vec3(0.3, 0.5, 0.0)).norm() < 0.1) {
            avoid.push_back(f);
        }
    }
    const CurveDesigner designer(mesh);
    CurveInputs inputs;
    inputs.avoid = avoid;
    const std::vector<Vec3> picks = {{0.1, 0.5, 0.0}, {0.6, 0.5, 0.0}, {0.6, 0.9, 0.0}};
    const Curve curve = cornered(designer, picks, {1}, {}, inputs);
    EXPECT_GT(curve.report.clearance, 0.0);
    EXPECT_EQ(curve.report.avoidedFaces, std::ssize(avoid));
}

TEST(Corners, HaveIdsOfTheInputOfAMendedMesh) {
    const CurveDesigner designer(withFaceReversed(jitteredPlate(20, 20, 0.2, 3), 100));
    const std::vector<Vec3> picks = {{0.1, 0.2, 0.0}, {0.5, 0.7, 0.0}, {0.9, 0.4, 0.0}};
    const Curve curve = designer.design(picks, {}, {}, {.corners = std::vector<int>{1}});
    const TriangleMesh& mesh = designer.mesh();
    for (std::size_t i = 0; i < curve.polyline.points.size(); ++i) {
        const auto& [face, barycentric] = curve.polyline.surfacePoints[i];
        Vec3 position = Vec3::Zero();
        for (int k = 0; k < 3; ++k) {
            position += barycentric[k] * mesh.vertices[mesh.faces[face][k]];
        }
        EXPECT_LT((position - curve.polyline.points[i]).norm(), 1e-14);
    }
    EXPECT_EQ(cornersOf(curve.spline), std::vector<int>{1});
}

TEST(Corners, StayWhereACurveStartsFromAnother) {
    const CurveDesigner designer(jitteredPlate(40, 40, 0.2, 3));
    std::vector<Vec3> picks = heart();
    const std::vector<std::vector<int>> choices = {{0, 6}, {6}, {3, 9}};
    for (const std::vector<int>& corners : choices) {
        const SolverOptions options{.closed = true};
        const Curve before = cornered(designer, picks, corners, options);
        std::vector<Vec3> moved = picks;
        moved[2] += Vec3(0.02, -0.01, 0.0);
        CurveInputs inputs;
        inputs.start = &before;
        const Curve after = cornered(designer, moved, corners, options, inputs);
        expectKnots(after, corners);
        const Curve scratch = cornered(designer, moved, corners, options);
        EXPECT_LT(largestDistance(after.polyline, scratch.polyline), 1e-2);
        EXPECT_LE(after.report.newtonIterations, scratch.report.newtonIterations);
    }
}

TEST(Corners, OfOtherPicksAreNoStart) {
    const CurveDesigner designer(jitteredPlate(40, 40, 0.2, 3));
    const std::vector<Vec3> picks = heart();
    const SolverOptions options{.closed = true};
    const std::vector<std::vector<int>> others = {{}, {5, 6}, {0, 5}, {1}};
    for (const std::vector<int>& other : others) {
        CurveInputs none;
        none.corners = other;
        const Curve before = designer.design(picks, options, {}, none);
        CurveInputs inputs;
        inputs.start = &before;
        expectSameBits(
            cornered(designer, picks, {0, 6}, options, inputs),
            cornered(designer, picks, {0, 6}, options)
        );
    }
    const Curve before = cornered(designer, picks, {0, 6}, options);
    CurveInputs inputs;
    inputs.start = &before;
    expectSameBits(
        goodCurve(designer, picks, options, inputs), goodCurve(designer, picks, options)
    );
}

TEST(Corners, MayBeDrawnAsInThePaper) {
    const CurveDesigner designer(
        jitteredPlate(16, 16, 0.2, 3), ShellOptions{.kind = ShellKind::Simplified}
    );
    const std::vector<Vec3> picks = {
        {0.1, 0.2, 0.0}, {0.3, 0.7, 0.0}, {0.5, 0.5, 0.0}, {0.9, 0.4, 0.0}
    };
    CurveInputs inputs;
    const std::vector<int> corners = {2};
    inputs.corners = corners;
    const Curve curve = designer.design(picks, paperPreset(), {}, inputs);
    expectStrict(designer.surface(), curve.polyline);
    expectKnots(curve, corners);
    EXPECT_EQ(curve.shell, ShellKind::Simplified);
}

TEST(Corners, HaveOffsetsAtTheirDistance) {
    const CurveDesigner designer(jitteredPlate(40, 40, 0.2, 3));
    const Curve curve = cornered(designer, heart(), {0, 6}, {.closed = true});
    const std::vector<SurfacePolyline> lines =
        offsetPolylines(designer.surface(), curve.polyline, {.distance = 0.03});
    ASSERT_EQ(lines.size(), 2U);
    for (const SurfacePolyline& line : lines) {
        for (const Vec3& point : line.points) {
            EXPECT_NEAR(distanceToPolyline(point, curve.polyline), 0.03, 1e-4);
        }
    }
}

TEST(Corners, ThatAreNoPicksAreRefused) {
    const CurveDesigner designer(plate(4, 4));
    const std::vector<Vec3> picks = {{0.1, 0.1, 0.0}, {0.9, 0.8, 0.0}, {0.9, 0.2, 0.0}};
    for (const int corner : {3, -1}) {
        CurveInputs inputs;
        const std::vector<int> corners = {1, corner};
        inputs.corners = corners;
        try {
            static_cast<void>(designer.design(picks, {}, {}, inputs));
            FAIL() << corner;
        } catch (const InputError& error) {
            EXPECT_EQ(error.code(), InputErrorCode::BadOption);
            EXPECT_EQ(error.elements(), std::vector<std::int64_t>{corner});
            if (corner == 3) {
                EXPECT_STREQ(error.what(), "pick 4 is to be a corner, but there are 3 picks");
            }
        }
    }
}

}  // namespace
}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
// Splines followed over the extended surface along the fibres.
#include "projection/fibre_tracer.h"

#include "solver/problem_traces.h"
#include "support/meshes.h"
#include "support/random.h"
#include "surface/surface_point.h"
#include "surface/triangle_tree.h"
#include "utility/worker_thread.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::vector<double> evenBreaks(int spans) {
    std::vector<double> breaks;
    for (int i = 0; i <= spans; ++i) {
        breaks.push_back(static_cast<double>(i) / spans);
    }
    return breaks;
}

// A clamped cubic over a mesh in the extended surface's frame, whose ends are its picks.
struct Followed {
    Followed(const TriangleMesh& mesh, const std::vector<Vec3>& controlPoints)
        : surface(mesh),
          extended(extendSurface(surface, 3)),
          space(3, false, evenBreaks(static_cast<int>(controlPoints.size()) - 3)),
          controls(static_cast<Eigen::Index>(controlPoints.size()), 3) {
        for (std::size_t c = 0; c < controlPoints.size(); ++c) {
            controls.row(static_cast<Eigen::Index>(c)) = extended.frame.toUnit(controlPoints[c]);
        }
        problem.extended = &extended;
        problem.distanceTolerance = 1e-3;
        pin(0.0);
        pin(1.0);
        controls.row(0) = problem.picks.front().position;
        controls.row(controls.rows() - 1) = problem.picks.back().position;
    }

    // A pick where the curve passes.
    void pin(double parameter) {
        const Vec3 there = space.evaluate(controls, parameter);
        const SurfacePoint point =
            TriangleTree(extended.vertices, extended.faces).closestPoint(there).point;
        problem.picks.push_back({point, extended.position(point), parameter});
    }

    [[nodiscard]] CurveDistance measured() const {
        return measureAlongFibres(fibreStartOf(problem), space, controls);
    }

    [[nodiscard]] CurveDistance measuredInHalves(const FootOfSpan& middle) const {
        return measureAlongFibres(fibreStartOf(problem), space, controls, middle);
    }

    // How far q + height n(q) is from P, at best.
    [[nodiscard]] double missOf(const SurfacePoint& foot, double t) const {
        const Triangle& face = extended.faces[foot.face];
        Vec3 n = Vec3::Zero();
        for (int corner = 0; corner < 3; ++corner) {
            n += foot.barycentric[corner] * extended.directions[face[corner]];
        }
        return (space.evaluate(controls, t) - extended.position(foot)).cross(n.normalized()).norm();
    }

    Surface surface;
    ExtendedSurface extended;
    SplineSpace space;
    ControlPoints controls;
    CurveProblem problem;
};

// Round a sphere or a torus in its plane, up and down.
std::vector<Vec3> roundTrip(double radius, double wave) {
    std::vector<Vec3> points;
    for (int i = 0; i < 24; ++i) {
        const double angle = 0.3 + 0.2 * i;
        const double r = radius * (1.0 + wave * std::sin(2.0 * i));
        points.emplace_back(
            r * std::cos(angle), r * std::sin(angle), radius * 0.1 * std::sin(1.3 * i)
        );
    }
    return points;
}

struct FollowedCase {
    std::string name;
    TriangleMesh mesh;
    std::vector<Vec3> points;

    friend std::ostream& operator<<(std::ostream& out, const FollowedCase& c) {
        return out << c.name;
    }
};

std::vector<FollowedCase> followedCases() {
    std::vector<Vec3> acrossPlate;
    for (int i = 0; i < 12; ++i) {
        const double x = 0.05 + 0.08 * i;
        acrossPlate.emplace_back(x, 0.5 + 0.3 * std::sin(9.0 * x), 0.02 * std::cos(20.0 * x));
    }
    return {
        {"NoisySphere", withNoise(icosphere(4), 0.01, 5), roundTrip(1.0, 0.02)},
        {"CoarseSphere", icosphere(1), roundTrip(0.9, 0.02)},
        {"Torus", torus(60, 24), roundTrip(1.4, 0.01)},
        {"JitteredPlate", jitteredPlate(12, 12, 0.02, 3), acrossPlate}
    };
}

class FibreTraces : public testing::TestWithParam<FollowedCase> {
protected:
    Followed followed_{GetParam().mesh, GetParam().points};
    CurveDistance distance_ = followed_.measured();
    const FibreTrace& trace_ = std::get<FibreTrace>(distance_.trace);
};

TEST_P(FibreTraces, PassFromFaceToFaceOnTheEdgesBetween) {
    ASSERT_TRUE(trace_.isWhole);
    const std::vector<int> faces = facesPassed(distance_.trace);
    ASSERT_GT(faces.size(), 20U);
    ASSERT_EQ(trace_.crossings.size(), faces.size() - 1);
    double before = 0.0;
    for (std::size_t i = 0; i < trace_.crossings.size(); ++i) {
        const auto& [parameter, point] = trace_.crossings[i];
        EXPECT_GE(parameter, before);
        before = parameter;
        const Triangle& neighbours = followed_.extended.faceNeighbours[faces[i]];
        EXPECT_EQ(std::ranges::count(neighbours, faces[i + 1]), 1);
        EXPECT_EQ(point.face, faces[i]);
        EXPECT_EQ(point.barycentric.minCoeff(), 0.0);
        EXPECT_EQ(std::ranges::count(facesHolding(followed_.surface, point), faces[i + 1]), 1);
        EXPECT_LT(followed_.missOf(point, parameter), 1e-12);
    }
}

TEST_P(FibreTraces, HaveTheFeetOfWalks) {
    ASSERT_TRUE(trace_.isWhole);
    const FibreProjector finder(followed_.extended);
    const SurfacePoint& first = followed_.problem.picks.front().point;
    FootPoint walked{first.face, first.barycentric[1], first.barycentric[2], 0.0};
    FootFrame frame;
    double farthest = 0.0;
    constexpr int kSteps = 5000;
    for (int i = 0; i <= kSteps; ++i) {
        const double t = static_cast<double>(i) / kSteps;
        finder.move(followed_.space.evaluate(followed_.controls, t), walked, frame);
        const FootPoint foot =
            footAt(followed_.extended, trace_, followed_.space, followed_.controls, t);
        const SurfacePoint point{foot.face, foot.barycentric()};
        EXPECT_GT(point.barycentric.minCoeff(), -1e-9);
        EXPECT_LT(followed_.missOf(point, t), 1e-12);
        const Vec3 there = followed_.extended.position({walked.face, walked.barycentric()});
        EXPECT_LT((followed_.extended.position(point) - there).norm(), 1e-8);
        farthest =
            std::max(farthest, (followed_.space.evaluate(followed_.controls, t) - there).norm());
    }
    EXPECT_LT(distance_.largest, 1.002 * farthest);
    EXPECT_GT(distance_.largest, 0.98 * farthest);
    EXPECT_EQ(distance_.largest, std::ranges::max(distance_.perSpan));
}

void expectSame(const CurveDistance& a, const CurveDistance& b) {
    const auto& traceA = std::get<FibreTrace>(a.trace);
    const auto& traceB = std::get<FibreTrace>(b.trace);
    EXPECT_EQ(traceA.isWhole, traceB.isWhole);
    EXPECT_EQ(traceA.wholeSpans, traceB.wholeSpans);
    EXPECT_EQ(facesPassed(a.trace), facesPassed(b.trace));
    ASSERT_EQ(traceA.crossings.size(), traceB.crossings.size());
    for (std::size_t i = 0; i < traceA.crossings.size(); ++i) {
        EXPECT_NEAR(traceA.crossings[i].parameter, traceB.crossings[i].parameter, 1e-13);
    }
    ASSERT_EQ(a.perSpan.size(), b.perSpan.size());
    for (std::size_t i = 0; i < a.perSpan.size(); ++i) {
        if (a.perSpan[i] != b.perSpan[i]) {
            EXPECT_NEAR(a.perSpan[i], b.perSpan[i], 1e-13);
        }
    }
}

TEST_P(FibreTraces, AreTheSameInHalves) {
    WorkerThread side;
    for (int span = 1; span < followed_.space.spanCount(); ++span) {
        const FootPoint foot = footAt(
            followed_.extended,
            trace_,
            followed_.space,
            followed_.controls,
            followed_.space.breaks()[span]
        );
        const CurveDistance alone = followed_.measuredInHalves({span, foot});
        expectSame(alone, distance_);
        followed_.problem.side = &side;
        const CurveDistance both = followed_.measuredInHalves({span, foot});
        followed_.problem.side = nullptr;
        expectSame(both, alone);
        EXPECT_EQ(both.perSpan, alone.perSpan);
    }
}

TEST_P(FibreTraces, AreTheSameInHalvesOneOfWhichBeginsElsewhere) {
    const int span = followed_.space.spanCount() / 2;
    for (int face = 0; face < followed_.surface.faceCount(); face += 7) {
        expectSame(followed_.measuredInHalves({span, {face, 0.3, 0.3, 0.0}}), distance_);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Meshes,
    FibreTraces,
    testing::ValuesIn(followedCases()),
    [](const testing::TestParamInfo<FollowedCase>& tested) { return tested.param.name; }
);

// Two faces on either side of the diagonal of a square.
TEST(FibreTrace, LeavesAFaceAndComesBackWithinASpan) {
    const Followed followed(
        plate(1, 1), {{0.3, 0.2, 0.0}, {0.4, 0.8, 0.0}, {0.6, 0.8, 0.0}, {0.9, 0.6, 0.0}}
    );
    const CurveDistance distance = followed.measured();
    const std::vector<int> faces = facesPassed(distance.trace);
    ASSERT_EQ(faces.size(), 3U);
    EXPECT_EQ(faces.front(), faces.back());
    for (const EdgeCrossing& crossing : progressOf(distance.trace).crossings) {
        const Vec3 there = followed.extended.frame.toUser(
            followed.space.evaluate(followed.controls, crossing.parameter)
        );
        EXPECT_NEAR(there.x(), there.y(), 1e-10);
    }
}

TEST(FibreTrace, PassesVerticesAndAlongEdges) {
    std::vector<Vec3> alongRow;
    std::vector<Vec3> alongDiagonal;
    for (int i = 0; i <= 8; ++i) {
        alongRow.emplace_back(i / 8.0, 0.5, 0.0);
        alongDiagonal.emplace_back(i / 8.0, i / 8.0, 0.0);
    }
    for (const std::vector<Vec3>& points : {alongRow, alongDiagonal}) {
        const Followed followed(plate(4, 4), points);
        const CurveDistance distance = followed.measured();
        EXPECT_TRUE(progressOf(distance.trace).isWhole);
        EXPECT_LT(distance.largest, 1e-12);
        // Round a vertex faces are passed without a way in them, but not left out.
        const std::vector<EdgeCrossing>& crossings = progressOf(distance.trace).crossings;
        EXPECT_GE(crossings.size(), facesPassed(distance.trace).size() - 1);
        for (std::size_t i = 1; i < crossings.size(); ++i) {
            EXPECT_GE(commonFace(followed.surface, crossings[i - 1].point, crossings[i].point), 0);
        }
    }
}

// Round them, whatever rounding makes of the coordinates there. The last curve starts a span on an
// edge, by rounding, and is coming back to it where the span ends.
TEST(FibreTrace, PassesVerticesAtBreaks) {
    constexpr int kSpans = 8;
    constexpr int kWalks = 300;
    for (int i = 0; i < kWalks; ++i) {
        SCOPED_TRACE("curve " + std::to_string(i));
        Random random(static_cast<std::uint64_t>(i + 1 < kWalks ? i : 5308));
        Eigen::Isometry3d turn = Eigen::Isometry3d::Identity();
        turn.rotate(
            Eigen::AngleAxisd(random.uniform(0.0, 6.0), random.point(-1.0, 1.0).normalized())
        );
        const TriangleMesh mesh =
            transformed(withNoise(icosphere(3), 0.005, 9), turn, random.uniform(0.1, 1000.0));
        // Near vertices one after the other on a great circle.
        const Vec3 start = random.point(-1.0, 1.0).normalized();
        const Vec3 across = start.cross(random.point(-1.0, 1.0)).normalized();
        const auto vertexTowards = [&](double angle) {
            const Vec3 direction = std::cos(angle) * start + std::sin(angle) * across;
            return *std::ranges::max_element(mesh.vertices, {}, [&](const Vec3& v) {
                return v.dot(direction);
            });
        };
        std::vector<Vec3> controlPoints;
        for (int c = 0; c < kSpans + 3; ++c) {
            controlPoints.push_back(vertexTowards(0.2 * c));
        }
        Followed followed(mesh, controlPoints);
        // At these breaks three control points act alone, and none of them twice.
        for (const int span : {3, 6}) {
            const double t = static_cast<double>(span) / kSpans;
            const Vec3 there = followed.space.evaluate(followed.controls, t);
            const Vec3 wanted =
                *std::ranges::min_element(followed.extended.vertices, {}, [&](const Vec3& v) {
                    return (v - there).squaredNorm();
                });
            for (int j = 0; j < 3; ++j) {
                followed.controls.row(span + j) += wanted - there;
            }
            followed.pin(t);
        }
        const CurveDistance distance = followed.measured();
        EXPECT_TRUE(progressOf(distance.trace).isWhole);
        EXPECT_LT(distance.largest, 0.05);
    }
}

TEST(FibreTrace, LiesOnTheBoundaryBeyondIt) {
    std::vector<Vec3> points;
    for (int i = 0; i <= 8; ++i) {
        points.emplace_back(0.1 + 0.1 * i, 0.02 * std::abs(i - 4) - 0.03, 0.0);
    }
    const Followed followed(plate(10, 10), points);
    const CurveDistance distance = followed.measured();
    ASSERT_TRUE(progressOf(distance.trace).isWhole);
    double beyond = 0.0;
    for (int i = 0; i <= 1000; ++i) {
        const Vec3 p = followed.space.evaluate(followed.controls, i / 1000.0);
        beyond = std::max(beyond, -followed.extended.frame.toUser(p).y());
    }
    EXPECT_GT(beyond, 0.005);
    EXPECT_NEAR(distance.largest * followed.extended.frame.scale, beyond, 0.05 * beyond);
    int outside = 0;
    for (const EdgeCrossing& crossing : progressOf(distance.trace).crossings) {
        ASSERT_LT(crossing.point.face, followed.surface.faceCount());
        const Vec3 p = followed.space.evaluate(followed.controls, crossing.parameter);
        if (followed.extended.frame.toUser(p).y() < -1e-9) {
            EXPECT_NEAR(followed.surface.position(crossing.point).y(), 0.0, 1e-12);
            ++outside;
        }
    }
    EXPECT_GT(outside, 3);
}

TEST(FibreTrace, EndsWithTheGhosts) {
    std::vector<Vec3> points;
    for (int i = 0; i <= 8; ++i) {
        points.emplace_back(0.1 + 0.1 * i, 0.3 - 0.5 * (4 - std::abs(i - 4)) / 4.0, 0.0);
    }
    const Followed followed(plate(10, 10), points);
    const CurveDistance distance = followed.measured();
    EXPECT_FALSE(progressOf(distance.trace).isWhole);
    EXPECT_EQ(distance.largest, kInfinity);
    EXPECT_LT(distance.perSpan.front(), 1e-9);
    EXPECT_EQ(distance.perSpan.back(), kInfinity);
    // What is known of a second half is of no use then.
    const int last = followed.space.spanCount() - 1;
    const SurfacePoint& goal = followed.problem.picks.back().point;
    expectSame(
        followed.measuredInHalves({last, {goal.face, goal.barycentric[1], goal.barycentric[2]}}),
        distance
    );
}

TEST(FibreTrace, EndsWhereFibresCross) {
    std::vector<Vec3> points;
    for (int i = 0; i <= 8; ++i) {
        points.emplace_back(0.05, 0.02, 1.0 - 0.25 * i);
    }
    const Followed followed(icosphere(3), points);
    const CurveDistance distance = followed.measured();
    const int whole = progressOf(distance.trace).wholeSpans;
    EXPECT_GT(whole, 0);
    EXPECT_LT(whole, followed.space.spanCount());
    EXPECT_LT(distance.perSpan[whole - 1], 0.5);
    EXPECT_EQ(distance.perSpan[whole], kInfinity);
}

// The direction at one corner points to the other side, so that fibres cross near the edge: each
// face has the curve leave by it, after a piece of 1e-14 of the span.
TEST(FibreTrace, EndsWhereTwoFacesHandItBackAndForth) {
    Followed followed(
        TriangleMesh{
            {{-0.510, 2.039, -1.059},
             {-0.571, 2.261, 0.200},
             {0.156, -0.393, 0.003},
             {-0.282, 7.297, 3.059}},
            {{0, 1, 2}, {3, 2, 1}}
        },
        {{0.001, 0.155, 0.036}, {0.0, 0.161, 0.041}, {-0.002, 0.167, 0.047}, {-0.003, 0.173, 0.052}}
    );
    const std::array<Vec3, 4> directions = {
        Vec3(0.225, 0.972, 0.070),
        Vec3(-0.079, 0.981, -0.180),
        Vec3(-0.047, 0.866, 0.498),
        Vec3(-0.071, -0.890, -0.450)
    };
    std::ranges::copy(directions, followed.extended.directions.begin());
    const CurveDistance distance = followed.measured();
    EXPECT_EQ(progressOf(distance.trace).wholeSpans, 0);
    EXPECT_EQ(distance.largest, kInfinity);
    EXPECT_LT(progressOf(distance.trace).crossings.size(), 200U);
}

// The curve stays within a tolerance of the top, where fibres lead down to it all the way.
TEST(FibreTrace, TellsTheSidesOfAPlateApart) {
    constexpr double kThickness = 1e-3;
    std::vector<Vec3> points;
    for (int i = 0; i <= 8; ++i) {
        points.emplace_back(0.1 + 0.1 * i, 0.5, i == 0 || i == 8 ? kThickness : 0.0);
    }
    Followed followed(box(20, {1.0, 1.0, kThickness}), points);
    EXPECT_LT(followed.measured().largest, 1.1 * kThickness);
    followed.pin(0.5);
    ASSERT_LT(followed.problem.picks.back().position.z(), 0.0);
    const CurveDistance distance = followed.measured();
    EXPECT_EQ(distance.largest, kInfinity);
    EXPECT_EQ(distance.perSpan[followed.space.spanAt(0.5)], kInfinity);
    EXPECT_TRUE(std::isfinite(distance.perSpan.front()));
}

}  // namespace
}  // namespace bspline_curve

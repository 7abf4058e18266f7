// SPDX-License-Identifier: GPL-3.0-or-later
// Curves go round the faces to avoid, wherever there is a way, and say so where there is none.
#include "curve_checks.h"
#include "support/many_cases.h"
#include "support/refusal.h"
#include "surface/surface_point.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace bspline_curve {
namespace {

using namespace test_support;

/// The vertices nearest to some points, as picks.
std::vector<Vec3> picksNear(const CurveDesigner& designer, std::vector<Vec3> points) {
    return verticesNear(designer.surface().vertices(), std::move(points));
}

/// Expects that no vertex and no segment of a polyline needs a face of the region.
void expectOutside(const Surface& surface, const Region& region, const SurfacePolyline& line) {
    const std::vector<char> isIn = faceFlags(surface.mesh(), region);
    const std::size_t count = line.surfacePoints.size();
    for (std::size_t i = 0; i < count; ++i) {
        EXPECT_EQ(isIn[line.surfacePoints[i].face], 0) << "vertex " << i;
        if (i + 1 == count && !line.closed) {
            break;
        }
        const std::vector<int> here = facesHolding(surface, line.surfacePoints[i]);
        const std::vector<int> next = facesHolding(surface, line.surfacePoints[(i + 1) % count]);
        EXPECT_TRUE(
            std::ranges::any_of(
                here,
                [&](int f) { return isIn[f] == 0 && std::ranges::find(next, f) != next.end(); }
            )
        ) << "segment "
          << i;
    }
}

/// Expects that a curve that avoids a region is refused with a code, in a message that says `said`.
void expectNoCurve(
    const CurveDesigner& designer,
    const std::vector<Vec3>& picks,
    const Region& avoid,
    InputErrorCode code,
    const std::string& said = "",
    const std::optional<std::vector<std::int64_t>>& elements = std::nullopt,
    const SolverOptions& options = {}
) {
    expectRefused(
        [&] { return designer.design(picks, options, {}, {.avoid = avoid}); }, code, said, elements
    );
}

/// Designs a curve that avoids a region, and expects that it is good, minimised without a stall and
/// outside of the region.
Curve curveRound(
    const CurveDesigner& designer,
    const std::vector<Vec3>& picks,
    const Region& avoid,
    const SolverOptions& options = {}
) {
    Curve curve = goodCurve(designer, picks, options, {.avoid = avoid});
    expectOutside(designer.surface(), avoid, curve.polyline);
    for (const RoundReport& round : curve.report.rounds) {
        EXPECT_EQ(round.status, MinimiseStatus::Converged) << name(round.status);
    }
    return curve;
}

bool hasPoint(const Curve& curve, const Predicate& isIn) {
    return std::ranges::any_of(curve.polyline.points, isIn);
}

class Avoidance : public EitherShell {};

/// A disc in the way of two picks on a plate.
class AvoidedDisc : public EitherShell {
protected:
    CurveDesigner designer_ = designerOn(jitteredPlate(40, 40, 0.2, 3));
    Region disc_ = facesWhere(designer_.surface(), ball({0.5, 0.5, 0}, 0.2));
    std::vector<Vec3> picks_ = {{0.1, 0.48, 0}, {0.9, 0.48, 0}};
};

TEST_P(AvoidedDisc, IsPassedSmoothly) {
    // The shortest way is 0.91 long.
    struct Case {
        SolverOptions options;
        double longest;
    };

    for (const auto& [options, longest] : {
             Case{{.degree = 2}, 1.2},
             Case{{.degree = 3}, 1.2},
             Case{{.degree = 4}, 1.2},
             Case{{.tension = 0.9}, 1.0},
         }) {
        SCOPED_TRACE("degree " + std::to_string(options.degree));
        const Curve curve = curveRound(designer_, picks_, disc_, options);
        EXPECT_LT(length(curve.polyline), longest);
        EXPECT_TRUE(curve.report.detours.empty());
    }
}

TEST_P(Avoidance, ClosedCurvesGoRoundSeveralDiscs) {
    const CurveDesigner designer = designerOn(withNoise(icosphere(4), 0.004, 9));
    const std::vector<Vec3> picks =
        picksNear(designer, {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}});
    const Region discs = facesWhere(designer.surface(), [](const Vec3& p) {
        return ball({0.7, 0.7, 0.05}, 0.3)(p) || ball({-0.7, 0.7, -0.1}, 0.35)(p) ||
               ball({0.7, -0.7, 0}, 0.2)(p);
    });
    curveRound(designer, picks, discs, {.closed = true});
}

TEST_P(Avoidance, CurvesFindTheGapInAWall) {
    // A wall over the whole plate, with a gap of two cells between its halves.
    const CurveDesigner designer = designerOn(plate(30, 30));
    const Region wall = facesWhere(designer.surface(), [](const Vec3& p) {
        return std::abs(p.x() - 0.5) < 0.1 && !(p.y() > 0.7 && p.y() < 0.7667);
    });
    const Curve curve = curveRound(designer, {{0.1, 0.3, 0}, {0.9, 0.2, 0}}, wall);
    EXPECT_TRUE(hasPoint(curve, [](const Vec3& p) { return p.y() > 0.7; }));
    ASSERT_EQ(curve.report.detours.size(), 1U);
    const double ratio = length(curve.polyline) / std::hypot(0.8, 0.1);
    EXPECT_NEAR(curve.report.detours[0].ratio, ratio, 2e-3 * ratio);
}

TEST_P(Avoidance, CurvesPassWhereTheWayIsOneFaceWide) {
    // All faces but those of a bent strip: every edge that the curve crosses has both ends on them.
    const CurveDesigner designer = designerOn(plate(12, 12));
    const Surface& surface = designer.surface();
    const auto isInRow = [](const Vec3& p) {
        return (p.y() > 6.0 / 12.0 && p.y() < 7.0 / 12.0 && p.x() < 7.0 / 12.0) ||
               (p.x() > 6.0 / 12.0 && p.x() < 7.0 / 12.0 && p.y() < 7.0 / 12.0);
    };
    const Region rest = facesWhere(surface, [&](const Vec3& p) { return !isInRow(p); });
    ASSERT_EQ(static_cast<int>(rest.size()), surface.faceCount() - 2 * 13);
    const Curve curve =
        designer.design({{0.03, 0.54, 0}, {0.54, 0.03, 0}}, {}, {}, {.avoid = rest});
    EXPECT_TRUE(curve.report.usable);
    expectStrict(surface, curve.polyline);
    expectOutside(surface, rest, curve.polyline);
}

TEST_P(Avoidance, CurvesTakeTheOtherWayRoundATorus) {
    const CurveDesigner designer = designerOn(torus(60, 24));
    // A band all round the tube, over the short way between the picks.
    const Region band = facesWhere(designer.surface(), [](const Vec3& p) {
        return p.x() > 0.0 && std::abs(p.y()) < 0.1;
    });
    const std::vector<Vec3> picks = picksNear(designer, {{0.9, 0.6, 0.2}, {0.9, -0.6, 0.2}});
    const Curve curve = curveRound(designer, picks, band);
    EXPECT_TRUE(hasPoint(curve, [](const Vec3& p) { return p.x() < -0.5; }));
    // A second band leaves no way.
    const Region both =
        facesWhere(designer.surface(), [](const Vec3& p) { return std::abs(p.y()) < 0.1; });
    expectNoCurve(designer, picks, both, InputErrorCode::NoPath);
}

TEST_P(AvoidedDisc, IsAsFarAsTheCurveSaysAtEverySampling) {
    const Curve curve = curveRound(designer_, picks_, disc_);
    EXPECT_EQ(curve.report.avoidedFaces, static_cast<int>(disc_.size()));
    const Surface& surface = designer_.surface();
    double nearest = 1.0;
    for (const Vec3& p : curve.polyline.points) {
        for (const int f : disc_) {
            for (const int v : surface.faces()[f]) {
                nearest = std::min(nearest, (p - surface.vertices()[v]).norm());
            }
        }
    }
    EXPECT_GT(curve.report.clearance, 0.0);
    EXPECT_LE(curve.report.clearance, nearest);
    EXPECT_GT(curve.report.clearance, nearest - surface.averageEdgeLength());
    const Curve fine = designer_.design(picks_, {}, {5000, 0.0}, {.avoid = disc_});
    expectOutside(surface, disc_, fine.polyline);
    const Curve free = designer_.design(picks_);
    EXPECT_EQ(free.report.avoidedFaces, 0);
    EXPECT_TRUE(std::isinf(free.report.clearance));
}

TEST_P(Avoidance, PicksMayLieNextToWhatIsAvoided) {
    const CurveDesigner designer = designerOn(plate(40, 40));
    const Region half = facesWhere(designer.surface(), [](const Vec3& p) { return p.y() < 0.5; });
    for (const double gap : {0.02, 1e-3, 1e-5}) {
        SCOPED_TRACE("gap " + std::to_string(gap));
        const std::vector<Vec3> picks = {{0.2, 0.5 + gap, 0}, {0.51, 0.5 + gap, 0}, {0.8, 0.6, 0}};
        const Curve curve = goodCurve(designer, picks, {}, {.avoid = half});
        expectOutside(designer.surface(), half, curve.polyline);
        EXPECT_LT(length(curve.polyline), 0.75);
    }
}

TEST_P(Avoidance, ReversedPicksGiveTheCurveReversed) {
    const CurveDesigner designer = designerOn(withNoise(icosphere(4), 0.004, 9));
    const std::vector<Vec3> picks = picksNear(designer, {{1, 0, 0}, {0, 1, 0}, {-1, 0.1, 0.3}});
    const std::vector<Vec3> reversed(picks.rbegin(), picks.rend());
    const Region discs = facesWhere(designer.surface(), [](const Vec3& p) {
        return ball({0.7, 0.7, 0.05}, 0.3)(p) || ball({-0.7, 0.7, -0.1}, 0.35)(p);
    });
    const Curve there = curveRound(designer, picks, discs);
    const Curve back = curveRound(designer, reversed, discs);
    EXPECT_LT(
        largestGap(there.spline, back.spline, true), 0.1 * designer.surface().averageEdgeLength()
    );
}

TEST_P(Avoidance, PicksThatLieInsideAreRefusedByName) {
    const CurveDesigner designer = designerOn(plate(20, 20));
    const Region disc = facesWhere(designer.surface(), ball({0.5, 0.5, 0}, 0.2));
    for (const Vec3& inside :
         {Vec3(0.51, 0.52, 0),
          designer.surface().vertices()[designer.surface().faces()[disc.front()][0]]}) {
        expectNoCurve(
            designer,
            {{0.1, 0.1, 0}, {0.9, 0.1, 0}, inside},
            disc,
            InputErrorCode::PickAvoided,
            "pick 3 lies in face",
            {{2}}
        );
    }
}

TEST_P(Avoidance, PicksBehindARingAreRefusedByName) {
    const CurveDesigner designer = designerOn(plate(40, 40));
    const Region ring = facesWhere(designer.surface(), [](const Vec3& p) {
        const double radius = (p - Vec3(0.5, 0.5, 0)).norm();
        return radius > 0.2 && radius < 0.3;
    });
    expectNoCurve(
        designer,
        {{0.1, 0.1, 0}, {0.9, 0.1, 0}, {0.5, 0.5, 0}},
        ring,
        InputErrorCode::NoPath,
        "from pick 2 to pick 3",
        {{1, 2}}
    );
    // Numbered as they were given, also where some are at the same point.
    expectNoCurve(
        designer,
        {{0.1, 0.1, 0}, {0.1, 0.1, 0}, {0.9, 0.1, 0}, {0.9, 0.1, 0}, {0.5, 0.5, 0}},
        ring,
        InputErrorCode::NoPath,
        "from pick 3 to pick 5",
        {{2, 4}}
    );
}

TEST_P(Avoidance, FacesThatTouchInAVertexLeaveNoWay) {
    // The free faces on both sides of the wall share one vertex only.
    const CurveDesigner designer = designerOn(plate(2, 2));
    const Region others = facesWhere(designer.surface(), [](const Vec3& p) {
        return (p.x() < 0.5) != (p.y() < 0.5);
    });
    expectNoCurve(designer, {{0.2, 0.25, 0}, {0.8, 0.7, 0}}, others, InputErrorCode::NoPath);
}

TEST_P(Avoidance, SettingsThatCannotKeepThePromiseAreRefused) {
    const CurveDesigner designer = designerOn(plate(10, 10));
    const std::vector<Vec3> picks = {{0.1, 0.1, 0}, {0.9, 0.1, 0}};
    for (const SolverOptions& options :
         {SolverOptions{.quadrature = Quadrature::Samples},
          SolverOptions{.initialCurve = InitialCurve::ControlPolygon},
          SolverOptions{.interpolation = Interpolation::Penalty},
          SolverOptions{.avoidMargin = 0.0}}) {
        expectNoCurve(designer, picks, {150}, InputErrorCode::BadOption, "", {}, options);
    }
    expectNoCurve(
        designer, picks, {150, 200, -3}, InputErrorCode::IndexOutOfRange, "", {{-3, 200}}
    );
}

// ---- Random layouts ----

struct Layout {
    Region avoid;
    std::vector<Vec3> picks;
    bool isPossible = true;
};

/// Components of the faces outside of a region: -1 inside.
std::vector<int> componentsOutside(const Surface& surface, const Region& region) {
    const std::vector<char> isIn = faceFlags(surface.mesh(), region);
    std::vector<int> component(surface.faceCount(), -1);
    for (int seed = 0, next = 0; seed < surface.faceCount(); ++seed) {
        if (isIn[seed] != 0 || component[seed] >= 0) {
            continue;
        }
        std::vector<int> stack{seed};
        component[seed] = next;
        while (!stack.empty()) {
            const int f = stack.back();
            stack.pop_back();
            for (const int there : surface.faceNeighbours()[f]) {
                if (there >= 0 && isIn[there] == 0 && component[there] < 0) {
                    component[there] = next;
                    stack.push_back(there);
                }
            }
        }
        ++next;
    }
    return component;
}

/// Discs and slabs of random size and place, and picks that mostly lie outside of them.
Layout randomLayout(const Surface& surface, std::uint64_t seed) {
    Random random(seed);
    const double size = surface.diagonal();
    const auto anyPoint = [&] {
        return SurfacePoint{random.integer(0, surface.faceCount() - 1), random.barycentric()};
    };
    std::vector<Predicate> obstacles;
    for (int count = random.integer(1, 6); count > 0; --count) {
        const Vec3 centre = surface.position(anyPoint());
        if (random.integer(0, 2) > 0) {
            obstacles.push_back(ball(centre, size * random.uniform(0.02, 0.2)));
            continue;
        }
        const Vec3 normal = random.point(-1.0, 1.0).normalized();
        const double half = size * random.uniform(0.005, 0.03);
        const double reach = size * random.uniform(0.1, 0.5);
        obstacles.push_back([=](const Vec3& p) {
            return std::abs(normal.dot(p - centre)) < half && (p - centre).norm() < reach;
        });
    }
    Layout layout;
    layout.avoid = facesWhere(surface, [&](const Vec3& p) {
        return std::ranges::any_of(obstacles, [&](const Predicate& isIn) { return isIn(p); });
    });
    const std::vector<int> component = componentsOutside(surface, layout.avoid);
    const bool anywhere = random.integer(0, 9) == 0;
    int first = -1;
    for (int count = random.integer(3, 5); count > 0; --count) {
        SurfacePoint pick = anyPoint();
        for (int tries = 0; tries < 1000 && !anywhere && component[pick.face] < 0; ++tries) {
            pick = anyPoint();
        }
        first = layout.picks.empty() ? component[pick.face] : first;
        layout.isPossible &= first >= 0 && component[pick.face] == first;
        layout.picks.push_back(surface.position(pick));
    }
    return layout;
}

TEST_P(Avoidance, RandomLayoutsAreDrawnOutsideOrRefused) {
    int drawn = 0;
    int refused = 0;
    for (const TriangleMesh& mesh :
         {withNoise(icosphere(3), 0.01, 7), torus(48, 20), jitteredPlate(30, 30, 0.2, 5)}) {
        const CurveDesigner designer = designerOn(mesh);
        for (std::uint64_t seed = 1; seed <= std::uint64_t{caseCount(20, 10)}; ++seed) {
            SCOPED_TRACE(
                std::to_string(mesh.faces.size()) + " faces, seed " + std::to_string(seed)
            );
            const Layout layout = randomLayout(designer.surface(), seed);
            const SolverOptions options{
                .degree = 2 + static_cast<int>(seed % 3), .closed = seed % 3 == 0
            };
            try {
                const Curve curve =
                    designer.design(layout.picks, options, {}, {.avoid = layout.avoid});
                EXPECT_TRUE(layout.isPossible);
                expectStrict(designer.surface(), curve.polyline);
                expectOutside(designer.surface(), layout.avoid, curve.polyline);
                ++drawn;
            } catch (const InputError& error) {
                EXPECT_FALSE(layout.isPossible) << error.what();
                EXPECT_TRUE(
                    error.code() == InputErrorCode::NoPath ||
                    error.code() == InputErrorCode::PickAvoided
                ) << error.what();
                ++refused;
            }
        }
    }
    EXPECT_GT(drawn, 0);
    EXPECT_GT(refused, 0);
}

INSTANTIATE_TEST_SUITE_P(Shells, Avoidance, kEitherShell, nameOfShell);
INSTANTIATE_TEST_SUITE_P(Shells, AvoidedDisc, kEitherShell, nameOfShell);

TEST(AvoidanceFarAway, ChangesNothing) {
    const CurveDesigner designer(withNoise(icosphere(4), 0.004, 9));
    const std::vector<Vec3> picks = picksNear(designer, {{1, 0, 0}, {0, 1, 0}, {-1, 0.1, 0.3}});
    const Region far = facesWhere(designer.surface(), ball({0, 0, -1}, 0.3));
    const Curve with = designer.design(picks, {}, {}, {.avoid = far});
    const Curve without = designer.design(picks);
    EXPECT_EQ(largestGap(with.spline, without.spline), 0.0);
}

}  // namespace
}  // namespace bspline_curve

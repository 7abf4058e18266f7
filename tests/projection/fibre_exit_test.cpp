// SPDX-License-Identifier: GPL-3.0-or-later
// Where curves leave the fibres of a face, against many places on the way.
#include "projection/fibre_exit.h"

#include "support/meshes.h"
#include "support/random.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

namespace bspline_curve {
namespace {

using namespace test_support;

constexpr int kFace = 0;
constexpr int kCurves = 3000;
constexpr int kPlaces = 400;
// Nearer to a wall than this is on it.
constexpr double kRounding = 1e-10;

// A curve from a place over a face, with the walls that it starts on.
class ExitCase {
public:
    // Coefficients by tau of the barycentric coordinates u and v, if the fibres were parallel, and
    // of the height in lengths of an edge.
    using Coordinates = std::array<Vec3, 4>;

    ExitCase(const ExtendedSurface& extended, const Coordinates& coordinates)
        : fibres_(extended, kFace) {
        const Vec3 corner = extended.vertices[extended.faces[kFace][0]];
        const Vec3 normal =
            fibres_.edgeU().norm() * fibres_.edgeU().cross(fibres_.edgeV()).normalized();
        curve_.degree = 3;
        for (std::size_t j = 0; j < coordinates.size(); ++j) {
            const auto& [u, v, height] =
                std::array{coordinates[j].x(), coordinates[j].y(), coordinates[j].z()};
            curve_.coefficients[j] = u * fibres_.edgeU() + v * fibres_.edgeV() + height * normal +
                                     (j == 0 ? corner : Vec3::Zero());
        }
        here_ = placeAt(0.0);
    }

    [[nodiscard]] FibrePlace placeAt(double tau) const {
        FibrePlace place;
        place.position = curve_.at(tau);
        place.along = curve_.derivativeAt(tau);
        place.foot = {kFace, 1.0 / 3.0, 1.0 / 3.0, 0.0};
        EXPECT_EQ(
            fibres_.find<FaceFibres::Search::Exact>(place.position, place.foot, place.frame),
            FaceFibres::Outcome::Found
        );
        return place;
    }

    [[nodiscard]] double leastCoordinateAt(double tau) const {
        return placeAt(tau).foot.barycentric().minCoeff();
    }

    // That the exit is one, and that there is none before.
    void expectFirstExit() const {
        FibrePlace there;
        const std::optional<FibreExit> exit = findExit(fibres_, curve_, 0.0, here_, there);
        ASSERT_TRUE(exit.has_value());
        const FibrePlace found = placeAt(exit->tau);
        EXPECT_LT((there.position - found.position).norm(), 1e-12);
        EXPECT_LT((there.along - found.along).norm(), 1e-12);
        EXPECT_LT((there.foot.barycentric() - found.foot.barycentric()).norm(), kRounding);
        EXPECT_NEAR(there.foot.height, found.foot.height, kRounding);
        EXPECT_LT((there.frame.u - found.frame.u).norm(), 1e-6 * found.frame.u.norm());
        for (int i = 0; i <= kPlaces; ++i) {
            ASSERT_GT(leastCoordinateAt(exit->tau * i / kPlaces), -kRounding) << "before";
        }
        if (exit->wall < 0) {
            EXPECT_EQ(exit->tau, 1.0);
            return;
        }
        EXPECT_NEAR(there.foot.barycentric()[exit->wall], 0.0, kRounding);
        const Vec3 slopes(
            -(found.frame.u + found.frame.v).dot(found.along),
            found.frame.u.dot(found.along),
            found.frame.v.dot(found.along)
        );
        EXPECT_LT(slopes[exit->wall], 1e-6);
    }

private:
    FaceFibres fibres_;
    PolynomialCurve curve_;
    FibrePlace here_;
};

// From inside the face, or from one of its walls inwards; `bend`: of the higher coefficients.
ExitCase::Coordinates randomCurve(Random& random, double speed, double bend) {
    ExitCase::Coordinates c;
    double u = random.uniform(0.0, 1.0);
    double v = random.uniform(0.0, 1.0);
    if (u + v > 1.0) {
        u = 1.0 - u;
        v = 1.0 - v;
    }
    c[0] = {0.02 + 0.94 * u, 0.02 + 0.94 * v, 0.05 * random.uniform(-1.0, 1.0)};
    for (std::size_t j = 1; j < c.size(); ++j) {
        c[j] = (j == 1 ? speed : bend) * random.point(-1.0, 1.0);
        c[j].z() *= 0.02;
    }
    if (random.uniform(0.0, 1.0) < 0.5) {
        c[0].x() = 0.0;
        c[0].z() =
            0.0;  // on the surface, so that it is there for fibres that are not parallel, too
        c[1].x() = std::abs(c[1].x());
    }
    return c;
}

// Coordinates are cubics there.
TEST(FibreExit, IsTheFirstOneOfCurvesThatTurnOverAPlate) {
    const Surface surface(plate(1, 1));
    const ExtendedSurface extended = extendSurface(surface, 3);
    Random random(7);
    for (int i = 0; i < kCurves; ++i) {
        SCOPED_TRACE("curve " + std::to_string(i));
        const double bend = random.uniform(0.0, 4.0);
        ExitCase(extended, randomCurve(random, 2.0, bend)).expectFirstExit();
    }
}

TEST(FibreExit, IsTheFirstOneOfNearlyStraightCurvesOverASphere) {
    const Surface surface(withNoise(icosphere(2), 0.02, 3));
    const ExtendedSurface extended = extendSurface(surface, 3);
    Random random(8);
    for (int i = 0; i < kCurves; ++i) {
        SCOPED_TRACE("curve " + std::to_string(i));
        ExitCase(extended, randomCurve(random, 2.0, 0.1)).expectFirstExit();
    }
}

// Through a wall and back, before it meets the one that its tangent leads to.
TEST(FibreExit, IsBeforeWhereTheTangentLeads) {
    const Surface surface(plate(1, 1));
    const ExtendedSurface extended = extendSurface(surface, 3);
    ExitCase(
        extended,
        {Vec3(0.2, 0.02, 0.0), Vec3(1.2, 0.0, 0.0), Vec3(0.0, -0.8, 0.0), Vec3(0.0, 1.3, 0.0)}
    )
        .expectFirstExit();
}

// Along walls and into vertices: both walls of a vertex are passed at once.
TEST(FibreExit, IsAtAVertexWhereTheCurveLeadsThere) {
    const Surface surface(plate(1, 1));
    const ExtendedSurface extended = extendSurface(surface, 3);
    for (const std::pair<double, double>& start :
         {std::pair(0.2, 0.2), std::pair(0.0, 0.5), std::pair(0.5, 0.0), std::pair(0.5, 0.5)}) {
        const auto [u, v] = start;
        ExitCase(
            extended, {Vec3(u, v, 0.0), Vec3(-2.0 * u, -2.0 * v, 0.0), Vec3::Zero(), Vec3::Zero()}
        )
            .expectFirstExit();
        ExitCase(
            extended,
            {Vec3(u, v, 0.0), Vec3(2.0 - 2.0 * u, -2.0 * v, 0.0), Vec3::Zero(), Vec3::Zero()}
        )
            .expectFirstExit();
    }
}

}  // namespace
}  // namespace bspline_curve

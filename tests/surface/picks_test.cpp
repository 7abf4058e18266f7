// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/picks.h"

#include "bspline_curve/error.h"
#include "support/meshes.h"
#include "support/random.h"
#include "support/refusal.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace bspline_curve {
namespace {

using namespace test_support;
using enum InputErrorCode;
using Elements = std::vector<std::int64_t>;

/// Picks on a plate of 3 x 4, whose diagonal is 5, or on another mesh.
struct PicksTest : public ::testing::Test {
    explicit PicksTest(TriangleMesh mesh = plate(6, 8, 3.0, 4.0))
        : surface(std::move(mesh)), tree(surface.vertices(), surface.faces()) {}

    [[nodiscard]] std::vector<SurfacePoint> locate(
        const std::vector<Vec3>& picks, bool closed = false
    ) const {
        return locatePicks(surface, tree, picks, closed).points;
    }

    void expectRefused(
        const std::vector<Vec3>& picks,
        bool closed,
        InputErrorCode code,
        const Elements& elements,
        const std::vector<std::string>& said = {""}
    ) const {
        for (const std::string& text : said) {
            const auto call = [&] { return locate(picks, closed); };
            test_support::expectRefused(call, code, text, elements);
        }
    }

    Surface surface;
    TriangleTree tree;
};

struct PicksOnTwoComponentsTest : public PicksTest {
    PicksOnTwoComponentsTest() : PicksTest(twoComponents()) {}
};

TEST_F(PicksTest, AreProjectedToTheSurfaceInOrder) {
    const std::vector<Vec3> picks = {{0.3, 0.4, 0.01}, {2.2, 3.1, -0.02}, {1.0, 1.0, 0.0}};
    const std::vector<SurfacePoint> points = locate(picks);
    ASSERT_EQ(points.size(), picks.size());
    for (std::size_t i = 0; i < picks.size(); ++i) {
        const Vec3 expected(picks[i][0], picks[i][1], 0.0);
        EXPECT_LT((surface.position(points[i]) - expected).norm(), 1e-14);
    }
}

TEST(Picks, ThatWereLocatedAreLocatedInTheSamePlaceBitForBit) {
    const Surface surface(icosphere(3));
    const TriangleTree tree(surface.vertices(), surface.faces());
    Random random(5);
    std::vector<Vec3> picks;
    for (int i = 0; i < 500; ++i) {
        picks.push_back(random.point(-1.0, 1.0).normalized());
    }
    const std::vector<SurfacePoint> first = locatePicks(surface, tree, picks, false).points;
    for (std::size_t i = 0; i < picks.size(); ++i) {
        picks[i] = surface.position(first[i]);
    }
    const std::vector<SurfacePoint> second = locatePicks(surface, tree, picks, false).points;
    ASSERT_EQ(second.size(), first.size());
    for (std::size_t i = 0; i < first.size(); ++i) {
        EXPECT_EQ(second[i].face, first[i].face);
        EXPECT_EQ(second[i].barycentric, first[i].barycentric);
    }
}

TEST_F(PicksTest, MustBeTwoOrThreeWhenClosed) {
    expectRefused({}, false, TooFewPicks, {});
    expectRefused({{1, 1, 0}}, false, TooFewPicks, {});
    expectRefused({{1, 1, 0}, {2, 2, 0}}, true, TooFewPicks, {});
    EXPECT_EQ(locate({{1, 1, 0}, {2, 2, 0}}).size(), 2U);
    EXPECT_EQ(locate({{1, 1, 0}, {2, 2, 0}, {1, 2, 0}}, true).size(), 3U);
}

TEST_F(PicksTest, MustBeFinite) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    expectRefused({{1, 1, 0}, {2, nan, 0}, {1, 2, 0}}, false, NonFiniteCoordinate, {1});
}

TEST_F(PicksTest, MustLieWithinOnePercentOfTheDiagonal) {
    EXPECT_EQ(locate({{1, 1, 0.0499}, {2, 2, 0}}).size(), 2U);
    expectRefused(
        {{1, 1, 0}, {2, 2, 0.25}, {1, 2, 0}, {1, 3, -1}},
        false,
        PickTooFar,
        {1, 3},
        {"pick 2 lies 0.25 from the surface, more than 1 % of the diagonal (0.05)",
         "all that are concerned: picks 2, 4"}
    );
}

TEST_F(PicksTest, ThatFollowEachOtherAtOnePointAreOne) {
    const std::vector<Vec3> picks = {{1, 1, 0}, {2, 2, 0.01}, {2, 2, -0.01}, {2, 2, 0}, {1, 2, 0}};
    const LocatedPicks located = locatePicks(surface, tree, picks, false);
    EXPECT_EQ(located.points.size(), 3U);
    EXPECT_EQ(located.pointOf, (std::vector{0, 1, 1, 1, 2}));
    EXPECT_EQ(located.repeated(), (std::vector{2, 3}));
    EXPECT_EQ(located.firstPicks(), (std::vector{0, 1, 4}));
}

TEST_F(PicksTest, AtTheEndOfAClosedCurveAreOneWithTheFirst) {
    const std::vector<Vec3> picks = {{1, 1, 0}, {2, 2, 0}, {1, 2, 0}, {1, 1, 0}, {1, 1, 0}};
    const LocatedPicks located = locatePicks(surface, tree, picks, true);
    EXPECT_EQ(located.points.size(), 3U);
    EXPECT_EQ(located.pointOf, (std::vector{0, 1, 2, 0, 0}));
    EXPECT_EQ(located.repeated(), (std::vector{3, 4}));
    EXPECT_EQ(located.firstPicks(), (std::vector{0, 1, 2}));
    // An open curve comes back.
    EXPECT_EQ(locatePicks(surface, tree, picks, false).pointOf, (std::vector{0, 1, 2, 3, 3}));
}

TEST_F(PicksTest, MustLeaveEnoughDifferentPoints) {
    expectRefused(
        {{1, 1, 0}, {1, 1, 0.01}}, false, CoincidentPicks, {0, 1}, {"leaves 1 point of the surface"}
    );
    expectRefused(
        {{1, 1, 0}, {2, 2, 0}, {2, 2, 0}, {1, 1, 0}},
        true,
        CoincidentPicks,
        {1, 2, 3},
        {"leaves 2 points of the surface, but a closed curve needs 3"}
    );
}

TEST(Picks, ChooseTheComponentThatTheyShareWhereSeveralLieUponEachOther) {
    // The second plate covers the upper half of the first, and goes on.
    TriangleMesh upper = plate(6, 8, 3.0, 4.0);
    for (Vec3& vertex : upper.vertices) {
        vertex += Vec3(0.0, 2.0, 1e-7);
    }
    const Surface surface(joined(plate(6, 8, 3.0, 4.0), upper));
    const TriangleTree tree(surface.vertices(), surface.faces());
    const auto componentsOf = [&](const std::vector<Vec3>& picks) {
        std::vector<int> components;
        for (const SurfacePoint& point : locatePicks(surface, tree, picks, false).points) {
            components.push_back(surface.faceComponents()[point.face]);
        }
        return components;
    };
    const Vec3 onBoth(1, 3, 0);
    const Vec3 onFirst(1, 1, 0);
    const Vec3 onSecond(1, 5, 0);
    EXPECT_EQ(componentsOf({onBoth, onFirst}), (std::vector{0, 0}));
    EXPECT_EQ(componentsOf({onBoth, onSecond}), (std::vector{1, 1}));
    EXPECT_EQ(componentsOf({onSecond, onBoth, onSecond}), (std::vector{1, 1, 1}));
    expectRefused(
        [&] { return locatePicks(surface, tree, {onBoth, onFirst, onSecond}, false); },
        PicksOnDifferentComponents,
        "pick 3 lies on another",
        Elements{2}
    );
}

TEST_F(PicksOnTwoComponentsTest, MustLieOnOneComponent) {
    EXPECT_EQ(locate({{1, 0, 0}, {0, 1, 0}}).size(), 2U);
    EXPECT_EQ(locate({{5, 0, 0}, {4, 1, 0}}).size(), 2U);
    expectRefused(
        {{1, 0, 0}, {5, 0, 0}, {0, 1, 0}, {3, 0, 0}},
        false,
        PicksOnDifferentComponents,
        {1, 3},
        {"pick 2 lies on another connected component of the surface than pick 1"}
    );
}

}  // namespace
}  // namespace bspline_curve

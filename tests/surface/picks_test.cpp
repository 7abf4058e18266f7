// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/picks.h"

#include "bspline_curve/error.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace bspline_curve {
namespace {

using namespace test_support;
using Elements = std::vector<std::int64_t>;

/// Picks on a plate of 3 x 4, whose diagonal is 5, or on another mesh.
struct PicksTest : public ::testing::Test {
    explicit PicksTest(TriangleMesh mesh = plate(6, 8, 3.0, 4.0))
        : surface(std::move(mesh)), tree(surface.vertices(), surface.faces()) {}

    [[nodiscard]] std::vector<SurfacePoint> locate(
        const std::vector<Vec3>& picks, bool closed = false
    ) const {
        return locatePicks(surface, tree, picks, closed);
    }

    [[nodiscard]] InputError refusal(const std::vector<Vec3>& picks, bool closed = false) const {
        try {
            static_cast<void>(locate(picks, closed));
        } catch (const InputError& error) {
            return error;
        }
        ADD_FAILURE() << "the picks were accepted";
        return {InputErrorCode::UnreadableFile, ""};
    }

    Surface surface;
    TriangleTree tree;
};

struct PicksOnTwoComponentsTest : public PicksTest {
    PicksOnTwoComponentsTest() : PicksTest(twoComponents()) {}
};

void expectMentions(const InputError& error, const std::string& text) {
    EXPECT_NE(std::string(error.what()).find(text), std::string::npos)
        << '"' << error.what() << "\" does not mention \"" << text << '"';
}

TEST_F(PicksTest, AreProjectedToTheSurfaceInOrder) {
    const std::vector<Vec3> picks = {{0.3, 0.4, 0.01}, {2.2, 3.1, -0.02}, {1.0, 1.0, 0.0}};
    const std::vector<SurfacePoint> points = locate(picks);
    ASSERT_EQ(points.size(), picks.size());
    for (std::size_t i = 0; i < picks.size(); ++i) {
        const Vec3 expected(picks[i][0], picks[i][1], 0.0);
        EXPECT_LT((surface.position(points[i]) - expected).norm(), 1e-14);
    }
}

TEST_F(PicksTest, MustBeTwoOrThreeWhenClosed) {
    EXPECT_EQ(refusal({}).code(), InputErrorCode::TooFewPicks);
    EXPECT_EQ(refusal({{1, 1, 0}}).code(), InputErrorCode::TooFewPicks);
    EXPECT_EQ(refusal({{1, 1, 0}, {2, 2, 0}}, true).code(), InputErrorCode::TooFewPicks);
    EXPECT_EQ(locate({{1, 1, 0}, {2, 2, 0}}).size(), 2U);
    EXPECT_EQ(locate({{1, 1, 0}, {2, 2, 0}, {1, 2, 0}}, true).size(), 3U);
}

TEST_F(PicksTest, MustBeFinite) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const InputError error = refusal({{1, 1, 0}, {2, nan, 0}, {1, 2, 0}});
    EXPECT_EQ(error.code(), InputErrorCode::NonFiniteCoordinate);
    EXPECT_EQ(error.elements(), (Elements{1}));
}

TEST_F(PicksTest, MustLieWithinOnePercentOfTheDiagonal) {
    EXPECT_EQ(locate({{1, 1, 0.0499}, {2, 2, 0}}).size(), 2U);
    const InputError error = refusal({{1, 1, 0}, {2, 2, 0.25}, {1, 2, 0}, {1, 3, -1}});
    EXPECT_EQ(error.code(), InputErrorCode::PickTooFar);
    EXPECT_EQ(error.elements(), (Elements{1, 3}));
    expectMentions(error, "pick 1 lies 0.25 from the surface");
    expectMentions(error, "more than 1 % of the diagonal (0.05)");
    expectMentions(error, "all picks concerned: 1, 3");
}

TEST_F(PicksTest, ThatFollowEachOtherMustNotCoincideOnTheSurface) {
    const InputError error = refusal({{1, 1, 0}, {2, 2, 0.01}, {2, 2, -0.01}});
    EXPECT_EQ(error.code(), InputErrorCode::CoincidentPicks);
    EXPECT_EQ(error.elements(), (Elements{1, 2}));
    expectMentions(error, "pick 1 and pick 2");
}

TEST_F(PicksTest, MayComeBackToAnEarlierPickUnlessTheCurveClosesThere) {
    const std::vector<Vec3> picks = {{1, 1, 0}, {2, 2, 0}, {1, 2, 0}, {1, 1, 0}};
    EXPECT_EQ(locate(picks).size(), 4U);
    const InputError error = refusal(picks, true);
    EXPECT_EQ(error.code(), InputErrorCode::CoincidentPicks);
    EXPECT_EQ(error.elements(), (Elements{0, 3}));
}

TEST_F(PicksOnTwoComponentsTest, MustLieOnOneComponent) {
    EXPECT_EQ(locate({{1, 0, 0}, {0, 1, 0}}).size(), 2U);
    EXPECT_EQ(locate({{5, 0, 0}, {4, 1, 0}}).size(), 2U);
    const InputError error = refusal({{1, 0, 0}, {5, 0, 0}, {0, 1, 0}, {3, 0, 0}});
    EXPECT_EQ(error.code(), InputErrorCode::PicksOnDifferentComponents);
    EXPECT_EQ(error.elements(), (Elements{1, 3}));
    expectMentions(error, "pick 1 lies on another connected component of the surface than pick 0");
}

}  // namespace
}  // namespace bspline_curve

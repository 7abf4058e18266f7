// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/error.h"
#include "bspline_curve/mesh.h"
#include "support/meshes.h"
#include "support/refusal.h"

#include <gtest/gtest.h>

#include <limits>

namespace bspline_curve {
namespace {

using namespace test_support;
using Ids = std::vector<std::int64_t>;

/// A plate of 4 x 4 cells over [0, 1]^2: 32 faces, 25 vertices.
struct RegionTest : public ::testing::Test {
    Surface surface{plate(4, 4)};

    [[nodiscard]] std::vector<double> xOfVertices() const {
        std::vector<double> field;
        for (const Vec3& vertex : surface.vertices()) {
            field.push_back(vertex.x());
        }
        return field;
    }

    [[nodiscard]] double meanX(int face) const {
        const Triangle& corners = surface.faces()[face];
        double sum = 0.0;
        for (const int v : corners) {
            sum += surface.vertices()[v].x();
        }
        return sum / 3.0;
    }
};

TEST_F(RegionTest, IsSortedWithoutRepetitions) {
    EXPECT_EQ(makeRegion(surface.mesh(), Ids{7, 31, 0, 7, 3}), (Region{0, 3, 7, 31}));
    EXPECT_TRUE(makeRegion(surface.mesh(), Ids{}).empty());
}

TEST_F(RegionTest, NamesTheIdsThatAreNoFaces) {
    const auto make = [&] { return makeRegion(surface.mesh(), Ids{3, 32, -1, 32}); };
    expectRefused(make, InputErrorCode::IndexOutOfRange, "from 0 to 31", Ids{-1, 32});
}

TEST_F(RegionTest, OfVerticesHoldsTheFacesAllOfWhoseCornersAreSelected) {
    std::vector<char> selected(25, 0);
    for (const std::size_t v : {0U, 1U, 5U, 6U, 12U}) {  // the corners of cell (0, 0), and one more
        selected[v] = 1;
    }
    EXPECT_EQ(facesOfVertices(surface.mesh(), selected).size(), 2U);
    selected.pop_back();
    const auto make = [&] { return facesOfVertices(surface.mesh(), selected); };
    expectRefused(make, InputErrorCode::IndexOutOfRange);
}

TEST_F(RegionTest, OfAThresholdTakesTheMeanOverTheCorners) {
    const std::vector<double> field = xOfVertices();
    const Region under = facesUnder(surface.mesh(), field, 0.4);
    const Region over = facesOver(surface.mesh(), field, 0.4);
    EXPECT_EQ(under.size() + over.size(), 32U);  // no mean is 0.4
    for (const int f : under) {
        EXPECT_LT(meanX(f), 0.4);
    }
    for (const int f : over) {
        EXPECT_GT(meanX(f), 0.4);
    }
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(facesUnder(surface.mesh(), field, infinity).size(), 32U);
    EXPECT_TRUE(facesOver(surface.mesh(), field, infinity).empty());
    EXPECT_TRUE(facesUnder(surface.mesh(), std::vector<double>(25, 0.5), 0.5).empty());
}

TEST_F(RegionTest, OfAThresholdRefusesOtherFieldsAndNoNumber) {
    const auto under = [&] { return facesUnder(surface.mesh(), std::vector<double>(24), 0.0); };
    expectRefused(under, InputErrorCode::BadField);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto over = [&] { return facesOver(surface.mesh(), xOfVertices(), nan); };
    expectRefused(over, InputErrorCode::BadOption);
}

TEST_F(RegionTest, HasAFlagPerFace) {
    const std::vector<char> flags = faceFlags(surface.mesh(), {2, 30});
    ASSERT_EQ(flags.size(), 32U);
    for (std::size_t f = 0; f < flags.size(); ++f) {
        EXPECT_EQ(flags[f] != 0, f == 2 || f == 30) << f;
    }
}

}  // namespace
}  // namespace bspline_curve

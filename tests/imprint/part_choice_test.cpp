// SPDX-License-Identifier: GPL-3.0-or-later
#include "imprint/part_choice.h"

#include "imprint/random_curves.h"
#include "support/many_cases.h"
#include "support/meshes.h"
#include "support/refusal.h"
#include "support/seeds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace bspline_curve {

namespace {

using namespace test_support;

/// A plate of 8 x 8 cells with two squares of 2 x 2 and 1 x 1 cells.
class TwoSquares : public testing::Test {
protected:
    static constexpr int kCells = 8;

    [[nodiscard]] std::vector<int> chosen(const PartChoice& choice) const {
        return chosenParts(imprinted_, parts_, choice);
    }

    [[nodiscard]] std::vector<int> at(double x, double y) const {
        return chosen({.which = PartChoice::Which::Seeds, .seeds = {Vec3(x, y, 0.0)}});
    }

    Surface surface_{plate(kCells, kCells)};
    ImprintedMesh imprinted_ = imprint(
        surface_,
        std::vector{
            alongGrid(
                surface_,
                kCells,
                {{1, 1}, {2, 1}, {3, 1}, {3, 2}, {3, 3}, {2, 3}, {1, 3}, {1, 2}},
                true
            ),
            alongGrid(surface_, kCells, {{5, 5}, {6, 5}, {6, 6}, {5, 6}}, true),
        },
        {}
    );
    MeshParts parts_ = partsOf(imprinted_);
};

TEST_F(TwoSquares, AreChosenBySizeSideAndSeed) {
    ASSERT_EQ(parts_.parts.size(), 3U);
    EXPECT_EQ(chosen({.which = PartChoice::Which::Largest}), std::vector{0});
    EXPECT_EQ(chosen({.which = PartChoice::Which::Smallest}), std::vector{2});
    EXPECT_EQ(chosen({.which = PartChoice::Which::Inside}), (std::vector{1, 2}));
    EXPECT_EQ(at(0.3, 0.2), std::vector{1});
    EXPECT_EQ(at(0.7, 0.7), std::vector{2});
    EXPECT_EQ(at(0.9, 0.1), std::vector{0});
    EXPECT_EQ(at(0.25, 0.25), std::vector{1});  // a vertex inside
}

TEST_F(TwoSquares, AreChosenBySeveralSeeds) {
    PartChoice choice{
        .which = PartChoice::Which::Seeds, .seeds = {Vec3(0.7, 0.7, 0), Vec3(0.3, 0.2, 0)}
    };
    EXPECT_EQ(chosen(choice), (std::vector{1, 2}));
    choice.seeds.emplace_back(0.2, 0.3, 0);  // in one of them again
    EXPECT_EQ(chosen(choice), (std::vector{1, 2}));
    EXPECT_EQ(chosen({.which = PartChoice::Which::Outside}), std::vector{0});
    choice.seeds.clear();
    expectRefused([&] { return chosen(choice); }, InputErrorCode::NoPath, "no part is meant");
}

TEST_F(TwoSquares, RefuseSeedsOnCurvesAndFarAway) {
    expectRefused([&] { return at(0.2, 0.125); }, InputErrorCode::NoPath, "lies on a curve");
    expectRefused([&] { return at(0.125, 0.125); }, InputErrorCode::NoPath, "lies on a curve");
    const PartChoice above{.which = PartChoice::Which::Seeds, .seeds = {Vec3(0.2, 0.2, 1.0)}};
    expectRefused([&] { return chosen(above); }, InputErrorCode::PickTooFar, "is 1 away");
}

TEST_F(TwoSquares, CutTheirRimsAloneWhereTheyAreChosen) {
    EXPECT_EQ(edgesAround(imprinted_, parts_, {1}).size(), 8U);
    EXPECT_EQ(edgesAround(imprinted_, parts_, {0}).size(), 12U);
    const CutMesh cut = cutAlongEdges(imprinted_.mesh, edgesAround(imprinted_, parts_, {2}));
    EXPECT_EQ(cut.mesh.vertices.size(), imprinted_.mesh.vertices.size() + 4);
    const SubMesh small = facesWithLabels(cut.mesh, parts_.labels, {2});
    EXPECT_EQ(small.mesh.vertices.size(), 4U);
    EXPECT_EQ(small.mesh.faces.size(), 2U);
    EXPECT_NEAR(Surface(small.mesh).area(), 1.0 / 64, 1e-15);
}

TEST(PartChoice, TheHoleOfALetterIsOutside) {
    const Surface surface(plate(8, 8));
    const auto square = [&](int low, int high) {
        std::vector<std::array<int, 2>> round;
        for (int i = low; i < high; ++i) {
            round.push_back({i, low});
        }
        for (int i = low; i < high; ++i) {
            round.push_back({high, i});
        }
        for (int i = high; i > low; --i) {
            round.push_back({i, high});
        }
        for (int i = high; i > low; --i) {
            round.push_back({low, i});
        }
        return alongGrid(surface, 8, round, true);
    };
    const ImprintedMesh imprinted =
        imprint(surface, std::vector{square(1, 7), square(2, 6), square(3, 5)}, {});
    const MeshParts parts = partsOf(imprinted);
    ASSERT_EQ(parts.parts.size(), 4U);
    // From outside: 28, 20, 12 and 4 cells.
    EXPECT_EQ(
        chosenParts(imprinted, parts, {.which = PartChoice::Which::Inside}), (std::vector{1, 3})
    );
    EXPECT_EQ(
        chosenParts(imprinted, parts, {.which = PartChoice::Which::Outside}), (std::vector{0, 2})
    );
    // A curve that is there twice leaves what is inside of it outside.
    const ImprintedMesh twice =
        imprint(surface, std::vector{square(2, 6), square(2, 6), square(3, 5)}, {});
    EXPECT_EQ(
        chosenParts(twice, partsOf(twice), {.which = PartChoice::Which::Inside}), std::vector{2}
    );
}

TEST(PartChoice, LeavesOtherComponentsAlone) {
    const Surface surface(joined(
        plate(4, 4), transformed(plate(4, 4), Eigen::Isometry3d(Eigen::Translation3d(9, 0, 0)), 3.0)
    ));
    const SurfacePolyline square = alongGrid(surface, 4, {{1, 1}, {2, 1}, {2, 2}, {1, 2}}, true);
    const ImprintedMesh imprinted = imprint(surface, std::vector{square}, {});
    const MeshParts parts = partsOf(imprinted);
    ASSERT_EQ(parts.parts.size(), 3U);
    EXPECT_EQ(partedParts(imprinted, parts), (std::vector{1, 2}));
    EXPECT_EQ(chosenParts(imprinted, parts, {.which = PartChoice::Which::Largest}), std::vector{1});
    PartChoice choice{.which = PartChoice::Which::Largest};
    EXPECT_EQ(keptParts(imprinted, parts, choice), (std::vector{0, 1}));
    choice.dropUntouched = true;
    EXPECT_EQ(keptParts(imprinted, parts, choice), std::vector{1});
}

TEST(PartChoice, ComponentsThatNoCurvePartsAreOneMeshTogether) {
    const auto movedPlate = [](double x, double size) {
        return transformed(plate(4, 4), Eigen::Isometry3d(Eigen::Translation3d(x, 0, 0)), size);
    };
    const std::vector<std::array<int, 2>> corners{{1, 1}, {2, 1}, {2, 2}, {1, 2}};
    const auto groups = [&](const TriangleMesh& mesh) {
        const Surface surface(mesh);
        const ImprintedMesh imprinted =
            imprint(surface, std::vector{alongGrid(surface, 4, corners, true)}, {});
        return partsPerMesh(imprinted, partsOf(imprinted), std::nullopt, true);
    };
    using Groups = std::vector<std::vector<int>>;
    const TriangleMesh two = joined(plate(4, 4), movedPlate(9, 3.0));
    EXPECT_EQ(groups(plate(4, 4)), (Groups{{0}, {1}}));
    EXPECT_EQ(groups(two), (Groups{{0}, {1}, {2}}));
    EXPECT_EQ(groups(joined(two, movedPlate(30, 0.5))), (Groups{{0, 2}, {1}, {3}}));
}

TEST(PartChoice, RefusesASlit) {
    const Surface surface(plate(4, 4));
    const SurfacePolyline slit = alongGrid(surface, 4, {{1, 1}, {2, 1}, {3, 1}}, false);
    const ImprintedMesh imprinted = imprint(surface, std::vector{slit}, {});
    expectRefused(
        [&] { return chosenParts(imprinted, partsOf(imprinted), {}); },
        InputErrorCode::NoPath,
        "the curves part nothing"
    );
}

TEST(PartChoice, EveryPartOfRandomNetworksIsWhole) {
    for (const TriangleMesh& mesh : {plate(3, 3), icosphere(2), torus(14, 9), box(1)}) {
        const Surface surface(mesh);
        forEachSeed(caseCount(50, 4), [&](Random& random) {
            const ImprintedMesh imprinted = imprint(surface, randomCurves(surface, random), {});
            const MeshParts parts = partsOf(imprinted);
            for (int label = 0; label < static_cast<int>(parts.parts.size()); ++label) {
                const std::vector<std::array<int, 2>> rim = edgesAround(imprinted, parts, {label});
                const CutMesh cut = cutAlongEdges(imprinted.mesh, rim);
                const Surface part(facesWithLabels(cut.mesh, parts.labels, {label}).mesh);
                ASSERT_EQ(part.componentCount(), 1);
                ASSERT_NEAR(part.area(), parts.parts[label].area, 1e-12 * surface.area());
            }
        });
    }
}

}  // namespace

}  // namespace bspline_curve

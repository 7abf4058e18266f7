// SPDX-License-Identifier: GPL-3.0-or-later
// Shells that are built near curves alone, and shells from a store.
#include "curve_checks.h"
#include "shell/shell_store.h"

#include <cmath>
#include <future>
#include <map>
#include <memory>
#include <optional>
#include <string_view>

namespace bspline_curve {
namespace {

using namespace test_support;

const SolverOptions kByCells{.quadrature = Quadrature::Cells};

class LocalShell : public testing::Test {
protected:
    TriangleMesh mesh_ = withNoise(icosphere(4), 0.004, 11);
    std::vector<Vec3> picks_ = verticesOf(mesh_, {5, 100, 400, 900});
    CurveDesigner local_ = designerIn(ShellKind::Local, mesh_);
    CurveDesigner full_ = designerIn(ShellKind::FullResolution, mesh_);
};

TEST_F(LocalShell, GivesTheCurveOfTheWholeShell) {
    const Curve near = goodCurve(local_, picks_);
    const Curve whole = goodCurve(full_, picks_);
    EXPECT_EQ(near.spline.controlPoints, whole.spline.controlPoints);
    const double tolerance =
        SolverOptions().distanceTolerance * full_.surface().averageEdgeLength();
    EXPECT_LT(largestDistance(near.polyline, whole.polyline), tolerance);
    EXPECT_EQ(whole.prisms, full_.surface().faceCount());
    EXPECT_EQ(whole.shell, ShellKind::FullResolution);
    EXPECT_EQ(near.shell, std::nullopt);
    EXPECT_EQ(near.prisms, 0);
    EXPECT_GT(near.facesPassed, 0);
    EXPECT_LT(near.facesPassed, whole.prisms / 4);
}

// Integrals cell by cell take the whole shell, so everything is the same.
TEST_F(LocalShell, IsTheWholeOneForCurvesThatNeedIt) {
    const Curve near = local_.design(picks_, kByCells);
    const Curve whole = full_.design(picks_, kByCells);
    EXPECT_EQ(near.polyline.points, whole.polyline.points);
    EXPECT_EQ(near.shell, ShellKind::FullResolution);
    EXPECT_EQ(near.prisms, whole.prisms);
}

TEST_F(LocalShell, DoesNotRememberOtherCurves) {
    const CurveDesigner used = designerIn(ShellKind::Local, mesh_);
    goodCurve(used, verticesOf(mesh_, {50, 300, 900}));
    static_cast<void>(used.design(picks_, kByCells));
    EXPECT_EQ(goodCurve(local_, picks_).polyline.points, goodCurve(used, picks_).polyline.points);
}

TEST_F(LocalShell, ServesThreadsAtOnce) {
    const auto draw = [&](const SolverOptions& options) {
        return local_.design(picks_, options).polyline.points;
    };
    std::vector<std::future<std::vector<Vec3>>> sampled;
    std::vector<std::future<std::vector<Vec3>>> inCells;
    for (int i = 0; i < 3; ++i) {
        sampled.push_back(std::async(std::launch::async, draw, SolverOptions()));
        inCells.push_back(std::async(std::launch::async, draw, kByCells));
    }
    const std::vector<Vec3> first = draw({});
    const std::vector<Vec3> firstInCells = draw(kByCells);
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(sampled[i].get(), first);
        EXPECT_EQ(inCells[i].get(), firstInCells);
    }
}

TEST_F(LocalShell, DrawsAlongBoundaries) {
    const std::vector<Vec3> picks = {{0.1, 0.0, 0.0}, {0.5, 0.02, 0.0}, {0.9, 0.0, 0.0}};
    const Curve near = goodCurve(designerIn(ShellKind::Local, plate(20, 20)), picks);
    const Curve whole = goodCurve(designerIn(ShellKind::FullResolution, plate(20, 20)), picks);
    EXPECT_EQ(near.spline.controlPoints, whole.spline.controlPoints);
    EXPECT_LT(largestDistance(near.polyline, whole.polyline), 1e-9);
}

/// A store in memory that counts what is asked of it. It knows one surface only.
class MemoryStore : public ShellStore {
public:
    [[nodiscard]] Found find(
        const Surface& /*surface*/,
        const std::shared_ptr<const ExtendedSurface>& /*extended*/,
        std::string_view parameters
    ) const override {
        ++finds;
        const auto found = shells.find(std::string(parameters));
        return {
            .build = found == shells.end() ? std::nullopt : std::optional(found->second),
            .note = note
        };
    }

    [[nodiscard]] std::string store(
        const Surface& /*surface*/,
        const ExtendedSurface& /*extended*/,
        std::string_view parameters,
        const ShellBuild& build
    ) const override {
        shells.emplace(parameters, build);
        return note;
    }

    mutable std::map<std::string, ShellBuild> shells;
    mutable int finds = 0;
    std::string note;
};

const TriangleMesh kMesh = icosphere(4);
const std::vector<Vec3> kPicks = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
const ShellOptions kSimplified{.kind = ShellKind::Simplified};

TEST(ShellStores, ServeTheSecondDesignerWithTheSameCurve) {
    const MemoryStore store;
    const CurveDesigner first(kMesh, kSimplified, {}, {}, &store);
    EXPECT_FALSE(first.shell().isFromStore);
    ASSERT_EQ(store.shells.size(), 1U);
    const CurveDesigner second(kMesh, kSimplified, {}, {}, &store);
    EXPECT_TRUE(second.shell().isFromStore);
    EXPECT_TRUE(second.shell().notes.empty());
    EXPECT_EQ(second.shell().kind, ShellKind::Simplified);
    EXPECT_EQ(store.shells.size(), 1U);
    const Curve a = goodCurve(first, kPicks);
    const Curve b = goodCurve(second, kPicks);
    EXPECT_EQ(a.spline.controlPoints, b.spline.controlPoints);
    EXPECT_EQ(a.polyline.points, b.polyline.points);
    EXPECT_EQ(a.prisms, b.prisms);
}

TEST(ShellStores, AreNotAskedForShellsOfFullResolution) {
    const MemoryStore store;
    const CurveDesigner designer(kMesh, {.kind = ShellKind::FullResolution}, {}, {}, &store);
    EXPECT_FALSE(designer.shell().isFromStore);
    EXPECT_EQ(store.finds, 0);
    EXPECT_TRUE(store.shells.empty());
}

TEST(ShellStores, KeepOneShellForEachSetOfOptionsThatASimplifiedShellFollows) {
    const MemoryStore store;
    ShellOptions options = kSimplified;
    options.thickness = 0.5;  // of full resolution only
    for (const ShellOptions& o : {kSimplified, options}) {
        const CurveDesigner designer(kMesh, o, {}, {}, &store);
    }
    EXPECT_EQ(store.shells.size(), 1U);
    std::vector<ShellOptions> others(3, kSimplified);
    others[0].targetThickness = std::nextafter(kSimplified.targetThickness, 1.0);
    others[1].targetEdgeLength = 0.5;
    others[2].smoothingPasses = 2;
    for (const ShellOptions& o : others) {
        const CurveDesigner designer(kMesh, o, {}, {}, &store);
        EXPECT_FALSE(designer.shell().isFromStore);
    }
    EXPECT_EQ(store.shells.size(), 4U);
}

TEST(ShellStores, TellTheirTroubleInNotesAndStopNoCurve) {
    MemoryStore store;
    store.note = "out of order";
    const CurveDesigner designer(kMesh, kSimplified, {}, {}, &store);
    EXPECT_EQ(designer.shell().notes, (std::vector<std::string>{"out of order", "out of order"}));
    goodCurve(designer, kPicks);
}

}  // namespace
}  // namespace bspline_curve

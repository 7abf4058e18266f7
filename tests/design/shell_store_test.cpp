// SPDX-License-Identifier: GPL-3.0-or-later
// How designers use a store of shells.
#include "shell/shell_store.h"

#include "curve_checks.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

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

}  // namespace

TEST(ShellStores, ServeTheSecondDesignerWithTheSameCurve) {
    const MemoryStore store;
    const CurveDesigner first(kMesh, kSimplified, {}, &store);
    EXPECT_FALSE(first.shell().isFromStore);
    ASSERT_EQ(store.shells.size(), 1U);
    const CurveDesigner second(kMesh, kSimplified, {}, &store);
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
    const CurveDesigner designer(kMesh, {.kind = ShellKind::FullResolution}, {}, &store);
    EXPECT_FALSE(designer.shell().isFromStore);
    EXPECT_EQ(store.finds, 0);
    EXPECT_TRUE(store.shells.empty());
}

TEST(ShellStores, KeepOneShellForEachSetOfOptionsThatASimplifiedShellFollows) {
    const MemoryStore store;
    ShellOptions options = kSimplified;
    options.thickness = 0.5;  // of full resolution only
    for (const ShellOptions& o : {kSimplified, options}) {
        const CurveDesigner designer(kMesh, o, {}, &store);
    }
    EXPECT_EQ(store.shells.size(), 1U);
    std::vector<ShellOptions> others(3, kSimplified);
    others[0].targetThickness = std::nextafter(kSimplified.targetThickness, 1.0);
    others[1].targetEdgeLength = 0.5;
    others[2].smoothingPasses = 2;
    for (const ShellOptions& o : others) {
        const CurveDesigner designer(kMesh, o, {}, &store);
        EXPECT_FALSE(designer.shell().isFromStore);
    }
    EXPECT_EQ(store.shells.size(), 4U);
}

TEST(ShellStores, TellTheirTroubleInNotesAndStopNoCurve) {
    MemoryStore store;
    store.note = "out of order";
    const CurveDesigner designer(kMesh, kSimplified, {}, &store);
    EXPECT_EQ(designer.shell().notes, (std::vector<std::string>{"out of order", "out of order"}));
    static_cast<void>(goodCurve(designer, kPicks));
}

}  // namespace bspline_curve

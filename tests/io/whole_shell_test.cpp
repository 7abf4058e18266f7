// SPDX-License-Identifier: GPL-3.0-or-later
// The shell of a mesh by itself, as programs that link the library have it.
#include "bspline_curve/whole_shell.h"

#include "io/environment_variable.h"
#include "io/temporary_files.h"
#include "support/meshes.h"

#include <algorithm>

namespace bspline_curve::io_tests {

namespace {

class WholeShells : public FileTest {
protected:
    [[nodiscard]] static Workpiece workpiece(ShellKind kind) {
        return Workpiece(test_support::icosphere(1), {.shell = {.kind = kind}});
    }

    /// How many shells there are on disk.
    [[nodiscard]] std::size_t kept() {
        const std::filesystem::path folder = path("cache") / "shells";
        return std::filesystem::exists(folder)
                   ? static_cast<std::size_t>(std::ranges::count_if(
                         std::filesystem::directory_iterator(folder),
                         [](const auto& entry) { return entry.is_regular_file(); }
                     ))
                   : 0;
    }

    std::string cache_ = path("cache").string();
    Variable cacheFolder_{"BSPLINE_CURVE_CACHE", cache_.c_str()};
};

TEST_F(WholeShells, HavePrismsAndHoldEveryInvariant) {
    for (const ShellKind kind : {ShellKind::Simplified, ShellKind::FullResolution}) {
        const Workpiece sphere = workpiece(kind);
        const WholeShell shell(sphere, false);
        const ShellFigures& figures = shell.figures();
        EXPECT_EQ(figures.kind, kind);
        EXPECT_GT(figures.prisms, 0);
        EXPECT_EQ(figures.ghostPrisms, 0);
        EXPECT_EQ(figures.boundaryEdges, 0);
        EXPECT_GT(figures.thickness.min, 0.0);
        EXPECT_LE(figures.thickness.min, figures.thickness.mean);
        EXPECT_TRUE(std::ranges::all_of(shell.check(), &ShellInvariant::holds));
        EXPECT_TRUE(shell.notes().empty());
    }
}

TEST_F(WholeShells, AreWrittenByTheEndOfTheName) {
    const Workpiece sphere = workpiece(ShellKind::FullResolution);
    const WholeShell shell(sphere, false);
    EXPECT_TRUE(shell.bytes("a.ply").starts_with("ply\n"));
    EXPECT_NE(shell.bytes("a.VTU").find("UnstructuredGrid"), std::string::npos);
    EXPECT_TRUE(shell.bytes("a.msh").starts_with("$MeshFormat"));
    expectContains(
        refusal([&] { return shell.bytes("a.obj"); }, InputErrorCode::UnwritableFile), ".obj"
    );
}

TEST_F(WholeShells, AreFoundAgainOnDisk) {
    const Workpiece sphere = workpiece(ShellKind::Simplified);
    WholeShell made(sphere);
    EXPECT_EQ(kept(), 0U);
    made.keep();
    EXPECT_EQ(kept(), 1U);
    const WholeShell found(sphere);
    EXPECT_EQ(found.bytes("a.vtu"), made.bytes("a.vtu"));
    const Workpiece again = workpiece(ShellKind::Simplified);
    prepareWithKeptShell(again);
    EXPECT_TRUE(again.shell().isFromStore);
    EXPECT_EQ(kept(), 1U);
}

TEST_F(WholeShells, AreLeftOnDiskByWhatPrepares) {
    const Workpiece sphere = workpiece(ShellKind::Simplified);
    prepareWithKeptShell(sphere);
    EXPECT_FALSE(sphere.shell().isFromStore);
    EXPECT_EQ(kept(), 1U);
}

TEST_F(WholeShells, AreNoLocalOnes) {
    const Workpiece sphere = workpiece(ShellKind::Local);
    expectContains(
        refusal([&] { return WholeShell(sphere).figures().prisms; }, InputErrorCode::BadOption),
        "simplified or full"
    );
}

}  // namespace

}  // namespace bspline_curve::io_tests

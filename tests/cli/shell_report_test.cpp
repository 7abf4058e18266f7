// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/reports/shell_report.h"

#include "io/json_values.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

namespace bspline_curve::cli {

namespace {

using io_tests::expectValues;

struct Reported {
    explicit Reported(TriangleMesh mesh)
        : workpiece(std::move(mesh), {.shell = {.kind = ShellKind::FullResolution}}),
          shell(workpiece) {}

    [[nodiscard]] nlohmann::json report(const ShellRunFigures& figures = {}) const {
        return nlohmann::json::parse(shellReportText(workpiece, shell, figures));
    }

    Workpiece workpiece;
    WholeShell shell;
};

}  // namespace

TEST(ShellReport, WritesEveryFigureUnderItsName) {
    const Reported plate(test_support::plate(4, 3));
    ShellRunFigures figures;
    figures.meshFile = "a.ply";
    figures.seconds.cpu = 0.5;
    figures.seconds.read = 0.25;
    figures.peakMemoryBytes = 1000000;
    const int prisms = plate.shell.figures().prisms;
    EXPECT_GT(prisms, 24);
    expectValues(
        plate.report(figures),
        {{"/shell", "full"},
         {"/faces", 24},
         {"/prisms", prisms},
         {"/ghost_prisms", prisms - 24},
         {"/blocked_faces", 0},
         {"/moved_vertices", 0},
         {"/mesh/boundary_edges", 14},
         {"/mesh/components", 1},
         {"/mesh/file", "a.ply"},
         {"/seconds/cpu", 0.5},
         {"/seconds/read", 0.25},
         {"/peak_memory_bytes", 1000000},
         {"/notes", nlohmann::json::array()},
         {"/check", nullptr},
         {"/repair", nullptr}}
    );
}

TEST(ShellReport, SaysHowEachInvariantFared) {
    const Reported plate(test_support::plate(4, 3));
    ShellRunFigures figures;
    figures.check = plate.shell.check();
    const std::size_t count = figures.check->size();
    for (ShellInvariant& invariant : *figures.check) {
        EXPECT_TRUE(invariant.holds) << invariant.name;
        if (invariant.name == "transversal surface") {
            invariant.holds = false;
            invariant.violations = 12;
            invariant.firstIds = {3, 4};
        }
    }
    const auto report = plate.report(figures);
    EXPECT_EQ(report["check"].size(), count);
    expectValues(
        report["check"],
        {{"/positive tetrahedra/holds", true},
         {"/transversal surface/holds", false},
         {"/transversal surface/violations", 12},
         {"/transversal surface/first_ids", {3, 4}}}
    );
}

TEST(ShellReport, ListsWhatARepairChanged) {
    const auto repaired = Reported(test_support::bowTie()).report()["repair"];
    const auto nothing = nlohmann::json::array();
    expectValues(
        repaired,
        {{"/changes", 1},
         {"/duplicated_vertices/0/vertex", 0},
         {"/duplicated_vertices/0/copies", nlohmann::json::array({5})},
         {"/left_out_faces", nothing},
         {"/merged_vertices", nothing},
         {"/removed_degenerate_faces", nothing},
         {"/split_faces", nothing},
         {"/removed_duplicate_faces", nothing},
         {"/reversed_faces", nothing},
         {"/cut_edges", nothing}}
    );
}

}  // namespace bspline_curve::cli

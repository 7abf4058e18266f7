// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/reports/field_report.h"

#include "support/meshes.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <vector>

namespace bspline_curve::cli {

TEST(FieldReport, TellsKindAndRange) {
    const Workpiece workpiece(test_support::icosphere(1));
    std::vector<double> field(workpiece.mesh().vertices.size(), 1.0);
    field[3] = -1.0;
    field[4] = 44.0;
    const FieldRunFigures figures{
        .meshFile = "a.ply", .kind = "ridge", .naturalCost = "exp-minus", .seconds = {}
    };
    const auto report = nlohmann::json::parse(fieldReportText(workpiece, field, figures));
    EXPECT_EQ(report["kind"], "ridge");
    EXPECT_EQ(report["minimum"], -1.0);
    EXPECT_EQ(report["maximum"], 44.0);
    EXPECT_DOUBLE_EQ(report["mean"].get<double>(), 83.0 / 42.0);
    EXPECT_EQ(report["mesh"]["vertices"], 42);
    EXPECT_TRUE(report["repair"].is_null());
}

}  // namespace bspline_curve::cli

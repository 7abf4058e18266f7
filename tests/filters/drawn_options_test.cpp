// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/drawn_options.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace bspline_curve {
namespace {

CurveRequest requestWith(const char* id, const ParameterValue& value) {
    ParameterValues values(curveFilter());
    values.set(id, value);
    return curveRequest(values);
}

TEST(DrawnOptions, ComeBackFromTheRequestThatIsMadeOfThem) {
    DrawnOptions options;
    EXPECT_EQ(drawnOptions(curveRequest(valuesOf(options))), options);
    options = {
        .closed = true,
        .degree = 4,
        .tension = 0.3,
        .field = "valley",
        .fieldWeight = 500.0,
        .avoid = "over-threshold",
        .avoidThreshold = 0.75
    };
    const CurveRequest request = curveRequest(valuesOf(options));
    EXPECT_EQ(drawnOptions(request), options);
    EXPECT_EQ(request.solver.fieldCost, FieldCost::Natural);
    for (const EnumOption& field : curveFilter().parameter("field").options) {
        options = {.field = field.id};
        EXPECT_EQ(drawnOptions(curveRequest(valuesOf(options))), options) << field.id;
    }
    for (const EnumOption& avoid : curveFilter().parameter("avoid").options) {
        options = {.avoid = avoid.id};
        EXPECT_EQ(drawnOptions(curveRequest(valuesOf(options))), options) << avoid.id;
    }
}

TEST(DrawnOptions, AreTheDefaultsOfTheFilter) {
    EXPECT_EQ(DrawnOptions().field, kNoField);
    const ParameterValues values = valuesOf(DrawnOptions());
    for (const ParameterDescription& parameter : curveFilter().parameters) {
        EXPECT_EQ(values.value(parameter.id), parameter.defaultValue) << parameter.id;
    }
}

TEST(DrawnOptions, AreNoneWhereARequestAsksForMore) {
    EXPECT_FALSE(drawnOptions(requestWith("preset", "paper")));
    EXPECT_FALSE(drawnOptions(requestWith("samples", 1000)));
    EXPECT_FALSE(drawnOptions(requestWith("shell", "full")));
    EXPECT_FALSE(drawnOptions(requestWith("avoid_margin", 0.05)));
    EXPECT_FALSE(drawnOptions(requestWith("weld", 1e-6)));
    EXPECT_FALSE(drawnOptions(requestWith("strict", true)));
    EXPECT_FALSE(drawnOptions(requestWith("pick_tolerance", "0.1,0.2")));
    EXPECT_TRUE(drawnOptions(requestWith("pick_tolerance", "0.1")));
    EXPECT_TRUE(drawnOptions(requestWith("corners", "1")));  // these are of the picks
    EXPECT_TRUE(drawnOptions(requestWith("tangents", "1: 1, 0, 0")));
    // What belongs to a field that is not there is not asked for.
    EXPECT_TRUE(drawnOptions(requestWith("field_smoothing", 0.1)));
    ParameterValues values(curveFilter());
    values.set("field", "ridge");
    values.set("field_smoothing", 0.1);
    EXPECT_FALSE(drawnOptions(curveRequest(values)));
    EXPECT_TRUE(drawnOptions(requestWith("tube_radius", 0.1)));
    EXPECT_TRUE(drawnOptions(requestWith("picks", "0 0 0 1 1 1")));
}

TEST(DrawnOptions, AreParametersOfTheFilterInItsOrder) {
    std::vector<std::string> ids;
    for (const ParameterDescription& parameter : curveFilter().parameters) {
        if (std::ranges::find(drawnParameters(), parameter.id) != drawnParameters().end()) {
            ids.push_back(parameter.id);
        }
    }
    EXPECT_EQ(drawnParameters(), ids);
}

}  // namespace
}  // namespace bspline_curve

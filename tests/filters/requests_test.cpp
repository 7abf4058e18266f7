// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/requests.h"

#include "bspline_curve/error.h"
#include "filters/option_bindings.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace bspline_curve {
namespace {

using Text = std::string;

void expectEqual(const SolverOptions& a, const SolverOptions& b) {
    for (const Binding<SolverOptions>& binding : solverBindings()) {
        EXPECT_EQ(binding.write(a), binding.write(b)) << binding.id;
    }
}

TEST(CurveRequest, IsTheOptionsDefaultsWhereNothingWasGiven) {
    const CurveRequest request = curveRequest(ParameterValues(curveFilter()));
    expectEqual(request.solver, SolverOptions());
    EXPECT_FALSE(request.field);
    EXPECT_EQ(request.avoid.by, FaceChoice::By::Nothing);
    EXPECT_EQ(request.surface, LayerId());
    EXPECT_TRUE(request.picksText.empty());
}

TEST(CurveRequest, FollowsThePresetWhereNothingElseWasGiven) {
    ParameterValues values(curveFilter());
    values.set("preset", Text("paper"));
    expectEqual(curveRequest(values).solver, paperPreset());
    values.set("bending", Text("geodesic"));
    values.set("max_rounds", 7);
    SolverOptions expected = paperPreset();
    expected.bending = Bending::Geodesic;
    expected.maxRounds = 7;
    expectEqual(curveRequest(values).solver, expected);
    EXPECT_EQ(curveRequest(values).shell.kind, ShellKind::Simplified);
    values.set("shell", Text("full"));
    EXPECT_EQ(curveRequest(values).shell.kind, ShellKind::FullResolution);
}

TEST(CurveRequest, ChoosesCornersByNumbersFromOne) {
    const auto cornersOf = [](const Text& text) {
        ParameterValues values(curveFilter());
        values.set("corners", text);
        return curveRequest(values).corners;
    };
    EXPECT_EQ(cornersOf("").of(3), std::vector<int>());
    EXPECT_EQ(cornersOf(" 4, 1 ").of(9), (std::vector<int>{3, 0}));
    EXPECT_EQ(cornersOf("2 3").of(9), (std::vector<int>{1, 2}));
    EXPECT_EQ(cornersOf("all").of(3), (std::vector<int>{0, 1, 2}));
    EXPECT_EQ(describe(cornersOf("2 3")), "2,3");
    EXPECT_EQ(describe(cornersOf("all")), "all");
    EXPECT_EQ(describe(PickChoice()), "");
    for (const Text wrong : {"0", "-1", "1.5", "x", "1;2", "all 1", "1 all", "99999999999"}) {
        try {
            static_cast<void>(cornersOf(wrong));
            FAIL() << wrong;
        } catch (const InputError& error) {
            EXPECT_EQ(error.code(), InputErrorCode::BadOption);
            EXPECT_TRUE(Text(error.what()).starts_with("corners is \"" + wrong)) << error.what();
        }
    }
}

TEST(CurveRequest, TakesOneToleranceForAllPicksOrOneForEach) {
    const auto requestOf = [](const Text& text) {
        ParameterValues values(curveFilter());
        values.set("pick_tolerance", text);
        return curveRequest(values);
    };
    const MeshLength edges{1.5, true};
    const CurveRequest all = requestOf("1.5 edges");
    EXPECT_EQ(all.solver.pickTolerance, edges);
    EXPECT_TRUE(all.pickTolerances.within(3).empty());
    EXPECT_TRUE(all.pickTolerances.weights(3).empty());
    const CurveRequest each = requestOf(" 0.4, 0,1.5edges , weight 100 ");
    EXPECT_EQ(each.solver.pickTolerance, MeshLength());
    EXPECT_EQ(
        each.pickTolerances.within(4), (std::vector<MeshLength>{{0.4, false}, {}, edges, {}})
    );
    EXPECT_EQ(each.pickTolerances.weights(4), (std::vector<double>{0.0, 0.0, 0.0, 100.0}));
    EXPECT_THROW(static_cast<void>(each.pickTolerances.within(3)), InputError);
    const CurveRequest weight = requestOf("weight 2e3");
    EXPECT_EQ(weight.pickTolerances.weights(3), (std::vector<double>{2e3, 2e3, 2e3}));
    for (const Text wrong :
         {"",
          ",",
          "0.4,",
          "0.4;1",
          "1 2",
          "weight",
          "weight -1",
          "weight 0",
          "weight nan",
          "-1,0"}) {
        try {
            static_cast<void>(requestOf(wrong));
            FAIL() << wrong;
        } catch (const InputError& error) {
            EXPECT_EQ(error.code(), InputErrorCode::BadOption);
            EXPECT_TRUE(Text(error.what()).starts_with("pick_tolerance ")) << error.what();
        }
    }
}

TEST(CurveRequest, TakesTangentsByNumbersFromOne) {
    const auto tangentsOf = [](const Text& text) {
        ParameterValues values(curveFilter());
        values.set("tangents", text);
        return curveRequest(values).tangents;
    };
    EXPECT_TRUE(tangentsOf("").of(3).empty());
    const PickDirections two = tangentsOf(" 3: 0 , 0.1, -2e-3;1:1 0 0 ; ");
    const std::vector<PickTangent> expected = {
        PickTangent::along(Vec3::UnitX()), {}, PickTangent::along({0.0, 0.1, -2e-3}), {}
    };
    EXPECT_EQ(two.of(4), expected);
    EXPECT_EQ(describe(two), "3:0,0.1,-0.002;1:1,0,0");
    EXPECT_EQ(tangentsOf(describe(two)), two);
    EXPECT_THROW(static_cast<void>(two.of(2)), InputError);
    const PickDirections ofCorners = tangentsOf("1: 1 0 0 / 0,1,0; 2:any/0 0 1;3: 0 0 2/ any");
    const std::vector<PickTangent> sides = {
        {Vec3::UnitX(), Vec3::UnitY()},
        {Vec3::Zero(), Vec3::UnitZ()},
        {2.0 * Vec3::UnitZ(), Vec3::Zero()}
    };
    EXPECT_EQ(ofCorners.of(3), sides);
    EXPECT_EQ(describe(ofCorners), "1:1,0,0/0,1,0;2:any/0,0,1;3:0,0,2/any");
    EXPECT_EQ(tangentsOf(describe(ofCorners)), ofCorners);
    for (const Text wrong :
         {"0:1,0,0",
          "1:0,0,0",
          "1:1,0",
          "1:1,0,0,0",
          "1 1,0,0",
          "x",
          "1:nan,0,0",
          "1:1,0,0 2:0,1,0",
          "1:any",
          "1:any/any",
          "1:1,0,0/",
          "1:/1,0,0",
          "1:1,0,0/0,0,0"}) {
        EXPECT_THROW(static_cast<void>(tangentsOf(wrong)), InputError) << wrong;
    }
}

TEST(CurveRequest, TakesTheNaturalCostOfItsFieldUnlessAnotherIsGiven) {
    ParameterValues values(curveFilter());
    values.set("field", Text("crease-distance"));
    CurveRequest request = curveRequest(values);
    ASSERT_TRUE(request.field);
    EXPECT_EQ(request.field->options.kind, FieldKind::CreaseDistance);
    EXPECT_EQ(request.solver.fieldCost, FieldCost::Natural);
    values.set("field_cost", Text("exp-minus"));
    EXPECT_EQ(curveRequest(values).solver.fieldCost, FieldCost::ExpMinus);
    values.set("field", Text("none"));
    EXPECT_FALSE(curveRequest(values).field);
}

TEST(CurveRequest, HoldsWhatWasGiven) {
    ParameterValues values(curveFilter());
    values.set("surface_layer", LayerId{4});
    values.set("picks", Text("0 0 0; 1 0 0"));
    values.set("closed", true);
    values.set("avoid", Text("under-threshold"));
    values.set("avoid_threshold", -2.5);
    values.set("shell", Text("simplified"));
    values.set("target_thickness", 0.25);
    values.set("max_segment_length", 0.5);
    values.set("field", Text("obstacle"));
    values.set("field_region", Text("selected-vertices"));
    values.set("field_inverted", true);
    const CurveRequest request = curveRequest(values);
    EXPECT_EQ(request.surface, LayerId{4});
    EXPECT_EQ(request.picksText, "0 0 0; 1 0 0");
    EXPECT_TRUE(request.solver.closed);
    EXPECT_EQ(request.avoid.by, FaceChoice::By::UnderThreshold);
    EXPECT_EQ(request.avoid.threshold, -2.5);
    EXPECT_EQ(request.shell.kind, ShellKind::Simplified);
    EXPECT_EQ(request.shell.targetThickness, 0.25);
    EXPECT_EQ(request.sampling.maxSegmentLength, 0.5);
    EXPECT_EQ(request.field->region.by, FaceChoice::By::SelectedVertices);
    EXPECT_TRUE(request.field->options.inverted);
}

TEST(FieldRequest, HoldsWhatWasGiven) {
    ParameterValues values(fieldFilter());
    EXPECT_EQ(fieldRequest(values).options.kind, FieldOptions().kind);
    values.set("kind", Text("valley"));
    values.set("smoothing", 0.125);
    const FieldRequest request = fieldRequest(values);
    EXPECT_EQ(request.options.kind, FieldKind::Valley);
    EXPECT_EQ(request.options.smoothing, 0.125);
}

}  // namespace
}  // namespace bspline_curve

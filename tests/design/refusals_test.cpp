// SPDX-License-Identifier: GPL-3.0-or-later
// Bad input is refused by name; progress only rises and cancels at once.
#include "bspline_curve/options.h"
#include "curve_checks.h"
#include "design/curve_designer.h"
#include "support/places.h"
#include "support/refusal.h"

#include <cmath>
#include <limits>
#include <optional>

namespace bspline_curve {
namespace {

using namespace test_support;

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

class Refusals : public testing::Test {
protected:
    void expectNoCurve(
        InputErrorCode code,
        const std::vector<double>& field,
        const SolverOptions& options = {},
        const SamplingOptions& sampling = {},
        const std::optional<std::vector<std::int64_t>>& elements = std::nullopt
    ) const {
        expectRefused(
            [&] { return designer_.design(picks_, options, sampling, {.field = field}); },
            code,
            "",
            elements
        );
    }

    CurveDesigner designer_{plate(4, 4)};
    std::vector<Vec3> picks_ = {{0.1, 0.2, 0}, {0.9, 0.7, 0}};
    std::vector<double> field_ = std::vector<double>(25, 1.0);
};

TEST_F(Refusals, FieldsOfAnotherSizeAreRefused) {
    expectNoCurve(InputErrorCode::BadField, std::vector<double>(24, 1.0));
    expectNoCurve(InputErrorCode::BadField, std::vector<double>(26, 1.0));
}

TEST_F(Refusals, FieldsThatAreNotFiniteAreRefusedWithTheirVertices) {
    field_[7] = kNotANumber;
    field_[11] = std::numeric_limits<double>::infinity();
    expectNoCurve(InputErrorCode::BadField, field_, {}, {}, {{7, 11}});
}

TEST_F(Refusals, FieldsWhoseCostIsNotFiniteAreRefusedWithTheirVertices) {
    field_[7] = -1000.0;
    expectNoCurve(InputErrorCode::BadField, field_, {.fieldCost = FieldCost::ExpMinus}, {}, {{7}});
    EXPECT_NO_THROW(
        static_cast<void>(designer_.design(picks_, {.maxRounds = 1}, {}, {.field = field_}))
    );
}

TEST_F(Refusals, OptionsOutOfRangeAreRefused) {
    expectNoCurve(InputErrorCode::BadOption, {}, {.degree = 5});
    expectNoCurve(InputErrorCode::BadOption, {}, {.tension = kNotANumber});
    expectNoCurve(InputErrorCode::BadOption, {}, {}, {-1, 0.0});
    expectNoCurve(InputErrorCode::BadOption, {}, {}, {10, -1.0});
    expectNoCurve(InputErrorCode::BadOption, {}, {}, {10, kNotANumber});
}

TEST_F(Refusals, ShellOptionsOutOfRangeAreRefused) {
    const ShellKind simplified = ShellKind::Simplified;
    for (const ShellOptions& options : std::vector<ShellOptions>{
             {.thickness = 0.0},
             {.thickness = -1.0},
             {.thickness = kNotANumber},
             {.smoothingPasses = -1},
             {.kind = simplified, .targetThickness = 0.0},
             {.kind = simplified, .targetThickness = kNotANumber},
             {.kind = simplified, .targetEdgeLength = -1.0},
             {.kind = simplified, .targetEdgeLength = kNotANumber},
             {.kind = simplified, .smoothingPasses = -1},
         }) {
        expectRefused(
            [&] { return CurveDesigner(plate(4, 4), options); }, InputErrorCode::BadOption
        );
    }
}

TEST_F(Refusals, TooFewPicksAreRefused) {
    expectRefused([&] { return designer_.design({{0.1, 0.2, 0}}); }, InputErrorCode::TooFewPicks);
    expectNoCurve(InputErrorCode::TooFewPicks, {}, {.closed = true});
}

struct Calls {
    std::vector<double> fractions;
    int allowed = 1 << 30;

    Progress callback() {
        return [this](double fraction, const char*) {
            fractions.push_back(fraction);
            return static_cast<int>(fractions.size()) < allowed;
        };
    }
};

void expectRising(const std::vector<double>& fractions) {
    double before = 0.0;
    for (const double fraction : fractions) {
        EXPECT_GE(fraction, before);
        EXPECT_LE(fraction, 1.0);
        before = fraction;
    }
}

TEST(ProgressReports, RiseToOneAndCancelAtEveryCall) {
    const TriangleMesh mesh = withNoise(icosphere(3), 0.01, 43);
    const std::vector<Vec3> picks = {mesh.vertices[5], mesh.vertices[100], mesh.vertices[400]};
    const CurveDesigner designer(mesh);
    Calls curve;
    static_cast<void>(designer.design(picks, {}, {}, {}, curve.callback()));
    ASSERT_FALSE(curve.fractions.empty());
    expectRising(curve.fractions);
    EXPECT_EQ(curve.fractions.back(), 1.0);

    for (std::size_t call = 1; call <= curve.fractions.size(); ++call) {
        Calls cancelled{.fractions = {}, .allowed = static_cast<int>(call)};
        EXPECT_THROW(
            static_cast<void>(designer.design(picks, {}, {}, {}, cancelled.callback())), Cancelled
        ) << call;
        EXPECT_EQ(cancelled.fractions.size(), call);
    }
    // A cancelled call leaves nothing behind.
    const Curve after = designer.design(picks);
    EXPECT_TRUE(after.report.usable);
}

TEST(ProgressReports, CancelThePreparationAtEveryCall) {
    // Of many faces, so that they are grouped, too; other threads work beside this one.
    const TriangleMesh mesh = icosphere(5);
    Calls whole;
    static_cast<void>(CurveDesigner(mesh, {}, {}, whole.callback()));
    EXPECT_GE(whole.fractions.size(), 10);
    expectRising(whole.fractions);
    for (std::size_t call = 1; call <= whole.fractions.size(); ++call) {
        Calls cancelled{.fractions = {}, .allowed = static_cast<int>(call)};
        EXPECT_THROW(CurveDesigner(mesh, {}, {}, cancelled.callback()), Cancelled) << call;
        EXPECT_EQ(cancelled.fractions.size(), call);
    }
}

TEST(ProgressReports, RiseWhereAMeshIsMendedAndPreparedAgain) {
    TriangleMesh mesh = icosphere(3);
    mesh.faces.push_back(mesh.faces.front());
    Calls calls;
    const CurveDesigner designer(mesh, {}, {}, calls.callback());
    EXPECT_FALSE(designer.surface().provenance().isIdentity());
    expectRising(calls.fractions);
}

// ---- At samples and by cells ----

std::optional<InputError> refusalBy(
    const CurveDesigner& designer,
    const std::vector<Vec3>& picks,
    Quadrature quadrature,
    const Region& avoid
) {
    SolverOptions options;
    options.quadrature = quadrature;
    try {
        static_cast<void>(designer.design(picks, options, {}, {.avoid = avoid}));
    } catch (const InputError& error) {
        return error;
    }
    return std::nullopt;
}

TEST(RefusalsAtSamples, AreThoseOfCells) {
    struct Refused {
        TriangleMesh mesh;
        std::vector<Vec3> picks;
        double wall = 0.0;  // faces to avoid beside x = 0.5
    };

    const std::vector<Refused> cases = {
        {twoComponents(), {{-1, 0, 0}, {3, 0, 0}}},
        {plate(8, 8), {{0.1, 0.2, 0}, {0.9, 0.7, 0}}, 0.1},
        {plate(8, 8), {{0.1, 0.2, 0}, {0.5, 0.7, 0}}, 0.1},
        {plate(8, 8), {{0.1, 0.2, 0}, {0.5, 0.7, 3.0}}},
        {plate(8, 8), {{0.1, 0.2, 0}, {0.1, 0.2, 0}}},
    };
    for (std::size_t i = 0; i < cases.size(); ++i) {
        SCOPED_TRACE("case " + std::to_string(i));
        const CurveDesigner designer(cases[i].mesh);
        const Region avoid = facesWhere(designer.surface(), [&](const Vec3& p) {
            return std::abs(p.x() - 0.5) < cases[i].wall;
        });
        const std::vector<Vec3>& picks = cases[i].picks;
        const auto one = refusalBy(designer, picks, Quadrature::FootPoints, avoid);
        const auto other = refusalBy(designer, picks, Quadrature::Cells, avoid);
        ASSERT_TRUE(one && other);
        EXPECT_EQ(one->code(), other->code());
        EXPECT_STREQ(one->what(), other->what());
        EXPECT_EQ(one->elements(), other->elements());
    }
}

}  // namespace
}  // namespace bspline_curve

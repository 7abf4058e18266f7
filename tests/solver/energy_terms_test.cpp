// SPDX-License-Identifier: GPL-3.0-or-later
// What all terms of PointTerms have in common, in cells and at samples.
#include "solver/energy_terms.h"

#include "problem_fixture.h"
#include "solver/cell_integrand.h"
#include "solver/term_takers.h"
#include "support/meshes.h"
#include "support/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

// A sphere with a field, and a disc to avoid; all of the rest is within its margin.
class EnergyTermsOnASphere : public testing::Test {
protected:
    EnergyTermsOnASphere() {
        std::vector<double> field;
        for (const Vec3& v : fixture_.surface().vertices()) {
            field.push_back(std::sin(3.0 * v.x()) + v.y() * v.z());
        }
        fixture_.setField(field);
        Region region;
        for (int f = 0; f < fixture_.surface().faceCount(); ++f) {
            if (fixture_.surface().position({f, Vec3::Constant(1.0 / 3.0)}).z() < -0.8) {
                region.push_back(f);
            }
        }
        fixture_.avoid(region, 3.0);
    }

    static SolverOptions squaredField() {
        SolverOptions options;
        options.fieldWeight = 2.0;
        options.fieldCost = FieldCost::Square;
        return options;
    }

    [[nodiscard]] const CurveProblem& problem() const { return fixture_.problem(); }

    // Points of faces outside of the region.
    [[nodiscard]] std::vector<SurfacePoint> places() const {
        Random random(7);
        std::vector<SurfacePoint> places;
        while (places.size() < 50) {
            const int face = random.integer(0, fixture_.surface().faceCount() - 1);
            if (!problem().obstacles->isAvoided(face)) {
                places.push_back({face, Vec3(0.2, 0.5, 0.3)});
            }
        }
        return places;
    }

    ProblemFixture fixture_{
        icosphere(3), {{1, 0.1, 0}, {0, 1, 0.2}, {-0.45, 0.2, 0.87}}, squaredField()
    };
    EnergyWeights weights_{.alpha = 20.0, .avoidance = 3.0};
};

TEST_F(EnergyTermsOnASphere, SayTheSameOfASurfacePointInACellAndAtAFoot) {
    for (const SurfacePoint& place : places()) {
        const ShellCell cell(*problem().shell, place);
        EnergyTerms inCell;
        ASSERT_TRUE(CellIntegrand(problem(), weights_, cell)
                        .add(problem().extended->position(place), 1.0, inCell));
        const FootPoint foot = FootPoint::at(place);
        const FootFrame frame;
        EnergyTerms atFoot;
        ASSERT_TRUE(
            PointTerms::add(
                FootGround{problem(), weights_, 1.0, foot.face},
                FootSample{foot, frame, 0.0},
                1.0,
                TakeValue{atFoot}
            )
        );
        EXPECT_GT(atFoot.avoidance, 0.0);
        EXPECT_NEAR(inCell.external, atFoot.external, 1e-12 * (1.0 + atFoot.external));
        EXPECT_NEAR(inCell.avoidance, atFoot.avoidance, 1e-9 * atFoot.avoidance);
        EXPECT_NEAR(inCell.distance, 0.0, 1e-20);
        EXPECT_EQ(atFoot.distance, 0.0);
    }
}

TEST_F(EnergyTermsOnASphere, HaveNoValueOnAPole) {
    const int avoided = [&] {
        int face = 0;
        while (!problem().obstacles->isAvoided(face)) {
            ++face;
        }
        return face;
    }();
    const SurfacePoint place{avoided, Vec3(0.2, 0.5, 0.3)};
    const FootPoint foot = FootPoint::at(place);
    const FootFrame frame;
    const FootSample sample{foot, frame, 0.0};
    EnergyTerms terms;
    EXPECT_FALSE(
        PointTerms::add(
            FootGround{problem(), weights_, 1.0, avoided}, sample, 1.0, TakeValue{terms}
        )
    );
    const ShellCell cell(*problem().shell, place);
    EXPECT_FALSE(CellIntegrand(problem(), weights_, cell)
                     .add(problem().extended->position(place), 1.0, terms));
    // Without a weight it has no say.
    weights_.avoidance = 0.0;
    EXPECT_TRUE(
        PointTerms::add(
            FootGround{problem(), weights_, 1.0, avoided}, sample, 1.0, TakeValue{terms}
        )
    );
    EXPECT_EQ(terms.avoidance, 0.0);
}

TEST_F(EnergyTermsOnASphere, AreWeightedInTheSum) {
    const EnergyTerms values{
        .internal = 1.0, .external = 10.0, .distance = 100.0, .fit = 1e3, .avoidance = 1e4
    };
    weights_.beta = 5.0;
    EXPECT_DOUBLE_EQ(
        PointTerms::sum(values, problem(), weights_), 1.0 + 2.0 * 10.0 + 20.0 * 100.0 + 5e3 + 3e4
    );
    const double field = 2.0 * (10.0 - problem().fieldCosts.least);
    EXPECT_DOUBLE_EQ(
        PointTerms::scale(values, problem(), weights_, 0.5),
        0.5 + 1.0 + kFieldShare * field + 20.0 * 100.0 + 5e3 + 3e4
    );
}

}  // namespace
}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/field_cache.h"

#include "support/meshes.h"
#include "support/refusal.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

class KnownFields : public ::testing::Test {
protected:
    [[nodiscard]] std::shared_ptr<const ValidatedField> find(
        const std::vector<double>& field, FieldCost cost = FieldCost::ExpMinus
    ) {
        return known_.find(surface_, extended_, ScalarField(field).shared(), cost);
    }

    Surface surface_{plate(6, 6)};
    ExtendedSurface extended_ = extendSurface(surface_, 3);
    std::vector<double> field_ = std::vector<double>(surface_.vertices().size(), 1.0);
    FieldCache known_;
};

TEST_F(KnownFields, AreCheckedOnceForTheSameValues) {
    const auto first = find(field_);
    EXPECT_EQ(find(std::vector<double>(field_)), first);
    const auto square = find(field_, FieldCost::Square);
    EXPECT_NE(square, first);
    EXPECT_DOUBLE_EQ(square->costs.least, 1.0);
    field_.back() = 2.0;
    const auto other = find(field_, FieldCost::Square);
    EXPECT_NE(other, square);
    EXPECT_DOUBLE_EQ(other->vertexCosts.back(), 4.0);
    EXPECT_EQ(first->values.size(), extended_.vertices.size());
}

TEST_F(KnownFields, AreRefusedWhereAnyValueIsNotFinite) {
    static_cast<void>(find(field_));
    for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
        std::vector<double> field = field_;
        field[7] = bad;
        for (int time = 0; time < 2; ++time) {
            expectRefused([&] { return find(field); }, InputErrorCode::BadField, "", {{7}});
        }
    }
    EXPECT_NO_THROW(static_cast<void>(find(field_)));
}

TEST_F(KnownFields, KnowTheCheapestFace) {
    for (std::size_t v = 0; v < field_.size(); ++v) {
        field_[v] = 3.0 + std::sin(static_cast<double>(v));
    }
    const auto found = find(field_, FieldCost::Identity);
    const SolverOptions options{.fieldWeight = 100.0};
    const FieldTravel travel = found->travel(options, 0.5);
    double least = std::numeric_limits<double>::infinity();
    for (const Triangle& face : surface_.faces()) {
        least = std::min(least, travel.costOf(face));
    }
    EXPECT_DOUBLE_EQ(least, 1.0);
    EXPECT_TRUE(found->travel(options, 0.0).empty());
    EXPECT_TRUE(find({})->travel(options, 1.0).empty());
}

}  // namespace
}  // namespace bspline_curve

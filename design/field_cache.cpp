// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/field_cache.h"

#include "bspline_curve/error.h"
#include "text/error_messages.h"
#include "utility/index_sets.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>

namespace bspline_curve {
namespace {

void requireFinite(
    const Surface& surface, std::span<const double> field, std::span<const double> costs
) {
    std::vector<std::int64_t> bad;
    for (std::size_t v = 0; v < field.size(); ++v) {
        if (!std::isfinite(field[v]) || !std::isfinite(costs[v])) {
            bad.push_back(surface.provenance().inputVertex(static_cast<int>(v)));
        }
    }
    sortUnique(bad);
    if (!bad.empty()) {
        throw InputError(
            InputErrorCode::BadField,
            "the field or its cost is not finite at " + std::to_string(bad.size()) + " vertices (" +
                describeElements(bad) + "): give another number there",
            bad
        );
    }
}

double leastOfFaces(const Surface& surface, std::span<const double> vertexCosts) {
    const auto meanOver = [&](const Triangle& face) {
        return (vertexCosts[face[0]] + vertexCosts[face[1]] + vertexCosts[face[2]]) / 3.0;
    };
    double least = meanOver(surface.faces().front());
    for (const Triangle& face : surface.faces()) {
        least = std::min(least, meanOver(face));
    }
    return least;
}

}  // namespace

FieldTravel ValidatedField::travel(const SolverOptions& options, double share) const {
    const double weight = share * options.fieldWeight / kUsualBending;
    if (vertexCosts.empty() || weight == 0.0 || !options.fieldGuidesPath) {
        return {};
    }
    return {vertexCosts, weight, leastOfFaces};
}

ValidatedField validateField(
    const Surface& surface,
    const ExtendedSurface& extended,
    std::span<const double> field,
    FieldCost cost
) {
    ValidatedField checked;
    checked.vertexCosts = vertexCostsOf(field, cost);
    requireFinite(surface, field, checked.vertexCosts);
    checked.values.assign(field.begin(), field.end());
    for (const int source : extended.ghostSource) {
        checked.values.push_back(field[source]);
    }
    checked.costs = summaryOf(checked.vertexCosts);
    checked.leastOfFaces = leastOfFaces(surface, checked.vertexCosts);
    return checked;
}

std::shared_ptr<const ValidatedField> FieldCache::find(
    const Surface& surface,
    const ExtendedSurface& extended,
    const std::shared_ptr<const std::vector<double>>& field,
    FieldCost cost
) {
    if (field == nullptr) {
        return std::make_shared<const ValidatedField>();
    }
    const MutexLock lock(mutex_);
    // Compares the bits: a value that is no number is like none that is kept.
    const bool isSame =
        field_ != nullptr && cost == cost_ &&
        (field == field_ ||
         (field->size() == field_->size() &&
          std::memcmp(field->data(), field_->data(), field->size() * sizeof(double)) == 0));
    if (!isSame) {
        kept_ =
            std::make_shared<const ValidatedField>(validateField(surface, extended, *field, cost));
        field_ = field;
        cost_ = cost;
    }
    return kept_;
}

}  // namespace bspline_curve

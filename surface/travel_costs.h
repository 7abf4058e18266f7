// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "utility/sparse_map.h"

#include <cmath>
#include <functional>
#include <utility>

namespace bspline_curve {

/// What a unit of length costs in each face.
struct TravelCosts {
    /// Of a face: positive, infinite where no way may enter. The same whenever it is asked. Empty:
    /// 1 everywhere.
    std::function<double(int face)> ofFace{};
    /// No face costs less, > 0. The nearer to what the cheapest costs, the less is searched.
    double least = 1.0;
};

/// Travel costs that are asked once of each face that is looked at.
class KnownCosts {
public:
    explicit KnownCosts(TravelCosts costs) : costs_(std::move(costs)) {}

    [[nodiscard]] double of(int face) {
        if (!costs_.ofFace) {
            return 1.0;
        }
        if (const double* cost = known_.find(face)) {
            return *cost;
        }
        return known_.at(face, costs_.ofFace(face));
    }

    [[nodiscard]] bool isOpen(int face) { return std::isfinite(of(face)); }

    [[nodiscard]] const TravelCosts& costs() const { return costs_; }

private:
    TravelCosts costs_;
    SparseMap<double> known_;
};

}  // namespace bspline_curve

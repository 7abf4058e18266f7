// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/surface_point.h"
#include "utility/sparse_map.h"

#include <cmath>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace bspline_curve {

/// What a unit of length costs in each face.
struct TravelCosts {
    /// Of a face: positive, infinite where no way may enter. The same whenever it is asked. Empty:
    /// 1 everywhere.
    std::function<double(int face)> ofFace{};
    /// No face costs less, > 0. The nearer to what the cheapest costs, the less is searched.
    double least = 1.0;
    /// Most open faces cost 1, so that cheap ways are short ones.
    bool areLengths = true;
};

/// A way from the start of a search to a place, to be gone on from (A*).
struct Offer {
    double estimate;  ///< what the whole way costs at least, or nearly
    double cost;      ///< as far as the place
    int place;
    bool isWhole = false;  ///< the goal lies at the place, and the estimate is exact

    /// Ties are broken by place, for the same result on every platform.
    bool operator>(const Offer& other) const {
        return estimate != other.estimate ? estimate > other.estimate : place > other.place;
    }
};

/// Offers, the one with the least estimate first; keeps its memory when it is cleared.
struct OfferQueue : std::priority_queue<Offer, std::vector<Offer>, std::greater<>> {
    void clear() { c.clear(); }
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

    [[nodiscard]] std::vector<int> openFacesHolding(
        const Surface& surface, const SurfacePoint& point
    ) {
        std::vector<int> faces = facesHolding(surface, point);
        std::erase_if(faces, [this](int f) { return !isOpen(f); });
        return faces;
    }

    [[nodiscard]] const TravelCosts& costs() const { return costs_; }

private:
    TravelCosts costs_;
    SparseMap<double> known_;
};

}  // namespace bspline_curve

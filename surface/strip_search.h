// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/surface.h"

#include <optional>
#include <vector>

namespace bspline_curve {

/// Finds strips of faces, each joined to the next by an edge, along which the way from one point to
/// another over midpoints of edges costs least (A*). Holds work arrays of O(#F), so keep one for
/// many queries.
class StripSearch {
public:
    /// `faceCosts`: what a unit of length costs in each face, positive, infinite where no way may
    /// enter; empty: 1 everywhere.
    StripSearch(const Surface& surface, std::vector<double> faceCosts);

    /// The strip, from a face that holds the start to one that holds the goal, or nothing if there
    /// is none. O(k log k), k the faces nearer to the start than the goal is.
    [[nodiscard]] std::optional<std::vector<int>> find(
        const SurfacePoint& start, const SurfacePoint& goal
    );

    /// The faces that hold a point and may be entered.
    [[nodiscard]] std::vector<int> openFacesHolding(const SurfacePoint& point) const;

    [[nodiscard]] double costOf(int face) const {
        return faceCosts_.empty() ? 1.0 : faceCosts_[static_cast<std::size_t>(face)];
    }

    [[nodiscard]] bool isOpen(int face) const;

private:
    // A crossing 3 f + k leaves face f over the edge opposite to its corner k.
    struct Arrival {
        double cost;
        int crossing;  // by which the way arrives
        int before;    // the crossing before that, or -1
    };

    struct Offer {
        double estimate;  // of the whole way
        double cost;
        int crossing;
        bool isWhole = false;  // the goal lies behind the crossing, and the estimate is exact

        bool operator>(const Offer& other) const {
            return estimate != other.estimate ? estimate > other.estimate
                                              : crossing > other.crossing;
        }
    };

    [[nodiscard]] Vec3 middle(int crossing) const;
    [[nodiscard]] int faceBehind(int crossing) const;
    [[nodiscard]] Arrival& arrivalAt(int crossing);
    void offer(double cost, int crossing, int before);
    void push(const Offer& entry);
    void leave(int face, const Vec3& from, double cost, int before);
    void clear();
    [[nodiscard]] std::vector<int> stripTo(int crossing);

    const Surface& surface_;
    std::vector<double> faceCosts_;
    double leastCost_ = 1.0;
    std::vector<Arrival> arrivals_;  // at an edge, under the smaller of its two crossings
    std::vector<int> touched_;
    std::vector<Offer> queue_;  // a heap
    Vec3 goal_ = Vec3::Zero();
};

}  // namespace bspline_curve

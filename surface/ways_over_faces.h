// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/progress.h"
#include "surface/passages.h"
#include "surface/travel_costs.h"
#include "utility/sparse_map.h"

#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace bspline_curve {

/// A way over faces from one point to another.
struct FaceWay {
    std::vector<Step> steps;
    double length = 0.0;  ///< over a few points of each edge: hardly more than the shortest
};

/// What a way over faces may cross.
enum class Crossing : char {
    Joined,  ///< from a face to its neighbours
    Parted,  ///< between any two faces of an edge
    Slits,   ///< open slits as well
};

/// Finds shortest ways over the faces of a mended surface, by a search from points to points on
/// edges (A*). Keeps its memory: use one for many ways.
class WaysOverFaces {
public:
    /// Refers to the surface and the edges. `avoid`: faces that ways do not enter, ascending.
    WaysOverFaces(const Surface& surface, const PartedEdges& parted, std::span<const int> avoid);

    /// The shortest way, or none of at most `longest`. Looks only at faces from which that can be
    /// reached, and where it is finite at no more than a million points. Throws Cancelled.
    [[nodiscard]] std::optional<FaceWay> find(
        const SurfacePoint& start,
        const SurfacePoint& goal,
        Crossing crossing,
        double longest = std::numeric_limits<double>::infinity(),
        const Progress& progress = {}
    );

private:
    struct Arrival {
        double cost = std::numeric_limits<double>::infinity();
        int side = -1;        // by which the way arrives
        int before = -1;      // the node before, or -1
        bool isLeft = false;  // the way goes on: nothing changes any more
    };

    [[nodiscard]] std::vector<int> facesAt(const SurfacePoint& point) const;
    [[nodiscard]] bool mayEnter(int face) const;
    [[nodiscard]] int partedAt(int side) const;
    [[nodiscard]] std::vector<int> sidesAcross(int side) const;
    [[nodiscard]] int edgeOf(int side) const;
    [[nodiscard]] double shareOf(int node) const;
    [[nodiscard]] Vec3 place(int side, int node) const;
    void leave(int face, const Vec3& from, double cost, int before);
    [[nodiscard]] FaceWay wayTo(int node, double length) const;

    const Surface& surface_;
    const PartedEdges& parted_;
    std::span<const int> avoid_;
    int pointsOnEdge_;
    // Of one query.
    Crossing crossing_ = Crossing::Joined;
    Vec3 goal_ = Vec3::Zero();
    std::vector<int> goalFaces_;
    double longest_ = 0.0;
    SparseMap<Arrival> arrivals_;  // at nodes: points on edges
    OfferQueue queue_;
};

}  // namespace bspline_curve

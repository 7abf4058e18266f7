// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/paper/edge_path.h"

#include "shell/shell.h"
#include "surface/surface_point.h"
#include "surface/travel_costs.h"
#include "utility/sparse_map.h"

#include <algorithm>
#include <limits>

namespace bspline_curve {
namespace {

// How a vertex is reached: from another one, or from the start, in a face that holds both.
struct Arrival {
    double distance;
    int from;  // vertex, or -1: the start
    int face;
};

// Dijkstra's algorithm on the vertices of the faces that have a prism.
class EdgeSearch {
public:
    EdgeSearch(const CurveProblem& problem, const SurfacePoint& from, const SurfacePoint& to)
        : problem_(problem), extended_(*problem.extended), goal_(extended_.faces[to.face]) {
        const Vec3 start = extended_.position(from);
        for (const int v : extended_.faces[from.face]) {
            reach(v, {(extended_.vertices[v] - start).norm(), -1, from.face});
        }
        end_ = extended_.position(to);
    }

    // The corner of the goal's face by which the shortest way leads there, or -1.
    int run() {
        int best = -1;
        double shortest = std::numeric_limits<double>::infinity();
        while (!queue_.empty() && queue_.top().cost < shortest) {
            const Offer offer = queue_.top();
            queue_.pop();
            const int v = offer.place;
            const Arrival arrival = *arrivals_.find(v);
            if (offer.cost > arrival.distance) {
                continue;  // reached by a shorter way since
            }
            if (cornerOf(goal_, v) >= 0) {
                const double whole = arrival.distance + (extended_.vertices[v] - end_).norm();
                if (whole < shortest) {
                    shortest = whole;
                    best = v;
                }
            }
            goOn(v, arrival);
        }
        return best;
    }

    [[nodiscard]] const Arrival& arrival(int v) const { return *arrivals_.find(v); }

private:
    // To all neighbours, turning round the vertex both ways from a face that holds it.
    void goOn(int v, const Arrival& arrival) {
        for (const int side : {1, 2}) {
            int face = arrival.face;
            do {
                const int corner = cornerOf(extended_.faces[face], v);
                for (const int other : {1, 2}) {
                    const int w = extended_.faces[face][(corner + other) % 3];
                    const double step = (extended_.vertices[w] - extended_.vertices[v]).norm();
                    reach(w, {arrival.distance + step, v, face});
                }
                face = extended_.faceNeighbours[face][(corner + side) % 3];
            } while (face >= 0 && isOpen(face) && face != arrival.face);
        }
    }

    [[nodiscard]] bool isOpen(int face) const {
        return !problem_.shell->isGhost(face) && !problem_.shell->isBlocked(face);
    }

    void reach(int v, const Arrival& arrival) {
        Arrival& known = arrivals_.at(v, {std::numeric_limits<double>::infinity(), -1, -1});
        if (arrival.distance < known.distance) {
            known = arrival;
            queue_.push({.estimate = arrival.distance, .cost = arrival.distance, .place = v});
        }
    }

    const CurveProblem& problem_;
    const ExtendedSurface& extended_;
    const Triangle& goal_;
    Vec3 end_;
    SparseMap<Arrival> arrivals_;
    OfferQueue queue_;
};

}  // namespace

std::optional<EdgePath> EdgePath::shortest(
    const CurveProblem& problem, const SurfacePoint& from, const SurfacePoint& to
) {
    EdgePath path;
    if (from.face == to.face) {
        path.add(problem, from.face, from.barycentric, to.barycentric);
        return path;
    }
    EdgeSearch search(problem, from, to);
    int v = search.run();
    if (v < 0) {
        return std::nullopt;
    }
    const std::vector<Triangle>& faces = problem.extended->faces;
    const auto cornerIn = [&](int face, int vertex) -> Vec3 {
        return Vec3::Unit(cornerOf(faces[face], vertex));
    };
    // Backwards from the end.
    path.add(problem, to.face, cornerIn(to.face, v), to.barycentric);
    while (true) {
        const Arrival& arrival = search.arrival(v);
        const bool isFirst = arrival.from < 0;
        path.add(
            problem,
            arrival.face,
            isFirst ? from.barycentric : cornerIn(arrival.face, arrival.from),
            cornerIn(arrival.face, v)
        );
        if (isFirst) {
            break;
        }
        v = arrival.from;
    }
    std::ranges::reverse(path.parts_);
    return path;
}

void EdgePath::add(const CurveProblem& problem, int face, const Vec3& begin, const Vec3& end) {
    const ExtendedSurface& extended = *problem.extended;
    const double length =
        (extended.position({face, end}) - extended.position({face, begin})).norm();
    parts_.push_back({face, begin, end, length});
}

double EdgePath::length() const {
    double sum = 0.0;
    for (const Part& part : parts_) {
        sum += part.length;
    }
    return sum;
}

SurfacePoint EdgePath::at(double distance) const {
    std::size_t i = 0;
    while (i + 1 < parts_.size() && distance > parts_[i].length) {
        distance -= parts_[i].length;
        ++i;
    }
    const Part& part = parts_[i];
    const double s = part.length > 0.0 ? std::clamp(distance / part.length, 0.0, 1.0) : 0.0;
    return {part.face, (1.0 - s) * part.begin + s * part.end};
}

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#include "field/feature_distance.h"

#include "utility/index_sets.h"
#include "utility/infinity.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <queue>
#include <utility>

namespace bspline_curve {

namespace {

/// Collects both ends of the edges for which isFeature(face, neighbour) holds.
template <class IsFeature>
std::vector<int> endsOfEdges(const Surface& surface, const IsFeature& isFeature) {
    std::vector<int> ends;
    for (int face = 0; face < surface.faceCount(); ++face) {
        const Triangle& corners = surface.faces()[face];
        for (std::size_t k = 0; k < 3; ++k) {
            if (isFeature(face, surface.faceNeighbours()[face][k])) {
                ends.insert(ends.end(), {corners[(k + 1) % 3], corners[(k + 2) % 3]});
            }
        }
    }
    sortUnique(ends);
    return ends;
}

/// The distance at a corner of a face whose other corners are at `toFirst` and `toSecond` from it
/// and have the given distances: that of a straight front which passes over them to the corner from
/// within the face, else along one of the edges.
double distanceAcross(
    const Vec3& toFirst, const Vec3& toSecond, double firstDistance, double secondDistance
) {
    const double alongEdges =
        std::min(firstDistance + toFirst.norm(), secondDistance + toSecond.norm());
    if (!std::isfinite(firstDistance) || !std::isfinite(secondDistance)) {
        return alongEdges;
    }
    // The distance is linear in the face, d at the corner, and its gradient g has the length 1:
    // with G = (the Gram matrix of the edges)^-1 and s = known distances - d, s' G s = 1.
    Eigen::Matrix2d gram;
    gram << toFirst.squaredNorm(), toFirst.dot(toSecond), toFirst.dot(toSecond),
        toSecond.squaredNorm();
    const Eigen::Matrix2d inverse = gram.inverse();
    const Eigen::Vector2d known(firstDistance, secondDistance);
    const Eigen::Vector2d ones = Eigen::Vector2d::Ones();
    const double a = ones.dot(inverse * ones);
    const double b = ones.dot(inverse * known);
    const double c = known.dot(inverse * known) - 1.0;
    const double discriminant = b * b - a * c;
    if (!(discriminant >= 0.0)) {
        return alongEdges;
    }
    const double distance = (b + std::sqrt(discriminant)) / a;
    // The way back from the corner leads between the edges.
    const Eigen::Vector2d share = inverse * (known - distance * ones);
    const bool isWithin = share[0] <= 0.0 && share[1] <= 0.0;
    return isWithin ? std::min(distance, alongEdges) : alongEdges;
}

/// Vertices in order of their distance; improved ones are visited again.
class Front {
public:
    Front(const Surface& surface, double reach)
        : surface_(surface), reach_(reach), distances_(surface.vertices().size(), kInfinity) {}

    void offer(int vertex, double distance) {
        // Smaller gains are rounding, which could go round in circles.
        constexpr double kGain = 1.0 - 1e-12;
        if (distance <= reach_ && distance < kGain * distances_[vertex]) {
            distances_[vertex] = distance;
            queue_.emplace(distance, vertex);
        }
    }

    void advance() {
        while (!queue_.empty()) {
            const auto [distance, vertex] = queue_.top();
            queue_.pop();
            if (distance == distances_[vertex]) {
                spreadFrom(vertex);
            }
        }
    }

    [[nodiscard]] std::vector<double> takeDistances() { return std::move(distances_); }

private:
    void spreadFrom(int vertex) {
        for (const int face : surface_.facesAround(vertex)) {
            const Triangle& corners = surface_.faces()[face];
            for (std::size_t k = 0; k < 3; ++k) {
                if (corners[k] != vertex) {
                    const int first = corners[(k + 1) % 3];
                    const int second = corners[(k + 2) % 3];
                    const Vec3& corner = surface_.vertices()[corners[k]];
                    const double distance = distanceAcross(
                        surface_.vertices()[first] - corner,
                        surface_.vertices()[second] - corner,
                        distances_[first],
                        distances_[second]
                    );
                    offer(corners[k], distance);
                }
            }
        }
    }

    using Entry = std::pair<double, int>;

    const Surface& surface_;
    double reach_;
    std::vector<double> distances_;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
};

}  // namespace

std::vector<int> creaseVertices(const Surface& surface, double angleDegrees) {
    const double cosine = std::cos(angleDegrees * std::numbers::pi / 180.0);
    return endsOfEdges(surface, [&](int face, int neighbour) {
        return neighbour >= 0 &&
               surface.faceNormal(face).dot(surface.faceNormal(neighbour)) < cosine;
    });
}

std::vector<int> boundaryVertices(const Surface& surface) {
    return endsOfEdges(surface, [](int /*face*/, int neighbour) { return neighbour < 0; });
}

std::vector<double> distancesTo(
    const Surface& surface, const std::vector<int>& sources, double reach
) {
    Front front(surface, reach);
    for (const int source : sources) {
        front.offer(source, 0.0);
    }
    front.advance();
    return front.takeDistances();
}

}  // namespace bspline_curve

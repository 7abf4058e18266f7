// SPDX-License-Identifier: GPL-3.0-or-later
#include "fill/planar_triangulation.h"

#include "fill/inner_edges.h"
#include "surface/mesh_checks.h"
#include "surface/predicates.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <utility>

namespace bspline_curve {

namespace {

/// Changes of a bend (1 - cos) below this are none.
constexpr double kBendMargin = 1e-6;
constexpr double kCotangentMargin = 1e-9;
constexpr int kMostPasses = 100;

int turn(const Vec3& a, const Vec3& b, const Vec3& c) {
    return projectedOrientationSign(a, b, c, 2);
}

/// Twice the area over the longest side's square: 0.87 for an equilateral triangle.
double shapeOf(const Vec3& a, const Vec3& b, const Vec3& c) {
    const double longest =
        std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    return longest > 0.0 ? (b - a).cross(c - a).norm() / longest : 0.0;
}

/// Cuts ears off a polygon, the best-shaped one first.
class EarCutter {
public:
    EarCutter(
        const std::vector<Vec3>& polygon, const std::vector<Vec3>& seen, const EdgeSet& forbidden
    )
        : polygon_(polygon),
          seen_(seen),
          forbidden_(forbidden),
          count_(static_cast<int>(seen.size())),
          next_(count_),
          last_(count_),
          shape_(count_, kNoEar) {
        for (int i = 0; i < count_; ++i) {
            next_[i] = (i + 1) % count_;
            last_[i] = (i + count_ - 1) % count_;
        }
        for (int i = 0; i < count_; ++i) {
            shape_[i] = ear(i);
        }
    }

    [[nodiscard]] std::vector<Triangle> run() {
        std::vector<Triangle> triangles;
        std::vector<int> left(count_);
        std::iota(left.begin(), left.end(), 0);
        while (left.size() > 2) {
            const auto best = std::ranges::max_element(left, {}, [&](int i) { return shape_[i]; });
            const int tip = *best;
            if (shape_[tip] <= kNoEar) {
                return {};
            }
            const int before = last_[tip];
            const int after = next_[tip];
            triangles.push_back({before, tip, after});
            left.erase(best);
            next_[before] = after;
            last_[after] = before;
            shape_[before] = ear(before);
            shape_[after] = ear(after);
        }
        return triangles;
    }

private:
    static constexpr double kNoEar = 0.0;

    /// How well-shaped the ear at a point is; kNoEar where there is none.
    [[nodiscard]] double ear(int tip) const {
        const int before = last_[tip];
        const int after = next_[tip];
        if (turn(seen_[before], seen_[tip], seen_[after]) <= 0 ||
            !hasArea(polygon_[before], polygon_[tip], polygon_[after])) {
            return kNoEar;
        }
        const auto [low, high] = std::minmax(before, after);
        const bool isSide = next_[after] == before;  // three points are left
        if (!isSide && forbidden_.contains({low, high})) {
            return kNoEar;
        }
        for (int other = next_[after]; other != before; other = next_[other]) {
            if (turn(seen_[before], seen_[tip], seen_[other]) >= 0 &&
                turn(seen_[tip], seen_[after], seen_[other]) >= 0 &&
                turn(seen_[after], seen_[before], seen_[other]) >= 0) {
                return kNoEar;
            }
        }
        return shapeOf(seen_[before], seen_[tip], seen_[after]);
    }

    const std::vector<Vec3>& polygon_;
    const std::vector<Vec3>& seen_;
    const EdgeSet& forbidden_;
    int count_;
    std::vector<int> next_, last_;
    std::vector<double> shape_;
};

/// Flips edges of a triangulation, in passes.
class BendFlips {
public:
    BendFlips(
        const std::vector<Vec3>& polygon,
        const std::vector<Vec3>& seen,
        const EdgeSet& forbidden,
        std::vector<Triangle>& faces
    )
        : polygon_(polygon), seen_(seen), forbidden_(forbidden), faces_(faces) {}

    void run() {
        for (int pass = 0; pass < kMostPasses; ++pass) {
            if (!flipSome()) {
                return;
            }
        }
    }

private:
    bool flipSome() {
        const std::vector<InnerEdge> edges = innerEdges(faces_);
        beyond_.clear();
        edges_.clear();
        for (const InnerEdge& edge : edges) {
            beyond_[{edge.a, edge.b}] = edge.d;
            beyond_[{edge.b, edge.a}] = edge.c;
            const auto [low, high] = std::minmax(edge.a, edge.b);
            edges_.insert({low, high});
        }
        // A flip changes the bends around; those beside it wait for the next pass.
        std::vector<char> isNear(faces_.size(), 0);
        std::map<std::pair<int, int>, int> faceAt;
        for (int f = 0; f < static_cast<int>(faces_.size()); ++f) {
            for (int k = 0; k < 3; ++k) {
                faceAt[{faces_[f][k], faces_[f][(k + 1) % 3]}] = f;
            }
        }
        bool isFlipped = false;
        for (const InnerEdge& edge : edges) {
            if (isNear[edge.first] != 0 || isNear[edge.second] != 0 || !isBetterFlipped(edge)) {
                continue;
            }
            const auto& [a, b, c, d, first, second] = edge;
            for (const auto& side :
                 {std::pair{c, b}, std::pair{a, c}, std::pair{b, d}, std::pair{d, a}}) {
                const auto found = faceAt.find(side);
                if (found != faceAt.end()) {
                    isNear[found->second] = 1;
                }
            }
            isNear[first] = isNear[second] = 1;
            faces_[first] = {c, d, b};
            faces_[second] = {d, c, a};
            isFlipped = true;
        }
        return isFlipped;
    }

    [[nodiscard]] Vec3 normal(int a, int b, int c) const {
        return (polygon_[b] - polygon_[a]).cross(polygon_[c] - polygon_[a]).stableNormalized();
    }

    /// Bend towards the face across the directed side from a to b; 0 on the rim.
    [[nodiscard]] double bendAcross(const Vec3& normalHere, int a, int b) const {
        const auto found = beyond_.find({a, b});
        return found == beyond_.end() ? 0.0 : 1.0 - normalHere.dot(normal(b, a, found->second));
    }

    [[nodiscard]] double cotangentAt(int apex, int b, int c) const {
        const Vec3 to = polygon_[b] - polygon_[apex];
        const Vec3 from = polygon_[c] - polygon_[apex];
        return to.dot(from) / std::max(to.cross(from).norm(), 1e-300);
    }

    [[nodiscard]] bool isBetterFlipped(const InnerEdge& edge) const {
        const auto& [a, b, c, d, first, second] = edge;
        const auto [low, high] = std::minmax(c, d);
        if (turn(seen_[c], seen_[d], seen_[b]) <= 0 || turn(seen_[d], seen_[c], seen_[a]) <= 0 ||
            forbidden_.contains({low, high}) || edges_.contains({low, high}) ||
            !hasArea(polygon_[c], polygon_[d], polygon_[b]) ||
            !hasArea(polygon_[d], polygon_[c], polygon_[a])) {
            return false;
        }
        const Vec3 abc = normal(a, b, c);
        const Vec3 bad = normal(b, a, d);
        const Vec3 cdb = normal(c, d, b);
        const Vec3 dca = normal(d, c, a);
        const double before = std::max(
            {1.0 - abc.dot(bad),
             bendAcross(abc, b, c),
             bendAcross(abc, c, a),
             bendAcross(bad, a, d),
             bendAcross(bad, d, b)}
        );
        const double after = std::max(
            {1.0 - cdb.dot(dca),
             bendAcross(cdb, b, c),
             bendAcross(dca, c, a),
             bendAcross(dca, a, d),
             bendAcross(cdb, d, b)}
        );
        if (std::abs(after - before) > kBendMargin) {
            return after < before;
        }
        return before <= kBendMargin &&
               cotangentAt(c, a, b) + cotangentAt(d, a, b) < -kCotangentMargin;
    }

    const std::vector<Vec3>& polygon_;
    const std::vector<Vec3>& seen_;
    const EdgeSet& forbidden_;
    std::vector<Triangle>& faces_;
    std::map<std::pair<int, int>, int> beyond_;  // third corner of the face across a directed side
    EdgeSet edges_;
};

}  // namespace

PlanarView planarView(const std::vector<Vec3>& polygon) {
    PlanarView view;
    Vec3 middle = Vec3::Zero();
    for (const Vec3& point : polygon) {
        middle += point / static_cast<double>(polygon.size());
    }
    Vec3 area = Vec3::Zero();
    double extent = 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        area += (polygon[i] - middle).cross(polygon[(i + 1) % polygon.size()] - middle);
        extent = std::max(extent, (polygon[i] - middle).norm());
    }
    const Vec3 normal = area.stableNormalized();
    const Vec3 x = normal.unitOrthogonal();
    const Vec3 y = normal.cross(x);
    for (const Vec3& point : polygon) {
        const Vec3 from = point - middle;
        view.seen.emplace_back(area.isZero(0.0) ? Vec3::Zero() : Vec3(from.dot(x), from.dot(y), 0));
        view.deviation = std::max(view.deviation, std::abs(from.dot(normal)) / extent);
    }
    return view;
}

std::vector<Triangle> triangulateSeen(
    const std::vector<Vec3>& polygon, const PlanarView& view, const EdgeSet& forbidden
) {
    std::vector<Triangle> faces = EarCutter(polygon, view.seen, forbidden).run();
    BendFlips(polygon, view.seen, forbidden, faces).run();
    return faces;
}

}  // namespace bspline_curve

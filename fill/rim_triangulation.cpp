// SPDX-License-Identifier: GPL-3.0-or-later
#include "fill/rim_triangulation.h"

#include "surface/mesh_checks.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

namespace bspline_curve {

namespace {

constexpr double kImpossible = std::numeric_limits<double>::infinity();
/// A triangle is flat where twice its area is less than this of its longest side's square.
constexpr double kFlatRelative = 1e-10;

/// The triangulation of some points of a polygon, in order.
class LeastArea {
public:
    LeastArea(const std::vector<Vec3>& polygon, const EdgeSet& forbidden, std::vector<int> places)
        : polygon_(polygon),
          forbidden_(forbidden),
          places_(std::move(places)),
          count_(static_cast<int>(places_.size())),
          cost_(static_cast<std::size_t>(count_) * count_, 0.0),
          middle_(static_cast<std::size_t>(count_) * count_, -1) {
        for (int width = 2; width < count_; ++width) {
            for (int i = 0; i + width < count_; ++i) {
                choose(i, i + width);
            }
        }
    }

    [[nodiscard]] bool isPossible() const { return cost_[at(0, count_ - 1)] < kImpossible; }

    [[nodiscard]] std::vector<Triangle> triangles() const {
        std::vector<Triangle> result;
        std::vector<std::pair<int, int>> open{{0, count_ - 1}};
        while (!open.empty()) {
            const auto [i, j] = open.back();
            open.pop_back();
            if (j - i < 2) {
                continue;
            }
            const int m = middle_[at(i, j)];
            result.push_back({places_[i], places_[m], places_[j]});
            open.emplace_back(i, m);
            open.emplace_back(m, j);
        }
        return result;
    }

private:
    [[nodiscard]] std::size_t at(int i, int j) const {
        return static_cast<std::size_t>(i) * count_ + j;
    }

    /// Twice the area of a triangle; impossible where it is flat, or not below `limit`.
    [[nodiscard]] double costOf(int i, int m, int j, double limit) const {
        const Vec3& a = polygon_[places_[i]];
        const Vec3& b = polygon_[places_[m]];
        const Vec3& c = polygon_[places_[j]];
        const double area = (b - a).cross(c - a).norm();
        if (area >= limit) {
            return kImpossible;
        }
        const double longest =
            std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
        return area > kFlatRelative * longest && hasArea(a, b, c) ? area : kImpossible;
    }

    /// The best triangle on the chord from i to j.
    void choose(int i, int j) {
        double& best = cost_[at(i, j)];
        best = kImpossible;
        const auto [low, high] = std::minmax(places_[i], places_[j]);
        const bool isWhole = i == 0 && j == count_ - 1;  // a side of the polygon, no chord
        if (!isWhole && !forbidden_.empty() && forbidden_.contains({low, high})) {
            return;
        }
        for (int m = i + 1; m < j; ++m) {
            const double parts = cost_[at(i, m)] + cost_[at(m, j)];
            if (parts >= best) {
                continue;
            }
            const double cost = parts + costOf(i, m, j, best - parts);
            if (cost < best) {
                best = cost;
                middle_[at(i, j)] = m;
            }
        }
    }

    const std::vector<Vec3>& polygon_;
    const EdgeSet& forbidden_;
    std::vector<int> places_;
    int count_;
    std::vector<double> cost_;
    std::vector<int> middle_;
};

}  // namespace

std::vector<Triangle> triangulateRim(
    const std::vector<Vec3>& polygon, const EdgeSet& forbidden, int most
) {
    const auto count = static_cast<int>(polygon.size());
    const int coarseCount = std::min(count, most);
    const auto placeOf = [&](int i) {
        return static_cast<int>(static_cast<std::int64_t>(i) * count / coarseCount);
    };
    std::vector<int> coarse;
    for (int i = 0; i < coarseCount; ++i) {
        coarse.push_back(placeOf(i));
    }
    const LeastArea first(polygon, forbidden, coarse);
    if (!first.isPossible()) {
        return {};
    }
    if (coarseCount == count) {
        return first.triangles();
    }
    // A triangle with points left out along its sides becomes a polygon of its own.
    std::vector<int> next(count);  // of each coarse place
    for (int i = 0; i < coarseCount; ++i) {
        next[coarse[i]] = i + 1 < coarseCount ? coarse[i + 1] : count;
    }
    std::vector<Triangle> result;
    for (const Triangle& triangle : first.triangles()) {
        std::vector<int> places;
        for (int k = 0; k < 3; ++k) {
            const int from = triangle[k];
            const int to = triangle[(k + 1) % 3];
            places.push_back(from);
            if (next[from] % count == to) {
                for (int place = from + 1; place < next[from]; ++place) {
                    places.push_back(place);
                }
            }
        }
        const LeastArea part(polygon, forbidden, places);
        if (!part.isPossible()) {
            return {};
        }
        for (const Triangle& each : part.triangles()) {
            result.push_back(each);
        }
    }
    return result;
}

}  // namespace bspline_curve

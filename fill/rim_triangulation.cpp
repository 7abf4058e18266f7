// SPDX-License-Identifier: GPL-3.0-or-later
#include "fill/rim_triangulation.h"

#include "fill/inner_edges.h"
#include "surface/mesh_checks.h"
#include "utility/index_sets.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>

namespace bspline_curve {

namespace {

/// A triangle is flat where twice its area is less than this of its longest side's square.
constexpr double kFlatRelative = 1e-10;
/// Bends (1 - cos of the angle between neighbours) below this count as none: 0.08 degrees.
constexpr double kNoBend = 1e-6;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// What a triangulation costs; the largest bend first.
struct Cost {
    double bend = kInfinity;
    double area = kInfinity;
    auto operator<=>(const Cost&) const = default;
};

/// The triangulation of some points of a polygon, in order.
class LeastBend {
public:
    LeastBend(
        const std::vector<Vec3>& polygon,
        const EdgeSet& forbidden,
        const TriangleTest& isAllowed,
        const GoOn& goOn,
        std::vector<int> places
    )
        : polygon_(polygon),
          forbidden_(forbidden),
          isAllowed_(isAllowed),
          places_(std::move(places)),
          count_(static_cast<int>(places_.size())),
          best_(static_cast<std::size_t>(count_) * count_) {
        for (int i = 0; i + 1 < count_; ++i) {
            best_[at(i, i + 1)].cost = best_[at(i + 1, i)].cost = {.bend = 0.0, .area = 0.0};
        }
        for (int width = 2; width < count_; ++width) {
            goOn();
            for (int i = 0; i + width < count_; ++i) {
                choose(i, i + width);
                best_[at(i + width, i)] = best_[at(i, i + width)];
            }
        }
    }

    [[nodiscard]] bool isPossible() const { return best_[at(0, count_ - 1)].cost.bend < kInfinity; }

    [[nodiscard]] std::vector<Triangle> triangles() const {
        std::vector<Triangle> result;
        std::vector<std::pair<int, int>> open{{0, count_ - 1}};
        while (!open.empty()) {
            const auto [i, j] = open.back();
            open.pop_back();
            if (j - i < 2) {
                continue;
            }
            const int m = best_[at(i, j)].middle;
            result.push_back({places_[i], places_[m], places_[j]});
            open.emplace_back(i, m);
            open.emplace_back(m, j);
        }
        return result;
    }

private:
    /// The best triangulation of the points from i to j; also at (j, i), so that those that lead to
    /// one point follow each other.
    struct Best {
        Cost cost;
        int middle = -1;             ///< the third corner of its triangle on the chord from i to j
        Vec3 normal = Vec3::Zero();  ///< of that triangle; zero on a side of the polygon
    };

    [[nodiscard]] std::size_t at(int i, int j) const {
        return static_cast<std::size_t>(i) * count_ + j;
    }

    /// Zero on sides of the polygon, which have no triangle beyond.
    [[nodiscard]] static double bendBetween(const Vec3& normal, const Best& beyond) {
        if (beyond.middle < 0) {
            return 0.0;
        }
        const double bend = 1.0 - normal.dot(beyond.normal);
        return bend > kNoBend ? bend : 0.0;
    }

    /// The best triangle on the chord from i to j.
    void choose(int i, int j) {
        Best& best = best_[at(i, j)];
        const auto [low, high] = std::minmax(places_[i], places_[j]);
        const bool isWhole = i == 0 && j == count_ - 1;  // a side of the polygon, no chord
        if (!isWhole && !forbidden_.empty() && forbidden_.contains({low, high})) {
            return;
        }
        for (int m = i + 1; m < j; ++m) {
            consider(best, i, m, j);
        }
    }

    void consider(Best& best, int i, int m, int j) const {
        const Best& left = best_[at(i, m)];
        const Best& right = best_[at(j, m)];
        Cost cost{
            .bend = std::max(left.cost.bend, right.cost.bend),
            .area = left.cost.area + right.cost.area
        };
        if (!(cost < best.cost)) {
            return;
        }
        const Vec3& a = polygon_[places_[i]];
        const Vec3& b = polygon_[places_[m]];
        const Vec3& c = polygon_[places_[j]];
        Vec3 normal = (b - a).cross(c - a);
        const double area = normal.norm();
        const double longest =
            std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
        if (!(area > kFlatRelative * longest)) {
            return;
        }
        normal /= area;
        cost.area += area;
        cost.bend = std::max({cost.bend, bendBetween(normal, left), bendBetween(normal, right)});
        if (!(cost < best.cost) || !hasArea(a, b, c)) {
            return;
        }
        if (isAllowed_ && !isAllowed_({places_[i], places_[m], places_[j]})) {
            return;
        }
        best = {.cost = cost, .middle = m, .normal = normal};
    }

    const std::vector<Vec3>& polygon_;
    const EdgeSet& forbidden_;
    const TriangleTest& isAllowed_;
    std::vector<int> places_;
    int count_;
    std::vector<Best> best_;
};

}  // namespace

std::vector<Triangle> triangulateRim(
    const std::vector<Vec3>& polygon,
    const EdgeSet& forbidden,
    const GoOn& goOn,
    int most,
    const TriangleTest& isAllowed
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
    const LeastBend first(polygon, forbidden, isAllowed, goOn, coarse);
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
        const LeastBend part(polygon, forbidden, isAllowed, goOn, places);
        if (!part.isPossible()) {
            return {};
        }
        for (const Triangle& each : part.triangles()) {
            result.push_back(each);
        }
    }
    return result;
}

std::vector<int> grown(
    const std::vector<Triangle>& faces, const std::vector<int>& region, int rings
) {
    std::vector<char> isIn(faces.size(), 0);
    for (const int face : region) {
        isIn[face] = 1;
    }
    const std::vector<InnerEdge> edges = innerEdges(faces);
    for (int ring = 0; ring < rings; ++ring) {
        const std::vector<char> before = isIn;
        for (const InnerEdge& edge : edges) {
            if (before[edge.first] != 0 || before[edge.second] != 0) {
                isIn[edge.first] = isIn[edge.second] = 1;
            }
        }
    }
    return indicesWhere<int>(faces.size(), [&](std::size_t f) { return isIn[f] != 0; });
}

std::vector<Triangle> retriangulated(
    const std::vector<Vec3>& points,
    const std::vector<Triangle>& faces,
    const EdgeSet& forbidden,
    const std::vector<int>& region,
    const TriangleTest& isAllowed,
    const GoOn& goOn
) {
    // Faces of the region that are joined have one number, that of the first.
    std::vector<int> groupOf(faces.size(), -1);
    for (const int face : region) {
        groupOf[face] = face;
    }
    const std::vector<InnerEdge> edges = innerEdges(faces);
    for (bool isJoined = true; isJoined;) {
        isJoined = false;
        for (const auto& [a, b, c, d, first, second] : edges) {
            int& one = groupOf[first];
            int& other = groupOf[second];
            if (one >= 0 && other >= 0 && one != other) {
                one = other = std::min(one, other);
                isJoined = true;
            }
        }
    }
    std::vector<Triangle> result;
    std::map<int, std::vector<int>> cornersOf;  // by group
    for (std::size_t f = 0; f < faces.size(); ++f) {
        if (groupOf[f] < 0) {
            result.push_back(faces[f]);
        } else {
            std::vector<int>& corners = cornersOf[groupOf[f]];
            corners.insert(corners.end(), faces[f].begin(), faces[f].end());
        }
    }
    for (auto& [group, corners] : cornersOf) {
        // There are no inner points: the outline passes the corners in the polygon's order.
        sortUnique(corners);
        std::vector<Vec3> outline;
        for (const int corner : corners) {
            outline.push_back(points[corner]);
        }
        EdgeSet chords;
        for (const auto& [low, high] : forbidden) {
            const int from = indexIn(corners, low);
            const int to = indexIn(corners, high);
            if (from >= 0 && to >= 0) {
                chords.insert({from, to});
            }
        }
        const auto inPolygon = [&](const Triangle& places) {
            return Triangle{corners[places[0]], corners[places[1]], corners[places[2]]};
        };
        const std::vector<Triangle> part =
            triangulateRim(outline, chords, goOn, kMostRimPoints, [&](const Triangle& places) {
                return isAllowed(inPolygon(places));
            });
        if (part.empty()) {
            return {};
        }
        for (const Triangle& places : part) {
            result.push_back(inPolygon(places));
        }
    }
    return result;
}

}  // namespace bspline_curve

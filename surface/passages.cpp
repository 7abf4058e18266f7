// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/passages.h"

#include "surface/seams.h"
#include "utility/index_sets.h"

#include <algorithm>
#include <span>
#include <utility>

namespace bspline_curve {

namespace {

/// The half-edges with an end that is one vertex with others in the given mesh, by roots, sorted.
std::vector<HalfEdge> halfEdgesByRoots(const Surface& surface, const std::vector<int>& roots) {
    std::vector<int> counts(roots.size(), 0);
    for (const int root : roots) {
        ++counts[root];
    }
    std::vector<HalfEdge> halfEdges;
    for (int f = 0; f < surface.faceCount(); ++f) {
        for (int k = 0; k < 3; ++k) {
            const Triangle& face = surface.faces()[f];
            const auto [low, high] =
                std::minmax(roots[face[(k + 1) % 3]], roots[face[(k + 2) % 3]]);
            if (counts[low] > 1 || counts[high] > 1) {
                halfEdges.push_back({low, high, f, k});
            }
        }
    }
    std::ranges::sort(halfEdges);
    return halfEdges;
}

/// Whether a pair of sides has a side in common with another one.
bool meet(const std::pair<int, int>& a, const std::pair<int, int>& b) {
    return a.first == b.first || a.first == b.second || a.second == b.first || a.second == b.second;
}

/// The stretches of one edge, for steps over it by share.
std::vector<Stretch> stretchesOf(const std::vector<Step>& steps) {
    struct Crossing {
        double first, last;
        std::pair<int, int> sides;
    };

    std::vector<Crossing> crossings;  // those of the same sides in a row are one
    std::vector<std::pair<int, int>> pairs;
    for (const Step& step : steps) {
        const std::pair<int, int> sides = std::minmax(step.from, step.to);
        pairs.push_back(sides);
        if (!crossings.empty() && crossings.back().sides == sides) {
            crossings.back().last = step.share;
        } else {
            crossings.push_back({step.share, step.share, sides});
        }
    }
    sortUnique(pairs);
    std::vector<Stretch> stretches;
    const auto meetsAnother = [&](const std::pair<int, int>& one) {
        return std::ranges::any_of(pairs, [&](const auto& p) { return p != one && meet(p, one); });
    };
    if (std::ranges::none_of(pairs, meetsAnother)) {
        for (const std::pair<int, int>& sides : pairs) {
            stretches.push_back({steps.front().edge, 0.0, 1.0, sides});
        }
        return stretches;
    }
    const auto count = static_cast<double>(crossings.size());
    const double least = 0.5 / count;
    double begin = 0.0;
    for (std::size_t i = 0; i < crossings.size(); ++i) {
        const auto left = count - static_cast<double>(i) - 1.0;
        const double middle =
            left == 0.0 ? 1.0 : 0.5 * (crossings[i].last + crossings[i + 1].first);
        const double end = std::clamp(middle, begin + least, 1.0 - left * least);
        stretches.push_back({steps.front().edge, begin, end, crossings[i].sides});
        begin = end;
    }
    return stretches;
}

}  // namespace

PartedEdges::PartedEdges(const Surface& surface, const std::vector<int>& roots, bool findsSlits) {
    const std::vector<HalfEdge> halfEdges = halfEdgesByRoots(surface, roots);
    forEachEdge(halfEdges, [&](std::span<const HalfEdge> edge) {
        const bool isParted =
            edge.size() > 2 ||
            (edge.size() == 2 && surface.faceNeighbours()[edge[0].face][edge[0].k] != edge[1].face);
        if (isParted) {
            std::vector<int> sides;
            for (const HalfEdge& halfEdge : edge) {
                sides.push_back(sideOf(halfEdge.face, halfEdge.k));
            }
            add(surface, std::move(sides), false);
        }
    });
    std::ranges::sort(edgeOfSide_);
    if (!findsSlits) {
        return;
    }
    for (const auto& [a, b, isParallel] : findSeams(surface.mesh())) {
        if (const int side = sideOf(a.face, a.k); edgeAt(side) < 0) {
            add(surface, {side, sideOf(b.face, b.k)}, true);
        }
    }
    std::ranges::sort(edgeOfSide_);
}

void PartedEdges::add(const Surface& surface, std::vector<int> sides, bool isSlit) {
    const auto index = static_cast<int>(edges_.size());
    for (const int side : sides) {
        edgeOfSide_.emplace_back(side, index);
    }
    std::ranges::sort(sides);
    const Triangle& face = surface.faces()[sides.front() / 3];
    const Vec3& from = surface.vertices()[face[(sides.front() + 1) % 3]];
    const Vec3& to = surface.vertices()[face[(sides.front() + 2) % 3]];
    edges_.push_back({std::move(sides), isSlit, 0.5 * (from + to), (to - from).norm()});
}

int PartedEdges::edgeAt(int side) const {
    const auto found = std::ranges::lower_bound(edgeOfSide_, side, {}, &std::pair<int, int>::first);
    return found != edgeOfSide_.end() && found->first == side ? found->second : -1;
}

std::vector<Triangle> facesBeforeParting(
    const TriangleMesh& mended, const std::vector<int>& roots
) {
    std::vector<Triangle> faces = mended.faces;
    for (Triangle& face : faces) {
        for (int& v : face) {
            v = roots[v];
        }
    }
    return faces;
}

Passages passagesOf(const std::vector<Step>& steps) {
    Passages passages;
    std::vector<Step> parted;
    for (const Step& step : steps) {
        if (step.edge < 0) {
            passages.strips.emplace_back(step.from, step.to);
        } else {
            parted.push_back(step);
        }
    }
    std::ranges::stable_sort(parted, {}, [](const Step& s) { return std::pair(s.edge, s.share); });
    for (auto first = parted.begin(); first != parted.end();) {
        const auto last = std::find_if(first, parted.end(), [&](const Step& step) {
            return step.edge != first->edge;
        });
        std::ranges::copy(
            stretchesOf(std::vector<Step>(first, last)), std::back_inserter(passages.stretches)
        );
        first = last;
    }
    return passages;
}

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/shell_builder.h"

#include "surface/input_error.h"
#include "surface/predicates.h"
#include "surface/self_intersection.h"
#include "surface/triangle_tree.h"

#include <algorithm>
#include <string>

namespace bspline_curve {
namespace {

constexpr double kInvertedShrink = 0.6;
constexpr double kIntersectingShrink = 0.5;
// After this many shrinks (a length of 1e-9 edges) a place counts as impossible and its faces are
// blocked.
constexpr int kMaxOrientationRounds = 40;
constexpr int kMaxIntersectionRounds = 30;

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

// Where slot k's vertex stands in the face, slots ascending by vertex index.
Prism makePrism(const Triangle& face) {
    Prism prism;
    std::array<signed char, 3> order = {0, 1, 2};
    std::sort(order.begin(), order.end(), [&](signed char a, signed char b) {
        return face[static_cast<std::size_t>(a)] < face[static_cast<std::size_t>(b)];
    });
    for (std::size_t slot = 0; slot < 3; ++slot) {
        prism.faceCorner[slot] = order[slot];
        prism.pillars[slot] = face[static_cast<std::size_t>(order[slot])];
    }
    prism.orientation = (order[1] - order[0] + 3) % 3 == 1 ? 1 : -1;
    return prism;
}

class Builder {
public:
    Builder(const ShellBase& base, const ShellOptions& options) : base_(base) {
        const std::size_t n = base.vertices.size();
        for (auto& layer : lengths_) {
            layer.resize(n);
            for (std::size_t v = 0; v < n; ++v) {
                layer[v] = options.thickness * base.edgeLengths[v];
            }
        }
        tips_.resize(2 * n);
        for (std::size_t v = 0; v < n; ++v) {
            placeTips(v);
        }
        prisms_.reserve(base.faces.size());
        for (const Triangle& face : base.faces) {
            prisms_.push_back(makePrism(face));
        }
        blocked_.assign(base.faces.size(), 0);
        std::vector<char> unseen(n, 0);
        for (const int v : base.unseenVertices) {
            unseen[at(v)] = 1;
        }
        for (std::size_t f = 0; f < base.faces.size(); ++f) {
            for (const int v : base.faces[f]) {
                blocked_[f] = static_cast<char>(blocked_[f] | unseen[at(v)]);
            }
        }
    }

    // Shrinks pillars until every tetrahedron is positive. Only prisms with a pillar that changed
    // are tested again.
    void uprightAll(std::vector<char> changed) {
        for (int round = 0;; ++round) {
            std::vector<char> shrinkTop(base_.vertices.size(), 0);
            std::vector<char> shrinkBottom(base_.vertices.size(), 0);
            bool any = false;
            for (std::size_t f = 0; f < prisms_.size(); ++f) {
                const Prism& prism = prisms_[f];
                if (blocked_[f] != 0 ||
                    (changed[at(prism.pillars[0])] | changed[at(prism.pillars[1])] |
                     changed[at(prism.pillars[2])]) == 0) {
                    continue;
                }
                for (const int slab : {0, 1}) {
                    if (slabIsUpright(prism, slab)) {
                        continue;
                    }
                    if (round >= kMaxOrientationRounds) {
                        blocked_[f] = 1;
                        continue;
                    }
                    any = true;
                    for (const int v : prism.pillars) {
                        (slab == 0 ? shrinkTop : shrinkBottom)[at(v)] = 1;
                    }
                }
            }
            report_.orientationRounds = std::max(report_.orientationRounds, round);
            if (!any) {
                return;
            }
            changed = shrink(shrinkTop, shrinkBottom, kInvertedShrink);
        }
    }

    // Shrinks pillars until top and bottom intersect neither themselves nor each other.
    void separateAll(const Progress& progress) {
        std::vector<char> changed(base_.vertices.size(), 1);
        for (int round = 0;; ++round) {
            // Most builds need a handful of rounds, each with less to do than the one before.
            bspline_curve::report(progress, 1.0 - 0.7 / (round + 1.0), "separating top and bottom");
            const std::vector<std::pair<int, int>> pairs = intersectingPairs(changed);
            report_.intersectionRounds = round;
            if (pairs.empty()) {
                return;
            }
            std::vector<char> shrinkTop(base_.vertices.size(), 0);
            std::vector<char> shrinkBottom(base_.vertices.size(), 0);
            for (const auto& [i, j] : pairs) {
                const int f = faceOf(i);
                const int g = faceOf(j);
                if (f != g &&
                    trianglesIntersect(base_.vertices, base_.faces[at(f)], base_.faces[at(g)])) {
                    block(f, g, true);
                } else if (round >= kMaxIntersectionRounds) {
                    block(f, g, false);
                } else {
                    for (const int triangle : {i, j}) {
                        for (const int v : base_.faces[at(faceOf(triangle))]) {
                            (isTop(triangle) ? shrinkTop : shrinkBottom)[at(v)] = 1;
                        }
                    }
                }
            }
            changed = shrink(shrinkTop, shrinkBottom, kIntersectingShrink);
            uprightAll(changed);
        }
    }

    ShellBuild finish() {
        connect();
        std::vector<Pillar> pillars(base_.vertices.size());
        for (std::size_t v = 0; v < pillars.size(); ++v) {
            pillars[v] = {tips_[pillars.size() + v], base_.vertices[v], tips_[v]};
        }
        for (std::size_t f = 0; f < at(base_.surfaceFaceCount); ++f) {
            if (blocked_[f] != 0) {
                report_.blockedFaces.push_back(static_cast<int>(f));
            }
        }
        std::sort(report_.selfIntersections.begin(), report_.selfIntersections.end());
        return {
            Shell(std::move(pillars), std::move(prisms_), base_.surfaceFaceCount),
            std::move(report_)
        };
    }

private:
    // Triangles 0 .. #F-1 are the top, #F .. 2#F-1 the bottom; tips likewise.
    [[nodiscard]] int faceOf(int triangle) const {
        const int count = static_cast<int>(base_.faces.size());
        return triangle < count ? triangle : triangle - count;
    }

    [[nodiscard]] bool isTop(int triangle) const {
        return triangle < static_cast<int>(base_.faces.size());
    }

    void placeTips(std::size_t v) {
        tips_[v] = base_.vertices[v] + lengths_[0][v] * base_.directions[v];
        tips_[base_.vertices.size() + v] = base_.vertices[v] - lengths_[1][v] * base_.directions[v];
    }

    [[nodiscard]] bool slabIsUpright(const Prism& prism, int slab) const {
        const std::size_t offset = slab == 0 ? 0 : base_.vertices.size();
        const int wanted = slab == 0 ? prism.orientation : -prism.orientation;
        for (const auto& split : kSlabSplit) {
            std::array<const Vec3*, 4> p{};
            for (std::size_t k = 0; k < 4; ++k) {
                const std::size_t v = at(prism.pillars[static_cast<std::size_t>(split[k].slot)]);
                p[k] = split[k].outer ? &tips_[offset + v] : &base_.vertices[v];
            }
            if (orientationSign(*p[0], *p[1], *p[2], *p[3]) != wanted) {
                return false;
            }
        }
        return true;
    }

    std::vector<char> shrink(
        const std::vector<char>& top, const std::vector<char>& bottom, double factor
    ) {
        std::vector<char> changed(base_.vertices.size(), 0);
        for (std::size_t v = 0; v < changed.size(); ++v) {
            if (top[v] != 0) {
                lengths_[0][v] *= factor;
            }
            if (bottom[v] != 0) {
                lengths_[1][v] *= factor;
            }
            if (top[v] != 0 || bottom[v] != 0) {
                changed[v] = 1;
                placeTips(v);
            }
        }
        return changed;
    }

    // Intersecting pairs of top and bottom triangles of which at least one has a changed pillar.
    [[nodiscard]] std::vector<std::pair<int, int>> intersectingPairs(
        const std::vector<char>& changed
    ) const {
        const std::size_t n = base_.vertices.size();
        const int faceCount = static_cast<int>(base_.faces.size());
        std::vector<Triangle> triangles;
        std::vector<int> ids;
        std::vector<char> dirty;
        triangles.reserve(2 * at(faceCount));
        for (int triangle = 0; triangle < 2 * faceCount; ++triangle) {
            const std::size_t f = at(faceOf(triangle));
            if (blocked_[f] != 0) {
                continue;
            }
            Triangle corners = base_.faces[f];
            char isDirty = 0;
            for (int& v : corners) {
                isDirty = static_cast<char>(isDirty | changed[at(v)]);
                v += isTop(triangle) ? 0 : static_cast<int>(n);
            }
            triangles.push_back(corners);
            ids.push_back(triangle);
            dirty.push_back(isDirty);
        }
        std::vector<std::pair<int, int>> pairs;
        const TriangleTree tree(tips_, triangles);
        tree.forEachOverlappingPair([&](int i, int j) {
            if ((dirty[at(i)] | dirty[at(j)]) != 0 &&
                trianglesIntersect(tips_, triangles[at(i)], triangles[at(j)])) {
                pairs.emplace_back(ids[at(i)], ids[at(j)]);
            }
        });
        std::sort(pairs.begin(), pairs.end());
        return pairs;
    }

    void block(int f, int g, bool surfaceIntersects) {
        blocked_[at(f)] = blocked_[at(g)] = 1;
        if (surfaceIntersects && f < base_.surfaceFaceCount && g < base_.surfaceFaceCount) {
            const std::pair<int, int> pair = std::minmax(f, g);
            if (std::find(
                    report_.selfIntersections.begin(), report_.selfIntersections.end(), pair
                ) == report_.selfIntersections.end()) {
                report_.selfIntersections.push_back(pair);
            }
        }
    }

    // Neighbours across walls: wall k is opposite to slot k, hence to face corner faceCorner[k].
    void connect() {
        for (std::size_t f = 0; f < prisms_.size(); ++f) {
            Prism& prism = prisms_[f];
            for (std::size_t slot = 0; slot < 3; ++slot) {
                const int there =
                    base_.faceNeighbours[f][static_cast<std::size_t>(prism.faceCorner[slot])];
                prism.neighbours[slot] = -1;
                if (there < 0 || blocked_[f] != 0 || blocked_[at(there)] != 0) {
                    continue;
                }
                prism.neighbours[slot] = there;
                for (std::size_t k = 0; k < 3; ++k) {
                    if (base_.faceNeighbours[at(there)][static_cast<std::size_t>(
                            prisms_[at(there)].faceCorner[k]
                        )] == static_cast<int>(f) &&
                        prisms_[at(there)].pillars[k] != prism.pillars[(slot + 1) % 3] &&
                        prisms_[at(there)].pillars[k] != prism.pillars[(slot + 2) % 3]) {
                        prism.neighbourWalls[slot] = static_cast<signed char>(k);
                    }
                }
            }
        }
    }

    const ShellBase& base_;
    std::array<std::vector<double>, 2> lengths_;  // of top and bottom half pillars
    std::vector<Vec3> tips_;                      // top of every vertex, then bottom
    std::vector<Prism> prisms_;
    std::vector<char> blocked_;
    ShellBuildReport report_;
};

}  // namespace

void ShellOptions::validate() const {
    if (!(thickness > 0.0)) {
        throw InputError(
            InputErrorCode::BadOption,
            "shell thickness is " + std::to_string(thickness) +
                ", but must be above 0 (mean edge lengths)"
        );
    }
    if (smoothingPasses < 0) {
        throw InputError(
            InputErrorCode::BadOption,
            "smoothing passes are " + std::to_string(smoothingPasses) + ", but must not be negative"
        );
    }
}

ShellBuild buildShell(
    const ShellBase& base, const ShellOptions& options, const Progress& progress
) {
    options.validate();
    Builder builder(base, options);
    builder.uprightAll(std::vector<char>(base.vertices.size(), 1));
    builder.separateAll(progress);
    return builder.finish();
}

}  // namespace bspline_curve

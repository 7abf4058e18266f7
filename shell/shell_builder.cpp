// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/shell_builder.h"

#include "shell/everted_layers.h"
#include "shell/full_prisms.h"
#include "shell/nested_components.h"
#include "shell/pillar_reach.h"
#include "shell/slab.h"
#include "surface/predicates.h"
#include "surface/self_intersection.h"
#include "surface/triangle_tree.h"
#include "utility/report_progress.h"

#include <algorithm>
#include <utility>

namespace bspline_curve {
namespace {

constexpr double kInvertedShrink = 0.6;
constexpr double kIntersectingShrink = 0.5;
// Pillars shorter than this share of the wanted length shrink no more: where that does not help,
// faces are blocked.
constexpr double kLeastShare = 1e-9;
// Ghosts that still intersect something after this many rounds are given up, or they would make
// needles of the pillars on the boundary of the surface.
constexpr int kGhostRounds = 6;

// Layers of points: tips above and below, middles.
constexpr int kTop = 0;
constexpr int kBottom = 1;
constexpr int kMiddle = 2;

// Which pillars are meant, above and below.
using PillarMarks = std::array<std::vector<char>, 2>;

// The triangles of the shell's boundary.
struct Boundary {
    std::vector<int> faces;           // of the extended surface, whose prism each belongs to
    std::vector<Triangle> triangles;  // of the layers' points
};

class Builder {
public:
    Builder(const ExtendedSurface& extended, const ShellOptions& options) : extended_(extended) {
        const std::size_t n = extended.vertices.size();
        for (const int side : {kTop, kBottom}) {
            for (std::size_t v = 0; v < n; ++v) {
                lengths_[side].push_back(options.thickness * extended.edgeLengths[v]);
            }
        }
        wantedLengths_ = lengths_[0];
        keepPillarsApart(extended, lengths_);
        layers_.pillarCount = n;
        layers_.points.reserve(3 * n);
        for (int layer = 0; layer < 3; ++layer) {
            layers_.points.insert(
                layers_.points.end(), extended.vertices.begin(), extended.vertices.end()
            );
        }
        for (std::size_t v = 0; v < n; ++v) {
            placeTips(v);
        }
        prisms_.reserve(extended.faces.size());
        for (const Triangle& face : extended.faces) {
            prisms_.push_back(prismOver(face));
        }
        blocked_.assign(extended.faces.size(), 0);
        changed_.assign(n, 1);
        std::vector<char> unseen(n, 0);
        for (const int v : extended.unseenVertices) {
            unseen[v] = 1;
        }
        for (std::size_t f = 0; f < extended.faces.size(); ++f) {
            for (const int v : extended.faces[f]) {
                blocked_[f] = static_cast<char>(blocked_[f] | unseen[v]);
            }
        }
    }

    // Shrinks pillars until every tetrahedron is positive. Only prisms with a pillar that changed
    // are tested again.
    void uprightAll() {
        std::vector<char> everChanged = changed_;
        for (int round = 0;; ++round) {
            PillarMarks marks = noPillars();
            bool any = false;
            for (std::size_t f = 0; f < prisms_.size(); ++f) {
                const Prism& prism = prisms_[f];
                const bool isDirty =
                    std::any_of(prism.pillars.begin(), prism.pillars.end(), [&](int v) {
                        return changed_[v] != 0;
                    });
                for (const int slab : {kTop, kBottom}) {
                    if (isDirty && blocked_[f] == 0 && !slabIsUpright(prism, slab)) {
                        any = true;
                        if (!markForShrinking(marks, slab, prism.pillars)) {
                            block(static_cast<int>(f), everChanged);
                        }
                    }
                }
            }
            report_.orientationRounds = std::max(report_.orientationRounds, round);
            if (!any) {
                break;
            }
            shrink(marks, kInvertedShrink);
            for (std::size_t v = 0; v < changed_.size(); ++v) {
                everChanged[v] = static_cast<char>(everChanged[v] | changed_[v]);
            }
        }
        changed_ = std::move(everChanged);
    }

    // Shrinks pillars until the boundary of the shell intersects itself nowhere, no component lies
    // inside of another one, and no layer is inside out.
    void separateAll(const Progress& progress) {
        for (int round = 0;; ++round) {
            // Most builds need a handful of rounds, each with less to do than the one before.
            bspline_curve::report(progress, 1.0 - 0.7 / (round + 1.0), "separating top and bottom");
            PillarMarks marks = noPillars();
            std::vector<char> freed(extended_.vertices.size(), 0);
            report_.intersectionRounds = round;
            if (!markIntersecting(marks, freed) && !markNested(marks, freed) &&
                !markEverted(marks, freed)) {
                return;
            }
            shrink(marks, kIntersectingShrink);
            // Where a face is blocked, its neighbours have new walls.
            for (std::size_t v = 0; v < freed.size(); ++v) {
                changed_[v] = static_cast<char>(changed_[v] | freed[v]);
            }
            uprightAll();
        }
    }

    ShellBuild finish() {
        std::vector<Pillar> pillars(extended_.vertices.size());
        for (std::size_t v = 0; v < pillars.size(); ++v) {
            pillars[v] = {
                layers_.point(kBottom, v), layers_.point(kMiddle, v), layers_.point(kTop, v)
            };
        }
        for (std::size_t f = 0; f < blocked_.size(); ++f) {
            if (blocked_[f] == 0) {
                continue;
            }
            prisms_[f].orientation = 0;
            if (!isGhost(static_cast<int>(f))) {
                report_.blockedFaces.push_back(static_cast<int>(f));
            }
        }
        connectPrisms(prisms_, extended_.faceNeighbours);
        return {
            Shell(std::move(pillars), std::move(prisms_), extended_.surfaceFaceCount),
            std::move(report_)
        };
    }

private:
    [[nodiscard]] bool isGhost(int face) const { return face >= extended_.surfaceFaceCount; }

    void placeTips(std::size_t v) {
        layers_.points[layers_.indexOf(kTop, v)] =
            extended_.vertices[v] + lengths_[kTop][v] * extended_.directions[v];
        layers_.points[layers_.indexOf(kBottom, v)] =
            extended_.vertices[v] - lengths_[kBottom][v] * extended_.directions[v];
    }

    [[nodiscard]] bool slabIsUpright(const Prism& prism, int slab) const {
        const int wanted = slab == kTop ? prism.orientation : -prism.orientation;
        return bspline_curve::slabIsUpright(wanted, [&](int slot, bool outer) -> const Vec3& {
            return layers_.point(outer ? slab : kMiddle, prism.pillars[slot]);
        });
    }

    // ---- Shrinking ----

    [[nodiscard]] PillarMarks noPillars() const {
        return {
            std::vector<char>(extended_.vertices.size(), 0),
            std::vector<char>(extended_.vertices.size(), 0)
        };
    }

    [[nodiscard]] bool canShrink(int v, int side) const {
        return lengths_[side][v] > kLeastShare * wantedLengths_[v];
    }

    // Whether any of the half pillars could be marked.
    bool markForShrinking(PillarMarks& marks, int side, const std::array<int, 3>& vertices) const {
        bool any = false;
        for (const int v : vertices) {
            if (canShrink(v, side)) {
                marks[side][v] = 1;
                any = true;
            }
        }
        return any;
    }

    // The same of those with a tip in a triangle of the boundary.
    bool markTipsForShrinking(PillarMarks& marks, const Triangle& triangle) const {
        bool any = false;
        for (const int point : triangle) {
            const int side = layerOf(point);
            if (side != kMiddle && canShrink(pillarOf(point), side)) {
                marks[side][pillarOf(point)] = 1;
                any = true;
            }
        }
        return any;
    }

    [[nodiscard]] int layerOf(int point) const {
        return point / static_cast<int>(layers_.pillarCount);
    }

    [[nodiscard]] int pillarOf(int point) const {
        return point % static_cast<int>(layers_.pillarCount);
    }

    void shrink(const PillarMarks& marks, double factor) {
        for (std::size_t v = 0; v < changed_.size(); ++v) {
            changed_[v] = static_cast<char>(marks[kTop][v] | marks[kBottom][v]);
            for (const int side : {kTop, kBottom}) {
                if (marks[side][v] != 0) {
                    lengths_[side][v] *= factor;
                }
            }
            if (changed_[v] != 0) {
                placeTips(v);
            }
        }
    }

    // ---- Separation ----

    // The boundary: top and bottom, and the walls where the shell ends, split like their prism.
    [[nodiscard]] Boundary boundary() const {
        Boundary boundary;
        boundary.faces.reserve(2 * prisms_.size());
        boundary.triangles.reserve(2 * prisms_.size());
        const auto add = [&](std::size_t f,
                             const std::array<int, 3>& pillars,
                             const std::array<int, 3>& layers) {
            boundary.faces.push_back(static_cast<int>(f));
            Triangle& triangle = boundary.triangles.emplace_back();
            for (std::size_t k = 0; k < 3; ++k) {
                triangle[k] = static_cast<int>(layers_.indexOf(layers[k], pillars[k]));
            }
        };
        for (std::size_t f = 0; f < prisms_.size(); ++f) {
            if (blocked_[f] != 0) {
                continue;
            }
            const Prism& prism = prisms_[f];
            for (const int side : {kTop, kBottom}) {
                add(f, prism.pillars, {side, side, side});
            }
            for (std::size_t slot = 0; slot < 3; ++slot) {
                const int there = extended_.faceNeighbours[f][prism.faceCorner[slot]];
                if (there >= 0 && blocked_[there] == 0) {
                    continue;
                }
                const auto [low, high] =
                    std::minmax(prism.pillars[(slot + 1) % 3], prism.pillars[(slot + 2) % 3]);
                for (const int side : {kTop, kBottom}) {
                    add(f, {low, high, high}, {kMiddle, kMiddle, side});
                    add(f, {low, high, low}, {kMiddle, side, side});
                }
            }
        }
        return boundary;
    }

    [[nodiscard]] bool isDirty(const Triangle& triangle) const {
        return std::any_of(triangle.begin(), triangle.end(), [&](int point) {
            return changed_[pillarOf(point)] != 0;
        });
    }

    // Intersecting pairs of boundary triangles of which at least one has a changed pillar.
    [[nodiscard]] std::vector<std::pair<int, int>> intersectingPairs(
        const std::vector<Triangle>& triangles
    ) const {
        std::vector<std::pair<int, int>> pairs;
        const TriangleTree tree(layers_.points, triangles);
        tree.forEachOverlappingPair([&](int i, int j) {
            const Triangle& first = triangles[i];
            const Triangle& second = triangles[j];
            if ((isDirty(first) || isDirty(second)) &&
                trianglesIntersect(layers_.points, first, second)) {
                pairs.emplace_back(i, j);
            }
        });
        std::sort(pairs.begin(), pairs.end());
        return pairs;
    }

    // Marks pillars where the boundary intersects itself, blocks faces where shrinking cannot help.
    bool markIntersecting(PillarMarks& marks, std::vector<char>& freed) {
        const auto [faces, triangles] = boundary();
        const std::vector<std::pair<int, int>> pairs = intersectingPairs(triangles);
        for (const auto& [i, j] : pairs) {
            const int f = faces[i];
            const int g = faces[j];
            if (f != g &&
                trianglesIntersect(extended_.vertices, extended_.faces[f], extended_.faces[g])) {
                blockCrossingFaces(freed);
                continue;
            }
            if (report_.intersectionRounds >= kGhostRounds && (isGhost(f) || isGhost(g))) {
                blockPair(f, g, freed);
                continue;
            }
            const bool canShrinkFirst = markTipsForShrinking(marks, triangles[i]);
            const bool canShrinkSecond = markTipsForShrinking(marks, triangles[j]);
            if (!canShrinkFirst && !canShrinkSecond) {
                blockPair(f, g, freed);
            }
        }
        return !pairs.empty();
    }

    bool markNested(PillarMarks& marks, std::vector<char>& freed) {
        const std::vector<NestedVertex> nested =
            findNestedComponents(layers_, prisms_, extended_.faceNeighbours, blocked_);
        for (const NestedVertex& found : nested) {
            if (!markForShrinking(marks, found.slab, prisms_[found.prism].pillars)) {
                block(found.prism, freed);
            }
        }
        return !nested.empty();
    }

    bool markEverted(PillarMarks& marks, std::vector<char>& freed) {
        const std::vector<EvertedPrism> everted =
            findEvertedLayers(layers_, prisms_, extended_.faceNeighbours, blocked_);
        for (const auto& [prism, slab] : everted) {
            if (!markForShrinking(marks, slab, prisms_[prism].pillars)) {
                block(prism, freed);
            }
        }
        return !everted.empty();
    }

    // All of them, once: not only those whose prisms are thin enough to show it.
    void blockCrossingFaces(std::vector<char>& freed) {
        if (std::exchange(crossingsAreBlocked_, true)) {
            return;
        }
        for (const auto& [f, g] : findSelfIntersections(extended_.vertices, extended_.faces)) {
            blockPair(f, g, freed);
            if (!isGhost(f) && !isGhost(g)) {
                report_.selfIntersections.emplace_back(f, g);
            }
        }
    }

    // A ghost gives way to the surface.
    void blockPair(int f, int g, std::vector<char>& freed) {
        const bool onlyGhosts = isGhost(f) != isGhost(g);
        for (const int face : {f, g}) {
            if (!onlyGhosts || isGhost(face)) {
                block(face, freed);
            }
        }
    }

    void block(int face, std::vector<char>& freed) {
        blocked_[face] = 1;
        for (const int v : extended_.faces[face]) {
            freed[v] = 1;
        }
    }

    const ExtendedSurface& extended_;
    std::array<std::vector<double>, 2> lengths_;  // of half pillars, above and below
    std::vector<double> wantedLengths_;
    PillarLayers layers_;
    std::vector<Prism> prisms_;
    std::vector<char> blocked_;
    std::vector<char> changed_;  // pillars that are not tested yet
    bool crossingsAreBlocked_ = false;
    ShellBuildReport report_;
};

}  // namespace

ShellBuild buildShell(
    const ExtendedSurface& extended, const ShellOptions& options, const Progress& progress
) {
    options.validate();
    Builder builder(extended, options);
    builder.uprightAll();
    builder.separateAll(progress);
    return builder.finish();
}

}  // namespace bspline_curve

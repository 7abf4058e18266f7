// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/shell_builder.h"

#include "bspline_curve/progress.h"
#include "shell/overlapping_components.h"
#include "shell/pillar_lengths.h"
#include "shell/projection_stretch.h"
#include "surface/self_intersection.h"
#include "surface/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bspline_curve {
namespace {

struct BuilderConstants {
    /// Factor on the half pillars of a prism with a tetrahedron that is not positive.
    double invertedShrink = 0.6;
    /// Factor on half pillars whose tips belong to triangles that intersect.
    double intersectingShrink = 0.5;
    /// Half pillars below this share of the wanted length are not shortened; faces are blocked.
    double leastShare = 1e-9;
    /// Pillars are shortened for the sake of digits where that leaves at most this share of the
    /// stretch that loses them.
    double grazingShare = 0.5;
    /// Rounds after which the factor is squared, cubed, …: sheets that touch are never parted, and
    /// their pillars must become too short some time.
    int patientRounds = 16;
    /// Rounds after which ghosts that intersect something are blocked: needles otherwise.
    int ghostRounds = 6;
    /// Where fewer than one in so many triangles changed, each is compared by a search of its own:
    /// that takes about twice as long for all of them.
    std::size_t fewTouched = 4;
    /// Pairs of triangles that are tested between two reports of the progress: milliseconds.
    std::size_t pairsPerReport = 100000;
    /// Shares of the progress: up to where pillars are placed, and all tetrahedra are positive.
    double placedShare = 0.2, positiveShare = 0.3;
};

constexpr BuilderConstants kBuilder;

// The triangles of the shell's boundary, and the face over which the prism of each lies.
struct Boundary {
    std::vector<int> faces;
    std::vector<Triangle> triangles;
};

class Builder {
public:
    Builder(const ExtendedSurface& extended, const ShellOptions& options, const Progress& progress)
        : extended_(extended) {
        const std::size_t n = extended.vertices.size();
        for (const double edgeLength : extended.edgeLengths) {
            wantedLengths_.push_back(options.thickness * edgeLength);
        }
        lengths_ = {wantedLengths_, wantedLengths_};
        limitPillarLengths(extended, lengths_, progress);
        points_.points.resize(PillarPoints::kLevels * n);
        for (std::size_t v = 0; v < n; ++v) {
            placePillar(v);
        }
        prisms_.reserve(extended.faces.size());
        for (const Triangle& face : extended.faces) {
            prisms_.push_back(prismOver(face));
        }
        connectPrisms(prisms_, extended.faceNeighbours);
        marks_ = {std::vector<char>(n, 0), std::vector<char>(n, 0)};
        changed_.assign(n, 1);
        touched_.assign(n, 1);
        std::vector<char> unseen(n, 0);
        for (const int v : extended.unseenVertices) {
            unseen[v] = 1;
        }
        for (Prism& prism : prisms_) {
            if (std::ranges::any_of(prism.pillars, [&](int v) { return unseen[v] != 0; })) {
                prism.orientation = 0;
            }
        }
    }

    // Shortens pillars until every tetrahedron is positive and none stretches projections too much.
    // Only prisms with a pillar that changed
    // are tested again.
    void makePositive() {
        changed_ = touched_;
        for (int round = 0;; ++round) {
            bool isDone = true;
            for (int f = 0; f < static_cast<int>(prisms_.size()); ++f) {
                const bool hasChanged = std::ranges::any_of(prisms_[f].pillars, [&](int v) {
                    return changed_[v] != 0;
                });
                for (int slab = 0; hasChanged && slab < 2; ++slab) {
                    const Prism& prism = prisms_[f];
                    if (!isBlocked(f) &&
                        (!Slab{points_, prism.pillars, prism.orientation, slab}.isPositive() ||
                         stretchesTooMuch(prism, slab))) {
                        isDone = false;
                        shortenOrBlock({f, slab});
                    }
                }
            }
            report_.orientationRounds = std::max(report_.orientationRounds, round);
            if (isDone) {
                return;
            }
            shorten(kBuilder.invertedShrink);
        }
    }

    // Shortens pillars until the boundary of the shell intersects itself nowhere, no component lies
    // inside of another one, and no layer is inside out.
    void separate(const Progress& progress) {
        for (int round = 0;; ++round) {
            // Most builds need a handful of rounds, each with less to do than the one before.
            const double fraction = 1.0 - (1.0 - kBuilder.positiveShare) / (round + 1.0);
            const auto show = [&] {
                bspline_curve::report(progress, fraction, "separating top and bottom");
            };
            show();
            report_.intersectionRounds = round;
            const Boundary boundary = findBoundary();
            const std::vector<std::pair<int, int>> pairs =
                intersectingPairs(boundary.triangles, show);
            touched_.assign(touched_.size(), 0);
            if (!pairs.empty()) {
                markIntersecting(boundary, pairs);
            } else if (!markOverlappingComponents()) {
                return;
            }
            const int haste = std::max(0, round - kBuilder.patientRounds);
            shorten(std::pow(kBuilder.intersectingShrink, 1 + haste));
            makePositive();
        }
    }

    ShellBuild finish() {
        std::vector<Pillar> pillars(extended_.vertices.size());
        for (std::size_t v = 0; v < pillars.size(); ++v) {
            pillars[v] = points_.pillar(static_cast<int>(v));
        }
        for (int f = 0; f < extended_.surfaceFaceCount; ++f) {
            if (isBlocked(f)) {
                report_.blockedFaces.push_back(f);
            }
        }
        for (Prism& prism : prisms_) {
            for (std::size_t slot = 0; slot < 3; ++slot) {
                if (prism.orientation == 0 || isBlocked(prism.neighbours[slot])) {
                    prism.neighbours[slot] = -1;
                    prism.neighbourWalls[slot] = 0;
                }
            }
        }
        return {
            Shell(std::move(pillars), std::move(prisms_), extended_.surfaceFaceCount),
            std::move(report_)
        };
    }

private:
    [[nodiscard]] bool isGhost(int face) const { return face >= extended_.surfaceFaceCount; }

    /// Whether there is no prism: also for face -1, beyond the end of the extended surface.
    [[nodiscard]] bool isBlocked(int face) const {
        return face < 0 || prisms_[face].orientation == 0;
    }

    void placePillar(std::size_t v) {
        const Vec3& middle = extended_.vertices[v];
        const Vec3& direction = extended_.directions[v];
        points_.set(
            static_cast<int>(v),
            {middle - lengths_[1][v] * direction, middle, middle + lengths_[0][v] * direction}
        );
    }

    // Whether the projection loses digits that shorter half pillars would save. Where fibres graze
    // the face they save none.
    [[nodiscard]] bool stretchesTooMuch(const Prism& prism, std::size_t slab) const {
        std::array<Pillar, 3> pillars;
        for (std::size_t k = 0; k < 3; ++k) {
            pillars[k] = points_.pillar(prism.pillars[k]);
        }
        const Vec3 first = pillars[1].middle - pillars[0].middle;
        const Vec3 second = pillars[2].middle - pillars[0].middle;
        const Gram face = gramOf(first, second);
        const std::array<Vec3, 3> fibres = fibresOf(pillars, slab);
        if (largestStretch(gramsOf(pillars, fibres, slab), face) <= kMostStretch) {
            return false;
        }
        std::array<Gram, 3> ofShort;
        std::ranges::transform(fibres, ofShort.begin(), [&](const Vec3& fibre) {
            return gramOf(first, second, fibre);
        });
        return largestStretch(ofShort, face) <= kBuilder.grazingShare * kMostStretch;
    }

    // ---- Shortening ----

    // Marks a half pillar to be shortened; false where it is too short already.
    bool mark(int pillar, int slab) {
        const bool canShrink =
            lengths_[slab][pillar] > kBuilder.leastShare * wantedLengths_[pillar];
        if (canShrink) {
            marks_[slab][pillar] = 1;
        }
        return canShrink;
    }

    // Marks the half pillars of a slab; where none can be shortened its face is blocked.
    void shortenOrBlock(const PrismSlab& found) {
        bool any = false;
        for (const int v : prisms_[found.prism].pillars) {
            any = mark(v, found.slab) || any;
        }
        if (!any) {
            block(found.prism);
        }
    }

    // Marks the half pillars with a tip in a triangle of the boundary; false where none could be.
    bool markTips(const Triangle& triangle) {
        bool any = false;
        for (const int point : triangle) {
            for (const int slab : {0, 1}) {
                if (point % PillarPoints::kLevels == static_cast<int>(kOuterLevels[slab])) {
                    any = mark(point / PillarPoints::kLevels, slab) || any;
                }
            }
        }
        return any;
    }

    // Shortens the half pillars that are marked.
    void shorten(double factor) {
        for (std::size_t v = 0; v < changed_.size(); ++v) {
            changed_[v] = static_cast<char>(marks_[0][v] | marks_[1][v]);
            for (const int slab : {0, 1}) {
                if (std::exchange(marks_[slab][v], 0) != 0) {
                    lengths_[slab][v] *= factor;
                }
            }
            if (changed_[v] != 0) {
                touched_[v] = 1;
                placePillar(v);
            }
        }
    }

    // ---- Separation ----

    // Top and bottom, and the walls where the shell ends.
    [[nodiscard]] Boundary findBoundary() const {
        Boundary boundary;
        boundary.faces.reserve(2 * prisms_.size());
        boundary.triangles.reserve(2 * prisms_.size());
        const auto add = [&](int f, const Triangle& triangle) {
            boundary.faces.push_back(f);
            boundary.triangles.push_back(triangle);
        };
        for (int f = 0; f < static_cast<int>(prisms_.size()); ++f) {
            if (isBlocked(f)) {
                continue;
            }
            const Prism& prism = prisms_[f];
            for (const Level level : kOuterLevels) {
                add(f, layerTriangle(prism.pillars, level));
            }
            for (std::size_t slot = 0; slot < 3; ++slot) {
                if (isBlocked(prism.neighbours[slot])) {
                    for (const Triangle& triangle : wallTriangles(prism.pillars, slot)) {
                        add(f, triangle);
                    }
                }
            }
        }
        return boundary;
    }

    [[nodiscard]] bool hasTouchedPillar(const Triangle& triangle) const {
        return std::ranges::any_of(triangle, [&](int point) {
            return touched_[point / PillarPoints::kLevels] != 0;
        });
    }

    // Pairs of triangles that intersect and of which at least one changed. Calls `show` now and
    // then, which may throw.
    template <class Show>
    [[nodiscard]] std::vector<std::pair<int, int>> intersectingPairs(
        const std::vector<Triangle>& triangles, const Show& show
    ) const {
        std::vector<char> isTouched;
        for (const Triangle& triangle : triangles) {
            isTouched.push_back(static_cast<char>(hasTouchedPillar(triangle)));
        }
        const TriangleTree tree(points_.points, triangles);
        std::vector<std::pair<int, int>> pairs;
        std::size_t visited = 0;
        const auto test = [&](int i, int j) {
            if (++visited % kBuilder.pairsPerReport == 0) {
                show();
            }
            if ((isTouched[i] != 0 || isTouched[j] != 0) &&
                trianglesIntersect(points_.points, triangles[i], triangles[j])) {
                pairs.emplace_back(i, j);
            }
        };
        const auto touched = static_cast<std::size_t>(std::ranges::count(isTouched, 1));
        if (touched * kBuilder.fewTouched > triangles.size()) {
            tree.forEachOverlappingPair(test);
        } else {
            for (int i = 0; i < static_cast<int>(triangles.size()); ++i) {
                if (isTouched[i] != 0) {
                    tree.forEachOverlapping(i, [&](int j) {
                        if (j > i || isTouched[j] == 0) {  // else j has seen i
                            test(std::min(i, j), std::max(i, j));
                        }
                    });
                }
            }
        }
        std::ranges::sort(pairs);
        return pairs;
    }

    // Marks the pillars of triangles that intersect; blocks faces where shorter ones do not help.
    void markIntersecting(
        const Boundary& boundary, const std::vector<std::pair<int, int>>& intersecting
    ) {
        for (const auto& [i, j] : intersecting) {
            const int f = boundary.faces[i];
            const int g = boundary.faces[j];
            if (f != g &&
                trianglesIntersect(extended_.vertices, extended_.faces[f], extended_.faces[g])) {
                blockCrossingFaces();
            } else if (report_.intersectionRounds >= kBuilder.ghostRounds &&
                       (isGhost(f) || isGhost(g))) {
                blockPair(f, g);
            } else {
                const bool anyOfFirst = markTips(boundary.triangles[i]);
                const bool anyOfSecond = markTips(boundary.triangles[j]);
                if (!anyOfFirst && !anyOfSecond) {
                    blockPair(f, g);
                }
            }
        }
    }

    // Whether there are any.
    bool markOverlappingComponents() {
        const PrismComponents components = findComponents(prisms_);
        std::vector<PrismSlab> found = findNestedSlabs(points_, prisms_, components);
        if (found.empty()) {
            found = findInvertedSlabs(points_, prisms_, components);
        }
        for (const PrismSlab& slab : found) {
            shortenOrBlock(slab);
        }
        return !found.empty();
    }

    // All of them, once: not only those whose prisms are thin enough to show it.
    void blockCrossingFaces() {
        if (std::exchange(crossingsAreBlocked_, true)) {
            return;
        }
        for (const auto& [f, g] : findSelfIntersections(extended_.vertices, extended_.faces)) {
            blockPair(f, g);
            if (!isGhost(f) && !isGhost(g)) {
                report_.selfIntersections.emplace_back(f, g);
            }
        }
    }

    // A ghost gives way to the surface.
    void blockPair(int f, int g) {
        const bool onlyGhosts = isGhost(f) != isGhost(g);
        for (const int face : {f, g}) {
            if (!onlyGhosts || isGhost(face)) {
                block(face);
            }
        }
    }

    // The neighbours of a blocked face have new walls, which are to be tested.
    void block(int face) {
        prisms_[face].orientation = 0;
        for (const int v : extended_.faces[face]) {
            touched_[v] = 1;
        }
    }

    const ExtendedSurface& extended_;
    std::array<std::vector<double>, 2> lengths_;  // of half pillars, above and below
    std::vector<double> wantedLengths_;
    PillarPoints points_;
    std::vector<Prism> prisms_;               // orientation 0 where blocked
    std::array<std::vector<char>, 2> marks_;  // half pillars to shorten
    std::vector<char> changed_;               // pillars whose prisms are to be tested
    std::vector<char> touched_;               // pillars whose boundary triangles are to be tested
    bool crossingsAreBlocked_ = false;
    ShellBuildReport report_;
};

}  // namespace

ShellBuild buildShell(
    const ExtendedSurface& extended, const ShellOptions& options, const Progress& progress
) {
    options.validate();
    Builder builder(extended, options, partOf(progress, 0.0, kBuilder.placedShare));
    report(progress, kBuilder.placedShare, "placing pillars");
    builder.makePositive();
    builder.separate(progress);
    return builder.finish();
}

}  // namespace bspline_curve

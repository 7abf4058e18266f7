// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/patch_levels.h"

#include "bspline_curve/progress.h"
#include "utility/large_array.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

namespace bspline_curve {
namespace {

// Patches are not made larger where there are no more than these: searching them all takes less
// than a millisecond.
constexpr int kFewPatches = 4096;

// The faces as a graph.
class FaceGraph {
public:
    explicit FaceGraph(const Surface& surface) : surface_(surface) {
        reserveLarge(areas_, surface.faces().size());
        reserveLarge(centres_, surface.faces().size());
        for (const Triangle& face : surface.faces()) {
            const Vec3& a = surface.vertices()[face[0]];
            const Vec3& b = surface.vertices()[face[1]];
            const Vec3& c = surface.vertices()[face[2]];
            areas_.push_back(0.5 * (b - a).cross(c - a).norm());
            centres_.emplace_back((a + b + c) / 3.0);
        }
    }

    [[nodiscard]] int count() const { return surface_.faceCount(); }

    [[nodiscard]] const Vec3& centre(int node) const { return centres_[node]; }

    [[nodiscard]] double area(int node) const { return areas_[node]; }

    template <class Visit>
    void visitNeighbours(int node, const Visit& visit) const {
        for (const int neighbour : surface_.faceNeighbours()[node]) {
            if (neighbour >= 0) {
                visit(neighbour);
            }
        }
    }

    template <class Visit>
    void visitSamples(int node, const Visit& visit) const {
        visit(node);
    }

private:
    const Surface& surface_;
    std::vector<double> areas_;
    std::vector<Vec3> centres_;
};

// Patches as a graph.
struct PatchGraph {
    PatchLevels::Level level;  // without patchOf
    std::vector<double> areas;

    explicit PatchGraph(int count) {
        reserveLarge(areas, count);
        reserveLarge(level.centres, count);
        reserveLarge(level.samples, count);
        level.offsets.reserve(count + 1);
        level.offsets.push_back(0);
    }

    [[nodiscard]] int count() const { return level.count(); }

    [[nodiscard]] const Vec3& centre(int node) const { return level.centres[node]; }

    [[nodiscard]] double area(int node) const { return areas[node]; }

    template <class Visit>
    void visitNeighbours(int node, const Visit& visit) const {
        for (int i = level.offsets[node]; i < level.offsets[node + 1]; ++i) {
            visit(level.neighbours[i]);
        }
    }

    template <class Visit>
    void visitSamples(int node, const Visit& visit) const {
        for (const int face : level.samples[node]) {
            if (face >= 0) {
                visit(face);
            }
        }
    }
};

// Nodes in pairs, each with the nearest that is left; a node whose neighbours are all taken joins
// the nearest of them.
struct Pairing {
    std::vector<int> patchOf;
    int count = 0;

    template <class Graph>
    explicit Pairing(const Graph& graph) : patchOf(makeLarge(graph.count(), -1)) {
        for (int node = 0; node < graph.count(); ++node) {
            if (patchOf[node] < 0) {
                place(graph, node);
            }
        }
    }

private:
    template <class Graph>
    void place(const Graph& graph, int node) {
        constexpr double kFar = std::numeric_limits<double>::infinity();
        const Vec3& centre = graph.centre(node);
        int left = -1;
        int taken = -1;
        double leftDistance = kFar;
        double takenDistance = kFar;
        graph.visitNeighbours(node, [&](int neighbour) {
            const double distance = (graph.centre(neighbour) - centre).squaredNorm();
            const bool isTaken = patchOf[neighbour] >= 0;
            double& least = isTaken ? takenDistance : leftDistance;
            if (distance < least) {
                least = distance;
                (isTaken ? taken : left) = neighbour;
            }
        });
        if (left < 0 && taken >= 0) {
            patchOf[node] = patchOf[taken];
            return;
        }
        patchOf[node] = count;
        if (left >= 0) {
            patchOf[left] = count;
        }
        ++count;
    }
};

// The nodes of each patch, one patch after the other.
struct Members {
    std::vector<int> offsets, nodes;

    explicit Members(const Pairing& pairing)
        : offsets(pairing.count + 1), nodes(makeLarge(pairing.patchOf.size(), 0)) {
        for (const int patch : pairing.patchOf) {
            ++offsets[patch + 1];
        }
        for (std::size_t i = 1; i < offsets.size(); ++i) {
            offsets[i] += offsets[i - 1];
        }
        std::vector<int> next(offsets.begin(), offsets.end() - 1);
        for (std::size_t node = 0; node < pairing.patchOf.size(); ++node) {
            nodes[next[pairing.patchOf[node]]++] = static_cast<int>(node);
        }
    }
};

// As many of the faces as there is room for, evenly.
PatchLevels::Samples thinned(const std::vector<int>& faces) {
    PatchLevels::Samples samples;
    samples.fill(-1);
    const std::size_t kept = std::min(samples.size(), faces.size());
    for (std::size_t i = 0; i < kept; ++i) {
        samples[i] = faces[i * faces.size() / kept];
    }
    return samples;
}

template <class Graph>
PatchGraph coarsened(const Graph& fine, const Pairing& pairing) {
    const Members members(pairing);
    PatchGraph coarse(pairing.count);
    std::vector<int> seenFrom(pairing.count, -1);
    std::vector<int> faces;
    for (int patch = 0; patch < pairing.count; ++patch) {
        double area = 0.0;
        Vec3 moment = Vec3::Zero();
        faces.clear();
        seenFrom[patch] = patch;
        for (int i = members.offsets[patch]; i < members.offsets[patch + 1]; ++i) {
            const int node = members.nodes[i];
            area += fine.area(node);
            moment += fine.area(node) * fine.centre(node);
            fine.visitSamples(node, [&](int face) { faces.push_back(face); });
            fine.visitNeighbours(node, [&](int neighbour) {
                const int other = pairing.patchOf[neighbour];
                if (seenFrom[other] != patch) {
                    seenFrom[other] = patch;
                    coarse.level.neighbours.push_back(other);
                }
            });
        }
        coarse.areas.push_back(area);
        coarse.level.centres.emplace_back(moment / area);
        coarse.level.samples.push_back(thinned(faces));
        coarse.level.offsets.push_back(static_cast<int>(coarse.level.neighbours.size()));
    }
    return coarse;
}

// Pairs of pairs: their graph, with the patch of each node.
template <class Graph>
PatchGraph quartered(const Graph& fine, const Progress& progress) {
    report(progress, 0.0, kPreparingStage);
    const Pairing pairs(fine);
    report(progress, 0.3, kPreparingStage);
    const PatchGraph paired = coarsened(fine, pairs);
    report(progress, 0.7, kPreparingStage);
    const Pairing pairsOfPairs(paired);
    PatchGraph coarse = coarsened(paired, pairsOfPairs);
    coarse.level.patchOf = pairs.patchOf;
    for (int& patch : coarse.level.patchOf) {
        patch = pairsOfPairs.patchOf[patch];
    }
    return coarse;
}

// Shares of the work.
constexpr double kGraphShare = 0.1;
constexpr double kFinestShare = 0.8;

// Patches that a way leads over from centre to centre are a third of it wide, at most: the nearest
// one is then found, and what remains of the way is short.
constexpr double kShareOfWay = 1.0 / 3.0;

}  // namespace

PatchLevels::PatchLevels(const Surface& surface, const Progress& progress) {
    if (surface.faceCount() <= kFewPatches) {
        return;
    }
    const FaceGraph faces(surface);
    PatchGraph graph = quartered(faces, partOf(progress, kGraphShare, kFinestShare));
    // Soon done, all of them.
    const Progress coarser = partOf(progress, kFinestShare, kFinestShare);
    int below = surface.faceCount();
    // Components of one face stay.
    while (graph.count() < below) {
        below = graph.count();
        std::optional<PatchGraph> larger;
        if (below > kFewPatches) {
            larger = quartered(graph, coarser);
        }
        graph.level.neighbours.shrink_to_fit();
        levels_.push_back(std::move(graph.level));
        if (!larger) {
            return;
        }
        graph = std::move(*larger);
    }
}

const PatchLevels::Samples* PatchLevels::samplesTowards(
    const Vec3& p, int face, double facesAway
) const {
    const Level* level = nullptr;
    int patch = face;
    const double widest = kShareOfWay * facesAway;
    for (const Level& larger : levels_) {
        const auto faces = static_cast<double>(levels_.front().patchOf.size());
        if (faces > widest * widest * larger.count()) {
            break;
        }
        level = &larger;
        patch = larger.patchOf[patch];
    }
    if (level == nullptr) {
        return nullptr;
    }
    const int start = patch;
    double least = (level->centres[patch] - p).squaredNorm();
    for (int before = -1; patch != before;) {
        before = patch;
        for (int i = level->offsets[before]; i < level->offsets[before + 1]; ++i) {
            const int neighbour = level->neighbours[i];
            const double distance = (level->centres[neighbour] - p).squaredNorm();
            if (distance < least) {
                least = distance;
                patch = neighbour;
            }
        }
    }
    return patch != start ? &level->samples[patch] : nullptr;
}

}  // namespace bspline_curve

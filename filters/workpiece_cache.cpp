// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/workpiece_cache.h"

#include "bspline_curve/progress.h"
#include "bspline_curve/whole_shell.h"
#include "workpiece/layer_ids.h"
#include "workpiece/workpiece_parts.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <utility>

namespace bspline_curve {

namespace {

/// Mixes words into a hash; the constants are those of the SplitMix64 generator.
class Hash {
public:
    void add(std::uint64_t word) {
        state_ = (state_ ^ word) + 0x9e3779b97f4a7c15ULL;
        state_ = (state_ ^ (state_ >> 30U)) * 0xbf58476d1ce4e5b9ULL;
        state_ = (state_ ^ (state_ >> 27U)) * 0x94d049bb133111ebULL;
        state_ ^= state_ >> 31U;
    }

    void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }

    void add(int number) { add(static_cast<std::uint64_t>(static_cast<std::uint32_t>(number))); }

    [[nodiscard]] std::uint64_t value() const { return state_; }

private:
    std::uint64_t state_ = 0;
};

std::uint64_t hashOf(const TriangleMesh& mesh, const ShellOptions& options) {
    Hash hash;
    for (const Vec3& vertex : mesh.vertices) {
        for (const double x : vertex) {
            hash.add(x);
        }
    }
    for (const Triangle& face : mesh.faces) {
        for (const int v : face) {
            hash.add(v);
        }
    }
    hash.add(static_cast<int>(options.kind));
    hash.add(options.smoothingPasses);
    for (const double x : {options.thickness, options.targetThickness, options.targetEdgeLength}) {
        hash.add(x);
    }
    return hash.value();
}

/// Bit by bit, so that not even the sign of a zero differs.
template <class Element>
bool isSame(const std::vector<Element>& a, const std::vector<Element>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Element)) == 0;
}

bool isSame(const TriangleMesh& a, const TriangleMesh& b) {
    static_assert(sizeof(Vec3) == 3 * sizeof(double), "no padding to compare");
    return isSame(a.vertices, b.vertices) && isSame(a.faces, b.faces);
}

/// Strictness aside: it decides whether a mesh is taken, not what is made of it.
bool areSame(const PreparingOptions& a, const PreparingOptions& b) {
    MendingOptions mending = a.mending;
    mending.strict = b.mending.strict;
    return a.shell == b.shell && mending == b.mending;
}

}  // namespace

WorkpieceCache::Found WorkpieceCache::findOrMake(
    const TriangleMesh& mesh, const PreparingOptions& options, const Progress& progress
) {
    options.mending.validate();
    const std::uint64_t hash = hashOf(mesh, options.shell);
    {
        const MutexLock lock(mutex_);
        const auto found = std::ranges::find_if(entries_, [&](const Entry& entry) {
            return entry.hash == hash && areSame(entry.workpiece->options(), options) &&
                   isSame(mesh, entry.workpiece->mesh());
        });
        if (found != entries_.end()) {
            const auto refusal = surfaceOf(*found->workpiece).provenance().refusal();
            if (refusal && options.mending.strict) {
                throw InputError(*refusal);
            }
            entries_.splice(entries_.begin(), entries_, found);
            return {.workpiece = found->workpiece, .isKept = true};
        }
    }
    auto made = std::make_shared<const Workpiece>(mesh, options, progress);
    const MutexLock lock(mutex_);
    entries_.push_front({.hash = hash, .workpiece = made});
    while (entries_.size() > capacity_) {
        entries_.pop_back();
    }
    return {.workpiece = std::move(made), .isKept = false};
}

WorkpieceCache::Found WorkpieceCache::ready(
    const LayerInput& layer, const PreparingOptions& options, const Progress& progress
) {
    constexpr double kValidatedShare = 0.2;
    return madeFrom(layer, [&] {
        Found found = findOrMake(layer.mesh, options, partOf(progress, 0.0, kValidatedShare));
        prepareWithKeptShell(*found.workpiece, partOf(progress, kValidatedShare, 1.0));
        return found;
    });
}

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/designer_cache.h"

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

}  // namespace

std::optional<DesignerCache::Found> DesignerCache::find(
    std::uint64_t hash, const TriangleMesh& mesh, const ShellOptions& options, double weld
) {
    const std::scoped_lock lock(mutex_);
    const auto found = std::ranges::find_if(entries_, [&](const Entry& entry) {
        return entry.hash == hash && entry.options == options && entry.weld == weld &&
               isSame(mesh, entry.mesh());
    });
    if (found == entries_.end()) {
        return std::nullopt;
    }
    entries_.splice(entries_.begin(), entries_, found);
    return Found{.designer = found->designer, .mending = found->mending, .isKept = true};
}

DesignerCache::Found DesignerCache::findOrMake(
    const TriangleMesh& mesh,
    const ShellOptions& options,
    const std::function<Mended<CurveDesigner>()>& make,
    double weld
) {
    const std::uint64_t hash = hashOf(mesh, options);
    if (std::optional<Found> found = find(hash, mesh, options, weld)) {
        return *std::move(found);
    }
    Mended<CurveDesigner> mended = make();
    Entry entry{
        .hash = hash,
        .options = options,
        .weld = weld,
        .designer = std::make_shared<const CurveDesigner>(std::move(mended.made)),
        .mending = nullptr
    };
    if (mended.mending) {
        entry.mending = std::make_shared<const Mending>(*std::move(mended.mending));
        entry.given = mesh;
    }
    Found found{.designer = entry.designer, .mending = entry.mending, .isKept = false};
    const std::scoped_lock lock(mutex_);
    entries_.push_front(std::move(entry));
    while (entries_.size() > capacity_) {
        entries_.pop_back();
    }
    return found;
}

}  // namespace bspline_curve

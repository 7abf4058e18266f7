// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/progress.h"
#include "shell/simplify/operations.h"
#include "surface/surface_point.h"
#include "utility/index_sets.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <functional>
#include <optional>

namespace bspline_curve {
namespace {

// The queue may be a quarter longer than needed, and this much.
constexpr std::size_t kSpareEdges = 4096;
// How often the progress callback is asked, in edges.
constexpr int kProgressInterval = 1024;

}  // namespace

void Collapser::run(double length, const Progress& progress) {
    pushAll(length);
    const double all = std::max<double>(1.0, static_cast<double>(queue_.size()));
    for (int count = 1; !queue_.empty(); ++count) {
        const Edge edge = pop();
        if (count % kProgressInterval == 0) {
            // New edges come as well, so the share of the first ones is what surely never falls.
            report(progress, std::min(1.0, count / all), "simplifying the shell");
        }
        if (!editor_.complex().hasEdge(edge.a, edge.b)) {
            continue;
        }
        const std::uint64_t key =
            static_cast<std::uint64_t>(edge.a) << 32U | static_cast<std::uint32_t>(edge.b);
        const auto failed = failed_.find(key);
        const bool inVain =
            failed != failed_.end() &&
            failed->second >= std::max(editor_.changed(edge.a), editor_.changed(edge.b));
        if (!inVain && !collapseEither(edge, length)) {
            failed_[key] = editor_.time();
        }
    }
}

// Pushes the edge between two pillars if it is shorter than a length.
void Collapser::push(int a, int b, double length) {
    const double edgeLength = editor_.middleLength(a, b);
    if (edgeLength >= length) {
        return;
    }
    if (queue_.size() >= queueLimit_) {
        dropStale();
    }
    queue_.push_back({edgeLength, std::min(a, b), std::max(a, b)});
    std::ranges::push_heap(queue_, std::greater<>());
}

Collapser::Edge Collapser::pop() {
    std::ranges::pop_heap(queue_, std::greater<>());
    const Edge edge = queue_.back();
    queue_.pop_back();
    return edge;
}

// Drops edges that are no more (one that comes back is pushed again) or listed twice.
void Collapser::dropStale() {
    sortUnique(queue_);
    std::erase_if(queue_, [&](const Edge& edge) {
        return !editor_.complex().hasEdge(edge.a, edge.b);
    });
    queueLimit_ = queue_.size() + queue_.size() / 4 + kSpareEdges;
    queue_.reserve(queueLimit_);
}

void Collapser::pushAll(double length) {
    const PrismComplex& complex = editor_.complex();
    for (int prism = 0; prism < complex.prismIdCount(); ++prism) {
        for (std::size_t k = 0; complex.isAlive(prism) && k < 3; ++k) {
            const int a = complex.pillarsOf(prism)[k];
            const int b = complex.pillarsOf(prism)[(k + 1) % 3];
            // Each edge from one side, at the rim from the only one; frozen edges stay anyway.
            if (a < b) {
                push(a, b, length);
            }
        }
    }
}

// The edges of the prisms around a pillar.
void Collapser::pushAround(int pillar, double length) {
    around_.clear();
    editor_.complex().appendPrismsAround(pillar, around_);
    for (const int prism : around_) {
        const Triangle& pillars = editor_.complex().pillarsOf(prism);
        const int k = cornerOf(pillars, pillar);
        push(pillar, pillars[(k + 1) % 3], length);
        push(pillars[(k + 1) % 3], pillars[(k + 2) % 3], length);
    }
}

bool Collapser::collapseEither(const Edge& edge, double length) {
    // Rather keep what is on a crease, then what has the longer pillar.
    const auto worth = [&](int v) {
        const Pillar pillar = editor_.pillarAt(v);
        return std::pair(creases_.degree(v), (pillar.top - pillar.bottom).norm());
    };
    const bool keepA = worth(edge.a) > worth(edge.b);
    const int first = keepA ? edge.b : edge.a;
    const int second = keepA ? edge.a : edge.b;
    if (collapse(first, second)) {
        pushAround(second, length);
        return true;
    }
    if (collapse(second, first)) {
        pushAround(first, length);
        return true;
    }
    return false;
}

bool Collapser::collapse(int removed, int kept) {
    if (editor_.isFrozen(removed) ||
        (creases_.degree(removed) != 0 &&
         (creases_.degree(removed) != 2 || !creases_.holdEdge(removed, kept)))) {
        return false;
    }
    if (!propose(removed, kept) || !(editor_.replace() || turnAndReplace(removed, kept))) {
        return false;
    }
    if (creases_.degree(removed) != 0) {
        creases_.collapse(removed, kept);
    }
    return true;
}

bool Collapser::propose(int removed, int kept) {
    editor_.proposeStar(removed);
    if (!keepsTopology(removed, kept)) {
        return false;
    }
    const double now = editor_.leastQuality();
    std::erase_if(editor_.fresh, [&](Triangle& pillars) {
        const bool holdsEdge = cornerOf(pillars, kept) >= 0;
        pillars[cornerOf(pillars, removed)] = kept;
        return holdsEdge;
    });
    return editor_.leastQuality() >= std::min(now, kSimplifier.leastQuality);
}

// Link condition: the pillars next to both ends are those of the edge's two prisms, and those two
// with `kept` are not yet a prism.
bool Collapser::keepsTopology(int removed, int kept) {
    const PrismComplex& complex = editor_.complex();
    const std::vector<int>& star = editor_.old;
    around_.clear();
    complex.appendPrismsAround(kept, around_);
    if (star.size() + around_.size() > kSimplifier.maxValence + 4) {
        return false;
    }
    const auto neighbours = [&](const std::vector<int>& prisms, int pillar, std::vector<int>& to) {
        to.clear();
        for (const int prism : prisms) {
            for (const int other : complex.pillarsOf(prism)) {
                if (other != pillar) {
                    to.push_back(other);
                }
            }
        }
        sortUnique(to);
    };
    neighbours(star, removed, ring_);
    neighbours(around_, kept, near_);
    const auto common = std::ranges::count_if(ring_, [&](int pillar) {
        return std::ranges::binary_search(near_, pillar);
    });
    const auto shared = std::ranges::count_if(star, [&](int prism) {
        return cornerOf(complex.pillarsOf(prism), kept) >= 0;
    });
    if (common != 2 || shared != 2) {
        return false;
    }
    return star.size() > 3 || std::ranges::none_of(around_, [&](int prism) {
               return std::ranges::all_of(complex.pillarsOf(prism), [&](int pillar) {
                   return pillar == kept || std::ranges::binary_search(ring_, pillar);
               });
           });
}

// The same collapse with another pillar at `kept`: along the mean normal of the patch, between the
// directions of both, in the middle of the edge, at last half as long.
bool Collapser::turnAndReplace(int removed, int kept) {
    if (editor_.isFrozen(kept)) {
        return false;
    }
    const PrismComplex& complex = editor_.complex();
    for (const int prism : around_) {
        const Triangle& pillars = complex.pillarsOf(prism);
        if (cornerOf(pillars, removed) < 0) {
            editor_.old.push_back(prism);
            editor_.fresh.push_back(pillars);
        }
    }
    const Pillar before = editor_.pillarAt(kept);
    const Pillar other = editor_.pillarAt(removed);
    const double top = (before.top - before.middle).norm();
    const double bottom = (before.bottom - before.middle).norm();
    const auto tryAt = [&](const Vec3& middle, const Vec3& direction, double share) {
        return editor_.replaceWith(
            kept, {middle - share * bottom * direction, middle, middle + share * top * direction}
        );
    };
    const Vec3 normal = editor_.meanNormal();
    const Vec3 between =
        ((before.top - before.bottom).normalized() + (other.top - other.bottom).normalized())
            .normalized();
    if (tryAt(before.middle, normal, 1.0) || tryAt(before.middle, between, 1.0)) {
        return true;
    }
    if (creases_.degree(kept) == 0) {
        const std::optional<Vec3> middle =
            editor_.onSurface(0.5 * (before.middle + other.middle), normal);
        if (middle && tryAt(*middle, normal, 1.0)) {
            return true;
        }
    }
    return tryAt(before.middle, normal, 0.5);
}

}  // namespace bspline_curve

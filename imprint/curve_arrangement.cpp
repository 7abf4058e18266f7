// SPDX-License-Identifier: GPL-3.0-or-later
#include "imprint/curve_arrangement.h"

#include "bspline_curve/error.h"
#include "surface/predicates.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace bspline_curve {

namespace {

/// Rounds of dividing in one face. Two or three are usual; each begins from nodes that are farther
/// apart than the snapping distance.
constexpr int kMaxRounds = 100;

int turn(const FacePlace& a, const FacePlace& b, const FacePlace& c) {
    constexpr int kDropped = 2;
    return projectedOrientationSign(a, b, c, kDropped);
}

}  // namespace

/// A segment with its ends in the face.
struct CurveArrangement::Placed {
    ImprintSegment segment;
    FacePlace a, b;

    [[nodiscard]] FacePlace low() const { return a.cwiseMin(b); }

    [[nodiscard]] FacePlace high() const { return a.cwiseMax(b); }

    /// Whether a place is strictly between the ends and within `snap` of the segment.
    [[nodiscard]] bool passes(const FacePlace& place, double snap) const {
        const FacePlace along = b - a;
        const double share = (place - a).dot(along) / along.squaredNorm();
        if (share <= 0.0 || share >= 1.0) {
            return false;
        }
        return (place - a - share * along).norm() <= snap || turn(a, b, place) == 0;
    }

    [[nodiscard]] bool crosses(const Placed& other) const {
        return turn(a, b, other.a) * turn(a, b, other.b) < 0 &&
               turn(other.a, other.b, a) * turn(other.a, other.b, b) < 0;
    }

    [[nodiscard]] FacePlace crossing(const Placed& other) const {
        const FacePlace along = b - a;
        const FacePlace across = other.b - other.a;
        const FacePlace between = other.a - a;
        const double share = (between.x() * across.y() - between.y() * across.x()) /
                             (along.x() * across.y() - along.y() * across.x());
        return a + std::clamp(share, 0.0, 1.0) * along;
    }
};

void CurveArrangement::add(int face, int from, int to) {
    insert(face, from, to);
}

void CurveArrangement::insert(int face, int a, int b) {
    if (a == b || nodes_.commonSide(a, b, face) >= 0) {
        return;
    }
    const ImprintSegment segment{std::min(a, b), std::max(a, b)};
    const int* node = dividedAt(face, segment);
    if (node != nullptr) {
        insert(face, a, *node);
        insert(face, *node, b);
    } else {
        segments_[face].insert(segment);
        unresolved_.insert(face);
    }
}

const int* CurveArrangement::dividedAt(int face, ImprintSegment segment) const {
    const auto inFace = divisions_.find(face);
    if (inFace == divisions_.end()) {
        return nullptr;
    }
    const auto found = inFace->second.find(segment);
    return found != inFace->second.end() ? &found->second : nullptr;
}

std::vector<int> CurveArrangement::faces() const {
    std::vector<int> faces;
    for (const auto& [face, segments] : segments_) {
        if (!segments.empty()) {
            faces.push_back(face);
        }
    }
    return faces;
}

std::vector<CurveArrangement::Placed> CurveArrangement::placed(int face) const {
    std::vector<Placed> all;
    for (const ImprintSegment& segment : segments_.at(face)) {
        all.push_back({segment, nodes_.placeIn(segment.a, face), nodes_.placeIn(segment.b, face)});
    }
    std::ranges::stable_sort(all, {}, [](const Placed& one) { return one.low().x(); });
    return all;
}

void CurveArrangement::resolve() {
    // In order of faces, so that nothing depends on the order of the curves.
    while (!unresolved_.empty()) {
        const int face = *unresolved_.begin();
        int rounds = 0;
        while (resolveFace(face)) {
            if (++rounds > kMaxRounds) {
                throw InputError(
                    InputErrorCode::NoPath,
                    "the curves in face " + std::to_string(face) +
                        " cross too closely to be told apart; snap over a larger distance, or "
                        "leave some of them out",
                    {face}
                );
            }
        }
        unresolved_.erase(face);
    }
}

/// One round; whether anything was divided.
bool CurveArrangement::resolveFace(int face) {
    const std::vector<Placed> segments = placed(face);
    if (divideAtNodes(face, segments)) {
        return true;
    }
    return divideAtCrossings(face, segments);
}

bool CurveArrangement::divideAtNodes(int face, const std::vector<Placed>& segments) {
    struct At {
        FacePlace place;
        int node;
    };

    std::vector<At> all;
    for (const int node : nodes_.allIn(face)) {
        all.push_back({nodes_.placeIn(node, face), node});
    }
    std::ranges::sort(all, [](const At& one, const At& other) {
        return std::pair(one.place.x(), one.node) < std::pair(other.place.x(), other.node);
    });
    const double snap = snap_.in(face);
    bool divided = false;
    for (const Placed& one : segments) {
        const double last = one.high().x() + snap;
        for (auto at = std::ranges::lower_bound(
                 all, one.low().x() - snap, {}, [](const At& each) { return each.place.x(); }
             );
             at != all.end() && at->place.x() <= last;
             ++at) {
            if (at->node != one.segment.a && at->node != one.segment.b &&
                one.passes(at->place, snap) && divide(face, one.segment, at->node)) {
                largestMove_ = std::max(largestMove_, distance(one.segment, at->node));
                divided = true;
                break;  // its halves come in the next round
            }
        }
    }
    return divided;
}

/// Distance of a node from a segment in space.
double CurveArrangement::distance(ImprintSegment segment, int node) const {
    const Vec3 start = nodes_.position(segment.a);
    const Vec3 along = (nodes_.position(segment.b) - start).normalized();
    const Vec3 offset = nodes_.position(node) - start;
    return (offset - offset.dot(along) * along).norm();
}

bool CurveArrangement::divideAtCrossings(int face, const std::vector<Placed>& segments) {
    bool divided = false;
    std::vector<char> isWhole(segments.size(), 1);
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const double last = segments[i].high().x();
        for (std::size_t j = i + 1;
             j < segments.size() && isWhole[i] != 0 && segments[j].low().x() <= last;
             ++j) {
            if (isWhole[j] == 0 || !segments[i].crosses(segments[j])) {
                continue;
            }
            const int node = addCrossing(face, segments[i], segments[j]);
            const bool first = divide(face, segments[i].segment, node);
            const bool second = divide(face, segments[j].segment, node);
            isWhole[i] = first ? 0 : 1;
            isWhole[j] = second ? 0 : 1;
            divided = divided || first || second;
        }
    }
    return divided;
}

int CurveArrangement::addCrossing(int face, const Placed& one, const Placed& other) {
    const FacePlace place = one.crossing(other);
    const SurfacePoint crossing{
        .face = face, .barycentric = Vec3(1.0 - place.x() - place.y(), place.x(), place.y())
    };
    const int before = nodes_.count();
    const int node = nodes_.add(face, crossing.barycentric);
    largestMove_ =
        std::max(largestMove_, (nodes_.position(node) - surface_.position(crossing)).norm());
    if (node == before && nodes_[node].on == ImprintNode::On::Edge) {
        for (const int holder : nodes_.facesOfEdge(nodes_[node].element)) {
            if (holder != face && segments_.contains(holder)) {
                unresolved_.insert(holder);
            }
        }
    }
    return node;
}

bool CurveArrangement::divide(int face, ImprintSegment segment, int node) {
    if (node == segment.a || node == segment.b) {
        return false;
    }
    segments_.at(face).erase(segment);
    divisions_[face].emplace(segment, node);
    insert(face, segment.a, node);
    insert(face, node, segment.b);
    return true;
}

void CurveArrangement::appendPath(int face, int from, int to, std::vector<int>& path) const {
    if (from == to) {
        return;
    }
    const int* node = dividedAt(face, {std::min(from, to), std::max(from, to)});
    if (node != nullptr) {
        appendPath(face, from, *node, path);
        appendPath(face, *node, to, path);
        return;
    }
    const int side = nodes_.commonSide(from, to, face);
    if (side >= 0) {
        const auto share = [&](int each) {
            const FacePlace place = nodes_.placeIn(each, face);
            const std::array<double, 3> barycentric{
                1.0 - place.x() - place.y(), place.x(), place.y()
            };
            return barycentric.at((side + 2) % 3);
        };
        std::vector<int> between = nodes_.onSide(face, side);
        const auto [low, high] = std::minmax({share(from), share(to)});
        std::erase_if(between, [&](int each) { return share(each) <= low || share(each) >= high; });
        if (share(from) > share(to)) {
            std::ranges::reverse(between);
        }
        path.insert(path.end(), between.begin(), between.end());
    }
    path.push_back(to);
}

}  // namespace bspline_curve

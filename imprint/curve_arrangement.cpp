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

[[noreturn]] void refuseFace(int face) {
    throw InputError(
        InputErrorCode::NoPath,
        "the curves in face " + std::to_string(face) +
            " cross too closely to be told apart; snap over a larger distance, or leave some of "
            "them out",
        {face}
    );
}

ImprintSegment between(int one, int other) {
    return {std::min(one, other), std::max(one, other)};
}

int turn(const FacePlace& a, const FacePlace& b, const FacePlace& c) {
    constexpr int kDropped = 2;
    return projectedOrientationSign(a, b, c, kDropped);
}

}  // namespace

/// Whether a place is strictly between the ends, nearer to each than these are to each other, and
/// within `snap` of the segment. So halves are shorter: of three places a little more than `snap`
/// apart each may be as near to the segment between the others.
bool CurveArrangement::Placed::passes(const FacePlace& place, double snap) const {
    const FacePlace along = b - a;
    const double length = along.squaredNorm();
    const double share = (place - a).dot(along) / length;
    if (share <= 0.0 || share >= 1.0 || (place - a).squaredNorm() >= length ||
        (place - b).squaredNorm() >= length) {
        return false;
    }
    return (place - a - share * along).norm() <= snap || turn(a, b, place) == 0;
}

bool CurveArrangement::Placed::crosses(const Placed& other) const {
    return turn(a, b, other.a) * turn(a, b, other.b) < 0 &&
           turn(other.a, other.b, a) * turn(other.a, other.b, b) < 0;
}

FacePlace CurveArrangement::Placed::crossing(const Placed& other) const {
    const FacePlace along = b - a;
    const FacePlace across = other.b - other.a;
    const FacePlace offset = other.a - a;
    const double share = (offset.x() * across.y() - offset.y() * across.x()) /
                         (along.x() * across.y() - along.y() * across.x());
    return a + std::clamp(share, 0.0, 1.0) * along;
}

void CurveArrangement::insert(int face, int a, int b) {
    if (a == b || nodes_.commonSide(a, b, face) >= 0) {
        return;
    }
    const ImprintSegment segment = between(a, b);
    const int* node = dividedAt(face, segment);
    if (node != nullptr) {
        insert(face, a, *node);
        insert(face, *node, b);
        return;
    }
    const int slot = slotOf_.at(face, static_cast<int>(slots_.size()));
    if (slot == static_cast<int>(slots_.size())) {
        slots_.push_back({.face = face});
    }
    std::vector<ImprintSegment>& segments = slots_[slot].segments;
    const auto place = std::ranges::lower_bound(segments, segment);
    if (place == segments.end() || *place != segment) {
        segments.insert(place, segment);
        slots_[slot].isResolved = false;
    }
}

const int* CurveArrangement::dividedAt(int face, ImprintSegment segment) const {
    const int* slot = slotOf_.find(face);
    if (slot == nullptr) {
        return nullptr;
    }
    const auto& divisions = slots_[*slot].divisions;
    const auto found =
        std::ranges::lower_bound(divisions, segment, {}, &std::pair<ImprintSegment, int>::first);
    return found != divisions.end() && found->first == segment ? &found->second : nullptr;
}

bool CurveArrangement::passesAlong(int face, ImprintSegment whole, ImprintSegment part) const {
    if (whole == part) {
        return true;
    }
    const int* node = dividedAt(face, whole);
    return node != nullptr && (passesAlong(face, between(whole.a, *node), part) ||
                               passesAlong(face, between(*node, whole.b), part));
}

std::vector<int> CurveArrangement::faces() const {
    std::vector<int> faces;
    for (const FaceSegments& slot : slots_) {
        if (!slot.segments.empty()) {
            faces.push_back(slot.face);
        }
    }
    return faces;
}

std::span<const ImprintSegment> CurveArrangement::segmentsIn(int face) const {
    const int* slot = slotOf_.find(face);
    return slot != nullptr ? std::span(slots_[*slot].segments) : std::span<ImprintSegment>();
}

void CurveArrangement::resolve() {
    // In order of faces, so that nothing depends on the order of the curves. A face can unsettle
    // its neighbours, which come in the next pass.
    for (;;) {
        std::vector<int> unresolved;
        for (const FaceSegments& slot : slots_) {
            if (!slot.isResolved) {
                unresolved.push_back(slot.face);
            }
        }
        if (unresolved.empty()) {
            return;
        }
        std::ranges::sort(unresolved);
        for (const int face : unresolved) {
            int rounds = 0;
            while (resolveFace(face)) {
                if (++rounds > kMaxRounds) {
                    refuseFace(face);
                }
            }
            slots_[*slotOf_.find(face)].isResolved = true;
        }
    }
}

void CurveArrangement::placeAll(int face) {
    placed_.clear();
    for (const ImprintSegment& segment : segmentsIn(face)) {
        placed_.push_back(
            {segment, nodes_.placeIn(segment.a, face), nodes_.placeIn(segment.b, face)}
        );
    }
    std::ranges::stable_sort(placed_, {}, &Placed::low);
    listed_.clear();
    nodes_.appendInside(face, listed_);
    for (int k = 0; k < 3; ++k) {
        nodes_.appendOnSide(face, k, listed_);
        listed_.push_back(~surface_.faces()[face][k]);
    }
    placedNodes_.clear();
    for (const int node : listed_) {
        placedNodes_.push_back({nodes_.placeIn(node, face), node});
    }
    std::ranges::sort(placedNodes_, [](const PlacedNode& one, const PlacedNode& other) {
        return std::pair(one.place.x(), one.node) < std::pair(other.place.x(), other.node);
    });
}

/// One round; whether anything was divided.
bool CurveArrangement::resolveFace(int face) {
    placeAll(face);
    return divideAtNodes(face) || divideAtCrossings(face);
}

bool CurveArrangement::divideAtNodes(int face) {
    const double snap = snap_.in(face);
    bool divided = false;
    for (const Placed& one : placed_) {
        const double last = one.high() + snap;
        for (auto at = std::ranges::lower_bound(
                 placedNodes_,
                 one.low() - snap,
                 {},
                 [](const PlacedNode& each) { return each.place.x(); }
             );
             at != placedNodes_.end() && at->place.x() <= last;
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

bool CurveArrangement::divideAtCrossings(int face) {
    bool divided = false;
    std::vector<char> isWhole(placed_.size(), 1);
    for (std::size_t i = 0; i < placed_.size(); ++i) {
        const double last = placed_[i].high();
        for (std::size_t j = i + 1;
             j < placed_.size() && isWhole[i] != 0 && placed_[j].low() <= last;
             ++j) {
            if (isWhole[j] == 0 || !placed_[i].crosses(placed_[j])) {
                continue;
            }
            const int node = addCrossing(face, placed_[i], placed_[j]);
            const bool first = divide(face, placed_[i].segment, node);
            const bool second = divide(face, placed_[j].segment, node);
            isWhole[i] = first ? 0 : 1;
            isWhole[j] = second ? 0 : 1;
            divided = divided || first || second;
        }
    }
    return divided;
}

int CurveArrangement::addCrossing(int face, const Placed& one, const Placed& other) {
    const SurfacePoint crossing{.face = face, .barycentric = barycentricAt(one.crossing(other))};
    const int before = nodes_.count();
    const int node = nodes_.add(face, crossing.barycentric);
    largestMove_ =
        std::max(largestMove_, (nodes_.position(node) - surface_.position(crossing)).norm());
    if (node == before && nodes_[node].on == ImprintNode::On::Edge) {
        for (const int holder : nodes_.facesOfEdge(nodes_[node].element)) {
            const int* slot = holder >= 0 ? slotOf_.find(holder) : nullptr;
            if (slot != nullptr) {
                slots_[*slot].isResolved = false;
            }
        }
    }
    return node;
}

bool CurveArrangement::divide(int face, ImprintSegment segment, int node) {
    if (node == segment.a || node == segment.b) {
        return false;
    }
    if (passesAlong(face, between(segment.a, node), segment) ||
        passesAlong(face, between(node, segment.b), segment)) {
        refuseFace(face);  // a crossing moved to a node, and back
    }
    FaceSegments& slot = slots_[*slotOf_.find(face)];
    slot.segments.erase(std::ranges::lower_bound(slot.segments, segment));
    const std::pair division(segment, node);
    slot.divisions.insert(std::ranges::lower_bound(slot.divisions, division), division);
    insert(face, segment.a, node);
    insert(face, node, segment.b);
    return true;
}

void CurveArrangement::appendPath(int face, int from, int to, std::vector<int>& path) const {
    if (from == to) {
        return;
    }
    const int* node = dividedAt(face, between(from, to));
    if (node != nullptr) {
        appendPath(face, from, *node, path);
        appendPath(face, *node, to, path);
        return;
    }
    const int side = nodes_.commonSide(from, to, face);
    if (side >= 0) {
        const auto share = [&](int each) {
            return barycentricAt(nodes_.placeIn(each, face))[(side + 2) % 3];
        };
        const auto [low, high] = std::minmax({share(from), share(to)});
        std::vector<int> inner;
        nodes_.appendOnSide(face, side, inner);
        std::erase_if(inner, [&](int each) { return share(each) <= low || share(each) >= high; });
        if (share(from) > share(to)) {
            std::ranges::reverse(inner);
        }
        path.insert(path.end(), inner.begin(), inner.end());
    }
    path.push_back(to);
}

}  // namespace bspline_curve

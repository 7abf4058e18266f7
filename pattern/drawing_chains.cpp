// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/drawing_chains.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace bspline_curve {

namespace {

using Vec2 = Eigen::Vector2d;

constexpr double kMeetRelative = 1e-6;

/// An end of a path: 2 * path for its start, 2 * path + 1 for its end.
using End = int;

const Vec2& placeOf(const Drawing& drawing, End end) {
    const std::vector<DrawingArc>& arcs = drawing.paths[end / 2].arcs;
    return end % 2 == 0 ? arcs.front().points.front() : arcs.back().points.back();
}

/// Finds the ends near to an end by squares of the plane.
class Meetings {
public:
    Meetings(const Drawing& drawing, double distance) : drawing_(drawing), distance_(distance) {
        for (End end = 0; end < 2 * static_cast<int>(drawing.paths.size()); ++end) {
            if (!drawing.paths[end / 2].closed) {
                squares_[squareOf(placeOf(drawing, end))].push_back(end);
            }
        }
    }

    /// The only other end that meets this one, or -1.
    [[nodiscard]] End partnerOf(End end) const {
        const Vec2& place = placeOf(drawing_, end);
        const Square square = squareOf(place);
        End partner = -1;
        int count = 0;
        for (std::int64_t dx = -1; dx <= 1; ++dx) {
            for (std::int64_t dy = -1; dy <= 1; ++dy) {
                const auto found = squares_.find({square[0] + dx, square[1] + dy});
                if (found == squares_.end()) {
                    continue;
                }
                for (const End other : found->second) {
                    if (other != end && (placeOf(drawing_, other) - place).norm() <= distance_) {
                        partner = other;
                        ++count;
                    }
                }
            }
        }
        return count == 1 ? partner : -1;
    }

private:
    using Square = std::array<std::int64_t, 2>;

    [[nodiscard]] Square squareOf(const Vec2& place) const {
        return {std::llround(place.x() / distance_), std::llround(place.y() / distance_)};
    }

    const Drawing& drawing_;
    double distance_;
    std::map<Square, std::vector<End>> squares_;
};

/// Adds a path to a chain, from one of its ends to the other.
void append(DrawingPath& chain, const DrawingPath& path, bool backwards) {
    std::vector<DrawingArc> arcs = path.arcs;
    if (backwards) {
        std::ranges::reverse(arcs);
        for (DrawingArc& arc : arcs) {
            std::ranges::reverse(arc.points);
            std::ranges::reverse(arc.weights);
        }
    }
    if (!chain.arcs.empty()) {
        arcs.front().points.front() = chain.arcs.back().points.back();
    }
    std::ranges::move(arcs, std::back_inserter(chain.arcs));
}

}  // namespace

Drawing chained(const Drawing& drawing) {
    const double size = drawing.box().isEmpty() ? 0.0 : drawing.box().diagonal().norm();
    if (!(size > 0.0)) {
        return drawing;
    }
    const Meetings meetings(drawing, kMeetRelative * size);
    std::vector<End> partners(2 * drawing.paths.size(), -1);
    for (End end = 0; end < static_cast<int>(partners.size()); ++end) {
        if (!drawing.paths[end / 2].closed) {
            partners[end] = meetings.partnerOf(end);
        }
    }
    std::vector<bool> isTaken(drawing.paths.size(), false);
    Drawing result{.paths = {}, .baseline = drawing.baseline};
    for (int first = 0; first < static_cast<int>(drawing.paths.size()); ++first) {
        if (isTaken[first]) {
            continue;
        }
        // Back to the chain's start, or once round.
        End start = 2 * first;
        while (partners[start] >= 0 && partners[start] / 2 != first) {
            start = partners[start] ^ 1;
        }
        DrawingPath chain;
        End at = start;
        do {
            isTaken[at / 2] = true;
            append(chain, drawing.paths[at / 2], at % 2 == 1);
            at = partners[at ^ 1];
        } while (at >= 0 && at != start);
        chain.closed = drawing.paths[first].closed || (at >= 0 && at == start);
        if (chain.closed) {
            chain.arcs.back().points.back() = chain.arcs.front().points.front();
        }
        chain.number = static_cast<int>(result.paths.size());
        result.paths.push_back(std::move(chain));
    }
    return result;
}

}  // namespace bspline_curve

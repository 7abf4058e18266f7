// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/close_chords.h"

#include "projection/fibre_projector.h"

#include <cmath>
#include <cstddef>

namespace bspline_curve {
namespace {

// More are needed only where no walk over the surface leads from one end of a chord to the other.
constexpr int kMostHalvings = 8;

struct Chord {
    SurfacePoint begin;
    bool isClose;
};

struct Foot {
    Vec3 point;
    FootPoint foot;
    FootFrame frame;
};

// Of the midpoints of the chords that may not be close, in their order.
std::vector<Foot> feetOfMidpoints(
    const ExtendedSurface& extended,
    const FibreProjector& finder,
    const std::vector<Chord>& chords,
    const SurfacePoint& end
) {
    std::vector<Foot> feet;
    for (std::size_t i = 0; i < chords.size(); ++i) {
        if (!chords[i].isClose) {
            const SurfacePoint& from = chords[i].begin;
            const SurfacePoint& to = i + 1 < chords.size() ? chords[i + 1].begin : end;
            const Vec3 middle = 0.5 * (extended.position(from) + extended.position(to));
            feet.push_back({middle, {from.face, from.barycentric[1], from.barycentric[2]}, {}});
        }
    }
    std::vector<FibreProjector::Move> moves;
    moves.reserve(feet.size());
    for (Foot& foot : feet) {
        moves.push_back({foot.point, &foot.foot, &foot.frame});
    }
    finder.moveAll(moves);
    return feet;
}

}  // namespace

std::optional<std::vector<SurfacePoint>> withCloseChords(
    const ExtendedSurface& extended,
    const PatchLevels* patches,
    std::span<const SurfacePoint> path,
    double distance
) {
    const FibreProjector finder(extended, patches);
    std::vector<Chord> chords;
    for (const SurfacePoint& point : path.first(path.size() - 1)) {
        chords.push_back({point, false});
    }
    for (int halvings = 0; halvings < kMostHalvings; ++halvings) {
        const std::vector<Foot> feet = feetOfMidpoints(extended, finder, chords, path.back());
        auto foot = feet.begin();
        std::vector<Chord> halved;
        halved.reserve(chords.size() + feet.size());
        for (const Chord& chord : chords) {
            halved.push_back(chord);
            if (chord.isClose) {
                continue;
            }
            const auto& [middle, at, frame] = *foot++;
            if (std::abs(at.height) <= distance) {
                halved.back().isClose = true;
                continue;
            }
            if (at.face >= extended.surfaceFaceCount) {
                return std::nullopt;
            }
            const Vec3 barycentric = at.barycentric().cwiseMax(0.0);
            halved.push_back({{at.face, barycentric / barycentric.sum()}, false});
        }
        chords.swap(halved);
        if (feet.empty()) {
            break;
        }
    }
    std::vector<SurfacePoint> points;
    points.reserve(chords.size() + 1);
    for (const Chord& chord : chords) {
        points.push_back(chord.begin);
    }
    points.push_back(path.back());
    return points;
}

}  // namespace bspline_curve

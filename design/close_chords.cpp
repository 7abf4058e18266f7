// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/close_chords.h"

#include "projection/fibre_projector.h"

#include <cmath>
#include <cstddef>
#include <utility>

namespace bspline_curve {
namespace {

// Of a chord. More are needed only where no walk over the surface leads from one end to the other.
constexpr int kMostHalvings = 8;

class ChordHalver {
public:
    ChordHalver(const ExtendedSurface& extended, const PatchLevels* patches, double distance)
        : extended_(extended), finder_(extended, patches), distance_(distance) {}

    // Adds the points of a chord but for its end; false where a foot lies beyond the boundary.
    [[nodiscard]] bool add(const SurfacePoint& from, const SurfacePoint& to, int halvings = 0) {
        if (halvings < kMostHalvings) {
            FootPoint foot{from.face, from.barycentric[1], from.barycentric[2]};
            FootFrame frame;
            finder_.move(0.5 * (extended_.position(from) + extended_.position(to)), foot, frame);
            if (std::abs(foot.height) > distance_) {
                const SurfacePoint middle = foot.surfacePoint();
                return foot.face < extended_.surfaceFaceCount && add(from, middle, halvings + 1) &&
                       add(middle, to, halvings + 1);
            }
        }
        points_.push_back(from);
        return true;
    }

    [[nodiscard]] std::vector<SurfacePoint> take(const SurfacePoint& end) {
        points_.push_back(end);
        return std::move(points_);
    }

private:
    const ExtendedSurface& extended_;
    FibreProjector finder_;
    double distance_;
    std::vector<SurfacePoint> points_;
};

}  // namespace

std::optional<std::vector<SurfacePoint>> withCloseChords(
    const ExtendedSurface& extended,
    const PatchLevels* patches,
    std::span<const SurfacePoint> path,
    double distance
) {
    ChordHalver halver(extended, patches, distance);
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        if (!halver.add(path[i], path[i + 1])) {
            return std::nullopt;
        }
    }
    return halver.take(path.back());
}

}  // namespace bspline_curve

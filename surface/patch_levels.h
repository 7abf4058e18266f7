// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/progress.h"
#include "surface/surface.h"

#include <array>
#include <vector>

namespace bspline_curve {

/// The faces of a surface in connected patches, these in larger ones, and so on: coarse graphs of
/// the surface in which a way is found in a time that hardly depends on its resolution. Patches
/// grow over edges only, so the two sides of a thin plate stay apart, and so do components.
/// Immutable, so that many threads may use it at once.
class PatchLevels {
public:
    /// Faces all over a patch, to measure it by; -1 where there are fewer.
    using Samples = std::array<int, 8>;

    /// The patches of one level, about a fifth of those below.
    struct Level {
        /// The patch of each face, or of each patch of the level below.
        std::vector<int> patchOf;
        std::vector<Vec3> centres;  ///< of area, in the user's unit
        std::vector<Samples> samples;
        /// The patches that share an edge with patch i: neighbours[offsets[i]] and on, until
        /// offsets[i + 1].
        std::vector<int> offsets, neighbours;

        [[nodiscard]] int count() const { return static_cast<int>(centres.size()); }
    };

    /// O(#F): about 30 ms for 100,000 faces. Throws Cancelled.
    explicit PatchLevels(const Surface& surface, const Progress& progress = {});

    /// Finest first, each while there are many patches; none where the surface has few faces.
    [[nodiscard]] const std::vector<Level>& levels() const { return levels_; }

    /// Faces near a point, found from a face by way of patches, each with its centre nearer to it
    /// (in the user's unit) than the one before. `facesAway`: about how many faces lie between; the
    /// more, the larger the patches. Null where no patch that small is nearer than that of the
    /// face. A few patches are looked at, unless even the largest are small beside the way.
    [[nodiscard]] const Samples* samplesTowards(const Vec3& p, int face, double facesAway) const;

private:
    std::vector<Level> levels_;
};

}  // namespace bspline_curve

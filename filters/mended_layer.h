// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/layer_input.h"
#include "surface/mending.h"
#include "surface/surface.h"

#include <memory>
#include <string>

// A layer whose mesh was mended in memory, and the way back to it.
namespace bspline_curve {

/// A layer's mesh as a surface, mended where it had to be.
struct MendedSurface {
    std::shared_ptr<const Surface> surface;
    std::shared_ptr<const Mending> mending;  ///< null: the mesh is as it was given

    [[nodiscard]] const MeshRepair* repair() const { return mending ? &mending->repair : nullptr; }
};

/// Throws InputError, with the layer's ids, see madeFrom().
[[nodiscard]] MendedSurface surfaceOf(const LayerInput& layer, const MendingOptions& options);

/// Quality and selections of a layer on its mended mesh; the mesh itself is left out.
[[nodiscard]] LayerInput carriedOver(const LayerInput& layer, const MeshRepair& repair);

/// A warning for the host's log.
[[nodiscard]] std::string describeMending(const Mending& mending);

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/layer_input.h"
#include "surface/mending.h"

#include <string>

// A layer whose mesh was mended in memory, and the way back to it.
namespace bspline_curve {

/// Quality and selections of a layer on its mended mesh; the mesh itself is left out.
[[nodiscard]] LayerInput carriedOver(const LayerInput& layer, const MeshRepair& repair);

/// A warning for the host's log.
[[nodiscard]] std::string describeMending(const Mending& mending);

}  // namespace bspline_curve

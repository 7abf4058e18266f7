// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/surface.h"

#include <cstdint>
#include <span>
#include <vector>

namespace bspline_curve {

/// A region of a surface: ids of its faces, ascending, each once.
using Region = std::vector<int>;

/// The region of faces given by id, in any order. Throws InputError (IndexOutOfRange) naming the
/// ids that are no face of the surface.
[[nodiscard]] Region makeRegion(const Surface& surface, std::span<const std::int64_t> faces);

/// The same of a mesh of so many faces.
[[nodiscard]] Region makeRegion(int faceCount, std::span<const std::int64_t> faces);

/// The faces all of whose corners are selected; one flag per vertex. Throws InputError
/// (IndexOutOfRange) where there are more or fewer flags.
[[nodiscard]] Region facesOfVertices(const Surface& surface, std::span<const char> selected);

/// The faces over whose corners the mean of a field, one value per vertex, is under (over) a
/// threshold. Throws InputError: BadField (other than one value per vertex), BadOption (a threshold
/// that is no number).
[[nodiscard]] Region facesUnder(
    const Surface& surface, std::span<const double> field, double threshold
);
[[nodiscard]] Region facesOver(
    const Surface& surface, std::span<const double> field, double threshold
);

/// One flag per face: 1 in the region.
[[nodiscard]] std::vector<char> faceFlags(const Surface& surface, const Region& region);

}  // namespace bspline_curve

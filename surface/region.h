// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"

#include <cstdint>
#include <span>
#include <vector>

namespace bspline_curve {

/// A region of a mesh: ids of its faces, ascending, each once.
using Region = std::vector<int>;

/// The region of faces given by id, in any order. Throws InputError (IndexOutOfRange) naming the
/// ids that are no face of the mesh.
[[nodiscard]] Region makeRegion(const TriangleMesh& mesh, std::span<const std::int64_t> faces);

/// The faces all of whose corners are selected; one flag per vertex. Throws InputError
/// (IndexOutOfRange) where there are more or fewer flags.
[[nodiscard]] Region facesOfVertices(const TriangleMesh& mesh, std::span<const char> selected);

/// The faces over whose corners the mean of a field, one value per vertex, is under (over) a
/// threshold. Throws InputError: BadField (other than one value per vertex), BadOption (a threshold
/// that is no number).
[[nodiscard]] Region facesUnder(
    const TriangleMesh& mesh, std::span<const double> field, double threshold
);
[[nodiscard]] Region facesOver(
    const TriangleMesh& mesh, std::span<const double> field, double threshold
);

/// One flag per face: 1 in the region.
[[nodiscard]] std::vector<char> faceFlags(const TriangleMesh& mesh, const Region& region);

}  // namespace bspline_curve

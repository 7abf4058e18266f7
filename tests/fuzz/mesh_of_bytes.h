// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"
#include "fuzz/byte_source.h"

namespace bspline_curve::fuzz {

/// A mesh of at most about a thousand faces: a surface of the tests or a soup of faces on a
/// lattice, then damaged, scaled and moved.
[[nodiscard]] TriangleMesh meshOf(ByteSource& bytes);

}  // namespace bspline_curve::fuzz

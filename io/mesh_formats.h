// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/files.h"

#include <string>

// The formats of meshes that hold more than vertices and faces; meshBytes() chooses among them.
namespace bspline_curve {

[[nodiscard]] std::string meshPly(const TriangleMesh& mesh, const MeshAttributes& attributes);
[[nodiscard]] std::string meshObj(const TriangleMesh& mesh, const MeshAttributes& attributes);

}  // namespace bspline_curve

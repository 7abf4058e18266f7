// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "host_document.h"

#include <optional>
#include <string>

// The per-vertex attributes of polylines on a surface.
namespace bspline_curve {

inline const std::string kFaceIndexAttribute = "face_index";
inline const std::string kBarycentricAttribute = "barycentric";
inline const std::string kParameterAttribute = "t";

/// vcglib of 2020.09 looks attributes up in meshes that are not const only; it does not change
/// them.
[[nodiscard]] inline CMeshO& forLookup(const CMeshO& mesh) {
    return const_cast<CMeshO&>(mesh);
}

/// A per-vertex attribute of a mesh; none where it has none of this name and type.
template <class Value>
[[nodiscard]] auto vertexAttribute(const CMeshO& mesh, const std::string& name) {
    using Allocator = vcg::tri::Allocator<CMeshO>;
    auto handle = Allocator::FindPerVertexAttribute<Value>(forLookup(mesh), name);
    return Allocator::IsValidHandle(forLookup(mesh), handle) ? std::optional(handle) : std::nullopt;
}

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <common/meshmodel.h>

#include <string>
#include <vector>

// What MeshLab's versions spell differently about documents: here, 2020.09.
namespace bspline_curve::host {

/// As hosts hand it to what describes a dialog.
using DialogDocument = MeshDocument;

[[nodiscard]] inline bool hasQuality(const MeshModel& layer) {
    return layer.hasDataMask(MeshModel::MM_VERTQUALITY);
}

[[nodiscard]] inline std::vector<const MeshModel*> layersOf(const MeshDocument& document) {
    return {document.meshList.begin(), document.meshList.end()};
}

/// Null where the document has no such layer.
[[nodiscard]] inline const MeshModel* layerWithId(const MeshDocument& document, int id) {
    return document.getMesh(id);
}

inline void removeLayer(MeshDocument& document, int id) {
    document.delMesh(document.getMesh(id));
}

/// Writes a line into the document's log.
inline void log(MeshDocument& document, GLLogStream::Levels level, const std::string& text) {
    document.Log.Log(level, text);
}

/// Names of textures: this version reads the pictures by them.
inline void copyTextures(const MeshModel& from, MeshModel& to) {
    to.cm.textures = from.cm.textures;
}

/// Null where the mesh has no such attribute of this type.
template <class Value>
[[nodiscard]] const Value* perMeshAttribute(const CMeshO& mesh, const std::string& name) {
    using Allocator = vcg::tri::Allocator<CMeshO>;
    // This vcglib looks attributes up in meshes that are not const only; it does not change them.
    auto& looked = const_cast<CMeshO&>(mesh);
    auto handle = Allocator::FindPerMeshAttribute<Value>(looked, name);
    return Allocator::IsValidHandle(looked, handle) ? &handle() : nullptr;
}

}  // namespace bspline_curve::host

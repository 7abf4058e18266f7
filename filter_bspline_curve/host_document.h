// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <common/ml_document/mesh_document.h>

#include <string>
#include <vector>

// What MeshLab's versions spell differently about documents: here, 2022.02 and later.
namespace bspline_curve::host {

/// As hosts hand it to what describes a dialog.
using DialogDocument = const MeshDocument;

[[nodiscard]] inline bool hasQuality(const MeshModel& layer) {
    return layer.hasPerVertexQuality();
}

[[nodiscard]] inline std::vector<const MeshModel*> layersOf(const MeshDocument& document) {
    std::vector<const MeshModel*> layers;
    for (const MeshModel& layer : document.meshIterator()) {
        layers.push_back(&layer);
    }
    return layers;
}

/// Null where the document has no such layer.
[[nodiscard]] inline const MeshModel* layerWithId(const MeshDocument& document, int id) {
    return id < 0 ? nullptr : document.getMesh(static_cast<unsigned int>(id));
}

inline void removeLayer(MeshDocument& document, int id) {
    document.delMesh(static_cast<unsigned int>(id));
}

/// Writes a line into the document's log.
inline void log(MeshDocument& document, GLLogStream::Levels level, const std::string& text) {
    document.Log.log(level, text);
}

/// Names and pictures of textures.
inline void copyTextures(const MeshModel& from, MeshModel& to) {
    to.cm.textures = from.cm.textures;
    for (const auto& [name, picture] : from.getTextures()) {
        to.addTexture(name, picture);
    }
}

/// Null where the mesh has no such attribute of this type.
template <class Value>
[[nodiscard]] const Value* perMeshAttribute(const CMeshO& mesh, const std::string& name) {
    using Allocator = vcg::tri::Allocator<CMeshO>;
    auto handle = Allocator::FindPerMeshAttribute<Value>(mesh, name);
    return Allocator::IsValidHandle(mesh, handle) ? &handle() : nullptr;
}

}  // namespace bspline_curve::host

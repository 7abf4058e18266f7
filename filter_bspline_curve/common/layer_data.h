// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filter_bspline_curve/common/layer_arrays.h"
#include "host_document.h"

#include <array>
#include <map>
#include <string>
#include <vector>

namespace bspline_curve {

/// Custom attributes of numbers and points, by name: a value per vertex or per face.
struct Attributes {
    std::map<std::string, std::vector<Scalarm>> numbers;
    std::map<std::string, std::vector<Point3m>> points;
};

/// What a layer has beside its mesh, per vertex and per face of its arrays, and what layers that
/// are made of it take from it. Vectors are empty where the layer has no such data.
struct LayerData {
    int mask = MeshModel::MM_NONE;  ///< of all below
    Matrix44m toWorld = Matrix44m::Identity();
    std::vector<Point3m> positions;  ///< in the layer's coordinates
    std::vector<CVertexO::QualityType> vertexQuality;
    std::vector<vcg::Color4b> vertexColours;
    std::vector<CVertexO::TexCoordType> vertexTextures;
    Attributes vertexAttributes;
    std::vector<CFaceO::QualityType> faceQuality;
    std::vector<vcg::Color4b> faceColours;
    std::vector<std::array<CFaceO::TexCoordType, 3>> wedgeTextures;
    Attributes faceAttributes;

    [[nodiscard]] bool has(int data) const { return (mask & data) != 0; }
};

/// `arrays`: of the layer.
[[nodiscard]] LayerData dataOf(const MeshModel& layer, const LayerArrays& arrays);

}  // namespace bspline_curve

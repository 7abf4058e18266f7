// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_bspline_curve/common/host_meshes.h"

#include "bspline_curve/progress.h"
#include "filter_bspline_curve/common/layer_making.h"
#include "filters/part_colours.h"

#include <vcg/complex/algorithms/update/normal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace bspline_curve {

namespace {

using Allocator = vcg::tri::Allocator<CMeshO>;

const std::string kOnCurve = "on_curve";
const std::string kParent = "parent";
constexpr const char* kStage = "layers";
constexpr int kColourChannels = 4;
constexpr double kMostColour = 255.0;
/// A vertex with so much of selected ones is selected.
constexpr double kWhole = 1.0 - 1e-6;

unsigned char colourOf(double value) {
    return static_cast<unsigned char>(std::lround(std::clamp(value, 0.0, kMostColour)));
}

/// Fills a mesh of the host from a mesh and the layer that it was made from.
class MeshFiller {
public:
    MeshFiller(
        HostMesh& filled,
        const MeshLayer& layer,
        const LayerInput& input,
        const LayerArrays& ids,
        const LayerData& data
    )
        : filled_(filled),
          mesh_(*filled.mesh),
          made_(layer.made),
          input_(input),
          ids_(ids),
          data_(data),
          showsParts_(layer.showsParts) {}

    /// `coloursParts`: colours faces by their part, without a word of it in their quality.
    void fill(bool coloursParts, const Progress& progress) {
        coloursParts = coloursParts || showsParts_;
        enableData(coloursParts);
        addVertices();
        addFaces();
        report(progress, 0.3, kStage);
        carryVertexData();
        carryVertexAttributes();
        report(progress, 0.6, kStage);
        carryFaceData();
        carryFaceAttributes();
        if (showsParts_) {
            labelParts();
        }
        if (coloursParts) {
            colourParts();
        }
        report(progress, 0.8, kStage);
        vcg::tri::UpdateNormal<CMeshO>::PerVertexNormalizedPerFaceNormalized(mesh_);
    }

private:
    [[nodiscard]] bool has(int data) const { return data_.has(data); }

    void enableData(bool coloursParts) {
        filled_.mask = data_.mask;
        if (showsParts_) {
            filled_.mask |= MeshModel::MM_FACEQUALITY;
        }
        if (coloursParts) {
            filled_.mask |= MeshModel::MM_FACECOLOR;
        }
        if (has(MeshModel::MM_VERTTEXCOORD)) {
            mesh_.vert.EnableTexCoord();
        }
        if ((filled_.mask & MeshModel::MM_FACEQUALITY) != 0) {
            mesh_.face.EnableQuality();
        }
        if ((filled_.mask & MeshModel::MM_FACECOLOR) != 0) {
            mesh_.face.EnableColor();
        }
        if (has(MeshModel::MM_WEDGTEXCOORD)) {
            mesh_.face.EnableWedgeTexCoord();
        }
    }

    void addVertices() {
        const std::vector<Vec3>& vertices = made_.mesh().vertices;
        const FromWorld fromWorld(data_.toWorld);
        Allocator::AddVertices(mesh_, vertices.size());
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            const int id = made_.vertexOf(static_cast<int>(i));
            mesh_.vert[i].P() = id < 0 ? fromWorld(vertices[i]) : data_.positions[id];
        }
    }

    void addFaces() {
        const std::vector<Triangle>& faces = made_.mesh().faces;
        Allocator::AddFaces(mesh_, faces.size());
        for (std::size_t f = 0; f < faces.size(); ++f) {
            for (int k = 0; k < 3; ++k) {
                mesh_.face[f].V(k) = &mesh_.vert[faces[f][k]];
            }
        }
    }

    // ---- vertices ----

    /// Of each vertex of the layer get(its values), a number, carried over, to set(i, number).
    template <class Values, class Get, class Set>
    void carry(const Values& layerValues, const Get& get, const Set& set) {
        std::vector<double> numbers;
        numbers.reserve(layerValues.size());
        for (const auto& value : layerValues) {
            numbers.push_back(double(get(value)));
        }
        const std::vector<double> carried = made_.carried(numbers);
        for (std::size_t i = 0; i < carried.size(); ++i) {
            set(i, carried[i]);
        }
    }

    void carryVertexData() {
        auto& to = mesh_.vert;
        if (has(MeshModel::MM_VERTQUALITY)) {
            carry(
                data_.vertexQuality,
                [](auto quality) { return quality; },
                [&](std::size_t i, double q) { to[i].Q() = static_cast<CVertexO::QualityType>(q); }
            );
        }
        if (has(MeshModel::MM_VERTCOLOR)) {
            for (int channel = 0; channel < kColourChannels; ++channel) {
                carry(
                    data_.vertexColours,
                    [&](const vcg::Color4b& colour) { return colour[channel]; },
                    [&](std::size_t i, double c) { to[i].C()[channel] = colourOf(c); }
                );
            }
        }
        if (has(MeshModel::MM_VERTTEXCOORD)) {
            for (int axis = 0; axis < 2; ++axis) {
                carry(
                    data_.vertexTextures,
                    [&](const auto& place) { return place.P()[axis]; },
                    [&](std::size_t i, double u) { to[i].T().P()[axis] = static_cast<float>(u); }
                );
            }
            carry(
                data_.vertexTextures,
                [](const auto& place) { return place.N(); },
                [&](std::size_t i, double n) { to[i].T().N() = static_cast<short>(std::lround(n)); }
            );
        }
        if (std::ranges::count(input_.selectedVertices, 1) > 0) {
            carry(
                input_.selectedVertices,
                [](char isSelected) { return isSelected; },
                [&](std::size_t i, double share) {
                    if (share >= kWhole) {
                        to[i].SetS();
                    }
                }
            );
        }
    }

    void carryVertexAttributes() {
        auto& [numbers, points] = filled_.vertexAttributes;
        for (const auto& [name, values] : data_.vertexAttributes.numbers) {
            std::vector<Scalarm>& to = numbers[name];
            to.resize(mesh_.vert.size());
            carry(
                values,
                [](Scalarm value) { return value; },
                [&](std::size_t i, double value) { to[i] = static_cast<Scalarm>(value); }
            );
        }
        for (const auto& [name, values] : data_.vertexAttributes.points) {
            std::vector<Point3m>& to = points[name];
            to.resize(mesh_.vert.size());
            for (int axis = 0; axis < 3; ++axis) {
                carry(
                    values,
                    [&](const Point3m& value) { return value[axis]; },
                    [&](std::size_t i, double value) { to[i][axis] = static_cast<Scalarm>(value); }
                );
            }
        }
        // An imprinted mesh that is imprinted again keeps what it had.
        std::vector<Scalarm>& onCurve = numbers[kOnCurve];
        onCurve.resize(mesh_.vert.size(), Scalarm(0));
        const std::vector<double> flags = made_.curveFlags();
        for (std::size_t i = 0; i < flags.size(); ++i) {
            const bool was = double(onCurve[i]) >= kWhole;
            onCurve[i] = static_cast<Scalarm>(was ? 1.0 : flags[i]);
        }
    }

    // ---- faces ----

    /// Calls copy(face of the mesh, the layer's face) for each face that is part of one.
    template <class Copy>
    void copyFaces(const Copy& copy) {
        for (std::size_t f = 0; f < mesh_.face.size(); ++f) {
            const int parent = made_.faceOf(static_cast<int>(f));
            if (parent >= 0) {
                copy(f, parent);
            }
        }
    }

    void carryFaceData() {
        auto& to = mesh_.face;
        copyFaces([&](std::size_t f, int parent) {
            if (!input_.selectedFaces.empty() && input_.selectedFaces[parent] != 0) {
                to[f].SetS();
            }
            if (has(MeshModel::MM_FACEQUALITY)) {
                to[f].Q() = data_.faceQuality[parent];
            }
            if (has(MeshModel::MM_FACECOLOR)) {
                to[f].C() = data_.faceColours[parent];
            }
            if (has(MeshModel::MM_WEDGTEXCOORD)) {
                carryWedges(static_cast<int>(f), data_.wedgeTextures[parent]);
            }
        });
    }

    void carryWedges(int f, const std::array<CFaceO::TexCoordType, 3>& parent) {
        for (int corner = 0; corner < 3; ++corner) {
            const Vec3 place = made_.placeOf(f, corner);
            auto& wedge = mesh_.face[f].WT(corner);
            for (int axis = 0; axis < 2; ++axis) {
                double value = 0.0;
                for (int k = 0; k < 3; ++k) {
                    value += place[k] * double(parent[k].P()[axis]);
                }
                wedge.P()[axis] = static_cast<float>(value);
            }
            wedge.N() = parent[0].N();
        }
    }

    template <class Value>
    void copyFaceValues(const std::vector<Value>& from, std::vector<Value>& to) {
        to.resize(mesh_.face.size());
        copyFaces([&](std::size_t f, int parent) { to[f] = from[parent]; });
    }

    void carryFaceAttributes() {
        auto& [numbers, points] = filled_.faceAttributes;
        for (const auto& [name, values] : data_.faceAttributes.numbers) {
            copyFaceValues(values, numbers[name]);
        }
        for (const auto& [name, values] : data_.faceAttributes.points) {
            copyFaceValues(values, points[name]);
        }
        std::vector<Scalarm>& parents = numbers[kParent];
        parents.assign(mesh_.face.size(), Scalarm(-1));
        copyFaces([&](std::size_t f, int parent) {
            parents[f] = static_cast<Scalarm>(ids_.faceIds[parent]);
        });
    }

    void labelParts() {
        for (std::size_t f = 0; f < mesh_.face.size(); ++f) {
            mesh_.face[f].Q() = static_cast<CFaceO::QualityType>(made_.labels()[f]);
        }
    }

    void colourParts() {
        for (std::size_t f = 0; f < mesh_.face.size(); ++f) {
            const auto [red, green, blue] = partColour(made_.labels()[f]);
            constexpr unsigned char kOpaque = 255;
            mesh_.face[f].C() = vcg::Color4b(red, green, blue, kOpaque);
        }
    }

    HostMesh& filled_;
    CMeshO& mesh_;
    const MadeMesh& made_;
    const LayerInput& input_;
    const LayerArrays& ids_;
    const LayerData& data_;
    bool showsParts_;
};

/// Whether a layer shows colours or pictures, so that its parts are told apart without further
/// ones.
bool isColoured(const LayerData& data) {
    return data.has(
        MeshModel::MM_VERTCOLOR | MeshModel::MM_FACECOLOR | MeshModel::MM_VERTTEXCOORD |
        MeshModel::MM_WEDGTEXCOORD
    );
}

}  // namespace

std::vector<HostMesh> hostMeshes(
    const std::vector<MeshLayer>& made,
    const LayerInput& input,
    const LayerArrays& ids,
    const LayerData& data,
    bool coloursParts,
    const Progress& progress
) {
    std::vector<HostMesh> filled;
    for (const MeshLayer& layer : made) {
        const Progress step = stepOf(progress, filled.size(), made.size());
        filled.emplace_back().suffix = layer.suffix;
        MeshFiller(filled.back(), layer, input, ids, data)
            .fill(coloursParts && made.size() > 1 && !isColoured(data), step);
    }
    return filled;
}

}  // namespace bspline_curve

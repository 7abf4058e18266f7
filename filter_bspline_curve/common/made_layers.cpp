// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_bspline_curve/common/made_layers.h"

#include "filter_bspline_curve/common/curve_source.h"
#include "filter_bspline_curve/common/layer_making.h"
#include "filter_bspline_curve/common/polyline_attributes.h"
#include "filter_bspline_curve/common/window.h"
#include "imprint/part_colours.h"

#include <vcg/complex/algorithms/update/normal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace bspline_curve {

namespace {

using Allocator = vcg::tri::Allocator<CMeshO>;

const std::string kOnCurve = "on_curve";
const std::string kParent = "parent";
constexpr int kColourChannels = 4;
constexpr double kMostColour = 255.0;
/// A vertex with so much of selected ones is selected.
constexpr double kWhole = 1.0 - 1e-6;

unsigned char colourOf(double value) {
    return static_cast<unsigned char>(std::lround(std::clamp(value, 0.0, kMostColour)));
}

/// Fills a new layer from a mesh and the surface that it was made from.
class LayerFiller {
public:
    LayerFiller(MeshModel& layer, const SurfaceLayer& surface, const MadeMesh& made)
        : layer_(layer), from_(surface.layer), arrays_(surface.arrays), made_(made) {}

    /// `coloursParts`: colours faces by their part, without a word of it in their quality.
    void fill(bool showsParts, bool coloursParts) {
        enableData(showsParts, coloursParts);
        addVertices();
        addFaces();
        carryVertexData();
        carryVertexAttributes();
        carryFaceData();
        carryFaceAttributes();
        addOwnAttributes();
        if (showsParts) {
            labelParts();
        }
        if (showsParts || coloursParts) {
            colourParts();
        }
        vcg::tri::UpdateNormal<CMeshO>::PerVertexNormalizedPerFaceNormalized(layer_.cm);
        attachTo(from_, layer_);
    }

private:
    [[nodiscard]] bool has(int data) const { return from_.hasDataMask(data); }

    void enableData(bool showsParts, bool coloursParts) {
        int mask = MeshModel::MM_NONE;
        for (const int data :
             {MeshModel::MM_VERTQUALITY,
              MeshModel::MM_VERTCOLOR,
              MeshModel::MM_VERTTEXCOORD,
              MeshModel::MM_FACEQUALITY,
              MeshModel::MM_FACECOLOR,
              MeshModel::MM_WEDGTEXCOORD}) {
            if (has(data)) {
                mask |= data;
            }
        }
        if (showsParts) {
            mask |= MeshModel::MM_FACEQUALITY;
        }
        if (showsParts || coloursParts) {
            mask |= MeshModel::MM_FACECOLOR;
        }
        layer_.updateDataMask(mask);
        host::copyTextures(from_, layer_);
    }

    void addVertices() {
        const std::vector<Vec3>& vertices = made_.mesh().vertices;
        const FromWorld fromWorld(from_.cm.Tr);
        Allocator::AddVertices(layer_.cm, vertices.size());
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            const int id = made_.vertexOf(static_cast<int>(i));
            layer_.cm.vert[i].P() =
                id < 0 ? fromWorld(vertices[i]) : from_.cm.vert[arrays_.vertexIds[id]].cP();
        }
    }

    void addFaces() {
        const std::vector<Triangle>& faces = made_.mesh().faces;
        Allocator::AddFaces(layer_.cm, faces.size());
        for (std::size_t f = 0; f < faces.size(); ++f) {
            for (int k = 0; k < 3; ++k) {
                layer_.cm.face[f].V(k) = &layer_.cm.vert[faces[f][k]];
            }
        }
    }

    // ---- vertices ----

    /// Of each of the surface's vertices get(id in the layer), carried over, to set(i, value).
    template <class Get, class Set>
    void carry(const Get& get, const Set& set) {
        std::vector<double> values;
        values.reserve(arrays_.vertexIds.size());
        for (const int id : arrays_.vertexIds) {
            values.push_back(double(get(id)));
        }
        const std::vector<double> carried = made_.carried(values);
        for (std::size_t i = 0; i < carried.size(); ++i) {
            set(i, carried[i]);
        }
    }

    void carryVertexData() {
        const auto& from = from_.cm.vert;
        auto& to = layer_.cm.vert;
        if (has(MeshModel::MM_VERTQUALITY)) {
            carry(
                [&](int id) { return from[id].cQ(); },
                [&](std::size_t i, double q) { to[i].Q() = static_cast<CVertexO::QualityType>(q); }
            );
        }
        if (has(MeshModel::MM_VERTCOLOR)) {
            for (int channel = 0; channel < kColourChannels; ++channel) {
                carry(
                    [&](int id) { return from[id].cC()[channel]; },
                    [&](std::size_t i, double c) { to[i].C()[channel] = colourOf(c); }
                );
            }
        }
        if (has(MeshModel::MM_VERTTEXCOORD)) {
            for (int axis = 0; axis < 2; ++axis) {
                carry(
                    [&](int id) { return from[id].cT().P()[axis]; },
                    [&](std::size_t i, double u) { to[i].T().P()[axis] = static_cast<float>(u); }
                );
            }
            carry(
                [&](int id) { return from[id].cT().N(); },
                [&](std::size_t i, double n) { to[i].T().N() = static_cast<short>(std::lround(n)); }
            );
        }
        carry(
            [&](int id) { return from[id].IsS() ? 1.0 : 0.0; },
            [&](std::size_t i, double share) {
                if (share >= kWhole) {
                    to[i].SetS();
                }
            }
        );
    }

    void carryVertexAttributes() {
        std::vector<std::string> names;
        Allocator::GetAllPerVertexAttribute<Scalarm>(forLookup(from_.cm), names);
        for (const std::string& name : names) {
            auto from = Allocator::FindPerVertexAttribute<Scalarm>(forLookup(from_.cm), name);
            auto to = Allocator::AddPerVertexAttribute<Scalarm>(layer_.cm, name);
            carry(
                [&](int id) { return from[id]; },
                [&](std::size_t i, double value) { to[i] = static_cast<Scalarm>(value); }
            );
        }
        Allocator::GetAllPerVertexAttribute<Point3m>(forLookup(from_.cm), names);
        for (const std::string& name : names) {
            auto from = Allocator::FindPerVertexAttribute<Point3m>(forLookup(from_.cm), name);
            auto to = Allocator::AddPerVertexAttribute<Point3m>(layer_.cm, name);
            for (int axis = 0; axis < 3; ++axis) {
                carry(
                    [&](int id) { return from[id][axis]; },
                    [&](std::size_t i, double value) { to[i][axis] = static_cast<Scalarm>(value); }
                );
            }
        }
    }

    // ---- faces ----

    /// Calls copy(face of the layer, id of the surface's face) for each face that is part of one.
    template <class Copy>
    void copyFaces(const Copy& copy) {
        for (std::size_t f = 0; f < layer_.cm.face.size(); ++f) {
            const int parent = made_.faceOf(static_cast<int>(f));
            if (parent >= 0) {
                copy(f, arrays_.faceIds[parent]);
            }
        }
    }

    void carryFaceData() {
        const auto& from = from_.cm.face;
        auto& to = layer_.cm.face;
        copyFaces([&](std::size_t f, int id) {
            if (from[id].IsS()) {
                to[f].SetS();
            }
            if (has(MeshModel::MM_FACEQUALITY)) {
                to[f].Q() = from[id].cQ();
            }
            if (has(MeshModel::MM_FACECOLOR)) {
                to[f].C() = from[id].cC();
            }
            if (has(MeshModel::MM_WEDGTEXCOORD)) {
                carryWedges(static_cast<int>(f), from[id]);
            }
        });
    }

    void carryWedges(int f, const CFaceO& parent) {
        for (int corner = 0; corner < 3; ++corner) {
            const Vec3 place = made_.placeOf(f, corner);
            auto& wedge = layer_.cm.face[f].WT(corner);
            for (int axis = 0; axis < 2; ++axis) {
                double value = 0.0;
                for (int k = 0; k < 3; ++k) {
                    value += place[k] * double(parent.cWT(k).P()[axis]);
                }
                wedge.P()[axis] = static_cast<float>(value);
            }
            wedge.N() = parent.cWT(0).N();
        }
    }

    void carryFaceAttributes() {
        std::vector<std::string> names;
        Allocator::GetAllPerFaceAttribute<Scalarm>(forLookup(from_.cm), names);
        for (const std::string& name : names) {
            copyFaceAttribute<Scalarm>(name);
        }
        Allocator::GetAllPerFaceAttribute<Point3m>(forLookup(from_.cm), names);
        for (const std::string& name : names) {
            copyFaceAttribute<Point3m>(name);
        }
    }

    template <class Value>
    void copyFaceAttribute(const std::string& name) {
        auto from = Allocator::FindPerFaceAttribute<Value>(forLookup(from_.cm), name);
        auto to = Allocator::AddPerFaceAttribute<Value>(layer_.cm, name);
        copyFaces([&](std::size_t f, int id) { to[f] = from[id]; });
    }

    // ---- what is new ----

    void addOwnAttributes() {
        // An imprinted mesh that is imprinted again keeps what it had.
        auto onCurve = Allocator::GetPerVertexAttribute<Scalarm>(layer_.cm, kOnCurve);
        const std::vector<double> flags = made_.curveFlags();
        for (std::size_t i = 0; i < flags.size(); ++i) {
            const bool was = double(onCurve[i]) >= kWhole;
            onCurve[i] = static_cast<Scalarm>(was ? 1.0 : flags[i]);
        }
        auto parent = Allocator::GetPerFaceAttribute<Scalarm>(layer_.cm, kParent);
        for (std::size_t f = 0; f < layer_.cm.face.size(); ++f) {
            parent[f] = Scalarm(-1);
        }
        copyFaces([&](std::size_t f, int id) { parent[f] = static_cast<Scalarm>(id); });
    }

    void labelParts() {
        for (std::size_t f = 0; f < layer_.cm.face.size(); ++f) {
            layer_.cm.face[f].Q() = static_cast<CFaceO::QualityType>(made_.labels()[f]);
        }
    }

    void colourParts() {
        for (std::size_t f = 0; f < layer_.cm.face.size(); ++f) {
            const auto [red, green, blue] = partColour(made_.labels()[f]);
            constexpr unsigned char kOpaque = 255;
            layer_.cm.face[f].C() = vcg::Color4b(red, green, blue, kOpaque);
        }
    }

    MeshModel& layer_;
    const MeshModel& from_;
    const LayerArrays& arrays_;
    const MadeMesh& made_;
};

/// Whether a layer shows colours or pictures, so that its parts are told apart without further
/// ones.
bool isColoured(const MeshModel& layer) {
    return std::ranges::any_of(
        std::array{
            MeshModel::MM_VERTCOLOR,
            MeshModel::MM_FACECOLOR,
            MeshModel::MM_VERTTEXCOORD,
            MeshModel::MM_WEDGTEXCOORD
        },
        [&](int data) { return layer.hasDataMask(data); }
    );
}

void selectBand(MeshModel& surface, const LayerArrays& arrays, const std::vector<char>& band) {
    for (CFaceO& face : surface.cm.face) {
        if (!face.IsD()) {
            face.ClearS();
        }
    }
    for (std::size_t f = 0; f < band.size(); ++f) {
        if (band[f] != 0) {
            surface.cm.face[arrays.faceIds[f]].SetS();
        }
    }
}

}  // namespace

std::vector<std::string> addMadeLayers(
    MeshDocument& document, const SurfaceLayer& surface, const MeshesResult& result
) {
    std::vector<const MeshModel*> layers;
    const bool coloursParts = hasWindow() && result.layers.size() > 1 && !isColoured(surface.layer);
    for (std::size_t i = 0; i < result.layers.size(); ++i) {
        const MeshLayer& mesh = result.layers[i];
        const QString name = nameOf(surface.layer) + QString::fromStdString(mesh.suffix);
        MeshModel& layer = *document.addNewMesh("", name, i == 0);
        LayerFiller(layer, surface, mesh.made).fill(mesh.showsParts, coloursParts);
        layers.push_back(&layer);
    }
    if (hasWindow()) {
        document.setVisible(surface.layer.id(), false);
    }
    std::vector<std::string> labels;  // MeshLab changes names that are taken
    for (const MeshModel* const layer : layers) {
        labels.push_back(layer->label().toStdString());
    }
    return labels;
}

void addOffsetLayers(
    MeshDocument& document,
    MeshModel& surface,
    const LayerArrays& arrays,
    const OffsetResult& result
) {
    std::map<std::string, int> pieces;  // of each curve so far
    for (std::size_t i = 0; i < result.pieces.size(); ++i) {
        const auto& [line, curve] = result.pieces[i];
        const int piece = ++pieces[curve];
        QString name = QString::fromStdString(curve) + " offset";
        name += piece > 1 ? QString(" %1").arg(piece) : QString();
        markAsResult(addPolylineLayer(
            document,
            {surface, arrays},
            line,
            {.name = name, .quality = line.parameters, .isCurrent = i == 0}
        ));
    }
    if (!result.band.empty()) {
        selectBand(surface, arrays, result.band);
    }
}

}  // namespace bspline_curve

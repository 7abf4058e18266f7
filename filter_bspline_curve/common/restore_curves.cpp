// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_bspline_curve/common/restore_curves.h"

#include "bspline_curve/error.h"
#include "bspline_curve/mesh.h"
#include "filter_bspline_curve/common/curve_side_file.h"
#include "filter_bspline_curve/common/curve_source.h"
#include "filter_bspline_curve/common/layer_arrays.h"
#include "filter_bspline_curve/common/layer_making.h"
#include "filter_bspline_curve/common/polyline_layer.h"
#include "filter_bspline_curve/common/save_watcher.h"
#include "filter_bspline_curve/common/window.h"
#include "filters/curve_records.h"
#include "filters/drawn_curve_file.h"
#include "filters/utf8_path.h"
#include "text/text_parsing.h"

#include <algorithm>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

namespace bspline_curve {

namespace {

using Allocator = vcg::tri::Allocator<CMeshO>;

/// With how many surfaces a layer was tried, so that a note is not told again.
const std::string kTried = "bspline_curve_restoring_tried";

std::vector<const MeshModel*> surfacesOf(const MeshDocument& document) {
    std::vector<const MeshModel*> surfaces;
    for (const MeshModel* const layer : host::layersOf(document)) {
        if (layer->cm.FN() > 0) {
            surfaces.push_back(layer);
        }
    }
    return surfaces;
}

/// Restores one layer.
class CurveRestorer {
public:
    CurveRestorer(MeshModel& layer, const std::vector<const MeshModel*>& surfaces)
        : layer_(layer),
          surfaces_(surfaces),
          file_(utf8Path(sideFileOf(layer.fullName()).toStdString())) {}

    /// What to tell of it. Throws where it cannot be restored.
    std::vector<std::string> restore(const std::string& bytes) {
        records_ = recordsOf(file_, bytes);
        if (records_.curves.size() != 1) {
            refuseFile(file_, "has several curves; open it with the drawing tool");
        }
        const CurveRecord& record = records_.curves.front();
        if (record.curve && !isLine(layer_, record.curve->polyline)) {
            refuseFile(file_, "is of another curve");
        }
        if (const MeshModel* const same = sameSurface(); same != nullptr && record.curve) {
            restoreExactly(*same);
        } else {
            restoreProjected();
        }
        if (layer_.cm.EN() == 0) {
            addEdges(layer_.cm, record.closed);
        }
        if (!record.name.empty() && layer_.label() == layer_.shortName()) {
            layer_.setLabel(QString::fromStdString(record.name));
        }
        return std::move(notes_);
    }

private:
    [[nodiscard]] const CurveRecord& record() const { return records_.curves.front(); }

    /// The layer with the mesh that the curve was drawn on; of several rather one that has moved
    /// with it.
    [[nodiscard]] const MeshModel* sameSurface() const {
        const MeshModel* found = nullptr;
        for (const MeshModel* const surface : surfaces_) {
            if (!records_.mesh || surface->cm.FN() != records_.mesh->faces ||
                checksumOf(*surface) != *records_.mesh) {
                continue;
            }
            if (found == nullptr || surface->cm.Tr == layer_.cm.Tr) {
                found = surface;
            }
        }
        return found;
    }

    void restoreExactly(const MeshModel& surface) {
        const LayerArrays arrays = arraysOf(surface);
        Curve curve = *record().curve;
        SurfacePolyline& line = curve.polyline;
        for (std::size_t i = 0; i < line.points.size(); ++i) {
            line.points[i] = worldPosition(arrays, line.surfacePoints[i]);
        }
        const ToWorld toWorld(surface);
        for (Vec3& point : curve.spline.controlPoints) {
            point = toWorld(point);
        }
        CurveSource source = sourceOn(surface);
        for (const SketchPick& pick : record().picks) {
            source.positions.push_back(worldPosition(arrays, pick.point));
            addDemands(pick, inWorld(toWorld, pick), source);
            source.picks.push_back(
                {.face = arrays.faceIds[pick.point.face], .barycentric = pick.point.barycentric}
            );
        }
        layer_.updateDataMask(MeshModel::MM_VERTCOLOR);
        putOnSurface(layer_, {surface, arrays}, line);
        showColour();
        source.curve = std::make_shared<const Curve>(std::move(curve));
        keepSource(layer_, std::move(source));
    }

    /// `pick`: the last of the source's. `tangent`: its own, in world coordinates.
    static void addDemands(
        const SketchPick& pick, const PickTangent& tangent, CurveSource& source
    ) {
        const int index = static_cast<int>(source.positions.size()) - 1;
        if (pick.isCorner) {
            source.corners.push_back(index);
        }
        if (!tangent.isAny()) {
            source.tangents.emplace_back(index, tangent);
        }
    }

    /// The directions of a pick that is still in the layer's coordinates.
    static PickTangent inWorld(const ToWorld& toWorld, const SketchPick& pick) {
        const auto moved = [&](const Vec3& direction) {
            return Vec3(toWorld(pick.position + direction) - toWorld(pick.position));
        };
        return {moved(pick.tangent.before), moved(pick.tangent.after)};
    }

    [[nodiscard]] Vec3 worldPosition(const LayerArrays& arrays, const SurfacePoint& point) const {
        const TriangleMesh& mesh = arrays.input.mesh;
        if (point.face >= static_cast<int>(mesh.faces.size())) {
            refuseFile(
                file_, "names face " + std::to_string(point.face) + ", which the mesh has not"
            );
        }
        return positionOf(mesh, point);
    }

    void showColour() {
        if (const std::optional<CurveColour>& colour = record().colour) {
            for (CVertexO& vertex : layer_.cm.vert) {
                vertex.C() = {(*colour)[0], (*colour)[1], (*colour)[2], (*colour)[3]};
            }
        }
    }

    void restoreProjected() {
        const ToWorld toWorld(layer_);
        CurveRecords moved = records_;
        for (SketchPick& pick : moved.curves.front().picks) {
            pick.tangent = inWorld(toWorld, pick);
            pick.position = toWorld(pick.position);
        }
        for (const MeshModel* const surface : surfaces_) {
            if (restoreProjected(*surface, moved)) {
                return;
            }
        }
        throw InputError(
            InputErrorCode::PickTooFar,
            "they are on no layer of this document; open the mesh that the curve was drawn on"
        );
    }

    /// Whether all picks are near the surface.
    bool restoreProjected(const MeshModel& surface, const CurveRecords& records) {
        const LayerArrays arrays = arraysOf(surface);
        OpenedCurves opened;
        try {
            opened = placedRecords(
                file_.filename(),
                records,
                {.mesh = arrays.input.mesh, .checksum = checksumOf(surface)}
            );
        } catch (const InputError&) {
            return false;
        }
        CurveSource source = sourceOn(surface);
        for (const SketchPick& pick : opened.curves.front().picks) {
            source.positions.push_back(pick.position);
            addDemands(pick, pick.tangent, source);
            source.picks.push_back(
                {.face = arrays.faceIds[pick.point.face], .barycentric = pick.point.barycentric}
            );
        }
        rememberSurface(layer_, surface);
        keepSource(layer_, std::move(source));
        notes_ = std::move(opened.notes);
        return true;
    }

    [[nodiscard]] CurveSource sourceOn(const MeshModel& surface) const {
        CurveSource source;
        source.surface = surface.id();
        source.closed = record().closed;
        source.options = record().options;
        source.toWorld = surface.cm.Tr;
        source.file = layer_.fullName().toStdString();
        return source;
    }

    MeshModel& layer_;
    const std::vector<const MeshModel*>& surfaces_;
    std::filesystem::path file_;
    CurveRecords records_;
    std::vector<std::string> notes_;
};

/// Whether a layer may be a curve that was read from a file.
bool isCandidate(const MeshModel& layer, int surfaces) {
    const int* const tried = host::perMeshAttribute<int>(layer.cm, kTried);
    return layer.cm.FN() == 0 && layer.cm.VN() > 0 && !layer.fullName().isEmpty() &&
           sourceOf(layer) == nullptr && (tried == nullptr || *tried != surfaces);
}

void restoreLayer(
    MeshModel& layer, const std::vector<const MeshModel*>& surfaces, RestoredCurves& restored
) {
    const std::string name = layer.shortName().toStdString();
    try {
        const std::optional<std::string> bytes =
            readWholeFileIfThere(utf8Path(sideFileOf(layer.fullName()).toStdString()));
        if (!bytes) {
            return;
        }
        const std::vector<std::string> notes = CurveRestorer(layer, surfaces).restore(*bytes);
        restored.layers.push_back(layer.id());
        restored.notes.insert(restored.notes.end(), notes.begin(), notes.end());
    } catch (const std::exception& error) {
        Allocator::GetPerMeshAttribute<int>(layer.cm, kTried)() = static_cast<int>(surfaces.size());
        restored.notes.push_back(
            "Picks and options of " + name + " were not taken up: " + error.what()
        );
    }
}

}  // namespace

RestoredCurves restoreCurves(MeshDocument& document) {
    RestoredCurves restored;
    const std::vector<const MeshModel*> surfaces = surfacesOf(document);
    if (surfaces.empty()) {
        return restored;
    }
    for (const MeshModel* const layer : host::layersOf(document)) {
        if (isCandidate(*layer, static_cast<int>(surfaces.size()))) {
            restoreLayer(*document.getMesh(layer->id()), surfaces, restored);
        }
    }
    if (!restored.layers.empty() && hasWindow()) {
        watchSaving(document);
    }
    return restored;
}

}  // namespace bspline_curve

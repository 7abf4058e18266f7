// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_bspline_curve/picks_source.h"

#include "filter_bspline_curve/layer_mesh.h"
#include "filter_bspline_curve/picked_points.h"

#include <common/mlexception.h>

#include <QStringList>
#include <filesystem>

namespace bspline_curve {

namespace {

std::vector<Vec3> picksOfLayer(const MeshDocument& document, unsigned int id) {
    const MeshModel* layer = document.getMesh(id);
    if (layer == nullptr) {
        throw MLException(QString("picks_layer: there is no layer %1").arg(id));
    }
    if (layer->cm.FN() > 0) {
        throw MLException(QString(
                              "picks_layer: layer \"%1\" has faces; a layer of picks has points "
                              "only, in the order of the curve"
        )
                              .arg(layer->label()));
    }
    return pointsOf(*layer);
}

std::vector<Vec3> picksOfTool(const MeshModel& surface) {
    std::vector<Vec3> picks;
    for (const Point3m& point : pickedPointsOf(surface.cm)) {
        picks.push_back(toVec3(point));
    }
    if (picks.empty()) {
        throw MLException(
            "no picks: give picks, picks_file or picks_layer, or pick points on the surface with "
            "Edit > PickPoints"
        );
    }
    return picks;
}

/// The names of the parameters that give picks.
QStringList givenSources(const CurveRequest& request) {
    QStringList sources;
    if (!request.picksText.isEmpty()) {
        sources << "picks";
    }
    if (!request.picksFile.isEmpty()) {
        sources << "picks_file";
    }
    if (request.picksLayer != request.surfaceLayer) {
        sources << "picks_layer";
    }
    return sources;
}

}  // namespace

PicksFile picksFor(const CurveRequest& request, const MeshDocument& document) {
    const QStringList sources = givenSources(request);
    if (sources.size() > 1) {
        throw MLException(QString("picks are given more than once, by %1: give one of them")
                              .arg(sources.join(" and ")));
    }
    if (sources.isEmpty()) {
        return {.picks = picksOfTool(*document.getMesh(request.surfaceLayer)), .closed = {}};
    }
    if (sources.front() == "picks") {
        return {.picks = parsePicksText(request.picksText.toStdString()), .closed = {}};
    }
    if (sources.front() == "picks_file") {
        return readPicks(std::filesystem::path(request.picksFile.toStdString()));
    }
    return {.picks = picksOfLayer(document, request.picksLayer), .closed = {}};
}

}  // namespace bspline_curve

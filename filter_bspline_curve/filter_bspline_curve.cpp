// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_bspline_curve/filter_bspline_curve.h"

#include "design/curve_designer.h"
#include "filter_bspline_curve/curve_parameters.h"
#include "filter_bspline_curve/layer_mesh.h"
#include "filter_bspline_curve/picks_source.h"
#include "filter_bspline_curve/result_layer.h"
#include "io/shell_cache.h"
#include "surface/input_error.h"

#include <chrono>
#include <new>
#include <optional>
#include <utility>

namespace {

using namespace bspline_curve;

using Clock = std::chrono::steady_clock;

/// Reports a stage's progress as a part of the host's 0 to 100.
Progress hostProgress(vcg::CallBackPos* callback, double first, double last) {
    if (callback == nullptr) {
        return {};
    }
    return [=](double fraction, const char* stage) {
        return callback(static_cast<int>(first + fraction * (last - first)), stage);
    };
}

const MeshModel& surfaceOf(const MeshDocument& document, unsigned int id) {
    const MeshModel* surface = document.getMesh(id);
    if (surface == nullptr) {
        throw MLException(QString("surface_layer: there is no layer %1").arg(id));
    }
    return *surface;
}

/// The core's ids count elements that are not deleted; where the layer has others, a message with
/// ids has to say so.
CurveDesigner designerFor(
    const LayerMesh& mesh, const ShellOptions& options, const Progress& progress
) {
    const std::optional<ShellCache> cache = ShellCache::ofUser();
    try {
        return CurveDesigner(mesh.world, options, progress, cache ? &*cache : nullptr);
    } catch (const InputError& error) {
        if (mesh.hasLayersIds || error.elements().empty()) {
            throw;
        }
        throw MLException(
            QString("%1 (ids count without the layer's deleted elements)").arg(error.what())
        );
    }
}

struct Drawn {
    std::map<std::string, QVariant> figures;
    ShellSummary shell;
};

/// From the document to the document: reads the layer and the picks, has the curve designed, adds
/// its layer.
Drawn drawCurve(const CurveRequest& request, MeshDocument& document, vcg::CallBackPos* callback) {
    const auto start = Clock::now();
    const MeshModel& surface = surfaceOf(document, request.surfaceLayer);
    const LayerMesh mesh = meshOf(surface);
    const PicksFile picks = picksFor(request, document);
    SolverOptions options = request.solver;
    options.closed = options.closed || picks.closed.value_or(false);
    const std::vector<double> field =
        request.useQualityField ? qualityOf(surface, mesh) : std::vector<double>{};
    // A designer belongs to one state of one surface; none is kept, so none can be stale. Shells
    // that took long are in the cache.
    const CurveDesigner designer =
        designerFor(mesh, request.shell, hostProgress(callback, 0.0, 50.0));
    const Curve curve = designer.design(
        picks.picks, options, request.sampling, {.field = field}, hostProgress(callback, 50.0, 99.0)
    );
    addCurveLayer(document, surface, mesh, curve, field);
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    return {.figures = figuresOf(curve, designer, seconds), .shell = designer.shell()};
}

}  // namespace

FilterBsplineCurvePlugin::FilterBsplineCurvePlugin() {
    typeList = {BsplineCurveOnSurface};
    for (const ActionIDType type : types()) {
        actionList.push_back(new QAction(filterName(type), this));
    }
}

QString FilterBsplineCurvePlugin::pluginName() const {
    return "FilterBsplineCurve";
}

QString FilterBsplineCurvePlugin::vendor() const {
    return "bspline_curve";
}

QString FilterBsplineCurvePlugin::filterName(ActionIDType /*filter*/) const {
    return "B-spline Curve on Surface";
}

QString FilterBsplineCurvePlugin::pythonFilterName(ActionIDType /*filter*/) const {
    return "generate_bspline_curve_on_surface";
}

QString FilterBsplineCurvePlugin::filterInfo(ActionIDType /*filter*/) const {
    return "Draws a smooth curve through picked points on a triangle mesh: a variational "
           "B-spline, found in a thin shell around the surface, and its exact shadow as a "
           "polyline every segment of which lies inside one face. The curve becomes a new layer; "
           "the mesh is not changed. Picks come from Edit &gt; PickPoints, a layer of points, a "
           "file or text; their order is the order of the curve. A scalar per vertex (a field) "
           "may draw the curve to where its cost is low.<br>Each vertex of the curve knows its "
           "face (<i>face_index</i>), its barycentric coordinates there (<i>barycentric</i>) and "
           "its parameter (<i>t</i>).<br>See:<br><b>\"A variational approach for feature-aware "
           "B-spline curve design on surface meshes\"</b><br>The Visual Computer, 2023.";
}

FilterPlugin::FilterClass FilterBsplineCurvePlugin::getClass(const QAction* /*action*/) const {
    return FilterPlugin::MeshCreation;
}

FilterPlugin::FilterArity FilterBsplineCurvePlugin::filterArity(const QAction* /*action*/) const {
    return FilterPlugin::FIXED;
}

int FilterBsplineCurvePlugin::postCondition(const QAction* /*action*/) const {
    return MeshModel::MM_NONE;
}

RichParameterList FilterBsplineCurvePlugin::initParameterList(
    const QAction* /*action*/, const MeshDocument& document
) {
    return curveParameters(document);
}

std::map<std::string, QVariant> FilterBsplineCurvePlugin::applyFilter(
    const QAction* /*action*/,
    const RichParameterList& parameters,
    MeshDocument& document,
    unsigned int& postConditionMask,
    vcg::CallBackPos* callback
) {
    postConditionMask = MeshModel::MM_NONE;
    try {
        Drawn drawn = drawCurve(readRequest(parameters), document, callback);
        log(logLine(drawn.figures, drawn.shell));
        for (const std::string& note : drawn.shell.notes) {
            log(GLLogStream::WARNING, note);
        }
        if (!drawn.figures["usable"].toBool()) {
            log(GLLogStream::WARNING,
                "The curve did not reach the distance tolerance: its layer shows how far it "
                "came. More picks, a thicker shell or more rounds may help.");
        }
        return std::move(drawn.figures);
    } catch (const MLException&) {
        throw;
    } catch (const InputError& error) {
        throw MLException(error.what());
    } catch (const Cancelled&) {
        throw MLException("The curve was cancelled.");
    } catch (const std::bad_alloc&) {
        throw MLException("There is not enough memory for a curve on this mesh.");
    } catch (const std::exception& error) {
        throw MLException(QString("The curve could not be drawn: %1").arg(error.what()));
    }
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_bspline_curve/filter_bspline_curve.h"

#include "design/curve_designer.h"
#include "filter_bspline_curve/curve_parameters.h"
#include "filter_bspline_curve/field_parameters.h"
#include "filter_bspline_curve/layer_field.h"
#include "filter_bspline_curve/layer_mesh.h"
#include "filter_bspline_curve/picks_source.h"
#include "filter_bspline_curve/result_layer.h"
#include "io/shell_cache.h"
#include "surface/input_error.h"
#include "surface/region.h"

#include <chrono>
#include <new>
#include <optional>
#include <utility>
#include <vector>

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

/// Makes something from the arrays of a layer. Ids in errors count elements that are not deleted;
/// where the layer has others, a message with ids has to say so.
template <class Make>
auto madeFrom(const LayerMesh& mesh, const Make& make) {
    try {
        return make();
    } catch (const InputError& error) {
        if (mesh.hasLayersIds || error.elements().empty()) {
            throw;
        }
        throw MLException(
            QString("%1 (ids count without the layer's deleted elements)").arg(error.what())
        );
    }
}

CurveDesigner designerFor(
    const LayerMesh& mesh, const ShellOptions& options, const Progress& progress
) {
    const std::optional<ShellCache> cache = ShellCache::ofUser();
    return madeFrom(mesh, [&] {
        return CurveDesigner(mesh.world, options, progress, cache ? &*cache : nullptr);
    });
}

/// The faces to avoid. `field` is empty where there is none.
Region avoidedRegion(
    const CurveRequest& request,
    const MeshModel& layer,
    const LayerMesh& mesh,
    const Surface& surface,
    const std::vector<double>& field
) {
    const auto values = [&] { return field.empty() ? qualityOf(layer, mesh) : field; };
    switch (request.avoid) {
        case Avoid::SelectedFaces:
            return selectedRegion(layer, mesh, surface, RegionSource::SelectedFaces);
        case Avoid::SelectedVertices:
            return selectedRegion(layer, mesh, surface, RegionSource::SelectedVertices);
        case Avoid::UnderThreshold:
            return facesUnder(surface, values(), request.avoidThreshold);
        case Avoid::OverThreshold:
            return facesOver(surface, values(), request.avoidThreshold);
        default:
            return {};
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
    // A designer belongs to one state of one surface; none is kept, so none can be stale. Shells
    // that took long are in the cache.
    const CurveDesigner designer =
        designerFor(mesh, request.shell, hostProgress(callback, 0.0, 50.0));
    std::vector<double> field;
    if (request.field) {
        field = madeFrom(mesh, [&] {
            return fieldOf(
                surface,
                mesh,
                designer.surface(),
                *request.field,
                hostProgress(callback, 50.0, 60.0)
            );
        });
    }
    const Region avoid = avoidedRegion(request, surface, mesh, designer.surface(), field);
    const Curve curve = designer.design(
        picks.picks,
        options,
        request.sampling,
        {.field = field, .avoid = avoid},
        hostProgress(callback, 60.0, 99.0)
    );
    addCurveLayer(document, surface, mesh, curve, field);
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    return {.figures = figuresOf(curve, designer, seconds), .shell = designer.shell()};
}

/// Makes a field the quality of the current layer.
std::map<std::string, QVariant> computeField(
    const FieldRequest& request, MeshDocument& document, vcg::CallBackPos* callback
) {
    MeshModel* layer = document.mm();
    if (layer == nullptr) {
        throw MLException("there is no layer: load a triangle mesh first");
    }
    const LayerMesh mesh = meshOf(*layer);
    const std::vector<double> field = madeFrom(mesh, [&] {
        const Surface surface(mesh.world);
        return fieldOf(*layer, mesh, surface, request, hostProgress(callback, 0.0, 99.0));
    });
    return setQuality(*layer, mesh, field);
}

/// Runs a filter; whatever it throws becomes an MLException. `what`: "the curve", for messages.
template <class Run>
std::map<std::string, QVariant> asHostExpects(const char* what, const Run& run) {
    const auto failed = [&](const char* message) {
        return MLException(QString(message).arg(what));
    };
    try {
        return run();
    } catch (const MLException&) {
        throw;
    } catch (const InputError& error) {
        throw MLException(error.what());
    } catch (const Cancelled&) {
        throw failed("The %1 was cancelled.");
    } catch (const std::bad_alloc&) {
        throw failed("There is not enough memory for a %1 on this mesh.");
    } catch (const std::exception& error) {
        throw MLException(QString("The %1 could not be made: %2").arg(what, error.what()));
    }
}

}  // namespace

FilterBsplineCurvePlugin::FilterBsplineCurvePlugin() {
    typeList = {BsplineCurveOnSurface, ScalarFieldForCurves};
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

QString FilterBsplineCurvePlugin::filterName(ActionIDType filter) const {
    return filter == ScalarFieldForCurves ? "Scalar Field for Curves" : "B-spline Curve on Surface";
}

QString FilterBsplineCurvePlugin::pythonFilterName(ActionIDType filter) const {
    return filter == ScalarFieldForCurves ? "compute_scalar_field_for_curves_per_vertex"
                                          : "generate_bspline_curve_on_surface";
}

QString FilterBsplineCurvePlugin::filterInfo(ActionIDType filter) const {
    if (filter == ScalarFieldForCurves) {
        return "Computes a scalar per vertex that curves can follow or avoid, and makes it the "
               "quality of the current layer: variation of normals, curvature, ridges and valleys "
               "at a scale, distances to creases and to the boundary, obstacles from a selection. "
               "It is the same in every unit and, but for the variation of normals, hardly depends "
               "on how fine the mesh is. The filter <i>B-spline Curve on Surface</i> takes the "
               "same fields by itself.<br>See:<br><b>\"A variational approach for feature-aware "
               "B-spline curve design on surface meshes\"</b><br>The Visual Computer, 2023, "
               "Sect. 5.2.";
    }
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

FilterPlugin::FilterClass FilterBsplineCurvePlugin::getClass(const QAction* action) const {
    return ID(action) == ScalarFieldForCurves ? FilterPlugin::Quality : FilterPlugin::MeshCreation;
}

FilterPlugin::FilterArity FilterBsplineCurvePlugin::filterArity(const QAction* action) const {
    return ID(action) == ScalarFieldForCurves ? FilterPlugin::SINGLE_MESH : FilterPlugin::FIXED;
}

int FilterBsplineCurvePlugin::postCondition(const QAction* action) const {
    return ID(action) == ScalarFieldForCurves ? MeshModel::MM_VERTQUALITY : MeshModel::MM_NONE;
}

RichParameterList FilterBsplineCurvePlugin::initParameterList(
    const QAction* action, const MeshDocument& document
) {
    return ID(action) == ScalarFieldForCurves ? fieldParameters() : curveParameters(document);
}

std::map<std::string, QVariant> FilterBsplineCurvePlugin::applyFilter(
    const QAction* action,
    const RichParameterList& parameters,
    MeshDocument& document,
    unsigned int& postConditionMask,
    vcg::CallBackPos* callback
) {
    if (ID(action) == ScalarFieldForCurves) {
        postConditionMask = MeshModel::MM_VERTQUALITY;
        return asHostExpects("field", [&] {
            return computeField(readFieldRequest(parameters), document, callback);
        });
    }
    postConditionMask = MeshModel::MM_NONE;
    return asHostExpects("curve", [&] {
        Drawn drawn = drawCurve(readRequest(parameters), document, callback);
        log(logLine(drawn.figures, drawn.shell));
        for (const std::string& note : drawn.shell.notes) {
            log(GLLogStream::WARNING, note);
        }
        if (!drawn.figures["field_at_rest"].toBool()) {
            log(GLLogStream::WARNING,
                "The field could still be lowered where the iterations ended: it pulls the curve "
                "into bends that are sharper than its knots. Smooth the field, or lower its "
                "weight.");
        }
        if (!drawn.figures["usable"].toBool()) {
            log(GLLogStream::WARNING,
                "The curve did not reach the distance tolerance: its layer shows how far it "
                "came. More picks, a thicker shell or more rounds may help.");
        }
        return std::move(drawn.figures);
    });
}

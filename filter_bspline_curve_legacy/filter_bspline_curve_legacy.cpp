// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_bspline_curve_legacy/filter_bspline_curve_legacy.h"

#include "bspline_curve/error.h"
#include "filter_bspline_curve/common/dialog_parameters.h"
#include "filter_bspline_curve/common/layer_arrays.h"
#include "filter_bspline_curve/common/result_layers.h"
#include "filter_bspline_curve/common/show_curve.h"
#include "filter_bspline_curve/common/surface_choice.h"
#include "filter_bspline_curve/common/window.h"
#include "filters/description_html.h"
#include "filters/labels.h"
#include "filters/run_filters.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <exception>
#include <string>

namespace {

using namespace bspline_curve;

constexpr int kAllDone = 100;

/// meshlabserver prints what it is told as it is, one after another: it needs line ends, and each
/// stage once. The window shows the last.
bool isServer() {
    return QFileInfo(QCoreApplication::applicationFilePath()).baseName() == "meshlabserver";
}

/// Reports progress as percents.
Progress hostProgress(vcg::CallBackPos* callback) {
    if (callback == nullptr) {
        return {};
    }
    return [callback,
            inLines = isServer(),
            last = std::string()](double fraction, const char* stage) mutable {
        std::string text = stage;
        if (inLines) {
            text = last == stage ? "" : last.assign(stage) + "\n";
        }
        return callback(static_cast<int>(fraction * (kAllDone - 1)), text.c_str());
    };
}

const FilterDescription& description(int filter) {
    return filter == FilterBsplineCurveLegacyPlugin::ScalarFieldForCurves ? fieldFilter()
                                                                          : curveFilter();
}

}  // namespace

FilterBsplineCurveLegacyPlugin::FilterBsplineCurveLegacyPlugin() {
    typeList = {BsplineCurveOnSurface, BsplineCurveAllOptions, ScalarFieldForCurves};
    for (const FilterIDType type : types()) {
        actionList.push_back(new QAction(filterName(type), this));
    }
}

QString FilterBsplineCurveLegacyPlugin::pluginName() const {
    return "FilterBsplineCurve";
}

QString FilterBsplineCurveLegacyPlugin::filterName(FilterIDType filter) const {
    const QString name = QString::fromStdString(description(filter).name);
    return filter == BsplineCurveAllOptions ? name + " (All Options)" : name;
}

QString FilterBsplineCurveLegacyPlugin::filterScriptFunctionName(FilterIDType filter) {
    return QString::fromStdString(description(filter).pythonName);
}

QString FilterBsplineCurveLegacyPlugin::filterInfo(FilterIDType filter) const {
    // Dialogs show it above the parameters.
    return QString::fromStdString(
        hasWindow() ? description(filter).shortDescription : descriptionHtml(description(filter))
    );
}

MeshFilterInterface::FilterClass FilterBsplineCurveLegacyPlugin::getClass(QAction* action) {
    return ID(action) == ScalarFieldForCurves ? Quality : MeshCreation;
}

MeshFilterInterface::FILTER_ARITY FilterBsplineCurveLegacyPlugin::filterArity(
    QAction* action
) const {
    return ID(action) == ScalarFieldForCurves ? SINGLE_MESH : FIXED;
}

int FilterBsplineCurveLegacyPlugin::postCondition(QAction* action) const {
    return ID(action) == ScalarFieldForCurves ? MeshModel::MM_VERTQUALITY : MeshModel::MM_NONE;
}

void FilterBsplineCurveLegacyPlugin::initParameterSet(
    QAction* action, MeshDocument& document, RichParameterList& parameters
) {
    const FilterIDType filter = ID(action);
    const Offered usual = hasWindow() ? Offered::Main : Offered::Usual;
    const Offered offered = filter == BsplineCurveOnSurface ? usual : Offered::All;
    parameters = dialogParameters(description(filter), document, offered);
}

bool FilterBsplineCurveLegacyPlugin::applyFilter(
    QAction* action,
    MeshDocument& document,
    const RichParameterList& parameters,
    vcg::CallBackPos* callback
) {
    const bool isField = ID(action) == ScalarFieldForCurves;
    errorMessage.clear();
    FilterLog written;
    try {
        written = isField ? computeField(document, parameters, callback)
                          : drawCurve(document, parameters, callback);
    } catch (const std::exception& error) {
        const std::string message = describeFailure(isField ? "field" : "curve", error);
        errorMessage = QString::fromStdString(
            hasWindow() ? withLabels(message, description(ID(action))) : message
        );
    }
    if (callback != nullptr) {
        callback(kAllDone, isServer() ? "" : "done");
    }
    if (written.figures.empty()) {
        Log(GLLogStream::WARNING, errorMessage.toStdString());
        return false;
    }
    writeLog(written);
    return true;
}

FilterLog FilterBsplineCurveLegacyPlugin::drawCurve(
    MeshDocument& document, const RichParameterList& parameters, vcg::CallBackPos* callback
) {
    const CurveRequest request = curveRequest(valuesOf(parameters, curveFilter()));
    const MeshModel& surface = surfaceOf(document, request);
    const LayerArrays arrays = arraysOf(surface);
    const CurveResult result = runCurveFilter(
        arrays.input,
        pickCandidates(document, surface, request),
        request,
        designers_,
        hostProgress(callback)
    );
    showCurve(document, surface, arrays, request, result);
    return result.log;
}

FilterLog FilterBsplineCurveLegacyPlugin::computeField(
    MeshDocument& document, const RichParameterList& parameters, vcg::CallBackPos* callback
) {
    MeshModel* const layer = document.mm();
    if (layer == nullptr) {
        throw InputError(
            InputErrorCode::EmptyMesh, "there is no layer: load a triangle mesh first"
        );
    }
    const FieldRequest request = fieldRequest(valuesOf(parameters, fieldFilter()));
    const LayerArrays arrays = arraysOf(*layer);
    const FieldResult result = runFieldFilter(arrays.input, request, hostProgress(callback));
    setQuality(*layer, arrays, result);
    return result.log;
}

void FilterBsplineCurveLegacyPlugin::writeLog(const FilterLog& written) {
    Log(GLLogStream::FILTER, written.figures);
    for (const std::string& warning : written.warnings) {
        Log(GLLogStream::WARNING, warning);
    }
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_bspline_curve/filter_bspline_curve.h"

#include "bspline_curve/error.h"
#include "filter_bspline_curve/common/dialog_parameters.h"
#include "filter_bspline_curve/common/layer_arrays.h"
#include "filter_bspline_curve/common/result_layers.h"
#include "filter_bspline_curve/common/show_curve.h"
#include "filter_bspline_curve/common/surface_choice.h"
#include "filter_bspline_curve/common/window.h"
#include "filters/description_html.h"
#include "filters/labels.h"

#include <exception>
#include <variant>

namespace {

using namespace bspline_curve;

constexpr int kAllDone = 100;

/// Reports progress as percents.
Progress hostProgress(vcg::CallBackPos* callback) {
    if (callback == nullptr) {
        return {};
    }
    return [callback](double fraction, const char* stage) {
        return callback(static_cast<int>(fraction * (kAllDone - 1)), stage);
    };
}

const FilterDescription& description(int filter) {
    return filter == FilterBsplineCurvePlugin::ScalarFieldForCurves ? fieldFilter() : curveFilter();
}

QVariant toVariant(const std::vector<double>& values) {
    return QVariant::fromValue<Eigen::VectorXd>(
        Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()))
    );
}

template <class Number>
QVariant toVariant(Number value) {
    return value;
}

std::map<std::string, QVariant> asHostExpects(const Figures& figures) {
    std::map<std::string, QVariant> answer;
    for (const Figure& figure : figures) {
        answer[figure.name] =
            std::visit([](const auto& value) { return toVariant(value); }, figure.value);
    }
    return answer;
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
    return QString::fromStdString(description(filter).name);
}

QString FilterBsplineCurvePlugin::pythonFilterName(ActionIDType filter) const {
    return QString::fromStdString(description(filter).pythonName);
}

QString FilterBsplineCurvePlugin::filterInfo(ActionIDType filter) const {
    // Dialogs show it above the parameters.
    return QString::fromStdString(
        hasWindow() ? description(filter).shortDescription : descriptionHtml(description(filter))
    );
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
    return dialogParameters(description(ID(action)), document);
}

std::map<std::string, QVariant> FilterBsplineCurvePlugin::applyFilter(
    const QAction* action,
    const RichParameterList& parameters,
    MeshDocument& document,
    unsigned int& postConditionMask,
    vcg::CallBackPos* callback
) {
    const bool isField = ID(action) == ScalarFieldForCurves;
    postConditionMask = static_cast<unsigned int>(postCondition(action));
    try {
        return asHostExpects(
            isField ? computeField(document, parameters, callback)
                    : drawCurve(document, parameters, callback)
        );
    } catch (const std::exception& error) {
        const std::string message = describeFailure(isField ? "field" : "curve", error);
        throw MLException(
            QString::fromStdString(
                hasWindow() ? withLabels(message, description(ID(action))) : message
            )
        );
    }
}

Figures FilterBsplineCurvePlugin::drawCurve(
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
    writeLog(result.log);
    return result.figures;
}

Figures FilterBsplineCurvePlugin::computeField(
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
    writeLog(result.log);
    return result.figures;
}

void FilterBsplineCurvePlugin::writeLog(const FilterLog& written) {
    log(written.figures);
    for (const std::string& warning : written.warnings) {
        log(GLLogStream::WARNING, warning);
    }
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_bspline_curve/filter_bspline_curve.h"

#include "filter_bspline_curve/common/dialog_parameters.h"
#include "filter_bspline_curve/common/fit_dialog.h"
#include "filter_bspline_curve/common/run_on_document.h"
#include "filter_bspline_curve/common/window.h"
#include "filters/description_html.h"

#include <cstddef>
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

/// The number of a filter is its place among all filters.
const FilterDescription& description(int filter) {
    return *allFilters().at(filter);
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
    for (std::size_t i = 0; i < allFilters().size(); ++i) {
        typeList.push_back(static_cast<ActionIDType>(i));
    }
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
    switch (menuOf(description(ID(action)))) {
        case Menu::Quality:
            return FilterPlugin::Quality;
        case Menu::Remeshing:
            return FilterPlugin::Remeshing;
        case Menu::Creation:
            break;
    }
    return FilterPlugin::MeshCreation;
}

FilterPlugin::FilterArity FilterBsplineCurvePlugin::filterArity(const QAction* action) const {
    return isField(description(ID(action))) ? FilterPlugin::SINGLE_MESH : FilterPlugin::FIXED;
}

int FilterBsplineCurvePlugin::postCondition(const QAction* action) const {
    return changesOf(description(ID(action)));
}

RichParameterList FilterBsplineCurvePlugin::initParameterList(
    const QAction* action, const MeshDocument& document
) {
    const FilterDescription& filter = description(ID(action));
    fitDialogSoon(filterName(ID(action)), filter);
    return dialogParameters(filter, document);
}

std::map<std::string, QVariant> FilterBsplineCurvePlugin::applyFilter(
    const QAction* action,
    const RichParameterList& parameters,
    MeshDocument& document,
    unsigned int& postConditionMask,
    vcg::CallBackPos* callback
) {
    const FilterDescription& filter = description(ID(action));
    postConditionMask = static_cast<unsigned int>(postCondition(action));
    try {
        const FilterAnswer answer =
            runOnDocument(filter, document, parameters, workpieces_, hostProgress(callback));
        writeLog(answer.log);
        return asHostExpects(answer.figures);
    } catch (const std::exception& error) {
        throw MLException(QString::fromStdString(failureOf(filter, error)));
    }
}

void FilterBsplineCurvePlugin::writeLog(const LogLines& written) {
    for (const std::string& line : written.lines) {
        log(line);
    }
    for (const std::string& warning : written.warnings) {
        log(GLLogStream::WARNING, warning);
    }
}

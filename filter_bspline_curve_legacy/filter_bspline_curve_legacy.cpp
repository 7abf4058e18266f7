// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_bspline_curve_legacy/filter_bspline_curve_legacy.h"

#include "filter_bspline_curve/common/dialog_parameters.h"
#include "filter_bspline_curve/common/fit_dialog.h"
#include "filter_bspline_curve/common/run_on_document.h"
#include "filter_bspline_curve/common/window.h"
#include "filters/description_html.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <algorithm>
#include <exception>
#include <functional>
#include <string>
#include <vector>

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

/// A filter as this host lists it.
struct Listed {
    const FilterDescription& filter;
    bool isTwin = false;   ///< with all options
    bool hasTwin = false;  ///< so it has the main ones in a window
};

/// Whether its dialog would have many parameters that most people do not need.
bool needsTwin(const FilterDescription& filter) {
    return std::ranges::any_of(filter.parameters, [](const ParameterDescription& parameter) {
        return parameter.isFolded() && !parameter.isAdvanced();
    });
}

/// In the order of allFilters(), and after all of them the twins.
const std::vector<Listed>& listed() {
    static const std::vector<Listed> filters = [] {
        std::vector<Listed> all;
        for (const FilterDescription* const filter : allFilters()) {
            all.push_back({.filter = *filter, .hasTwin = needsTwin(*filter)});
        }
        for (const FilterDescription* const filter : allFilters()) {
            if (needsTwin(*filter)) {
                all.push_back({.filter = *filter, .isTwin = true});
            }
        }
        return all;
    }();
    return filters;
}

int listedCount() {
    return static_cast<int>(listed().size());
}

const FilterDescription& description(int filter) {
    return listed().at(filter).filter;
}

/// A script lists each parameter that it is told of.
Offered offeredOf(const Listed& each) {
    if (hasWindow()) {
        return each.hasTwin ? Offered::Main : Offered::All;
    }
    return !each.isTwin && &each.filter == &curveFilter() ? Offered::Usual : Offered::All;
}

}  // namespace

FilterBsplineCurveLegacyPlugin::FilterBsplineCurveLegacyPlugin() {
    for (int filter = 0; filter < listedCount(); ++filter) {
        typeList.push_back(filter);
    }
    // The search of the window lists filters whose names match alike by the address of their
    // actions, so those of earlier filters get lower ones: a filter goes before its twin.
    std::vector<QAction*> actions;
    for (int filter = 0; filter < listedCount(); ++filter) {
        actions.push_back(new QAction(this));
    }
    std::ranges::sort(actions, std::less<>());
    for (int filter = 0; filter < listedCount(); ++filter) {
        actions[filter]->setText(filterName(filter));
        actionList.push_back(actions[filter]);
    }
}

QString FilterBsplineCurveLegacyPlugin::pluginName() const {
    return "FilterBsplineCurve";
}

QString FilterBsplineCurveLegacyPlugin::filterName(FilterIDType filter) const {
    const QString name = QString::fromStdString(description(filter).name);
    return listed().at(filter).isTwin ? name + " (All Options)" : name;
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
    switch (menuOf(description(ID(action)))) {
        case Menu::Quality:
            return Quality;
        case Menu::Remeshing:
            return Remeshing;
        case Menu::Creation:
            break;
    }
    return MeshCreation;
}

MeshFilterInterface::FILTER_ARITY FilterBsplineCurveLegacyPlugin::filterArity(
    QAction* action
) const {
    return isField(description(ID(action))) ? SINGLE_MESH : FIXED;
}

int FilterBsplineCurveLegacyPlugin::postCondition(QAction* action) const {
    return changesOf(description(ID(action)));
}

void FilterBsplineCurveLegacyPlugin::initParameterSet(
    QAction* action, MeshDocument& document, RichParameterList& parameters
) {
    const FilterIDType filter = ID(action);
    fitDialogSoon(filterName(filter), description(filter));
    parameters = dialogParameters(description(filter), document, offeredOf(listed().at(filter)));
}

bool FilterBsplineCurveLegacyPlugin::applyFilter(
    QAction* action,
    MeshDocument& document,
    const RichParameterList& parameters,
    vcg::CallBackPos* callback
) {
    const FilterDescription& filter = description(ID(action));
    errorMessage.clear();
    LogLines written;
    try {
        written =
            runOnDocument(filter, document, parameters, workpieces_, hostProgress(callback)).log;
    } catch (const std::exception& error) {
        errorMessage = QString::fromStdString(failureOf(filter, error));
    }
    if (callback != nullptr) {
        callback(kAllDone, isServer() ? "" : "done");
    }
    if (written.lines.empty()) {
        Log(GLLogStream::WARNING, errorMessage.toStdString());
        return false;
    }
    writeLog(written);
    return true;
}

void FilterBsplineCurveLegacyPlugin::writeLog(const LogLines& written) {
    for (const std::string& line : written.lines) {
        Log(GLLogStream::FILTER, line);
    }
    for (const std::string& warning : written.warnings) {
        Log(GLLogStream::WARNING, warning);
    }
}

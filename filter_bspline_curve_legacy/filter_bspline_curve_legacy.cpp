// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_bspline_curve_legacy/filter_bspline_curve_legacy.h"

#include "filter_bspline_curve/common/dialog_parameters.h"
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

/// The filters stand in the order of allFilters(); after them comes the twin of the first, with all
/// options.
int twin() {
    return static_cast<int>(allFilters().size());
}

const FilterDescription& description(int filter) {
    return *allFilters().at(filter == twin() ? 0 : filter);
}

}  // namespace

FilterBsplineCurveLegacyPlugin::FilterBsplineCurveLegacyPlugin() {
    for (int filter = 0; filter <= twin(); ++filter) {
        typeList.push_back(filter);
    }
    // The search of the window lists filters whose names match alike by the address of their
    // actions, so those of earlier filters get lower ones: the first goes before its twin.
    std::vector<QAction*> actions;
    for (int filter = 0; filter <= twin(); ++filter) {
        actions.push_back(new QAction(this));
    }
    std::ranges::sort(actions, std::less<>());
    for (int filter = 0; filter <= twin(); ++filter) {
        actions[filter]->setText(filterName(filter));
        actionList.push_back(actions[filter]);
    }
}

QString FilterBsplineCurveLegacyPlugin::pluginName() const {
    return "FilterBsplineCurve";
}

QString FilterBsplineCurveLegacyPlugin::filterName(FilterIDType filter) const {
    const QString name = QString::fromStdString(description(filter).name);
    return filter == twin() ? name + " (All Options)" : name;
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
    const Offered usual = hasWindow() ? Offered::Main : Offered::Usual;
    const Offered offered = filter == 0 ? usual : Offered::All;
    parameters = dialogParameters(description(filter), document, offered);
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
            runOnDocument(filter, document, parameters, designers_, hostProgress(callback)).log;
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

// SPDX-License-Identifier: GPL-3.0-or-later
// What becomes of the curves that are drawn with the tool: layers and files.
#include "edit_bspline_curve/common/curve_tool.h"
#include "edit_bspline_curve/common/curve_words.h"
#include "edit_bspline_curve/common/kept_settings.h"
#include "filters/curve_figures.h"
#include "filters/utf8_path.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <algorithm>
#include <chrono>
#include <exception>
#include <utility>

namespace bspline_curve {
namespace {

/// The host waits no longer than this for curves that are still being solved when the tool ends;
/// their picks are kept then.
constexpr std::chrono::milliseconds kPatience(150);

/// Formats of the files that curves are saved to and opened from.
constexpr const char* kFiles = "Curves (*.json *.obj *.dxf)";

}  // namespace

CurveMaker CurveTool::maker() {
    return {
        .drawn = [this](const SketchCurve& curve) { return toDrawn(curve); },
        .result =
            [this](const SketchCurve& curve, const CurveRequest& request) {
                const auto& guides = curve.options.guides;
                DesignedCurve drawn = workpiece_->finished(
                    *curve.settled, guides ? guides->values().field : ScalarField()
                );
                drawn.seconds = secondsOf(drawn.curve.report);
                // The surface is kept for all curves but the first.
                const bool isKept = std::exchange(hasResults_, true);
                return curveResult(std::move(drawn), {workpiece_, isKept}, request);
            }
    };
}

void CurveTool::makeLayers() {
    isMaking_ = session_ != nullptr;
    refresh();
}

void CurveTool::use(const FilterDescription& filter) {
    used_ = &filter;
    makeLayers();
}

void CurveTool::makeWhatWaits() {
    if (!isMaking_ || !session_->isSettled()) {
        return;
    }
    isMaking_ = false;
    const FilterDescription* const filter = std::exchange(used_, nullptr);
    if (!bringLayers() || filter == nullptr) {
        return;
    }
    try {
        uses_.start(*filter);
        timer_.start(kLookEvery);
        takeUse();  // so that its button is there for the next click
    } catch (const std::exception& error) {
        notice_ = error.what();
    }
}

void CurveTool::cancelUse() {
    if (uses_.cancel()) {
        notice_ = tr("Stopped.");
        refresh();
    }
}

// Whether what could be made was made.
bool CurveTool::bringLayers() {
    try {
        notice_ = madeText(layers_.bring(session_->sketch(), maker()));
        const SketchCurve* const active = session_->sketch().activeCurve();
        if (active != nullptr && layers_.isLayer(*active)) {
            session_->newCurve();  // the next click begins one
        }
        return true;
    } catch (const std::exception& error) {
        notice_ = error.what();
        return false;
    }
}

QString CurveTool::madeText(int made) const {
    const std::vector<std::shared_ptr<SketchCurve>>& curves = session_->sketch().curves;
    const auto left = static_cast<int>(std::ranges::count_if(curves, [&](const auto& curve) {
        return !layers_.isLayer(*curve);
    }));
    if (left > 0) {
        return tr("%1 made. %2 not finished: add picks, or move those that are red.")
            .arg(
                countText(made, "layer"),
                countText(left, "curve") + (left == 1 ? tr(" is") : tr(" are"))
            );
    }
    return made > 0 || curves.empty() ? tr("%1 made.").arg(countText(made, "layer"))
                                      : tr("All curves are layers already.");
}

void CurveTool::finish() {
    if (!session_) {
        return;
    }
    session_->cancel();
    uses_.finish();
    static_cast<void>(session_->settleWithin(kPatience));
    if (!bringLayers()) {
        layers_.say(notice_.toStdString());
    }
    layers_.show(session_->sketch(), true);
    const int left = layers_.keepUnfinished(session_->sketch(), maker());
    if (left > 0) {
        layers_.say(
            countText(left, "curve").toStdString() + (left == 1 ? " is" : " are") +
            " not finished, and kept with the surface: the drawing tool goes on with " +
            (left == 1 ? "it" : "them") + " when it is started there again."
        );
    }
}

// ---- Files ----

CurveFileSurface CurveTool::fileSurface() const {
    return {
        .mesh = workpiece_->mesh(),
        .checksum = workpiece_->checksum(),
        .workpiece = workpiece_.get()
    };
}

// Whether all curves are in a file now.
bool CurveTool::save() {
    session_->cancel();
    const QPointer<CurveTool> self(this);
    const QString file = QFileDialog::getSaveFileName(
        view_.window(), tr("Save curves"), QDir(kept::folder()).filePath("curves.json"), kFiles
    );
    if (file.isEmpty() || self.isNull() || !session_) {  // the tool may end while somebody chooses
        return false;
    }
    static_cast<void>(session_->settleWithin(kPatience));  // others are saved with their picks
    std::vector<CurveToSave> curves;
    for (const std::shared_ptr<SketchCurve>& curve : session_->sketch().curves) {
        curves.push_back({toDrawn(*curve), curve->settled});
    }
    try {
        saveDrawnCurves(utf8Path(file.toStdString()), curves, fileSurface());
    } catch (const std::exception& error) {
        QMessageBox::warning(view_.window(), tr("B-spline Curves"), error.what());
        return false;
    }
    kept::setFolder(QFileInfo(file).path());
    saved_.assign(session_->sketch().curves.begin(), session_->sketch().curves.end());
    notice_ =
        tr("%1 saved to %2.")
            .arg(countText(static_cast<int>(curves.size()), "curve"), QFileInfo(file).fileName());
    refresh();
    return true;
}

void CurveTool::open() {
    const QPointer<CurveTool> self(this);
    const QString file =
        QFileDialog::getOpenFileName(view_.window(), tr("Open curves"), kept::folder(), kFiles);
    if (file.isEmpty() || self.isNull() || !session_) {
        return;
    }
    try {
        const OpenedCurves opened = openDrawnCurves(utf8Path(file.toStdString()), fileSurface());
        std::vector<SketchCurve> curves;
        for (const DrawnCurve& drawn : opened.curves) {
            curves.push_back(toSketch(drawn, true));
        }
        session_->add(std::move(curves));
        kept::setFolder(QFileInfo(file).path());
        notice_ = tr("%1 opened.").arg(countText(static_cast<int>(opened.curves.size()), "curve"));
        for (const std::string& note : opened.notes) {
            notice_ += "\n" + QString::fromStdString(note);
        }
    } catch (const std::exception& error) {
        notice_ = error.what();
    }
    refresh();
}

}  // namespace bspline_curve

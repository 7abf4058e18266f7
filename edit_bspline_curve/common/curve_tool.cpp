// SPDX-License-Identifier: GPL-3.0-or-later
#include "edit_bspline_curve/common/curve_tool.h"

#include "bspline_curve/error.h"
#include "design/designer_surface.h"
#include "edit_bspline_curve/common/curve_words.h"
#include "edit_bspline_curve/common/kept_settings.h"
#include "edit_bspline_curve/common/sketch_painter.h"
#include "field/make_field.h"
#include "filters/find_designer.h"
#include "filters/mended_layer.h"
#include "filters/utf8_path.h"

#include <QAction>
#include <QApplication>
#include <QCloseEvent>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMdiArea>
#include <QMdiSubWindow>
#include <QMessageBox>
#include <QMouseEvent>
#include <QPushButton>
#include <QWheelEvent>
#include <algorithm>
#include <chrono>
#include <exception>
#include <utility>

namespace bspline_curve {
namespace {

constexpr int kLookEvery = 15;  // milliseconds

/// The host waits no longer than this for curves that are still being solved when the tool ends;
/// their picks are kept then.
constexpr std::chrono::milliseconds kPatience(150);

/// Formats of the files that curves are saved to and opened from.
constexpr const char* kFiles = "Curves (*.json *.obj *.dxf)";

QAction* suspendingActionOf(const QWidget& window) {
    for (QAction* const action : window.findChildren<QAction*>()) {
        if (action->shortcut() == QKeySequence(Qt::Key_Escape) && action->isCheckable()) {
            return action;
        }
    }
    return nullptr;
}

double secondsOf(const SolveReport& report) {
    const auto& s = report.seconds;
    return s.path + s.initial + s.minimise + s.knots + s.polyline + s.failedAttempts;
}

}  // namespace

CurveTool::CurveTool(QGLWidget& view, ToolStart start, SketchLayers& layers, Use use)
    : view_(view),
      layers_(layers),
      use_(std::move(use)),
      start_(std::move(start)),
      hadTracking_(view.hasMouseTracking()),
      panel_(new ToolPanel(view)),
      suspending_(suspendingActionOf(*view.window())),
      preparing_(
          std::async(
              std::launch::async,
              [layer = std::move(start_.surface), progress = untilTheEnd()]() mutable {
                  const MeshChecksum checksum = checksumOf(layer.mesh);
                  DesignerCache designers;
                  // Strictness is the filter's.
                  DesignerCache::Found found = designerFor(layer, {}, {}, designers, progress);
                  if (const MeshRepair* const repair = found.repair()) {
                      layer = carriedOver(layer, *repair);
                  }
                  return Prepared{std::move(found), std::move(layer), checksum};
              }
          )
      ),
      notice_(start_.note) {
    view_.setMouseTracking(true);
    qApp->installEventFilter(this);
    connect(qApp, &QCoreApplication::aboutToQuit, this, &CurveTool::stop);
    connect(&timer_, &QTimer::timeout, this, &CurveTool::look);
    if (suspending_ != nullptr) {
        connect(suspending_, &QAction::toggled, this, &CurveTool::refresh);
    }
    connectPanel();
    panel_->say(tr("Preparing the surface …"));
    timer_.start(kLookEvery);
}

CurveTool::~CurveTool() {
    qApp->removeEventFilter(this);
    view_.setMouseTracking(hadTracking_);
    if (isLent_) {
        toggleCamera();
    }
    stop();
    delete panel_;
}

void CurveTool::connectPanel() {
    connect(panel_, &ToolPanel::optionsChanged, this, &CurveTool::setOptions);
    connect(panel_, &ToolPanel::keyAsked, this, &CurveTool::runKey);
    connect(panel_, &ToolPanel::commitAsked, this, &CurveTool::makeLayers);
    connect(panel_, &ToolPanel::useAsked, this, [this](const FilterDescription* filter) {
        use(*filter);
    });
    connect(panel_, &ToolPanel::turnAsked, this, &CurveTool::setTurning);
    connect(panel_, &ToolPanel::magnetChanged, this, &CurveTool::refresh);
    connect(panel_, &ToolPanel::unitChanged, this, &CurveTool::refresh);
    // Later, since these rebuild the list that tells of them.
    connect(panel_, &ToolPanel::curveChosen, this, [this](int curve) {
        QTimer::singleShot(0, this, [this, curve] { choose(curve); });
    });
    connect(panel_, &ToolPanel::lookAsked, this, [this](int curve, const SketchLook& look) {
        QTimer::singleShot(0, this, [this, curve, look] { setLook(curve, look); });
    });
    connect(panel_, &ToolPanel::saveAsked, this, &CurveTool::save);
    connect(panel_, &ToolPanel::openAsked, this, &CurveTool::open);
    connect(panel_, &ToolPanel::closed, this, [this] {
        QMetaObject::invokeMethod(&view_, "endEdit", Qt::QueuedConnection);
    });
}

Progress CurveTool::untilTheEnd() const {
    return [this](double, const char*) { return !isEnding_; };
}

void CurveTool::stop() {
    isEnding_ = true;
    timer_.stop();
    preparing_ = {};  // waits
    preparingCrests_ = {};
    session_.reset();
}

// ---- What is prepared ----

void CurveTool::look() {
    const auto isReady = [](const auto& future) {
        return future.valid() &&
               future.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    };
    try {
        if (isReady(preparing_)) {
            begin(preparing_.get());
        }
        if (isReady(preparingCrests_)) {
            session_->setSnapping(preparingCrests_.get());
        }
    } catch (const std::exception& error) {
        panel_->say(error.what());
    }
    if (!preparing_.valid() && !preparingCrests_.valid()) {
        timer_.stop();
    }
}

void CurveTool::begin(Prepared prepared) {
    found_ = std::move(prepared.found);
    checksum_ = prepared.checksum;
    options_ = std::make_unique<OptionBook>(found_.designer, std::move(prepared.layer));
    SessionSettings settings;
    settings.colour = kept::colour();
    // The session's thread wakes ours.
    settings.wake = [this] {
        QMetaObject::invokeMethod(this, [this] { refresh(); }, Qt::QueuedConnection);
    };
    session_ = std::make_unique<DrawingSession>(found_.designer, std::move(settings));
    std::vector<SketchCurve> curves;
    for (const TakenUp& taken : start_.curves) {
        curves.push_back(toSketch(taken.curve, taken.layer >= 0 && found_.repair() == nullptr));
        curves.back().look.isHidden = taken.isHidden;
    }
    session_->begin(std::move(curves), start_.active);
    layers_.begin(start_.curves, session_->sketch());
    if (kept::isMagnetOn()) {
        prepareCrests();
    }
    refresh();
}

// `isOnMesh`: the picks are on the designer's mesh; else their positions are near to it.
SketchCurve CurveTool::toSketch(const DrawnCurve& drawn, bool isOnMesh) {
    SketchCurve curve;
    curve.look.name = drawn.name;
    if (drawn.colour) {
        curve.look.colour = {(*drawn.colour)[0], (*drawn.colour)[1], (*drawn.colour)[2]};
    }
    curve.picks = drawn.picks;
    curve.options = options_->toSketch(drawn.options);
    if (!isOnMesh) {
        for (SketchPick& pick : curve.picks) {
            pick.point = treeOf(*found_.designer).closestPoint(pick.position).point;
        }
    }
    return curve;
}

DrawnCurve CurveTool::toDrawn(const SketchCurve& curve) const {
    constexpr std::uint8_t kOpaque = 255;
    const SketchColour& colour = curve.look.colour;
    return {
        .picks = curve.picks,
        .options = options_->fromSketch(curve.options),
        .name = curve.look.name,
        .colour = CurveColour{colour.red, colour.green, colour.blue, kOpaque}
    };
}

// Ridges and valleys take seconds on a large mesh, so they wait until somebody snaps.
void CurveTool::prepareCrests() {
    if (std::exchange(hasCrests_, true)) {
        return;
    }
    preparingCrests_ =
        std::async(std::launch::async, [designer = found_.designer, progress = untilTheEnd()] {
            const auto field = [&](FieldKind kind) {
                return std::make_shared<const std::vector<double>>(
                    makeField(surfaceOf(*designer), FieldOptions{.kind = kind}, {}, progress)
                );
            };
            SnapOptions snapping;
            snapping.ridge = field(FieldKind::Ridge);
            snapping.valley = field(FieldKind::Valley);
            return snapping;
        });
    timer_.start(kLookEvery);
}

void CurveTool::refresh() {
    if (session_) {
        session_->update();
        layers_.show(session_->sketch());
        makeWhatWaits();
    }
    if (panel_ == nullptr) {
        return;
    }
    PanelState state;
    state.session = session_.get();
    if (const SketchCurve* const curve = session_ ? session_->sketch().activeCurve() : nullptr) {
        state.active = options_->fromSketch(curve->options);
    }
    state.isTurning = isTurning_;
    state.isHostsCamera = isHostsCamera();
    state.isMaking = isMaking_;
    state.notice = notice_;
    state.edge = session_ ? surfaceOf(*found_.designer).averageEdgeLength() : 0.0;
    panel_->show(state);
    view_.update();
}

void CurveTool::draw() {
    seen_.emplace(view_);
    if (session_) {
        session_->update();
        paintSketch(*session_, *seen_);
    }
}

// ---- The mouse ----

Pointer CurveTool::pointerOf(const QMouseEvent& event, const View& seen) {
    Pointer pointer = seen.pointerAt(event.localPos());
    pointer.snaps = event.modifiers().testFlag(Qt::ControlModifier) != kept::isMagnetOn();
    pointer.removes = event.modifiers().testFlag(Qt::ShiftModifier);
    if (pointer.snaps) {
        prepareCrests();
    }
    return pointer;
}

void CurveTool::mousePress(QMouseEvent& event) {
    last_ = event.localPos();
    notice_.clear();
    const bool isOurs = session_ && seen_ && !isTurning_ && event.button() == Qt::LeftButton &&
                        !event.modifiers().testFlag(Qt::AltModifier);
    if (!isOurs || !session_->press(pointerOf(event, *seen_))) {
        lendToCamera(event);
    }
    refresh();
}

void CurveTool::mouseMove(QMouseEvent& event) {
    last_ = event.localPos();
    if (session_ && seen_ && !isTurning_) {
        session_->move(pointerOf(event, *seen_));
        refresh();
    }
}

void CurveTool::mouseRelease(QMouseEvent& event) {
    if (session_ && seen_ && event.button() == Qt::LeftButton) {
        session_->release(pointerOf(event, *seen_));
        refresh();
    }
}

void CurveTool::wheel(QWheelEvent& event) {
    toggleCamera();
    QWheelEvent same(event);
    QCoreApplication::sendEvent(&view_, &same);
    toggleCamera();
}

// ---- Options and looks ----

void CurveTool::setOptions(const DrawnOptions& options, bool isLive) {
    if (!session_) {
        return;
    }
    notice_.clear();
    try {
        session_->setOptions(options_->toSketch(options), isLive);
    } catch (const InputError& error) {
        notice_ = error.what();
    }
    refresh();
}

void CurveTool::setLook(int curve, const SketchLook& look) {
    if (!session_ || curve >= static_cast<int>(session_->sketch().curves.size())) {
        return;
    }
    if (!(look.colour == session_->sketch().curves[curve]->look.colour)) {
        kept::setColour(look.colour);  // and of curves to come
        session_->setColour(look.colour);
    }
    session_->setLook(curve, look);
    refresh();
}

void CurveTool::choose(int curve) {
    if (session_ && curve < static_cast<int>(session_->sketch().curves.size())) {
        session_->select(curve);
        refresh();
    }
}

// ---- Layers ----

CurveMaker CurveTool::maker() {
    return {
        .drawn = [this](const SketchCurve& curve) { return toDrawn(curve); },
        .result =
            [this](const SketchCurve& curve, const CurveRequest& request) {
                const std::vector<double> none;
                const std::vector<double>& field =
                    curve.options.guides ? curve.options.guides->values().field : none;
                const Curve& drawn = *curve.settled;
                CurveResult result =
                    curveResult({}, drawn, field, secondsOf(drawn.report), found_, request);
                found_.isKept = true;  // by the next curve
                return result;
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
        use_(*filter);
    } catch (const std::exception& error) {
        notice_ = error.what();
    }
}

// Whether what could be made was made.
bool CurveTool::bringLayers() {
    session_->newCurve();  // the next click begins one
    try {
        const int count = layers_.bring(session_->sketch(), maker());
        notice_ = count == 0 ? tr("All curves are layers already.")
                             : tr("%1 made.").arg(countText(count, "layer"));
        return true;
    } catch (const std::exception& error) {
        notice_ = error.what();
        return false;
    }
}

void CurveTool::finish() {
    if (!session_) {
        return;
    }
    session_->cancel();
    static_cast<void>(session_->settleWithin(kPatience));
    static_cast<void>(bringLayers());
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
        .mesh = found_.designer->mesh(),
        .checksum = checksum_,
        .repair = found_.repair(),
        .tree = &treeOf(*found_.designer)
    };
}

// Whether all curves are in a file now.
bool CurveTool::save() {
    const QString file = QFileDialog::getSaveFileName(
        view_.window(), tr("Save curves"), QDir(kept::folder()).filePath("curves.json"), kFiles
    );
    if (file.isEmpty()) {
        return false;
    }
    session_->settle();
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
    const QString file =
        QFileDialog::getOpenFileName(view_.window(), tr("Open curves"), kept::folder(), kFiles);
    if (file.isEmpty() || !session_) {
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

// ---- Keys, and the end of the host ----

bool CurveTool::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
        case QEvent::ShortcutOverride:
        case QEvent::KeyPress:
            return takeKey(*watched, static_cast<QKeyEvent&>(*event));
        case QEvent::Close:
            if (watched == view_.window()) {
                const bool may = mayClose();
                event->setAccepted(may);
                return !may;
            }
            if (const auto* const widget = qobject_cast<QWidget*>(watched);
                widget != nullptr && widget->isAncestorOf(&view_)) {
                finish();  // the host asks about layers
            }
            return false;
        case QEvent::MouseButtonRelease:
            return watched == &view_ && isLent_ &&
                   returnFromCamera(static_cast<QMouseEvent&>(*event));
        case QEvent::Leave:
            if (watched == &view_ && session_) {
                session_->leave();
                refresh();
            }
            return false;
        default:
            return false;
    }
}

// Whether keys in the host's window are for this view: nothing is open above, and its document is
// the one in front.
bool CurveTool::isInFront() const {
    if (QApplication::activeModalWidget() != nullptr ||
        QApplication::activePopupWidget() != nullptr || panel_ == nullptr) {
        return false;
    }
    const QWidget* const active = QApplication::activeWindow();
    if (active != view_.window() && active != panel_) {
        return false;
    }
    for (const QWidget* widget = &view_; widget != nullptr; widget = widget->parentWidget()) {
        if (const auto* const document = qobject_cast<const QMdiSubWindow*>(widget)) {
            return document->mdiArea() == nullptr ||
                   document->mdiArea()->currentSubWindow() == document;
        }
    }
    return true;
}

// Whether nobody else is to have the key. The host's shortcuts never have it.
bool CurveTool::takeKey(QObject& watched, QKeyEvent& event) {
    const std::optional<ToolKey> key = toolKeyOf(event);
    if (!key || !isInFront()) {
        return false;
    }
    if (event.type() == QEvent::ShortcutOverride) {
        event.accept();
        return true;
    }
    const bool isOnItsWay = !watched.isWidgetType();  // to a widget
    if (isOnItsWay || !isForTool(*key, QApplication::focusWidget(), *panel_)) {
        return false;
    }
    event.accept();
    run(*key);
    return true;
}

void CurveTool::run(const ToolKey& key) {
    switch (key.action) {
        case ToolKey::Action::Sketch:
            runKey(key.sketch);
            break;
        case ToolKey::Action::MakeLayers:
            makeLayers();
            break;
        case ToolKey::Action::TurnView:
            if (isHostsCamera()) {
                suspending_->trigger();
            } else if (session_ && session_->isDragging()) {
                runKey(SketchKey::Cancel);
            } else {
                setTurning(!isTurning_);
            }
            break;
        case ToolKey::Action::Nothing:
            break;
    }
}

void CurveTool::runKey(SketchKey key) {
    notice_.clear();
    if (session_ && seen_) {
        Pointer pointer = seen_->pointerAt(last_);
        pointer.snaps = kept::isMagnetOn();
        session_->key(key, pointer);
        refresh();
    }
}

bool CurveTool::isSaved(const std::shared_ptr<SketchCurve>& curve) const {
    return layers_.isSaved(*curve) || std::ranges::find(saved_, curve) != saved_.end();
}

// The host does not ask, so this does.
bool CurveTool::mayClose() {
    if (!session_) {
        return true;
    }
    session_->cancel();
    const std::vector<std::shared_ptr<SketchCurve>>& curves = session_->sketch().curves;
    const auto count = static_cast<int>(std::ranges::count_if(curves, [&](const auto& curve) {
        return !isSaved(curve);
    }));
    if (count == 0) {
        return true;
    }
    QMessageBox question(
        QMessageBox::Question,
        tr("B-spline Curves"),
        tr("%1 that you drew %2 not saved in a file.")
            .arg(countText(count, "curve"), count == 1 ? "is" : "are"),
        QMessageBox::NoButton,
        view_.window()
    );
    QPushButton* const saves = question.addButton(tr("Save …"), QMessageBox::AcceptRole);
    question.addButton(tr("Close without saving"), QMessageBox::DestructiveRole);
    QPushButton* const stay = question.addButton(tr("Go on drawing"), QMessageBox::RejectRole);
    question.setDefaultButton(stay);
    question.setEscapeButton(stay);
    question.exec();
    if (question.clickedButton() == saves) {
        return save();
    }
    return question.clickedButton() != stay;
}

// ---- The camera ----

// The host gives all events to the tool while it is not suspended.
void CurveTool::toggleCamera() {
    QMetaObject::invokeMethod(&view_, "suspendEditToggle");
}

bool CurveTool::isHostsCamera() const {
    return suspending_ != nullptr && suspending_->isEnabled() && suspending_->isChecked();
}

void CurveTool::setTurning(bool turns) {
    isTurning_ = turns;
    if (session_) {
        session_->cancel();
        session_->leave();
    }
    refresh();
}

// The right button turns the view as the left one does in the host's camera, since the left one
// draws.
void CurveTool::lendToCamera(QMouseEvent& event) {
    isLent_ = true;
    toggleCamera();
    const auto asLeft = [](Qt::MouseButton button) {
        return button == Qt::RightButton ? Qt::LeftButton : button;
    };
    QMouseEvent same(
        event.type(),
        event.localPos(),
        event.windowPos(),
        event.screenPos(),
        asLeft(event.button()),
        asLeft(event.button()),
        // What the tool alone asked for is not the camera's.
        event.modifiers() & ~Qt::KeyboardModifiers(Qt::AltModifier)
    );
    QCoreApplication::sendEvent(&view_, &same);
}

// Whether the event was handed on in another shape.
bool CurveTool::returnFromCamera(QMouseEvent& event) {
    // After the camera had it.
    QMetaObject::invokeMethod(
        this,
        [this] {
            if (std::exchange(isLent_, false)) {
                toggleCamera();
            }
        },
        Qt::QueuedConnection
    );
    if (event.button() != Qt::RightButton) {
        return false;
    }
    QMouseEvent asLeft(
        event.type(),
        event.localPos(),
        event.windowPos(),
        event.screenPos(),
        Qt::LeftButton,
        Qt::NoButton,
        event.modifiers()
    );
    QCoreApplication::sendEvent(&view_, &asLeft);
    return true;
}

}  // namespace bspline_curve

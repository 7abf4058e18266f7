// SPDX-License-Identifier: GPL-3.0-or-later
#include "edit_bspline_curve/common/curve_tool.h"

#include "bspline_curve/error.h"
#include "edit_bspline_curve/common/kept_settings.h"
#include "edit_bspline_curve/common/sketch_painter.h"

#include <QAction>
#include <QApplication>
#include <QKeySequence>
#include <QMouseEvent>
#include <QWheelEvent>
#include <chrono>
#include <exception>
#include <utility>

namespace bspline_curve {
namespace {

/// Handles of directions are so far from their picks, in logical pixels.
constexpr double kTangentReach = 40.0;

QAction* suspendingActionOf(const QWidget& window) {
    for (QAction* const action : window.findChildren<QAction*>()) {
        if (action->shortcut() == QKeySequence(Qt::Key_Escape) && action->isCheckable()) {
            return action;
        }
    }
    return nullptr;
}

}  // namespace

CurveTool::CurveTool(QGLWidget& view, ToolStart start, SketchLayers& layers, CurveUses& uses)
    : view_(view),
      layers_(layers),
      uses_(uses),
      start_(std::move(start)),
      hadTracking_(view.hasMouseTracking()),
      panel_(new ToolPanel(view)),
      suspending_(suspendingActionOf(*view.window())),
      preparing_(
          std::async(
              std::launch::async,
              [surface = std::move(start_.surface), progress = untilTheEnd()]() mutable {
                  return prepare(std::move(surface), progress);
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
    connect(panel_, &ToolPanel::cancelAsked, this, &CurveTool::cancelUse);
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

CurveTool::Prepared CurveTool::prepare(LayerArrays surface, const Progress& progress) {
    Prepared prepared;
    prepared.ofLayer = checksumOf(surface);
    // Strictness is the filter's.
    prepared.workpiece = workpieceOf(surface.input, {}, progress);
    prepared.workpiece->prepare(progress);
    prepared.layer = std::move(surface.input);
    return prepared;
}

void CurveTool::look() {
    takePrepared();
    takeUse();
    if (!preparing_.valid() && !preparingCrests_.valid() && uses_.running() == nullptr &&
        !uses_.waits()) {
        timer_.stop();
    }
}

void CurveTool::takePrepared() {
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
}

// What the filter made is the current layer then, the surface is hidden, and the drawing is over:
// so this waits for the end of a drag, and for answers to what is asked.
void CurveTool::takeUse() {
    if (panel_ != nullptr) {
        panel_->showUse(uses_.running());
    }
    if (!uses_.waits() || (session_ && session_->isDragging()) ||
        QApplication::activeModalWidget() != nullptr) {
        return;
    }
    try {
        if (uses_.step()) {
            QMetaObject::invokeMethod(&view_, "updateLayerTable", Qt::QueuedConnection);
            QMetaObject::invokeMethod(&view_, "endEdit", Qt::QueuedConnection);
        }
    } catch (const std::exception& error) {
        notice_ = error.what();
        refresh();
    }
}

void CurveTool::begin(Prepared prepared) {
    workpiece_ = std::move(prepared.workpiece);
    options_ = std::make_unique<OptionBook>(workpiece_, std::move(prepared.layer));
    SessionSettings settings;
    settings.colour = kept::colour();
    settings.handlePixels = kTangentReach;
    // The session's thread wakes ours.
    settings.wake = [this] {
        QMetaObject::invokeMethod(this, [this] { refresh(); }, Qt::QueuedConnection);
    };
    session_ = std::make_unique<DrawingSession>(workpiece_, std::move(settings));
    std::vector<SketchCurve> curves;
    for (const TakenUp& taken : start_.curves) {
        curves.push_back(toSketch(taken.curve, taken.layer >= 0));
        curves.back().look.isHidden = taken.isHidden;
    }
    session_->begin(std::move(curves), start_.active);
    layers_.begin(start_.curves, session_->sketch(), prepared.ofLayer);
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
            pick.point = workpiece_->closestPoint(pick.position).place;
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
        std::async(std::launch::async, [workpiece = workpiece_, progress = untilTheEnd()] {
            const auto field = [&](FieldKind kind) {
                return workpiece->field({}, {.options = {.kind = kind}}, progress);
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
    state.edge = session_ ? workpiece_->meanEdgeLength() : 0.0;
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
    pointer.removes = pointer.strokes = event.modifiers().testFlag(Qt::ShiftModifier);
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

// Of a curve that a list names, which may be one that a drag has just begun: it ends with the drag.
bool CurveTool::has(int curve) {
    if (session_) {
        session_->cancel();
    }
    return session_ && curve < static_cast<int>(session_->sketch().curves.size());
}

void CurveTool::setLook(int curve, const SketchLook& look) {
    if (!has(curve)) {
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
    if (has(curve)) {
        session_->select(curve);
        refresh();
    }
}

}  // namespace bspline_curve

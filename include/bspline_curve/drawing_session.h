// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "bspline_curve/mesh.h"
#include "bspline_curve/sketch.h"
#include "bspline_curve/workpiece.h"

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace bspline_curve {

/// Where the mouse is: the ray into the scene through its pixel, in the mesh's unit.
struct Pointer {
    Vec3 start = Vec3::Zero();
    Vec3 direction = -Vec3::UnitZ();  ///< unit length, away from the viewer
    /// The width of a pixel: at distance 1 from the start, or anywhere if the view is
    /// orthographic.
    double pixel = 1e-3;
    bool isOrthographic = false;
    bool snaps = false;    ///< the key that snaps picks to features is held
    bool removes = false;  ///< the key that turns clicks on picks into their removal is held
    bool strokes = false;  ///< the key that makes a drag a line drawn freehand is held

    [[nodiscard]] double pixelAt(double distance) const {
        return isOrthographic ? pixel : pixel * distance;
    }
};

/// Keys of the drawing session; hosts say which of theirs they are.
enum class SketchKey {
    Add,        ///< a pick where the pointer is, as a click does
    Move,       ///< the selected pick to where the pointer is, as a drag does
    Next,       ///< select the next pick, or the first
    Previous,   ///< select the pick before, or the last
    NextCurve,  ///< make the next curve the active one
    Remove,     ///< the selected pick, or the active curve where none is selected
    Close,      ///< close the active curve, or open it
    NewCurve,   ///< the next pick begins a curve
    Kind,       ///< the next PickKind of the selected pick
    Undo,
    Redo,
    Cancel,  ///< the drag that goes on; else the selection
};

/// Part of a sketch.
struct SketchHit {
    int curve = -1;  ///< -1: none
    int pick = -1;   ///< of that curve; -1: between picks
    int after = -1;  ///< between picks: the pick before
    int handle = 0;  ///< of the pick's direction: 1 the one ahead, -1 the one behind; 0: none

    [[nodiscard]] bool operator==(const SketchHit&) const = default;
};

/// How near the mouse must come, in pixels.
struct HitRadii {
    double pick = 9.0, curve = 6.0;
};

/// What picks snap to, besides what the mesh and the sketch show by themselves.
struct SnapOptions {
    double creaseAngle = 40.0;  ///< edges whose faces' normals differ by more are creases, degrees
    /// Fields of FieldKind::Ridge and FieldKind::Valley; empty: picks do not snap to these.
    ScalarField ridge, valley;
    /// Least value of a vertex on a ridge or in a valley: that of a cylinder whose radius is a
    /// tenth of the diagonal.
    double leastCrest = 0.5;
};

/// What a pick snapped to.
enum class SnapKind { None, Pick, Boundary, Crease, Ridge, Valley, Vertex };

/// For people: "a boundary", "a ridge", …; empty for None.
[[nodiscard]] const char* nameOf(SnapKind kind);

/// Where a pick snapped to.
struct Snap {
    SnapKind kind = SnapKind::None;
    SurfacePoint point;  ///< unchanged where nothing is near
};

/// How a session behaves.
struct SessionSettings {
    HitRadii radii{};
    SnapOptions snapping{};
    double snapPixels = 12.0;  ///< picks snap to what is within
    double dragPixels = 3.0;   ///< a press becomes a drag after so much
    /// The handles of the selected pick's direction are so far from it; 0: there are none, as where
    /// the host draws none.
    double handlePixels = 0.0;
    SketchCurveOptions options{};  ///< of new curves
    SketchColour colour{};         ///< likewise
    /// Called on a thread of the session's own when an answer waits for update(); may be empty.
    std::function<void()> wake{};
};

/// Drawing curves on a surface with a mouse, without a window: takes events, holds curves, picks,
/// what is hovered and selected, and a history, and solves curves beside. A host forwards its
/// events, calls update() before it draws, and draws what this says.
///
/// A click on the surface adds a pick to the active curve, or begins one, a click on the active
/// curve inserts one there, and each can be dragged at once, as can picks that are there. A click
/// on the first pick of an open curve closes it, one on another curve makes that the active one.
/// Each drag and each click is one entry of the history.
///
/// A selected pick with a direction has a handle on either side; to drag one turns the direction,
/// at a corner that of its side.
///
/// A drag with Pointer::strokes draws freehand: the line becomes a curve of few picks along it
/// (Workpiece::fit()), closed where it ends where it began. A line from a curve to the same
/// curve replaces the stretch between; picks outside of it stay.
///
/// While a pick is dragged the curve is solved from the one before (CurveInputs::start). When it is
/// let go the curve is solved from scratch, so that it is the one that a filter draws for the same
/// picks; undo and redo lead to the same curves again. All calls from one thread.
class DrawingSession {
public:
    /// On a workpiece, which this prepares where that was not done. Throws Cancelled.
    explicit DrawingSession(
        std::shared_ptr<const Workpiece> workpiece, SessionSettings settings = {}
    );
    ~DrawingSession();
    DrawingSession(const DrawingSession&) = delete;
    DrawingSession& operator=(const DrawingSession&) = delete;

    // ---- Events. Each returns whether the session took it; what it did not take is the camera's.

    bool press(const Pointer& pointer);
    bool move(const Pointer& pointer);
    bool release(const Pointer& pointer);
    /// The pointer left the view.
    void leave();
    bool key(SketchKey key, const Pointer& pointer);

    // ---- The same by calls. Picks and curves by index; std::out_of_range where there is no such.

    void addPick(const SurfacePoint& point);
    void insertPick(int after, const SurfacePoint& point);
    void movePick(int pick, const SurfacePoint& point);
    void removePick(int pick);
    /// Whether the curve may turn at a pick, see CurveInputs::corners. Where that changes, the pick
    /// loses its tangent.
    void setCorner(int pick, bool isCorner);
    /// The direction in which the curve passes a pick, see CurveInputs::tangents. A pick with the
    /// same on both sides is no corner, one with two is.
    void setTangent(int pick, const PickTangent& tangent);
    /// The same as one choice; PickKind::Aligned and PickKind::Free take the directions that the
    /// curve has there.
    void setKind(int pick, PickKind kind);
    void select(int curve, int pick = -1);
    void setClosed(bool closed);
    /// Of the active curve, where there is one, and of new ones. `isLive`: more of the same change
    /// is to come, as while a slider is moved; all of it is one entry of the history.
    void setOptions(const SketchCurveOptions& options, bool isLive = false);

    /// Of one curve, as one entry of the history; the curve stays as it is.
    void setLook(int curve, SketchLook look);

    /// Of new curves from now on.
    void setColour(SketchColour colour) { settings_.colour = colour; }

    /// What picks snap to from now on.
    void setSnapping(const SnapOptions& snapping) { settings_.snapping = snapping; }

    void newCurve();
    void removeCurve(int curve);
    void undo();
    void redo();
    void cancel();  ///< the drag that goes on

    // ---- What is to be seen.

    /// Takes the answers that are ready. Whether what is to be seen changed.
    bool update();

    [[nodiscard]] const Sketch& sketch() const { return sketch_; }

    [[nodiscard]] const SketchHit& hovered() const { return hovered_; }

    /// SessionSettings::handlePixels.
    [[nodiscard]] double handlePixels() const { return settings_.handlePixels; }

    /// Whether a drag goes on, of a pick or of a line.
    [[nodiscard]] bool isDragging() const {
        return mode_ == Mode::Dragging || mode_ == Mode::Stroking;
    }

    /// The line that is being drawn freehand; empty: none.
    [[nodiscard]] const std::vector<SketchPick>& stroke() const { return stroke_; }

    [[nodiscard]] bool canUndo() const { return history_.canUndo(); }

    [[nodiscard]] bool canRedo() const { return history_.canRedo(); }

    /// What the pick that is dragged, or that a click would add, snaps to.
    [[nodiscard]] const Snap& snapped() const { return snapped_; }

    /// The active curve with the point under the pointer as one more pick; null where there is
    /// none, or it is not known yet.
    [[nodiscard]] const std::shared_ptr<const Curve>& preview() const { return preview_; }

    /// Whether all curves of the sketch are solved, as far as they can be.
    [[nodiscard]] bool isSettled() const;

    [[nodiscard]] const Workpiece& workpiece() const { return *workpiece_; }

    /// Whether the surface hides a point that the pointer points at.
    [[nodiscard]] bool hides(const Pointer& pointer, const Vec3& point) const;
    /// The same of a pick, which is hidden as well where its face is seen from behind and another
    /// one is before it: the other side of a thin plate.
    [[nodiscard]] bool hides(const Pointer& pointer, const SketchPick& pick) const;

    /// Unit normal of a face as the mended mesh has it; zero where that does not have the face.
    [[nodiscard]] Vec3 normalAt(const SurfacePoint& point) const;

    /// Where the handle of a pick's direction is as the pointer's viewer sees it, `side`: 1 ahead,
    /// -1 behind. None where that side has no direction.
    [[nodiscard]] std::optional<Vec3> handle(
        const SketchPick& pick, int side, const Pointer& pointer
    ) const;

    /// Waits until all curves are settled, but for the one whose pick is being dragged.
    void settle();

    /// The same for a limited time; whether they are.
    [[nodiscard]] bool settleWithin(std::chrono::milliseconds time);

    // ---- Curves that were drawn before: picks, options and look of each.

    /// Goes on with these alone. They are where the history begins, so undo does not remove them.
    /// `active`: index of one of them; -1: none.
    void begin(std::vector<SketchCurve> curves, int active = -1);

    /// Adds them, as one entry of the history.
    void add(std::vector<SketchCurve> curves);

private:
    struct Seen;         // where the surface meets a ray
    struct Solver;       // what solves curves beside
    struct Answer;       // of it
    struct Request;      // to it
    struct Freehand;     // a line that was drawn so
    struct AskedStroke;  // whose curve is asked for

    enum class Mode { Idle, Pressed, Dragging, Stroking };
    enum class Asking { Live, Preview, Settled, Stroke };

    struct Asked {
        std::uint64_t id;
        Asking kind;
        std::shared_ptr<SketchCurve> curve;
    };

    [[nodiscard]] SketchPick pickAt(const SurfacePoint& point) const;
    /// Moves a pick, which stays what it is.
    void place(SketchPick& pick, const SurfacePoint& point) const;
    [[nodiscard]] Seen seenBy(const Pointer& pointer) const;
    /// The point under the pointer, snapped where that is asked for.
    SurfacePoint pointUnder(const Pointer& pointer, const Seen& seen);
    [[nodiscard]] bool hasMoved(const Pointer& pointer) const;

    bool staysWithoutDrag();

    // Lines drawn freehand.
    void beginStroke(const Pointer& pointer, const Seen& seen, const SketchHit& hit);
    void goOnWithStroke(const Seen& seen);
    void endStroke(const Pointer& pointer);
    void enterStroke(Freehand stroke);
    [[nodiscard]] Request fitRequest(const AskedStroke& asked, std::uint64_t id) const;
    [[nodiscard]] double tolerance(const AskedStroke& asked) const;  ///< user's unit
    void takeStroke(const Answer& answer, const std::shared_ptr<SketchCurve>& of);

    // Kinds of picks, and handles.
    bool changeKind();
    void setFree(int pick);
    [[nodiscard]] int handleUnder(const Pointer& pointer, const Seen& seen) const;
    bool pressHandle(const Pointer& pointer, const Seen& seen);
    void turn(const Pointer& pointer);

    // Of key().
    bool moveSelected(const Pointer& pointer);
    bool change(SketchKey key);
    bool selectNext(SketchKey key);
    bool selectNextCurve();

    /// A copy of a curve in its place, to be changed.
    SketchCurve& copied(int curve);
    /// The same of the active one, whose picks or options change.
    SketchCurve& changed();
    void append(SketchCurve curve);
    SketchCurve& begun();
    void insertBehind(int after, const SurfacePoint& point);
    void enter();  ///< ends a change: an entry of the history, and curves to be settled
    void settleNow();
    void askLive();
    void askPreview(const SurfacePoint& point);
    void askSettled();
    std::uint64_t ask(Asking kind, std::shared_ptr<SketchCurve> curve);
    void dropLive();
    [[nodiscard]] bool isSettling() const;
    [[nodiscard]] static bool isOfDrag(Asking kind);
    bool take(const Answer& answer);
    void show(const Sketch& state);
    void requireCurve(int curve) const;
    void requirePick(int pick) const;

    std::shared_ptr<const Workpiece> workpiece_;
    SessionSettings settings_;
    Sketch sketch_;
    SketchHistory history_;
    SketchHit hovered_;
    Snap snapped_;
    Mode mode_ = Mode::Idle;
    Vec3 pressedAt_ = Vec3::Zero();
    bool closesOnRelease_ = false;
    int turning_ = 0;            ///< the handle that is pressed or dragged, see SketchHit::handle
    bool isLiveChange_ = false;  ///< the newest entry of the history is not complete yet
    Pointer strokeStart_;
    int strokeFrom_ = -1;  ///< the curve where the line begins; -1: none
    double strokePixel_ = 0.0;
    std::vector<SketchPick> stroke_;  ///< while it is drawn
    std::vector<AskedStroke> strokes_;
    std::shared_ptr<const Curve> preview_;
    std::uint64_t lastId_ = 0;  // of requests
    std::uint64_t lastCurveId_ = 0;
    std::vector<Asked> asked_;
    std::unique_ptr<Solver> solver_;
};

}  // namespace bspline_curve

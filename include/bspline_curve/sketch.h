// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "bspline_curve/error.h"
#include "bspline_curve/field.h"
#include "bspline_curve/mesh.h"
#include "bspline_curve/options.h"
#include "bspline_curve/progress.h"
#include "bspline_curve/tangent.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace bspline_curve {

/// The field that curves follow and the faces that they avoid. A field takes seconds on a large
/// mesh, so it is made when a curve is first solved with it, and kept. Curves share it; several
/// threads may ask for it.
class SketchGuides {
public:
    struct Values {
        ScalarField field;
        std::vector<int> avoid;  ///< faces
    };

    using Maker = std::function<Values(const Progress&)>;

    explicit SketchGuides(Maker maker);
    explicit SketchGuides(Values values);

    /// Throws what the maker throws; an InputError again without asking it once more.
    [[nodiscard]] const Values& values(const Progress& progress = {}) const;

private:
    struct State;
    std::shared_ptr<State> state_;
};

/// How one curve of a sketch is drawn.
struct SketchCurveOptions {
    SolverOptions solver{};                      ///< `closed` too
    std::shared_ptr<const SketchGuides> guides;  ///< null: neither a field nor faces to avoid
};

struct SketchPick {
    SurfacePoint point;
    Vec3 position = Vec3::Zero();  ///< of the point, user's unit
    bool isCorner = false;         ///< see CurveInputs::corners
    PickTangent tangent{};         ///< see CurveInputs::tangents
};

/// How a curve passes a pick.
enum class PickKind {
    Automatic,  ///< smoothly, in the direction that is fairest
    Aligned,    ///< smoothly, in a direction of its own
    Corner,     ///< it may turn there
    Free        ///< a corner with directions of its own on either side
};

[[nodiscard]] inline PickKind kindOf(const SketchPick& pick) {
    if (pick.isCorner) {
        return pick.tangent.isAny() ? PickKind::Corner : PickKind::Free;
    }
    return pick.tangent.isAny() ? PickKind::Automatic : PickKind::Aligned;
}

/// Why a curve is not what its picks ask for.
struct SketchProblem {
    std::string message;     ///< one line, for people
    std::vector<int> picks;  ///< those concerned; all where it is not known which
    Remedy remedy{};         ///< what helps, which hosts say
};

/// Of sRGB.
struct SketchColour {
    std::uint8_t red = 225, green = 60, blue = 30;

    [[nodiscard]] bool operator==(const SketchColour&) const = default;
};

/// How a curve is named and shown: nothing of it moves the curve.
struct SketchLook {
    std::string name;
    SketchColour colour;
    bool isHidden = false;  ///< neither shown nor hit

    [[nodiscard]] bool operator==(const SketchLook&) const = default;
};

/// One curve: what was asked for, which does not change once others may see it, and what came of
/// it. A state of the sketch that undo brings back is the same object.
struct SketchCurve {
    std::uint64_t id = 0;  ///< the same in all states of the curve; 0: the session gives one
    SketchLook look;
    std::vector<SketchPick> picks;
    SketchCurveOptions options;
    /// The curve from scratch: it depends on picks and options alone, so it is the one that a
    /// filter draws. Null until it is solved, and where there is none.
    std::shared_ptr<const Curve> settled;
    bool isAnswered = false;  ///< whether that was tried
    SketchProblem problem;    ///< empty message: none known
    /// The last curve that was solved for these picks, or for those before the last changes, and
    /// its picks: what is shown meanwhile.
    std::shared_ptr<const Curve> last;
    std::vector<Vec3> lastPicks;

    /// Whether the picks are enough for a curve.
    [[nodiscard]] bool isDrawable() const {
        return picks.size() >= (options.solver.closed ? 3U : 2U);
    }

    [[nodiscard]] std::vector<Vec3> positions() const;
    /// Picks that are corners.
    [[nodiscard]] std::vector<int> corners() const;
    /// Of each pick, see CurveInputs::tangents; empty: no pick has any.
    [[nodiscard]] std::vector<PickTangent> tangents() const;

    /// The polyline to be shown: the settled one; else the last one, displaced with its picks where
    /// there are as many. Empty where there is none.
    [[nodiscard]] std::vector<Vec3> shownPoints() const;

    /// Whether there is nothing more to find out.
    [[nodiscard]] bool isSettled() const { return isAnswered || !isDrawable(); }

    /// Whether the same is asked for, so that the same comes of it.
    [[nodiscard]] bool asksForTheSame(const SketchCurve& other) const;
};

/// What a user has drawn. Copies share curves.
struct Sketch {
    std::vector<std::shared_ptr<SketchCurve>> curves;
    int active = -1;    ///< index of the curve that picks are added to; -1: none
    int selected = -1;  ///< index of a pick of the active curve; -1: none

    [[nodiscard]] SketchCurve* activeCurve() const {
        return active < 0 ? nullptr : curves[active].get();
    }

    [[nodiscard]] bool operator==(const Sketch&) const = default;  ///< the same curve objects
};

/// States of a sketch, for undo and redo: a list, and where in it we are.
class SketchHistory {
public:
    /// States kept at most; the oldest go first.
    static constexpr std::size_t kMostStates = 1000;

    /// Of this state alone.
    explicit SketchHistory(Sketch first = {}) : states_{std::move(first)} {}

    [[nodiscard]] const Sketch& now() const { return states_[position_]; }

    /// Drops what was undone. Nothing where the state is that of now.
    void add(const Sketch& state);

    /// Puts a state in the place of that of now.
    void replace(const Sketch& state) { states_[position_] = state; }

    [[nodiscard]] bool canUndo() const { return position_ > 0; }

    [[nodiscard]] bool canRedo() const { return position_ + 1 < states_.size(); }

    void undo() { position_ -= canUndo() ? 1 : 0; }

    void redo() { position_ += canRedo() ? 1 : 0; }

private:
    std::vector<Sketch> states_;
    std::size_t position_ = 0;
};

}  // namespace bspline_curve

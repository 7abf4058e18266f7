// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/imprint.h"
#include "bspline_curve/offset.h"
#include "bspline_curve/parts.h"
#include "fill/fill_holes.h"
#include "filters/option_bindings.h"
#include "filters/parameter_values.h"
#include "filters/polyline_layers.h"
#include "imprint/imprint.h"
#include "imprint/part_choice.h"
#include "offset/offset_curves.h"

#include <optional>
#include <string>

// What users ask for of the filters that use curves, as the libraries take it.
namespace bspline_curve {

/// What all of them take.
struct CurveUse {
    LayerId surface;
    LayerId curve;  ///< the surface itself, or no id: its curves, as the host knows them
    Placing placing;
    MendingOptions mending;
};

struct ImprintRequest {
    CurveUse use;
    ImprintOptions imprint;
};

/// What a cut leaves, as users name it.
enum class KeptParts { All, Largest, Smallest, Inside, Outside, Seeds };
enum class FillKind { None, Flat, Smooth };

struct CutWords {
    KeptParts keep = KeptParts::All;
    std::string seed;            ///< "x y z; x y z; ..."; empty: the points of the host's own tool
    bool dropUntouched = false;  ///< components that no curve parts
    FillKind fill = FillKind::None;
    bool split = false;   ///< where all are kept: a layer for each part
    double relief = 0.0;  ///< height that the parts to keep are moved by; 0: they are cut
    ReliefProfile profile = ReliefProfile::Step;
    double profileWidth = 0.0;
    double stroke = 0.0;     ///< width that the curves are drawn with, see strokesOn(); 0: none
    double thickness = 0.0;  ///< of the walls that parts become; 0: none
    /// Length of the base that parts become solids by; 0: none, or to `baseHeight` where a
    /// direction is given.
    double base = 0.0;
    std::string baseDirection{};  ///< "x y z"; empty: against the parts' mean normal
    double baseHeight = 0.0;      ///< of the plane along the direction

    /// Whether parts become solids on a base.
    [[nodiscard]] bool isBased() const { return base != 0.0 || !baseDirection.empty(); }
};

struct CutRequest {
    ImprintRequest imprint;
    CutWords words;
};

struct FillRequest {
    CurveUse use{};  ///< without curves
    FillShape shape = FillShape::Smooth;
    double mostLength = 0.0;  ///< 0: any
    int mostEdges = 0;        ///< 0: any
    std::string seed{};       ///< "x y z"; empty: all holes

    [[nodiscard]] HoleChoice choice() const;
};

struct SegmentRequest {
    ImprintRequest imprint;
    bool split = false;
};

struct OffsetRequest {
    CurveUse use;
    OffsetOptions offset;  ///< distance 0: kOffsetRelative
    bool selectBand = false;
};

struct PointsRequest {
    CurveUse use{};
    int count = 20;           ///< of each curve
    std::string distances{};  ///< in its place, in words; empty: not said
    bool atPicks = false;     ///< in its place
};

/// The distance of an offset if none is given, relative to the diagonal.
inline constexpr double kOffsetRelative = 0.02;

[[nodiscard]] Bindings<CurveUse> useBindings();
[[nodiscard]] Bindings<Placing> placingBindings();
[[nodiscard]] Bindings<ImprintOptions> imprintBindings();
[[nodiscard]] Bindings<CutWords> cutBindings();
[[nodiscard]] Bindings<FillRequest> fillBindings();
[[nodiscard]] Bindings<SegmentRequest> segmentBindings();
[[nodiscard]] Bindings<OffsetOptions> offsetBindings();
[[nodiscard]] Bindings<OffsetRequest> bandBindings();
[[nodiscard]] Bindings<PointsRequest> pointsBindings();

/// Throws InputError (BadOption): choices that exclude each other, or one that needs another.
[[noreturn]] void refuseChoice(const std::string& message);

/// What all filters that use curves take. Throws InputError (BadOption).
[[nodiscard]] CurveUse curveUse(const ParameterValues& values);

// Of imprintFilter(), cutFilter(), fillFilter(), segmentFilter(), offsetFilter() and
// pointsFilter(). Throw InputError (BadOption) naming the value and its range where a number is
// outside, or where two choices exclude each other.
[[nodiscard]] ImprintRequest imprintRequest(const ParameterValues& values);
[[nodiscard]] CutRequest cutRequest(const ParameterValues& values);
[[nodiscard]] FillRequest fillRequest(const ParameterValues& values);
[[nodiscard]] SegmentRequest segmentRequest(const ParameterValues& values);
[[nodiscard]] OffsetRequest offsetRequest(const ParameterValues& values);
[[nodiscard]] PointsRequest pointsRequest(const ParameterValues& values);

/// Distances along a curve, "0, 0.5, 1.2". Throws InputError (BadOption) naming what is no number.
[[nodiscard]] std::vector<double> parseDistances(const std::string& text);

/// What a cut leaves. `toolPoints`: of the host's own tool, in world coordinates. Throws InputError
/// where seeds are meant and there is none.
[[nodiscard]] CutChoice cutChoice(const CutWords& words, const std::vector<Vec3>& toolPoints);

}  // namespace bspline_curve

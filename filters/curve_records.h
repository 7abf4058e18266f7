// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "bspline_curve/mesh_checksum.h"
#include "filters/drawn_curve.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

// What files keep of curves, before a surface is at hand. In JSON, see docs/FILES.md.
namespace bspline_curve {

/// One curve: what it was drawn from, and what came of it. Faces are those of the mesh as it was
/// given.
struct CurveRecord {
    std::string name;  ///< UTF-8; empty: none
    std::optional<CurveColour> colour;
    bool closed = false;
    std::vector<SketchPick> picks;
    /// `closed` is that above. None: more was asked for than these can say.
    std::optional<DrawnOptions> options;
    std::shared_ptr<const Curve> curve;  ///< without its report; null: the picks had none
};

struct CurveRecords {
    std::optional<MeshChecksum> mesh;  ///< that the faces are of; none: not known
    std::vector<CurveRecord> curves;
    std::vector<std::string> notes{};  ///< of what was read: what is not as it was written
};

/// The record of a curve that was drawn.
[[nodiscard]] CurveRecord recordOf(const DrawnCurve& drawn, std::shared_ptr<const Curve> curve);

/// JSON, with a newline at its end: one curve as the document itself, several in "curves".
[[nodiscard]] std::string recordsText(const CurveRecords& records);

/// The same without polylines and splines, in ASCII and without blanks or line ends: for comments
/// of formats that hold the polylines themselves.
[[nodiscard]] std::string shortRecordsText(const CurveRecords& records);

/// What one of the two wrote, or writeCurve(): then picks are those of the polyline, and degree and
/// `closed` those of the spline. `file` is for messages. Throws InputError (UnreadableFile).
[[nodiscard]] CurveRecords recordsOf(const std::filesystem::path& file, std::string_view text);

}  // namespace bspline_curve

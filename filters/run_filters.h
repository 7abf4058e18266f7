// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "bspline_curve/progress.h"
#include "bspline_curve/shell.h"
#include "filters/figures.h"
#include "filters/pick_candidates.h"
#include "filters/requests.h"
#include "filters/workpiece_cache.h"

#include <exception>
#include <optional>
#include <string>
#include <vector>

// The filters, from arrays to arrays. Hosts convert, show and log.
namespace bspline_curve {

/// What a host is to write into its log: lines for scripts, and the same in words for people.
struct FilterLog {
    std::string figures;                      ///< one line "key=value key=value …"
    std::vector<std::string> table{};         ///< further lines of that kind, one for each part
    std::vector<std::string> warnings;        ///< whole sentences
    std::string summary{};                    ///< of `figures`: one or a few sentences
    std::vector<std::string> tableInWords{};  ///< of `table`
};

/// What a host writes, line by line.
struct LogLines {
    std::vector<std::string> lines, warnings;
};

/// For scripts: `figures` and `table`.
[[nodiscard]] LogLines scriptLog(const FilterLog& log);

/// For people in a window: `summary`, `tableInWords`, and the labels of the dialog in warnings.
[[nodiscard]] LogLines windowLog(const FilterLog& log, const FilterDescription& filter);

/// The control points of a spline in order, with segments between them.
struct ControlPolygon {
    std::vector<Vec3> points;
    bool closed = false;  ///< the last is joined to the first, which is not repeated
};

/// A curve, all in world coordinates; face ids and vertex ids are those of LayerInput.
struct CurveResult {
    Curve curve;
    std::vector<double> quality;  ///< of each vertex: the field or, where there is none, t
    bool followsField = false;
    // What the request asks for besides the curve.
    std::optional<TriangleMesh> tube;
    std::optional<ControlPolygon> controlPolygon;
    std::optional<ShellLayers> shellLayers;
    Figures figures;
    FilterLog log;
};

struct FieldResult {
    std::vector<double> values;  ///< one per vertex of LayerInput
    Figures figures;
    FilterLog log;
};

/// What is to be said of a layer that was mended, in sentences.
[[nodiscard]] std::vector<std::string> layerNotes(const Workpiece& workpiece);

/// Draws a curve, on a mended copy of a mesh that needs it, and writes the file that the request
/// names. `workpieces` keeps what the next curve on the same mesh can use again. Throws InputError,
/// Cancelled, std::bad_alloc; see describeFailure().
[[nodiscard]] CurveResult runCurveFilter(
    const LayerInput& layer,
    const PickCandidates& picks,
    const CurveRequest& request,
    WorkpieceCache& workpieces,
    const Progress& progress = {}
);

/// The result of that filter for a curve that was drawn already. Throws InputError
/// (UnwritableFile).
[[nodiscard]] CurveResult curveResult(
    DesignedCurve drawn, const WorkpieceCache::Found& found, const CurveRequest& request
);

/// Computes a field. Throws likewise.
[[nodiscard]] FieldResult runFieldFilter(
    const LayerInput& layer, const FieldLayerRequest& request, const Progress& progress = {}
);

/// What to tell the user about an exception of a filter. `what`: "curve", "field", "imprint" …
[[nodiscard]] std::string describeFailure(const char* what, const std::exception& error);

}  // namespace bspline_curve

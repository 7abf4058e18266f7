// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "filters/figures.h"
#include "filters/requests.h"
#include "imprint/mesh_parts.h"

#include <cstddef>
#include <string>
#include <vector>

// What the filters did, in one or a few sentences: FilterLog::summary. Lengths are in the unit of
// the mesh, numbers have at most four significant digits, choices have the labels of dialogs.
namespace bspline_curve {

/// What a curve does not know itself.
struct CurveCircumstances {
    bool followsField = false;
    bool isSurfaceKept = false;  ///< an earlier curve had prepared it
    double seconds = 0.0;
};

/// "Closed curve through 7 picks, 1.064 mesh units long, usable: its spline stays within 0.0012
/// mesh units of the surface. It follows the field "Ridges". Time: 0.21 s, on a surface that was
/// ready."
[[nodiscard]] std::string curveSummary(
    const Curve& curve, const CurveRequest& request, const CurveCircumstances& circumstances
);

/// "Field "Ridges" at 2503 vertices: from 0.02 to 0.98, 0.4 on average."
[[nodiscard]] std::string fieldSummary(
    FieldKind kind, std::size_t vertices, const Figures& figures
);

// Of the figures of each filter.

/// "2 curves imprinted, 1 of them projected: 40 new vertices, 36 divided faces, 1 crossing. 2
/// parts, with areas of 3.1 and 0.7 square mesh units. Time: 0.05 s."
[[nodiscard]] std::string imprintSummary(const Figures& figures);

/// The same of a cut, with the layers that it made and the holes that it filled.
[[nodiscard]] std::string cutSummary(const Figures& figures, std::size_t layers);

/// "2 holes filled, with 140 new faces. Time: 0.02 s."
[[nodiscard]] std::string fillSummary(const Figures& figures);

/// The same of a segmentation.
[[nodiscard]] std::string segmentSummary(const Figures& figures);

/// "Lines at 0.05 mesh units from 1 curve: 2 pieces, together 2.1 mesh units long, at that distance
/// to 2e-05 mesh units. Time: 0.3 s."
[[nodiscard]] std::string offsetSummary(const Figures& figures);

/// "20 points on 1 curve, 2.1 mesh units long. Time: 0.1 s."
[[nodiscard]] std::string pointsSummary(const Figures& figures);

/// "Curves along 3 boundaries, together 4.1 mesh units long, nowhere farther from them than 0.06
/// mesh units. 1 boundary is left out. Time: 0.2 s."
[[nodiscard]] std::string fitSummary(const Figures& figures);

/// "2 curves became 1, 3.2 mesh units long. Time: 0.1 s."
[[nodiscard]] std::string editSummary(const Figures& figures);

/// "Pattern of 24 curves, together 3.2 mesh units long, within 0.0001 mesh units of the drawing
/// (allowed: 0.0004). Lengths are 0.98 to 1.03 times those of the drawing. Time: 1.2 s."
[[nodiscard]] std::string patternSummary(const Figures& figures);

/// A line for each part: "Part 0: area 3.1 square mesh units, perimeter 7.2 mesh units, centroid
/// (0, 0.1, 0.5), 240 faces, Euler characteristic 1."
[[nodiscard]] std::vector<std::string> partTableInWords(const MeshParts& parts);

}  // namespace bspline_curve

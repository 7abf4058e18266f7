// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/run_edit.h"

#include "bspline_curve/error.h"
#include "bspline_curve/pieces.h"
#include "bspline_curve/spline.h"
#include "filters/summaries.h"
#include "surface/strict_line.h"
#include "utility/index_sets.h"
#include "utility/stopwatch.h"
#include "workpiece/workpiece_parts.h"

#include <algorithm>
#include <iterator>
#include <span>
#include <utility>

namespace bspline_curve {

namespace {

constexpr double kReadyToEditShare = 0.4;  // of the work, for progress only

Curve curveOfLine(PlacedCurve& placed) {
    if (placed.drawn) {
        return *placed.drawn;
    }
    Curve curve;
    curve.polyline = std::move(placed.line);
    curve.spline = polygonSpline(curve.polyline);
    curve.report.usable = true;
    return curve;
}

class CurveEditor {
public:
    CurveEditor(const Workpiece& workpiece, const EditRequest& request, const Progress& progress)
        : workpiece_(workpiece), request_(request), progress_(progress) {}

    [[nodiscard]] std::vector<EditResult::EditedCurve> edited(
        std::span<const EditResult::EditedCurve> curves
    ) const {
        if (request_.edit == CurveEdit::Join) {
            return {joined(curves)};
        }
        std::vector<EditResult::EditedCurve> made;
        for (std::size_t i = 0; i < curves.size(); ++i) {
            std::ranges::move(
                editedOne(curves[i], stepOf(progress_, i, curves.size())), std::back_inserter(made)
            );
        }
        return made;
    }

private:
    [[nodiscard]] EditResult::EditedCurve joined(
        std::span<const EditResult::EditedCurve> curves
    ) const {
        if (curves.size() < 2) {
            throw InputError(
                InputErrorCode::BadOption,
                "there is 1 curve, but two or more are joined: show their layers, and let "
                "curve_layer be the surface, which stands for all of them"
            );
        }
        EditResult::EditedCurve whole = curves.front();
        for (std::size_t i = 1; i < curves.size(); ++i) {
            whole.curve = joinedCurves(
                workpiece_,
                whole.curve,
                curves[i].curve,
                request_.join,
                stepOf(progress_, i - 1, curves.size() - 1)
            );
        }
        whole.label += " joined";
        return whole;
    }

    [[nodiscard]] std::vector<EditResult::EditedCurve> editedOne(
        const EditResult::EditedCurve& given, const Progress& progress
    ) const {
        const auto& [curve, label] = given;
        const std::vector<double>& at = request_.parameters;
        switch (request_.edit) {
            case CurveEdit::Reverse:
                return {{reversedCurve(curve), label + " turned round"}};
            case CurveEdit::Trim:
                return {{partOfCurve(workpiece_, curve, at.front(), at.back()), label + " part"}};
            case CurveEdit::Extend: {
                const double length = extension();
                const double atStart = request_.ends == CurveEnds::End ? 0.0 : length;
                const double atEnd = request_.ends == CurveEnds::Start ? 0.0 : length;
                return {
                    {extendedCurve(workpiece_, curve, atStart, atEnd, progress), label + " longer"}
                };
            }
            case CurveEdit::Split:
            case CurveEdit::Join:
                break;
        }
        std::vector<EditResult::EditedCurve> parts;
        for (Curve& part : partsOfCurve(workpiece_, curve, at)) {
            std::string name = label + " part ";
            name += std::to_string(parts.size() + 1);
            parts.push_back({std::move(part), std::move(name)});
        }
        return parts;
    }

    [[nodiscard]] double extension() const {
        return request_.extension > 0.0 ? request_.extension
                                        : kExtensionRelative * workpiece_.diagonal();
    }

    const Workpiece& workpiece_;
    const EditRequest& request_;
    const Progress& progress_;
};

}  // namespace

EditResult runEditFilter(
    const CurvesOnLayer& input,
    const EditRequest& request,
    WorkpieceCache& workpieces,
    const Progress& progress
) {
    Stopwatch watch;
    const WorkpieceCache::Found found = workpieces.ready(
        input.surface, {.mending = request.use.mending}, partOf(progress, 0.0, kReadyToEditShare)
    );
    PlacedCurves placed = placedCurves(surfaceOf(*found.workpiece), input, request.use.placing);
    EditResult result;
    std::vector<EditResult::EditedCurve> given;
    for (PlacedCurve& curve : placed.curves) {
        result.usedLayers.push_back(input.curves[curve.layer].id);
        given.push_back({curveOfLine(curve), curve.label});
    }
    sortUnique(result.usedLayers);
    const Progress rest = partOf(progress, kReadyToEditShare, 1.0);
    result.curves = CurveEditor(*found.workpiece, request, rest).edited(given);
    double length = 0.0;
    int unusable = 0;
    for (const EditResult::EditedCurve& each : result.curves) {
        length += lengthOf(each.curve.polyline);
        unusable += each.curve.report.usable ? 0 : 1;
    }
    result.figures = {
        {"curves", static_cast<int>(given.size())},
        {"projected_curves", placed.projected},
        {"new_curves", static_cast<int>(result.curves.size())},
        {"length", length},
        {"seconds", watch.lap()},
    };
    result.log.figures = keyValueText(result.figures);
    result.log.summary = editSummary(result.figures);
    result.log.warnings = layerNotes(*found.workpiece);
    std::ranges::move(
        placingWarnings(placed, input.surface), std::back_inserter(result.log.warnings)
    );
    if (unusable > 0) {
        result.log.warnings.emplace_back(
            "The spline of what was added is too far from the surface; the polyline is on it."
        );
    }
    return result;
}

}  // namespace bspline_curve

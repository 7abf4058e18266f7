// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/run_curve_uses.h"

#include "bspline_curve/curve.h"
#include "bspline_curve/error.h"
#include "bspline_curve/imprint.h"
#include "bspline_curve/lines.h"
#include "bspline_curve/offset.h"
#include "bspline_curve/parts.h"
#include "bspline_curve/progress.h"
#include "filters/summaries.h"
#include "text/sentences.h"
#include "utility/stopwatch.h"
#include "workpiece/workpiece_parts.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <memory>
#include <utility>

namespace bspline_curve {

namespace {

// Shares of the work, for progress only.
constexpr double kSurfaceShare = 0.4;
constexpr double kPlacedShare = 0.5;
constexpr double kPartsShare = 0.9;

int countOf(std::size_t count) {
    return static_cast<int>(count);
}

/// What all of these filters do first.
struct PlacedInput {
    std::shared_ptr<const Workpiece> workpiece;
    PlacedCurves placed;
    std::vector<std::string> warnings;

    [[nodiscard]] std::vector<SurfacePolyline> lines() const {
        std::vector<SurfacePolyline> lines;
        for (const PlacedCurve& curve : placed.curves) {
            lines.push_back(curve.line);
        }
        return lines;
    }
};

PlacedInput placedInput(const CurvesOnLayer& input, const CurveUse& use, const Progress& progress) {
    report(progress, 0.0, "surface");
    PlacedInput result;
    result.workpiece = workpieceOf(input.surface, {.mending = use.mending});
    report(progress, kSurfaceShare, "curves");
    result.placed = placedCurves(surfaceOf(*result.workpiece), input, use.placing);
    report(progress, kPlacedShare, "curves");
    result.warnings = layerNotes(*result.workpiece);
    std::ranges::move(
        placingWarnings(result.placed, input.surface), std::back_inserter(result.warnings)
    );
    return result;
}

struct Imprinted {
    Imprint imprint;
    Figures figures;
    std::vector<std::string> warnings;
};

Imprinted imprinted(
    const CurvesOnLayer& input,
    const ImprintRequest& request,
    const Progress& progress,
    double stroke = 0.0
) {
    PlacedInput placed = placedInput(input, request.use, progress);
    const std::vector<SurfacePolyline> lines = placed.lines();
    const Progress step = partOf(progress, kPlacedShare, kPartsShare);
    Imprinted result{
        .imprint = stroke > 0.0 ? strokesOn(*placed.workpiece, lines, stroke, request.imprint, step)
                                : imprintOn(*placed.workpiece, lines, request.imprint, step),
        .figures = {},
        .warnings = std::move(placed.warnings)
    };
    const ImprintedMesh& mesh = *result.imprint.mesh;
    result.figures = {
        {"curves", countOf(lines.size())},
        {"projected_curves", placed.placed.projected},
        {"vertices", countOf(mesh.mesh.vertices.size())},
        {"new_vertices", countOf(mesh.ownPlaces.size())},
        {"faces", countOf(mesh.mesh.faces.size())},
        {"divided_faces", mesh.dividedFaces},
        {"crossings", countOf(mesh.crossings.size())},
        {"largest_move", mesh.largestMove},
        {"parts", countOf(result.imprint.parts.parts.size())},
    };
    return result;
}

/// One list for each column of the table of parts.
void addPartFigures(const MeshParts& parts, Figures& figures) {
    std::vector<double> faces;
    std::vector<double> areas;
    std::vector<double> perimeters;
    std::vector<double> centroids;
    std::vector<double> eulers;
    for (const MeshPart& part : parts.parts) {
        faces.push_back(part.faces);
        areas.push_back(part.area);
        perimeters.push_back(part.perimeter);
        centroids.insert(centroids.end(), part.centroid.begin(), part.centroid.end());
        eulers.push_back(part.euler);
    }
    figures.push_back({"part_faces", std::move(faces)});
    figures.push_back({"part_areas", std::move(areas)});
    figures.push_back({"part_perimeters", std::move(perimeters)});
    figures.push_back({"part_centroids", std::move(centroids)});
    figures.push_back({"part_eulers", std::move(eulers)});
}

std::vector<std::string> partTable(const MeshParts& parts) {
    std::vector<std::string> lines;
    for (std::size_t i = 0; i < parts.parts.size(); ++i) {
        const MeshPart& part = parts.parts[i];
        lines.push_back(keyValueText({
            {"part", countOf(i)},
            {"faces", part.faces},
            {"area", part.area},
            {"perimeter", part.perimeter},
            {"centroid_x", part.centroid.x()},
            {"centroid_y", part.centroid.y()},
            {"centroid_z", part.centroid.z()},
            {"euler", part.euler},
        }));
    }
    return lines;
}

MeshesResult finished(
    Imprinted&& imprinted, std::vector<MeshLayer> layers, Stopwatch& watch, bool withTable = false
) {
    MeshesResult result;
    result.layers = std::move(layers);
    result.figures = std::move(imprinted.figures);
    result.figures.push_back({"seconds", watch.lap()});
    result.log.figures = keyValueText(result.figures);
    result.log.warnings = std::move(imprinted.warnings);
    if (withTable) {
        result.log.table = partTable(imprinted.imprint.parts);
        result.log.tableInWords = partTableInWords(imprinted.imprint.parts);
    }
    addPartFigures(imprinted.imprint.parts, result.figures);
    return result;
}

std::string partSuffix(const std::vector<int>& chosen) {
    return chosen.size() == 1 ? " part " + std::to_string(chosen.front()) : " rest";
}

}  // namespace

MeshesResult runImprintFilter(
    const CurvesOnLayer& input, const ImprintRequest& request, const Progress& progress
) {
    Stopwatch watch;
    Imprinted from = imprinted(input, request, progress);
    std::vector<MeshLayer> layers;
    layers.push_back({.suffix = " imprinted", .made = wholeMesh(from.imprint)});
    MeshesResult result = finished(std::move(from), std::move(layers), watch);
    result.log.summary = imprintSummary(result.figures);
    return result;
}

MeshesResult runCutFilter(
    const CurvesOnLayer& input,
    const std::vector<Vec3>& toolPoints,
    const CutRequest& request,
    const Progress& progress
) {
    Stopwatch watch;
    const CutChoice choice = cutChoice(request.words, toolPoints);
    Imprinted from = imprinted(input, request.imprint, progress, request.words.stroke);
    CutMeshes cut = cutOn(from.imprint, choice, partOf(progress, kPartsShare, 1.0));
    addSentences(from.warnings, cut.notes);
    std::vector<MeshLayer> layers;
    for (CutMeshes::Piece& piece : cut.pieces) {
        const std::string suffix = choice.relief != 0.0    ? " relief"
                                   : choice.keep           ? " part"
                                   : cut.pieces.size() > 1 ? partSuffix(piece.parts)
                                                           : " cut";
        layers.push_back({.suffix = suffix, .made = std::move(piece.mesh)});
    }
    from.figures.push_back({"doubled_vertices", cut.doubledVertices});
    from.figures.push_back({"filled_holes", cut.filledHoles});
    from.figures.push_back({"dropped_parts", countOf(cut.dropped.size())});
    MeshesResult result = finished(std::move(from), std::move(layers), watch);
    result.log.summary = cutSummary(result.figures, result.layers.size());
    return result;
}

MeshesResult runFillFilter(
    const CurvesOnLayer& input, const FillRequest& request, const Progress& progress
) {
    Stopwatch watch;
    report(progress, 0.0, "surface");
    const auto workpiece = workpieceOf(input.surface, {.mending = request.use.mending});
    const Imprint imprint =
        imprintOn(*workpiece, {}, {}, partOf(progress, kSurfaceShare, kPlacedShare));
    CutMeshes filled =
        holesFilled(imprint, request.choice(), request.shape, partOf(progress, kPlacedShare, 1.0));
    MeshesResult result;
    result.layers.push_back({.suffix = " filled", .made = std::move(filled.pieces.front().mesh)});
    const TriangleMesh& mesh = result.layers.front().made.mesh();
    result.figures = {
        {"filled_holes", filled.filledHoles},
        {"vertices", countOf(mesh.vertices.size())},
        {"faces", countOf(mesh.faces.size())},
        {"new_faces", countOf(mesh.faces.size() - input.surface.mesh.faces.size())},
        {"seconds", watch.lap()},
    };
    result.log.figures = keyValueText(result.figures);
    result.log.warnings = layerNotes(*workpiece);
    addSentences(result.log.warnings, filled.notes);
    result.log.summary = fillSummary(result.figures);
    return result;
}

MeshesResult runSegmentFilter(
    const CurvesOnLayer& input, const SegmentRequest& request, const Progress& progress
) {
    Stopwatch watch;
    Imprinted from = imprinted(input, request.imprint, progress);
    CutMeshes segments = segmentsOf(from.imprint, request.split);
    addSentences(from.warnings, segments.notes);
    std::vector<MeshLayer> layers;
    for (CutMeshes::Piece& piece : segments.pieces) {
        layers.push_back(
            {.suffix = request.split ? partSuffix(piece.parts) : " segmented",
             .made = std::move(piece.mesh),
             .showsParts = true}
        );
    }
    MeshesResult result = finished(std::move(from), std::move(layers), watch, true);
    result.log.summary = segmentSummary(result.figures);
    return result;
}

OffsetResult runOffsetFilter(
    const CurvesOnLayer& input, const OffsetRequest& request, const Progress& progress
) {
    Stopwatch watch;
    PlacedInput placed = placedInput(input, request.use, progress);
    const std::vector<PlacedCurve>& curves = placed.placed.curves;
    OffsetOptions options = request.offset;
    if (options.distance == 0.0) {
        options.distance = kOffsetRelative * placed.workpiece->diagonal();
    }
    OffsetLines lines = linesBeside(
        *placed.workpiece,
        placed.lines(),
        options,
        request.selectBand,
        partOf(progress, kPlacedShare, 1.0)
    );
    for (std::size_t i = 0; i < curves.size(); ++i) {
        if (!lines.hasBeside(i)) {
            throw InputError(
                InputErrorCode::NoPath, "layer \"" + curves[i].label + "\": " + kNothingBeside
            );
        }
    }
    OffsetResult result;
    result.band = std::move(lines.band);
    double length = 0.0;
    double deviation = 0.0;
    for (auto& [fitted, curve] : lines.pieces) {
        length += lengthOf(fitted.line);
        deviation = std::max(deviation, fitted.deviation);
        result.pieces.push_back({.line = std::move(fitted.line), .curve = curves[curve].label});
    }
    result.figures = {
        {"curves", countOf(curves.size())},
        {"projected_curves", placed.placed.projected},
        {"offset", options.distance},
        {"pieces", countOf(result.pieces.size())},
        {"length", length},
        {"largest_deviation", deviation},
        {"seconds", watch.lap()},
    };
    result.log = {
        .figures = keyValueText(result.figures),
        .warnings = std::move(placed.warnings),
        .summary = offsetSummary(result.figures)
    };
    return result;
}

namespace {

std::vector<double> distancesAlong(const PlacedCurve& curve, const PointsRequest& request) {
    std::vector<double> given = parseDistances(request.distances);
    if (!given.empty()) {
        return given;
    }
    if (request.atPicks) {
        if (curve.line.picks.empty()) {
            refuseChoice(
                "layer \"" + curve.label +
                "\" keeps no picks: it is no curve of this plugin, or was changed; give the "
                "option count"
            );
        }
        return distancesOfPicks(curve.line);
    }
    if (request.count == 1 && !curve.line.closed) {
        refuseChoice(
            "count is 1, but layer \"" + curve.label + "\" is an open curve: 2 points are its ends"
        );
    }
    return evenDistances(curve.line, request.count);
}

}  // namespace

PointsResult runPointsFilter(
    const CurvesOnLayer& input, const PointsRequest& request, const Progress& progress
) {
    Stopwatch watch;
    PlacedInput placed = placedInput(input, request.use, progress);
    const std::vector<PlacedCurve>& curves = placed.placed.curves;
    const CurvePoints along(placed.workpiece->mesh());
    PointsResult result;
    double length = 0.0;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        const PlacedCurve& curve = curves[i];
        const std::vector<CurvePoint> points =
            along.at(curve.line, curve.spline, distancesAlong(curve, request));
        std::ranges::copy(points, std::back_inserter(result.points));
        result.curveOf.insert(result.curveOf.end(), points.size(), static_cast<int>(i));
        length += lengthOf(curve.line);
    }
    result.figures = {
        {"curves", countOf(curves.size())},
        {"projected_curves", placed.placed.projected},
        {"points", countOf(result.points.size())},
        {"length", length},
        {"seconds", watch.lap()},
    };
    result.log = {
        .figures = keyValueText(result.figures),
        .warnings = std::move(placed.warnings),
        .summary = pointsSummary(result.figures)
    };
    return result;
}

}  // namespace bspline_curve

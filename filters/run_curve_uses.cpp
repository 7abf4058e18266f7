// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/run_curve_uses.h"

#include "bspline_curve/error.h"
#include "bspline_curve/shell.h"
#include "design/curve_on_given_mesh.h"
#include "design/strict_polyline.h"
#include "fill/raised_parts.h"
#include "filters/curve_notes.h"
#include "filters/mended_layer.h"
#include "filters/summaries.h"
#include "imprint/mesh_parts.h"
#include "imprint/part_choice.h"
#include "imprint/slits.h"
#include "shell/extended_surface.h"
#include "utility/report_progress.h"
#include "utility/stopwatch.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <memory>
#include <optional>
#include <utility>

namespace bspline_curve {

namespace {

// Shares of the work, for progress only.
constexpr double kSurfaceShare = 0.4;
constexpr double kPlacedShare = 0.5;
constexpr double kImprintedShare = 0.8;
constexpr double kPartsShare = 0.9;
constexpr double kLinesShare = 0.8;  // of an offset, without its band

int countOf(std::size_t count) {
    return static_cast<int>(count);
}

/// What all of these filters do first.
struct PlacedInput {
    MendedSurface on;
    PlacedCurves placed;
    std::vector<std::string> warnings;

    [[nodiscard]] const Surface& surface() const { return *on.surface; }
};

PlacedInput placedInput(const CurvesOnLayer& input, const CurveUse& use, const Progress& progress) {
    report(progress, 0.0, "surface");
    PlacedInput result;
    result.on = surfaceOf(input.surface, use.mending);
    report(progress, kSurfaceShare, "curves");
    result.placed = placedCurves(result.surface(), result.on.repair(), input, use.placing);
    report(progress, kPlacedShare, "curves");
    if (result.on.mending) {
        result.warnings.push_back(describeMending(*result.on.mending));
    }
    std::ranges::move(
        leftOutWarnings(result.placed, input.surface), std::back_inserter(result.warnings)
    );
    return result;
}

struct Imprinted {
    PlacedInput input;
    std::shared_ptr<const ImprintedMesh> imprint;
    MeshParts parts;
    Figures figures;
    std::vector<std::string> warnings;
};

Imprinted imprinted(
    const CurvesOnLayer& input, const ImprintRequest& request, const Progress& progress
) {
    Imprinted result;
    result.input = placedInput(input, request.use, progress);
    const PlacedCurves& placed = result.input.placed;
    std::vector<SurfacePolyline> lines;
    for (const PlacedCurve& curve : placed.curves) {
        lines.push_back(curve.line);
    }
    result.imprint = std::make_shared<const ImprintedMesh>(
        imprint(result.input.surface(), lines, request.imprint)
    );
    report(progress, kImprintedShare, "parts");
    result.parts = partsOf(*result.imprint);
    report(progress, kPartsShare, "layers");
    result.warnings = std::move(result.input.warnings);
    const ImprintedMesh& mesh = *result.imprint;
    result.figures = {
        {"curves", countOf(placed.curves.size())},
        {"projected_curves", placed.projected},
        {"vertices", countOf(mesh.mesh.vertices.size())},
        {"new_vertices", countOf(mesh.newVertices.size())},
        {"faces", countOf(mesh.mesh.faces.size())},
        {"divided_faces", mesh.dividedFaces},
        {"crossings", countOf(mesh.crossings.size())},
        {"largest_move", mesh.largestMove},
        {"parts", countOf(result.parts.parts.size())},
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
    Imprinted&& imprinted, std::vector<MeshLayer> layers, Stopwatch& watch, bool withTable
) {
    MeshesResult result;
    result.layers = std::move(layers);
    result.figures = std::move(imprinted.figures);
    result.figures.push_back({"seconds", watch.lap()});
    result.log.figures = keyValueText(result.figures);
    result.log.warnings = std::move(imprinted.warnings);
    if (withTable) {
        result.log.table = partTable(imprinted.parts);
        result.log.tableInWords = partTableInWords(imprinted.parts);
    }
    addPartFigures(imprinted.parts, result.figures);
    return result;
}

std::string partSuffix(const std::vector<int>& chosen) {
    return chosen.size() == 1 ? " part " + std::to_string(chosen.front()) : " rest";
}

/// Adds a warning where curves part nothing.
void warnOfSlits(Imprinted& from, bool isCut) {
    const std::string note = describeSlits(slitsOf(*from.imprint, from.parts), isCut);
    if (!note.empty()) {
        from.warnings.push_back(asSentence(note));
    }
}

MeshLayer layerOf(
    const Imprinted& from, std::string suffix, FilledParts taken, bool showsParts = false
) {
    return {
        .suffix = std::move(suffix),
        .made = MadeMesh(from.input.on, from.imprint, std::move(taken)),
        .showsParts = showsParts
    };
}

}  // namespace

MeshesResult runImprintFilter(
    const CurvesOnLayer& input, const ImprintRequest& request, const Progress& progress
) {
    Stopwatch watch;
    Imprinted from = imprinted(input, request, progress);
    std::vector<MeshLayer> layers;
    layers.push_back(layerOf(from, " imprinted", wholeImprint(*from.imprint, from.parts)));
    MeshesResult result = finished(std::move(from), std::move(layers), watch, false);
    result.log.summary = imprintSummary(result.figures);
    return result;
}

namespace {

/// The parts that one layer gets; adds warnings.
FilledParts partsOfLayer(
    Imprinted& from,
    const CutMesh& cut,
    const CutChoice& choice,
    const std::vector<int>& chosen,
    const Progress& progress
) {
    if (choice.relief == 0.0) {
        return takenParts(*from.imprint, cut, from.parts, chosen, fillShape(choice.fill), progress);
    }
    RaisedParts raised = raisedParts(*from.imprint, from.parts, chosen, choice.relief);
    if (raised.turnedFaces > 0) {
        from.warnings.push_back(
            "The relief turns " + std::to_string(raised.turnedFaces) +
            " faces over; take a smaller height."
        );
    }
    return std::move(raised.whole);
}

}  // namespace

MeshesResult runCutFilter(
    const CurvesOnLayer& input,
    const std::vector<Vec3>& toolPoints,
    const CutRequest& request,
    const Progress& progress
) {
    Stopwatch watch;
    const std::optional<PartChoice> choice = partChoice(request.choice, toolPoints);
    Imprinted from = imprinted(input, request.imprint, progress);
    const CutMesh cut = openedAlongCurves(*from.imprint);
    const std::size_t doubled = cut.mesh.vertices.size() - from.imprint->mesh.vertices.size();
    std::vector<MeshLayer> layers;
    int filledHoles = 0;
    const std::vector<std::vector<int>> chosenParts =
        partsPerMesh(*from.imprint, from.parts, choice, request.choice.split);
    const Progress taking = partOf(progress, kPartsShare, 1.0);
    for (const std::vector<int>& chosen : chosenParts) {
        const Progress step = stepOf(taking, layers.size(), chosenParts.size());
        FilledParts taken = partsOfLayer(from, cut, request.choice, chosen, step);
        filledHoles += countOf(taken.rims.size());
        if (taken.openRims > 0) {
            from.warnings.push_back(
                std::to_string(taken.openRims) +
                " rims stay open, since the boundary of the mesh is part of them."
            );
        }
        const std::string suffix = request.choice.relief != 0.0 ? " relief"
                                   : choice                     ? " part"
                                   : chosenParts.size() > 1     ? partSuffix(chosen)
                                                                : " cut";
        layers.push_back(layerOf(from, suffix, std::move(taken)));
    }
    warnOfSlits(from, !choice);
    from.figures.push_back({"doubled_vertices", countOf(doubled)});
    from.figures.push_back({"filled_holes", filledHoles});
    MeshesResult result = finished(std::move(from), std::move(layers), watch, false);
    result.log.summary = cutSummary(result.figures, result.layers.size());
    return result;
}

MeshesResult runSegmentFilter(
    const CurvesOnLayer& input, const SegmentRequest& request, const Progress& progress
) {
    Stopwatch watch;
    Imprinted from = imprinted(input, request.imprint, progress);
    if (partedParts(*from.imprint, from.parts).empty()) {
        refuseNothingParted();
    }
    warnOfSlits(from, false);
    std::vector<MeshLayer> layers;
    if (request.split) {
        const CutMesh cut = cutAlongCurves(*from.imprint);
        for (const std::vector<int>& chosen :
             partsPerMesh(*from.imprint, from.parts, std::nullopt, true)) {
            layers.push_back(
                layerOf(from, partSuffix(chosen), openParts(cut, from.parts, chosen), true)
            );
        }
    } else {
        layers.push_back(
            layerOf(from, " segmented", wholeImprint(*from.imprint, from.parts), true)
        );
    }
    MeshesResult result = finished(std::move(from), std::move(layers), watch, true);
    result.log.summary = segmentSummary(result.figures);
    return result;
}

namespace {

/// The lines beside a curve; refuses where there is none.
std::vector<FittedLine> linesBeside(
    const Surface& surface,
    const ExtendedSurface& extended,
    const PlacedCurve& curve,
    const OffsetOptions& options,
    const Progress& progress
) {
    std::vector<FittedLine> lines = offsetCurves(surface, extended, curve.line, options, progress);
    if (lines.empty()) {
        throw InputError(
            InputErrorCode::NoPath,
            "layer \"" + curve.label +
                "\": no point of the surface on that side is at this distance from the curve; "
                "give a smaller offset"
        );
    }
    return lines;
}

void addBand(
    const Surface& surface,
    const PlacedCurve& curve,
    const OffsetOptions& options,
    const Progress& progress,
    std::vector<char>& band
) {
    const std::vector<char> within = facesWithin(surface, curve.line, options, progress);
    band.resize(within.size(), 0);
    for (std::size_t f = 0; f < within.size(); ++f) {
        band[f] = static_cast<char>(band[f] | within[f]);
    }
}

}  // namespace

OffsetResult runOffsetFilter(
    const CurvesOnLayer& input, const OffsetRequest& request, const Progress& progress
) {
    Stopwatch watch;
    PlacedInput placed = placedInput(input, request.use, progress);
    const Surface& surface = placed.surface();
    OffsetOptions options = request.offset;
    if (options.distance == 0.0) {
        options.distance = kOffsetRelative * surface.diagonal();
    }
    OffsetResult result;
    double length = 0.0;
    double deviation = 0.0;
    const ExtendedSurface extended = extendSurface(surface, ShellOptions().smoothingPasses);
    const Progress drawing = partOf(progress, kPlacedShare, 1.0);
    const std::vector<PlacedCurve>& curves = placed.placed.curves;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        const PlacedCurve& curve = curves[i];
        const Progress step = stepOf(drawing, i, curves.size());
        for (FittedLine& fitted :
             linesBeside(surface, extended, curve, options, partOf(step, 0.0, kLinesShare))) {
            length += lengthOf(fitted.line);
            deviation = std::max(deviation, fitted.deviation);
            bringBack(fitted.line, placed.on.repair());
            result.pieces.push_back({.line = std::move(fitted.line), .curve = curve.label});
        }
        if (request.selectBand) {
            addBand(surface, curve, options, partOf(step, kLinesShare, 1.0), result.band);
        }
    }
    result.band =
        flagsOfGiven(std::move(result.band), input.surface.mesh.faces.size(), placed.on.repair());
    result.figures = {
        {"curves", countOf(placed.placed.curves.size())},
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

}  // namespace bspline_curve

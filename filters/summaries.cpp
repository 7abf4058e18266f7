// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/summaries.h"

#include "bspline_curve/curve.h"
#include "filters/filter_description.h"
#include "text/error_messages.h"

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string_view>
#include <variant>

namespace bspline_curve {

namespace {

const Figure& figureCalled(const Figures& figures, std::string_view figureName) {
    const auto found = std::ranges::find(figures, figureName, &Figure::name);
    if (found == figures.end()) {
        throw std::logic_error("no figure " + std::string(figureName));
    }
    return *found;
}

int countIn(const Figures& figures, std::string_view figureName) {
    return std::get<int>(figureCalled(figures, figureName).value);
}

double numberIn(const Figures& figures, std::string_view figureName) {
    return std::get<double>(figureCalled(figures, figureName).value);
}

std::string counted(int count, const char* one, const char* many) {
    return describeCount(static_cast<std::size_t>(count), one, many);
}

std::string lengthIn(const Figures& figures, std::string_view figureName) {
    return describeLength(numberIn(figures, figureName));
}

std::string describeTime(double seconds) {
    return " Time: " + describeNumber(seconds) + " s";
}

std::string timeIn(const Figures& figures) {
    return describeTime(numberIn(figures, "seconds")) + ".";
}

std::string describeField(FieldKind kind) {
    const std::vector<EnumOption>& kinds = curveFilter().parameter("field").options;
    const auto found = std::ranges::find(kinds, name(kind), &EnumOption::id);
    return "\"" + (found == kinds.end() ? name(kind) : found->label) + "\"";
}

/// "3.1 and 0.7", "3.1, 0.7, 0.5 and 12 smaller ones"
std::string firstOf(const std::vector<double>& areas) {
    constexpr std::size_t kNamedAreas = 5;
    const std::size_t named = std::min(areas.size(), kNamedAreas);
    std::string text;
    for (std::size_t i = 0; i < named; ++i) {
        const bool isLast = i + 1 == areas.size();
        text += i == 0 ? "" : isLast ? " and " : ", ";
        text += describeNumber(areas[i]);
    }
    return named < areas.size()
               ? text + " and " + std::to_string(areas.size() - named) + " smaller ones"
               : text;
}

/// "2 curves cut, 1 of them projected: …. 2 parts, with areas of …." `done`: "cut".
std::string imprintedSentences(const Figures& figures, const std::string& done) {
    std::string text = counted(countIn(figures, "curves"), "curve ", "curves ") + done;
    if (const int projected = countIn(figures, "projected_curves"); projected > 0) {
        text += ", " + std::to_string(projected) + " of them projected";
    }
    text += ": " + counted(countIn(figures, "new_vertices"), "new vertex", "new vertices") + ", " +
            counted(countIn(figures, "divided_faces"), "divided face", "divided faces") + ", " +
            counted(countIn(figures, "crossings"), "crossing", "crossings") + ". ";
    auto areas = std::get<std::vector<double>>(figureCalled(figures, "part_areas").value);
    std::ranges::sort(areas, std::greater<>());
    return text +
           counted(countIn(figures, "parts"), "part, with an area of ", "parts, with areas of ") +
           firstOf(areas) + " square mesh units.";
}

}  // namespace

std::string curveSummary(
    const Curve& curve, const CurveRequest& request, const CurveCircumstances& circumstances
) {
    const SolveReport& report = curve.report;
    std::string text = curve.polyline.closed ? "Closed curve through " : "Open curve through ";
    text +=
        describeCount(curve.polyline.picks.size(), "pick", "picks") + ", " +
        describeLength(lengthOf(curve.polyline)) + " long, " +
        (report.usable ? "usable: its spline stays within " : "not usable: its spline is up to ") +
        describeLength(report.maxDistance * report.meanEdgeLength) +
        (report.usable ? " of the surface." : " from the surface.");
    if (!report.pickDistances.empty()) {
        text += " It passes the picks within " +
                describeLength(std::ranges::max(report.pickDistances)) + ".";
    }
    if (circumstances.followsField && request.field) {
        text += " It follows the field " + describeField(request.field->options.kind) + ".";
    }
    if (report.avoidedFaces > 0) {
        text += " It stays " + describeLength(report.clearance) + " from the " +
                counted(report.avoidedFaces, "face", "faces") + " to avoid.";
    }
    return text + describeTime(circumstances.seconds) +
           (circumstances.isSurfaceKept ? ", on a surface that was ready." : ".");
}

std::string fieldSummary(FieldKind kind, std::size_t vertices, const Figures& figures) {
    return "Field " + describeField(kind) + " at " + describeCount(vertices, "vertex", "vertices") +
           ": from " + describeNumber(numberIn(figures, "minimum")) + " to " +
           describeNumber(numberIn(figures, "maximum")) + ", " +
           describeNumber(numberIn(figures, "mean")) + " on average.";
}

std::string imprintSummary(const Figures& figures) {
    return imprintedSentences(figures, "imprinted") + timeIn(figures);
}

std::string cutSummary(const Figures& figures, std::size_t layers) {
    std::string text =
        imprintedSentences(figures, "cut") + " " + describeCount(layers, "new layer", "new layers");
    if (const int holes = countIn(figures, "filled_holes"); holes > 0) {
        text += ", " + counted(holes, "hole", "holes") + " filled";
    }
    return text + "." + timeIn(figures);
}

std::string fillSummary(const Figures& figures) {
    return counted(countIn(figures, "filled_holes"), "hole", "holes") + " filled, with " +
           counted(countIn(figures, "new_faces"), "new face", "new faces") + "." + timeIn(figures);
}

std::string segmentSummary(const Figures& figures) {
    return imprintedSentences(figures, "imprinted") + timeIn(figures);
}

std::string offsetSummary(const Figures& figures) {
    return "Lines at " + lengthIn(figures, "offset") + " from " +
           counted(countIn(figures, "curves"), "curve", "curves") + ": " +
           counted(countIn(figures, "pieces"), "piece", "pieces") + ", together " +
           lengthIn(figures, "length") + " long, at that distance to " +
           lengthIn(figures, "largest_deviation") + "." + timeIn(figures);
}

std::string pointsSummary(const Figures& figures) {
    const int curves = countIn(figures, "curves");
    return counted(countIn(figures, "points"), "point", "points") + " on " +
           counted(curves, "curve", "curves") + ", " + (curves == 1 ? "" : "together ") +
           lengthIn(figures, "length") + " long." + timeIn(figures);
}

std::string fitSummary(const Figures& figures) {
    std::string text =
        "Curves along " + counted(countIn(figures, "curves"), "boundary", "boundaries") +
        ", together " + lengthIn(figures, "length") + " long, nowhere farther from them than " +
        lengthIn(figures, "largest_deviation") + ".";
    if (const int corners = countIn(figures, "corners"); corners > 0) {
        text += " They have " + counted(corners, "corner", "corners") + ".";
    }
    if (const int left = countIn(figures, "left_out"); left > 0) {
        text += " " + counted(left, "boundary is", "boundaries are") + " left out.";
    }
    return text + timeIn(figures);
}

std::string editSummary(const Figures& figures) {
    std::string text = counted(countIn(figures, "curves"), "curve", "curves");
    if (const int projected = countIn(figures, "projected_curves"); projected > 0) {
        text += ", " + std::to_string(projected) + " of them projected,";
    }
    const int made = countIn(figures, "new_curves");
    return text + " became " + std::to_string(made) + (made > 1 ? ", together " : ", ") +
           lengthIn(figures, "length") + " long." + timeIn(figures);
}

std::string patternSummary(const Figures& figures) {
    return "Pattern of " + counted(countIn(figures, "curves"), "curve", "curves") + ", together " +
           lengthIn(figures, "length") + " long, within " + lengthIn(figures, "largest_deviation") +
           " of the drawing (allowed: " + describeNumber(numberIn(figures, "tolerance")) +
           "). Lengths are " + describeNumber(numberIn(figures, "shortest_ratio")) + " to " +
           describeNumber(numberIn(figures, "longest_ratio")) + " times those of the drawing." +
           timeIn(figures);
}

std::vector<std::string> partTableInWords(const MeshParts& parts) {
    std::vector<std::string> lines;
    for (std::size_t i = 0; i < parts.parts.size(); ++i) {
        const MeshPart& part = parts.parts[i];
        lines.push_back(
            "Part " + std::to_string(i) + ": area " + describeNumber(part.area) +
            " square mesh units, perimeter " + describeLength(part.perimeter) + ", centroid (" +
            describeNumber(part.centroid.x()) + ", " + describeNumber(part.centroid.y()) + ", " +
            describeNumber(part.centroid.z()) + "), " + counted(part.faces, "face", "faces") +
            ", Euler characteristic " + std::to_string(part.euler) + "."
        );
    }
    return lines;
}

}  // namespace bspline_curve

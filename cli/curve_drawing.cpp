// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/curve_drawing.h"

#include "bspline_curve/error.h"
#include "bspline_curve/files.h"
#include "cli/value_checks.h"
#include "surface/error_messages.h"
#include "surface/triangle_tree.h"
#include "workpiece/workpiece_parts.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace bspline_curve::cli {

namespace {

void checkIsFile(std::string_view option, const std::filesystem::path& word) {
    if (word.empty() || std::filesystem::exists(word)) {
        return;
    }
    const std::vector<std::string> words = curveFilter().parameter(option).optionIds(false);
    throw InputError(
        InputErrorCode::UnreadableFile,
        flagOf(option) + " " + word.string() + ": there is no such file, and it is none of " +
            joined(words) + didYouMean(word.string(), words)
    );
}

/// Picks on the surface, nearest to where they are given. Throws InputError (PickTooFar).
std::vector<Vec3> movedOnto(
    const Surface& surface, const std::vector<Vec3>& picks, double distance
) {
    const TriangleTree tree(surface.vertices(), surface.faces());
    std::vector<Vec3> moved;
    for (std::size_t i = 0; i < picks.size(); ++i) {
        const auto nearest = tree.closestPoint(picks[i]);
        const double away = std::sqrt(nearest.squaredDistance);
        if (!(away <= distance)) {
            throw InputError(
                InputErrorCode::PickTooFar,
                describePicks({static_cast<std::int64_t>(i)}) + " lies " + describeNumber(away) +
                    " from the mesh, more than --pick-distance allows (" +
                    describeNumber(distance) + ")",
                {static_cast<std::int64_t>(i)}
            );
        }
        moved.push_back(nearest.position);
    }
    return moved;
}

}  // namespace

void checkDrawingFiles(const DrawingArguments& arguments) {
    checkIsFile("field", arguments.values);
    checkIsFile("avoid", arguments.avoided);
}

void readDrawingFiles(DrawingArguments& arguments, const TriangleMesh& mesh) {
    if (arguments.field && !arguments.values.empty()) {
        arguments.field->values = readField(arguments.values, mesh.vertices.size());
    }
    if (arguments.field && !arguments.region.empty()) {
        arguments.field->region.ids = regionOf(arguments.region, mesh);
    }
    if (!arguments.avoided.empty()) {
        arguments.avoid.ids = regionOf(arguments.avoided, mesh);
    }
}

std::vector<Vec3> picksFrom(const std::filesystem::path& file, DrawingArguments& arguments) {
    PicksFile picks = readPicks(file);
    arguments.solver.closed = arguments.solver.closed || picks.closed.value_or(false);
    if (arguments.corners == PickChoice()) {
        arguments.corners.ids = std::move(picks.corners);
    }
    if (arguments.tangents.entries.empty()) {
        arguments.tangents = std::move(picks.tangents);
    }
    return std::move(picks.picks);
}

DesignedCurve drawThrough(
    const std::vector<Vec3>& picks,
    const DrawingArguments& arguments,
    const LoadedMesh& loaded,
    const Progress& progress
) {
    const std::vector<Vec3> moved =
        arguments.pickDistance > 0.0
            ? movedOnto(surfaceOf(*loaded.workpiece), picks, arguments.pickDistance)
            : picks;
    DesignedCurve drawn = loaded.workpiece->draw(moved, arguments, loaded.layer, progress);
    if (arguments.field && arguments.field->automatic && !drawn.field.empty()) {
        drawn.notes.insert(
            drawn.notes.begin(),
            "the curve follows the quality of " + arguments.mesh.filename().string()
        );
    }
    return drawn;
}

}  // namespace bspline_curve::cli

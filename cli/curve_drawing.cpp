// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/curve_drawing.h"

#include "bspline_curve/error.h"
#include "bspline_curve/files.h"
#include "cli/value_checks.h"
#include "text/error_messages.h"

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
    if (arguments.pickTolerances.entries.empty() &&
        arguments.solver.pickTolerance == MeshLength()) {
        arguments.pickTolerances = std::move(picks.tolerances);
    }
    return std::move(picks.picks);
}

DesignedCurve drawThrough(
    const std::vector<Vec3>& picks,
    const DrawingArguments& arguments,
    const LoadedMesh& loaded,
    const Progress& progress
) {
    DesignedCurve drawn = loaded.workpiece->draw(picks, arguments, loaded.layer, progress);
    if (arguments.field && arguments.field->automatic && !drawn.field.empty()) {
        drawn.notes.insert(
            drawn.notes.begin(),
            "the curve follows the quality of " + arguments.mesh.filename().string()
        );
    }
    return drawn;
}

}  // namespace bspline_curve::cli

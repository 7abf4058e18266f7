// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/fuzz_target.h"

#include <algorithm>
#include <array>

namespace bspline_curve::fuzz {

std::span<const FuzzTarget> fuzzTargets() {
    static constexpr auto kTargets = std::to_array<FuzzTarget>({
        {.name = "ply", .run = readPlyBytes},
        {.name = "obj", .run = readObjBytes},
        {.name = "off", .run = readOffBytes},
        {.name = "stl", .run = readStlBytes},
        {.name = "picks", .run = readPicksBytes},
        {.name = "curve_json", .run = readCurveBytes},
        {.name = "foreign_curves", .run = readForeignCurveBytes, .isReader = false},
        {.name = "drawings", .run = readDrawingBytes, .isReader = false},  // blocks multiply
        {.name = "drawn_curves", .run = openDrawnBytes},
        {.name = "shell_file", .run = readShellBytes},
        {.name = "field", .run = readFieldBytes},
        {.name = "face_ids", .run = readFaceIdsBytes},
#ifdef BSPLINE_CURVE_FUZZ_JOBS
        {.name = "jobs", .run = readJobsBytes},
        {.name = "results", .run = readResultsBytes},
#endif
        {.name = "curve", .run = drawCurve, .isReader = false},
    });
    return kTargets;
}

const FuzzTarget* findTarget(std::string_view name) {
    const auto targets = fuzzTargets();
    const auto found = std::ranges::find(targets, name, &FuzzTarget::name);
    return found == targets.end() ? nullptr : &*found;
}

}  // namespace bspline_curve::fuzz

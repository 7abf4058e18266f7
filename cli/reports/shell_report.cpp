// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/reports/shell_report.h"

#include "cli/reports/mesh_json.h"
#include "text/json_text.h"

namespace bspline_curve::cli {

namespace {

Json meshOfShell(const Workpiece& workpiece, const ShellFigures& shell, const std::string& file) {
    Json mesh = meshJson(workpiece, file);
    mesh["boundary_edges"] = shell.boundaryEdges;
    mesh["longest_side"] = shell.longestSide;
    return mesh;
}

Json shellSeconds(
    const Workpiece& workpiece, const ShellFigures& shell, const ShellRunFigures& figures
) {
    const auto& seconds = figures.seconds;
    return {
        {"cpu", seconds.cpu},
        {"wall", seconds.wall},
        {"read", seconds.read},
        {"validate", workpiece.seconds().validate},
        {"base", shell.extendedSeconds},
        {"shell", shell.shellSeconds},
        {"check", seconds.check},
        {"write", seconds.write},
    };
}

Json checkOf(const std::optional<std::vector<ShellInvariant>>& check) {
    if (!check) {
        return nullptr;
    }
    Json result;
    for (const ShellInvariant& invariant : *check) {
        result[std::string(invariant.name)] = {
            {"holds", invariant.holds},
            {"violations", invariant.violations},
            {"first_ids", invariant.firstIds},
        };
    }
    return result;
}

}  // namespace

std::string shellReportText(
    const Workpiece& workpiece, const WholeShell& shell, const ShellRunFigures& figures
) {
    const ShellFigures& made = shell.figures();
    const ShellThickness& thickness = made.thickness;
    const Json document = {
        {"shell", name(made.kind)},
        {"prisms", made.prisms},
        {"ghost_prisms", made.ghostPrisms},
        {"pillars", made.pillars},
        {"faces", workpiece.mesh().faces.size()},
        {"blocked_faces", made.blockedFaces},
        {"moved_vertices", made.movedVertices},
        {"thickness", {{"mean", thickness.mean}, {"p5", thickness.p5}, {"min", thickness.min}}},
        {"seconds", shellSeconds(workpiece, made, figures)},
        {"peak_memory_bytes", figures.peakMemoryBytes},
        {"check", checkOf(figures.check)},
        {"notes", shell.notes()},
        {"repair", repairJson(workpiece.repair())},
        {"mesh", meshOfShell(workpiece, made, figures.meshFile)},
    };
    // A file name may hold bytes that are not UTF-8; they become replacement characters.
    return jsonText(document);
}

}  // namespace bspline_curve::cli

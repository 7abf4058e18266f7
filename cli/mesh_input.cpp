// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mesh_input.h"

#include "bspline_curve/error.h"
#include "cli/command.h"

#include <CLI/CLI.hpp>

#include <utility>

namespace bspline_curve::cli {

void addRepairOption(CLI::App& app, bool& repair) {
    app.add_flag(
        "--repair",
        repair,
        "Part the surface where it is no manifold, turn faces that look the other way, drop "
        "duplicate faces and those without area; says what it changed"
    );
}

MeshFile readInputMesh(const std::filesystem::path& file, bool repair) {
    return readMeshFile(file, repair ? RepeatedVertices::Keep : RepeatedVertices::Refuse);
}

void refuseMissingQuality(const std::filesystem::path& file) {
    throw InputError(
        InputErrorCode::BadField,
        file.string() + ": has no per-vertex quality of type float or double (only .ply can)"
    );
}

std::optional<MeshRepair> repairIfAsked(TriangleMesh& mesh, bool repair) {
    if (!repair) {
        return std::nullopt;
    }
    MeshRepair repaired = repairMesh(std::move(mesh));
    mesh = std::move(repaired.mesh);
    return repaired;
}

void sayRepaired(const std::optional<MeshRepair>& repair) {
    if (repair && !repair->report.isEmpty()) {
        printError("repaired: " + repair->report.summary());
    }
}

}  // namespace bspline_curve::cli

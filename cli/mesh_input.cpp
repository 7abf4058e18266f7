// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mesh_input.h"

#include "bspline_curve/error.h"
#include "cli/command.h"

#include <CLI/CLI.hpp>

#include <utility>

namespace bspline_curve::cli {

void addRepairOption(CLI::App& app) {
    constexpr const char* kHidden = "";
    app.add_flag("--repair")->group(kHidden);
}

MeshFile readInputMesh(const std::filesystem::path& file, bool strict) {
    return readMeshFile(file, strict ? RepeatedVertices::Refuse : RepeatedVertices::Keep);
}

void refuseMissingQuality(const std::filesystem::path& file) {
    throw InputError(
        InputErrorCode::BadField,
        file.string() + ": has no per-vertex quality of type float or double (only .ply can)"
    );
}

Mended<Surface> surfaceOfMended(TriangleMesh given, const MendingOptions& options) {
    return makeMended(std::move(given), options, [](TriangleMesh mesh) {
        return Surface(std::move(mesh));
    });
}

void sayMended(const std::optional<Mending>& mending) {
    if (mending) {
        printError("note: " + mending->note() + (mending->refusal ? "; --strict refuses it" : ""));
    }
}

std::optional<RepairReport> reportOf(const std::optional<Mending>& mending) {
    return mending ? std::optional(mending->repair.report) : std::nullopt;
}

}  // namespace bspline_curve::cli

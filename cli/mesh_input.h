// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/mesh_reader.h"
#include "surface/repair.h"

#include <filesystem>
#include <optional>

namespace CLI {
class App;
}  // namespace CLI

// The mesh of a verb, with or without --repair.
namespace bspline_curve::cli {

void addRepairOption(CLI::App& app, bool& repair);

/// Reads the mesh; with `repair` also one whose faces name a vertex twice.
[[nodiscard]] MeshFile readInputMesh(const std::filesystem::path& file, bool repair);

/// Throws InputError (BadField): a mesh file without the quality that was asked for.
[[noreturn]] void refuseMissingQuality(const std::filesystem::path& file);

/// Where asked for, repairs `mesh`. The result's own mesh is moved to `mesh`.
[[nodiscard]] std::optional<MeshRepair> repairIfAsked(TriangleMesh& mesh, bool repair);

/// Says on stderr what was changed, if anything.
void sayRepaired(const std::optional<MeshRepair>& repair);

}  // namespace bspline_curve::cli

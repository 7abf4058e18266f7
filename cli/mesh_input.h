// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/mesh_reader.h"
#include "surface/mending.h"
#include "surface/surface.h"

#include <filesystem>
#include <optional>

namespace CLI {
class App;
}  // namespace CLI

// The mesh of a verb, mended or strictly as it is.
namespace bspline_curve::cli {

/// --repair, which asked for what is done by default now: accepted, not listed.
void addRepairOption(CLI::App& app);

/// Reads the mesh; unless `strict` also one whose faces name a vertex twice.
[[nodiscard]] MeshFile readInputMesh(const std::filesystem::path& file, bool strict);

/// Throws InputError (BadField): a mesh file without the quality that was asked for.
[[noreturn]] void refuseMissingQuality(const std::filesystem::path& file);

/// The surface of a mesh, see makeMended(). Throws InputError.
[[nodiscard]] Mended<Surface> surfaceOfMended(TriangleMesh given, const MendingOptions& options);

/// Says on stderr what was mended, if anything.
void sayMended(const std::optional<Mending>& mending);

/// What was mended, for reports.
[[nodiscard]] std::optional<RepairReport> reportOf(const std::optional<Mending>& mending);

}  // namespace bspline_curve::cli

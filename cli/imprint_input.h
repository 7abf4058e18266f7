// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/progress_bar.h"
#include "imprint/imprint.h"
#include "imprint/mesh_parts.h"
#include "io/imprint_writer.h"

#include <filesystem>
#include <vector>

namespace CLI {
class App;
}  // namespace CLI

// What the verbs that imprint curves share: mesh, curves and their imprint.
namespace bspline_curve::cli {

struct ImprintInput {
    std::filesystem::path mesh;
    std::vector<std::filesystem::path> curves;
    ImprintOptions options;
};

/// MESH, --curve and --snap.
void addImprintOptions(CLI::App& app, ImprintInput& input);

struct ImprintedFile {
    ImprintedMesh imprinted;
    MeshParts parts;
    std::vector<double> inputQuality, quality;  ///< of vertices; empty: the file has none
    ImprintFigures figures;
};

/// Reads and imprints. Shows the bar up to 0.7. Throws InputError, Cancelled.
[[nodiscard]] ImprintedFile readAndImprint(const ImprintInput& input, ProgressBar& bar);

/// Throws Cancelled after Ctrl-C.
void throwIfInterrupted();

}  // namespace bspline_curve::cli

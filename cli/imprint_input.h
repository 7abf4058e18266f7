// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/curve_input.h"
#include "cli/progress_bar.h"
#include "imprint/imprint.h"
#include "imprint/mesh_parts.h"
#include "io/imprint_writer.h"

#include <vector>

namespace CLI {
class App;
}  // namespace CLI

// What the verbs that imprint curves share: mesh, curves and their imprint.
namespace bspline_curve::cli {

struct ImprintInput {
    CurveInput use;
    ImprintOptions options;
};

/// The options of curves, and --snap.
class ImprintInputOptions {
public:
    /// Both must outlive this.
    ImprintInputOptions(CLI::App& app, ImprintInput& input);

    /// After parsing, see CurveInputOptions.
    void finish() { use_.finish(); }

private:
    CurveInputOptions use_;
};

struct ImprintedFile {
    ImprintedMesh imprinted;
    ImprintOrigins origins;
    MeshParts parts;
    std::vector<double> inputQuality, quality;  ///< of vertices; empty: the file has none
    ImprintFigures figures;
};

/// Reads, draws and imprints. Shows the bar up to 0.7. Throws InputError, Cancelled.
[[nodiscard]] ImprintedFile readAndImprint(const ImprintInput& input, ProgressBar& bar);

/// Says of curves that part nothing, see describeSlits(); nothing where there is none.
void saySlits(const ImprintedMesh& imprinted, const MeshParts& parts, bool isCut);

}  // namespace bspline_curve::cli

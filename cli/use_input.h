// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/files.h"
#include "bspline_curve/imprint.h"
#include "bspline_curve/offset.h"
#include "bspline_curve/parts.h"
#include "cli/curve_drawing.h"
#include "cli/loaded_mesh.h"
#include "cli/progress_bar.h"
#include "cli/reports/imprint_report.h"
#include "filters/imprint_requests.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

// What the verbs that use curves share: a mesh, curves on it that are read or drawn, their imprint.
namespace bspline_curve::cli {

struct UseArguments {
    std::filesystem::path output, report;  ///< report: empty: none asked for
    std::vector<std::filesystem::path> curves, picks;
    std::vector<std::string> layers;  ///< of curves of DXF; empty: all that are visible
    DrawingArguments drawing;         ///< the mesh, and how curves are drawn
};

/// MESH, --curve, --picks, the options of curves, and those of the filter that do the same.
class UseOptions {
public:
    /// All must outlive this.
    UseOptions(CLI::App& app, UseArguments& arguments, const FilterDescription& filter);

    /// Of the filter; --max-distance and --direction are there.
    DescribedOptions described;

    /// After parsing. Throws CLI::ParseError where neither curves nor picks are given, or options
    /// of curves without picks; InputError (BadOption).
    void finish();

private:
    UseArguments& arguments_;
    DrawingOptions drawing_;
};

/// A mesh and the curves on it, those of --curve first, then those of --picks, each in order.
struct CurvesOnMesh {
    LoadedMesh loaded;
    std::vector<SurfacePolyline> lines;
    std::vector<std::optional<SplineData>> splines;  ///< for each line, where it is known
    std::vector<std::filesystem::path> files;        ///< for each line, the one that it is from
    /// Of files; of preparing the mesh; of projecting and drawing.
    double readSeconds = 0.0, surfaceSeconds = 0.0, drawSeconds = 0.0;

    [[nodiscard]] const Workpiece& workpiece() const { return *loaded.workpiece; }
};

/// Reads, projects and draws. Shows the bar up to `share`. Prints notes. Throws InputError,
/// Cancelled.
[[nodiscard]] CurvesOnMesh curvesOnMesh(
    const UseArguments& arguments, const Placing& placing, ProgressBar& bar, double share
);

/// Refuses all but .ply. Throws InputError (UnwritableFile).
void checkHoldsLabels(const std::filesystem::path& file);

/// Curves as edges, and what reports tell of that.
struct ImprintedFile {
    Imprint imprint;
    std::vector<double> quality;  ///< of the input's vertices; empty: the file has none
    MeshExtras extras;            ///< of the input
    std::vector<Triangle> faces;  ///< of the input
    double diagonal = 0.0;        ///< of the mesh
    ImprintFigures figures;

    /// The bytes of a mesh that was made of it, with the parts of faces, the quality, and what else
    /// the input has.
    [[nodiscard]] std::string bytesOf(
        const std::filesystem::path& file, const MadeMesh& made, bool coloured = false
    ) const;
    /// A note where a file of that name cannot hold all that the input has; else none.
    [[nodiscard]] std::vector<std::string> notesFor(const std::filesystem::path& file) const;
    /// The quality at a mesh's vertices; empty: none.
    [[nodiscard]] std::vector<double> qualityOf(const MadeMesh& made) const;
};

/// The share of the progress that imprintedFile() takes.
inline constexpr double kImprintedShare = 0.7;

/// Reads, draws and imprints; the lines, or strokes of a width. Throws InputError, Cancelled.
[[nodiscard]] ImprintedFile imprintedFile(
    const UseArguments& arguments,
    const ImprintRequest& request,
    ProgressBar& bar,
    double stroke = 0.0
);

}  // namespace bspline_curve::cli

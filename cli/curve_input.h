// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/curve_options.h"
#include "cli/drawing_options.h"
#include "cli/prepared_mesh.h"
#include "cli/progress_bar.h"
#include "surface/mending.h"
#include "surface/mesh_checksum.h"
#include "surface/surface.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace CLI {
class App;
}  // namespace CLI

// What the verbs that use curves share: a mesh, and curves on it that are read or drawn.
namespace bspline_curve::cli {

struct CurveInput {
    std::filesystem::path mesh;
    std::vector<std::filesystem::path> curves, picks;
    double maxDistance = 0.0;  ///< of polylines; 0: kPickReachRelative
    CurveArguments drawing;    ///< how curves through picks are drawn
};

/// MESH, --curve, --picks, --max-distance and the options of curves.
class CurveInputOptions {
public:
    /// Both must outlive this.
    CurveInputOptions(CLI::App& app, CurveInput& input);

    /// After parsing. Throws CLI::ParseError where neither curves nor picks are given, or options
    /// of curves without picks; InputError (BadOption).
    void finish();

private:
    CurveInput& input_;
    DrawingOptions drawing_;
};

/// A mesh and the curves on it, those of --curve first, then those of --picks, each in order.
class CurvesOnMesh {
public:
    /// Reads, projects and draws. Shows the bar up to `share`. Prints notes. Throws InputError,
    /// Cancelled.
    CurvesOnMesh(const CurveInput& input, ProgressBar& bar, double share);

    /// Mended where it had to be; curves and quality are those of this one.
    [[nodiscard]] const Surface& surface() const;

    [[nodiscard]] const std::optional<Mending>& mending() const;

    /// Null: the mesh is as it was given.
    [[nodiscard]] const MeshRepair* repair() const {
        return mending() ? &mending()->repair : nullptr;
    }

    /// Of the mesh as it was given.
    [[nodiscard]] const MeshChecksum& checksum() const { return checksum_; }

    [[nodiscard]] const std::vector<SurfacePolyline>& curves() const { return curves_; }

    /// Of vertices; empty: the file has none.
    [[nodiscard]] const std::vector<double>& quality() const { return quality_; }

    /// Of files; of validation, adjacency and what drawing needs; of projecting and drawing.
    struct Seconds {
        double read = 0.0, surface = 0.0, draw = 0.0;
    };

    [[nodiscard]] const Seconds& seconds() const { return seconds_; }

private:
    void readMesh(const CurveInput& input, ProgressBar& bar, double share);
    void takeCurves(const CurveInput& input);
    void drawCurves(const CurveInput& input, ProgressBar& bar);

    std::unique_ptr<PreparedMesh> prepared_;          // where curves are drawn
    std::unique_ptr<const Mended<Surface>> surface_;  // else
    std::vector<double> quality_;
    MeshChecksum checksum_;
    std::vector<SurfacePolyline> curves_;
    Seconds seconds_;
};

}  // namespace bspline_curve::cli

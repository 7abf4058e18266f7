// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/files.h"
#include "cli/command.h"
#include "cli/drawing_options.h"
#include "cli/loaded_mesh.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace bspline_curve::cli {

/// Everything that the command line of one curve says.
struct CurveArguments : DrawingArguments {
    std::filesystem::path picks, output;
    std::filesystem::path report;  ///< empty: none asked for
    int repeat = 0;                ///< further curves to time
    bool requireUsable = false;
    LengthUnit unit = LengthUnit::Millimetre;  ///< of the mesh
};

/// That command line, see runParsed().
struct CurveParser {
    CurveParser();

    [[nodiscard]] CurveArguments finish();

    CLI::App app;
    CurveArguments arguments;
    DrawingOptions drawing{app, arguments};
};

/// Draws one curve on a mesh that is ready, and writes it. Prints what goes wrong.
[[nodiscard]] ExitCode drawOn(const LoadedMesh& loaded, CurveArguments arguments);

/// An option of the command line, for those who write one.
struct CurveOption {
    std::string name;  ///< without dashes; each alias is one of its own
    bool isFlag = false;
};

/// All but --help and --version.
[[nodiscard]] std::vector<CurveOption> curveOptions();

/// Reads a command line. Throws InputError (BadOption) saying what is wrong; prints nothing.
[[nodiscard]] CurveArguments readCurveArguments(Arguments arguments);

}  // namespace bspline_curve::cli

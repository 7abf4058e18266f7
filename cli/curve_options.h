// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "bspline_curve/options.h"
#include "bspline_curve/shell.h"
#include "cli/command.h"
#include "cli/field_input.h"
#include "surface/mending.h"

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace bspline_curve::cli {

/// Everything that the command line of one curve says.
struct CurveArguments {
    std::filesystem::path mesh, picks, output;
    std::filesystem::path report;  ///< empty: none asked for
    std::string field;          ///< empty: none; "auto"; the name of a kind; else a file of values
    FieldOptions fieldOptions;  ///< of a file, too: its values are those of the kind quality
    RegionArguments fieldRegion;
    RegionArguments
        avoid;       ///< thresholds are for the field, or for the quality where there is none
    int repeat = 0;  ///< further curves to time
    MendingOptions mending{};
    bool requireUsable = false;
    bool noCache = false;
    SolverOptions solver;  ///< the preset with what was given explicitly; closed where --closed
                           ///< was, fieldCost the kind's natural one where none was given
    ShellOptions shell;
    SamplingOptions sampling;
};

/// Reads the command line; or, after --help, --version or a wrong one, says how the program ends.
/// Prints help to stdout and one line about what is wrong to stderr.
[[nodiscard]] std::variant<CurveArguments, ExitCode> parseCurveArguments(Arguments arguments);

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

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/command.h"
#include "cli/field_input.h"
#include "surface/mending.h"

#include <filesystem>
#include <variant>

namespace bspline_curve::cli {

/// Everything that the command line of the verb field says.
struct FieldArguments {
    std::filesystem::path mesh, output;
    std::filesystem::path report;  ///< empty: none asked for
    MendingOptions mending{};
    FieldOptions field;
    RegionArguments region;
};

/// Reads the command line; or, after --help or a wrong one, says how the program ends. Prints help
/// to stdout and one line about what is wrong to stderr.
[[nodiscard]] std::variant<FieldArguments, ExitCode> parseFieldArguments(Arguments arguments);

}  // namespace bspline_curve::cli

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/shell.h"
#include "cli/command.h"
#include "surface/mending.h"

#include <filesystem>
#include <variant>

namespace bspline_curve::cli {

/// Everything that the command line of the verb shell says.
struct ShellArguments {
    std::filesystem::path mesh;
    std::filesystem::path output, report;  ///< empty: not asked for
    bool check = false;
    bool isConforming = false;  ///< tetrahedra that conform to the surface
    MendingOptions mending{};
    bool noCache = false;
    ShellOptions shell{.kind = ShellKind::Simplified};
};

/// Reads the command line; or, after --help or a wrong one, says how the program ends. Prints help
/// to stdout and one line about what is wrong to stderr.
[[nodiscard]] std::variant<ShellArguments, ExitCode> parseShellArguments(Arguments arguments);

}  // namespace bspline_curve::cli

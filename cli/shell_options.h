// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/command.h"
#include "cli/option_table.h"
#include "shell/shell_options.h"

#include <filesystem>
#include <variant>

namespace bspline_curve::cli {

/// Everything that the command line of the verb shell says.
struct ShellArguments {
    std::filesystem::path mesh;
    std::filesystem::path output, report;  ///< empty: not asked for
    bool check = false;
    bool repair = false;
    ShellOptions shell{.kind = ShellKind::Simplified};
};

/// Which kind of shell, and what a simplified one is wanted to look like.
void addShellKind(OptionTable<ShellOptions>& table);

/// The options of the shell of full resolution, as every verb that builds one has them.
void addShellOptions(OptionTable<ShellOptions>& table);

/// Reads the command line; or, after --help or a wrong one, says how the program ends. Prints help
/// to stdout and one line about what is wrong to stderr.
[[nodiscard]] std::variant<ShellArguments, ExitCode> parseShellArguments(Arguments arguments);

}  // namespace bspline_curve::cli

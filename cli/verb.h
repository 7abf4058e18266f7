// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/progress.h"
#include "cli/command.h"
#include "cli/progress_bar.h"
#include "text/error_messages.h"

#include <filesystem>
#include <functional>
#include <span>
#include <string>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

// What the verbs share.
namespace bspline_curve::cli {

/// What becomes of work that goes on after Ctrl-C.
enum class AfterInterrupt {
    EndSoon,  ///< it is ended, see endSoonAfterInterrupt()
    Finish    ///< it ends by itself, as it has other processes to end
};

/// What helps against an error, in words of the program.
inline constexpr RemedyWords kRemedyWords{
    .mend = "without --strict the mesh is mended", .weld = "--weld % joins these components"
};

/// Does the work of a verb; what it throws becomes one line on stderr and an exit code. From
/// here on the first Ctrl-C cancels. `isQuiet`: of the bar.
[[nodiscard]] ExitCode runVerb(
    const std::function<ExitCode(ProgressBar&)>& work,
    AfterInterrupt after = AfterInterrupt::EndSoon,
    bool isQuiet = false
);

/// A part [from, to] of the whole bar, and a way out for Ctrl-C.
[[nodiscard]] Progress progressPart(ProgressBar& bar, double from, double to);

/// One line on stderr for each.
void printNotes(std::span<const std::string> notes);

/// One line on stderr where files of an earlier run were removed.
void printRemoved(std::span<const std::filesystem::path> files);

/// Prints help, version or what is wrong with a command line.
[[nodiscard]] ExitCode explainParseError(const CLI::App& app, const CLI::ParseError& error);

}  // namespace bspline_curve::cli

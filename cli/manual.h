// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/command.h"

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace CLI {
class App;
}  // namespace CLI

// Help, manual pages and completion of shells, all made from the options that verbs declare.
namespace bspline_curve::cli {

/// The group of options that `--help` leaves out and `--help paper` lists.
inline constexpr std::string_view kPaperGroup = "Settings of the paper";
/// Groups that most verbs have.
inline constexpr const char* kLinesGroup = "Lines";
inline constexpr const char* kOutputGroup = "Output";
inline constexpr const char* kMendingGroup = "Mending of the mesh";
/// Long, and so the last one.
inline constexpr const char* kDrawingGroup = "Options of curves, for --picks";

/// A verb and what it does, in a few words.
using VerbSummary = std::pair<std::string_view, std::string_view>;

/// Words that come before the name of a verb in what main() asks verbs to print.
inline constexpr const char* kManual = "--manual";          ///< then: the summary
inline constexpr const char* kCompletion = "--completion";  ///< then: the shell

/// Gives a verb its help in groups.
void groupHelp(CLI::App& app);

/// Whether the words ask for a text about the verb in place of its work: `--help paper`, or the two
/// above. It is printed then.
[[nodiscard]] bool printsText(CLI::App& app, Arguments words);

/// The manual page of the program, in roff.
[[nodiscard]] std::string programManual(std::span<const VerbSummary> verbs);

/// A script of completion for bash, zsh or fish; `printVerb` prints the part of a verb to stdout,
/// as the script itself is. Returns whether there is such a shell.
[[nodiscard]] bool printCompletion(
    std::string_view shell,
    std::span<const VerbSummary> verbs,
    const std::function<void(std::string_view verb)>& printVerb
);

}  // namespace bspline_curve::cli

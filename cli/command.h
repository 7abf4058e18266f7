// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <string>

namespace bspline_curve::cli {

/// What the program returns to the shell.
enum class ExitCode : int {
    Success = 0,
    Failure = 1,  ///< bad mesh, picks or file, no usable curve where one is required, a shell that
                  ///< is wrong
    Usage = 2,    ///< an unknown option, or a value out of its range
    Interrupted = 130,  ///< Ctrl-C (128 + SIGINT), as shells report it
};

/// Arguments after the program's name and the verb.
using Arguments = std::span<const char* const>;

/// Prints one line "bspline_curve: …" to stderr; line ends within become blanks.
void printError(const std::string& message);

/// What `run` returns; what it throws besides becomes a line on stderr and a failure.
[[nodiscard]] ExitCode reportingErrors(const std::function<ExitCode()>& run);

/// The verb batch: many curves, as a file lists them.
[[nodiscard]] ExitCode runBatch(Arguments arguments);

/// The verb without a name: one curve through picks on a mesh.
[[nodiscard]] ExitCode runCurve(Arguments arguments);

/// The verb cut: the mesh opened along curves, whole or in parts.
[[nodiscard]] ExitCode runCut(Arguments arguments);
[[nodiscard]] ExitCode runFill(Arguments arguments);

/// The verb field: values at the vertices of a mesh that curves can follow or avoid.
[[nodiscard]] ExitCode runField(Arguments arguments);

/// The verb fit: smooth curves along lines that exist.
[[nodiscard]] ExitCode runFit(Arguments arguments);

/// The verb imprint: curves as edges of the mesh.
[[nodiscard]] ExitCode runImprint(Arguments arguments);

/// The word before which `batch` starts this program for a mesh; no verb for users.
inline constexpr const char* kMeshProcess = "--mesh-process";

/// Reads requests from the standard input, a packet socket: a number and the command line of a
/// curve, all on the mesh of the first one. Answers each, when its curve has ended, with the
/// number, the exit code, the signal that ended it (0: none), its peak memory in bytes and what it
/// printed. Ends without answers, with a line on stderr, where the mesh is refused.
[[nodiscard]] ExitCode runMeshProcess();

/// The verb offset: curves at a distance from a curve, along the surface.
[[nodiscard]] ExitCode runOffset(Arguments arguments);

/// The verb pattern: a planar drawing carried to the surface.
[[nodiscard]] ExitCode runPattern(Arguments arguments);

/// The verb edit: curves turned round, cut, joined and made longer.
[[nodiscard]] ExitCode runEdit(Arguments arguments);

/// The verb points: points at distances along curves.
[[nodiscard]] ExitCode runPoints(Arguments arguments);

/// The verb segment: labels, colours and measures of the parts between curves.
[[nodiscard]] ExitCode runSegment(Arguments arguments);

/// The verb shell: the shell of a mesh, to look at, to check and to use elsewhere.
[[nodiscard]] ExitCode runShell(Arguments arguments);

}  // namespace bspline_curve::cli

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/command.h"

namespace bspline_curve::cli {

/// The word before which `batch` starts this program for a mesh; no verb for users.
inline constexpr const char* kMeshProcess = "--mesh-process";

/// Reads requests from the standard input, a packet socket: a number and the command line of a
/// curve, all on the mesh of the first one. Answers each, when its curve has ended, with the
/// number, the exit code, the signal that ended it (0: none), its peak memory in bytes and what it
/// printed. Ends without answers, with a line on stderr, where the mesh is refused.
[[nodiscard]] ExitCode runMeshProcess();

}  // namespace bspline_curve::cli

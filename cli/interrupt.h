// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace bspline_curve::cli {

/// What a program says that Ctrl-C ended.
inline constexpr std::string_view kInterruptedMessage = "interrupted; nothing was written";

/// From now on the first Ctrl-C only makes interrupted() true; a second one ends the program at
/// once.
void catchInterrupts();

[[nodiscard]] bool interrupted();

/// Throws Cancelled after Ctrl-C.
void throwIfInterrupted();

/// Ends the process 0.1 s after Ctrl-C where it has not ended by itself, with one line and the exit
/// code Interrupted, until beginWriting(): work between two looks at interrupted() may take longer
/// on large meshes, as does giving back their memory. Leaves no temporary file. Costs one sleeping
/// thread; once per process.
void endSoonAfterInterrupt();

/// Before the first file of the results appears. Throws Cancelled after Ctrl-C; from now on only
/// interrupted() tells of one.
void beginWriting();

}  // namespace bspline_curve::cli

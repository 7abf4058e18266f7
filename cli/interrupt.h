// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace bspline_curve::cli {

/// From now on the first Ctrl-C only makes interrupted() true; a second one ends the program at
/// once.
void catchInterrupts();

[[nodiscard]] bool interrupted();

/// Throws Cancelled after Ctrl-C.
void throwIfInterrupted();

}  // namespace bspline_curve::cli

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/shell_builder.h"

#include <memory>

namespace bspline_curve {

/// Grows with every change that makes buildSimplifiedShell() or extendSurface() build other shells;
/// tests/io/shell_file_test.cpp tells when. Shells that were stored by another version are not
/// used.
inline constexpr int kSimplifierVersion = 6;

/// Builds a shell of the kind that the options say. Throws InputError (BadOption), Cancelled.
[[nodiscard]] ShellBuild makeShell(
    const std::shared_ptr<const ExtendedSurface>& extended,
    const ShellOptions& options,
    const Progress& progress = {}
);

/// Builds a simplified shell: starts from a shell of full resolution around the extended surface,
/// then collapses and flips edges, turns, lengthens and moves pillars, each only where the
/// invariants still hold afterwards (checkShell). The result does not depend on the machine. Throws
/// InputError (BadOption), Cancelled. About 60 us and 300 bytes per face.
[[nodiscard]] ShellBuild buildSimplifiedShell(
    const std::shared_ptr<const ExtendedSurface>& extended,
    const ShellOptions& options,
    const Progress& progress = {}
);

}  // namespace bspline_curve

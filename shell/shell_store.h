// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/shell_builder.h"
#include "surface/surface.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace bspline_curve {

/// Where simplified shells are kept from one run to the next. The core itself reads and writes no
/// files; io/shell_cache.h does. No trouble with a store is an error, since a shell can always be
/// built; it is told in notes.
class ShellStore {
public:
    struct Found {
        std::optional<ShellBuild> build;
        std::string note;  ///< why what is stored could not be used; empty where all is well
    };

    virtual ~ShellStore() = default;

    /// The shell that was stored for this surface, base and parameters.
    [[nodiscard]] virtual Found find(
        const Surface& surface,
        const std::shared_ptr<const ExtendedSurface>& extended,
        std::string_view parameters
    ) const = 0;

    /// Stores a simplified shell. Returns a note where that failed, else nothing.
    [[nodiscard]] virtual std::string store(
        const Surface& surface,
        const ExtendedSurface& extended,
        std::string_view parameters,
        const ShellBuild& build
    ) const = 0;
};

/// All that a simplified shell follows from besides its surface, as text: kSimplifierVersion and
/// the options that buildSimplifiedShell() and extendSurface() heed, to the last digit.
[[nodiscard]] std::string storedShellParameters(const ShellOptions& options);

/// A shell and how it was come by.
struct ObtainedShell {
    ShellBuild build;
    bool isFromStore = false;
    std::vector<std::string> notes;  ///< about the store; empty where all is well
};

/// The shell that the store has; else, and where there is no store (null) or a shell of full
/// resolution is asked for, which is quicker to build than to read, the one of makeShell().
/// Throws InputError (BadOption), Cancelled.
[[nodiscard]] ObtainedShell findOrMakeShell(
    const Surface& surface,
    const std::shared_ptr<const ExtendedSurface>& extended,
    const ShellOptions& options,
    const ShellStore* store,
    const Progress& progress = {}
);

/// Stores a simplified shell that did not come from there; does nothing where there is no store.
void keepShell(
    const Surface& surface,
    const ExtendedSurface& extended,
    const ShellOptions& options,
    const ShellStore* store,
    ObtainedShell& shell
);

}  // namespace bspline_curve

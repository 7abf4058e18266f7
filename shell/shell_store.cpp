// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/shell_store.h"

#include "shell/shell_simplifier.h"

#include <array>
#include <charconv>
#include <utility>

namespace bspline_curve {

namespace {

// The shortest text that is this number and no other.
std::string exactText(double value) {
    constexpr std::size_t kLongest = 32;
    std::array<char, kLongest> digits{};
    return {digits.data(), std::to_chars(digits.data(), digits.data() + kLongest, value).ptr};
}

void addNote(std::vector<std::string>& notes, std::string note) {
    if (!note.empty()) {
        notes.push_back(std::move(note));
    }
}

}  // namespace

std::string storedShellParameters(const ShellOptions& options) {
    return "simplifier " + std::to_string(kSimplifierVersion) + ", target thickness " +
           exactText(options.targetThickness) + ", target edge length " +
           exactText(options.targetEdgeLength) + ", smoothing passes " +
           std::to_string(options.smoothingPasses);
}

ObtainedShell findOrMakeShell(
    const Surface& surface,
    const std::shared_ptr<const ExtendedSurface>& extended,
    const ShellOptions& options,
    const ShellStore* store,
    const Progress& progress
) {
    options.validate();
    std::vector<std::string> notes;
    if (store != nullptr && options.kind == ShellKind::Simplified) {
        ShellStore::Found found = store->find(surface, extended, storedShellParameters(options));
        addNote(notes, std::move(found.note));
        if (found.build) {
            return {.build = std::move(*found.build), .isFromStore = true, .notes = notes};
        }
    }
    return {
        .build = makeShell(extended, options, progress),
        .isFromStore = false,
        .notes = std::move(notes)
    };
}

void keepShell(
    const Surface& surface,
    const ExtendedSurface& extended,
    const ShellOptions& options,
    const ShellStore* store,
    ObtainedShell& shell
) {
    if (store != nullptr && !shell.isFromStore && !shell.build.shell.isFullResolution()) {
        addNote(
            shell.notes,
            store->store(surface, extended, storedShellParameters(options), shell.build)
        );
    }
}

}  // namespace bspline_curve

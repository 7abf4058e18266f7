// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/shell_cache_option.h"

#include "cli/command.h"

#include <CLI/CLI.hpp>

namespace bspline_curve::cli {

void addCacheOption(CLI::App& app, bool& noCache) {
    app.add_flag(
        "--no-cache",
        noCache,
        "Neither take a simplified shell from the cache folder nor keep it there"
    );
}

std::optional<ShellCache> cacheUnless(bool noCache) {
    return noCache ? std::nullopt : ShellCache::ofUser();
}

void printNotes(std::span<const std::string> notes) {
    for (const std::string& note : notes) {
        printError("note: " + note);
    }
}

}  // namespace bspline_curve::cli

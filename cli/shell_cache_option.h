// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/shell_cache.h"

#include <optional>
#include <span>
#include <string>

namespace CLI {
class App;
}  // namespace CLI

// The cache of shells of a verb, with or without --no-cache.
namespace bspline_curve::cli {

void addCacheOption(CLI::App& app, bool& noCache);

/// The user's cache; none where it is switched off.
[[nodiscard]] std::optional<ShellCache> cacheUnless(bool noCache);

/// One line on stderr for each.
void printNotes(std::span<const std::string> notes);

}  // namespace bspline_curve::cli

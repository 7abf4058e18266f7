// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/shell_cache.h"

#include "bspline_curve/error.h"
#include "io/byte_stream.h"
#include "io/environment.h"
#include "io/shell_file.h"
#include "text/text_parsing.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cstdlib>
#include <string>
#include <system_error>
#include <tuple>
#include <utility>
#include <vector>

namespace bspline_curve {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kExtension = ".shell";
// A temporary file of this age was left behind by a process that was ended while it wrote.
constexpr std::chrono::hours kLeftBehind{1};

// Sixteen hexadecimal digits.
std::string inHexadecimal(std::uint64_t value) {
    constexpr std::size_t kDigits = 16;
    std::array<char, kDigits> digits{};
    char* const end = std::to_chars(digits.data(), digits.data() + kDigits, value, 16).ptr;
    const std::string text(digits.data(), end);
    return std::string(kDigits - text.size(), '0') + text;
}

void removeIfOld(const fs::path& file, fs::file_time_type lastUse) {
    if (fs::file_time_type::clock::now() - lastUse > kLeftBehind) {
        std::error_code error;
        fs::remove(file, error);
    }
}

struct CachedShell {
    fs::file_time_type lastUse;
    fs::path file;
    std::uint64_t bytes;
};

// The shells of a folder; what vanishes meanwhile is left out.
std::vector<CachedShell> entriesIn(const fs::path& directory) {
    std::vector<CachedShell> entries;
    std::error_code error;
    fs::directory_iterator item(directory, error);
    for (; !error && item != fs::directory_iterator(); item.increment(error)) {
        std::error_code gone;
        const fs::path& file = item->path();
        const fs::file_time_type lastUse = fs::last_write_time(file, gone);
        const std::uint64_t bytes = gone ? 0 : fs::file_size(file, gone);
        if (gone || !item->is_regular_file(gone)) {
            continue;
        }
        if (file.extension() == kExtension) {
            entries.push_back({lastUse, file, bytes});
        } else if (file.extension() == ".tmp") {
            removeIfOld(file, lastUse);
        }
    }
    return entries;
}

}  // namespace

ShellCache::ShellCache(fs::path directory, std::uint64_t sizeLimitBytes)
    : directory_(std::move(directory)), sizeLimitBytes_(sizeLimitBytes) {}

std::optional<fs::path> ShellCache::defaultDirectory() {
    if (std::getenv("BSPLINE_CURVE_CACHE") != nullptr) {
        const auto chosen = environmentPath("BSPLINE_CURVE_CACHE");
        return chosen ? std::optional(*chosen / "shells") : std::nullopt;
    }
    // A relative path there is to be ignored (XDG Base Directory Specification).
    if (const auto cache = environmentPath("XDG_CACHE_HOME"); cache && cache->is_absolute()) {
        return *cache / "bspline_curve" / "shells";
    }
    if (const auto home = environmentPath("HOME")) {
        return *home / ".cache" / "bspline_curve" / "shells";
    }
    return std::nullopt;
}

std::optional<ShellCache> ShellCache::ofUser() {
    const auto directory = defaultDirectory();
    return directory ? std::optional<ShellCache>(std::in_place, *directory) : std::nullopt;
}

fs::path ShellCache::entryOf(const Surface& surface, std::string_view parameters) const {
    std::string name = inHexadecimal(surfaceChecksum(surface));
    name.append("-").append(inHexadecimal(checksumOf(parameters))).append(kExtension);
    return directory_ / name;
}

ShellCache::Found ShellCache::find(
    const Surface& surface,
    const std::shared_ptr<const ExtendedSurface>& extended,
    std::string_view parameters
) const {
    const fs::path entry = entryOf(surface, parameters);
    std::error_code error;
    try {
        const std::optional<std::string> bytes = readWholeFileIfThere(entry);
        if (!bytes) {
            return {};
        }
        Found found{.build = decodeShell(entry, *bytes, surface, extended, parameters), .note = {}};
        // Where that fails the entry only looks older than it is.
        fs::last_write_time(entry, fs::file_time_type::clock::now(), error);
        return found;
    } catch (const InputError& reason) {
        const bool isRemoved = fs::remove(entry, error);
        return {
            .build = std::nullopt,
            .note = std::string("the stored shell was not used") +
                    (isRemoved || !error ? " and deleted: " : ": ") + reason.what()
        };
    }
}

std::string ShellCache::store(
    const Surface& surface,
    const ExtendedSurface& extended,
    std::string_view parameters,
    const ShellBuild& build
) const {
    std::error_code error;
    fs::create_directories(directory_, error);
    if (error) {
        return "the shell was not stored: " + directory_.string() + ": " + error.message();
    }
    const fs::path entry = entryOf(surface, parameters);
    try {
        saveShell(entry, surface, extended, parameters, build);
    } catch (const InputError& reason) {
        return std::string("the shell was not stored: ") + reason.what();
    }
    const std::uint64_t bytes = fs::file_size(entry, error);
    evict();
    if (!error && bytes > sizeLimitBytes_) {
        return "the shell was not stored: it is larger than the limit of the cache";
    }
    return {};
}

void ShellCache::evict() const {
    std::vector<CachedShell> entries = entriesIn(directory_);
    std::sort(entries.begin(), entries.end(), [](const CachedShell& a, const CachedShell& b) {
        return std::tie(a.lastUse, a.file) < std::tie(b.lastUse, b.file);
    });
    std::uint64_t total = 0;
    for (const CachedShell& entry : entries) {
        total += entry.bytes;
    }
    for (const CachedShell& entry : entries) {
        if (total <= sizeLimitBytes_) {
            return;
        }
        std::error_code error;
        fs::remove(entry.file, error);
        total -= entry.bytes;
    }
}

}  // namespace bspline_curve

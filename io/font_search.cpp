// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/font_search.h"

#include "bspline_curve/error.h"
#include "io/environment.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <system_error>
#include <tuple>

namespace bspline_curve {

namespace {

namespace fs = std::filesystem;

/// Files of upright sans serifs in lower case, as systems and their packages name them; the first
/// that is there is taken. All have the letters of European languages.
constexpr std::array<std::string_view, 12> kWellKnown{
    "dejavusans.ttf",
    "liberationsans-regular.ttf",
    "notosans-regular.ttf",
    "arial.ttf",
    "helvetica.ttc",
    "helvetica.ttf",
    "segoeui.ttf",
    "ubuntu-r.ttf",
    "opensans-regular.ttf",
    "roboto-regular.ttf",
    "freesans.ttf",
    "nimbussans-regular.otf",
};

std::string lowerCaseName(const fs::path& file) {
    // Names of other letters than these are none of ours.
    std::u8string name = file.filename().u8string();
    std::ranges::transform(name, name.begin(), [](char8_t c) {
        return c >= u8'A' && c <= u8'Z' ? static_cast<char8_t>(c - u8'A' + u8'a') : c;
    });
    return {name.begin(), name.end()};
}

/// A file of a well-known font; the lesser is preferred.
struct FontFile {
    std::size_t font;    // in kWellKnown
    std::size_t folder;  // of those searched
    fs::path file;

    friend bool operator<(const FontFile& a, const FontFile& b) {
        return std::tie(a.font, a.folder, a.file) < std::tie(b.font, b.folder, b.file);
    }
};

void addFonts(const fs::path& folder, std::size_t index, std::vector<FontFile>& found) {
    std::error_code error;
    fs::recursive_directory_iterator item(
        folder, fs::directory_options::skip_permission_denied, error
    );
    for (; !error && item != fs::recursive_directory_iterator(); item.increment(error)) {
        const auto* const known = std::ranges::find(kWellKnown, lowerCaseName(item->path()));
        std::error_code gone;
        if (known != kWellKnown.end() && item->is_regular_file(gone)) {
            found.push_back(
                {.font = static_cast<std::size_t>(known - kWellKnown.begin()),
                 .folder = index,
                 .file = item->path()}
            );
        }
    }
}

/// Adds a folder below the one that a variable names.
void addBelow(const char* variable, const fs::path& below, std::vector<fs::path>& folders) {
    if (const auto root = environmentPath(variable); root && root->is_absolute()) {
        folders.push_back(*root / below);
    }
}

}  // namespace

#ifdef _WIN32

std::vector<fs::path> fontFolders() {
    std::vector<fs::path> folders;
    addBelow("SystemRoot", "Fonts", folders);
    addBelow("LOCALAPPDATA", "Microsoft/Windows/Fonts", folders);
    return folders;
}

#elif defined(__APPLE__)

std::vector<fs::path> fontFolders() {
    std::vector<fs::path> folders{"/System/Library/Fonts", "/Library/Fonts"};
    addBelow("HOME", "Library/Fonts", folders);
    return folders;
}

#else

std::vector<fs::path> fontFolders() {
    std::vector<fs::path> folders;
    // The XDG Base Directory Specification: the default, and that relative paths do not count.
    std::string_view roots = "/usr/local/share:/usr/share";
    const auto fromEnvironment = environmentPath("XDG_DATA_DIRS");
    if (fromEnvironment) {
        roots = fromEnvironment->native();
    }
    while (!roots.empty()) {
        const std::size_t end = std::min(roots.find(':'), roots.size());
        if (const fs::path root = roots.substr(0, end); root.is_absolute()) {
            folders.push_back(root / "fonts");
        }
        roots.remove_prefix(std::min(end + 1, roots.size()));
    }
    addBelow("XDG_DATA_HOME", "fonts", folders);
    addBelow("HOME", ".local/share/fonts", folders);
    addBelow("HOME", ".fonts", folders);
    return folders;
}

#endif

std::optional<fs::path> findFont(std::span<const fs::path> folders) {
    std::vector<FontFile> found;
    for (std::size_t i = 0; i < folders.size(); ++i) {
        addFonts(folders[i], i, found);
    }
    const auto best = std::ranges::min_element(found, std::less<>());
    return best == found.end() ? std::nullopt : std::optional(best->file);
}

fs::path fontOrDefault(const fs::path& file) {
    if (!file.empty()) {
        return file;
    }
    const auto found = findFont(fontFolders());
    if (!found) {
        throw InputError(
            InputErrorCode::BadOption,
            "no font was found for the text: give a font file (.ttf, .otf or .pfb), or install "
            "one that is known, such as DejaVu Sans or Liberation Sans"
        );
    }
    return *found;
}

}  // namespace bspline_curve

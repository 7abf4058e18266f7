// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace bspline_curve {

struct CsvRecord {
    std::size_t line = 0;  ///< that it begins in, from 1
    std::vector<std::string> fields;
};

/// The records of a text with commas, semicolons or tabs between the fields, whichever the first
/// record has: a semicolon, else a tab, else commas. Blanks around fields are dropped; a field in
/// double quotes may hold separators, line ends and, doubled, quotes. Empty lines and lines that
/// begin with # are left out, as is a byte order mark.
struct CsvTable {
    char separator = ',';
    std::vector<CsvRecord> records;
};

/// Throws InputError (UnreadableFile) naming `file` and line where quotes do not match.
[[nodiscard]] CsvTable parseCsv(const std::filesystem::path& file, std::string_view bytes);

/// One line of a file with commas, with its line end; fields are in quotes where they must be.
[[nodiscard]] std::string csvLine(std::span<const std::string> fields);

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
// Picks in the rows of a table: of CSV, of texts with blanks, and of 3D Slicer's lists.
#include "io/picks_formats.h"
#include "text/csv.h"
#include "text/text_parsing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace bspline_curve {

namespace {

using std::filesystem::path;

/// Where x, y and z are in each record.
using Columns = std::array<std::size_t, 3>;

/// With semicolons between the fields decimal commas may be used.
std::optional<double> numberOf(std::string word, char separator) {
    if (separator == ';') {
        std::ranges::replace(word, ',', '.');
    }
    return parseNumber(word);
}

/// The axis that a column is named for: "x", "X [mm]", and "Points:0" of ParaView; else empty.
std::string axisNamed(std::string_view column) {
    std::string name = lowerCase(trimmed(column.substr(0, column.find_first_of("[("))));
    constexpr std::string_view kParaView = "points:";
    if (name.starts_with(kParaView) && name.size() == kParaView.size() + 1) {
        const std::size_t axis = std::string_view("012").find(name.back());
        return axis == std::string_view::npos ? std::string() : std::string(1, "xyz"[axis]);
    }
    return name;
}

/// The columns that a header names; none where one is not named.
std::optional<Columns> columnsNamed(const std::vector<std::string>& header) {
    Columns columns{};
    for (std::size_t k = 0; k < 3; ++k) {
        const auto found = std::ranges::find(header, std::string(1, "xyz"[k]), axisNamed);
        if (found == header.end()) {
            return std::nullopt;
        }
        columns[k] = static_cast<std::size_t>(found - header.begin());
    }
    return columns;
}

/// A table's columns, and whether its first record names them.
struct TableColumns {
    Columns columns{0, 1, 2};
    bool hasHeader = false;
};

TableColumns columnsOf(const path& file, const CsvRecord& first, char separator) {
    const auto isNumber = [&](const std::string& word) {
        return numberOf(word, separator).has_value();
    };
    if (std::ranges::all_of(first.fields, isNumber)) {
        return {};
    }
    if (const auto named = columnsNamed(first.fields)) {
        return {.columns = *named, .hasHeader = true};
    }
    const std::vector<std::string>& fields = first.fields;
    if (fields.front().find_first_of("0123456789+-.") == 0) {
        return {};  // no name: what is wrong with a coordinate is told where it is read
    }
    if (fields.size() >= 4 && std::all_of(fields.begin() + 1, fields.begin() + 4, isNumber)) {
        return {.columns = {1, 2, 3}, .hasHeader = false};  // behind a label
    }
    for (const char axis : {'x', 'y', 'z'}) {
        if (std::ranges::find(fields, std::string(1, axis), axisNamed) == fields.end()) {
            refuseLine(
                file, first.line, "the header names no column " + inQuotes(std::string(1, axis))
            );
        }
    }
    return {};
}

PicksFile picksOfTable(const path& file, const CsvTable& table, const TableColumns& where) {
    PicksFile result;
    for (std::size_t i = where.hasHeader ? 1 : 0; i < table.records.size(); ++i) {
        const auto& [line, fields] = table.records[i];
        Vec3 pick;
        for (std::size_t k = 0; k < 3; ++k) {
            if (where.columns[k] >= fields.size()) {
                refuseLine(file, line, "a pick needs three coordinates");
            }
            const std::string& word = fields[where.columns[k]];
            const auto value = numberOf(word, table.separator);
            if (!value || !std::isfinite(*value)) {
                refuseLine(
                    file,
                    line,
                    inQuotes(word) + " is not a finite number" +
                        (word.find(',') == std::string::npos ? ""
                                                             : "; write decimal points, not commas")
                );
            }
            pick[static_cast<Eigen::Index>(k)] = *value;
        }
        result.picks.push_back(pick);
    }
    return result;
}

PicksFile picksOfTable(const path& file, const CsvTable& table) {
    return table.records.empty()
               ? PicksFile{}
               : picksOfTable(file, table, columnsOf(file, table.records.front(), table.separator));
}

/// Whether a line has three fields or more between separators, none of them with blanks inside.
bool isParted(std::string_view line, char separator) {
    const std::vector<std::string_view> parts = splitAt(line, separator);
    return parts.size() >= 3 && std::ranges::all_of(parts, [](std::string_view part) {
               return part.find_first_of(" \t") == std::string_view::npos;
           });
}

bool isComment(std::string_view line) {
    return line.empty() || line.starts_with('#') || line.starts_with("//");
}

}  // namespace

PicksFile picksOfCsv(const path& file, std::string_view bytes) {
    return picksOfTable(file, parseCsv(file, bytes));
}

PicksFile picksOfText(const path& file, std::string_view bytes) {
    CsvTable table{.separator = ' ', .records = {}};
    LineReader lines(bytes);
    while (lines.next()) {
        std::string_view line = trimmed(lines.line());
        line = trimmed(line.substr(0, line.find('#')));
        if (isComment(line)) {
            continue;
        }
        if (table.records.empty()) {
            table.separator = isParted(line, ';') ? ';' : isParted(line, ',') ? ',' : ' ';
        }
        CsvRecord record{.line = lines.number(), .fields = {}};
        for (const std::string_view word :
             table.separator == ' ' ? splitAtBlanks(line) : splitAt(line, table.separator)) {
            record.fields.emplace_back(word);
        }
        table.records.push_back(std::move(record));
    }
    return picksOfTable(file, table);
}

PicksFile picksOfSlicerList(const path& file, std::string_view bytes) {
    // Comments at the beginning say what the columns are, and in which system.
    std::vector<std::string> names{"id", "x", "y", "z"};
    std::string system = "RAS";  // of files that do not say
    LineReader lines(bytes);
    while (lines.next() && lines.line().starts_with('#')) {
        const std::vector<std::string_view> sides = splitAt(lines.line().substr(1), '=');
        if (sides.size() != 2) {
            continue;
        }
        if (sides[0] == "CoordinateSystem") {
            system = sides[1];
            if (system != "LPS" && system != "RAS" && system != "0" && system != "1") {
                refuseLine(
                    file,
                    lines.number(),
                    "the CoordinateSystem " + inQuotes(system) + " is neither LPS nor RAS"
                );
            }
        } else if (sides[0] == "columns") {
            const std::vector<std::string_view> named = splitAt(sides[1], ',');
            names.assign(named.begin(), named.end());
        }
    }
    const std::optional<Columns> columns = columnsNamed(names);
    if (!columns) {
        refuseFile(file, "its columns have no x, y and z");
    }
    PicksFile result =
        picksOfTable(file, parseCsv(file, bytes), {.columns = *columns, .hasHeader = false});
    if (system == "RAS" || system == "0") {
        for (Vec3& pick : result.picks) {
            pick = Vec3(-pick.x(), -pick.y(), pick.z());
        }
    }
    return result;
}

}  // namespace bspline_curve

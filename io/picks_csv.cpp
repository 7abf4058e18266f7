// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/csv.h"
#include "io/picks_formats.h"
#include "io/text_parsing.h"

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

/// The columns that a header names; none where the first record holds numbers only.
std::optional<Columns> columnsOfHeader(const path& file, const CsvRecord& first, char separator) {
    const bool holdsNumbers = std::ranges::all_of(first.fields, [&](const std::string& word) {
        return numberOf(word, separator).has_value();
    });
    if (holdsNumbers) {
        return std::nullopt;
    }
    std::vector<std::string> names;
    for (const std::string& field : first.fields) {
        names.push_back(lowerCase(trimmed(field)));
    }
    Columns columns{};
    for (std::size_t k = 0; k < 3; ++k) {
        const std::string wanted(1, "xyz"[k]);
        const auto found = std::ranges::find(names, wanted);
        if (found == names.end()) {
            refuseLine(file, first.line, "the header names no column " + inQuotes(wanted));
        }
        columns[k] = static_cast<std::size_t>(found - names.begin());
    }
    return columns;
}

}  // namespace

PicksFile picksOfCsv(const path& file, std::string_view bytes) {
    const CsvTable table = parseCsv(file, bytes);
    PicksFile result;
    if (table.records.empty()) {
        return result;
    }
    const auto named = columnsOfHeader(file, table.records.front(), table.separator);
    const Columns columns = named.value_or(Columns{0, 1, 2});
    for (std::size_t i = named ? 1 : 0; i < table.records.size(); ++i) {
        const auto& [line, fields] = table.records[i];
        Vec3 pick;
        for (std::size_t k = 0; k < 3; ++k) {
            if (columns[k] >= fields.size()) {
                refuseLine(file, line, "a pick needs three coordinates");
            }
            const std::string& word = fields[columns[k]];
            const auto value = numberOf(word, table.separator);
            if (!value || !std::isfinite(*value)) {
                refuseLine(file, line, inQuotes(word) + " is not a finite number");
            }
            pick[static_cast<Eigen::Index>(k)] = *value;
        }
        result.picks.push_back(pick);
    }
    return result;
}

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
// A table of points as one polyline; of tables that writeCurve() wrote, with their places.
#include "io/picks_formats.h"
#include "io/polyline_formats.h"
#include "text/csv.h"
#include "text/text_parsing.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace bspline_curve {

namespace {

/// Columns that writeCurve() writes beside x, y and z, found by name.
class WrittenColumns {
public:
    explicit WrittenColumns(const std::vector<std::string>& header) {
        for (std::size_t k = 0; k < kNames.size(); ++k) {
            const auto found = std::ranges::find(header, kNames[k]);
            isComplete_ = isComplete_ && found != header.end();
            columns_[k] = static_cast<std::size_t>(found - header.begin());
        }
    }

    [[nodiscard]] bool isComplete() const { return isComplete_; }

    /// t, face, b0, b1, b2 of a record; none where one of them is no number.
    [[nodiscard]] std::optional<std::array<double, 5>> valuesOf(const CsvRecord& record) const {
        std::array<double, 5> values{};
        for (std::size_t k = 0; k < columns_.size(); ++k) {
            const std::optional<double> value = columns_[k] < record.fields.size()
                                                    ? parseNumber(record.fields[columns_[k]])
                                                    : std::nullopt;
            if (!value) {
                return std::nullopt;
            }
            values[k] = *value;
        }
        return values;
    }

private:
    static constexpr std::array<std::string_view, 5> kNames{"t", "face", "b0", "b1", "b2"};

    std::array<std::size_t, 5> columns_{};
    bool isComplete_ = true;
};

}  // namespace

PolylineGraph polylinesOfCsv(const std::filesystem::path& file, std::string_view bytes) {
    PolylineGraph graph;
    graph.points = picksOfCsv(file, bytes).picks;
    for (int i = 1; i < static_cast<int>(graph.points.size()); ++i) {
        graph.edges.push_back({i - 1, i});
    }
    const CsvTable table = parseCsv(file, bytes);
    if (table.records.empty()) {
        return graph;
    }
    const WrittenColumns written(table.records.front().fields);
    if (!written.isComplete() || table.records.size() != graph.points.size() + 1) {
        return graph;
    }
    double lastT = 1.0;
    for (std::size_t i = 1; i < table.records.size(); ++i) {
        const auto values = written.valuesOf(table.records[i]);
        if (!values) {
            graph.places.clear();
            return graph;
        }
        const auto& [t, face, b0, b1, b2] = *values;
        graph.places.push_back(placeOfNumbers(face, Vec3(b0, b1, b2)));
        lastT = t;
    }
    // An open curve ends at t = 1, a closed one before: its last segment leads back.
    if (lastT < 1.0 && graph.points.size() > 2) {
        graph.edges.push_back({static_cast<int>(graph.points.size()) - 1, 0});
    }
    return graph;
}

}  // namespace bspline_curve

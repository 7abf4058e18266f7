// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/error.h"
#include "bspline_curve/files.h"
#include "io/npy.h"
#include "text/error_messages.h"
#include "text/text_parsing.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

namespace bspline_curve {

namespace {

using std::filesystem::path;

std::vector<double> valuesOfText(const path& file, std::string_view bytes) {
    std::vector<double> values;
    LineReader lines(bytes);
    while (lines.next()) {
        for (const std::string_view word :
             splitAtBlanks(lines.line().substr(0, lines.line().find('#')))) {
            const auto value = parseNumber(word);
            if (!value) {
                refuseLine(file, lines.number(), inQuotes(word) + " is not a number");
            }
            values.push_back(*value);
        }
    }
    return values;
}

std::vector<double> valuesOfNpy(const path& file, std::string_view bytes) {
    constexpr std::array<std::string_view, 2> kTypes = {"<f4", "<f8"};
    const NpyArray array = parseNpy(file, bytes, kTypes, "float32 or float64");
    return array.type == "<f4" ? npyValues<float, double>(array) : npyValues<double, double>(array);
}

}  // namespace

std::vector<double> readField(const path& file, std::size_t vertexCount) {
    const std::string bytes = readWholeFile(file);
    std::vector<double> values =
        lowerCaseExtension(file) == ".npy" ? valuesOfNpy(file, bytes) : valuesOfText(file, bytes);
    if (values.size() != vertexCount) {
        throw InputError(
            InputErrorCode::BadField,
            file.string() + ": has " + std::to_string(values.size()) + " values, the mesh has " +
                std::to_string(vertexCount) + " vertices"
        );
    }
    std::vector<std::int64_t> bad;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!std::isfinite(values[i])) {
            bad.push_back(static_cast<std::int64_t>(i));
        }
    }
    if (!bad.empty()) {
        throw InputError(
            InputErrorCode::BadField,
            file.string() + ": " + std::to_string(bad.size()) +
                " values are not finite, at vertices " + describeElements(bad),
            bad
        );
    }
    return values;
}

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/files.h"
#include "io/npy.h"
#include "text/text_parsing.h"

#include <array>
#include <string>
#include <string_view>

namespace bspline_curve {

namespace {

using std::filesystem::path;

std::vector<std::int64_t> idsOfText(const path& file, std::string_view bytes) {
    std::vector<std::int64_t> ids;
    LineReader lines(bytes);
    while (lines.next()) {
        for (const std::string_view word :
             splitAtBlanks(lines.line().substr(0, lines.line().find('#')))) {
            const auto id = parseInteger(word);
            if (!id) {
                refuseLine(file, lines.number(), inQuotes(word) + " is not a whole number");
            }
            ids.push_back(*id);
        }
    }
    return ids;
}

std::vector<std::int64_t> idsOfNpy(const path& file, std::string_view bytes) {
    constexpr std::array<std::string_view, 4> kTypes = {"<i4", "<u4", "<i8", "<u8"};
    const NpyArray array = parseNpy(file, bytes, kTypes, "integers of 32 or 64 bits");
    if (array.type == "<i4") {
        return npyValues<std::int32_t, std::int64_t>(array);
    }
    // Ids beyond the range become negative ones, which are no faces either.
    return array.type == "<u4" ? npyValues<std::uint32_t, std::int64_t>(array)
                               : npyValues<std::int64_t, std::int64_t>(array);
}

}  // namespace

std::vector<std::int64_t> readFaceIds(const path& file) {
    const std::string bytes = readWholeFile(file);
    return lowerCaseExtension(file) == ".npy" ? idsOfNpy(file, bytes) : idsOfText(file, bytes);
}

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/error.h"
#include "bspline_curve/files.h"
#include "io/picks_formats.h"
#include "text/error_messages.h"
#include "text/text_parsing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace bspline_curve {

using std::filesystem::path;

double coordinateOf(const path& file, std::size_t line, std::string_view word) {
    const auto value = parseNumber(word);
    if (!value || !std::isfinite(*value)) {
        refuseLine(file, line, inQuotes(word) + " is not a finite number");
    }
    return *value;
}

namespace {

bool isPicksExtension(const std::string& extension) {
    constexpr std::array<std::string_view, 7> kKnown{
        ".pp", ".json", ".csv", ".fcsv", ".xyz", ".txt", ".asc"
    };
    return std::ranges::find(kKnown, extension) != kKnown.end();
}

}  // namespace

PicksFile readPicks(const path& file) {
    const std::string extension = lowerCaseExtension(file);
    const std::string bytes = isPicksExtension(extension) ? readWholeFile(file) : std::string();
    PicksFile result;
    if (extension == ".pp") {
        result = picksOfPickPoints(file, bytes);
    } else if (extension == ".json") {
        result = picksOfJson(file, bytes);
    } else if (extension == ".csv") {
        result = picksOfCsv(file, bytes);
    } else if (extension == ".fcsv") {
        result = picksOfSlicerList(file, bytes);
    } else if (isPicksExtension(extension)) {
        result = picksOfText(file, bytes);
    } else {
        refuseFile(
            file,
            "the extension " + inQuotes(extension) + " is none of " + std::string(kPicksExtensions)
        );
    }
    if (result.picks.empty()) {
        refuseFile(file, "holds no picks");
    }
    return result;
}

std::vector<Vec3> parsePicksText(std::string_view text) {
    std::string plain(text);
    std::ranges::replace(plain, '\n', ';');
    std::ranges::replace(plain, ',', ' ');
    std::vector<Vec3> picks;
    for (const std::string_view part : splitAt(plain, ';')) {
        const auto words = splitAtBlanks(part);
        if (words.empty()) {
            continue;
        }
        const std::string name = describePicks({std::ssize(picks)}) + ", " + inQuotes(part);
        if (words.size() != 3) {
            throw InputError(
                InputErrorCode::UnreadableFile, name + ", is not of the form \"x y z\""
            );
        }
        Vec3 pick;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto value = parseNumber(words[k]);
            if (!value || !std::isfinite(*value)) {
                throw InputError(
                    InputErrorCode::UnreadableFile,
                    name + ": " + inQuotes(words[k]) + " is not a finite number"
                );
            }
            pick[static_cast<Eigen::Index>(k)] = *value;
        }
        picks.push_back(pick);
    }
    return picks;
}

}  // namespace bspline_curve

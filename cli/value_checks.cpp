// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/value_checks.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace bspline_curve::cli {

namespace {

/// Least number of letters to insert, remove or replace (Levenshtein).
std::size_t editDistance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), 0);
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = std::exchange(row[0], i + 1);
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row.back();
}

}  // namespace

std::string didYouMean(std::string_view word, std::span<const std::string> words) {
    constexpr std::size_t kShort = 3;
    std::size_t least = word.size() > kShort ? 3 : 2;  // what is less than this is near
    std::string text;
    for (const std::string& candidate : words) {
        if (const std::size_t distance = editDistance(word, candidate); distance < least) {
            least = distance;
            text = "; did you mean " + candidate + "?";
        }
    }
    return text;
}

}  // namespace bspline_curve::cli

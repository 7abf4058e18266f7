// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/ply_cursor.h"

#include <string>

namespace bspline_curve {

void PlyCursor::refuse(
    const std::filesystem::path& file,
    const PlyHeader& header,
    const PlyElement& element,
    std::size_t index
) const {
    if (!word_.empty()) {
        const auto before = all_.substr(0, static_cast<std::size_t>(word_.data() - all_.data()));
        const auto line = static_cast<std::size_t>(std::ranges::count(before, '\n'));
        const bool hasComma = word_.find(',') != std::string_view::npos;
        refuseLine(
            file,
            header.lines + line + 1,
            element.name + " " + std::to_string(index) + ": " + inQuotes(word_) +
                " is not a number of its type" +
                (hasComma ? "; write decimal points, not commas" : "")
        );
    }
    refuseFile(
        file,
        "is truncated or damaged: no " + element.name + " " +
            (index < element.count ? std::to_string(index) + " " : "data ") + "of " +
            std::to_string(element.count)
    );
}

}  // namespace bspline_curve

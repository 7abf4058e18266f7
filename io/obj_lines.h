// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "text/text_parsing.h"

#include <string>
#include <string_view>

namespace bspline_curve {

/// The current line of an OBJ file with those that a backslash at its end joins to it; the reader
/// goes on to the last of them. `joined` holds the text where it is more than one line. `check` is
/// called at each line, `refuse` with the reason where the file ends before the last.
template <class Check, class Refuse>
[[nodiscard]] std::string_view wholeObjLine(
    LineReader& lines, std::string& joined, const Check& check, const Refuse& refuse
) {
    check();
    std::string_view line = lines.line();
    if (!line.ends_with('\\') || line.starts_with('#')) {
        return line;
    }
    joined.clear();
    while (line.ends_with('\\')) {
        joined += line.substr(0, line.size() - 1);
        if (!lines.next()) {
            refuse("the file ends where a line should go on");
        }
        check();
        line = lines.line();
    }
    joined += line;
    return joined;
}

}  // namespace bspline_curve

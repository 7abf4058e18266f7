// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/dxf_text.h"

#include "text/number_text.h"
#include "text/text_parsing.h"

#include <algorithm>

namespace bspline_curve {

void DxfText::add(int code, std::string_view value) {
    text_.append(std::to_string(code)).append("\n").append(value).append("\n");
}

void DxfText::add(int code, int value) {
    add(code, std::to_string(value));
}

void DxfText::add(int code, double value) {
    std::string text = numberText(value);
    if (text.find_first_of(".e") == std::string::npos) {
        text += ".0";
    }
    add(code, text);
}

void DxfText::add(int code, const Vec3& point) {
    constexpr int kNextAxis = 10;
    for (const double x : point) {
        add(code, x);
        code += kNextAxis;
    }
}

void DxfText::addPairs(std::string_view lines) {
    LineReader reader(lines);
    while (reader.next()) {
        const std::string_view line = reader.line();
        const std::size_t blank = std::min(line.find(' '), line.size());
        text_.append(line.substr(0, blank)).append("\n");
        text_.append(line.substr(std::min(blank + 1, line.size()))).append("\n");
    }
}

}  // namespace bspline_curve

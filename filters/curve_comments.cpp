// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/curve_comments.h"

#include "text/text_parsing.h"

#include <cstddef>

namespace bspline_curve {

namespace {

constexpr std::string_view kMark = "bspline_curve ";
constexpr std::string_view kObjComment = "# ";
constexpr std::string_view kDxfComment = "999";
/// Of a line. A text of DXF R12 has at most 255.
constexpr std::size_t kMostBytes = 200;

}  // namespace

std::string asComments(CommentStyle style, std::string_view text) {
    const std::string before =
        style == CommentStyle::Obj ? std::string(kObjComment) : std::string(kDxfComment) + "\n";
    std::string lines;
    for (std::size_t i = 0; i < text.size(); i += kMostBytes) {
        lines.append(before).append(kMark).append(text.substr(i, kMostBytes)).append("\n");
    }
    return lines;
}

std::optional<std::string> textOfComments(CommentStyle style, std::string_view bytes) {
    std::optional<std::string> text;
    LineReader lines(bytes);
    bool isComment = false;
    while (lines.next()) {
        std::string_view line = trimmed(lines.line());
        if (style == CommentStyle::Obj) {
            isComment = line.starts_with(kObjComment);
            line.remove_prefix(isComment ? kObjComment.size() : 0);
        }
        if (isComment && line.starts_with(kMark)) {
            text = text.value_or("").append(line.substr(kMark.size()));
        }
        isComment = style == CommentStyle::Dxf && line == kDxfComment;
    }
    return text;
}

}  // namespace bspline_curve

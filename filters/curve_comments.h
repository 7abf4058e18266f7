// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

// What the formats of polylines cannot say of a curve, as comments that other programs pass over.
namespace bspline_curve {

/// A format's lines of comments.
enum class CommentStyle {
    Obj,  ///< lines "# bspline_curve …"
    Dxf,  ///< groups 999 "bspline_curve …"
};

/// A text without blanks and line ends as comments, with a few hundred bytes a line, to stand at
/// the beginning of a file.
[[nodiscard]] std::string asComments(CommentStyle style, std::string_view text);

/// The text of the comments in a file; none where there are none.
[[nodiscard]] std::optional<std::string> textOfComments(CommentStyle style, std::string_view bytes);

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace bspline_curve {

/// Takes the numbers, flags and words of attributes of SVG, in which blanks and one comma part
/// numbers, or nothing where they can be told apart: "1-2.5.5" is 1, -2.5 and 0.5.
class NumberScanner {
public:
    explicit NumberScanner(std::string_view text) : text_(text) {}

    void skipBlanks();
    /// Blanks, and a comma among them.
    void skipSeparators();

    [[nodiscard]] bool atEnd() const { return at_ == text_.size(); }

    /// The next character, not taken; 0 at the end.
    [[nodiscard]] char peek() const { return atEnd() ? '\0' : text_[at_]; }

    char take() { return text_[at_++]; }

    /// Letters.
    [[nodiscard]] std::string_view word();
    /// A finite number, after separators. Throws std::invalid_argument.
    [[nodiscard]] double number();
    /// "0" or "1", after separators. Throws std::invalid_argument.
    [[nodiscard]] bool flag();
    /// Whether a number follows, after separators.
    [[nodiscard]] bool hasNumber();
    /// Throws std::invalid_argument: "<reason> at character 7".
    [[noreturn]] void refuse(const std::string& reason) const;

private:
    std::string_view text_;
    std::size_t at_ = 0;
};

}  // namespace bspline_curve

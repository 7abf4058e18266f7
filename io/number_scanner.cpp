// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/number_scanner.h"

#include "text/text_parsing.h"

#include <cmath>
#include <stdexcept>

namespace bspline_curve {

namespace {

bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

bool isLetter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool isBlank(char c) {
    return c == ' ' || (c >= '\t' && c <= '\r');
}

}  // namespace

void NumberScanner::refuse(const std::string& reason) const {
    std::string message = reason;
    message += " at character ";
    message += std::to_string(at_ + 1);
    throw std::invalid_argument(message);
}

void NumberScanner::skipBlanks() {
    while (isBlank(peek())) {
        ++at_;
    }
}

void NumberScanner::skipSeparators() {
    skipBlanks();
    if (peek() == ',') {
        ++at_;
        skipBlanks();
    }
}

std::string_view NumberScanner::word() {
    const std::size_t first = at_;
    while (isLetter(peek())) {
        ++at_;
    }
    return text_.substr(first, at_ - first);
}

bool NumberScanner::hasNumber() {
    skipSeparators();
    const char c = peek();
    return isDigit(c) || c == '-' || c == '+' || c == '.';
}

double NumberScanner::number() {
    skipSeparators();
    std::size_t end = at_;
    const auto next = [&] { return end < text_.size() ? text_[end] : '\0'; };
    const auto passDigits = [&] {
        while (isDigit(next())) {
            ++end;
        }
    };
    const bool hasPlus = next() == '+';
    end += next() == '-' || hasPlus ? 1 : 0;
    passDigits();
    if (next() == '.') {
        ++end;
        passDigits();
    }
    if (next() == 'e' || next() == 'E') {
        // Not the unit em.
        std::size_t exponent = end + 1;
        if (exponent < text_.size() && (text_[exponent] == '-' || text_[exponent] == '+')) {
            ++exponent;
        }
        if (exponent < text_.size() && isDigit(text_[exponent])) {
            end = exponent;
            passDigits();
        }
    }
    const std::size_t first = at_ + (hasPlus ? 1 : 0);
    const std::optional<double> value = parseNumber(text_.substr(first, end - first));
    if (!value || !std::isfinite(*value)) {
        refuse("there is no number");
    }
    at_ = end;
    return *value;
}

bool NumberScanner::flag() {
    skipSeparators();
    if (peek() != '0' && peek() != '1') {
        refuse("there is no flag 0 or 1");
    }
    return take() == '1';
}

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/text_parsing.h"

#include "bspline_curve/error.h"

#include <algorithm>
#include <charconv>
#include <memory>
#include <system_error>

namespace bspline_curve {

namespace {

constexpr std::string_view kBlanks = " \t\r\n";

template <class Number>
std::optional<Number> parseWhole(std::string_view token) {
    if (token.size() > 1 && token.front() == '+' && token[1] != '-') {
        token.remove_prefix(1);
    }
    Number value{};
    const char* const begin = std::to_address(token.begin());
    const char* const end = begin + token.size();
    const auto [stop, error] = std::from_chars(begin, end, value);
    if (error != std::errc() || stop != end) {
        return std::nullopt;
    }
    return value;
}

char lowerCaseCharacter(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

}  // namespace

void refuseFile(const std::filesystem::path& file, const std::string& reason) {
    throw InputError(InputErrorCode::UnreadableFile, file.string() + ": " + reason);
}

void refuseLine(const std::filesystem::path& file, std::size_t line, const std::string& reason) {
    throw InputError(
        InputErrorCode::UnreadableFile,
        file.string() + ", line " + std::to_string(line) + ": " + reason
    );
}

void refuseWriting(const std::filesystem::path& file, const std::string& reason) {
    throw InputError(InputErrorCode::UnwritableFile, file.string() + ": " + reason);
}

void refuseErrno(const std::filesystem::path& file) {
    refuseWriting(file, "cannot be written: " + std::generic_category().message(errno));
}

std::string readWholeFile(const std::filesystem::path& file) {
    std::optional<std::string> bytes = readWholeFileIfThere(file);
    if (!bytes) {
        refuseFile(file, "there is no such file");
    }
    return *std::move(bytes);
}

std::string lowerCase(std::string_view text) {
    std::string result(text);
    std::ranges::transform(result, result.begin(), lowerCaseCharacter);
    return result;
}

std::string lowerCaseExtension(const std::filesystem::path& file) {
    return lowerCase(file.extension().string());
}

std::optional<double> parseNumber(std::string_view token) {
    return parseWhole<double>(token);
}

std::optional<float> parseFloat(std::string_view token) {
    if (const auto number = parseWhole<float>(token)) {
        return number;
    }
    const auto wide = parseNumber(token);  // beyond the range of floats: 0 or infinite
    return wide ? std::optional(static_cast<float>(*wide)) : std::nullopt;
}

std::optional<long long> parseInteger(std::string_view token) {
    return parseWhole<long long>(token);
}

std::string_view withoutTrailingZeros(std::string_view text) {
    const std::size_t last = text.find_last_not_of('\0');
    return text.substr(0, last == std::string_view::npos ? 0 : last + 1);
}

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(kBlanks);
    if (first == std::string_view::npos) {
        return {};
    }
    return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

std::vector<std::string_view> splitAtBlanks(std::string_view text) {
    std::vector<std::string_view> words;
    std::size_t at = text.find_first_not_of(kBlanks);
    while (at != std::string_view::npos) {
        const std::size_t end = std::min(text.find_first_of(kBlanks, at), text.size());
        words.push_back(text.substr(at, end - at));
        at = text.find_first_not_of(kBlanks, end);
    }
    return words;
}

std::vector<std::string_view> splitAt(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    std::size_t at = 0;
    for (;;) {
        const std::size_t end = text.find(separator, at);
        parts.push_back(trimmed(text.substr(at, end - at)));
        if (end == std::string_view::npos) {
            return parts;
        }
        at = end + 1;
    }
}

std::string inQuotes(std::string_view token) {
    constexpr std::size_t kLongest = 40;
    std::string result = "\"";
    for (const char c : token.substr(0, kLongest)) {
        result += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
    }
    return result + (token.size() > kLongest ? "…\"" : "\"");
}

std::string_view withoutByteOrderMark(std::string_view text) {
    constexpr std::string_view kMark = "\xEF\xBB\xBF";
    return text.starts_with(kMark) ? text.substr(kMark.size()) : text;
}

LineReader::LineReader(std::string_view text) : rest_(withoutByteOrderMark(text)) {}

bool LineReader::next() {
    if (rest_.empty()) {
        return false;
    }
    const std::size_t end = rest_.find('\n');
    line_ = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    if (line_.ends_with('\r')) {
        line_.remove_suffix(1);
    }
    ++number_;
    return true;
}

}  // namespace bspline_curve

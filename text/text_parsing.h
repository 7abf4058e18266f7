// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace bspline_curve {

/// Throws InputError (UnreadableFile) that reads "<file>: <reason>".
[[noreturn]] void refuseFile(const std::filesystem::path& file, const std::string& reason);
/// The same with the line, counted from 1: "<file>, line 3: <reason>".
[[noreturn]] void refuseLine(
    const std::filesystem::path& file, std::size_t line, const std::string& reason
);
/// Throws InputError (UnwritableFile) that reads "<file>: <reason>".
[[noreturn]] void refuseWriting(const std::filesystem::path& file, const std::string& reason);
/// The same with what errno says.
[[noreturn]] void refuseErrno(const std::filesystem::path& file);

/// All bytes of a file. Throws InputError (UnreadableFile) where it is missing, a directory, not
/// readable or empty.
[[nodiscard]] std::string readWholeFile(const std::filesystem::path& file);

/// The same; nothing where there is no such file, also where another process deletes it meanwhile.
[[nodiscard]] std::optional<std::string> readWholeFileIfThere(const std::filesystem::path& file);

/// Whether a name means standard input or output: "-.ply", which holds what a .ply file would.
/// Files of that name are "./-.ply".
[[nodiscard]] bool isStandardStream(const std::filesystem::path& file);

/// The extension in lower case, with its dot: ".ply".
[[nodiscard]] std::string lowerCaseExtension(const std::filesystem::path& file);
[[nodiscard]] std::string lowerCase(std::string_view text);

/// A number that fills the whole token, whatever the locale; "nan" and "inf" are numbers here.
[[nodiscard]] std::optional<double> parseNumber(std::string_view token);
/// The same, rounded once, to a float.
[[nodiscard]] std::optional<float> parseFloat(std::string_view token);
[[nodiscard]] std::optional<long long> parseInteger(std::string_view token);

/// Without the zero bytes at the end, which some programs leave.
[[nodiscard]] std::string_view withoutTrailingZeros(std::string_view text);
/// Without blanks at both ends (a carriage return is a blank).
[[nodiscard]] std::string_view trimmed(std::string_view text);
/// The words between blanks.
[[nodiscard]] std::vector<std::string_view> splitAtBlanks(std::string_view text);
/// The trimmed parts between separators, empty ones included.
[[nodiscard]] std::vector<std::string_view> splitAt(std::string_view text, char separator);
/// Without the three bytes with which some programs begin a file in UTF-8.
[[nodiscard]] std::string_view withoutByteOrderMark(std::string_view text);
/// A token in quotes for a message, cut where it is long and without control characters.
[[nodiscard]] std::string inQuotes(std::string_view token);

/// Takes the lines of a text one by one, without their line ends.
class LineReader {
public:
    /// A byte order mark at the start is skipped. The text must outlive the reader.
    explicit LineReader(std::string_view text);

    /// Moves to the next line; false at the end.
    bool next();

    [[nodiscard]] std::string_view line() const { return line_; }

    /// Number of the current line, from 1.
    [[nodiscard]] std::size_t number() const { return number_; }

private:
    std::string_view rest_;
    std::string_view line_;
    std::size_t number_ = 0;
};

}  // namespace bspline_curve

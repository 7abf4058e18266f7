// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/csv.h"

#include "text/text_parsing.h"

#include <algorithm>

namespace bspline_curve {

namespace {

using std::filesystem::path;

char separatorOf(std::string_view line) {
    if (line.find(';') != std::string_view::npos) {
        return ';';
    }
    return line.find('\t') != std::string_view::npos ? '\t' : ',';
}

/// Takes a text apart, character by character.
class CsvParser {
public:
    CsvParser(const path& file, std::string_view text) : file_(file), text_(text) {}

    CsvTable run() {
        CsvTable table;
        while (at_ < text_.size()) {
            const std::string_view line = trimmed(restOfLine());
            if (line.empty() || line.front() == '#') {
                skipLine();
                continue;
            }
            if (table.records.empty()) {
                table.separator = separator_ = separatorOf(line);
            }
            table.records.push_back(record());
        }
        return table;
    }

private:
    [[nodiscard]] std::string_view restOfLine() const {
        return text_.substr(at_, text_.find('\n', at_) - at_);
    }

    void skipLine() {
        at_ = std::min(text_.find('\n', at_), text_.size() - 1) + 1;
        ++line_;
    }

    CsvRecord record() {
        CsvRecord result{.line = line_, .fields = {}};
        for (;;) {
            result.fields.push_back(field());
            const bool isEnd = at_ >= text_.size() || text_[at_] == '\n';
            if (isEnd) {
                if (at_ < text_.size()) {
                    skipLine();
                }
                return result;
            }
            ++at_;  // the separator
        }
    }

    /// Moves to the separator or the line end behind the field.
    std::string field() {
        while (at_ < text_.size() && text_[at_] != separator_ &&
               (text_[at_] == ' ' || text_[at_] == '\t' || text_[at_] == '\r')) {
            ++at_;
        }
        return at_ < text_.size() && text_[at_] == '"' ? quotedField() : plainField();
    }

    std::string plainField() {
        const std::string_view rest = restOfLine();
        const std::string_view text = rest.substr(0, rest.find(separator_));
        at_ += text.size();
        return std::string(trimmed(text));
    }

    std::string quotedField() {
        const std::size_t start = line_;
        std::string text;
        for (++at_; at_ < text_.size(); ++at_) {
            const char c = text_[at_];
            if (c == '"') {
                const bool isDoubled = at_ + 1 < text_.size() && text_[at_ + 1] == '"';
                if (!isDoubled) {
                    ++at_;
                    refuseTextBehindQuotes();
                    return text;
                }
                ++at_;
            }
            line_ += c == '\n' ? 1 : 0;
            text += c;
        }
        refuseLine(file_, start, "a quote is opened and not closed");
    }

    void refuseTextBehindQuotes() {
        if (const std::string behind = plainField(); !behind.empty()) {
            refuseLine(file_, line_, inQuotes(behind) + " stands behind a closing quote");
        }
    }

    const path& file_;
    std::string_view text_;
    std::size_t at_ = 0;
    std::size_t line_ = 1;
    char separator_ = ',';
};

bool needsQuotes(std::string_view field) {
    return field.find_first_of(",\"\r\n") != std::string_view::npos || field.starts_with('#') ||
           trimmed(field).size() != field.size();
}

}  // namespace

CsvTable parseCsv(const path& file, std::string_view bytes) {
    return CsvParser(file, withoutByteOrderMark(bytes)).run();
}

std::string csvLine(std::span<const std::string> fields) {
    std::string line;
    for (const std::string& field : fields) {
        line += &field == fields.data() ? "" : ",";
        if (!needsQuotes(field)) {
            line += field;
            continue;
        }
        line += '"';
        for (const char c : field) {
            line.append(c == '"' ? 2 : 1, c);
        }
        line += '"';
    }
    return line + '\n';
}

}  // namespace bspline_curve

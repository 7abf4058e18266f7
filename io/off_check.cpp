// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/file_checks.h"
#include "io/text_parsing.h"

#include <vector>

namespace bspline_curve {

namespace {

using Words = std::vector<std::string_view>;

/// Reads an OFF file line by line and writes it out plainly.
class OffCheck {
public:
    OffCheck(const std::filesystem::path& file, std::string_view bytes)
        : file_(file), lines_(bytes) {}

    CheckedOff run() {
        readHeader();
        for (std::size_t i = 0; i < vertices_; ++i) {
            readVertex();
        }
        for (std::size_t i = 0; i < faces_; ++i) {
            readFace();
        }
        CheckedOff result;
        result.expected.vertices = vertices_;
        result.expected.triangles = triangles_;
        result.text =
            "OFF\n" + std::to_string(vertices_) + ' ' + std::to_string(facesOut_) + " 0\n" + body_;
        return result;
    }

private:
    /// The words of the next line that has any, comments removed.
    Words nextWords(const char* wanted) {
        while (lines_.next()) {
            const std::string_view line = lines_.line();
            Words words = splitAtBlanks(line.substr(0, line.find('#')));
            if (!words.empty()) {
                return words;
            }
        }
        refuseFile(file_, std::string("the file ends where ") + wanted + " should be");
    }

    void readHeader() {
        Words words = nextWords("the word OFF");
        const std::string_view keyword = words[0];
        if (!keyword.ends_with("OFF")) {
            refuseFile(file_, "does not start with the word OFF");
        }
        if (keyword.find_first_of("4n") != std::string_view::npos) {
            refuseFile(file_, inQuotes(keyword) + " vertices have no three plain coordinates");
        }
        words.erase(words.begin());
        if (!words.empty() && words[0] == "BINARY") {
            refuseFile(file_, "binary OFF is not supported");
        }
        if (words.empty()) {
            words = nextWords("the counts of vertices and faces");
        }
        if (words.size() < 2) {
            refuse("expected the counts of vertices, faces and edges");
        }
        vertices_ = count(words[0]);
        faces_ = count(words[1]);
    }

    [[nodiscard]] std::size_t count(std::string_view word) const {
        const auto value = parseInteger(word);
        if (!value || *value < 0 || *value > 0x7fffffff) {
            refuse(inQuotes(word) + " is not a count");
        }
        return static_cast<std::size_t>(*value);
    }

    /// The position is first on the line, whatever follows it.
    void readVertex() {
        const Words words = nextWords("a vertex");
        if (words.size() < 3) {
            refuse("a vertex needs three coordinates on one line");
        }
        for (std::size_t k = 0; k < 3; ++k) {
            if (!parseNumber(words[k])) {
                refuse(inQuotes(words[k]) + " is not a number");
            }
            append(words[k], k < 2 ? ' ' : '\n');
        }
    }

    void readFace() {
        Words words = nextWords("a face");
        const std::size_t corners = count(words[0]);
        if (words.size() == 1) {  // the indices are on a line of their own
            const Words indices = nextWords("a face's indices");
            words.insert(words.end(), indices.begin(), indices.end());
        }
        if (corners < 3 || words.size() - 1 < corners) {
            refuse(
                "a face of " + std::to_string(corners) + " corners with " +
                std::to_string(words.size() - 1) + " indices"
            );
        }
        for (std::size_t k = 1; k <= corners; ++k) {
            if (count(words[k]) >= vertices_) {
                refuse(
                    "the face names vertex " + std::string(words[k]) + " of " +
                    std::to_string(vertices_) + ", counted from 0"
                );
            }
        }
        words.resize(corners + 1);
        triangles_ += corners - 2;
        writeFace(words);
    }

    void writeFace(const Words& words) {
        if (words.size() <= 5) {
            for (std::size_t k = 0; k < words.size(); ++k) {
                append(words[k], k + 1 < words.size() ? ' ' : '\n');
            }
            ++facesOut_;
            return;
        }
        for (std::size_t k = 2; k + 1 < words.size(); ++k) {
            append("3", ' ');
            append(words[1], ' ');
            append(words[k], ' ');
            append(words[k + 1], '\n');
            ++facesOut_;
        }
    }

    void append(std::string_view word, char separator) {
        body_ += word;
        body_ += separator;
    }

    [[noreturn]] void refuse(const std::string& reason) const {
        refuseLine(file_, lines_.number(), reason);
    }

    const std::filesystem::path& file_;
    LineReader lines_;
    std::size_t vertices_ = 0, faces_ = 0, facesOut_ = 0, triangles_ = 0;
    std::string body_;
};

}  // namespace

CheckedOff checkOff(const std::filesystem::path& file, std::string_view bytes) {
    return OffCheck(file, bytes).run();
}

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/mesh_parsers.h"
#include "text/text_parsing.h"

#include <utility>
#include <vector>

namespace bspline_curve {

namespace {

using Words = std::vector<std::string_view>;

/// Reads an OFF file line by line.
class OffParser {
public:
    OffParser(const std::filesystem::path& file, std::string_view bytes)
        : file_(file), lines_(bytes) {}

    ParsedMesh run() {
        readHeader();
        for (std::size_t i = 0; i < vertices_; ++i) {
            readVertex();
        }
        for (std::size_t i = 0; i < faces_; ++i) {
            readFace();
        }
        return std::move(parsed_);
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
        Vec3 point;
        for (int k = 0; k < 3; ++k) {
            const auto number = parseNumber(words[k]);
            if (!number) {
                refuse(inQuotes(words[k]) + " is not a number");
            }
            point[k] = *number;
        }
        parsed_.mesh.vertices.push_back(point);
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
        corners_.clear();
        for (std::size_t k = 1; k <= corners; ++k) {
            const std::size_t id = count(words[k]);
            if (id >= vertices_) {
                refuse(
                    "the face names vertex " + std::string(words[k]) + " of " +
                    std::to_string(vertices_) + ", counted from 0"
                );
            }
            corners_.push_back(static_cast<int>(id));
        }
        addPolygon(corners_, parsed_.mesh.vertices, parsed_.mesh.faces);
    }

    [[noreturn]] void refuse(const std::string& reason) const {
        refuseLine(file_, lines_.number(), reason);
    }

    const std::filesystem::path& file_;
    LineReader lines_;
    std::size_t vertices_ = 0, faces_ = 0;
    std::vector<int> corners_;
    ParsedMesh parsed_;
};

}  // namespace

ParsedMesh parseOff(const std::filesystem::path& file, std::string_view bytes) {
    return OffParser(file, bytes).run();
}

}  // namespace bspline_curve

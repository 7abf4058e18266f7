// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/mesh_parsers.h"
#include "io/obj_lines.h"
#include "text/text_parsing.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace bspline_curve {

namespace {

using Words = std::vector<std::string_view>;

/// Reads an OBJ file statement by statement.
class ObjParser {
public:
    ObjParser(const std::filesystem::path& file, std::string_view bytes)
        : file_(file), lines_(withoutTrailingZeros(bytes)) {}

    ParsedMesh run() {
        while (lines_.next()) {
            readLine(wholeLine());
        }
        if (vertices().empty()) {
            refuseFile(file_, "has no vertices; is it an OBJ mesh?");
        }
        if (std::cmp_greater(highestLineIndex_, vertices().size())) {
            refuseFile(
                file_,
                "a line element names vertex " + std::to_string(highestLineIndex_) + " of " +
                    std::to_string(vertices().size())
            );
        }
        if (zbrushColours_ > 0 && zbrushColours_ < vertices().size()) {
            refuseFile(file_, "has fewer #MRGB colours than vertices");
        }
        return std::move(parsed_);
    }

private:
    std::vector<Vec3>& vertices() { return parsed_.mesh.vertices; }

    std::string_view wholeLine() {
        return wholeObjLine(
            lines_,
            joined_,
            [this] { refuseZeroByte(); },
            [this](const char* reason) { refuse(reason); }
        );
    }

    void refuseZeroByte() const {
        if (lines_.line().find('\0') != std::string_view::npos) {
            refuse("holds a zero byte; is it a text?");
        }
    }

    void readLine(std::string_view line) {
        if (line.starts_with("#MRGB")) {
            zbrushColours_ += (line.size() - std::min<std::size_t>(line.size(), 6)) / 8;
        }
        if (line.empty() || line.front() == '#') {
            return;
        }
        const Words words = splitAtBlanks(line);
        if (words.empty()) {
            return;
        }
        const std::string_view keyword = words[0];
        const bool isGeometry =
            keyword == "v" || keyword == "f" || keyword == "q" || keyword == "l";
        // Some programs, vcglib among them, overlook other statements.
        const std::size_t after = keyword.size();
        if (isGeometry && (line.front() != keyword.front() ||
                           (after < line.size() && line[after] != ' ' && line[after] != '\t'))) {
            refuse("a statement must start at the beginning of its line, and a blank follow it");
        }
        if (keyword == "v") {
            readVertex(words);
        } else if (keyword == "f" || keyword == "q") {
            readFace(words, keyword == "q");
        } else if (keyword == "l") {
            checkLineElement(words);
        }
    }

    void readVertex(const Words& words) {
        if (words.size() < 4) {
            refuse("a vertex needs three coordinates");
        }
        Vec3 point;
        for (int k = 0; k < 3; ++k) {
            const auto number = parseNumber(words[k + 1]);
            if (!number) {
                refuse(inQuotes(words[k + 1]) + " is not a number");
            }
            point[k] = *number;
        }
        vertices().push_back(point);
    }

    /// `fromZero`: the statement "q" of QOBJ files counts vertices from 0.
    void readFace(const Words& words, bool fromZero) {
        const std::size_t corners = words.size() - 1;
        if (corners < 3 || (fromZero && corners != 4)) {
            refuse("a face with " + std::to_string(corners) + " corners");
        }
        corners_.clear();
        for (std::size_t k = 1; k < words.size(); ++k) {
            corners_.push_back(vertexId(words[k], fromZero));
        }
        addPolygon(corners_, vertices(), parsed_.mesh.faces);
        if (sortAndFindRepeated(corners_)) {
            parsed_.repeating.push_back(faces_);
        }
        ++faces_;
    }

    int vertexId(std::string_view corner, bool fromZero) {
        const auto index = parseInteger(corner.substr(0, corner.find('/')));
        if (!index || (!fromZero && *index == 0)) {
            refuse(inQuotes(corner) + " is not a vertex index");
        }
        const auto known = static_cast<long long>(vertices().size());
        long long id = *index;  // from 0, as QOBJ counts
        if (!fromZero) {
            id = *index > 0 ? *index - 1 : known + *index;
        }
        if (id < 0 || id >= known) {
            refuse(
                "the face names vertex " + std::to_string(*index) + ", but " +
                std::to_string(known) + " are defined before it"
            );
        }
        return static_cast<int>(id);
    }

    void checkLineElement(const Words& words) {
        // The first two are what programs make an edge of.
        for (std::size_t k = 1; k < std::min<std::size_t>(words.size(), 3); ++k) {
            const auto index = parseInteger(words[k].substr(0, words[k].find('/')));
            if (!index || *index < 1) {
                refuse(inQuotes(words[k]) + " is not a vertex index that a line element may have");
            }
            highestLineIndex_ = std::max(highestLineIndex_, *index);
        }
    }

    [[noreturn]] void refuse(const std::string& reason) const {
        refuseLine(file_, lines_.number(), reason);
    }

    const std::filesystem::path& file_;
    LineReader lines_;
    std::string joined_;  // of the current line, where it is more than one
    ParsedMesh parsed_;
    std::vector<int> corners_;
    std::int64_t faces_ = 0;
    long long highestLineIndex_ = 0;
    std::size_t zbrushColours_ = 0;
};

}  // namespace

ParsedMesh parseObj(const std::filesystem::path& file, std::string_view bytes) {
    return ObjParser(file, bytes).run();
}

}  // namespace bspline_curve

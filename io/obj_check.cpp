// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/file_checks.h"
#include "io/text_parsing.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace bspline_curve {

namespace {

using Words = std::vector<std::string_view>;

/// Looks through an OBJ file statement by statement.
class ObjCheck {
public:
    ObjCheck(const std::filesystem::path& file, std::string_view bytes)
        : file_(file), lines_(bytes) {}

    ExpectedMesh run() {
        while (lines_.next()) {
            if (lines_.line().find('\0') != std::string_view::npos) {
                refuse("holds a zero byte; is it a text?");
            }
            checkLine(lines_.line());
        }
        if (expected_.vertices == 0) {
            refuseFile(file_, "has no vertices; is it an OBJ mesh?");
        }
        if (std::cmp_greater(highestLineIndex_, expected_.vertices)) {
            refuseFile(
                file_,
                "a line element names vertex " + std::to_string(highestLineIndex_) + " of " +
                    std::to_string(expected_.vertices)
            );
        }
        // vcglib takes as many of these colours as there are vertices.
        if (zbrushColours_ > 0 && zbrushColours_ < expected_.vertices) {
            refuseFile(file_, "has fewer #MRGB colours than vertices");
        }
        return expected_;
    }

private:
    void checkLine(std::string_view line) {
        if (line.starts_with("#MRGB")) {
            zbrushColours_ += (line.size() - std::min<std::size_t>(line.size(), 6)) / 8;
        }
        if (line.empty() || line.front() == '#') {
            return;
        }
        if (line.ends_with('\\')) {
            refuse("lines continued with a backslash are not supported");
        }
        const Words words = splitAtBlanks(line);
        if (words.empty()) {
            return;
        }
        const std::string_view keyword = words[0];
        const bool isGeometry =
            keyword == "v" || keyword == "f" || keyword == "q" || keyword == "l";
        // vcglib counts the statements by a stricter rule than it reads them by.
        const std::size_t after = keyword.size();
        if (isGeometry && (line.front() != keyword.front() ||
                           (after < line.size() && line[after] != ' ' && line[after] != '\t'))) {
            refuse("a statement must start at the beginning of its line, and a blank follow it");
        }
        if (keyword == "v") {
            checkVertex(words);
        } else if (keyword == "f" || keyword == "q") {
            checkFace(words, keyword == "q");
        } else if (keyword == "l") {
            checkLineElement(words);
        }
    }

    void checkVertex(const Words& words) {
        if (words.size() < 4) {
            refuse("a vertex needs three coordinates");
        }
        for (std::size_t k = 1; k < 4; ++k) {
            if (!parseNumber(words[k])) {
                refuse(inQuotes(words[k]) + " is not a number");
            }
        }
        ++expected_.vertices;
    }

    /// `fromZero`: the statement "q" of QOBJ files counts vertices from 0.
    void checkFace(const Words& words, bool fromZero) {
        const std::size_t corners = words.size() - 1;
        if (corners < 3 || (fromZero && corners != 4)) {
            refuse("a face with " + std::to_string(corners) + " corners");
        }
        std::vector<long long> ids;
        for (std::size_t k = 1; k < words.size(); ++k) {
            ids.push_back(vertexId(words[k], fromZero));
        }
        expectFan(ids);
        std::ranges::sort(ids);
        if (std::ranges::adjacent_find(ids) != ids.end()) {
            expected_.repeating.push_back(faces_);
        }
        ++faces_;
    }

    /// vcglib leaves out those triangles of a fan that repeat a vertex.
    void expectFan(const std::vector<long long>& ids) {
        for (std::size_t k = 1; k + 1 < ids.size(); ++k) {
            const Triangle fan = {
                static_cast<int>(ids[0]), static_cast<int>(ids[k]), static_cast<int>(ids[k + 1])
            };
            if (fan[0] == fan[1] || fan[1] == fan[2] || fan[2] == fan[0]) {
                expected_.omitted.push_back({expected_.triangles, fan});
            }
            ++expected_.triangles;
        }
    }

    long long vertexId(std::string_view corner, bool fromZero) {
        const auto index = parseInteger(corner.substr(0, corner.find('/')));
        if (!index || (!fromZero && *index == 0)) {
            refuse(inQuotes(corner) + " is not a vertex index");
        }
        const auto known = static_cast<long long>(expected_.vertices);
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
        return id;
    }

    void checkLineElement(const Words& words) {
        // vcglib reads the first two indices.
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
    ExpectedMesh expected_;
    std::int64_t faces_ = 0;
    long long highestLineIndex_ = 0;
    std::size_t zbrushColours_ = 0;
};

}  // namespace

ExpectedMesh checkObj(const std::filesystem::path& file, std::string_view bytes) {
    return ObjCheck(file, bytes).run();
}

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/picks_reader.h"

#include "io/text_parsing.h"
#include "surface/input_error.h"

#include <nlohmann/json.hpp>
#include <tinyxml2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace bspline_curve {

namespace {

using std::filesystem::path;
using Words = std::vector<std::string_view>;

/// A coordinate of a file must be a finite number.
double coordinate(const path& file, std::size_t line, std::string_view word) {
    const auto value = parseNumber(word);
    if (!value || !std::isfinite(*value)) {
        refuseLine(file, line, inQuotes(word) + " is not a finite number");
    }
    return *value;
}

// ---------------------------------------------------------------- .pp

Vec3 pickOfElement(const path& file, const tinyxml2::XMLElement& element) {
    const auto line = static_cast<std::size_t>(element.GetLineNum());
    Vec3 pick;
    for (const auto& [name, k] : {std::pair{"x", 0}, {"y", 1}, {"z", 2}}) {
        const char* const text = element.Attribute(name);
        if (text == nullptr) {
            refuseLine(file, line, std::string("the point has no ") + name);
        }
        pick[k] = coordinate(file, line, trimmed(text));
    }
    return pick;
}

PicksFile readPickPoints(const path& file, const std::string& bytes) {
    tinyxml2::XMLDocument document;
    if (document.Parse(bytes.data(), bytes.size()) != tinyxml2::XML_SUCCESS) {
        const auto line = static_cast<std::size_t>(std::max(document.ErrorLineNum(), 1));
        refuseLine(file, line, std::string("is not XML (") + document.ErrorName() + ")");
    }
    const tinyxml2::XMLElement* const root = document.RootElement();
    if (root == nullptr || std::string_view(root->Name()) != "PickedPoints") {
        refuseFile(file, "is not a PickPoints file (no <PickedPoints>)");
    }
    PicksFile result;
    for (const auto* element = root->FirstChildElement("point"); element != nullptr;
         element = element->NextSiblingElement("point")) {
        const char* const active = element->Attribute("active");
        if (active == nullptr || std::string_view(active) != "0") {
            result.picks.push_back(pickOfElement(file, *element));
        }
    }
    return result;
}

// ---------------------------------------------------------------- .json

Vec3 pickOfJson(const path& file, const nlohmann::json& value, std::size_t index) {
    const bool isPoint =
        value.is_array() && value.size() == 3 &&
        std::ranges::all_of(value, [](const nlohmann::json& x) { return x.is_number(); });
    if (!isPoint) {
        refuseFile(
            file,
            "pick " + std::to_string(index) + " is not [x, y, z] but " + inQuotes(value.dump())
        );
    }
    const Vec3 pick(value[0].get<double>(), value[1].get<double>(), value[2].get<double>());
    if (!pick.allFinite()) {
        refuseFile(file, "pick " + std::to_string(index) + " is not finite");
    }
    return pick;
}

nlohmann::json parseJson(const path& file, const std::string& bytes) {
    try {
        return nlohmann::json::parse(bytes);
    } catch (const nlohmann::json::exception& error) {
        // "[json.exception.parse_error.101] parse error at line 1, column 2: …"
        const std::string text = error.what();
        const std::size_t end = text.find("] ");
        refuseFile(
            file, "is not JSON: " + (end == std::string::npos ? text : text.substr(end + 2))
        );
    }
}

PicksFile readJson(const path& file, const std::string& bytes) {
    const nlohmann::json document = parseJson(file, bytes);
    if (!document.is_object() || !document.contains("picks") || !document["picks"].is_array()) {
        refuseFile(file, R"(needs {"picks": [[x, y, z], …]})");
    }
    PicksFile result;
    for (const nlohmann::json& value : document["picks"]) {
        result.picks.push_back(pickOfJson(file, value, result.picks.size()));
    }
    if (document.contains("closed")) {
        if (!document["closed"].is_boolean()) {
            refuseFile(file, R"("closed" must be true or false)");
        }
        result.closed = document["closed"].get<bool>();
    }
    return result;
}

// ---------------------------------------------------------------- .xyz, .csv

PicksFile readXyz(const path& file, const std::string& bytes) {
    PicksFile result;
    LineReader lines(bytes);
    while (lines.next()) {
        const Words words = splitAtBlanks(lines.line().substr(0, lines.line().find('#')));
        if (words.empty()) {
            continue;
        }
        if (words.size() < 3) {
            refuseLine(file, lines.number(), "a pick needs three coordinates");
        }
        Vec3 pick;
        for (std::size_t k = 0; k < 3; ++k) {
            pick[static_cast<Eigen::Index>(k)] = coordinate(file, lines.number(), words[k]);
        }
        result.picks.push_back(pick);
    }
    return result;
}

std::string_view withoutQuotes(std::string_view word) {
    const bool isQuoted = word.size() >= 2 && word.front() == '"' && word.back() == '"';
    return isQuoted ? trimmed(word.substr(1, word.size() - 2)) : word;
}

class CsvReader {
public:
    CsvReader(const path& file, std::string_view bytes) : file_(file), lines_(bytes) {}

    PicksFile run() {
        PicksFile result;
        bool isFirst = true;
        while (lines_.next()) {
            const std::string_view line = trimmed(lines_.line());
            if (line.empty() || line.front() == '#') {
                continue;
            }
            if (isFirst) {
                isFirst = false;
                chooseSeparator(line);
                if (takeHeader(line)) {
                    continue;
                }
            }
            result.picks.push_back(pickOfLine(line));
        }
        return result;
    }

private:
    void chooseSeparator(std::string_view line) {
        if (line.find(';') != std::string_view::npos) {
            separator_ = ';';
        } else if (line.find('\t') != std::string_view::npos) {
            separator_ = '\t';
        }
    }

    /// A first line with a word that is no number is a header.
    bool takeHeader(std::string_view line) {
        const Words words = splitAt(line, separator_);
        if (std::ranges::all_of(words, [&](std::string_view word) {
                return number(word).has_value();
            })) {
            return false;
        }
        std::vector<std::string> names;
        for (const std::string_view word : words) {
            names.push_back(lowerCase(withoutQuotes(word)));
        }
        for (std::size_t k = 0; k < 3; ++k) {
            const std::string wanted(1, "xyz"[k]);
            const auto found = std::ranges::find(names, wanted);
            if (found == names.end()) {
                refuseLine(
                    file_, lines_.number(), "the header names no column " + inQuotes(wanted)
                );
            }
            columns_[k] = static_cast<std::size_t>(found - names.begin());
        }
        return true;
    }

    Vec3 pickOfLine(std::string_view line) {
        const Words words = splitAt(line, separator_);
        Vec3 pick;
        for (std::size_t k = 0; k < 3; ++k) {
            if (columns_[k] >= words.size()) {
                refuseLine(file_, lines_.number(), "a pick needs three coordinates");
            }
            const std::string_view word = words[columns_[k]];
            const auto value = number(word);
            if (!value || !std::isfinite(*value)) {
                refuseLine(file_, lines_.number(), inQuotes(word) + " is not a finite number");
            }
            pick[static_cast<Eigen::Index>(k)] = *value;
        }
        return pick;
    }

    [[nodiscard]] std::optional<double> number(std::string_view word) const {
        std::string text(withoutQuotes(word));
        if (separator_ == ';') {
            std::ranges::replace(text, ',', '.');
        }
        return parseNumber(text);
    }

    const path& file_;
    LineReader lines_;
    char separator_ = ',';
    std::array<std::size_t, 3> columns_{0, 1, 2};
};

}  // namespace

PicksFile readPicks(const path& file) {
    const std::string extension = lowerCaseExtension(file);
    const std::array<std::string_view, 4> known{".pp", ".json", ".xyz", ".csv"};
    if (std::ranges::find(known, extension) == known.end()) {
        refuseFile(
            file, "the extension " + inQuotes(extension) + " is none of .pp, .json, .xyz, .csv"
        );
    }
    const std::string bytes = readWholeFile(file);
    PicksFile result;
    if (extension == ".pp") {
        result = readPickPoints(file, bytes);
    } else if (extension == ".json") {
        result = readJson(file, bytes);
    } else if (extension == ".xyz") {
        result = readXyz(file, bytes);
    } else {
        result = CsvReader(file, bytes).run();
    }
    if (result.picks.empty()) {
        refuseFile(file, "holds no picks");
    }
    return result;
}

std::vector<Vec3> parsePicksText(std::string_view text) {
    std::string plain(text);
    std::ranges::replace(plain, '\n', ';');
    std::ranges::replace(plain, ',', ' ');
    std::vector<Vec3> picks;
    for (const std::string_view part : splitAt(plain, ';')) {
        const Words words = splitAtBlanks(part);
        if (words.empty()) {
            continue;
        }
        const std::string name = "pick " + std::to_string(picks.size()) + ", " + inQuotes(part);
        if (words.size() != 3) {
            throw InputError(
                InputErrorCode::UnreadableFile, name + ", is not of the form \"x y z\""
            );
        }
        Vec3 pick;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto value = parseNumber(words[k]);
            if (!value || !std::isfinite(*value)) {
                throw InputError(
                    InputErrorCode::UnreadableFile,
                    name + ": " + inQuotes(words[k]) + " is not a finite number"
                );
            }
            pick[static_cast<Eigen::Index>(k)] = *value;
        }
        picks.push_back(pick);
    }
    return picks;
}

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/polyline_formats.h"
#include "io/text_parsing.h"

#include <cstddef>
#include <optional>
#include <string>
#include <utility>

namespace bspline_curve {

namespace {

class ObjLines {
public:
    ObjLines(const std::filesystem::path& file, std::string_view bytes)
        : file_(file), lines_(withoutTrailingZeros(bytes)) {}

    PolylineGraph run() {
        while (lines_.next()) {
            const std::vector<std::string_view> words = splitAtBlanks(lines_.line());
            if (words.empty()) {
                continue;
            }
            if (words.back() == "\\" && (words[0] == "v" || words[0] == "l")) {
                refuse("a statement that goes on in the next line; write it in one");
            }
            if (words[0] == "v") {
                readVertex(words);
            } else if (words[0] == "l") {
                readLine(words);
            }
        }
        return std::move(graph_);
    }

private:
    void readVertex(const std::vector<std::string_view>& words) {
        if (words.size() < 4) {
            refuse("a vertex needs three coordinates");
        }
        Vec3 point;
        for (int k = 0; k < 3; ++k) {
            const std::optional<double> number = parseNumber(words[k + 1]);
            if (!number) {
                refuse(inQuotes(words[k + 1]) + " is not a number");
            }
            point[k] = *number;
        }
        graph_.points.push_back(point);
    }

    void readLine(const std::vector<std::string_view>& words) {
        if (words.size() < 3) {
            refuse("a line element needs at least two vertices");
        }
        for (std::size_t k = 2; k < words.size(); ++k) {
            graph_.edges.push_back({vertexOf(words[k - 1]), vertexOf(words[k])});
        }
    }

    [[nodiscard]] int vertexOf(std::string_view word) const {
        const auto known = static_cast<long long>(graph_.points.size());
        const std::optional<long long> index = parseInteger(word.substr(0, word.find('/')));
        const long long id = !index ? -1 : *index > 0 ? *index - 1 : known + *index;
        if (!index || *index == 0 || id < 0 || id >= known) {
            refuse(
                inQuotes(word) + " is not the index of one of the " + std::to_string(known) +
                " vertices before it"
            );
        }
        return static_cast<int>(id);
    }

    [[noreturn]] void refuse(const std::string& reason) const {
        refuseLine(file_, lines_.number(), reason);
    }

    const std::filesystem::path& file_;
    LineReader lines_;
    PolylineGraph graph_;
};

}  // namespace

PolylineGraph polylinesOfObj(const std::filesystem::path& file, std::string_view bytes) {
    return ObjLines(file, bytes).run();
}

}  // namespace bspline_curve

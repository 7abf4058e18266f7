// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/left_out.h"
#include "io/obj_lines.h"
#include "io/polyline_formats.h"
#include "io/space_paths.h"
#include "text/text_parsing.h"

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace bspline_curve {

namespace {

class ObjLines {
public:
    ObjLines(const std::filesystem::path& file, std::string_view bytes)
        : file_(file), lines_(withoutTrailingZeros(bytes)), leftOut_(file) {}

    PolylineGraph run() {
        while (lines_.next()) {
            const std::string_view line = wholeLine();
            const std::vector<std::string_view> words = splitAtBlanks(line);
            if (!words.empty()) {
                read(words);
            }
        }
        appendSplines();
        if (graph_.edges.empty() && !leftOut_.empty()) {
            leftOut_.refuse();
        }
        if (!leftOut_.empty()) {
            graph_.notes.push_back(leftOut_.note("free-form curve", "free-form curves"));
        }
        return std::move(graph_);
    }

private:
    std::string_view wholeLine() {
        return wholeObjLine(lines_, joined_, [] {}, [this](const char* reason) { refuse(reason); });
    }

    void read(const std::vector<std::string_view>& words) {
        const std::string_view keyword = words[0];
        if (keyword == "v") {
            readVertex(words);
        } else if (keyword == "l") {
            readLine(words);
        } else if (keyword == "cstype") {
            isRational_ = words.size() > 2 && words[1] == "rat";
            isSpline_ = words.back() == "bspline";
        } else if (keyword == "deg" && words.size() > 1) {
            spline_.degree = static_cast<int>(parseInteger(words[1]).value_or(0));
        } else if (keyword == "curv") {
            beginCurve(words);
        } else if (keyword == "parm" && words.size() > 1 && words[1] == "u") {
            for (std::size_t k = 2; k < words.size(); ++k) {
                spline_.knots.push_back(numberIn(words[k]));
            }
        } else if (keyword == "end" && isInCurve_) {
            endCurve();
        }
    }

    [[nodiscard]] double numberIn(std::string_view word) const {
        const std::optional<double> number = parseNumber(word);
        if (!number) {
            refuse(inQuotes(word) + " is not a number");
        }
        return *number;
    }

    void readVertex(const std::vector<std::string_view>& words) {
        if (words.size() < 4) {
            refuse("a vertex needs three coordinates");
        }
        graph_.points.emplace_back(numberIn(words[1]), numberIn(words[2]), numberIn(words[3]));
        weights_.push_back(words.size() == 5 ? numberIn(words[4]) : 1.0);
    }

    void beginCurve(const std::vector<std::string_view>& words) {
        isInCurve_ = true;
        curveLine_ = lines_.number();
        spline_.knots.clear();
        spline_.points.clear();
        spline_.weights.clear();
        for (std::size_t k = 3; k < words.size(); ++k) {
            const int vertex = vertexOf(words[k]);
            spline_.points.push_back(graph_.points[vertex]);
            if (isRational_) {
                spline_.weights.push_back(weights_[vertex]);
            }
        }
    }

    void endCurve() {
        isInCurve_ = false;
        if (!isSpline_) {
            leftOut_.add(curveLine_, "a curve that is no B-spline (cstype bspline)");
            return;
        }
        SpacePath path;
        try {
            path.arcs = arcsOf(spline_);
        } catch (const std::invalid_argument& error) {
            leftOut_.add(curveLine_, error.what());
            return;
        }
        if (path.arcs.empty()) {
            leftOut_.add(curveLine_, "a spline without length");
            return;
        }
        closeWhereEndsMeet(path);
        splines_.add(path);
    }

    /// After all vertices, whose indices stay.
    void appendSplines() {
        const PolylineGraph along = splines_.take();
        const auto before = static_cast<int>(graph_.points.size());
        graph_.points.insert(graph_.points.end(), along.points.begin(), along.points.end());
        for (const auto& [from, to] : along.edges) {
            graph_.edges.push_back({before + from, before + to});
        }
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
    std::string joined_;           // of the current line, where it is more than one
    std::vector<double> weights_;  // of the vertices, of rational splines
    bool isRational_ = false, isSpline_ = false, isInCurve_ = false;
    std::size_t curveLine_ = 0;
    SpaceSpline spline_;
    PathLines splines_;
    LeftOut leftOut_;
    PolylineGraph graph_;
};

}  // namespace

PolylineGraph polylinesOfObj(const std::filesystem::path& file, std::string_view bytes) {
    return ObjLines(file, bytes).run();
}

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/ply_cursor.h"
#include "io/polyline_formats.h"
#include "text/text_parsing.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

namespace bspline_curve {

namespace {

class PlyLines {
public:
    PlyLines(const std::filesystem::path& file, const PlyHeader& header, std::string_view data)
        : file_(file), header_(header), cursor_(data, header.format) {}

    PolylineGraph run() {
        for (const PlyElement& element : header_.elements) {
            if (element.name == "vertex") {
                hasPlaces_ = findProperty(element, "face") != nullptr &&
                             findProperty(element, "barycentric_2") != nullptr;
            }
            const std::size_t count = element.properties.empty() ? 0 : element.count;
            for (std::size_t i = 0; i < count; ++i) {
                readOne(element);
                if (cursor_.failed()) {
                    cursor_.refuse(file_, header_, element, i);
                }
                keep(element, i);
            }
        }
        checkEdges();
        return std::move(graph_);
    }

private:
    void readOne(const PlyElement& element) {
        for (const PlyProperty& property : element.properties) {
            if (property.countType == PlyScalar::None) {
                *targetOf(property.name) = cursor_.number(property.type);
                continue;
            }
            const double count = cursor_.number(property.countType);
            for (double k = 0; k < count && !cursor_.failed(); ++k) {
                ignored_ = cursor_.number(property.type);
            }
        }
    }

    double* targetOf(std::string_view name) {
        constexpr std::string_view kAxes = "xyz";
        const std::size_t axis = name.size() == 1 ? kAxes.find(name) : std::string_view::npos;
        if (axis != std::string_view::npos) {
            return &point_[static_cast<int>(axis)];
        }
        constexpr std::array<std::string_view, 4> kPlace{
            "face", "barycentric_0", "barycentric_1", "barycentric_2"
        };
        const auto* const ofPlace = std::ranges::find(kPlace, name);
        if (ofPlace != kPlace.end()) {
            return &place_[static_cast<std::size_t>(ofPlace - kPlace.begin())];
        }
        return name == "vertex1" ? ends_.data() : name == "vertex2" ? &ends_[1] : &ignored_;
    }

    void keep(const PlyElement& element, std::size_t i) {
        if (element.name == "vertex") {
            graph_.points.push_back(point_);
            if (hasPlaces_) {
                graph_.places.push_back(
                    placeOfNumbers(place_[0], Vec3(place_[1], place_[2], place_[3]))
                );
            }
        } else if (element.name == "edge") {
            std::array<int, 2> edge{};
            for (std::size_t k = 0; k < 2; ++k) {
                const bool isIndex = ends_[k] >= 0 && ends_[k] <= kLargestIndex;  // no NaN
                if (!isIndex) {
                    refuseEnd(i, ends_[k]);
                }
                edge[k] = static_cast<int>(ends_[k]);
            }
            graph_.edges.push_back(edge);
        }
    }

    /// At the end, since edges may stand before vertices.
    void checkEdges() const {
        for (std::size_t i = 0; i < graph_.edges.size(); ++i) {
            for (const int end : graph_.edges[i]) {
                if (std::cmp_greater_equal(end, graph_.points.size())) {
                    refuseEnd(i, end);
                }
            }
        }
    }

    [[noreturn]] void refuseEnd(std::size_t edge, double end) const {
        std::string reason = "edge " + std::to_string(edge);
        reason += " names vertex " + std::to_string(static_cast<long long>(end));
        reason += " of " + std::to_string(graph_.points.size()) + ", counted from 0";
        refuseFile(file_, reason);
    }

    static constexpr double kLargestIndex = 2147483647.0;

    const std::filesystem::path& file_;
    const PlyHeader& header_;
    PlyCursor cursor_;
    Vec3 point_ = Vec3::Zero();
    std::array<double, 2> ends_{};
    std::array<double, 4> place_{};  // face, barycentric coordinates
    bool hasPlaces_ = false;
    double ignored_ = 0.0;
    PolylineGraph graph_;
};

void checkHas(
    const std::filesystem::path& file,
    const PlyHeader& header,
    std::string_view name,
    std::initializer_list<const char*> properties
) {
    const auto element = std::ranges::find(header.elements, name, &PlyElement::name);
    if (element == header.elements.end() || element->count == 0) {
        refuseFile(file, "has no polyline: no element \"" + std::string(name) + "\"");
    }
    for (const char* property : properties) {
        const PlyProperty* const found = findProperty(*element, property);
        if (found == nullptr || found->countType != PlyScalar::None) {
            refuseFile(file, "its element " + std::string(name) + " has no " + property);
        }
    }
}

}  // namespace

PolylineGraph polylinesOfPly(const std::filesystem::path& file, std::string_view bytes) {
    const PlyHeader header = readPlyHeader(file, bytes);
    checkHas(file, header, "vertex", {"x", "y", "z"});
    checkHas(file, header, "edge", {"vertex1", "vertex2"});
    return PlyLines(file, header, bytes.substr(header.size)).run();
}

}  // namespace bspline_curve

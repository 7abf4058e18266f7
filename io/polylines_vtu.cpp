// SPDX-License-Identifier: GPL-3.0-or-later
// Lines of VTK's XML files of unstructured grids and of poly data.
#include "io/base64.h"
#include "io/polyline_formats.h"
#include "text/text_parsing.h"

#include <tinyxml2.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

namespace bspline_curve {

namespace {

using VtkElement = tinyxml2::XMLElement;

std::string_view attributeIn(const VtkElement& element, const char* name) {
    const char* const value = element.Attribute(name);
    return value == nullptr ? std::string_view() : std::string_view(value);
}

class VtuLines {
public:
    VtuLines(const std::filesystem::path& file, const VtkElement& root) : file_(file) {
        if (std::string_view(root.Name()) != "VTKFile" ||
            attributeIn(root, "type") != "UnstructuredGrid") {
            refuseFile(
                file, "is no unstructured grid of VTK (<VTKFile type=\"UnstructuredGrid\">)"
            );
        }
        if (!attributeIn(root, "compressor").empty()) {
            refuseFile(file, "is compressed; write it without compression, or as .ply");
        }
        if (attributeIn(root, "byte_order") == "BigEndian") {
            refuseFile(file, "is big-endian; write it little-endian, or as .ply");
        }
        headerSize_ = attributeIn(root, "header_type") == "UInt64" ? sizeof(std::uint64_t)
                                                                   : sizeof(std::uint32_t);
    }

    PolylineGraph run(const VtkElement& root) {
        const VtkElement& piece = only(only(root, "UnstructuredGrid"), "Piece");
        const std::vector<double> points =
            numbersOf(only(only(piece, "Points"), "DataArray"), "the points");
        for (std::size_t i = 0; i + 2 < points.size(); i += 3) {
            graph_.points.emplace_back(points[i], points[i + 1], points[i + 2]);
        }
        readCells(only(piece, "Cells"));
        if (const VtkElement* const data = piece.FirstChildElement("PointData")) {
            readPlaces(*data);
        }
        return std::move(graph_);
    }

private:
    [[nodiscard]] const VtkElement& only(const VtkElement& parent, const char* name) const {
        const VtkElement* const child = parent.FirstChildElement(name);
        if (child == nullptr) {
            refuseFile(file_, std::string("has no <") + name + "> in <" + parent.Name() + ">");
        }
        return *child;
    }

    static const VtkElement* arrayNamed(const VtkElement& parent, std::string_view name) {
        for (const VtkElement* each = parent.FirstChildElement("DataArray"); each != nullptr;
             each = each->NextSiblingElement("DataArray")) {
            if (attributeIn(*each, "Name") == name) {
                return each;
            }
        }
        return nullptr;
    }

    [[nodiscard]] std::vector<double> cellsOf(const VtkElement& cells, const char* name) const {
        const VtkElement* const array = arrayNamed(cells, name);
        if (array == nullptr) {
            refuseFile(file_, std::string("its cells have no array \"") + name + "\"");
        }
        return numbersOf(*array, name);
    }

    void readCells(const VtkElement& cells) {
        constexpr double kLine = 3.0;
        constexpr double kPolyLine = 4.0;
        const std::vector<double> corners = cellsOf(cells, "connectivity");
        const std::vector<double> ends = cellsOf(cells, "offsets");
        const std::vector<double> types = cellsOf(cells, "types");
        const auto count = static_cast<double>(graph_.points.size());
        std::size_t start = 0;
        for (std::size_t cell = 0; cell < std::min(ends.size(), types.size()); ++cell) {
            const bool isInside = ends[cell] >= static_cast<double>(start) &&
                                  ends[cell] <= static_cast<double>(corners.size());
            if (!isInside) {
                refuseFile(file_, "the offset of cell " + std::to_string(cell) + " is not there");
            }
            const auto end = static_cast<std::size_t>(ends[cell]);
            if (types[cell] == kLine || types[cell] == kPolyLine) {
                for (std::size_t i = start; i < end; ++i) {
                    const bool isPoint = corners[i] >= 0.0 && corners[i] < count;
                    if (!isPoint) {
                        refuseFile(
                            file_,
                            "cell " + std::to_string(cell) + " names a point that is not there"
                        );
                    }
                    if (i > start) {
                        graph_.edges.push_back(
                            {static_cast<int>(corners[i - 1]), static_cast<int>(corners[i])}
                        );
                    }
                }
            }
            start = end;
        }
    }

    void readPlaces(const VtkElement& data) {
        const VtkElement* const faceArray = arrayNamed(data, "face");
        const VtkElement* const weightArray = arrayNamed(data, "barycentric");
        if (faceArray == nullptr || weightArray == nullptr) {
            return;
        }
        const std::vector<double> faces = numbersOf(*faceArray, "face");
        const std::vector<double> weights = numbersOf(*weightArray, "barycentric");
        if (faces.size() != graph_.points.size() || weights.size() != 3 * faces.size()) {
            return;
        }
        for (std::size_t i = 0; i < faces.size(); ++i) {
            graph_.places.push_back(placeOfNumbers(
                faces[i], Vec3(weights[3 * i], weights[3 * i + 1], weights[3 * i + 2])
            ));
        }
    }

    [[nodiscard]] std::vector<double> numbersOf(
        const VtkElement& array, const std::string& name
    ) const {
        const char* const found = array.GetText();
        const std::string_view text = found == nullptr ? std::string_view() : trimmed(found);
        const std::string_view format = attributeIn(array, "format");
        if (format == "ascii") {
            std::vector<double> numbers;
            for (const std::string_view word : splitAtBlanks(text)) {
                const std::optional<double> number = parseNumber(word);
                if (!number) {
                    refuseFile(file_, name + ": " + inQuotes(word) + " is not a number");
                }
                numbers.push_back(*number);
            }
            return numbers;
        }
        if (format != "binary") {
            refuseFile(
                file_, name + " are appended; write the file with arrays in place, or as .ply"
            );
        }
        const std::optional<std::string> bytes = bytesOfBase64(text);
        if (!bytes || bytes->size() < headerSize_) {
            refuseFile(file_, name + " are no base64");
        }
        return scalarsOf(attributeIn(array, "type"), bytes->substr(headerSize_), name);
    }

    template <class Number>
    static std::vector<double> scalars(std::string_view bytes) {
        std::vector<double> numbers;
        for (std::size_t at = 0; at + sizeof(Number) <= bytes.size(); at += sizeof(Number)) {
            Number number{};
            std::memcpy(&number, bytes.data() + at, sizeof number);
            numbers.push_back(static_cast<double>(number));
        }
        return numbers;
    }

    [[nodiscard]] std::vector<double> scalarsOf(
        std::string_view type, std::string_view bytes, const std::string& name
    ) const {
        using Read = std::vector<double> (*)(std::string_view);
        constexpr std::array<std::pair<std::string_view, Read>, 10> kTypes{{
            {"Float64", scalars<double>},
            {"Float32", scalars<float>},
            {"Int64", scalars<std::int64_t>},
            {"Int32", scalars<std::int32_t>},
            {"Int16", scalars<std::int16_t>},
            {"Int8", scalars<std::int8_t>},
            {"UInt64", scalars<std::uint64_t>},
            {"UInt32", scalars<std::uint32_t>},
            {"UInt16", scalars<std::uint16_t>},
            {"UInt8", scalars<std::uint8_t>},
        }};
        const auto* const known =
            std::ranges::find(kTypes, type, &std::pair<std::string_view, Read>::first);
        if (known == kTypes.end()) {
            refuseFile(file_, name + " are of the type " + inQuotes(type) + ", which is not known");
        }
        return known->second(bytes);
    }

    const std::filesystem::path& file_;
    std::size_t headerSize_ = 0;
    PolylineGraph graph_;
};

}  // namespace

PolylineGraph polylinesOfVtu(const std::filesystem::path& file, std::string_view bytes) {
    tinyxml2::XMLDocument document;
    if (document.Parse(bytes.data(), bytes.size()) != tinyxml2::XML_SUCCESS ||
        document.RootElement() == nullptr) {
        const auto line = static_cast<std::size_t>(std::max(document.ErrorLineNum(), 1));
        refuseLine(file, line, "is not XML");
    }
    const VtkElement& root = *document.RootElement();
    return VtuLines(file, root).run(root);
}

}  // namespace bspline_curve

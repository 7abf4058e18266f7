// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/mesh_parsers.h"
#include "io/ply_cursor.h"
#include "io/ply_header.h"
#include "text/text_parsing.h"
#include "utility/large_array.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace bspline_curve {

namespace {

class DataParser {
public:
    /// `strips`: the list to make triangles of, or null.
    DataParser(
        const std::filesystem::path& file,
        const PlyHeader& header,
        const PlyProperty* strips,
        std::string_view data
    )
        : file_(file), header_(header), strips_(strips), cursor_(data, header.format) {}

    ParsedMesh run() {
        for (const PlyElement& element : header_.elements) {
            if (element.name == "vertex") {
                vertices_ = static_cast<double>(element.count);
            }
        }
        for (const PlyElement& element : header_.elements) {
            readElement(element);
        }
        return std::move(parsed_);
    }

private:
    void readElement(const PlyElement& element) {
        if (element.properties.empty()) {
            return;  // however many there are
        }
        const bool isVertex = element.name == "vertex";
        const bool hasList =
            std::ranges::any_of(element.properties, [](const PlyProperty& property) {
                return property.countType != PlyScalar::None;
            });
        if (!hasList && !isVertex && header_.format != PlyFormat::Ascii) {
            std::size_t size = 0;
            for (const PlyProperty& property : element.properties) {
                size += sizeOf(property.type);
            }
            cursor_.skipBytes(size * element.count);
            refuseIfFailed(element, element.count);
            return;
        }
        std::vector<double*> targets;  // of the properties
        for (const PlyProperty& property : element.properties) {
            targets.push_back(isVertex ? targetOf(property) : &ignored_);
        }
        const bool hasQuality = std::ranges::find(targets, &quality_) != targets.end();
        if (isVertex) {  // at least a byte for each, whatever the header says
            reserveLarge(parsed_.mesh.vertices, std::min(element.count, cursor_.bytesLeft()));
        }
        for (std::size_t i = 0; i < element.count; ++i) {
            for (std::size_t k = 0; k < targets.size(); ++k) {
                const PlyProperty& property = element.properties[k];
                if (property.countType == PlyScalar::None) {
                    *targets[k] = cursor_.number(property.type);
                } else if (&property == strips_) {
                    readStrips(element, property, i);
                } else {
                    readList(element, property, i);
                }
            }
            refuseIfFailed(element, i);
            if (isVertex) {
                parsed_.mesh.vertices.push_back(point_);
            }
            if (hasQuality) {
                parsed_.quality.push_back(quality_);
            }
        }
    }

    double* targetOf(const PlyProperty& property) {
        constexpr std::string_view kAxes = "xyz";
        const std::size_t axis =
            property.name.size() == 1 ? kAxes.find(property.name) : std::string_view::npos;
        if (axis != std::string_view::npos) {
            return &point_[static_cast<int>(axis)];
        }
        return property.name == "quality" && isFloating(property.type) ? &quality_ : &ignored_;
    }

    void readList(const PlyElement& element, const PlyProperty& property, std::size_t i) {
        const double count = cursor_.number(property.countType);
        const bool isFace = element.name == "face" &&
                            (property.name == "vertex_indices" || property.name == "vertex_index");
        if (!cursor_.failed() && isFace && (count < 3 || count > 255)) {
            refuseFile(
                file_,
                "face " + std::to_string(i) + " has " +
                    std::to_string(static_cast<long long>(count)) + " corners"
            );
        }
        corners_.clear();
        for (double k = 0; k < count && !cursor_.failed(); ++k) {
            const double corner = cursor_.number(property.type);
            if (isFace && !cursor_.failed() && (corner < 0 || corner >= vertices_)) {
                refuseFile(
                    file_,
                    "face " + std::to_string(i) + " names vertex " +
                        std::to_string(static_cast<long long>(corner)) + " of " +
                        std::to_string(static_cast<long long>(vertices_)) + ", counted from 0"
                );
            }
            if (isFace) {
                corners_.push_back(static_cast<int>(corner));
            }
        }
        if (isFace && !cursor_.failed()) {
            addPolygon(corners_, parsed_.mesh.vertices, parsed_.mesh.faces);
            if (sortAndFindRepeated(corners_)) {
                parsed_.repeating.push_back(static_cast<std::int64_t>(i));
            }
        }
    }

    /// Triangles of three vertices in a row, every second one turned; -1 starts a new strip.
    void readStrips(const PlyElement& element, const PlyProperty& property, std::size_t i) {
        const double count = cursor_.number(property.countType);
        corners_.clear();
        for (double k = 0; k < count && !cursor_.failed(); ++k) {
            const double corner = cursor_.number(property.type);
            const bool isRestart = corner == -1 || (corner == 0xffffffff);
            if (!cursor_.failed() && !isRestart && (corner < 0 || corner >= vertices_)) {
                refuseFile(
                    file_,
                    element.name + " " + std::to_string(i) + " names vertex " +
                        std::to_string(static_cast<long long>(corner)) + " of " +
                        std::to_string(static_cast<long long>(vertices_)) + ", counted from 0"
                );
            }
            if (isRestart) {
                corners_.clear();
                continue;
            }
            corners_.push_back(static_cast<int>(corner));
            if (corners_.size() >= 3 && !cursor_.failed()) {
                addStripTriangle();
            }
        }
    }

    void addStripTriangle() {
        const std::size_t first = corners_.size() - 3;
        Triangle face{corners_[first], corners_[first + 1], corners_[first + 2]};
        if (first % 2 == 1) {
            std::swap(face[0], face[1]);
        }
        parsed_.mesh.faces.push_back(face);
        if (sortAndFindRepeated(face)) {
            parsed_.repeating.push_back(std::ssize(parsed_.mesh.faces) - 1);
        }
    }

    void refuseIfFailed(const PlyElement& element, std::size_t i) const {
        if (!cursor_.failed()) {
            return;
        }
        cursor_.refuse(file_, header_, element, i);
    }

    const std::filesystem::path& file_;
    const PlyHeader& header_;
    const PlyProperty* strips_;
    PlyCursor cursor_;
    double vertices_ = 0.0;
    Vec3 point_ = Vec3::Zero();
    double quality_ = 0.0, ignored_ = 0.0;
    std::vector<int> corners_;
    ParsedMesh parsed_;
};

// ---------------------------------------------------------------- what the header must say

void checkVertices(const std::filesystem::path& file, const PlyHeader& header) {
    const auto vertex = std::ranges::find(header.elements, "vertex", &PlyElement::name);
    if (vertex == header.elements.end() || vertex->count == 0) {
        refuseFile(file, "has no vertices");
    }
    for (const char* name : {"x", "y", "z"}) {
        const PlyProperty* const property = findProperty(*vertex, name);
        if (property == nullptr || !isFloating(property->type)) {
            refuseFile(
                file, std::string("the vertices have no ") + name + " of type float or double"
            );
        }
        if (header.format == PlyFormat::BigEndian && property->type == PlyScalar::Double) {
            refuseFile(
                file, "big-endian double coordinates are not supported; save it little-endian"
            );
        }
    }
}

void checkElementsKnown(const std::filesystem::path& file, const PlyHeader& header) {
    for (const PlyElement& element : header.elements) {
        if (element.name == "range_grid") {
            refuseFile(file, "has a range_grid, not faces; save it as triangles");
        }
        if (element.name == "edge" && (findProperty(element, "vertex1") == nullptr ||
                                       findProperty(element, "vertex2") == nullptr)) {
            refuseFile(file, "its edges have no vertex1 and vertex2");
        }
    }
}

/// The element of that name if it has any, else null.
const PlyElement* findFilled(const PlyHeader& header, std::string_view name) {
    const auto found = std::ranges::find(header.elements, name, &PlyElement::name);
    return found == header.elements.end() || found->count == 0 ? nullptr : &*found;
}

/// The list of vertices of faces or strips.
const PlyProperty* findIndices(const std::filesystem::path& file, const PlyElement& element) {
    const PlyProperty* indices = findProperty(element, "vertex_indices");
    indices = indices != nullptr ? indices : findProperty(element, "vertex_index");
    if (indices == nullptr || indices->countType == PlyScalar::None) {
        refuseFile(file, "its element " + element.name + " has no list vertex_indices");
    }
    if (isFloating(indices->type)) {
        refuseFile(
            file,
            "the vertex indices of its " + element.name + " are of type " + nameOf(indices->type)
        );
    }
    return indices;
}

}  // namespace

ParsedMesh parsePly(const std::filesystem::path& file, std::string_view bytes) {
    const PlyHeader header = readPlyHeader(file, bytes);
    checkVertices(file, header);
    checkElementsKnown(file, header);
    const PlyElement* const faces = findFilled(header, "face");
    const PlyElement* const strips = faces == nullptr ? findFilled(header, "tristrips") : nullptr;
    if (faces == nullptr && strips == nullptr) {
        refuseFile(file, "has no faces");
    }
    const PlyProperty* const indices = findIndices(file, faces != nullptr ? *faces : *strips);
    const PlyProperty* const stripIndices = strips != nullptr ? indices : nullptr;
    return DataParser(file, header, stripIndices, bytes.substr(header.size)).run();
}

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/files.h"
#include "io/mesh_parsers.h"
#include "io/ply_cursor.h"
#include "text/text_parsing.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <utility>

namespace bspline_curve {

namespace {

using Vec2 = Eigen::Vector2d;
using Words = std::vector<std::string_view>;

/// Which corner of a polygon a vertex is.
std::size_t cornerIn(std::span<const int> polygon, int vertex) {
    return static_cast<std::size_t>(std::ranges::find(polygon, vertex) - polygon.begin());
}

// ---- PLY ----

/// Reads again what the mesh's own parser passes over. Expects a file that it has read.
class PlyExtras {
public:
    PlyExtras(const PlyHeader& header, std::string_view data)
        : header_(header), cursor_(data, header.format) {}

    MeshExtras run() {
        for (const PlyElement& element : header_.elements) {
            const bool isVertex = element.name == "vertex";
            const bool isFace = element.name == "face";
            if (isVertex || isFace) {
                declare(element, isVertex ? extras_.vertices : extras_.faces);
            }
            for (std::size_t i = 0; i < element.count && !element.properties.empty(); ++i) {
                readOne(element);
                if (isVertex) {
                    takeVertex(element);
                } else if (isFace) {
                    takeFace(element);
                }
            }
        }
        if (!hasTexture_) {
            extras_.cornerTexture.clear();
        }
        return std::move(extras_);
    }

private:
    static bool isOfMesh(const PlyElement& element, const PlyProperty& property) {
        return property.countType != PlyScalar::None || property.name == "x" ||
               property.name == "y" || property.name == "z" ||
               (property.name == "quality" && element.name == "vertex");
    }

    static void declare(const PlyElement& element, std::vector<MeshChannel>& channels) {
        for (const PlyProperty& property : element.properties) {
            if (!isOfMesh(element, property)) {
                channels.push_back({.name = property.name, .type = property.type, .values = {}});
            }
        }
    }

    void readOne(const PlyElement& element) {
        values_.assign(element.properties.size(), 0.0);
        lists_.resize(element.properties.size());
        for (std::size_t k = 0; k < element.properties.size(); ++k) {
            const PlyProperty& property = element.properties[k];
            lists_[k].clear();
            if (property.countType == PlyScalar::None) {
                values_[k] = cursor_.number(property.type);
                continue;
            }
            const double count = cursor_.number(property.countType);
            for (double i = 0; i < count && !cursor_.failed(); ++i) {
                lists_[k].push_back(cursor_.number(property.type));
            }
        }
    }

    void takeVertex(const PlyElement& element) {
        std::size_t channel = 0;
        Vec3 point = Vec3::Zero();
        for (std::size_t k = 0; k < element.properties.size(); ++k) {
            const PlyProperty& property = element.properties[k];
            if (!isOfMesh(element, property)) {
                extras_.vertices[channel++].values.push_back(values_[k]);
            } else if (property.name.size() == 1) {
                point[property.name[0] - 'x'] = values_[k];
            }
        }
        points_.push_back(point);
    }

    void takeFace(const PlyElement& element) {
        const std::vector<double>* texture = nullptr;
        std::vector<int> corners;
        for (std::size_t k = 0; k < element.properties.size(); ++k) {
            const std::string& name = element.properties[k].name;
            if (name == "vertex_indices" || name == "vertex_index") {
                corners.assign(lists_[k].begin(), lists_[k].end());
            } else if (name == "texcoord") {
                texture = &lists_[k];
            }
        }
        std::vector<Triangle> triangles;
        addPolygon(corners, points_, triangles);
        for (const Triangle& triangle : triangles) {
            std::size_t channel = 0;
            for (std::size_t k = 0; k < element.properties.size(); ++k) {
                if (!isOfMesh(element, element.properties[k])) {
                    extras_.faces[channel++].values.push_back(values_[k]);
                }
            }
            std::array<Vec2, 3> places{Vec2::Zero(), Vec2::Zero(), Vec2::Zero()};
            if (texture != nullptr && texture->size() == 2 * corners.size()) {
                hasTexture_ = true;
                for (std::size_t k = 0; k < 3; ++k) {
                    const std::size_t at = 2 * cornerIn(corners, triangle[k]);
                    places[k] = {(*texture)[at], (*texture)[at + 1]};
                }
            }
            extras_.cornerTexture.push_back(places);
        }
    }

    const PlyHeader& header_;
    PlyCursor cursor_;
    std::vector<double> values_;              // of the properties of one element
    std::vector<std::vector<double>> lists_;  // likewise
    std::vector<Vec3> points_;
    bool hasTexture_ = false;
    MeshExtras extras_;
};

MeshExtras extrasOfPly(const std::filesystem::path& file, std::string_view bytes) {
    const PlyHeader header = readPlyHeader(file, bytes);
    MeshExtras extras = PlyExtras(header, bytes.substr(header.size)).run();
    LineReader lines(bytes.substr(0, header.size));
    while (lines.next()) {
        constexpr std::string_view kTexture = "comment TextureFile ";
        if (lines.line().starts_with(kTexture)) {
            extras.textures.emplace_back(trimmed(lines.line().substr(kTexture.size())));
        }
    }
    return extras;
}

// ---- OBJ ----

class ObjExtras {
public:
    explicit ObjExtras(std::string_view bytes) : lines_(withoutTrailingZeros(bytes)) {}

    MeshExtras run() {
        while (lines_.next()) {
            std::string line(lines_.line());
            while (line.ends_with('\\') && lines_.next()) {
                line.pop_back();
                line += lines_.line();
            }
            const Words words = splitAtBlanks(line);
            if (!words.empty()) {
                read(words, line);
            }
        }
        if (!colours_.empty() && colours_.size() == points_.size()) {
            constexpr double kBrightest = 255.0;
            for (std::size_t k = 0; k < 3; ++k) {
                constexpr std::array<const char*, 3> kNames{"red", "green", "blue"};
                MeshChannel channel{.name = kNames[k], .type = PlyScalar::UInt8, .values = {}};
                for (const Vec3& colour : colours_) {
                    channel.values.push_back(kBrightest * colour[static_cast<int>(k)]);
                }
                extras_.vertices.push_back(std::move(channel));
            }
        }
        if (!hasTexture_) {
            extras_.cornerTexture.clear();
        }
        if (!hasNormals_) {
            extras_.cornerNormals.clear();
        }
        if (extras_.headings.empty()) {
            extras_.headingOf.clear();
        }
        return std::move(extras_);
    }

private:
    static double numberIn(const Words& words, std::size_t k) {
        return k < words.size() ? parseNumber(words[k]).value_or(0.0) : 0.0;
    }

    static Vec3 triple(const Words& words, std::size_t first) {
        return {numberIn(words, first), numberIn(words, first + 1), numberIn(words, first + 2)};
    }

    void read(const Words& words, const std::string& line) {
        const std::string_view keyword = words[0];
        if (keyword == "v") {
            points_.push_back(triple(words, 1));
            if (words.size() == 7) {
                colours_.push_back(triple(words, 4));
            }
        } else if (keyword == "vt") {
            texture_.emplace_back(triple(words, 1).head<2>());
        } else if (keyword == "vn") {
            normals_.push_back(triple(words, 1));
        } else if (keyword == "mtllib") {
            extras_.libraries.emplace_back(trimmed(std::string_view(line).substr(6)));
        } else if (keyword == "o" || keyword == "g" || keyword == "s" || keyword == "usemtl") {
            state_[std::string(keyword)] = std::string(trimmed(line));
            heading_ = -1;
        } else if (keyword == "f" || keyword == "q") {
            readFace(words, keyword == "q");
        }
    }

    /// Index of a corner's number among `count` things; none where there is no such number.
    static std::optional<std::size_t> indexIn(
        std::string_view word, std::size_t count, bool isFromZero
    ) {
        const std::optional<long long> number = parseInteger(word);
        if (!number) {
            return std::nullopt;
        }
        const long long index = isFromZero    ? *number
                                : *number > 0 ? *number - 1
                                              : static_cast<long long>(count) + *number;
        return index >= 0 && std::cmp_less(index, count)
                   ? std::optional(static_cast<std::size_t>(index))
                   : std::nullopt;
    }

    void readFace(const Words& words, bool isFromZero) {
        std::vector<int> corners;
        std::vector<Vec2> texture;
        std::vector<Vec3> normals;
        for (std::size_t k = 1; k < words.size(); ++k) {
            const std::vector<std::string_view> parts = splitAt(words[k], '/');
            const auto part = [&](std::size_t i) {
                return i < parts.size() ? parts[i] : std::string_view();
            };
            corners.push_back(
                static_cast<int>(indexIn(part(0), points_.size(), isFromZero).value_or(0))
            );
            const auto at = indexIn(part(1), texture_.size(), false);
            const auto normal = indexIn(part(2), normals_.size(), false);
            hasTexture_ = hasTexture_ || at;
            hasNormals_ = hasNormals_ || normal;
            texture.push_back(at ? texture_[*at] : Vec2(Vec2::Zero()));
            normals.push_back(normal ? normals_[*normal] : Vec3(Vec3::Zero()));
        }
        std::vector<Triangle> triangles;
        addPolygon(corners, points_, triangles);
        for (const auto& [a, b, c] : triangles) {
            const std::size_t i = cornerIn(corners, a);
            const std::size_t j = cornerIn(corners, b);
            const std::size_t k = cornerIn(corners, c);
            extras_.cornerTexture.push_back({texture[i], texture[j], texture[k]});
            extras_.cornerNormals.push_back({normals[i], normals[j], normals[k]});
            extras_.headingOf.push_back(currentHeading());
        }
    }

    int currentHeading() {
        if (heading_ < 0 && !state_.empty()) {
            std::string text;
            for (const auto& [keyword, line] : state_) {
                text.append(line).append("\n");
            }
            const auto [entry, isNew] =
                headings_.try_emplace(text, static_cast<int>(extras_.headings.size()));
            if (isNew) {
                extras_.headings.push_back(text);
            }
            heading_ = entry->second;
        }
        return heading_;
    }

    LineReader lines_;
    std::vector<Vec3> points_, colours_, normals_;
    std::vector<Vec2> texture_;
    std::map<std::string, std::string> state_;  // the last line of each keyword
    std::map<std::string, int> headings_;
    int heading_ = -1;
    bool hasTexture_ = false, hasNormals_ = false;
    MeshExtras extras_;
};

}  // namespace

std::string MeshExtras::words() const {
    const std::map<std::string, std::string> known{
        {"red", "colours"},
        {"green", "colours"},
        {"blue", "colours"},
        {"alpha", "colours"},
        {"nx", "normals"},
        {"ny", "normals"},
        {"nz", "normals"},
        {"s", "texture coordinates"},
        {"t", "texture coordinates"},
        {"u", "texture coordinates"},
        {"v", "texture coordinates"},
        {"texture_u", "texture coordinates"},
        {"texture_v", "texture coordinates"},
        {"texnumber", "texture coordinates"},
    };
    std::vector<std::string> list;
    const auto add = [&](const std::string& word) {
        if (std::ranges::find(list, word) == list.end()) {
            list.push_back(word);
        }
    };
    for (const auto* const channels : {&vertices, &faces}) {
        for (const MeshChannel& channel : *channels) {
            const auto found = known.find(channel.name);
            add(found == known.end() ? inQuotes(channel.name) : found->second);
        }
    }
    if (!cornerNormals.empty()) {
        add("normals");
    }
    if (!cornerTexture.empty()) {
        add("texture coordinates");
    }
    if (!libraries.empty() || !headings.empty()) {
        add("groups and materials");
    }
    std::string text;
    for (const std::string& word : list) {
        text.append(text.empty() ? "" : ", ").append(word);
    }
    return text;
}

MeshExtras readMeshExtras(const std::filesystem::path& file) {
    const std::string extension = lowerCaseExtension(file);
    if (extension == ".ply") {
        return extrasOfPly(file, readWholeFile(file));
    }
    return extension == ".obj" ? ObjExtras(readWholeFile(file)).run() : MeshExtras{};
}

}  // namespace bspline_curve

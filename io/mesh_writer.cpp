// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/mesh_writer.h"

#include "bspline_curve/error.h"
#include "io/append_binary.h"
#include "io/number_text.h"
#include "io/text_parsing.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

namespace bspline_curve {

namespace {

/// Channels of extras but those that the writer has values of its own for.
std::vector<const MeshChannel*> channelsBut(
    const std::vector<MeshChannel>* channels, std::span<const std::string_view> own
) {
    std::vector<const MeshChannel*> kept;
    if (channels != nullptr) {
        for (const MeshChannel& channel : *channels) {
            if (std::ranges::find(own, channel.name) == own.end()) {
                kept.push_back(&channel);
            }
        }
    }
    return kept;
}

void declare(std::string& bytes, const std::vector<const MeshChannel*>& channels) {
    for (const MeshChannel* const channel : channels) {
        bytes.append("property ").append(nameOf(channel->type)).append(" ");
        bytes.append(channel->name).append("\n");
    }
}

template <class Number>
void appendWhole(std::string& bytes, double value) {
    using Limits = std::numeric_limits<Number>;
    appendBinary(
        bytes,
        static_cast<Number>(std::clamp(
            std::round(value),
            static_cast<double>(Limits::min()),
            static_cast<double>(Limits::max())
        ))
    );
}

void appendScalar(std::string& bytes, PlyScalar type, double value) {
    switch (type) {
        case PlyScalar::None:
            return;
        case PlyScalar::Int8:
            return appendWhole<std::int8_t>(bytes, value);
        case PlyScalar::UInt8:
            return appendWhole<std::uint8_t>(bytes, value);
        case PlyScalar::Int16:
            return appendWhole<std::int16_t>(bytes, value);
        case PlyScalar::UInt16:
            return appendWhole<std::uint16_t>(bytes, value);
        case PlyScalar::Int32:
            return appendWhole<std::int32_t>(bytes, value);
        case PlyScalar::UInt32:
            return appendWhole<std::uint32_t>(bytes, value);
        case PlyScalar::Float:
            return appendBinary(bytes, static_cast<float>(value));
        case PlyScalar::Double:
            return appendBinary(bytes, value);
    }
}

void appendValues(
    std::string& bytes, const std::vector<const MeshChannel*>& channels, std::size_t index
) {
    for (const MeshChannel* const channel : channels) {
        appendScalar(bytes, channel->type, channel->values[index]);
    }
}

/// Normals at vertices, where corners have them and agree.
std::vector<MeshChannel> vertexNormals(const TriangleMesh& mesh, const MeshExtras* extras) {
    if (extras == nullptr || extras->cornerNormals.empty()) {
        return {};
    }
    std::vector<Vec3> normals(mesh.vertices.size(), Vec3::Zero());
    std::vector<char> isSet(mesh.vertices.size(), 0);
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        for (std::size_t k = 0; k < 3; ++k) {
            const int vertex = mesh.faces[f][k];
            const Vec3& normal = extras->cornerNormals[f][k];
            constexpr double kSame = 1e-6;
            if (isSet[vertex] != 0 && (normals[vertex] - normal).norm() > kSame) {
                return {};
            }
            isSet[vertex] = 1;
            normals[vertex] = normal;
        }
    }
    std::vector<MeshChannel> channels;
    for (int k = 0; k < 3; ++k) {
        MeshChannel channel{
            .name = std::string("n") + "xyz"[k], .type = PlyScalar::Float, .values = {}
        };
        for (const Vec3& normal : normals) {
            channel.values.push_back(normal[k]);
        }
        channels.push_back(std::move(channel));
    }
    return channels;
}

std::string meshPly(const TriangleMesh& mesh, const MeshAttributes& attributes) {
    const bool hasQuality = !attributes.vertexQuality.empty();
    const bool hasLabels = !attributes.faceLabels.empty();
    const bool hasColours = !attributes.faceColours.empty();
    const MeshExtras* const extras = attributes.extras;
    std::vector<std::string_view> ownOfFaces;
    if (hasLabels) {
        ownOfFaces.insert(ownOfFaces.end(), {"label", "quality"});
    }
    if (hasColours) {
        ownOfFaces.insert(ownOfFaces.end(), {"red", "green", "blue", "alpha"});
    }
    std::vector<const MeshChannel*> ofVertices =
        channelsBut(extras != nullptr ? &extras->vertices : nullptr, {});
    const std::vector<MeshChannel> normals = vertexNormals(mesh, extras);
    for (const MeshChannel& channel : normals) {
        ofVertices.push_back(&channel);
    }
    const std::vector<const MeshChannel*> ofFaces =
        channelsBut(extras != nullptr ? &extras->faces : nullptr, ownOfFaces);
    const bool hasTexture = extras != nullptr && !extras->cornerTexture.empty();
    std::string bytes = "ply\nformat binary_little_endian 1.0\n";
    for (const std::string& texture :
         extras != nullptr ? extras->textures : std::vector<std::string>()) {
        bytes.append("comment TextureFile ").append(texture).append("\n");
    }
    bytes += "element vertex " + std::to_string(mesh.vertices.size()) +
             "\nproperty double x\nproperty double y\nproperty double z\n" +
             (hasQuality ? "property double quality\n" : "");
    declare(bytes, ofVertices);
    bytes += "element face " + std::to_string(mesh.faces.size()) +
             "\nproperty list uchar int vertex_indices\n" +
             (hasLabels ? "property int label\nproperty double quality\n" : "") +
             (hasColours ? "property uchar red\nproperty uchar green\nproperty uchar "
                           "blue\nproperty uchar alpha\n"
                         : "") +
             (hasTexture ? "property list uchar float texcoord\n" : "");
    declare(bytes, ofFaces);
    bytes += "end_header\n";
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        for (const double x : mesh.vertices[v]) {
            appendBinary(bytes, x);
        }
        if (hasQuality) {
            appendBinary(bytes, attributes.vertexQuality[v]);
        }
        appendValues(bytes, ofVertices, v);
    }
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        appendBinary(bytes, std::uint8_t{3});
        for (const int vertex : mesh.faces[f]) {
            appendBinary(bytes, static_cast<std::int32_t>(vertex));
        }
        if (hasLabels) {
            appendBinary(bytes, static_cast<std::int32_t>(attributes.faceLabels[f]));
            appendBinary(bytes, static_cast<double>(attributes.faceLabels[f]));
        }
        if (hasColours) {
            for (const std::uint8_t channel : attributes.faceColours[f]) {
                appendBinary(bytes, channel);
            }
            appendBinary(bytes, std::uint8_t{255});
        }
        if (hasTexture) {
            constexpr std::uint8_t kNumbers = 6;
            appendBinary(bytes, kNumbers);
            for (const Eigen::Vector2d& place : extras->cornerTexture[f]) {
                appendBinary(bytes, static_cast<float>(place.x()));
                appendBinary(bytes, static_cast<float>(place.y()));
            }
        }
        appendValues(bytes, ofFaces, f);
    }
    return bytes;
}

std::string numbersOf(const Vec3& point) {
    return numberText(point.x()) + " " + numberText(point.y()) + " " + numberText(point.z());
}

/// The values of a channel of vertices; null: there is none of these names.
const std::vector<double>* valuesNamed(
    const MeshExtras* extras, std::initializer_list<std::string_view> names
) {
    if (extras != nullptr) {
        for (const MeshChannel& channel : extras->vertices) {
            if (std::ranges::find(names, channel.name) != names.end()) {
                return &channel.values;
            }
        }
    }
    return nullptr;
}

/// Statements of OBJ that give corners a vector, each vector once, and their indices from 1.
class ObjVectors {
public:
    explicit ObjVectors(std::string keyword) : keyword_(std::move(keyword)) {}

    std::size_t indexOf(const std::vector<double>& values) {
        const auto [entry, isNew] = indices_.try_emplace(values, indices_.size() + 1);
        if (isNew) {
            text_ += keyword_;
            for (const double value : values) {
                text_.append(" ").append(numberText(value));
            }
            text_ += '\n';
        }
        return entry->second;
    }

    [[nodiscard]] const std::string& text() const { return text_; }

private:
    std::string keyword_, text_;
    std::map<std::vector<double>, std::size_t> indices_;
};

std::string objBytes(const TriangleMesh& mesh, const MeshAttributes& attributes) {
    const MeshExtras* const extras = attributes.extras;
    std::string text;
    for (const std::string& library :
         extras != nullptr ? extras->libraries : std::vector<std::string>()) {
        text.append("mtllib ").append(library).append("\n");
    }
    constexpr double kBrightest = 255.0;
    const std::array colours{
        valuesNamed(extras, {"red"}), valuesNamed(extras, {"green"}), valuesNamed(extras, {"blue"})
    };
    const bool hasColours = std::ranges::find(colours, nullptr) == colours.end();
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        text += "v ";
        text += numbersOf(mesh.vertices[v]);
        for (std::size_t k = 0; hasColours && k < 3; ++k) {
            text += ' ';
            text += numberText((*colours[k])[v] / kBrightest);
        }
        text += '\n';
    }
    const auto* const s = valuesNamed(extras, {"s", "u", "texture_u"});
    const auto* const t = valuesNamed(extras, {"t", "v", "texture_v"});
    const std::array normals{
        valuesNamed(extras, {"nx"}), valuesNamed(extras, {"ny"}), valuesNamed(extras, {"nz"})
    };
    const bool hasVertexNormals = std::ranges::find(normals, nullptr) == normals.end();
    const bool hasCornerTexture = extras != nullptr && !extras->cornerTexture.empty();
    const bool hasCornerNormals = extras != nullptr && !extras->cornerNormals.empty();
    const bool hasTexture = hasCornerTexture || (s != nullptr && t != nullptr);
    const bool hasNormals = hasCornerNormals || hasVertexNormals;
    ObjVectors textures("vt");
    ObjVectors directions("vn");
    std::string faces;
    int heading = -1;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        if (extras != nullptr && !extras->headingOf.empty() && extras->headingOf[f] >= 0 &&
            extras->headingOf[f] != heading) {
            heading = extras->headingOf[f];
            faces += extras->headings[heading];
        }
        faces += 'f';
        for (std::size_t k = 0; k < 3; ++k) {
            const int vertex = mesh.faces[f][k];
            faces += ' ';
            faces += std::to_string(vertex + 1);
            if (hasTexture) {
                const Eigen::Vector2d place = hasCornerTexture
                                                  ? extras->cornerTexture[f][k]
                                                  : Eigen::Vector2d((*s)[vertex], (*t)[vertex]);
                faces += '/';
                faces += std::to_string(textures.indexOf({place.x(), place.y()}));
            }
            if (hasNormals) {
                const Vec3 normal =
                    hasCornerNormals
                        ? extras->cornerNormals[f][k]
                        : Vec3((*normals[0])[vertex], (*normals[1])[vertex], (*normals[2])[vertex]);
                faces += hasTexture ? "/" : "//";
                faces += std::to_string(directions.indexOf({normal.x(), normal.y(), normal.z()}));
            }
        }
        faces += '\n';
    }
    return text + textures.text() + directions.text() + faces;
}

std::string offBytes(const TriangleMesh& mesh) {
    std::string text = "OFF\n" + std::to_string(mesh.vertices.size()) + " " +
                       std::to_string(mesh.faces.size()) + " 0\n";
    for (const Vec3& vertex : mesh.vertices) {
        text += numbersOf(vertex);
        text += '\n';
    }
    for (const Triangle& face : mesh.faces) {
        text += '3';
        for (const int vertex : face) {
            text += ' ';
            text += std::to_string(vertex);
        }
        text += '\n';
    }
    return text;
}

std::string meshStl(const TriangleMesh& mesh) {
    constexpr std::size_t kTextSize = 80;
    std::string bytes(kTextSize, ' ');
    appendBinary(bytes, static_cast<std::uint32_t>(mesh.faces.size()));
    for (const auto& [a, b, c] : mesh.faces) {
        const Vec3 &p = mesh.vertices[a], &q = mesh.vertices[b], &r = mesh.vertices[c];
        const Vec3 normal = (q - p).cross(r - p).normalized();
        for (const Vec3& row : {normal, p, q, r}) {
            for (const double x : row) {
                appendBinary(bytes, static_cast<float>(x));
            }
        }
        appendBinary(bytes, std::uint16_t{0});
    }
    return bytes;
}

}  // namespace

std::string meshExtensions() {
    return ".ply, .obj, .off or .stl";
}

void checkMeshExtension(const std::filesystem::path& file) {
    const std::string extension = lowerCaseExtension(file);
    if (extension != ".ply" && extension != ".obj" && extension != ".off" && extension != ".stl") {
        throw InputError(
            InputErrorCode::UnwritableFile,
            file.string() + ": meshes are written as " + meshExtensions() +
                "; change the name's end"
        );
    }
}

std::string lostExtras(const std::filesystem::path& file, const MeshExtras& extras) {
    const std::string extension = lowerCaseExtension(file);
    MeshExtras lost = extras;
    if (extension == ".ply") {
        lost.vertices.clear();
        lost.faces.clear();
        lost.cornerTexture.clear();
        lost.cornerNormals.clear();
    } else if (extension == ".obj") {
        constexpr std::array<std::string_view, 13> kHeld{
            "red",
            "green",
            "blue",
            "alpha",
            "nx",
            "ny",
            "nz",
            "s",
            "t",
            "u",
            "v",
            "texture_u",
            "texture_v"
        };
        std::erase_if(lost.vertices, [&](const MeshChannel& channel) {
            return std::ranges::find(kHeld, channel.name) != kHeld.end();
        });
        lost.cornerTexture.clear();
        lost.cornerNormals.clear();
        lost.libraries.clear();
        lost.headings.clear();
    }
    return lost.words();
}

double largestMoveIn(const std::filesystem::path& file, const TriangleMesh& mesh) {
    double largest = 0.0;
    if (lowerCaseExtension(file) == ".stl") {
        for (const Vec3& p : mesh.vertices) {
            largest = std::max(largest, (p - p.cast<float>().cast<double>()).norm());
        }
    }
    return largest;
}

std::string meshBytes(
    const std::filesystem::path& file, const TriangleMesh& mesh, const MeshAttributes& attributes
) {
    checkMeshExtension(file);
    const std::string extension = lowerCaseExtension(file);
    if (extension == ".obj") {
        return objBytes(mesh, attributes);
    }
    if (extension == ".off") {
        return offBytes(mesh);
    }
    return extension == ".stl" ? meshStl(mesh) : meshPly(mesh, attributes);
}

}  // namespace bspline_curve

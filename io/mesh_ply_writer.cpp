// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes as PLY: binary, little-endian, doubles.
#include "io/append_binary.h"
#include "io/mesh_formats.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace bspline_curve {

namespace {

/// Channels of extras but those that the writer has values of its own for.
std::vector<const MeshChannel*> channelsBut(
    const std::vector<MeshChannel>& channels, std::span<const std::string_view> own
) {
    std::vector<const MeshChannel*> kept;
    for (const MeshChannel& channel : channels) {
        if (std::ranges::find(own, channel.name) == own.end()) {
            kept.push_back(&channel);
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
            appendWhole<std::int8_t>(bytes, value);
            return;
        case PlyScalar::UInt8:
            appendWhole<std::uint8_t>(bytes, value);
            return;
        case PlyScalar::Int16:
            appendWhole<std::int16_t>(bytes, value);
            return;
        case PlyScalar::UInt16:
            appendWhole<std::uint16_t>(bytes, value);
            return;
        case PlyScalar::Int32:
            appendWhole<std::int32_t>(bytes, value);
            return;
        case PlyScalar::UInt32:
            appendWhole<std::uint32_t>(bytes, value);
            return;
        case PlyScalar::Float:
            appendBinary(bytes, static_cast<float>(value));
            return;
        case PlyScalar::Double:
            appendBinary(bytes, value);
            return;
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

class PlyMesh {
public:
    PlyMesh(const TriangleMesh& mesh, const MeshAttributes& attributes)
        : mesh_(mesh), own_(attributes), normals_(vertexNormals(mesh, attributes.extras)) {
        std::vector<std::string_view> ownOfFaces;
        if (!own_.faceLabels.empty()) {
            ownOfFaces.insert(ownOfFaces.end(), {"label", "quality"});
        }
        if (!own_.faceColours.empty()) {
            ownOfFaces.insert(ownOfFaces.end(), {"red", "green", "blue", "alpha"});
        }
        if (own_.extras != nullptr) {
            ofVertices_ = channelsBut(own_.extras->vertices, {});
            ofFaces_ = channelsBut(own_.extras->faces, ownOfFaces);
            hasTexture_ = !own_.extras->cornerTexture.empty();
        }
        for (const MeshChannel& channel : normals_) {
            ofVertices_.push_back(&channel);
        }
    }

    std::string run() {
        addHeader();
        for (std::size_t v = 0; v < mesh_.vertices.size(); ++v) {
            addVertex(v);
        }
        for (std::size_t f = 0; f < mesh_.faces.size(); ++f) {
            addFace(f);
        }
        return std::move(bytes_);
    }

private:
    void addHeader() {
        bytes_ = "ply\nformat binary_little_endian 1.0\n";
        if (own_.extras != nullptr) {
            for (const std::string& texture : own_.extras->textures) {
                bytes_.append("comment TextureFile ").append(texture).append("\n");
            }
        }
        bytes_.append("element vertex ").append(std::to_string(mesh_.vertices.size()));
        bytes_ += "\nproperty double x\nproperty double y\nproperty double z\n";
        bytes_ += own_.vertexQuality.empty() ? "" : "property double quality\n";
        declare(bytes_, ofVertices_);
        bytes_.append("element face ").append(std::to_string(mesh_.faces.size()));
        bytes_ += "\nproperty list uchar int vertex_indices\n";
        bytes_ += own_.faceLabels.empty() ? "" : "property int label\nproperty double quality\n";
        bytes_ += own_.faceColours.empty() ? ""
                                           : "property uchar red\nproperty uchar green\nproperty "
                                             "uchar blue\nproperty uchar alpha\n";
        bytes_ += hasTexture_ ? "property list uchar float texcoord\n" : "";
        declare(bytes_, ofFaces_);
        bytes_ += "end_header\n";
    }

    void addVertex(std::size_t v) {
        for (const double x : mesh_.vertices[v]) {
            appendBinary(bytes_, x);
        }
        if (!own_.vertexQuality.empty()) {
            appendBinary(bytes_, own_.vertexQuality[v]);
        }
        appendValues(bytes_, ofVertices_, v);
    }

    void addFace(std::size_t f) {
        appendBinary(bytes_, std::uint8_t{3});
        for (const int vertex : mesh_.faces[f]) {
            appendBinary(bytes_, static_cast<std::int32_t>(vertex));
        }
        if (!own_.faceLabels.empty()) {
            appendBinary(bytes_, static_cast<std::int32_t>(own_.faceLabels[f]));
            appendBinary(bytes_, static_cast<double>(own_.faceLabels[f]));
        }
        if (!own_.faceColours.empty()) {
            for (const std::uint8_t channel : own_.faceColours[f]) {
                appendBinary(bytes_, channel);
            }
            appendBinary(bytes_, std::uint8_t{255});
        }
        if (hasTexture_) {
            addTexture(f);
        }
        appendValues(bytes_, ofFaces_, f);
    }

    void addTexture(std::size_t f) {
        constexpr std::uint8_t kNumbers = 6;
        appendBinary(bytes_, kNumbers);
        for (const Eigen::Vector2d& place : own_.extras->cornerTexture[f]) {
            appendBinary(bytes_, static_cast<float>(place.x()));
            appendBinary(bytes_, static_cast<float>(place.y()));
        }
    }

    const TriangleMesh& mesh_;
    const MeshAttributes& own_;
    std::vector<MeshChannel> normals_;
    std::vector<const MeshChannel*> ofVertices_, ofFaces_;  // of extras
    bool hasTexture_ = false;
    std::string bytes_;
};

}  // namespace

std::string meshPly(const TriangleMesh& mesh, const MeshAttributes& attributes) {
    return PlyMesh(mesh, attributes).run();
}

}  // namespace bspline_curve

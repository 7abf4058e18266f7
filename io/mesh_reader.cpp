// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/files.h"
#include "io/mesh_parsers.h"
#include "text/error_messages.h"
#include "text/text_parsing.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>

namespace bspline_curve {

namespace {

struct Format {
    std::string_view extension;
    ParsedMesh (*parse)(const std::filesystem::path& file, std::string_view bytes);
};

constexpr std::array kMeshFormats = {
    Format{".ply", parsePly},
    Format{".obj", parseObj},
    Format{".off", parseOff},
    Format{".stl", parseStl}
};

using Key = std::array<double, 3>;

struct KeyHash {
    std::size_t operator()(const Key& key) const {
        std::uint64_t hash = 0;
        for (const double coordinate : key) {
            hash = (hash ^ std::bit_cast<std::uint64_t>(coordinate)) * 0x9e3779b97f4a7c15ULL;
            hash ^= hash >> 32;
        }
        return hash;
    }
};

/// Makes vertices of equal coordinates one, in order of first use.
TriangleMesh welded(const TriangleMesh& soup) {
    TriangleMesh mesh;
    std::unordered_map<Key, int, KeyHash> ids;
    std::vector<int> newIds;
    newIds.reserve(soup.vertices.size());
    for (const Vec3& p : soup.vertices) {
        // Adding zero makes -0 and 0 the same key.
        const Key key{p.x() + 0.0, p.y() + 0.0, p.z() + 0.0};
        const auto [at, isNew] = ids.try_emplace(key, static_cast<int>(mesh.vertices.size()));
        if (isNew) {
            mesh.vertices.push_back(p);
        }
        newIds.push_back(at->second);
    }
    mesh.faces.reserve(soup.faces.size());
    for (Triangle face : soup.faces) {
        for (int& id : face) {
            id = newIds[id];
        }
        mesh.faces.push_back(face);
    }
    return mesh;
}

[[noreturn]] void refuseRepeating(
    const std::filesystem::path& file, const std::vector<std::int64_t>& faces
) {
    refuseElements(
        InputErrorCode::DegenerateFace,
        file.string() + ": " + describeCount(faces.size(), "face names", "faces name") +
            " a vertex twice",
        "faces",
        faces,
        "remove them"
    );
}

}  // namespace

MeshFile readMeshFile(const std::filesystem::path& file, RepeatedVertices repeated) {
    const std::string extension = lowerCaseExtension(file);
    const auto* const format = std::ranges::find(kMeshFormats, extension, &Format::extension);
    if (format == kMeshFormats.end()) {
        refuseFile(
            file, "the extension " + inQuotes(extension) + " is none of .ply, .obj, .off, .stl"
        );
    }
    ParsedMesh parsed = format->parse(file, readWholeFile(file));
    if (!parsed.repeating.empty() && repeated == RepeatedVertices::Refuse) {
        refuseRepeating(file, parsed.repeating);
    }
    if (parsed.mesh.faces.empty()) {
        refuseFile(file, "has no faces");
    }
    if (extension == ".stl") {
        parsed.mesh = welded(parsed.mesh);
    }
    return {.mesh = std::move(parsed.mesh), .quality = std::move(parsed.quality)};
}

TriangleMesh readMesh(const std::filesystem::path& file) {
    return readMeshFile(file).mesh;
}

}  // namespace bspline_curve

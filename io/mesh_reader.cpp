// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/mesh_reader.h"

#include "io/file_checks.h"
#include "io/text_parsing.h"
#include "io/vcglib_import.h"

#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <utility>

namespace bspline_curve {

namespace {

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
            id = newIds[static_cast<std::size_t>(id)];
        }
        mesh.faces.push_back(face);
    }
    return mesh;
}

/// The importers report some failures by a shorter mesh only.
void checkImported(
    const std::filesystem::path& file, const ExpectedMesh& expected, const ImportedMesh& imported
) {
    if (!imported.error.empty()) {
        refuseFile(file, imported.error);
    }
    const TriangleMesh& mesh = imported.mesh;
    if (mesh.vertices.size() != expected.vertices || mesh.faces.size() != expected.triangles) {
        refuseFile(
            file,
            "vcglib could read only " + std::to_string(mesh.vertices.size()) + " of " +
                std::to_string(expected.vertices) + " vertices and " +
                std::to_string(mesh.faces.size()) + " of " + std::to_string(expected.triangles) +
                " triangles; save it again with MeshLab"
        );
    }
    for (const Triangle& face : mesh.faces) {
        for (const int id : face) {
            if (id < 0 || static_cast<std::size_t>(id) >= mesh.vertices.size()) {
                refuseFile(file, "vcglib read a face of vertices that do not exist");
            }
        }
    }
}

}  // namespace

MeshFile readMeshFile(const std::filesystem::path& file) {
    const std::string extension = lowerCaseExtension(file);
    const bool known =
        extension == ".ply" || extension == ".obj" || extension == ".off" || extension == ".stl";
    if (!known) {
        refuseFile(
            file, "the extension " + inQuotes(extension) + " is none of .ply, .obj, .off, .stl"
        );
    }
    const std::string bytes = readWholeFile(file);
    ExpectedMesh expected;
    ImportedMesh imported;
    if (extension == ".ply") {
        expected = checkPly(file, bytes);
        imported = importPly(file, expected.quality);
    } else if (extension == ".obj") {
        expected = checkObj(file, bytes);
        imported = importObj(file);
    } else if (extension == ".stl") {
        expected = checkStl(file, bytes);
        imported = importStl(file);
    } else {
        const CheckedOff off = checkOff(file, bytes);
        expected = off.expected;
        imported = importOffText(off.text);
    }
    checkImported(file, expected, imported);
    if (imported.mesh.faces.empty()) {
        refuseFile(file, "has no faces");
    }
    if (extension == ".stl") {
        imported.mesh = welded(imported.mesh);
    }
    return {.mesh = std::move(imported.mesh), .quality = std::move(imported.quality)};
}

TriangleMesh readMesh(const std::filesystem::path& file) {
    return readMeshFile(file).mesh;
}

}  // namespace bspline_curve

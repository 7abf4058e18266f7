// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/mesh_reader.h"

#include "io/file_checks.h"
#include "io/text_parsing.h"
#include "io/vcglib_import.h"
#include "surface/input_error.h"

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
            id = newIds[id];
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

/// Puts back what the importer has left out, so that faces are numbered as in the file.
void insertOmitted(std::vector<Triangle>& faces, const std::vector<OmittedTriangle>& omitted) {
    if (omitted.empty()) {
        return;
    }
    std::vector<Triangle> all;
    all.reserve(faces.size() + omitted.size());
    auto rest = faces.begin();
    for (const auto& [place, corners] : omitted) {
        while (all.size() < place && rest != faces.end()) {
            all.push_back(*rest++);
        }
        all.push_back(corners);
    }
    all.insert(all.end(), rest, faces.end());
    faces = std::move(all);
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
        "remove them with MeshLab's filter 'Remove Zero Area Faces'"
    );
}

}  // namespace

MeshFile readMeshFile(const std::filesystem::path& file, RepeatedVertices repeated) {
    const std::string extension = lowerCaseExtension(file);
    const bool known =
        extension == ".ply" || extension == ".obj" || extension == ".off" || extension == ".stl";
    if (!known) {
        refuseFile(
            file, "the extension " + inQuotes(extension) + " is none of .ply, .obj, .off, .stl"
        );
    }
    const std::string bytes = readWholeFile(file);
    const auto checked = [&](ExpectedMesh found) {
        if (!found.repeating.empty() && repeated == RepeatedVertices::Refuse) {
            refuseRepeating(file, found.repeating);
        }
        return found;
    };
    ExpectedMesh expected;
    ImportedMesh imported;
    if (extension == ".ply") {
        expected = checked(checkPly(file, bytes));
        imported = importPly(file, expected.quality);
    } else if (extension == ".obj") {
        expected = checked(checkObj(file, bytes));
        imported = importObj(file);
    } else if (extension == ".stl") {
        expected = checkStl(file, bytes);
        imported = importStl(file);
    } else {
        const CheckedOff off = checkOff(file, bytes);
        expected = off.expected;
        imported = importOffText(off.text);
    }
    insertOmitted(imported.mesh.faces, expected.omitted);
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

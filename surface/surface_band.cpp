// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/surface_band.h"

#include "surface/index_sets.h"
#include "surface/input_error.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <unordered_set>
#include <utility>

namespace bspline_curve {
namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

void checkFaces(const Surface& surface, std::span<const int> faces) {
    if (faces.empty()) {
        throw InputError(InputErrorCode::EmptyMesh, "a band needs at least one face");
    }
    std::vector<std::int64_t> bad;
    for (const int face : faces) {
        if (face < 0 || face >= surface.faceCount()) {
            bad.push_back(face);
        }
    }
    if (!bad.empty()) {
        std::ranges::sort(bad);
        refuseElements(
            InputErrorCode::IndexOutOfRange,
            describeCount(bad.size(), "face does", "faces do") + " not exist",
            "faces",
            bad,
            "give indices below " + std::to_string(surface.faceCount())
        );
    }
}

// Adds faces to a set of faces until no vertex has two separate fans of them.
class FanJoiner {
public:
    FanJoiner(const Surface& surface, std::span<const int> faces) : surface_(surface) {
        for (const int face : faces) {
            add(face);
        }
    }

    [[nodiscard]] std::vector<int> run() {
        while (!pending_.empty()) {
            const int v = pending_.back();
            pending_.pop_back();
            if (fanCount(v) < 2) {
                continue;
            }
            for (const int face : surface_.facesAround(v)) {
                add(face);
            }
        }
        std::vector<int> faces(faces_.begin(), faces_.end());
        std::ranges::sort(faces);
        return faces;
    }

private:
    void add(int face) {
        if (faces_.insert(face).second) {
            const Triangle& corners = surface_.faces()[at(face)];
            pending_.insert(pending_.end(), corners.begin(), corners.end());
        }
    }

    // Number of runs of faces of the set around a vertex.
    [[nodiscard]] int fanCount(int v) const {
        const Surface::FaceRange around = surface_.facesAround(v);
        bool isBefore = !surface_.isBoundaryVertex(v) && faces_.contains(*(around.end() - 1));
        int starts = 0;
        for (const int face : around) {
            const bool isHere = faces_.contains(face);
            starts += static_cast<int>(isHere && !isBefore);
            isBefore = isHere;
        }
        return starts;
    }

    const Surface& surface_;
    std::unordered_set<int> faces_;
    std::vector<int> pending_;  // vertices to look at (again)
};

}  // namespace

int SurfaceBand::indexOf(int face) const {
    return indexIn(faces, face);
}

SurfaceBand cutBand(const Surface& whole, std::span<const int> faces) {
    checkFaces(whole, faces);
    std::vector<int> kept = FanJoiner(whole, faces).run();
    std::vector<int> vertices;
    vertices.reserve(3 * kept.size());
    for (const int face : kept) {
        const Triangle& corners = whole.faces()[at(face)];
        vertices.insert(vertices.end(), corners.begin(), corners.end());
    }
    sortUnique(vertices);
    TriangleMesh mesh;
    mesh.vertices.reserve(vertices.size());
    for (const int v : vertices) {
        mesh.vertices.push_back(whole.vertices()[at(v)]);
    }
    mesh.faces.reserve(kept.size());
    for (const int face : kept) {
        const Triangle& corners = whole.faces()[at(face)];
        mesh.faces.push_back(
            {indexIn(vertices, corners[0]),
             indexIn(vertices, corners[1]),
             indexIn(vertices, corners[2])}
        );
    }
    return {
        .surface = Surface(std::move(mesh)),
        .faces = std::move(kept),
        .vertices = std::move(vertices)
    };
}

std::vector<int> facesNear(const Surface& surface, std::span<const int> path, int count) {
    checkFaces(surface, path);
    if (count < 1) {
        throw InputError(
            InputErrorCode::BadOption,
            "the number of faces of a band must be >= 1, not " + std::to_string(count)
        );
    }
    std::vector<int> found(path.begin(), path.end());
    sortUnique(found);
    std::unordered_set<int> known(found.begin(), found.end());
    std::unordered_set<int> passed;  // vertices
    for (std::size_t i = 0; i < found.size() && found.size() < at(count); ++i) {
        for (const int v : surface.faces()[at(found[i])]) {
            if (!passed.insert(v).second) {
                continue;
            }
            for (const int face : surface.facesAround(v)) {
                if (found.size() < at(count) && known.insert(face).second) {
                    found.push_back(face);
                }
            }
        }
    }
    std::ranges::sort(found);
    return found;
}

}  // namespace bspline_curve

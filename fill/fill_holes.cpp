// SPDX-License-Identifier: GPL-3.0-or-later
#include "fill/fill_holes.h"

#include "bspline_curve/error.h"
#include "fill/patch_fairing.h"
#include "fill/patch_refinement.h"
#include "fill/rim_triangulation.h"
#include "surface/error_messages.h"
#include "surface/half_edges.h"
#include "surface/mesh_checks.h"
#include "utility/index_sets.h"
#include "utility/report_progress.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <map>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

namespace bspline_curve {

namespace {

constexpr int kFairingSteps = 20;
/// Points of a rim that is filled smoothly that are triangulated at once.
constexpr int kFewRimPoints = 120;
/// How far a middle in line with an edge is lifted off it, relative to the edges around.
constexpr double kLift = 1e-3;
constexpr int kSizeAverages = 4;  // along the rim, since faces beside curves are uneven

Vec3 normalOf(const TriangleMesh& mesh, const Triangle& face) {
    const Vec3& a = mesh.vertices[face[0]];
    return (mesh.vertices[face[1]] - a).cross(mesh.vertices[face[2]] - a);
}

/// The vertices of all rims, numbered.
class RimPlaces {
public:
    RimPlaces(const std::vector<std::vector<int>>& rims, std::size_t vertexCount)
        : placeOf_(vertexCount, -1) {
        for (const std::vector<int>& rim : rims) {
            for (const int vertex : rim) {
                if (placeOf_[vertex] < 0) {
                    placeOf_[vertex] = static_cast<int>(rimCounts_.size());
                    rimCounts_.push_back(0);
                }
                ++rimCounts_[placeOf_[vertex]];
            }
        }
    }

    [[nodiscard]] std::size_t count() const { return rimCounts_.size(); }

    /// -1 for a vertex on none of the rims.
    [[nodiscard]] int placeOf(int vertex) const { return placeOf_[vertex]; }

    /// Whether several rims meet there.
    [[nodiscard]] bool isShared(int place) const { return rimCounts_[place] > 1; }

private:
    std::vector<int> placeOf_;
    std::vector<int> rimCounts_;  // by place
};

struct MeanLength {
    double sum = 0.0;
    int count = 0;

    void add(double length) {
        sum += length;
        ++count;
    }

    [[nodiscard]] double mean() const { return sum / count; }
};

/// For each vertex on no rim, of the sides of faces that end there and on no rim either.
std::vector<MeanLength> lengthsOffRims(const TriangleMesh& mesh, const RimPlaces& places) {
    std::vector<MeanLength> result(mesh.vertices.size());
    for (const Triangle& face : mesh.faces) {
        for (int k = 0; k < 3; ++k) {
            const int a = face[k];
            const int b = face[(k + 1) % 3];
            if (places.placeOf(a) < 0 && places.placeOf(b) < 0) {
                const double length = (mesh.vertices[b] - mesh.vertices[a]).norm();
                result[a].add(length);
                result[b].add(length);
            }
        }
    }
    return result;
}

/// What is beside the vertex of a rim.
struct Beside {
    Vec3 laplacian = Vec3::Zero();  ///< as in RimSurroundings
    Vec3 normal = Vec3::Zero();
    MeanLength sides;             ///< of the faces' sides that end there
    MeanLength beyond;            ///< of those that end at its neighbours, and not on rims
    std::vector<int> neighbours;  ///< places with an edge to this one

    /// The length that edges have around. Beside a curve that was cut along edges are pieces of
    /// those of the mesh, so that those a step farther tell more.
    [[nodiscard]] double size() const { return beyond.count > 0 ? beyond.mean() : sides.mean(); }
};

std::vector<Beside> besideRims(const TriangleMesh& mesh, const RimPlaces& places) {
    const std::vector<MeanLength> offRims = lengthsOffRims(mesh, places);
    std::vector<Beside> result(places.count());
    for (const Triangle& face : mesh.faces) {
        for (int k = 0; k < 3; ++k) {
            const int place = places.placeOf(face[k]);
            if (place < 0) {
                continue;
            }
            Beside& beside = result[place];
            const Vec3 normal = normalOf(mesh, face);
            const int next = face[(k + 1) % 3];
            const int last = face[(k + 2) % 3];
            const Vec3 side = mesh.vertices[last] - mesh.vertices[next];
            // The sum of cotangent weights times differences within one face.
            beside.laplacian += 0.5 * side.cross(normal.stableNormalized());
            beside.normal += normal;
            for (const int end : {next, last}) {
                beside.sides.add((mesh.vertices[end] - mesh.vertices[face[k]]).norm());
                if (places.placeOf(end) >= 0) {
                    beside.neighbours.push_back(places.placeOf(end));
                } else if (offRims[end].count > 0) {
                    beside.beyond.add(offRims[end].mean());
                }
            }
        }
    }
    return result;
}

/// The lengths that edges at the rim should have: those beside it, averaged along the rim.
std::vector<double> averagedAlong(std::vector<double> sizes) {
    const std::size_t count = sizes.size();
    for (int pass = 0; pass < kSizeAverages; ++pass) {
        std::vector<double> averaged(count);
        for (std::size_t i = 0; i < count; ++i) {
            averaged[i] =
                0.25 * (sizes[(i + count - 1) % count] + sizes[(i + 1) % count]) + 0.5 * sizes[i];
        }
        sizes = std::move(averaged);
    }
    return sizes;
}

class HoleFiller {
public:
    HoleFiller(const TriangleMesh& mesh, const std::vector<std::vector<int>>& rims)
        : rims_(rims),
          places_(rims, mesh.vertices.size()),
          beside_(besideRims(mesh, places_)),
          result_{.mesh = mesh, .firstNew = {}} {}

    void fill(std::size_t rim, FillShape shape, const Progress& progress) {
        report(progress, 0.0, "filling a hole");
        Patch patch = patchOf(rim, shape);
        if (shape == FillShape::Smooth) {
            const RimSurroundings around = surroundings(rim);
            Patch smooth = patch;
            refinePatch(smooth, Relaxing::Free, partOf(progress, 0.1, 0.4));
            fairPatch(smooth, around, 1, partOf(progress, 0.4, 0.5));
            refinePatch(smooth, Relaxing::Tangential, partOf(progress, 0.5, 0.6));
            fairPatch(smooth, around, kFairingSteps, partOf(progress, 0.6, 1.0));
            // Rims with narrow ends can pull new vertices onto a line with theirs.
            if (!hasFlatFace(smooth)) {
                patch = std::move(smooth);
            }
        }
        append(patch, rim);
    }

    [[nodiscard]] FilledMesh take() { return std::move(result_); }

private:
    static bool hasFlatFace(const Patch& patch) {
        return std::ranges::any_of(patch.faces, [&](const Triangle& face) {
            return !hasArea(patch.points[face[0]], patch.points[face[1]], patch.points[face[2]]);
        });
    }

    [[nodiscard]] Patch patchOf(std::size_t rim, FillShape shape) const {
        const std::vector<int>& vertices = rims_[rim];
        Patch patch{
            .points = {},
            .sizes = {},
            .faces = {},
            .rimCount = static_cast<int>(vertices.size()),
            .forbidden = {}
        };
        std::map<int, int> localOf;  // by place
        for (const int vertex : vertices) {
            const int place = places_.placeOf(vertex);
            localOf.emplace(place, static_cast<int>(patch.points.size()));
            patch.points.push_back(result_.mesh.vertices[vertex]);
            patch.sizes.push_back(beside_[place].size());
        }
        patch.sizes = averagedAlong(std::move(patch.sizes));
        for (const auto& [place, local] : localOf) {
            for (const int neighbour : beside_[place].neighbours) {
                const auto other = localOf.find(neighbour);
                if (other != localOf.end()) {
                    const auto [low, high] = std::minmax(local, other->second);
                    patch.forbidden.insert({low, high});
                }
            }
        }
        // What is refined afterwards need not begin with the least area.
        if (shape == FillShape::Smooth) {
            patch.faces = triangulateRim(patch.points, patch.forbidden, kFewRimPoints);
        }
        if (patch.faces.empty()) {
            patch.faces = triangulateRim(patch.points, patch.forbidden);
        }
        if (patch.faces.empty() || isFaceOfMesh(vertices)) {
            closeWithMiddle(patch, rim, shape);
        }
        return patch;
    }

    [[nodiscard]] bool isFaceOfMesh(const std::vector<int>& rim) const {
        return rim.size() == 3 &&
               std::ranges::any_of(result_.mesh.faces, [&](const Triangle& face) {
                   return std::ranges::all_of(face, [&](int v) { return contains(rim, v); });
               });
    }

    /// Fills a rim that has no triangulation of its own with faces round a new point.
    void closeWithMiddle(Patch& patch, std::size_t rim, FillShape shape) const {
        if (shape == FillShape::Flat) {
            refuse(
                rim,
                "cannot be filled without a new vertex: each triangulation has a flat face, or an "
                "edge that the mesh has already"
            );
        }
        const int count = patch.rimCount;
        Vec3 middle = Vec3::Zero();
        double size = 0.0;
        for (int i = 0; i < count; ++i) {
            middle += patch.points[i] / count;
            size += patch.sizes[i] / count;
        }
        patch.points.push_back(middle);
        patch.sizes.push_back(size);
        patch.faces.clear();
        for (int i = 0; i < count; ++i) {
            patch.faces.push_back({i, (i + 1) % count, count});
        }
        if (hasFlatFace(patch)) {  // the middle is in line with an edge of the rim
            Vec3 area = Vec3::Zero();
            for (int i = 0; i < count; ++i) {
                area += (patch.points[i] - middle).cross(patch.points[(i + 1) % count] - middle);
            }
            patch.points.back() += kLift * size * area.normalized();
        }
    }

    [[nodiscard]] RimSurroundings surroundings(std::size_t rim) const {
        RimSurroundings around;
        for (const int vertex : rims_[rim]) {
            const int place = places_.placeOf(vertex);
            around.laplacians.push_back(beside_[place].laplacian);
            around.normals.push_back(beside_[place].normal);
            // Where rims meet, faces of the other patches are missing.
            around.isKnown.push_back(places_.isShared(place) ? 0 : 1);
        }
        return around;
    }

    void append(const Patch& patch, std::size_t rim) {
        std::vector<int> vertexOf = rims_[rim];
        result_.firstNew.push_back(static_cast<int>(result_.mesh.vertices.size()));
        for (std::size_t i = vertexOf.size(); i < patch.points.size(); ++i) {
            vertexOf.push_back(static_cast<int>(result_.mesh.vertices.size()));
            result_.mesh.vertices.push_back(patch.points[i]);
        }
        for (const Triangle& face : patch.faces) {
            const Triangle added{vertexOf[face[0]], vertexOf[face[1]], vertexOf[face[2]]};
            const std::vector<Vec3>& points = result_.mesh.vertices;
            if (!hasArea(points[added[0]], points[added[1]], points[added[2]])) {
                refuse(rim, "cannot be filled: a new face would have no area");
            }
            result_.mesh.faces.push_back(added);
            for (int k = 0; k < 3; ++k) {
                if (patch.isOnRim(face[k]) && patch.isOnRim(face[(k + 1) % 3])) {
                    const int from = places_.placeOf(added[k]);
                    const int to = places_.placeOf(added[(k + 1) % 3]);
                    beside_[from].neighbours.push_back(to);
                    beside_[to].neighbours.push_back(from);
                }
            }
        }
    }

    [[noreturn]] void refuse(std::size_t rim, const std::string& why) const {
        std::vector<std::int64_t> vertices(rims_[rim].begin(), rims_[rim].end());
        const std::string hole = "a hole of " + describeCount(vertices.size(), "edge", "edges");
        refuseElements(
            InputErrorCode::NoPath,
            hole + " " + why,
            "vertices",
            std::move(vertices),
            "choose another shape to fill it with, or move the curve"
        );
    }

    const std::vector<std::vector<int>>& rims_;
    RimPlaces places_;
    std::vector<Beside> beside_;  // by place
    FilledMesh result_;
};

}  // namespace

std::vector<std::vector<int>> rimsOf(const std::vector<Triangle>& faces) {
    std::map<int, int> next;
    forEachEdge(sortedHalfEdges(faces), [&](std::span<const HalfEdge> sides) {
        if (sides.size() == 1) {
            const Triangle& face = faces[sides[0].face];
            const int from = face[(sides[0].k + 2) % 3];
            if (!next.emplace(from, face[(sides[0].k + 1) % 3]).second) {
                throw std::logic_error("two rims meet at vertex " + std::to_string(from));
            }
        }
    });
    std::vector<std::vector<int>> rims;
    while (!next.empty()) {
        std::vector<int> rim;
        for (int vertex = next.begin()->first; next.contains(vertex);) {
            rim.push_back(vertex);
            const auto at = next.find(vertex);
            vertex = at->second;
            next.erase(at);
        }
        rims.push_back(std::move(rim));
    }
    return rims;
}

FilledMesh fillHoles(
    const TriangleMesh& mesh,
    const std::vector<std::vector<int>>& rims,
    FillShape shape,
    const Progress& progress
) {
    HoleFiller filler(mesh, rims);
    for (std::size_t rim = 0; rim < rims.size(); ++rim) {
        filler.fill(rim, shape, stepOf(progress, rim, rims.size()));
    }
    return filler.take();
}

}  // namespace bspline_curve

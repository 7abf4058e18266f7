// SPDX-License-Identifier: GPL-3.0-or-later
#include "fill/raised_parts.h"

#include "bspline_curve/error.h"
#include "fill/patch_checker.h"
#include "fill/settled_ways.h"
#include "imprint/imprint.h"
#include "surface/vertex_normals.h"
#include "utility/index_sets.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>

namespace bspline_curve {

namespace {

/// Walls are no lower than this, relative to the height.
constexpr double kLeastHeightShare = 0.02;
/// Ways are no longer than this many heights, as at the vertex of a ridge of 60 degrees.
constexpr double kLongestWay = 2.0;

/// Unit normals at the vertices of an imprint: those of the mesh without it, linear in each face,
/// so that they change little across small faces.
std::vector<Vec3> normalsOn(const ImprintedMesh& imprinted) {
    const TriangleMesh before = withoutImprint(imprinted);
    std::vector<Vec3> normals = interpolatedOwn(imprinted, before.faces, vertexNormals(before));
    for (std::size_t v = before.vertices.size(); v < normals.size(); ++v) {
        normals[v] = normals[v].stableNormalized();
    }
    return normals;
}

class PartRaiser {
public:
    PartRaiser(
        const ImprintedMesh& imprinted,
        const MeshParts& parts,
        const std::vector<int>& chosen,
        double height,
        const std::vector<double>& shares
    )
        : imprinted_(imprinted), parts_(parts), chosen_(chosen), height_(height), shares_(shares) {
        edges_ = edgesAround(imprinted, parts, chosen);
        cut_ = cutAlongEdges(imprinted.mesh, edges_);
        result_.whole = wholeImprint(imprinted, parts);
        raised_.resize(cut_.mesh.vertices.size(), -1);
    }

    RaisedParts run(const Progress& progress) {
        findBase();
        ways_.resize(imprinted_.mesh.vertices.size(), Vec3::Zero());
        const std::vector<Vec3> ways = directions();
        for (std::size_t f = 0; f < parts_.labels.size(); ++f) {
            if (isChosen(f)) {
                raise(f, ways);
            }
        }
        if (shares_.empty()) {
            addWalls();
        }
        settle(progress);
        return std::move(result_);
    }

private:
    [[nodiscard]] bool isChosen(std::size_t face) const {
        return std::ranges::binary_search(chosen_, parts_.labels[face]);
    }

    /// For one unit of height where each vertex goes: along its normal, and so far that the chosen
    /// faces at it come to lie at the height, in the mean of their areas. The volume is then that
    /// of the prisms on them, up to the square of the height.
    [[nodiscard]] std::vector<Vec3> directions() const {
        std::vector<Vec3> directions = normalsOn(imprinted_);
        std::vector<double> areas(directions.size(), 0.0);
        std::vector<double> lifted(directions.size(), 0.0);
        const TriangleMesh& mesh = imprinted_.mesh;
        for (std::size_t f = 0; f < parts_.labels.size(); ++f) {
            if (isChosen(f)) {
                const auto& [a, b, c] = mesh.faces[f];
                const Vec3& corner = mesh.vertices[a];
                const Vec3 normal = (mesh.vertices[b] - corner).cross(mesh.vertices[c] - corner);
                for (const int vertex : mesh.faces[f]) {
                    areas[vertex] += normal.norm();
                    lifted[vertex] += normal.dot(directions[vertex]);
                }
            }
        }
        for (std::size_t v = 0; v < directions.size(); ++v) {
            if (areas[v] > 0.0) {
                directions[v] *= areas[v] / std::max(lifted[v], areas[v] / kLongestWay);
            }
        }
        return directions;
    }

    /// Vertices of faces that stay where they are, and those of these that walls stand on.
    void findBase() {
        isBase_.resize(imprinted_.mesh.vertices.size(), false);
        for (std::size_t f = 0; f < parts_.labels.size(); ++f) {
            if (!isChosen(f)) {
                const Triangle& face = imprinted_.mesh.faces[f];
                for (std::size_t k = 0; k < 3; ++k) {
                    isBase_[face[k]] = true;
                    const auto [low, high] = std::minmax(face[k], face[(k + 1) % 3]);
                    if (std::ranges::binary_search(edges_, std::array{low, high})) {
                        below_[{low, high}] = static_cast<int>(f);
                    }
                }
            }
        }
    }

    void raise(std::size_t face, const std::vector<Vec3>& directions) {
        TriangleMesh& mesh = result_.whole.mesh;
        for (std::size_t k = 0; k < 3; ++k) {
            int& raised = raised_[cut_.mesh.faces[face][k]];
            if (raised < 0) {
                const int vertex = imprinted_.mesh.faces[face][k];
                raised = vertex;
                if (isBase_[vertex] && !shares_.empty()) {
                    continue;
                }
                if (isBase_[vertex]) {
                    raised = static_cast<int>(mesh.vertices.size());
                    mesh.vertices.push_back(mesh.vertices[vertex]);
                    result_.whole.source.push_back(vertex);
                }
                ways_.resize(mesh.vertices.size(), Vec3::Zero());
                ways_[raised] =
                    (shares_.empty() ? height_ : height_ * shares_[vertex]) * directions[vertex];
            }
            mesh.faces[face][k] = raised;
        }
    }

    /// Between the edges of raised faces on the rim and those of the faces beside them.
    void addWalls() {
        FilledParts& whole = result_.whole;
        for (std::size_t f = 0; f < parts_.labels.size(); ++f) {
            if (!isChosen(f)) {
                continue;
            }
            const Triangle& foot = imprinted_.mesh.faces[f];
            const Triangle top = whole.mesh.faces[f];
            for (std::size_t k = 0; k < 3; ++k) {
                const std::size_t next = (k + 1) % 3;
                const auto [low, high] = std::minmax(foot[k], foot[next]);
                if (std::ranges::binary_search(edges_, std::array{low, high})) {
                    whole.mesh.faces.push_back({foot[k], foot[next], top[next]});
                    whole.mesh.faces.push_back({foot[k], top[next], top[k]});
                    const int above = static_cast<int>(f);
                    const int below = below_.at({low, high});
                    whole.walls.push_back({below, below, above});
                    whole.walls.push_back({below, above, above});
                }
            }
        }
        whole.faces.resize(whole.mesh.faces.size(), -1);
        whole.labels.resize(whole.mesh.faces.size(), -1);
    }

    /// For each vertex of the whole mesh itself, of copies the first one that was raised: where the
    /// parts meet themselves in a vertex they do not cross.
    [[nodiscard]] std::vector<int> firstCopies() const {
        std::vector<int> first(result_.whole.source.size());
        std::vector<int> copyOf(imprinted_.mesh.vertices.size(), -1);
        for (std::size_t v = 0; v < first.size(); ++v) {
            first[v] = static_cast<int>(v);
            if (v >= copyOf.size()) {
                int& copy = copyOf[result_.whole.source[v]];
                copy = copy < 0 ? first[v] : copy;
                first[v] = copy;
            }
        }
        return first;
    }

    /// The faces that are moved, and walls, with those that stay.
    struct MovingFaces {
        TriangleMesh kept, sheet;  // the sheet without walls
        std::vector<int> ids;      // of the patch's faces in the whole mesh
        std::vector<int> rim;      // vertices that stay
        Patch patch;               // with walls; its first points are the rim, then all vertices
    };

    /// `first`: see firstCopies().
    [[nodiscard]] MovingFaces movingFaces(const std::vector<int>& first) const {
        const TriangleMesh& mesh = result_.whole.mesh;
        MovingFaces moving;
        moving.kept.vertices = imprinted_.mesh.vertices;
        moving.sheet.vertices = mesh.vertices;
        for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
            if (f < parts_.labels.size() && !isChosen(f)) {
                moving.kept.faces.push_back(mesh.faces[f]);
                continue;
            }
            moving.ids.push_back(static_cast<int>(f));
            Triangle& face = moving.sheet.faces.emplace_back(mesh.faces[f]);
            for (int& corner : face) {
                corner = first[corner];
                if (isOnBase(corner)) {
                    moving.rim.push_back(corner);
                }
            }
        }
        sortUnique(moving.rim);
        Patch& patch = moving.patch;
        patch.rimCount = static_cast<int>(moving.rim.size());
        for (const int vertex : moving.rim) {
            patch.points.push_back(mesh.vertices[vertex]);
        }
        patch.faces = moving.sheet.faces;
        for (Triangle& face : patch.faces) {
            for (int& corner : face) {
                corner = isOnBase(corner) ? indexIn(moving.rim, corner) : patch.rimCount + corner;
            }
        }
        moving.sheet.faces.resize(moving.sheet.faces.size() - result_.whole.walls.size());
        return moving;
    }

    /// Moves vertices as far as that crosses nothing.
    void settle(const Progress& progress) {
        TriangleMesh& mesh = result_.whole.mesh;
        const std::vector<int> first = firstCopies();
        MovingFaces moving = movingFaces(first);
        Patch& patch = moving.patch;
        PatchChecker checker(moving.kept);
        checker.begin(moving.rim, std::abs(height_));
        const double least = shares_.empty() ? kLeastHeightShare : 0.0;
        SettledWays settled(moving.sheet, ways_, height_, least);
        std::vector<int> bad;
        const auto crossing = [&](const std::vector<Vec3>& points, bool isStrict) {
            patch.points.resize(moving.rim.size());
            patch.points.insert(patch.points.end(), points.begin(), points.end());
            bad = checker.badFaces(patch, isStrict);
            return innerCorners(patch, bad);
        };
        settled.settle(crossing, progress);
        mesh.vertices = settled.points();
        for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
            mesh.vertices[v] = mesh.vertices[first[v]];
            const double share = settled.shares()[first[v]];
            result_.lower += share < 1.0 ? 1 : 0;
            result_.least = std::min(result_.least, share);
        }
        for (const int face : bad) {
            result_.whole.crossing.push_back(moving.ids[face]);
        }
    }

    /// Whether a vertex of the whole mesh stays where it is.
    [[nodiscard]] bool isOnBase(int vertex) const {
        return vertex < static_cast<int>(isBase_.size()) && isBase_[vertex];
    }

    const ImprintedMesh& imprinted_;
    const MeshParts& parts_;
    const std::vector<int>& chosen_;
    double height_;
    const std::vector<double>& shares_;
    std::vector<std::array<int, 2>> edges_;    // of curves around the parts
    CutMesh cut_;                              // parts it into fans of raised faces and of others
    std::vector<bool> isBase_;                 // for each imprinted vertex
    std::map<std::array<int, 2>, int> below_;  // by edges around the parts: faces that stay
    std::vector<int> raised_;                  // for each vertex of the cut; -1: not raised
    std::vector<Vec3> ways_;                   // for each vertex of the whole mesh
    RaisedParts result_;
};

}  // namespace

RaisedParts raisedParts(
    const ImprintedMesh& imprinted,
    const MeshParts& parts,
    const std::vector<int>& chosen,
    double height,
    const std::vector<double>& shares,
    const Progress& progress
) {
    if (!std::isfinite(height)) {
        throw InputError(InputErrorCode::BadOption, "the height of a relief must be finite");
    }
    if (height == 0.0) {
        return {.whole = wholeImprint(imprinted, parts)};
    }
    return PartRaiser(imprinted, parts, chosen, height, shares).run(progress);
}

}  // namespace bspline_curve

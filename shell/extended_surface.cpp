// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/extended_surface.h"

#include "bspline_curve/progress.h"
#include "shell/face_geometry.h"
#include "shell/pillar_directions.h"
#include "surface/surface_point.h"
#include "utility/index_sets.h"
#include "utility/large_array.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ranges>
#include <span>
#include <utility>

namespace bspline_curve {
namespace {

struct ExtensionConstants {
    /// Least cosine between an average of normals and each of them, for it to be the direction.
    double goodAverageCosine = 0.3;
    /// Smoothing may turn a direction as long as it keeps this cosine with the normals around.
    double smoothCosine = 0.8;
    /// Steps of singular vertices: most of them end after a few.
    int maxMoves = 60;
    /// Length of such a step, as a share of the way to the mean of the ring.
    double moveFraction = 0.25;
    /// Longest edge at a vertex among needles, in shortest ones.
    double needleRatio = 16.0;
    /// Width of the ghost strip, in mean lengths of the edges around a vertex.
    double ghostWidth = 0.5;
};

constexpr ExtensionConstants kExtension;

// The box of the vertices that faces refer to.
Eigen::AlignedBox3d boxOf(const Surface& surface) {
    Eigen::AlignedBox3d box;
    for (int v = 0; v < surface.vertexCount(); ++v) {
        if (!surface.facesAround(v).empty()) {
            box.extend(surface.vertices()[v]);
        }
    }
    return box;
}

class ExtendedSurfaceBuilder {
public:
    /// `normals`: of the surface's faces, unit, found with the directions.
    ExtendedSurfaceBuilder(
        const Surface& surface, ExtendedSurface& extended, std::vector<Vec3>& normals
    )
        : surface_(surface), extended_(extended), normals_(normals) {}

    void placeVertices(const ShellFrame& frame) {
        extended_.frame = frame;
        extended_.surfaceVertexCount = surface_.vertexCount();
        extended_.surfaceFaceCount = surface_.faceCount();
        reserveLarge(extended_.vertices, surface_.vertices().size());
        for (const Vec3& vertex : surface_.vertices()) {
            extended_.vertices.push_back(extended_.frame.toUnit(vertex));
        }
        reserveLarge(extended_.faces, surface_.faces().size());
        extended_.faces = surface_.faces();
        reserveLarge(extended_.faceNeighbours, surface_.faces().size());
        extended_.faceNeighbours = surface_.faceNeighbours();
    }

    void measureEdges() {
        extended_.edgeLengths = makeLarge(extended_.vertices.size(), 0.0);
        for (const Triangle& face : extended_.faces) {
            for (std::size_t k = 0; k < 3; ++k) {
                const int a = face[k];
                const int b = face[(k + 1) % 3];
                const double length = (extended_.vertices[a] - extended_.vertices[b]).norm();
                extended_.edgeLengths[a] += length;
                extended_.edgeLengths[b] += length;
            }
        }
        for (int v = 0; v < surface_.vertexCount(); ++v) {
            // Each face at a vertex counts two edges there.
            extended_.edgeLengths[v] /= std::max(1, 2 * surface_.facesAround(v).size());
        }
    }

    // Normals of faces, and their sums at vertices, each weighted by the angle of its corner.
    void sumNormals() {
        extended_.directions = makeLarge<Vec3>(extended_.vertices.size(), Vec3::Zero());
        extended_.normals = makeLarge<Vec3>(extended_.vertices.size(), Vec3::Zero());
        // Face by face, so that nothing of a face is computed or fetched for each of its corners.
        reserveLarge(normals_, extended_.faces.size());
        for (int f = 0; f < surface_.faceCount(); ++f) {
            const Vec3 cross = areaNormal(extended_, f);
            const double doubleArea = cross.norm();
            normals_.push_back(cross.normalized());
            const Triangle& face = extended_.faces[f];
            for (int k = 0; k < 3; ++k) {
                extended_.normals[face[k]] += cross;
                extended_.directions[face[k]] += cornerAngle(face, k, doubleArea) * normals_.back();
            }
        }
        for (int v = 0; v < surface_.vertexCount(); ++v) {
            extended_.normals[v].normalize();
        }
    }

    // Directions of all vertices; a vertex that none sees moves towards its ring's mean until one
    // does.
    void findDirections() {
        std::vector<int> unseen;
        for (int v = 0; v < surface_.vertexCount(); ++v) {
            if (surface_.facesAround(v).empty()) {
                extended_.directions[v] = Vec3::UnitZ();
            } else if (!chooseDirection(v, extended_.directions[v])) {
                unseen.push_back(v);
            }
        }
        std::vector<char> moved(extended_.vertices.size(), 0);
        for (int round = 0; round < kExtension.maxMoves && !unseen.empty(); ++round) {
            unseen = moveVertices(unseen, moved);
        }
        putBack(unseen, moved);
        for (int v = 0; v < surface_.vertexCount(); ++v) {
            if (moved[v] != 0) {
                extended_.movedVertices.push_back(v);
            }
        }
        extended_.unseenVertices = unseen;
    }

    // Averages directions of patches over the faces around each vertex, kept likewise.
    void takeDirectionsOf(const PatchLevels& patches) {
        const std::vector<Vec3> ofPatches = smoothPatchDirections(patches, normals_);
        const std::vector<int>& patchOf = patches.levels().front().patchOf;
        std::vector<Vec3> sums = makeLarge<Vec3>(extended_.vertices.size(), Vec3::Zero());
        for (std::size_t f = 0; f < extended_.faces.size(); ++f) {
            for (const int v : extended_.faces[f]) {
                sums[v] += ofPatches[patchOf[f]];
            }
        }
        for (int v = 0; v < surface_.vertexCount(); ++v) {
            turn(v, sums[v]);
        }
    }

    // Averages directions over the ring, each kept only where the smallest cosine does not suffer.
    void smoothDirections(int passes, const Progress& progress) {
        std::vector<Vec3> sums = makeLarge<Vec3>(extended_.vertices.size(), Vec3::Zero());
        for (int pass = 0; pass < passes; ++pass) {
            report(progress, static_cast<double>(pass) / passes, kPreparingStage);
            for (const Triangle& face : extended_.faces) {
                const Vec3 sum = extended_.directions[face[0]] + extended_.directions[face[1]] +
                                 extended_.directions[face[2]];
                for (const int v : face) {
                    sums[v] += sum;
                }
            }
            for (int v = 0; v < surface_.vertexCount(); ++v) {
                turn(v, std::exchange(sums[v], Vec3::Zero()));
            }
        }
    }

private:
    // Towards a sum of directions, where the pillar may.
    void turn(int v, const Vec3& sum) {
        const double length = sum.norm();
        if (length >= kLeastPillarCosine && mayTurn(v, sum / length)) {
            extended_.directions[v] = sum / length;
        }
    }

    [[nodiscard]] bool mayTurn(int v, const Vec3& direction) const {
        const auto normals = std::views::transform(
            surface_.facesAround(v), [&](int f) -> const Vec3& { return normals_[f]; }
        );
        const double after = leastCosine(direction, normals);
        return after >= kExtension.smoothCosine ||
               after >= leastCosine(extended_.directions[v], normals);
    }

    bool findDirection(int v) {
        Vec3 sum = Vec3::Zero();
        for (const int f : surface_.facesAround(v)) {
            const Triangle& face = extended_.faces[f];
            const double doubleArea = areaNormal(extended_, f).norm();
            sum += cornerAngle(face, cornerOf(face, v), doubleArea) * normals_[f];
        }
        return chooseDirection(v, sum);
    }

    // The average of the normals around a vertex, of which the sum is given, where it sees all
    // faces well, else the one that sees them best. Returns whether it sees all.
    bool chooseDirection(int v, const Vec3& sum) {
        star_.clear();
        for (const int f : surface_.facesAround(v)) {
            star_.push_back(normals_[f]);
        }
        const double length = sum.norm();
        const Vec3 average = sum / length;
        if (length > 0.0 && leastCosine(average, star_) >= kExtension.goodAverageCosine) {
            extended_.directions[v] = average;
            return true;
        }
        extended_.directions[v] = directionOfLeastAngle(star_);
        return leastCosine(extended_.directions[v], star_) >= kLeastPillarCosine;
    }

    [[nodiscard]] double cornerAngle(const Triangle& face, int k, double doubleArea) const {
        const Vec3& corner = extended_.vertices[face[k]];
        const Vec3 a = extended_.vertices[face[(k + 1) % 3]] - corner;
        const Vec3 b = extended_.vertices[face[(k + 2) % 3]] - corner;
        return std::atan2(doubleArea, a.dot(b));
    }

    // Vertices that no way led to a direction for: the surface there is as it was.
    void putBack(std::vector<int>& unseen, std::vector<char>& moved) {
        std::vector<int> touched;
        for (const int v : unseen) {
            extended_.vertices[v] = extended_.frame.toUnit(surface_.vertices()[v]);
            moved[v] = 0;
        }
        for (const int v : unseen) {
            for (const int f : surface_.facesAround(v)) {
                normals_[f] = areaNormal(extended_, f).normalized();
                touched.insert(touched.end(), extended_.faces[f].begin(), extended_.faces[f].end());
            }
        }
        sortUnique(touched);
        unseen.clear();
        for (const int v : touched) {
            if (!findDirection(v)) {
                unseen.push_back(v);
            }
        }
    }

    // How far the ring of a vertex counts at most, so that needles, which reach far beyond the fold
    // that the vertex is to leave, do not draw it along.
    [[nodiscard]] double reachOfRing(int v) const {
        double shortest = std::numeric_limits<double>::infinity();
        double longest = 0.0;
        for (const int f : surface_.facesAround(v)) {
            for (const int corner : surface_.faces()[f]) {
                if (corner != v) {
                    const Vec3 edge = surface_.vertices()[corner] - surface_.vertices()[v];
                    shortest = std::min(shortest, edge.norm());
                    longest = std::max(longest, edge.norm());
                }
            }
        }
        return longest > kExtension.needleRatio * shortest
                   ? shortest / extended_.frame.scale
                   : std::numeric_limits<double>::infinity();
    }

    // One step of all unseen vertices; returns those that are unseen now, ascending.
    std::vector<int> moveVertices(const std::vector<int>& unseen, std::vector<char>& moved) {
        std::vector<Vec3> targets;
        std::vector<int> touched;
        for (const int v : unseen) {
            const Vec3& here = extended_.vertices[v];
            const double reach = reachOfRing(v);
            Vec3 sum = Vec3::Zero();
            int count = 0;
            for (const int f : surface_.facesAround(v)) {
                for (const int corner : extended_.faces[f]) {
                    touched.push_back(corner);
                    if (corner != v) {
                        const Vec3& ring = extended_.vertices[corner];
                        const double distance = (ring - here).norm();
                        sum +=
                            distance > reach ? Vec3(here + reach / distance * (ring - here)) : ring;
                        ++count;
                    }
                }
            }
            targets.emplace_back(sum / count);
        }
        for (std::size_t i = 0; i < unseen.size(); ++i) {
            Vec3& p = extended_.vertices[unseen[i]];
            p += kExtension.moveFraction * (targets[i] - p);
            moved[unseen[i]] = 1;
        }
        for (const int v : unseen) {
            for (const int f : surface_.facesAround(v)) {
                normals_[f] = areaNormal(extended_, f).normalized();
            }
        }
        sortUnique(touched);
        std::vector<int> still;
        for (const int v : touched) {
            if (!findDirection(v)) {
                still.push_back(v);
            }
        }
        return still;
    }

    const Surface& surface_;
    ExtendedSurface& extended_;
    std::vector<Vec3>& normals_;
    std::vector<Vec3> star_;  // those around a vertex
};

// A boundary edge of a face, in the face's own order.
struct BoundaryEdge {
    int face, from, to;
};

// Grows the ghost strip: each boundary edge gets a quad, each boundary vertex one ghost.
class GhostBuilder {
public:
    GhostBuilder(const Surface& surface, ExtendedSurface& extended)
        : extended_(extended),
          nextEdge_(extended.vertices.size(), -1),
          previousEdge_(nextEdge_),
          ghostOf_(nextEdge_) {
        for (int f = 0; f < surface.faceCount(); ++f) {
            const Triangle& face = surface.faces()[f];
            for (std::size_t k = 0; k < 3; ++k) {
                if (surface.faceNeighbours()[f][k] < 0) {
                    const BoundaryEdge edge{f, face[(k + 1) % 3], face[(k + 2) % 3]};
                    nextEdge_[edge.from] = previousEdge_[edge.to] = static_cast<int>(edges_.size());
                    edges_.push_back(edge);
                }
            }
        }
    }

    void build() {
        for (const BoundaryEdge& edge : edges_) {
            if (previousEdge_[edge.from] >= 0) {
                placeGhost(edge, edges_[previousEdge_[edge.from]]);
            }
        }
        addFaces();
    }

private:
    [[nodiscard]] Vec3 outward(const BoundaryEdge& edge) const {
        const Vec3 normal = extended_.directions[edge.from] + extended_.directions[edge.to];
        return (extended_.vertices[edge.to] - extended_.vertices[edge.from])
            .cross(normal)
            .normalized();
    }

    // The ghost of the vertex from which an edge starts and to which the one before it leads.
    void placeGhost(const BoundaryEdge& edge, const BoundaryEdge& before) {
        const int v = edge.from;
        const Vec3 sum = outward(edge) + outward(before);
        const double length = sum.norm();
        const Vec3 direction = length > 0.0 ? Vec3(sum / length) : outward(edge);
        ghostOf_[v] = static_cast<int>(extended_.vertices.size());
        extended_.ghostSource.push_back(v);
        extended_.vertices.emplace_back(
            extended_.vertices[v] + kExtension.ghostWidth * extended_.edgeLengths[v] * direction
        );
        extended_.directions.push_back(extended_.directions[v]);
        extended_.edgeLengths.push_back(extended_.edgeLengths[v]);
    }

    // The quad beyond edge from->to is (to, from, from') and (to, from', to'). It is left out, and
    // the shell ends at that edge, where it would face backwards (narrow notches).
    void addFaces() {
        std::vector<int> firstFace(edges_.size(), -1);
        for (std::size_t e = 0; e < edges_.size(); ++e) {
            const auto& [face, from, to] = edges_[e];
            const Triangle inner = {to, from, ghostOf_[from]};
            const Triangle outer = {to, ghostOf_[from], ghostOf_[to]};
            if (ghostOf_[from] < 0 || ghostOf_[to] < 0 || !isUpright(inner) || !isUpright(outer)) {
                continue;
            }
            const int f = static_cast<int>(extended_.faces.size());
            firstFace[e] = f;
            extended_.faces.insert(extended_.faces.end(), {inner, outer});
            extended_.faceNeighbours.insert(
                extended_.faceNeighbours.end(), {{-1, f + 1, face}, {-1, -1, f}}
            );
            // The edge is opposite to the corner that is neither of its ends.
            const Triangle& corners = extended_.faces[face];
            extended_.faceNeighbours[face][3 - cornerOf(corners, from) - cornerOf(corners, to)] = f;
        }
        // Neighbouring quads share the edge from a boundary vertex to its ghost.
        for (std::size_t e = 0; e < edges_.size(); ++e) {
            const int after = nextEdge_[edges_[e].to];
            if (firstFace[e] >= 0 && after >= 0 && firstFace[after] >= 0) {
                extended_.faceNeighbours[firstFace[e] + 1][1] = firstFace[after];
                extended_.faceNeighbours[firstFace[after]][0] = firstFace[e] + 1;
            }
        }
    }

    [[nodiscard]] bool isUpright(const Triangle& face) const {
        const Vec3& corner = extended_.vertices[face[0]];
        const Vec3 normal =
            (extended_.vertices[face[1]] - corner).cross(extended_.vertices[face[2]] - corner);
        const double length = normal.norm();
        return std::ranges::all_of(face, [&](int v) {
            return normal.dot(extended_.directions[v]) > kLeastPillarCosine * length;
        });
    }

    ExtendedSurface& extended_;
    std::vector<BoundaryEdge> edges_;
    std::vector<int> nextEdge_, previousEdge_, ghostOf_;  // by vertex, -1 for none
};

}  // namespace

double longestSideOf(const ExtendedSurface& extended) {
    Eigen::AlignedBox3d box;
    for (int f = 0; f < extended.surfaceFaceCount; ++f) {
        for (const int v : extended.faces[f]) {
            box.extend(extended.vertices[v]);
        }
    }
    return box.isEmpty() ? 0.0 : box.sizes().maxCoeff();
}

double longestSideOf(const Surface& surface) {
    return boxOf(surface).sizes().maxCoeff();
}

RoughBase makeRoughBase(const Surface& surface, const Progress& progress) {
    report(progress, 0.0, kPreparingStage);
    RoughBase rough;
    ExtendedSurfaceBuilder builder(surface, rough.extended, rough.faceNormals);
    builder.placeVertices({boxOf(surface).center(), surface.diagonal()});
    report(progress, 0.2, kPreparingStage);
    builder.sumNormals();
    report(progress, 0.6, kPreparingStage);
    builder.findDirections();
    report(progress, 0.9, kPreparingStage);
    builder.measureEdges();
    return rough;
}

ExtendedSurface extendSurface(
    const Surface& surface,
    RoughBase rough,
    int smoothingPasses,
    const PatchLevels& patches,
    const Progress& progress
) {
    report(progress, 0.0, kPreparingStage);
    ExtendedSurfaceBuilder builder(surface, rough.extended, rough.faceNormals);
    if (smoothingPasses > 0 && patchesToSmoothOver(patches) != nullptr) {
        builder.takeDirectionsOf(patches);
        --smoothingPasses;  // that was one
    }
    builder.smoothDirections(smoothingPasses, partOf(progress, 0.4, 0.9));
    report(progress, 0.9, kPreparingStage);
    GhostBuilder(surface, rough.extended).build();
    return std::move(rough.extended);
}

ExtendedSurface extendSurface(
    const Surface& surface, int smoothingPasses, const Progress& progress
) {
    RoughBase rough = makeRoughBase(surface, partOf(progress, 0.0, 0.4));
    const PatchLevels patches(surface);
    return extendSurface(
        surface, std::move(rough), smoothingPasses, patches, partOf(progress, 0.4, 1.0)
    );
}

}  // namespace bspline_curve

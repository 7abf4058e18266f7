// SPDX-License-Identifier: GPL-3.0-or-later
#include "fill/thick_parts.h"

#include "bspline_curve/error.h"
#include "fill/part_sheet.h"
#include "fill/patch_checker.h"
#include "surface/half_edges.h"
#include "surface/vertex_normals.h"
#include "utility/index_sets.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

namespace bspline_curve {

namespace {

/// For each vertex of the imprint the way to where all faces around have moved by 1.
std::vector<Vec3> unitWays(const ImprintedMesh& imprinted) {
    // Mean normals count as that long at least: edges of more than 120 degrees are blunted.
    constexpr double kLeastMean = 0.5;
    const TriangleMesh before = withoutImprint(imprinted);
    std::vector<Vec3> ways = meanNormals(before);
    for (Vec3& way : ways) {
        way /= std::max(way.squaredNorm(), kLeastMean * kLeastMean);
    }
    for (const SurfacePoint& place : imprinted.ownPlaces) {
        Vec3 way = Vec3::Zero();
        for (int k = 0; k < 3; ++k) {
            way += place.barycentric[k] * ways[before.faces[place.face][k]];
        }
        ways.push_back(way);
    }
    return ways;
}

/// With one vertex where the part meets itself in one, so that this is no crossing.
TriangleMesh joinedMesh(const PartSheet& sheet) {
    TriangleMesh mesh = sheet.parts.mesh;
    for (Triangle& face : mesh.faces) {
        for (int& corner : face) {
            corner = sheet.first[corner];
        }
    }
    return mesh;
}

/// The other side of a wall, and how much of the thickness it has.
class OtherSide {
public:
    OtherSide(const PartSheet& sheet, std::vector<Vec3> ways, double thickness)
        : first_(sheet.first),
          sheet_(joinedMesh(sheet)),
          ways_(std::move(ways)),
          shares_(ways_.size(), 1.0),
          thickness_(std::abs(thickness)),
          checker_(sheet_) {
        for (const int vertex : sheet.rimVertices()) {
            rim_.push_back(first_[vertex]);
        }
        sortUnique(rim_);
        checker_.begin(rim_, thickness_);
        forEachEdge(sortedHalfEdges(sheet_.faces), [&](std::span<const HalfEdge> sides) {
            const auto& [low, high, face, k] = sides[0];
            edges_.push_back(
                {.a = low,
                 .b = high,
                 .length = (sheet_.vertices[low] - sheet_.vertices[high]).norm(),
                 .isOnRim = sides.size() == 1}
            );
        });
        for (const int vertex : rim_) {
            isOnRim_[vertex] = 1;
        }
        const auto rimCount = static_cast<int>(rim_.size());
        patch_.rimCount = rimCount;
        for (const auto& [a, b, c] : sheet_.faces) {
            patch_.faces.push_back({rimCount + a, rimCount + c, rimCount + b});
        }
        for (const auto& [from, to, face] : sheet.rim) {
            const int movedFrom = rimCount + first_[from];
            const int movedTo = rimCount + first_[to];
            const int a = indexIn(rim_, first_[from]);
            const int b = indexIn(rim_, first_[to]);
            patch_.faces.push_back({b, a, movedFrom});
            patch_.faces.push_back({b, movedFrom, movedTo});
        }
        for (const int vertex : rim_) {
            patch_.points.push_back(sheet_.vertices[vertex]);
        }
    }

    /// Faces that cross in the end: those of the other side, then those of walls.
    [[nodiscard]] std::vector<int> settle(const Progress& progress) {
        const std::vector<Vec3> straight = ways_;
        std::vector<int> bad = crossing();
        const std::size_t before = bad.size();
        int round = 0;
        const auto goOn = [&] {
            report(progress, static_cast<double>(++round) / kMostRounds, "thickening");
            return !bad.empty() && round <= kMostRounds;
        };
        while (goOn() && round <= kSmoothingRounds) {
            smoothAround(cornersOf(bad), round);
            bad = crossing();
        }
        if (!bad.empty() && bad.size() >= before) {
            ways_ = straight;
            bad = crossing();
        }
        while (goOn() && makeThinner(cornersOf(bad))) {
            bad = crossing();
        }
        return bad;
    }

    [[nodiscard]] std::vector<Vec3> points() const {
        std::vector<Vec3> points = sheet_.vertices;
        for (std::size_t v = 0; v < points.size(); ++v) {
            points[v] += shareOf(v) * ways_[first_[v]];
        }
        return points;
    }

    /// Of the thickness, at a vertex.
    [[nodiscard]] double shareOf(std::size_t vertex) const { return shares_[first_[vertex]]; }

private:
    struct Edge {
        int a, b;
        double length;
        bool isOnRim;
    };

    static constexpr int kMostRounds = 32;
    /// In the first rounds directions are smoothed alone, so that walls keep their thickness.
    static constexpr int kSmoothingRounds = 6;
    static constexpr int kPasses = 4;  // of smoothing, in a round
    /// Where faces cross, the wall keeps this share of its thickness in each round ...
    static constexpr double kThinner = 0.7;
    /// ... and is not made thinner than this one.
    static constexpr double kLeastShare = 0.02;
    /// Of the thickness along edges, where it was reduced.
    static constexpr double kSteepest = 0.5;

    std::vector<int> crossing() {
        patch_.points.resize(rim_.size());
        const std::vector<Vec3> moved = points();
        patch_.points.insert(patch_.points.end(), moved.begin(), moved.end());
        return checker_.badFaces(patch_, false);
    }

    /// Flags of vertices.
    [[nodiscard]] std::vector<char> cornersOf(const std::vector<int>& patchFaces) const {
        std::vector<char> flags(sheet_.vertices.size(), 0);
        for (const int face : patchFaces) {
            for (const int corner : patch_.faces[face]) {
                if (!patch_.isOnRim(corner)) {
                    flags[corner - patch_.rimCount] = 1;
                }
            }
        }
        return flags;
    }

    /// Ways become means of those around, of their own length; on the rim of those along it, so
    /// that walls do not fold. The region grows with the rounds.
    void smoothAround(std::vector<char> near, int rings) {
        for (int ring = 0; ring < rings; ++ring) {
            std::vector<char> wider = near;
            for (const Edge& edge : edges_) {
                wider[edge.a] = static_cast<char>(wider[edge.a] | near[edge.b]);
                wider[edge.b] = static_cast<char>(wider[edge.b] | near[edge.a]);
            }
            near = std::move(wider);
        }
        for (int pass = 0; pass < kPasses; ++pass) {
            std::vector<Vec3> sums(ways_.size(), Vec3::Zero());
            std::vector<double> weights(ways_.size(), 0.0);
            for (const Edge& edge : edges_) {
                for (const auto& [to, from] :
                     {std::pair{edge.a, edge.b}, std::pair{edge.b, edge.a}}) {
                    if (edge.isOnRim || isOnRim_[to] == 0) {
                        sums[to] += ways_[from] / edge.length;
                        weights[to] += 1.0 / edge.length;
                    }
                }
            }
            for (std::size_t v = 0; v < ways_.size(); ++v) {
                if (near[v] != 0) {
                    const Vec3 mean = ways_[v] + sums[v] / weights[v];
                    ways_[v] = ways_[v].norm() * mean.stableNormalized();
                }
            }
        }
    }

    /// False where nothing can be made thinner.
    bool makeThinner(const std::vector<char>& near) {
        bool isThinner = false;
        for (std::size_t v = 0; v < shares_.size(); ++v) {
            if (near[v] != 0 && shares_[v] > kLeastShare) {
                shares_[v] = std::max(kThinner * shares_[v], kLeastShare);
                isThinner = true;
            }
        }
        for (bool isLowered = isThinner; isLowered;) {
            isLowered = false;
            for (const auto& [a, b, length, isOnRim] : edges_) {
                const double most =
                    std::min(shares_[a], shares_[b]) + kSteepest * length / thickness_;
                isLowered = isLowered || shares_[a] > most || shares_[b] > most;
                shares_[a] = std::min(shares_[a], most);
                shares_[b] = std::min(shares_[b], most);
            }
        }
        return isThinner;
    }

    const std::vector<int>& first_;  // see PartSheet
    TriangleMesh sheet_;
    std::vector<Vec3> ways_;
    std::vector<double> shares_;  // of the thickness
    double thickness_;
    std::vector<int> rim_;
    std::vector<char> isOnRim_ = std::vector<char>(ways_.size(), 0);
    std::vector<Edge> edges_;
    PatchChecker checker_;
    Patch patch_;  // the other side and walls, over the vertices of the rim
};

}  // namespace

ThickParts thickened(
    const ImprintedMesh& imprinted,
    const MeshParts& parts,
    const std::vector<int>& chosen,
    double thickness,
    const Progress& progress
) {
    if (!std::isfinite(thickness) || thickness == 0.0) {
        throw InputError(InputErrorCode::BadOption, "the thickness must be a number other than 0");
    }
    const PartSheet sheet = sheetOf(imprinted, parts, chosen);
    const std::vector<Vec3> unit = unitWays(imprinted);
    std::vector<Vec3> ways;
    for (const int vertex : sheet.parts.source) {
        ways.emplace_back(thickness * unit[vertex]);
    }
    OtherSide other(sheet, std::move(ways), thickness);
    const std::vector<int> crossing = other.settle(progress);

    ThickParts result{.solid = sheet.parts};
    FilledParts& solid = result.solid;
    const auto vertexCount = static_cast<int>(sheet.parts.mesh.vertices.size());
    const auto faceCount = static_cast<int>(sheet.parts.mesh.faces.size());
    const bool isOutwards = thickness > 0.0;
    const std::vector<Vec3> moved = other.points();
    const std::vector<Vec3>& inner = isOutwards ? sheet.parts.mesh.vertices : moved;
    if (isOutwards) {
        solid.mesh.vertices = moved;
    }
    solid.mesh.vertices.insert(solid.mesh.vertices.end(), inner.begin(), inner.end());
    const std::vector<int>& source = sheet.parts.source;
    solid.source.insert(solid.source.end(), source.begin(), source.end());
    for (int f = 0; f < faceCount; ++f) {
        const auto& [a, b, c] = sheet.parts.mesh.faces[f];
        solid.mesh.faces.push_back({vertexCount + a, vertexCount + c, vertexCount + b});
        const int face = sheet.parts.faces[f];
        solid.walls.push_back({face, face, face});
    }
    for (const RimEdge& edge : sheet.rim) {
        addWall(solid, edge, vertexCount + edge.from, vertexCount + edge.to);
    }
    endSolid(solid);
    for (const int face : crossing) {
        solid.crossing.push_back(isOutwards && face < faceCount ? face : faceCount + face);
    }
    for (std::size_t v = 0; v < sheet.first.size(); ++v) {
        result.thinner += other.shareOf(v) < 1.0 ? 1 : 0;
        result.least = std::min(result.least, other.shareOf(v));
    }
    return result;
}

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#include "fill/thick_parts.h"

#include "bspline_curve/error.h"
#include "fill/part_sheet.h"
#include "fill/patch_checker.h"
#include "fill/settled_ways.h"
#include "imprint/imprint.h"
#include "surface/vertex_normals.h"
#include "utility/index_sets.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace bspline_curve {

namespace {

/// Walls are made no thinner than this, relative to what was asked for.
constexpr double kLeastThickness = 0.02;

/// For each vertex of the imprint the way to where all faces around have moved by 1.
std::vector<Vec3> unitWays(const ImprintedMesh& imprinted) {
    // Mean normals count as that long at least: edges of more than 120 degrees are blunted.
    constexpr double kLeastMean = 0.5;
    const TriangleMesh before = withoutImprint(imprinted);
    std::vector<Vec3> ways = meanNormals(before);
    for (Vec3& way : ways) {
        way /= std::max(way.squaredNorm(), kLeastMean * kLeastMean);
    }
    return interpolatedOwn(imprinted, before.faces, std::move(ways));
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

/// The other side of a wall and what joins it to the part, over the vertices of the rim.
class OtherSide {
public:
    /// `mesh`: joinedMesh() of the sheet, which must outlive this.
    OtherSide(const PartSheet& sheet, const TriangleMesh& mesh, double thickness) : checker_(mesh) {
        for (const int vertex : sheet.rimVertices()) {
            rim_.push_back(sheet.first[vertex]);
        }
        sortUnique(rim_);
        checker_.begin(rim_, std::abs(thickness));
        const auto rimCount = static_cast<int>(rim_.size());
        patch_.rimCount = rimCount;
        for (const auto& [a, b, c] : mesh.faces) {
            patch_.faces.push_back({rimCount + a, rimCount + c, rimCount + b});
        }
        for (const RimEdge& edge : sheet.rim) {
            const int from = sheet.first[edge.from];
            const int to = sheet.first[edge.to];
            patch_.faces.push_back({indexIn(rim_, to), indexIn(rim_, from), rimCount + from});
            patch_.faces.push_back({indexIn(rim_, to), rimCount + from, rimCount + to});
        }
        for (const int vertex : rim_) {
            patch_.points.push_back(mesh.vertices[vertex]);
        }
    }

    /// Vertices of the other side, given where they are, whose faces and walls cross something.
    std::vector<int> crossing(const std::vector<Vec3>& moved, bool isStrict) {
        patch_.points.resize(rim_.size());
        patch_.points.insert(patch_.points.end(), moved.begin(), moved.end());
        crossingFaces_ = checker_.badFaces(patch_, isStrict);
        return innerCorners(patch_, crossingFaces_);
    }

    /// The faces that crossed then: those of the other side, then those of walls.
    [[nodiscard]] const std::vector<int>& crossingFaces() const { return crossingFaces_; }

private:
    std::vector<int> rim_;
    PatchChecker checker_;
    Patch patch_;
    std::vector<int> crossingFaces_;
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
    const TriangleMesh joined = joinedMesh(sheet);
    SettledWays settled(joined, std::move(ways), thickness, kLeastThickness);
    OtherSide other(sheet, joined, thickness);
    settled.settle(
        [&](const std::vector<Vec3>& points, bool isStrict) {
            return other.crossing(points, isStrict);
        },
        progress
    );

    ThickParts result{.solid = sheet.parts};
    FilledParts& solid = result.solid;
    const auto vertexCount = static_cast<int>(sheet.parts.mesh.vertices.size());
    const auto faceCount = static_cast<int>(sheet.parts.mesh.faces.size());
    const bool isOutwards = thickness > 0.0;
    std::vector<Vec3> moved = settled.points();
    for (std::size_t v = 0; v < moved.size(); ++v) {
        const double share = settled.shares()[sheet.first[v]];
        moved[v] = moved[sheet.first[v]];
        result.thinner += share < 1.0 ? 1 : 0;
        result.least = std::min(result.least, share);
    }
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
    for (const int face : other.crossingFaces()) {
        solid.crossing.push_back(isOutwards && face < faceCount ? face : faceCount + face);
    }
    return result;
}

}  // namespace bspline_curve

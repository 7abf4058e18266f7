// SPDX-License-Identifier: GPL-3.0-or-later
#include "fill/based_parts.h"

#include "bspline_curve/error.h"
#include "fill/part_sheet.h"
#include "fill/patch_checker.h"
#include "imprint/imprint.h"
#include "surface/surface.h"
#include "text/error_messages.h"
#include "utility/index_sets.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <set>
#include <string>
#include <utility>

namespace bspline_curve {

namespace {

[[noreturn]] void refuseBase(const std::string& message) {
    throw InputError(InputErrorCode::NoPath, "the base: " + message);
}

/// The plane of points p with direction . p = height.
struct BasePlane {
    Vec3 direction;
    double height;

    [[nodiscard]] Vec3 below(const Vec3& point) const {
        return point + (height - direction.dot(point)) * direction;
    }
};

/// Against the mean normal of the parts.
Vec3 inwards(const TriangleMesh& sheet) {
    constexpr double kLeastMean = 1e-6;  // of the area
    Vec3 sum = Vec3::Zero();
    double area = 0.0;
    for (const auto& [a, b, c] : sheet.faces) {
        const Vec3& corner = sheet.vertices[a];
        const Vec3 normal = (sheet.vertices[b] - corner).cross(sheet.vertices[c] - corner);
        sum += normal;
        area += normal.norm();
    }
    if (sum.norm() <= kLeastMean * area) {
        refuseBase("the part has no mean normal; give a direction");
    }
    return -sum;
}

BasePlane planeFor(const TriangleMesh& sheet, const PartBase& base) {
    BasePlane plane{
        .direction = base.direction ? *base.direction : inwards(sheet),
        .height = base.height.value_or(0.0)
    };
    plane.direction = plane.direction.stableNormalized();
    double farthest = -std::numeric_limits<double>::infinity();
    for (const Vec3& vertex : sheet.vertices) {
        farthest = std::max(farthest, plane.direction.dot(vertex));
    }
    if (!base.height) {
        plane.height = farthest + base.length;
    }
    if (farthest >= plane.height) {
        refuseBase(
            "the part reaches " + describeNumber(farthest - plane.height) +
            " beyond the plane; move the plane farther, by at least that"
        );
    }
    return plane;
}

/// The rims as loops, in the direction of their faces.
std::vector<std::vector<int>> loopsOf(const PartSheet& sheet) {
    std::vector<int> next(sheet.parts.mesh.vertices.size(), -1);
    for (const RimEdge& edge : sheet.rim) {
        next[edge.from] = edge.to;
    }
    std::vector<std::vector<int>> loops;
    for (const RimEdge& edge : sheet.rim) {
        std::vector<int> loop;
        for (int vertex = edge.from; next[vertex] >= 0;) {
            loop.push_back(vertex);
            vertex = std::exchange(next[vertex], -1);
        }
        if (!loop.empty()) {
            loops.push_back(std::move(loop));
        }
    }
    return loops;
}

/// The region between loops in a plane as triangles of their points, facing along its normal.
class PlanarRegion {
public:
    explicit PlanarRegion(const Vec3& normal) : x_(normal.unitOrthogonal()), y_(normal.cross(x_)) {}

    [[nodiscard]] std::vector<Triangle> between(
        const std::vector<std::vector<int>>& loops, const std::vector<Vec3>& points
    ) {
        const Surface around(triangleAround(loops, points));
        std::vector<SurfacePolyline> lines;
        for (const std::vector<int>& loop : loops) {
            lines.push_back(lineIn(around, loop, points));
        }
        const ImprintedMesh imprinted = imprintOwn(around, lines, {.snap = 0.0});
        std::vector<int> pointOf(imprinted.mesh.vertices.size(), -1);
        bool isSimple = imprinted.crossings.empty();
        for (std::size_t i = 0; i < loops.size() && isSimple; ++i) {
            const std::vector<int>& vertices = imprinted.curves[i].vertices;
            isSimple = vertices.size() == loops[i].size();
            for (std::size_t k = 0; k < vertices.size() && isSimple; ++k) {
                isSimple = std::exchange(pointOf[vertices[k]], loops[i][k]) < 0;
            }
        }
        if (!isSimple) {
            refuseBase(
                "the rim crosses or touches itself as seen along the direction; give another one"
            );
        }
        return trianglesInside(imprinted, pointOf);
    }

private:
    [[nodiscard]] Vec3 flat(const Vec3& point) const { return {point.dot(x_), point.dot(y_), 0.0}; }

    /// So large that what is outside the loops is the largest part of it.
    [[nodiscard]] TriangleMesh triangleAround(
        const std::vector<std::vector<int>>& loops, const std::vector<Vec3>& points
    ) const {
        Eigen::AlignedBox3d box;
        for (const std::vector<int>& loop : loops) {
            for (const int vertex : loop) {
                box.extend(flat(points[vertex]));
            }
        }
        constexpr double kCornerDiagonals = 2.0;
        TriangleMesh around{.vertices = {}, .faces = {{0, 1, 2}}};
        for (int k = 0; k < 3; ++k) {
            const double angle = 2.0 * std::numbers::pi * k / 3.0;
            around.vertices.emplace_back(
                box.center() +
                kCornerDiagonals * box.diagonal().norm() * Vec3(std::cos(angle), std::sin(angle), 0)
            );
        }
        return around;
    }

    [[nodiscard]] SurfacePolyline lineIn(
        const Surface& around, const std::vector<int>& loop, const std::vector<Vec3>& points
    ) const {
        const std::vector<Vec3>& corners = around.vertices();
        const auto doubleArea = [](const Vec3& a, const Vec3& b, const Vec3& c) {
            return (b - a).cross(c - a).z();
        };
        SurfacePolyline line;
        line.closed = true;
        for (const int vertex : loop) {
            const Vec3 at = flat(points[vertex]);
            Vec3 weights;
            for (int k = 0; k < 3; ++k) {
                weights[k] = doubleArea(at, corners[(k + 1) % 3], corners[(k + 2) % 3]);
            }
            line.surfacePoints.push_back({.face = 0, .barycentric = weights / weights.sum()});
            line.points.push_back(at);
        }
        return line;
    }

    [[nodiscard]] static std::vector<Triangle> trianglesInside(
        const ImprintedMesh& imprinted, const std::vector<int>& pointOf
    ) {
        const MeshParts parts = partsOf(imprinted);
        const std::vector<int> inside =
            chosenParts(imprinted, parts, {.which = PartChoice::Which::Inside});
        std::vector<Triangle> triangles;
        for (std::size_t f = 0; f < parts.labels.size(); ++f) {
            if (std::ranges::binary_search(inside, parts.labels[f])) {
                const auto& [a, b, c] = imprinted.mesh.faces[f];
                triangles.push_back({pointOf[a], pointOf[b], pointOf[c]});
            }
        }
        return triangles;
    }

    Vec3 x_, y_;
};

/// Throws unless each edge of the rim has a triangle on its other side.
void checkFacing(const std::vector<RimEdge>& rim, const std::vector<Triangle>& cap) {
    std::set<std::array<int, 2>> sides;
    for (const Triangle& face : cap) {
        for (std::size_t k = 0; k < 3; ++k) {
            sides.insert({face[k], face[(k + 1) % 3]});
        }
    }
    if (!std::ranges::all_of(rim, [&](const RimEdge& edge) {
            return sides.contains({edge.to, edge.from});
        })) {
        refuseBase("its plane is on the outer side of a part; give the opposite direction");
    }
}

/// New faces that cross others, from 0: those of walls, then those in the plane.
std::vector<int> crossingIn(
    const PartSheet& sheet,
    const std::vector<int>& rim,
    const std::vector<Triangle>& cap,
    const BasePlane& plane
) {
    const auto count = static_cast<int>(rim.size());
    Patch patch;
    patch.rimCount = count;
    double shortest = std::numeric_limits<double>::infinity();
    for (const int vertex : rim) {
        const Vec3& point = sheet.parts.mesh.vertices[vertex];
        patch.points.push_back(point);
        shortest = std::min(shortest, plane.height - plane.direction.dot(point));
    }
    for (int i = 0; i < count; ++i) {
        patch.points.push_back(plane.below(patch.points[i]));
    }
    for (const RimEdge& edge : sheet.rim) {
        const int from = indexIn(rim, edge.from);
        const int to = indexIn(rim, edge.to);
        patch.faces.push_back({to, from, count + from});
        patch.faces.push_back({to, count + from, count + to});
    }
    for (const auto& [a, b, c] : cap) {
        patch.faces.push_back(
            {count + indexIn(rim, a), count + indexIn(rim, b), count + indexIn(rim, c)}
        );
    }
    PatchChecker checker(sheet.parts.mesh);
    checker.begin(rim, shortest);
    return checker.badFaces(patch, false);
}

void checkBase(const PartBase& base) {
    const bool isLength = std::isfinite(base.length) && base.length > 0.0;
    if (base.height ? !std::isfinite(*base.height) : !isLength) {
        throw InputError(
            InputErrorCode::BadOption, "the length of a base must be a number above 0"
        );
    }
    const auto isDirection = [](const Vec3& direction) {
        return direction.allFinite() && direction.norm() > 0.0;
    };
    if (base.direction ? !isDirection(*base.direction) : base.height.has_value()) {
        throw InputError(
            InputErrorCode::BadOption, "the direction of a base must have numbers, not all 0"
        );
    }
}

}  // namespace

FilledParts based(
    const ImprintedMesh& imprinted,
    const MeshParts& parts,
    const std::vector<int>& chosen,
    const PartBase& base
) {
    checkBase(base);
    const PartSheet sheet = sheetOf(imprinted, parts, chosen);
    if (sheet.rim.empty()) {
        return sheet.parts;
    }
    const TriangleMesh& mesh = sheet.parts.mesh;
    const BasePlane plane = planeFor(mesh, base);
    const std::vector<Triangle> cap =
        PlanarRegion(plane.direction).between(loopsOf(sheet), mesh.vertices);
    checkFacing(sheet.rim, cap);

    FilledParts solid = sheet.parts;
    const std::vector<int> rim = sheet.rimVertices();
    const auto first = static_cast<int>(mesh.vertices.size());
    for (const int vertex : rim) {
        solid.mesh.vertices.push_back(plane.below(mesh.vertices[vertex]));
        solid.source.push_back(solid.source[vertex]);
    }
    const auto moved = [&](int vertex) { return first + indexIn(rim, vertex); };
    std::vector<int> faceAt(mesh.vertices.size(), -1);
    for (const RimEdge& edge : sheet.rim) {
        addWall(solid, edge, moved(edge.from), moved(edge.to));
        faceAt[edge.from] = edge.face;
    }
    for (const auto& [a, b, c] : cap) {
        solid.mesh.faces.push_back({moved(a), moved(b), moved(c)});
        solid.walls.push_back({faceAt[a], faceAt[b], faceAt[c]});
    }
    for (const int face : crossingIn(sheet, rim, cap, plane)) {
        solid.crossing.push_back(static_cast<int>(mesh.faces.size()) + face);
    }
    endSolid(solid);
    return solid;
}

}  // namespace bspline_curve

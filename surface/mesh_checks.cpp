// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/mesh_checks.h"

#include "bspline_curve/error.h"
#include "text/error_messages.h"
#include "utility/index_sets.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace bspline_curve {

namespace {

using Elements = std::vector<std::int64_t>;

struct FaceArea {
    double twice;
    bool isEnough;  ///< see checkFacesHaveArea
};

FaceArea measure(const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 ab = b - a;
    const Vec3 ac = c - a;
    const double longestEdge =
        std::sqrt(std::max({ab.squaredNorm(), ac.squaredNorm(), (c - b).squaredNorm()}));
    const double largestCoordinate = std::max(
        {a.lpNorm<Eigen::Infinity>(), b.lpNorm<Eigen::Infinity>(), c.lpNorm<Eigen::Infinity>()}
    );
    const double twice = ab.cross(ac).norm();
    return {.twice = twice, .isEnough = twice > kRelativeArea * longestEdge * largestCoordinate};
}

}  // namespace

bool isUsable(const Vec3& point) {
    // A NaN compares false.
    return std::abs(point[0]) <= kLargestCoordinate && std::abs(point[1]) <= kLargestCoordinate &&
           std::abs(point[2]) <= kLargestCoordinate;
}

bool hasArea(const Vec3& a, const Vec3& b, const Vec3& c) {
    return measure(a, b, c).isEnough;
}

void checkArrays(const TriangleMesh& mesh) {
    // Half-edges are numbered with an int.
    constexpr auto kLargestFaceCount =
        static_cast<std::size_t>(std::numeric_limits<int>::max() / 3);
    if (mesh.faces.empty()) {
        throw InputError(
            InputErrorCode::EmptyMesh,
            "the mesh has no faces: choose a triangle mesh, not a point cloud or an empty layer"
        );
    }
    if (mesh.faces.size() > kLargestFaceCount || mesh.vertices.size() > kLargestFaceCount) {
        throw InputError(
            InputErrorCode::IndexOutOfRange,
            "the mesh has more than " + std::to_string(kLargestFaceCount) +
                " faces or vertices: simplify it first"
        );
    }

    const auto vertexCount = static_cast<int>(mesh.vertices.size());
    const auto isThere = [&](int vertex) { return vertex >= 0 && vertex < vertexCount; };
    Elements bad;
    if (!std::ranges::all_of(mesh.vertices, isUsable)) {
        for (const Triangle& face : mesh.faces) {
            std::ranges::copy_if(face, std::back_inserter(bad), [&](int v) {
                return isThere(v) && !isUsable(mesh.vertices[v]);
            });
        }
        sortUnique(bad);
    }
    if (!bad.empty()) {
        refuseElements(
            InputErrorCode::NonFiniteCoordinate,
            describeCount(bad.size(), "vertex has", "vertices have") +
                " a coordinate that is not a finite number below 1e60",
            "vertices",
            bad,
            "leave out the faces at them"
        );
    }
    bad = indicesWhere<std::int64_t>(mesh.faces.size(), [&](std::size_t f) {
        return !std::ranges::all_of(mesh.faces[f], isThere);
    });
    if (!bad.empty()) {
        refuseElements(
            InputErrorCode::IndexOutOfRange,
            describeCount(bad.size(), "face names", "faces name") + " a vertex outside of 0 to " +
                std::to_string(vertexCount - 1),
            "faces",
            bad,
            "write the mesh again with the program that made it"
        );
    }
}

double checkFacesHaveArea(const TriangleMesh& mesh) {
    const auto corner = [&](std::size_t face, std::size_t k) -> const Vec3& {
        return mesh.vertices[mesh.faces[face][k]];
    };
    // Equal corners have no area either, so one test finds repeated vertices as well.
    double twice = 0.0;
    const Elements bad = indicesWhere<std::int64_t>(mesh.faces.size(), [&](std::size_t f) {
        const FaceArea area = measure(corner(f, 0), corner(f, 1), corner(f, 2));
        twice += area.twice;
        return !area.isEnough;
    });
    if (!bad.empty()) {
        refuseElements(
            InputErrorCode::DegenerateFace,
            describeCount(bad.size(), "face has", "faces have") + " a repeated vertex or no area",
            "faces",
            bad,
            "remove them"
        );
    }
    return 0.5 * twice;
}

}  // namespace bspline_curve

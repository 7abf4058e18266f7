// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh_checksum.h"
#include "filters/pick_candidates.h"
#include "host_document.h"

#include <Eigen/Geometry>

#include <optional>
#include <vector>

namespace bspline_curve {

/// A layer as plain arrays, without its deleted elements. The layer itself is not changed.
struct LayerArrays {
    LayerInput input;
    std::vector<int> vertexIds;  ///< index in the layer of each vertex
    std::vector<int> faceIds;    ///< index in the layer of each face
    std::vector<Vec3> own;       ///< vertices in the layer's coordinates; empty: those of the world
    /// See checksumOf(); none: it was not needed yet.
    std::optional<MeshChecksum> checksum{};
};

/// World coordinates of points of a layer; exactly their own ones where its matrix is the identity.
class ToWorld {
public:
    explicit ToWorld(const MeshModel& layer);

    [[nodiscard]] Vec3 operator()(const Vec3& point) const {
        return isIdentity_ ? point : Vec3((matrix_ * point.homogeneous()).hnormalized());
    }

    [[nodiscard]] bool isInvertible() const;

    [[nodiscard]] bool isIdentity() const { return isIdentity_; }

private:
    Eigen::Matrix4d matrix_;
    bool isIdentity_;
};

/// Throws InputError where the layer has no faces or its matrix is singular. In double precision
/// from the layer's coordinates on, whatever the host's scalar is.
[[nodiscard]] LayerArrays arraysOf(const MeshModel& layer);

/// Vertices of a layer in order, without deleted ones, in world coordinates.
[[nodiscard]] std::vector<Vec3> pointsOf(const MeshModel& layer);

/// Of a layer in its own coordinates, so that its matrix does not matter.
[[nodiscard]] MeshChecksum checksumOf(const MeshModel& layer);

/// The same, of its arrays.
[[nodiscard]] MeshChecksum checksumOf(const LayerArrays& arrays);

[[nodiscard]] inline Vec3 toVec3(const Point3m& p) {
    return {double(p[0]), double(p[1]), double(p[2])};
}

[[nodiscard]] inline Point3m toPoint3m(const Vec3& v) {
    return {static_cast<Scalarm>(v[0]), static_cast<Scalarm>(v[1]), static_cast<Scalarm>(v[2])};
}

}  // namespace bspline_curve

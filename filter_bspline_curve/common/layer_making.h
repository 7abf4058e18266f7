// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filter_bspline_curve/common/layer_arrays.h"
#include "host_document.h"

#include <QString>
#include <cstddef>

// What all new layers need.
namespace bspline_curve {

/// Of curves, and of tubes around them.
inline const vcg::Color4b kCurveColour(225, 60, 30, 255);

/// The layer's label without the extension of its file.
[[nodiscard]] QString nameOf(const MeshModel& layer);

/// Edges from each vertex of [first, end) to the next, and where it is closed from the last to the
/// first.
void addEdges(CMeshO& mesh, std::size_t first, std::size_t end, bool closed);

/// Edges from each vertex to the next, and where it is closed from the last to the first.
void addEdges(CMeshO& mesh, bool closed);

/// Remembers the surface, and moves with it.
void attachTo(const MeshModel& surface, MeshModel& layer);

/// World coordinates as those of a layer; exactly the same where its matrix is the identity.
class FromWorld {
public:
    explicit FromWorld(const Matrix44m& matrix);

    [[nodiscard]] Point3m operator()(const Vec3& world) const;

    /// The same, not rounded to the host's scalar.
    [[nodiscard]] Vec3 inDoubles(const Vec3& world) const;

private:
    bool isIdentity_;
    Eigen::Matrix4d inverse_;
};

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_bspline_curve/common/layer_making.h"

#include "filter_bspline_curve/common/surface_choice.h"

#include <Eigen/LU>

#include <cstddef>

namespace bspline_curve {

namespace {

using Allocator = vcg::tri::Allocator<CMeshO>;

}  // namespace

QString nameOf(const MeshModel& layer) {
    const QString extension = "." + layer.suffixName();
    const QString label = layer.label();
    return extension.size() > 1 && label.endsWith(extension)
               ? label.left(label.size() - extension.size())
               : label;
}

void addEdges(CMeshO& mesh, std::size_t first, std::size_t end, bool closed) {
    for (std::size_t i = first; i + 1 < end; ++i) {
        Allocator::AddEdge(mesh, i, i + 1);
    }
    if (closed) {
        Allocator::AddEdge(mesh, end - 1, first);
    }
}

void addEdges(CMeshO& mesh, bool closed) {
    addEdges(mesh, 0, mesh.vert.size(), closed);
}

void attachTo(const MeshModel& surface, MeshModel& layer) {
    Allocator::GetPerMeshAttribute<int>(layer.cm, kSurfaceLayerAttribute)() = surface.id();
    layer.cm.Tr = surface.cm.Tr;
    vcg::tri::UpdateBounding<CMeshO>::Box(layer.cm);
}

FromWorld::FromWorld(const Matrix44m& matrix) : isIdentity_(matrix == Matrix44m::Identity()) {
    Eigen::Matrix4d toWorld;
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column) {
            toWorld(row, column) = static_cast<double>(matrix.ElementAt(row, column));
        }
    }
    inverse_ = toWorld.inverse();
}

Point3m FromWorld::operator()(const Vec3& world) const {
    return toPoint3m(inDoubles(world));
}

Vec3 FromWorld::inDoubles(const Vec3& world) const {
    return isIdentity_ ? world : Vec3((inverse_ * world.homogeneous()).hnormalized());
}

}  // namespace bspline_curve

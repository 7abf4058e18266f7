// SPDX-License-Identifier: GPL-3.0-or-later
// From an imprint back to its input, and values from the input to it.
#include "imprint/imprint.h"
#include "surface/surface_point.h"

#include <map>
#include <set>
#include <utility>

namespace bspline_curve {

namespace {

/// The face whose children are given, the one at its first corner first.
Triangle parentOf(std::span<const Triangle> children, int surfaceVertexCount) {
    if (children.size() == 1) {
        return children[0];
    }
    // Sides that no two children share lead round the parent, from its first corner.
    std::set<std::pair<int, int>> sides;
    for (const auto& [a, b, c] : children) {
        sides.insert({{a, b}, {b, c}, {c, a}});
    }
    std::map<int, int> next;
    for (const auto& [from, to] : sides) {
        if (!sides.contains({to, from})) {
            next[from] = to;
        }
    }
    Triangle parent{children[0][0], -1, -1};
    std::size_t corner = 1;
    for (int vertex = next.at(parent[0]); vertex != parent[0]; vertex = next.at(vertex)) {
        if (vertex < surfaceVertexCount) {
            parent.at(corner++) = vertex;
        }
    }
    return parent;
}

}  // namespace

TriangleMesh withoutImprint(const ImprintedMesh& imprinted) {
    TriangleMesh mesh;
    const int old = imprinted.surfaceVertexCount;
    const std::vector<int>& parents = imprinted.ownParents;
    mesh.vertices.assign(imprinted.mesh.vertices.begin(), imprinted.mesh.vertices.begin() + old);
    const std::span<const Triangle> faces = imprinted.mesh.faces;
    for (std::size_t first = 0; first < faces.size();) {
        std::size_t last = first + 1;
        while (last < faces.size() && parents[last] == parents[first]) {
            ++last;
        }
        mesh.faces.push_back(parentOf(faces.subspan(first, last - first), old));
        first = last;
    }
    return mesh;
}

std::vector<double> interpolated(
    const ImprintedMesh& imprinted,
    const std::vector<Triangle>& inputFaces,
    std::span<const double> values
) {
    std::vector<double> result(values.begin(), values.end());
    for (const SurfacePoint& point : imprinted.newVertices) {
        result.push_back(valueAt(inputFaces, values, point));
    }
    return result;
}

std::vector<Vec3> interpolatedOwn(
    const ImprintedMesh& imprinted, const std::vector<Triangle>& ownFaces, std::vector<Vec3> vectors
) {
    for (const auto& [face, barycentric] : imprinted.ownPlaces) {
        Vec3 vector = Vec3::Zero();
        for (int k = 0; k < 3; ++k) {
            vector += barycentric[k] * vectors[ownFaces[face][k]];
        }
        vectors.push_back(vector);
    }
    return vectors;
}

SurfacePolyline polylineOf(const Surface& imprinted, const ImprintedCurve& curve) {
    SurfacePolyline line;
    line.closed = curve.closed;
    for (const int vertex : curve.vertices) {
        const int face = *imprinted.facesAround(vertex).begin();
        SurfacePoint point{.face = face};
        point.barycentric[cornerOf(imprinted.faces()[face], vertex)] = 1.0;
        line.surfacePoints.push_back(point);
        line.points.push_back(imprinted.vertices()[vertex]);
        line.parameters.push_back(
            static_cast<double>(line.parameters.size()) / static_cast<double>(curve.vertices.size())
        );
    }
    return line;
}

}  // namespace bspline_curve

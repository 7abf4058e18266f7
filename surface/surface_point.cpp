// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/surface_point.h"

#include <algorithm>

namespace bspline_curve {

std::vector<int> facesHolding(const Surface& surface, const SurfacePoint& point) {
    std::vector<int> faces{point.face};
    int zeros = 0;
    int zeroCorner = 0;
    int liveCorner = 0;
    for (int k = 0; k < 3; ++k) {
        const bool isZero = point.barycentric[k] <= kOnEdgeBarycentric;
        zeros += static_cast<int>(isZero);
        (isZero ? zeroCorner : liveCorner) = k;
    }
    if (zeros == 2) {
        const Surface::FaceRange star =
            surface.facesAround(surface.faces()[point.face][liveCorner]);
        faces.assign(star.begin(), star.end());
    } else if (zeros == 1 && surface.faceNeighbours()[point.face][zeroCorner] >= 0) {
        faces.push_back(surface.faceNeighbours()[point.face][zeroCorner]);
    }
    std::ranges::sort(faces);
    return faces;
}

SurfacePoint inFace(const Surface& surface, const SurfacePoint& point, int face) {
    if (point.face == face) {
        return point;
    }
    SurfacePoint result{face, Vec3::Zero()};
    for (std::size_t k = 0; k < 3; ++k) {
        const int corner = cornerOf(surface.faces()[face], surface.faces()[point.face][k]);
        if (corner >= 0) {
            result.barycentric[corner] = point.barycentric[static_cast<Eigen::Index>(k)];
        }
    }
    result.barycentric /= result.barycentric.sum();
    return result;
}

int commonFace(const Surface& surface, const SurfacePoint& a, const SurfacePoint& b) {
    const std::vector<int> facesA = facesHolding(surface, a);
    const std::vector<int> facesB = facesHolding(surface, b);
    const auto found = std::ranges::find_first_of(facesA, facesB);
    return found == facesA.end() ? -1 : *found;
}

SurfacePoint snapped(const SurfacePoint& point, double tolerance) {
    SurfacePoint result = point;
    for (int k = 0; k < 3; ++k) {
        if (result.barycentric[k] <= tolerance) {
            result.barycentric[k] = 0.0;
        }
    }
    result.barycentric /= result.barycentric.sum();
    return result;
}

}  // namespace bspline_curve

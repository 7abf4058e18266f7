// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/surface_point.h"

#include <algorithm>

namespace bspline_curve {

namespace {

// The vertex, the edge or the face inside of which a point lies.
struct Support {
    bool isInside, isVertex;
    int zeroCorner = 0;  // one whose coordinate is zero
    int liveCorner = 0;  // one whose coordinate is not

    explicit Support(const SurfacePoint& point) {
        int zeros = 0;
        for (int k = 0; k < 3; ++k) {
            const bool isZero = point.barycentric[k] <= kOnEdgeBarycentric;
            zeros += static_cast<int>(isZero);
            (isZero ? zeroCorner : liveCorner) = k;
        }
        isInside = zeros == 0;
        isVertex = zeros == 2;
    }
};

// Whether a face has all vertices that a point depends on.
bool holds(const Surface& surface, int face, const SurfacePoint& point) {
    for (int k = 0; k < 3; ++k) {
        if (point.barycentric[k] > kOnEdgeBarycentric &&
            cornerOf(surface.faces()[face], surface.faces()[point.face][k]) < 0) {
            return false;
        }
    }
    return true;
}

}  // namespace

std::vector<int> facesHolding(const Surface& surface, const SurfacePoint& point) {
    std::vector<int> faces{point.face};
    const Support support(point);
    if (support.isVertex) {
        const Surface::FaceRange star =
            surface.facesAround(surface.faces()[point.face][support.liveCorner]);
        faces.assign(star.begin(), star.end());
    } else if (!support.isInside) {
        const int next = surface.faceNeighbours()[point.face][support.zeroCorner];
        if (next >= 0) {
            faces.push_back(next);
        }
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

// The faces that hold the point which fewer hold, asked for the other one: next to a vertex with
// many faces most points are in one or two.
int commonFace(const Surface& surface, const SurfacePoint& a, const SurfacePoint& b) {
    const Support ofA(a);
    const Support ofB(b);
    if (holds(surface, a.face, b)) {
        return a.face;
    }
    if (holds(surface, b.face, a)) {
        return b.face;
    }
    if (ofA.isInside || ofB.isInside) {
        return -1;
    }
    const auto across =
        [&](const SurfacePoint& point, const Support& support, const SurfacePoint& other) {
            const int next = surface.faceNeighbours()[point.face][support.zeroCorner];
            return next >= 0 && holds(surface, next, other) ? next : -1;
        };
    if (!ofA.isVertex) {
        return across(a, ofA, b);
    }
    if (!ofB.isVertex) {
        return across(b, ofB, a);
    }
    const int vertexA = surface.faces()[a.face][ofA.liveCorner];
    const int vertexB = surface.faces()[b.face][ofB.liveCorner];
    const bool isAFewer =
        surface.facesAround(vertexA).size() <= surface.facesAround(vertexB).size();
    for (const int face : surface.facesAround(isAFewer ? vertexA : vertexB)) {
        if (holds(surface, face, isAFewer ? b : a)) {
            return face;
        }
    }
    return -1;
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

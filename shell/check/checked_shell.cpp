// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/check/checked_shell.h"

#include "surface/predicates.h"

#include <algorithm>

namespace bspline_curve {
CheckedShell::CheckedShell(const Shell& shell) : shell_(shell) {
    points_.reserve(kLevels * shell.pillars().size());
    for (const Pillar& pillar : shell.pillars()) {
        points_.insert(points_.end(), {pillar.bottom, pillar.middle, pillar.top});
    }
    for (int tet = 0; tet < shell.tetrahedronCount(); ++tet) {
        if (isPresent(tet / kTetrahedraPerPrism)) {
            for (int k = 0; k < 4; ++k) {
                faces_.push_back(faceOpposite(tet, k));
            }
        }
    }
    std::sort(faces_.begin(), faces_.end());
}

int CheckedShell::slotParity(int i) const {
    const Prism& p = prism(i);
    if (!shell_.isFullResolution()) {
        return p.orientation;
    }
    const int first = p.faceCorner[0];
    const int second = p.faceCorner[1];
    const int third = p.faceCorner[2];
    if (std::min({first, second, third}) < 0 || first + second + third != 3 || first == second ||
        second == third || first == third) {
        return 0;
    }
    return second == (first + 1) % 3 ? 1 : -1;
}

std::array<int, 4> CheckedShell::tetPoints(int tet) const {
    const Prism& p = prism(tet / kTetrahedraPerPrism);
    const int inPrism = tet % kTetrahedraPerPrism;
    const Level outer = inPrism < 3 ? Top : Bottom;
    std::array<int, 4> points{};
    for (std::size_t k = 0; k < 4; ++k) {
        const SplitVertex vertex = kSlabSplit[inPrism % 3][k];
        points[k] = kLevels * p.pillars[vertex.slot] + (vertex.outer ? outer : Level::Middle);
    }
    return points;
}

std::array<Vec3, 4> CheckedShell::tetCorners(int tet) const {
    const std::array<int, 4> points = tetPoints(tet);
    return {point(points[0]), point(points[1]), point(points[2]), point(points[3])};
}

std::array<int, 2> CheckedShell::halfPillar(int tet) const {
    // Only one pillar has two of the four points.
    const std::array<int, 4> points = tetPoints(tet);
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = i + 1; j < 4; ++j) {
            if (points[i] / kLevels == points[j] / kLevels) {
                return {std::min(points[i], points[j]), std::max(points[i], points[j])};
            }
        }
    }
    return {points[0], points[0]};
}

int CheckedShell::volumeSign(const std::array<int, 4>& points) const {
    return orientationSign(point(points[0]), point(points[1]), point(points[2]), point(points[3]));
}

int CheckedShell::handedness(int tet) const {
    // The order of a tetrahedron's points is right-handed where the slots run counter-clockwise
    // and it lies above the middle; each of the two turns it over.
    const int side = tet % kTetrahedraPerPrism < 3 ? 1 : -1;
    return side * slotParity(tet / kTetrahedraPerPrism);
}

TetFace CheckedShell::faceOpposite(int tet, int k) const {
    const std::array<int, 4> points = tetPoints(tet);
    TetFace face{{}, tet, k};
    std::size_t count = 0;
    for (int j = 0; j < 4; ++j) {
        if (j != k) {
            face.points[count++] = points[j];
        }
    }
    std::sort(face.points.begin(), face.points.end());
    return face;
}

std::vector<TetFace> CheckedShell::boundary() const {
    std::vector<TetFace> boundary;
    forEachFace([&](std::size_t first, std::size_t count) {
        if (count == 1) {
            boundary.push_back(faces_[first]);
        }
    });
    return boundary;
}

}  // namespace bspline_curve

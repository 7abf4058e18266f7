// SPDX-License-Identifier: GPL-3.0-or-later
// Simplified shells: where the surface meets which tetrahedron, by trying all pairs whose boxes
// overlap.
#include "shell/check/checked_surface.h"
#include "shell/check/exact_overlap.h"
#include "surface/self_intersection.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace bspline_curve {
namespace {

// How a face meets a prism.
struct Meeting {
    bool meets = false;
    bool isTransversal = true;
    /// An edge beyond which there is no surface runs through the prism.
    bool hasBorder = false;
};

// The tetrahedra of a prism, which faces near by are tried with.
class PrismTetrahedra {
public:
    PrismTetrahedra(const CheckedShell& shell, int prism) {
        for (int i = 0; i < kTetrahedraPerPrism; ++i) {
            const int tet = kTetrahedraPerPrism * prism + i;
            const std::array<int, 4> points = shell.tetPoints(tet);
            const std::array<int, 2> half = shell.halfPillar(tet);
            for (std::size_t k = 0; k < 4; ++k) {
                tets_[i].corners[k] = shell.point(points[k]);
            }
            tets_[i].halfPillar = {shell.point(half[0]), shell.point(half[1])};
            tets_[i].box = boxOf(tets_[i].corners);
            box.extend(tets_[i].box);
        }
    }

    [[nodiscard]] Meeting meet(
        const CheckedShell& shell, const CheckedSurface& surface, int face
    ) const {
        Meeting result;
        const std::array<Vec3, 3> corners = cornersOf(shell.extended, face);
        const Eigen::AlignedBox3d faceBox = boxOf(corners);
        for (const Tetrahedron& tet : tets_) {
            if (!tet.box.intersects(faceBox) || !overlaps(tet.corners, corners)) {
                continue;
            }
            const auto& [from, to] = tet.halfPillar;
            result.meets = true;
            result.isTransversal = result.isTransversal && normalDotSign(corners, from, to) > 0;
            for (std::size_t k = 0; k < 3 && !result.hasBorder; ++k) {
                const Vec3& start = corners[(k + 1) % 3];
                const Vec3& end = corners[(k + 2) % 3];
                result.hasBorder =
                    surface.isBorder(face, k) && overlaps(tet.corners, {start, end, end});
            }
        }
        return result;
    }

    Eigen::AlignedBox3d box;

private:
    struct Tetrahedron {
        std::array<Vec3, 4> corners;
        std::array<Vec3, 2> halfPillar;
        Eigen::AlignedBox3d box;
    };

    std::array<Tetrahedron, kTetrahedraPerPrism> tets_;
};

// What all meetings taken together say.
struct Meetings {
    std::vector<char> isInSomePrism, isOblique, isUntracked;  // by face
    std::vector<char> hasBorder;                              // by prism
};

void setIf(bool holds, char& flag) {
    if (holds) {
        flag = 1;
    }
}

Meetings meetAll(const CheckedShell& shell, const CheckedSurface& surface) {
    const std::vector<char> none(surface.faceCount(), 0);
    Meetings all{none, none, none, std::vector<char>(shell.prismCount(), 0)};
    for (int prism = 0; prism < shell.prismCount(); ++prism) {
        const PrismTetrahedra tetrahedra(shell, prism);
        surface.forEachNear(tetrahedra.box, [&](int face) {
            const Meeting found = tetrahedra.meet(shell, surface, face);
            if (found.meets) {
                all.isInSomePrism[face] = 1;
                const bool isTracked = std::ranges::binary_search(shell.shell.facesOf(prism), face);
                setIf(!found.isTransversal, all.isOblique[face]);
                setIf(!isTracked, all.isUntracked[face]);
                setIf(found.hasBorder, all.hasBorder[prism]);
            }
        });
    }
    return all;
}

void checkTransversality(
    const CheckedShell& shell, const std::vector<char>& isOblique, Violations violations
) {
    const int faceCount = static_cast<int>(shell.extended.faces.size());
    for (int f = 0; f < std::max(shell.surface.faceCount(), faceCount); ++f) {
        if (f >= faceCount || !isOfSurface(shell, f) || isOblique[f] != 0) {
            violations.add({f});
        }
    }
}

void checkTracks(
    const CheckedShell& shell,
    const CheckedSurface& surface,
    const std::vector<char>& isUntracked,
    Violations violations
) {
    int previous = -1;
    for (const int f : shell.blockedFaces) {
        if (f <= previous || surface.isGhost(f) || !shell.shell.prismsOf(f).empty()) {
            violations.add({f});
        }
        previous = std::max(previous, f);
    }
    for (int f = 0; f < surface.faceCount(); ++f) {
        const bool isLost = surface.holds(f) && shell.shell.prismsOf(f).empty();
        if (isLost || isUntracked[f] != 0) {
            violations.add({f});
        }
    }
    for (int prism = 0; prism < shell.prismCount(); ++prism) {
        const std::span<const int> tracked = shell.shell.facesOf(prism);
        for (std::size_t i = 1; i < tracked.size(); ++i) {
            if (tracked[i] <= tracked[i - 1]) {
                violations.add({tracked[i]});
            }
        }
    }
}

// No face of the surface meets top, bottom or the walls where the shell ends; tracked ghosts meet
// neither top nor bottom. A face may share corners with a wall: vertices that are the middles of
// its pillars.
void checkContainment(
    const CheckedShell& shell, const CheckedSurface& surface, Violations violations
) {
    // Vertices of the extended surface that are middles of pillars get the number of these.
    const auto key = [](const Vec3& p) { return std::tuple(p[0], p[1], p[2]); };
    std::vector<Vec3> points = shell.points.points;
    std::map<std::tuple<double, double, double>, int> middles;
    for (int i = 0; i < static_cast<int>(shell.shell.pillars().size()); ++i) {
        const int middle = PillarPoints::indexOf(i, Level::Middle);
        middles.emplace(key(points[middle]), middle);
    }
    std::vector<int> numbers;
    for (const Vec3& vertex : shell.extended.vertices) {
        const auto middle = middles.find(key(vertex));
        const int ownNumber = static_cast<int>(points.size());
        numbers.push_back(middle == middles.end() ? ownNumber : middle->second);
        points.push_back(vertex);
    }

    std::vector<char> isCut(surface.faceCount(), 0);
    for (const TetFace& boundary : shell.boundary()) {
        const auto& [a, b, c] = boundary.points;
        const std::array<Vec3, 3> corners = {points[a], points[b], points[c]};
        surface.forEachNear(boxOf(corners), [&](int f) {
            const Triangle& face = shell.extended.faces[f];
            const Triangle numbered = {numbers[face[0]], numbers[face[1]], numbers[face[2]]};
            if ((boundary.isLayer() || !surface.isGhost(f)) && isCut[f] == 0 &&
                trianglesIntersect(points, boundary.points, numbered)) {
                isCut[f] = 1;
            }
        });
    }
    violations.addAll(isCut);
}

}  // namespace

void checkSimplifiedShell(const CheckedShell& shell, ShellCheck& result) {
    const CheckedSurface surface(shell);
    const Meetings meetings = meetAll(shell, surface);
    checkTransversality(shell, meetings.isOblique, {result.transversalSurface, shell.options});
    checkTracks(shell, surface, meetings.isUntracked, {result.completeTracking, shell.options});
    Violations notContained(result.containedSurface, shell.options);
    checkContainment(shell, surface, notContained);
    // What meets a tetrahedron and does not cross the boundary lies inside.
    for (int f = 0; f < shell.extended.surfaceFaceCount; ++f) {
        if (surface.holds(f) && meetings.isInSomePrism[f] == 0) {
            notContained.add({f});
        }
    }
    checkFibres(shell, surface, meetings.hasBorder, {result.singleCrossings, shell.options});
}

}  // namespace bspline_curve

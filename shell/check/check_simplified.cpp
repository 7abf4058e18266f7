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

// The surface in a prism: meets every tetrahedron with every face near by.
class PrismMeeting {
public:
    PrismMeeting(const CheckedShell& shell, const CheckedSurface& surface, int prism)
        : surface_(surface) {
        for (int i = 0; i < kTetrahedraPerPrism; ++i) {
            const int tet = kTetrahedraPerPrism * prism + i;
            tets_[i] = shell.tetCorners(tet);
            boxes_[i] = boxOf(tets_[i]);
            box_.extend(boxes_[i]);
            const std::array<int, 2> pillar = shell.halfPillar(tet);
            from_[i] = shell.point(pillar[0]);
            to_[i] = shell.point(pillar[1]);
        }
    }

    struct FaceMeeting {
        bool meets = false;
        bool isTransversal = true;
        bool hasBorder =
            false;  ///< an edge beyond which there is no surface runs through the prism
    };

    [[nodiscard]] FaceMeeting meet(int face) const {
        FaceMeeting result;
        const std::array<Vec3, 3> corners = surface_.corners(face);
        const BoxTree::Box box = boxOf(corners);
        for (std::size_t i = 0; i < tets_.size(); ++i) {
            if (!boxes_[i].intersects(box) || !overlaps(tets_[i], corners)) {
                continue;
            }
            result.meets = true;
            result.isTransversal =
                result.isTransversal && normalDotSign(corners, from_[i], to_[i]) > 0;
            for (std::size_t k = 0; k < 3 && !result.hasBorder; ++k) {
                const Vec3& start = corners[(k + 1) % 3];
                const Vec3& end = corners[(k + 2) % 3];
                result.hasBorder =
                    surface_.isBorder(face, k) && overlaps(tets_[i], {start, end, end});
            }
        }
        return result;
    }

    [[nodiscard]] const BoxTree::Box& box() const { return box_; }

private:
    const CheckedSurface& surface_;
    std::array<std::array<Vec3, 4>, kTetrahedraPerPrism> tets_;
    std::array<BoxTree::Box, kTetrahedraPerPrism> boxes_;
    std::array<Vec3, kTetrahedraPerPrism> from_, to_;
    BoxTree::Box box_;
};

// What all meetings taken together say.
struct Meetings {
    std::vector<char> isInSomePrism, isTransversal, isTracked;  // by face
    std::vector<char> hasBorder;                                // by prism
};

Meetings meetAll(const CheckedShell& shell, const CheckedSurface& surface) {
    const std::size_t faceCount = surface.faceCount();
    Meetings all{
        std::vector<char>(faceCount, 0),
        std::vector<char>(faceCount, 1),
        std::vector<char>(faceCount, 1),
        std::vector<char>(shell.prismCount(), 0)
    };
    for (int prism = 0; prism < shell.prismCount(); ++prism) {
        const PrismMeeting meeting(shell, surface, prism);
        const std::span<const int> tracked = shell.shell().facesOf(prism);
        surface.forEachNear(meeting.box(), [&](int face) {
            const PrismMeeting::FaceMeeting found = meeting.meet(face);
            if (!found.meets) {
                return;
            }
            all.isInSomePrism[face] = 1;
            if (!found.isTransversal) {
                all.isTransversal[face] = 0;
            }
            if (!std::binary_search(tracked.begin(), tracked.end(), face)) {
                all.isTracked[face] = 0;
            }
            if (found.hasBorder) {
                all.hasBorder[prism] = 1;
            }
        });
    }
    return all;
}

// Whether a face of the extended surface is that of the surface.
bool isOfSurface(const Surface& surface, const ExtendedSurface& extended, int f) {
    const Triangle& face = extended.faces[f];
    return (f >= surface.faceCount() || face == surface.faces()[f]) &&
           std::all_of(face.begin(), face.end(), [&](int v) {
               return isWhereItSays(surface, extended, v);
           });
}

void checkTransversality(
    const CheckedSurface& checked,
    const Surface& surface,
    const std::vector<char>& isTransversal,
    Violations violations
) {
    for (int f = 0; f < std::max(surface.faceCount(), checked.faceCount()); ++f) {
        if (f >= checked.faceCount() || !isOfSurface(surface, checked.extended(), f) ||
            isTransversal[f] == 0) {
            violations.add({f});
        }
    }
}

void checkTracks(
    const CheckedShell& shell,
    const CheckedSurface& surface,
    std::span<const int> blockedFaces,
    const std::vector<char>& isTracked,
    Violations violations
) {
    int previous = -1;
    for (const int f : blockedFaces) {
        if (f <= previous || f >= surface.extended().surfaceFaceCount ||
            !shell.shell().prismsOf(f).empty()) {
            violations.add({f});
        }
        previous = std::max(previous, f);
    }
    for (int f = 0; f < surface.faceCount(); ++f) {
        const bool isLost = surface.holds(f) && shell.shell().prismsOf(f).empty();
        if (isLost || isTracked[f] == 0) {
            violations.add({f});
        }
    }
    for (int prism = 0; prism < shell.prismCount(); ++prism) {
        const std::span<const int> tracked = shell.shell().facesOf(prism);
        for (std::size_t i = 1; i < tracked.size(); ++i) {
            if (tracked[i] <= tracked[i - 1]) {
                violations.add({tracked[i]});
            }
        }
    }
}

}  // namespace

void checkContainment(
    const CheckedShell& shell, const CheckedSurface& surface, Violations violations
) {
    // Vertices of the extended surface that are middles of pillars get the number of these.
    const auto key = [](const Vec3& p) { return std::tuple(p[0], p[1], p[2]); };
    std::vector<Vec3> points = shell.points();
    std::map<std::tuple<double, double, double>, int> middles;
    for (int i = CheckedShell::Middle; i < static_cast<int>(points.size());
         i += CheckedShell::kLevels) {
        middles.emplace(key(points[i]), i);
    }
    std::vector<int> numbers;
    for (const Vec3& vertex : surface.extended().vertices) {
        const auto middle = middles.find(key(vertex));
        numbers.push_back(
            middle == middles.end() ? static_cast<int>(points.size()) : middle->second
        );
        points.push_back(vertex);
    }

    std::vector<char> isCut(surface.faceCount(), 0);
    for (const TetFace& boundary : shell.boundary()) {
        const bool isLayer = CheckedShell::isLayer(boundary);
        const std::array<Vec3, 3> corners = {
            shell.point(boundary.points[0]),
            shell.point(boundary.points[1]),
            shell.point(boundary.points[2])
        };
        surface.forEachNear(boxOf(corners), [&](int f) {
            const Triangle& face = surface.extended().faces[f];
            const Triangle numbered = {numbers[face[0]], numbers[face[1]], numbers[face[2]]};
            if ((isLayer || !surface.isGhost(f)) && isCut[f] == 0 &&
                trianglesIntersect(points, boundary.points, numbered)) {
                isCut[f] = 1;
            }
        });
    }
    for (int f = 0; f < surface.faceCount(); ++f) {
        if (isCut[f] != 0) {
            violations.add({f});
        }
    }
}

void checkSimplifiedShell(
    const CheckedShell& shell,
    const Surface& surface,
    const ExtendedSurface& extended,
    std::span<const int> blockedFaces,
    const ShellCheckOptions& options,
    ShellCheck& result
) {
    const CheckedSurface checked(shell.shell(), extended, blockedFaces);
    const Meetings meetings = meetAll(shell, checked);
    checkTransversality(
        checked, surface, meetings.isTransversal, {result.transversalSurface, options}
    );
    checkTracks(
        shell, checked, blockedFaces, meetings.isTracked, {result.completeTracking, options}
    );
    Violations notContained(result.containedSurface, options);
    checkContainment(shell, checked, notContained);
    // What meets a tetrahedron and does not cross the boundary lies inside.
    for (int f = 0; f < extended.surfaceFaceCount; ++f) {
        if (checked.holds(f) && meetings.isInSomePrism[f] == 0) {
            notContained.add({f});
        }
    }
    checkFibres(shell, checked, meetings.hasBorder, options, {result.singleCrossings, options});
}

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/shell_cells.h"

#include <algorithm>
#include <utility>

namespace bspline_curve {

namespace {

// Points of a pillar follow each other from the bottom to the top.
enum Level : signed char { Bottom, Middle, Top };

/// Numbers the points of pillars in order of first use.
class PointList {
public:
    PointList(const Shell& shell, const ShellFrame& frame)
        : shell_(shell), frame_(frame), firstPoints_(shell.pillars().size(), -1) {}

    int pointOf(int pillar, Level level) {
        int& first = firstPoints_[pillar];
        if (first < 0) {
            first = static_cast<int>(points_.size());
            const Pillar& p = shell_.pillars()[pillar];
            for (const Vec3& point : {p.bottom, p.middle, p.top}) {
                points_.push_back(frame_.toUser(point));
            }
        }
        return first + level;
    }

    std::vector<Vec3> take() { return std::move(points_); }

private:
    const Shell& shell_;
    const ShellFrame& frame_;
    std::vector<int> firstPoints_;
    std::vector<Vec3> points_;
};

std::array<int, 4> tetrahedron(
    const Prism& prism, const std::array<SplitVertex, 4>& split, Level outer, PointList& points
) {
    std::array<int, 4> tet{};
    std::ranges::transform(split, tet.begin(), [&](const SplitVertex& vertex) {
        return points.pointOf(prism.pillars[vertex.slot], vertex.outer ? outer : Level::Middle);
    });
    // The split is right-handed in the top slab over slots that run counter-clockwise.
    const bool isRightHanded = (outer == Top) == (prism.orientation > 0);
    if (!isRightHanded) {
        std::swap(tet[0], tet[1]);
    }
    return tet;
}

Triangle layerTriangle(const Prism& prism, Level level, PointList& points) {
    Triangle layer{};
    std::ranges::transform(prism.pillars, layer.begin(), [&](int pillar) {
        return points.pointOf(pillar, level);
    });
    if (prism.orientation < 0) {
        std::swap(layer[1], layer[2]);
    }
    return layer;
}

}  // namespace

bool isGhostPrism(const Shell& shell, int prism) {
    if (shell.isFullResolution()) {
        return shell.isGhost(prism);
    }
    // Faces beyond the boundary come after those of the surface.
    const std::span<const int> faces = shell.facesOf(prism);
    return faces.empty() || faces.front() >= shell.surfaceFaceCount();
}

ShellCells makeShellCells(const Shell& shell, const ShellFrame& frame) {
    ShellCells cells;
    PointList points(shell, frame);
    for (int i = 0; i < static_cast<int>(shell.prisms().size()); ++i) {
        const Prism& prism = shell.prisms()[i];
        if (prism.orientation == 0) {
            continue;
        }
        cells.prisms.push_back(i);
        cells.ghost.push_back(static_cast<char>(isGhostPrism(shell, i)));
        for (const Level outer : {Top, Bottom}) {
            for (const auto& split : kSlabSplit) {
                cells.tetrahedra.push_back(tetrahedron(prism, split, outer, points));
            }
        }
        for (const Level level : {Top, Middle, Bottom}) {
            cells.layers.push_back(layerTriangle(prism, level, points));
        }
    }
    cells.points = points.take();
    return cells;
}

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "imprint/imprint_nodes.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace bspline_curve {

/// A constrained Delaunay triangulation of one face: its corners, points in it and on its sides,
/// and segments between points that become edges. Which triangles there are is decided by exact
/// signs in the face's barycentric coordinates, which of them are Delaunay by lengths on the face
/// (S. W. Sloan, A fast algorithm for generating constrained Delaunay triangulations, 1993).
/// Points must be different, and no point may lie on a segment, nor two segments cross.
class FaceTriangulation {
public:
    /// Begins with a face, whose corners are points 0, 1 and 2. The memory of the face before is
    /// used again.
    void start(const Vec3& corner0, const Vec3& corner1, const Vec3& corner2);

    /// Adds a point and gives its number. O(1) to O(n) expected for the search.
    int addPoint(const FacePlace& place);
    /// Makes the segment between two points an edge. O(k) to O(k^2) for k edges that it crosses.
    void addSegment(int a, int b);

    /// Appends all triangles, with the face's orientation.
    void appendTriangles(std::vector<Triangle>& triangles) const;

private:
    /// The side of a cell opposite to its point k; cell -1: none.
    struct Side {
        int cell = -1;
        int k = 0;
    };

    struct Border {
        Side beyond;  ///< the same side, of the cell across
        bool isSegment = false;
    };

    struct Cell {
        Triangle points;
        std::array<Border, 3> borders{};
    };

    [[nodiscard]] int turn(int a, int b, int c) const;
    [[nodiscard]] int locate(int point) const;
    void splitCell(int cell, int point);
    void splitSide(Side side, int point);
    int addCell();
    void setCell(int cell, const Triangle& points, const std::array<Border, 3>& borders);

    [[nodiscard]] Border border(Side side) const { return cells_[side.cell].borders[side.k]; }

    /// The side that leads from a to b, if there is one.
    [[nodiscard]] Side findSide(int a, int b) const;
    [[nodiscard]] std::vector<Side> sidesAround(int point) const;
    [[nodiscard]] bool isConvex(Side side) const;
    [[nodiscard]] bool isDelaunay(Side side) const;
    void flip(Side side);
    void restoreDelaunay(std::vector<Side> suspects);
    void markSegment(Side side);
    [[nodiscard]] bool isCrossed(int a, int b, int from, int to) const;
    [[nodiscard]] std::vector<std::array<int, 2>> sidesCrossed(int a, int b) const;

    Eigen::Vector2d first_, second_;  // the sides from corner 0 to 1 and to 2, in their plane
    std::vector<FacePlace> places_;
    std::vector<Eigen::Vector2d> flat_;  // the points in that plane
    std::vector<Cell> cells_;
    std::vector<int> cellOf_;  // one cell of each point
};

}  // namespace bspline_curve

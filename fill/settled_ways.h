// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"
#include "bspline_curve/progress.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace bspline_curve {

/// Moves the vertices of a sheet, each along a way of its own, as far as that crosses nothing.
/// Where it would, ways are smoothed around, if that helps, then vertices stop earlier, with a
/// slope of at most a half to those around.
class SettledWays {
public:
    /// The vertices at faces that cross something, given all positions; none: nothing crosses.
    /// Strictly: also where only slivers do in single precision.
    using Crossing =
        std::function<std::vector<int>(const std::vector<Vec3>& points, bool isStrict)>;

    /// `ways`: for each vertex. `reach`: their length on the whole, positive where they lead out of
    /// the sheet's faces. Ways end at `leastShare` of their length at the latest. The sheet must
    /// outlive this.
    SettledWays(const TriangleMesh& sheet, std::vector<Vec3> ways, double reach, double leastShare);

    /// Until nothing crosses, strictly if that can be. At most 64 rounds of O(n) and one search for
    /// crossings each; the last search is for how vertices end. Throws Cancelled.
    void settle(const Crossing& crossing, const Progress& progress);

    [[nodiscard]] std::vector<Vec3> points() const;

    /// Of each way, how much of it its vertex goes.
    [[nodiscard]] const std::vector<double>& shares() const { return shares_; }

private:
    struct Edge {
        int a, b;
        double length;
        bool isOnRim;
    };

    bool settle(const Crossing& crossing, bool isStrict, const Progress& progress);
    void smoothAround(const std::vector<int>& vertices, int rings);
    bool shorten(const std::vector<int>& vertices);
    void turnOutOfFaces(const std::vector<int>& vertices);

    const TriangleMesh& sheet_;
    std::vector<Vec3> ways_;
    std::vector<double> shares_;
    double reach_;
    double leastShare_;
    std::vector<char> isOnRim_;
    std::vector<Edge> edges_;
};

}  // namespace bspline_curve

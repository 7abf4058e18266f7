// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"
#include "solver/curve_problem.h"

#include <optional>
#include <vector>

namespace bspline_curve {

/// A way along edges of the surface from one of its points to another: R of Alg. 2.
class EdgePath {
public:
    /// The shortest one, by Dijkstra's algorithm: from the first point to a corner of its face,
    /// along edges, and from a corner of the other's face to it; straight within one face. Faces
    /// without a prism are not entered. Nothing where there is none.
    [[nodiscard]] static std::optional<EdgePath> shortest(
        const CurveProblem& problem, const SurfacePoint& from, const SurfacePoint& to
    );

    [[nodiscard]] double length() const;

    /// The point at a distance from the start, in [0, length()].
    [[nodiscard]] SurfacePoint at(double distance) const;

private:
    /// A straight part in one face.
    struct Part {
        int face;
        Vec3 begin, end;  // barycentric
        double length;
    };

    void add(const CurveProblem& problem, int face, const Vec3& begin, const Vec3& end);

    std::vector<Part> parts_;
};

}  // namespace bspline_curve

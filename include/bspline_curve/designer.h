// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "bspline_curve/mesh.h"
#include "bspline_curve/options.h"
#include "bspline_curve/progress.h"
#include "bspline_curve/scalar_field.h"
#include "bspline_curve/shell.h"

#include <memory>
#include <span>
#include <vector>

namespace bspline_curve {

class ShellStore;
class Surface;
class TriangleTree;

/// What a curve is drawn by, besides its picks. All may be empty.
struct CurveInputs {
    ScalarField field{};
    std::span<const int> avoid{};  ///< faces that the curve must not enter
    /// Of each pick, how far from it the curve may pass, instead of SolverOptions::pickTolerance;
    /// empty: that of all. `start` has no effect with any above 0.
    std::span<const MeshLength> pickTolerances{};
    /// Picks, from 0 and in any order, at which the curve may turn: it is continuous there and no
    /// more, passes them whatever their tolerance, and is as fair as it can be on either side. The
    /// spline has knots there whose multiplicity is the degree. Without effect at the ends of an
    /// open curve.
    std::span<const int> corners{};
    /// Of each pick the direction in which the curve passes it, in any length, as its part along
    /// the surface: in the plane whose normal is the mean of the faces' normals there. Zero: any
    /// direction; empty: none is given. The pick is passed whatever its tolerance, and is no
    /// corner. For Interpolation::Constraint and InitialCurve::GeodesicFit. SolveReport::tangents
    /// tells how well they are met.
    std::span<const Vec3> tangents{};
    /// A curve of the same designer through as many picks, each near the one of now, as while a
    /// user drags a pick. The solver then starts from that curve, displaced with its picks, which
    /// takes six tenths of the time on average; the result bends as much as one from scratch. Has
    /// no effect where degree, closedness or corners differ, where `start` was not solved at foot
    /// points, or where a piece between picks would double or halve its length.
    const Curve* start = nullptr;
    /// The curve is shown for a moment, as while a user drags a pick: knots that it does not need
    /// stay in, which takes two thirds of the time.
    bool isPreview = false;
};

struct StageSeconds {
    double validate = 0.0, tree = 0.0, shell = 0.0;  ///< once per surface
};

/// Draws curves on one mesh; keeps what can be used again for the next curve (tree, shell). All ids
/// are those of the mesh as it was given, whether or not it had to be mended. Several threads may
/// draw at once.
class CurveDesigner {
public:
    /// Validates the mesh (finite, oriented, two-manifold, every face with area), mended as
    /// `mending` says where it is not, and builds the shell, or takes it from `store` where one is
    /// given (null: none); a simplified shell that it has built is stored there. A local shell is
    /// built near each curve, and the whole of it with the first curve that needs it. Throws
    /// InputError, Cancelled. A local shell: O(n log n), about 0.6 us per face with two threads.
    explicit CurveDesigner(
        TriangleMesh mesh,
        const ShellOptions& options = {},
        const MendingOptions& mending = {},
        const Progress& progress = {},
        const ShellStore* store = nullptr
    );
    /// The same on a surface that is there already, which took so many seconds.
    explicit CurveDesigner(
        std::shared_ptr<const Surface> surface,
        const ShellOptions& options = {},
        const Progress& progress = {},
        const ShellStore* store = nullptr,
        double seconds = 0.0
    );
    ~CurveDesigner();
    CurveDesigner(CurveDesigner&&) noexcept;
    CurveDesigner& operator=(CurveDesigner&&) noexcept;

    /// One curve through the picks (user's unit). Throws InputError, Cancelled. A curve that did
    /// not reach its tolerance is returned, with report.usable == false.
    [[nodiscard]] Curve design(
        const std::vector<Vec3>& picks,
        const SolverOptions& options = {},
        const SamplingOptions& sampling = {},
        const CurveInputs& inputs = {},
        const Progress& progress = {}
    ) const;

    /// A smooth curve along a line on the mesh (points in the user's unit, joined by shortest paths
    /// and, as the solver's options say, closed): edges of a mesh, a stroke, a polyline of a file.
    /// An open one keeps its ends. Its picks are points of the curve, so that one drawn through
    /// them is like it. Of the solver's options pickTolerance has no effect. Throws InputError
    /// (NoPath also where there is no smooth curve so near), Cancelled. O(n) for n points: about 50
    /// microseconds a point.
    [[nodiscard]] Curve fit(
        const std::vector<Vec3>& line,
        const FitOptions& fit = {},
        const SolverOptions& options = {},
        const SamplingOptions& sampling = {},
        const Progress& progress = {}
    ) const;

    /// The mesh as it was given.
    [[nodiscard]] const TriangleMesh& mesh() const;
    /// What curves are drawn on, for the library's other parts; as long as the designer.
    [[nodiscard]] const Surface& surface() const;
    /// Over the faces of surface(), likewise.
    [[nodiscard]] const TriangleTree& tree() const;
    [[nodiscard]] StageSeconds seconds() const;
    [[nodiscard]] ShellSummary shell() const;

    /// What the shell looks like, for people: the whole of it, which this builds where it is local.
    [[nodiscard]] ShellLayers shellLayers() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace bspline_curve

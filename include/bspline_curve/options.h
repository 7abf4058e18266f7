// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace bspline_curve {

/// What is done to a mesh that is no oriented two-manifold before it is used.
struct MendingOptions {
    bool strict = false;  ///< nothing: it is refused
    double weld = 0.0;    ///< vertices within so many diagonals are joined first, >= 0
    bool slits = false;   ///< boundary edges that lie on each other stay parted

    /// Throws InputError (BadOption) where a mesh is to be taken as it is and to be welded.
    void validate() const;

    friend bool operator==(const MendingOptions&, const MendingOptions&) = default;
};

/// What to bend (4): the whole second derivative, as in the paper, or only the part that the
/// surface does not force.
enum class Bending { Geodesic, Ambient };
/// c(x) of the field term (5). Natural: that which the field is meant for, see
/// ScalarField::naturalCost().
enum class FieldCost { Identity, Square, ExpMinus, Natural };
/// How the first spline is made: a fit to the geodesic through the picks, or Alg. 2 of the paper.
enum class InitialCurve { GeodesicFit, ControlPolygon };
/// Where the integrals are taken: at samples by their foot points on the surface, which is quick on
/// any resolution; exactly cell by cell; or at evenly spaced samples in the shell (14)-(16).
enum class Quadrature { FootPoints, Cells, Samples };
/// Upper bound h of the barrier (11): 1, or tightened around the current curve by (12).
enum class BarrierWidth { Full, Tight };
/// Weight alpha of E_dist: a schedule that follows the distance, or (18).
enum class DistanceWeight { Schedule, Adaptive };
/// How picks are interpolated: eliminated as linear constraints, or the penalty E_fit (9) with
/// weight beta.
enum class Interpolation { Constraint, Penalty };
/// Which spans get knots: those where energy or distance asks for them, or the feature function
/// (19)-(23).
enum class KnotRule { EnergyAndDistance, FeatureFunction };
/// The height relative to the surface in a simplified shell: linear below and above the surface, as
/// in (10), or a smooth map with the same values at bottom, surface and top.
enum class RelativeHeight { Smooth, Linear };

/// In units of the square root of the surface's area. On finer meshes the tolerance would ask for
/// more knots, and more time, than what anyone sees of a curve: with the default tolerance the
/// spline then is within a thousandth of that root of the surface, on which its polyline lies in
/// any case.
inline constexpr double kFinestEdge = 0.01;

/// Numbers of the paper's own settings; each is used only where the option that it belongs to is
/// the paper's.
struct PaperOptions {
    int curveSegments = 200;  ///< M of (14)-(16): even segments of the whole curve, in [1, 10000]
    int gaussPoints = 2;      ///< M' of (14)-(16): Gauss points on each segment, in [1, 4]
    double barrierMargin = 0.02;  ///< epsilon_b of (12), of the relative height, in (0, 1]
    double heightScale = 0.99;  ///< eta of Sect. 4.2: relative height of points outside, in (0, 1]
    double alphaMin = 1.0;      ///< of (18), > 0
    double alphaMax = 1e8;      ///< of (18), > 0
    double betaFirst = 1e6;     ///< beta of the first round, > 0
    double betaMin = 10.0;      ///< of (18) for beta, > 0
    double betaMax = 1e10;      ///< the same, > 0
    double knotRatio = 1.0;     ///< r of (22), > 0; more of it inserts more knots in a round
    double featureTolerance =
        1.0;  ///< epsilon_d of the stop rules 1 and 2, relative to the energy,
              ///< >= 0

    friend bool operator==(const PaperOptions&, const PaperOptions&) = default;
};

/// A length: in the unit of the mesh, or in mean lengths of its edges.
struct MeshLength {
    double value = 0.0;
    bool isInEdges = false;

    [[nodiscard]] double in(double meanEdge) const { return isInEdges ? value * meanEdge : value; }

    friend bool operator==(const MeshLength&, const MeshLength&) = default;
};

/// "0.4"; "1edge", "0.5 edges". Throws InputError (BadOption) where it is neither, negative or not
/// finite; `name`: of the option, for the message.
[[nodiscard]] MeshLength parseLength(const std::string& text, const std::string& name);
/// The same back again.
[[nodiscard]] std::string describe(const MeshLength& length);

/// What makes a curve fair.
enum class Fairness {
    Curvature,  ///< the length times the integral of its squared geodesic curvature, whatever its
                ///< parameter: without a field, a region to avoid or tension over 0.5; else as
                ///< Parametric
    Parametric  ///< second derivatives by a parameter that is fixed at the start (4), as in the
                ///< paper
};

/// Options of one curve. The defaults are what measured best; paperPreset() is what the paper says.
struct SolverOptions {
    int degree = 3;        ///< polynomial degree (the paper's k), 2, 3 or 4
    bool closed = false;   ///< a periodic curve through the picks; at least 3 picks
    double tension = 0.0;  ///< lambda of (4), in [0, 1]: 0 smooth, 1 straight
    Fairness fairness = Fairness::Curvature;
    /// How far from a pick the curve may pass: it is as fair as it can be within that distance of
    /// all picks, as points of the surface. 0: it passes them. >= 0
    MeshLength pickTolerance{};
    /// Picks that are farther from the mesh are refused, in the user's unit; 0: 1 % of its
    /// diagonal. >= 0
    double pickDistance = 0.0;
    double fieldWeight = 2000.0;  ///< mu of (7), >= 0, for costs between 0 and 1; has no effect
                                  ///< without a field
    FieldCost fieldCost = FieldCost::Natural;
    bool fieldGuidesPath = true;  ///< the first curve follows the field as well, not only geodesics

    double avoidMargin = 0.02;  ///< what is avoided pushes the curve from this far away on,
                                ///< relative to the diagonal, in (0, 1]

    /// epsilon of (3), in average edge lengths, where edges shorter than kFinestEdge count as that
    /// long, > 0
    double distanceTolerance = 0.1;
    Bending bending = Bending::Geodesic;
    double normalBendingWeight =
        0.05;  ///< delta: share of normal bending kept by Bending::Geodesic, in (0, 1]
    InitialCurve initialCurve = InitialCurve::GeodesicFit;
    /// FootPoints is for degrees 3 and 4, tension up to 0.5, fields up to 20 times as strong as
    /// usual, curves that what they avoid does not push, and the defaults of the options from here
    /// to knotRule; other curves, and those that do not come to lie in the shell that way, are
    /// integrated by Cells.
    Quadrature quadrature = Quadrature::FootPoints;
    BarrierWidth barrierWidth = BarrierWidth::Full;
    DistanceWeight distanceWeight = DistanceWeight::Schedule;
    Interpolation interpolation = Interpolation::Constraint;
    KnotRule knotRule = KnotRule::EnergyAndDistance;
    RelativeHeight relativeHeight = RelativeHeight::Smooth;
    PaperOptions paper{};
    int maxRounds = 24;       ///< rounds of minimisation and knot insertion, >= 1
    int maxIterations = 100;  ///< Newton iterations per round, >= 1
    double minimumSpan =
        1e-4;  ///< epsilon_int of (23): no knot span shorter than this, in (0, 0.1]

    /// Throws InputError (BadOption) naming field, value and rule.
    void validate() const;

    friend bool operator==(const SolverOptions&, const SolverOptions&) = default;
};

/// The settings of the paper (2023), for comparison; degree, closed, tension and field stay at
/// their defaults. They are meant for a simplified shell (ShellKind::Simplified).
[[nodiscard]] SolverOptions paperPreset();

/// How a curve is fitted to a line that is there already.
struct FitOptions {
    /// How far from the line the curve may be, >= 0: nowhere farther, and as fair as it can be
    /// where the line is off by about a quarter of that. 0: by a mean edge length, and no more than
    /// the line's own noise, waves of up to a dozen of its points, asks for. The spline has as few
    /// knots as this allows: it may be off the surface by a tenth of it, where that is more than
    /// SolverOptions::distanceTolerance.
    MeshLength deviation{};
    /// In degrees, in [1, 180]: where the line turns by as much and more, along the surface and by
    /// more than its noise explains, the curve has a corner. 180: it has none. Steps along mesh
    /// edges and hands that tremble make no corners; the report tells which there are.
    double cornerAngle = 60.0;

    /// Throws InputError (BadOption).
    void validate() const;

    friend bool operator==(const FitOptions&, const FitOptions&) = default;
};

/// How finely the polyline follows the spline. The crossings of mesh edges and the picks are always
/// vertices.
struct SamplingOptions {
    int samples = 256;  ///< at least this many evenly spaced parameters as well; 0: none asked
    double maxSegmentLength = 0.0;  ///< no segment longer than this, user's unit; 0: not limited

    /// Throws InputError (BadOption).
    void validate() const;
};

}  // namespace bspline_curve

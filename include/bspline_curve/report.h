// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>
#include <vector>

namespace bspline_curve {

/// Why a minimisation or the whole solve stopped.
enum class SolveStatus {
    Converged,        ///< within tolerance, and more knots no longer change the result
    DistanceReached,  ///< max distance below tolerance, but the last minimisation did not converge
    KnotLimit,        ///< no knot may be inserted any more (23), distance still above tolerance
    RoundLimit,       ///< rounds used up, distance still above tolerance
    TightFit,         ///< no relaxed spline was found: one that follows a shortest path closely
    ShortestPath,     ///< nor that: the polyline is the shortest path itself, the spline beside it
};

enum class MinimiseStatus { Converged, LineSearchStalled, IterationLimit, NotPositive, Outside };

[[nodiscard]] const char* name(SolveStatus status);
[[nodiscard]] const char* name(MinimiseStatus status);

/// The four terms of (7) and that of what the curve avoids, unweighted.
struct EnergyTerms {
    double internal = 0.0, external = 0.0, distance = 0.0, fit = 0.0, avoidance = 0.0;

    friend EnergyTerms operator+(const EnergyTerms& a, const EnergyTerms& b) {
        return {
            a.internal + b.internal,
            a.external + b.external,
            a.distance + b.distance,
            a.fit + b.fit,
            a.avoidance + b.avoidance
        };
    }
};

struct IterationReport {
    int round = 0;
    double total = 0.0;  ///< weighted sum (7)
    EnergyTerms terms;
    double decrement = 0.0;  ///< Newton decrement, half the squared norm, in units of the energy
    double step = 0.0;       ///< accepted step length, above 1 where the whole step was too short
};

struct RoundReport {
    double alpha = 0.0, beta = 0.0;
    int knots = 0;
    int iterations = 0;
    MinimiseStatus status = MinimiseStatus::Converged;
    double maxDistance = 0.0;  ///< in average edge lengths
};

/// A part of a curve where it is farther from the surface than it may be.
struct FarPart {
    double from = 0.0, to = 0.0;  ///< parameters
    std::vector<int> faces;       ///< under it, ascending
};

/// A part of a curve from one pick to the next that is longer than it had to be.
struct Detour {
    /// What it goes round: edges that lie on each other and stay parted; edges that mending has
    /// cut, and that it could not pass; or what a field, faces to avoid or faces that its shell
    /// leaves out lead it round, where that is more than 1.5 times as long.
    enum class Round { Slit, Cut, Guides };

    int from = 0, to = 0;  ///< picks
    double ratio = 1.0;    ///< of its length and that of the shortest path
    Round round = Round::Guides;
};

/// How well a curve has the direction that was asked for at a pick, in radians; at a corner, the
/// larger angle of the directions that were.
struct MetTangent {
    int pick = 0;
    bool isBefore = true, isAfter = true;  ///< the sides of a corner that have one
    double ofSpline = 0.0;                 ///< the angle between the direction and P'
    double ofPolyline = 0.0;  ///< the larger one of those of the segments beside the pick, seen
                              ///< along the normal: they are chords
};

/// "slit", "cut", "guides".
[[nodiscard]] const char* name(Detour::Round round);

/// How a curve came about: what every stage did and why it stopped.
struct SolveReport {
    SolveStatus status = SolveStatus::RoundLimit;
    /// True where the curve may be used: it passes all picks and lies within the tolerance of the
    /// surface.
    bool usable = false;
    /// Where a curve that is not usable is too far from the surface, as far as that is known.
    std::optional<FarPart> farPart;
    int knotsFirst = 0, knotsLast = 0;  ///< length of the knot vector, end knots with multiplicity
    bool isSampled = false;             ///< at foot points, not cell by cell
    double maxDistance = 0.0;  ///< largest distance of spline and surface, in average edge lengths
    /// What that was to stay below, in average edge lengths: more than the option says where edges
    /// are very short (kFinestEdge).
    double allowedDistance = 0.0;
    double maxPickGap = 0.0;  ///< largest |P(t_ki) - x_i|, relative to the diagonal
    /// What distances are relative to above, in the user's unit.
    double meanEdgeLength = 0.0, diagonal = 0.0;
    int newtonIterations = 0;
    /// Of its weight, what the field had: less than 1 where it drew the ends of an open curve past
    /// their picks.
    double fieldShare = 1.0;
    double fieldCost = 0.0;  ///< E_ext (5), the mean of c over t; 0 without a field
    /// False where the iterations ended although the field still pulled: a sharper curve would cost
    /// less.
    bool fieldAtRest = true;
    /// Picks at the same point as the one before (on a closed curve also as the first), ascending:
    /// the curve passes that point once.
    std::vector<int> repeatedPicks;
    /// Of each pick, as a point of the surface, its distance from the polyline, in the user's unit,
    /// where the curve need not pass the picks; else empty.
    std::vector<double> pickDistances;
    /// Of a curve that was fitted to a line: how far it is from it at most, in the user's unit.
    std::optional<double> lineDistance;
    /// And by how many degrees the line turns at each of the curve's corners, along the curve.
    std::vector<double> cornerTurns;
    std::vector<Detour> detours;       ///< by pick
    std::vector<MetTangent> tangents;  ///< of picks with one, ascending
    int avoidedFaces = 0;
    /// Least distance of a vertex of the polyline to the avoided faces, user's unit; infinite where
    /// there are none.
    double clearance = std::numeric_limits<double>::infinity();
    std::vector<RoundReport> rounds;
    std::vector<IterationReport> iterations;

    struct Seconds {
        double path = 0.0, initial = 0.0, minimise = 0.0, knots = 0.0, polyline = 0.0;
        /// Attempts that led to no curve, before the one that did, and the
        /// shell of the whole surface where this curve was the first to need it.
        double failedAttempts = 0.0, shell = 0.0;
    } seconds;
};

}  // namespace bspline_curve

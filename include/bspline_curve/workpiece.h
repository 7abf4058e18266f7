// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "bspline_curve/curve_options.h"
#include "bspline_curve/error.h"
#include "bspline_curve/field.h"
#include "bspline_curve/mesh.h"
#include "bspline_curve/mesh_checksum.h"
#include "bspline_curve/options.h"
#include "bspline_curve/progress.h"
#include "bspline_curve/repair.h"
#include "bspline_curve/shell.h"
#include "bspline_curve/tangent.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace bspline_curve {

/// What a curve is drawn by, besides its picks. All may be empty.
struct CurveInputs {
    ScalarField field{};
    std::span<const int> avoid{};  ///< faces that the curve must not enter
    /// Of each pick, how far from it the curve may pass, instead of SolverOptions::pickTolerance;
    /// empty: that of all. `start` has no effect with any above 0.
    std::span<const MeshLength> pickTolerances{};
    /// Of each pick, in place of its tolerance, how much it costs to pass it at a distance d:
    /// weight (d / diagonal)^2, beside the curve's length times the integral of its squared
    /// geodesic curvature, which is 4 pi^2 for a circle; >= 0. No bound: the report tells d. 0: the
    /// tolerance holds; empty: for all. The curve passes its tangents' picks whatever their weight.
    std::span<const double> pickWeights{};
    /// Picks, from 0 and in any order, at which the curve may turn: it is continuous there and no
    /// more, passes them whatever their tolerance, and is as fair as it can be on either side. The
    /// spline has knots there whose multiplicity is the degree. Without effect at the ends of an
    /// open curve.
    std::span<const int> corners{};
    /// Of each pick the direction in which the curve passes it; of a corner that in which it comes
    /// and that in which it goes on. Empty: none is given. The pick is passed whatever its
    /// tolerance. Of the ends of an open curve the side that there is counts. For
    /// Interpolation::Constraint and InitialCurve::GeodesicFit. SolveReport::tangents tells how
    /// well they are met.
    std::span<const PickTangent> tangents{};
    /// A curve on the same workpiece through as many picks, each near the one of now, as while a
    /// user drags a pick. The solver then starts from that curve, displaced with its picks, which
    /// takes six tenths of the time on average; the result bends as much as one from scratch. Has
    /// no effect where degree, closedness or corners differ, where `start` was not solved at foot
    /// points, or where a piece between picks would double or halve its length.
    const Curve* start = nullptr;
    /// The curve is shown for a moment, as while a user drags a pick: knots that it does not need
    /// stay in, which takes two thirds of the time.
    bool isPreview = false;
};

/// A curve that was drawn, with all that hosts show and write of it.
struct DesignedCurve {
    Curve curve;
    ScalarField field{};          ///< that it follows; empty: none
    Region avoid{};               ///< faces that it does not enter
    std::vector<double> along{};  ///< the field at the vertices of the polyline, or none
    double fieldSeconds = 0.0, seconds = 0.0;  ///< the second without the first
    std::vector<std::string> notes{};  ///< of this curve: what people must know, see asSentence()
};

/// What preparing a mesh took.
struct StageSeconds {
    double validate = 0.0, tree = 0.0, shell = 0.0;  ///< once per mesh; 0 until that was done
};

/// The point of a mesh that is nearest to another one.
struct ClosestPoint {
    SurfacePoint place;  ///< of the mesh as it was given
    Vec3 position = Vec3::Zero();
    double distance = 0.0;  ///< user's unit
};

/// A mesh that curves are drawn on, prepared once for all curves on it and for what is made of
/// them. Begin here:
///
///     const Workpiece workpiece({vertices, faces});
///     SolverOptions options;
///     options.closed = true;
///     const Curve curve = workpiece.draw(picks, options).curve;
///
/// Ids of vertices and faces are everywhere those of the mesh as it was given, whether or not it
/// had to be mended. The functions of imprint.h, parts.h, offset.h, pattern.h, lines.h, files.h and
/// drawing_session.h go on from here. Several threads may use one at once; what they get does not
/// depend on how many there are. What is handed out by reference lives as long as the workpiece.
class Workpiece {
public:
    /// Validates the mesh (finite, oriented, two-manifold, every face with area) and mends it where
    /// it is not, unless the options are strict. O(n log n); with prepare() about 0.6 us per face
    /// on two threads. Throws InputError (what is wrong with mesh or options), Cancelled.
    explicit Workpiece(
        TriangleMesh mesh, const PreparingOptions& options = {}, const Progress& progress = {}
    );
    ~Workpiece();
    Workpiece(Workpiece&&) noexcept;
    Workpiece& operator=(Workpiece&&) noexcept;

    /// As it was given.
    [[nodiscard]] const TriangleMesh& mesh() const;
    /// As it is used: mended; the same one where nothing had to be. Its ids are its own.
    [[nodiscard]] const TriangleMesh& mendedMesh() const;
    [[nodiscard]] const PreparingOptions& options() const;
    /// By which files know the mesh again; computed when it is first asked for. O(n).
    [[nodiscard]] MeshChecksum checksum() const;
    /// Of the box of all vertices of faces, user's unit: what relative lengths are relative to.
    [[nodiscard]] double diagonal() const;
    /// Mean length of the edges of the mended mesh, user's unit.
    [[nodiscard]] double meanEdgeLength() const;
    /// Parts of the mended mesh that no edges join.
    [[nodiscard]] int componentCount() const;

    /// What was mended; null: nothing.
    [[nodiscard]] const RepairReport* repair() const;
    /// The same for people: "the mesh was mended: 1 vertex duplicated"; empty: nothing.
    [[nodiscard]] std::string mending() const;
    /// What people must know of the mesh: what was mended, how to have it otherwise. `strict`: the
    /// option that refuses such meshes, as the host calls it.
    [[nodiscard]] std::vector<std::string> notes(const std::string& strict = "strict") const;

    /// Makes what all curves need, a tree and the shell, unless that is done; the first curve does
    /// it otherwise. O(n log n); a simplified shell takes seconds. Throws Cancelled.
    void prepare(const Progress& progress = {}) const;
    /// What validating and preparing took.
    [[nodiscard]] StageSeconds seconds() const;
    /// The shell that curves are sought in; of kind ShellKind::Local it is built near each curve.
    [[nodiscard]] ShellSummary shell() const;
    /// What the shell looks like, for people: the whole of it, which this builds where it is local.
    [[nodiscard]] ShellLayers shellLayers() const;

    /// The point of the mesh that is nearest to one of space. O(log n). Expects finite coordinates.
    [[nodiscard]] ClosestPoint closestPoint(const Vec3& point) const;

    /// One curve through the picks, points near the mesh in the user's unit. A curve that did not
    /// reach its tolerance is returned, with `curve.report.usable == false`; notes say why. Takes
    /// as long as docs/PERFORMANCE.md tells, little more on fine meshes. Throws InputError (codes
    /// of picks, BadField, BadOption, NoPath), Cancelled.
    [[nodiscard]] DesignedCurve draw(
        const std::vector<Vec3>& picks,
        const SolverOptions& options = {},
        const SamplingOptions& sampling = {},
        const CurveInputs& inputs = {},
        const Progress& progress = {}
    ) const;
    /// The same with all that can be asked for, as programs have it: the field is made and faces to
    /// avoid are found from the quality and the selections of `with`, whose own mesh is not looked
    /// at. `start`: see CurveInputs. Throws likewise, and as field().
    [[nodiscard]] DesignedCurve draw(
        const std::vector<Vec3>& picks,
        const CurveOptions& options,
        const LayerInput& with,
        const Progress& progress = {},
        const Curve* start = nullptr
    ) const;

    /// A smooth curve along a line near the mesh (points in the user's unit, joined by shortest
    /// paths and, as the options say, closed): edges of a mesh, a stroke, a polyline of a file. An
    /// open one keeps its ends. Its picks are points of the curve, so that one drawn through them
    /// is like it. Of the solver's options pickTolerance has no effect. About 50 us a point. Throws
    /// InputError (NoPath also where there is no smooth curve so near), Cancelled.
    [[nodiscard]] DesignedCurve fit(
        const std::vector<Vec3>& line,
        const FitOptions& fit = {},
        const CurveOptions& options = {},
        const Progress& progress = {}
    ) const;

    /// A field, one value for each vertex. `with`: as for draw(). Throws as makeField(), and
    /// InputError (BadField) where there is no quality.
    [[nodiscard]] ScalarField field(
        const LayerInput& with, const FieldRequest& request, const Progress& progress = {}
    ) const;

    /// A curve that is there already with what draw() tells of it; `field`: that it follows.
    [[nodiscard]] DesignedCurve finished(Curve curve, const ScalarField& field) const;

    /// For the library itself, which knows what it is.
    struct Parts;

    [[nodiscard]] const Parts& parts() const { return *parts_; }

private:
    std::unique_ptr<const Parts> parts_;
};

/// The workpiece of a layer, whose ids errors then name. Throws InputError, Cancelled.
[[nodiscard]] std::shared_ptr<const Workpiece> workpieceOf(
    const LayerInput& layer, const PreparingOptions& options, const Progress& progress = {}
);

}  // namespace bspline_curve

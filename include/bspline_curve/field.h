// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"
#include "bspline_curve/options.h"
#include "bspline_curve/progress.h"
#include "bspline_curve/scalar_field.h"

#include <array>
#include <span>

namespace bspline_curve {

/// What the values of a field are made from.
enum class FieldKind {
    NormalVariation,   ///< how much the normals around turn away (24)
    MaximalCurvature,  ///< largest principal curvature (25)
    Ridge,             ///< how much the surface is a ridge: convex across
    Valley,            ///< how much it is a valley: concave across
    CreaseDistance,    ///< geodesic distance to the nearest edge with a large angle
    BoundaryDistance,  ///< geodesic distance to the nearest edge with one face
    Quality,           ///< the user's own values
    Obstacle,          ///< a hill on every chosen region of faces (26)
};

inline constexpr std::array kFieldKinds = {
    FieldKind::NormalVariation,
    FieldKind::MaximalCurvature,
    FieldKind::Ridge,
    FieldKind::Valley,
    FieldKind::CreaseDistance,
    FieldKind::BoundaryDistance,
    FieldKind::Quality,
    FieldKind::Obstacle,
};

/// As users write it.
[[nodiscard]] const char* name(FieldKind kind);

/// The cost c of (5) that a kind is meant for: the paper's where it names one.
[[nodiscard]] FieldCost naturalCost(FieldKind kind);

/// As users write it.
[[nodiscard]] const char* name(FieldCost cost);

/// Options of a field; all lengths are relative to the diagonal of the surface's box.
struct FieldOptions {
    FieldKind kind = FieldKind::MaximalCurvature;
    /// Curvature, ridge and valley: radius of the discs that curvatures are averaged over, in
    /// [0, 1].
    double curvatureScale = 0.015;
    /// Crease distance: edges are creases where the normals of their faces differ by more, in
    /// degrees, in [0, 180].
    double creaseAngle = 40.0;
    /// Crease and boundary distance: the distance that becomes 1, as do larger ones, in (0, 1].
    double reach = 0.1;
    /// Obstacle: value on the boundary of the region, the paper's s, >= 0.
    double obstacleValue = 1.0;
    /// Obstacle: how steeply the field grows from the boundary inwards, per diagonal, > 0.
    double obstacleSlope = 1.0;
    /// Radius of the discs that the finished values are averaged over, in [0, 1]; 0: none.
    double smoothing = 0.0;
    bool normalised = false;  ///< then mapped to [0, 1], see normalise()
    bool inverted = false;    ///< then high and low change places, see invert()

    /// Throws InputError (BadOption) naming field, value and rule.
    void validate() const;
};

/// What some kinds are made from.
struct FieldInputs {
    std::span<const double> quality{};  ///< Quality: one value per vertex
    std::span<const int> region{};      ///< Obstacle: faces, see Region
};

/// One value per vertex, as FieldKind says, then smoothed, normalised and inverted as the options
/// ask. Every kind is the same in every unit and position of the mesh (quality: as given), and
/// does not depend on the number of threads.
/// Throws InputError: what is wrong with the mesh (see CurveDesigner); BadOption; BadField (no
/// crease or no boundary to measure from; a quality of another size, or that is not finite, naming
/// the vertices; a region that obstacleField refuses); IndexOutOfRange (a region with ids of no
/// face). Throws Cancelled.
[[nodiscard]] ScalarField makeField(
    const TriangleMesh& mesh,
    const FieldOptions& options,
    const FieldInputs& inputs = {},
    const Progress& progress = {}
);

}  // namespace bspline_curve

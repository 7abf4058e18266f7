// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"
#include "bspline_curve/options.h"
#include "bspline_curve/progress.h"

#include <array>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace bspline_curve {

/// A scalar field on a mesh: one finite value per vertex. Copies share the values, and a designer
/// that gets the same field again need not look at it again.
class ScalarField {
public:
    /// No field at all.
    ScalarField() = default;

    /// NOLINTNEXTLINE(google-explicit-constructor): values are a field
    ScalarField(std::vector<double> values)
        : values_(
              values.empty() ? nullptr
                             : std::make_shared<const std::vector<double>>(std::move(values))
          ) {}

    [[nodiscard]] bool empty() const { return values_ == nullptr; }

    /// The cost c of (5) that its values are meant for: of a field of makeField() that of its kind,
    /// of values themselves the identity.
    [[nodiscard]] FieldCost naturalCost() const { return naturalCost_; }

    void setNaturalCost(FieldCost cost) { naturalCost_ = cost; }

    /// What an option asks for: a cost, or the natural one.
    [[nodiscard]] FieldCost costFor(FieldCost asked) const {
        return asked == FieldCost::Natural ? naturalCost_ : asked;
    }

    /// One per vertex of the mesh as the caller has it.
    [[nodiscard]] const std::vector<double>& values() const {
        static const std::vector<double> kNone;
        return values_ ? *values_ : kNone;
    }

    /// The same where it was made: a mesh that had to be mended has other vertices there. For the
    /// library itself.
    struct OnSurface {
        std::shared_ptr<const void> surface;  ///< which one
        std::vector<double> values;           ///< one per vertex of it
    };

    ScalarField(std::vector<double> values, std::shared_ptr<const OnSurface> onSurface)
        : ScalarField(std::move(values)) {
        onSurface_ = std::move(onSurface);
    }

    [[nodiscard]] const std::shared_ptr<const OnSurface>& onSurface() const { return onSurface_; }

    [[nodiscard]] const std::shared_ptr<const std::vector<double>>& shared() const {
        return values_;
    }

private:
    std::shared_ptr<const std::vector<double>> values_;
    std::shared_ptr<const OnSurface> onSurface_;
    FieldCost naturalCost_ = FieldCost::Identity;
};

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
    bool normalised = false;  ///< then mapped to [0, 1] by its quantiles of 1 and 99 %
    bool inverted = false;    ///< then x becomes least + largest - x

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
/// Throws InputError: what is wrong with the mesh (see Workpiece); BadOption; BadField (no crease
/// or no boundary to measure from; a quality of another size, or that is not finite, naming the
/// vertices; a region without faces, or that covers a component); IndexOutOfRange (a region with
/// ids of no face). Throws Cancelled.
[[nodiscard]] ScalarField makeField(
    const TriangleMesh& mesh,
    const FieldOptions& options,
    const FieldInputs& inputs = {},
    const Progress& progress = {}
);

}  // namespace bspline_curve

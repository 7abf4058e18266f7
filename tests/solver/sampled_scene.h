// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "projection/fibre_projector.h"
#include "solver/curve_problem.h"
#include "solver/obstacles.h"
#include "solver/sampled_integrals.h"
#include "surface/triangle_tree.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace bspline_curve::test_support {

inline constexpr double kAlpha = 20.0;
inline constexpr EnergyWeights kSceneWeights{.alpha = kAlpha, .avoidance = 3.0};

using Way = std::function<Vec3(double)>;

/// An open or closed way round the unit sphere, at some radius.
[[nodiscard]] Way roundTheSphere(double radius, bool closed);
[[nodiscard]] TriangleMesh noisySphere();

/// The breaks and the middles of some spans.
[[nodiscard]] std::vector<double> breaksWithMiddles(
    const SplineSpace& space, const std::vector<int>& spans
);
/// A spline whose feet are the nearest points of an extended surface, not yet followed.
[[nodiscard]] FootedSpline withNearestFeet(
    const SampledIntegrals& energy,
    const SplineSpace& space,
    const TriangleTree& tree,
    ControlPoints controls
);

/// A problem with an energy and a spline near a way, in the user's unit. No shell is needed.
class Scene {
public:
    Scene(const TriangleMesh& mesh, const SolverOptions& options, const Way& way, int spans);

    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;

    void setField(const std::function<double(const Vec3&)>& value);

    /// Avoids the faces whose middle, in the user's unit, is in a region.
    void avoid(const std::function<bool(const Vec3&)>& isIn, double margin);

    /// Holds the spline to a way, in the user's unit, at even parameters.
    void setFairedShape(const Way& way);

    [[nodiscard]] SampledIntegrals energy() const { return {problem_, space_, edge_}; }

    [[nodiscard]] const SplineSpace& space() const { return space_; }

    [[nodiscard]] const CurveProblem& problem() const { return problem_; }

    [[nodiscard]] const ExtendedSurface& extended() const { return extended_; }

    [[nodiscard]] const ControlPoints& controls() const { return controls_; }

    [[nodiscard]] double edge() const { return edge_; }

    /// A spline with feet that are sought from the nearest points of the surface.
    [[nodiscard]] FootedSpline footed(const SampledIntegrals& energy, ControlPoints controls) const;

    /// The spline moved, with its feet sought from where they are.
    [[nodiscard]] FootedSpline moved(
        const SampledIntegrals& energy, const FootedSpline& from, const ControlPoints& change
    ) const;

private:
    Surface surface_;
    ExtendedSurface extended_;
    TriangleTree tree_;
    FibreProjector finder_;
    double edge_;
    SplineSpace space_;
    std::vector<double> field_;
    std::unique_ptr<Obstacles> obstacles_;
    CurveProblem problem_;
    ControlPoints controls_;
};

[[nodiscard]] ControlPoints randomChange(const SplineSpace& space, std::uint64_t seed);
[[nodiscard]] Eigen::Map<const Eigen::VectorXd> flat(const ControlPoints& controls);
[[nodiscard]] SpanMatrix denseOf(const SpanBlocks& blocks, int basisCount);
[[nodiscard]] Eigen::VectorXd product(
    const std::vector<SpanBlocks>& hessian, const SplineSpace& space, const Eigen::VectorXd& x
);

struct Derivatives {
    EnergyTerms terms;
    Eigen::VectorXd gradient;
    std::vector<SpanBlocks> hessian;
};

[[nodiscard]] Derivatives derivativesOf(
    const SampledIntegrals& energy, const FootedSpline& spline, double turning
);

}  // namespace bspline_curve::test_support

// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/option_bindings.h"

#include "filters/binding_makers.h"

#include <utility>

namespace bspline_curve {

namespace {

/// Binds a number of the paper.
template <class Value>
Binding<SolverOptions> boundInPaper(const std::string& id, Value PaperOptions::* member) {
    return {
        .id = id,
        .read = [member](
                    const ParameterValue& value, SolverOptions& options
                ) { options.paper.*member = std::get<Value>(value); },
        .write = [member](const SolverOptions& options) -> ParameterValue {
            return options.paper.*member;
        }
    };
}

Names<FieldKind> fieldKinds() {
    Names<FieldKind> names;
    for (const FieldKind kind : kFieldKinds) {
        names.emplace_back(name(kind), kind);
    }
    return names;
}

Names<FieldCost> fieldCosts() {
    Names<FieldCost> names;
    for (const FieldCost cost :
         {FieldCost::Natural, FieldCost::Identity, FieldCost::Square, FieldCost::ExpMinus}) {
        names.emplace_back(name(cost), cost);
    }
    return names;
}

/// What the curve is.
Bindings<SolverOptions> shapeBindings() {
    using S = SolverOptions;
    return {
        bound("closed", &S::closed),
        bound("degree", &S::degree),
        bound("tension", &S::tension),
        boundTolerance("pick_tolerance", &S::pickTolerance),
        bound("pick_distance", &S::pickDistance),
        chosen("field_cost", &S::fieldCost, fieldCosts()),
        bound("field_weight", &S::fieldWeight),
        bound("avoid_margin", &S::avoidMargin),
    };
}

/// What is minimised, and from where.
Bindings<SolverOptions> modelBindings() {
    using S = SolverOptions;
    return {
        chosen(
            "fairness",
            &S::fairness,
            Names<Fairness>{
                {"curvature", Fairness::Curvature}, {"parametric", Fairness::Parametric}
            }
        ),
        chosen(
            "bending",
            &S::bending,
            Names<Bending>{{"geodesic", Bending::Geodesic}, {"ambient", Bending::Ambient}}
        ),
        bound("normal_bending_weight", &S::normalBendingWeight),
        bound("distance_tolerance", &S::distanceTolerance),
        chosen(
            "initial_curve",
            &S::initialCurve,
            Names<InitialCurve>{
                {"geodesic-fit", InitialCurve::GeodesicFit},
                {"control-polygon", InitialCurve::ControlPolygon}
            }
        ),
        chosen("field_guides_path", &S::fieldGuidesPath, Names<bool>{{"off", false}, {"on", true}}),
        chosen(
            "quadrature",
            &S::quadrature,
            Names<Quadrature>{
                {"foot-points", Quadrature::FootPoints},
                {"cells", Quadrature::Cells},
                {"samples", Quadrature::Samples}
            }
        ),
    };
}

/// How it is minimised.
Bindings<SolverOptions> methodBindings() {
    using S = SolverOptions;
    return {
        chosen(
            "barrier_width",
            &S::barrierWidth,
            Names<BarrierWidth>{{"full", BarrierWidth::Full}, {"tight", BarrierWidth::Tight}}
        ),
        chosen(
            "distance_weight",
            &S::distanceWeight,
            Names<DistanceWeight>{
                {"schedule", DistanceWeight::Schedule}, {"adaptive", DistanceWeight::Adaptive}
            }
        ),
        chosen(
            "interpolation",
            &S::interpolation,
            Names<Interpolation>{
                {"constraint", Interpolation::Constraint}, {"penalty", Interpolation::Penalty}
            }
        ),
        chosen(
            "knot_rule",
            &S::knotRule,
            Names<KnotRule>{
                {"energy-and-distance", KnotRule::EnergyAndDistance},
                {"feature-function", KnotRule::FeatureFunction}
            }
        ),
        bound("max_rounds", &S::maxRounds),
        bound("max_iterations", &S::maxIterations),
        bound("minimum_span", &S::minimumSpan),
    };
}

/// What only the paper's settings use.
Bindings<SolverOptions> paperBindings() {
    using P = PaperOptions;
    return {
        chosen(
            "relative_height",
            &SolverOptions::relativeHeight,
            Names<RelativeHeight>{
                {"smooth", RelativeHeight::Smooth}, {"linear", RelativeHeight::Linear}
            }
        ),
        boundInPaper("curve_segments", &P::curveSegments),
        boundInPaper("gauss_points", &P::gaussPoints),
        boundInPaper("barrier_margin", &P::barrierMargin),
        boundInPaper("height_scale", &P::heightScale),
        boundInPaper("alpha_min", &P::alphaMin),
        boundInPaper("alpha_max", &P::alphaMax),
        boundInPaper("beta_first", &P::betaFirst),
        boundInPaper("beta_min", &P::betaMin),
        boundInPaper("beta_max", &P::betaMax),
        boundInPaper("knot_ratio", &P::knotRatio),
        boundInPaper("feature_tolerance", &P::featureTolerance),
    };
}

}  // namespace

Bindings<SolverOptions> solverBindings() {
    Bindings<SolverOptions> all = shapeBindings();
    for (const Bindings<SolverOptions>& more :
         {modelBindings(), methodBindings(), paperBindings()}) {
        all.insert(all.end(), more.begin(), more.end());
    }
    return all;
}

PickTolerances pickTolerancesOf(const std::string& text) {
    PickTolerances tolerances = parsePickTolerances(text, "pick_tolerance");
    if (tolerances.entries.size() == 1 && tolerances.entries.front().weight == 0.0) {
        tolerances.entries.clear();
    }
    return tolerances;
}

Bindings<SamplingOptions> samplingBindings() {
    return {
        bound("samples", &SamplingOptions::samples),
        bound("max_segment_length", &SamplingOptions::maxSegmentLength),
    };
}

Bindings<ShellOptions> shellBindings() {
    using S = ShellOptions;
    return {
        chosen(
            "shell",
            &S::kind,
            Names<ShellKind>{
                {name(ShellKind::Simplified), ShellKind::Simplified},
                {name(ShellKind::FullResolution), ShellKind::FullResolution},
                {name(ShellKind::Local), ShellKind::Local}
            }
        ),
        bound("target_thickness", &S::targetThickness),
        bound("target_edge_length", &S::targetEdgeLength),
        bound("shell_thickness", &S::thickness),
        bound("shell_smoothing_passes", &S::smoothingPasses),
    };
}

Bindings<FieldOptions> fieldBindings(const std::string& kind, const std::string& prefix) {
    using F = FieldOptions;
    return {
        chosen(kind, &F::kind, fieldKinds()),
        bound(prefix + "curvature_scale", &F::curvatureScale),
        bound(prefix + "crease_angle", &F::creaseAngle),
        bound(prefix + "reach", &F::reach),
        bound(prefix + "obstacle_value", &F::obstacleValue),
        bound(prefix + "obstacle_slope", &F::obstacleSlope),
        bound(prefix + "smoothing", &F::smoothing),
        bound(prefix + "normalised", &F::normalised),
        bound(prefix + "inverted", &F::inverted),
    };
}

Bindings<FaceChoice> regionBindings(const std::string& prefix) {
    using By = FaceChoice::By;
    return {chosen(
        prefix + "region",
        &FaceChoice::by,
        Names<By>{
            {"selected-faces", By::SelectedFaces}, {"selected-vertices", By::SelectedVertices}
        }
    )};
}

Bindings<FaceChoice> avoidBindings() {
    using By = FaceChoice::By;
    return {
        chosen(
            "avoid",
            &FaceChoice::by,
            Names<By>{
                {"none", By::Nothing},
                {"selected-faces", By::SelectedFaces},
                {"selected-vertices", By::SelectedVertices},
                {"under-threshold", By::UnderThreshold},
                {"over-threshold", By::OverThreshold}
            }
        ),
        bound("avoid_threshold", &FaceChoice::threshold),
    };
}

Bindings<CurveRequest> curveBindings() {
    using C = CurveRequest;
    return {
        bound("surface_layer", &C::surface),
        bound("picks_layer", &C::picksLayer),
        bound("picks_file", &C::picksFile),
        bound("picks", &C::picksText),
        boundPicks<CurveRequest>("corners", &C::corners),
        boundDirections<CurveRequest>("tangents", &C::tangents),
        bound("tube_radius", &C::tubeRadius),
        bound("save", &C::saveFile),
        bound("control_polygon", &C::controlPolygon),
        bound("shell_layers", &C::shellLayers),
        bound("replace", &C::replace),
    };
}

}  // namespace bspline_curve

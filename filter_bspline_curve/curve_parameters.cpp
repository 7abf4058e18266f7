// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_bspline_curve/curve_parameters.h"

#include "filter_bspline_curve/parameter_values.h"

#include <QStringList>
#include <string>

namespace bspline_curve {

namespace {

// ---- layers ----

const MeshModel* onlyLayerWithFaces(const MeshDocument& document) {
    const MeshModel* found = nullptr;
    for (const MeshModel& layer : document.meshIterator()) {
        if (layer.cm.FN() > 0) {
            if (found != nullptr) {
                return nullptr;
            }
            found = &layer;
        }
    }
    return found;
}

/// The layer that a curve of this filter was drawn on; null where the layer is no such curve or its
/// surface is gone.
const MeshModel* surfaceOfCurve(const MeshDocument& document, const MeshModel& layer) {
    using Allocator = vcg::tri::Allocator<CMeshO>;
    const auto handle = Allocator::FindPerMeshAttribute<int>(layer.cm, kSurfaceLayerAttribute);
    return Allocator::IsValidHandle(layer.cm, handle)
               ? document.getMesh(static_cast<unsigned int>(handle()))
               : nullptr;
}

/// Null only in an empty document.
const MeshModel* defaultSurface(const MeshDocument& document) {
    const MeshModel* current = document.mm();
    if (current == nullptr || current->cm.FN() > 0) {
        return current;
    }
    if (const MeshModel* surface = surfaceOfCurve(document, *current)) {
        return surface;
    }
    const MeshModel* only = onlyLayerWithFaces(document);
    return only == nullptr ? current : only;
}

unsigned int defaultSurfaceLayer(const MeshDocument& document) {
    const MeshModel* surface = defaultSurface(document);
    return surface == nullptr ? 0 : static_cast<unsigned int>(surface->id());
}

double diagonalOf(const MeshDocument& document) {
    const MeshModel* surface = defaultSurface(document);
    return surface == nullptr || surface->cm.VN() == 0 ? 1.0 : surface->cm.trBB().Diag();
}

// ---- enumerations: the choices that the user sees, in the order of the core's enumerators ----

// After these come the kinds of fields, and the costs in the order of the core's enumerators.
const QString kNoField = "none";
const QStringList kFieldCosts = {
    "natural", name(FieldCost::Identity), name(FieldCost::Square), name(FieldCost::ExpMinus)
};
// In the order of the enumerators.
const QStringList kAvoided = {
    "none", "selected-faces", "selected-vertices", "under-threshold", "over-threshold"
};
const QStringList kPresets = {"default", "paper"};
const QStringList kShells = {name(ShellKind::Simplified), name(ShellKind::FullResolution)};
// In these the first choice leaves the decision to the preset.
const QStringList kBendings = {"preset", "geodesic", "ambient"};
const QStringList kInitialCurves = {"preset", "geodesic-fit", "control-polygon"};
const QStringList kSwitch = {"preset", "off", "on"};
const QStringList kQuadratures = {"preset", "foot-points", "cells", "samples"};
const QStringList kBarrierWidths = {"preset", "full", "tight"};
const QStringList kDistanceWeights = {"preset", "schedule", "adaptive"};
const QStringList kInterpolations = {"preset", "constraint", "penalty"};
const QStringList kKnotRules = {"preset", "energy-and-distance", "feature-function"};

template <typename Enum>
void overridePreset(
    Enum& option,
    const RichParameterList& parameters,
    const QString& name,
    const QStringList& choices
) {
    const int choice = choiceOf(parameters, name, choices);
    if (choice > 0) {
        option = static_cast<Enum>(choice - 1);
    }
}

/// A number left at its default leaves the decision to the preset.
template <typename Number>
void overridePreset(Number& option, Number value, Number standard) {
    if (value != standard) {
        option = value;
    }
}

// ---- the parameters, group by group ----

constexpr bool kAdvanced = true;
const QString kFieldPrefix = "field_";

void addPickParameters(RichParameterList& list, const MeshDocument& document) {
    const unsigned int surface = defaultSurfaceLayer(document);
    list.addParam(RichMesh(
        "surface_layer",
        surface,
        &document,
        "Surface",
        "The layer with the triangle mesh that the curve is drawn on. Default: the current "
        "layer; where that has no faces, the layer that it was drawn on if it is a curve of this "
        "filter, else the only layer with faces."
    ));
    list.addParam(RichMesh(
        "picks_layer",
        surface,
        &document,
        "Picks: layer",
        "A layer of points without faces; the curve passes through its vertices in their order. "
        "The surface itself (default): no layer of picks."
    ));
    list.addParam(RichFileOpen(
        "picks_file",
        "",
        {"*.pp", "*.json", "*.csv", "*.xyz"},
        "Picks: file",
        "A file of picks in world coordinates: .pp as PickPoints saves it, .json {\"picks\": "
        "[[x, y, z], ...]}, .csv or .xyz with one point a line. Empty: no file."
    ));
    list.addParam(RichString(
        "picks",
        "",
        "Picks: coordinates",
        "Picks as text \"x y z; x y z; ...\" in world coordinates. Empty: no text. Where neither "
        "text nor file nor layer is given, the points of Edit > PickPoints on the surface are "
        "used. Picks farther from the surface than 1 % of its diagonal are refused."
    ));
    list.addParam(RichBool(
        "closed",
        false,
        "Closed",
        "On: a closed curve through at least 3 picks. Off: an open curve from the first to the "
        "last of at least 2 picks, unless the file of picks says that it is closed."
    ));
}

void addShapeParameters(RichParameterList& list, const MeshDocument& document) {
    const SolverOptions options;
    const SamplingOptions sampling;
    list.addParam(
        RichInt("degree", options.degree, "Degree", "Polynomial degree of the spline: 2, 3 or 4.")
    );
    list.addParam(RichDynamicFloat(
        "tension",
        options.tension,
        0.0,
        1.0,
        "Tension",
        "From 0 (as smooth as possible) to 1 (as straight as possible: geodesics between the "
        "picks). No unit."
    ));
    list.addParam(RichEnum(
        "field",
        0,
        QStringList(kNoField) + fieldKindNames(),
        "Field",
        "A scalar that draws the curve to where its cost is low. none: no field. " +
            fieldKindsHelp()
    ));
    list.addParam(RichEnum(
        "field_cost",
        0,
        kFieldCosts,
        "Cost of the field",
        "What a value x of the field costs. natural: what the kind of field is meant for; "
        "identity: x; square: x^2; exp-minus: exp(-x), which draws the curve to large values."
    ));
    list.addParam(RichFloat(
        "field_weight",
        options.fieldWeight,
        "Weight of the field",
        "How much the field counts against smoothness, 0 or more: 0 has no effect. In units of 1 "
        "/ cost."
    ));
    list.addParam(RichInt(
        "samples",
        sampling.samples,
        "Samples",
        "At least this many vertices at even steps of the spline's parameter, besides those "
        "where the curve crosses mesh edges and the picks. 0 or more; 0: none."
    ));
    list.addParam(RichPercentage(
        "max_segment_length",
        sampling.maxSegmentLength,
        0.0,
        diagonalOf(document),
        "Largest segment",
        "No segment of the polyline is longer than this, in world units. 0: not limited."
    ));
}

void addAvoidParameters(RichParameterList& list) {
    list.addParam(RichEnum(
        "avoid",
        0,
        kAvoided,
        "Faces to avoid",
        "Faces of the surface that the curve does not enter. none: it may enter all; "
        "selected-faces; selected-vertices: the faces all of whose vertices are selected; "
        "under-threshold, over-threshold: the faces over which the mean of the field, or without a "
        "field of the per-vertex quality, is under or over the threshold."
    ));
    list.addParam(RichFloat(
        "avoid_threshold",
        0.0,
        "Threshold of faces to avoid",
        "The threshold of under-threshold and over-threshold, in the unit of the field."
    ));
    list.addParam(RichFloat(
        "avoid_margin",
        SolverOptions().avoidMargin,
        "Margin of faces to avoid",
        "From this far away on they push the curve, relative to the diagonal of the surface's box, "
        "above 0 and at most 1.",
        kAdvanced
    ));
}

void addShellKindParameter(RichParameterList& list) {
    list.addParam(RichEnum(
        "shell",
        static_cast<int>(ShellOptions().kind),
        kShells,
        "Shell",
        "The shell around the surface, in which the curve is sought. simplified: few thick prisms, "
        "which take seconds to build on large meshes and are kept for the next curve; full: one "
        "thin prism per face."
    ));
}

void addPresetParameters(RichParameterList& list) {
    const SolverOptions options;
    list.addParam(RichEnum(
        "preset",
        0,
        kPresets,
        "Preset",
        "default: the settings that measured best; paper: those of the paper (2023), for "
        "comparison. Every setting below that is left at its default follows the preset.",
        kAdvanced
    ));
    list.addParam(RichEnum(
        "bending",
        0,
        kBendings,
        "Bending",
        "What smoothness means. geodesic: only bending within the surface is penalised; ambient: "
        "all bending, as in the paper.",
        kAdvanced
    ));
    list.addParam(RichFloat(
        "normal_bending_weight",
        options.normalBendingWeight,
        "Weight of normal bending",
        "Share of the bending along the normal that counts with geodesic bending, above 0 and at "
        "most 1.",
        kAdvanced
    ));
    list.addParam(RichFloat(
        "distance_tolerance",
        options.distanceTolerance,
        "Distance tolerance",
        "Largest distance of the spline to the surface, in mean edge lengths, above 0. The "
        "polyline lies on the surface in any case.",
        kAdvanced
    ));
}

void addShellParameters(RichParameterList& list) {
    const ShellOptions shell;
    list.addParam(RichFloat(
        "target_thickness",
        shell.targetThickness,
        "Target thickness",
        "Simplified shell: longest pillar, bottom to top, relative to the longest side of the "
        "surface's box, above 0 and at most 1.",
        kAdvanced
    ));
    list.addParam(RichFloat(
        "target_edge_length",
        shell.targetEdgeLength,
        "Target edge length",
        "Simplified shell: shorter edges are collapsed where its invariants allow it, relative to "
        "the longest side of the surface's box, above 0 and at most 1.",
        kAdvanced
    ));
    list.addParam(RichFloat(
        "shell_thickness",
        shell.thickness,
        "Shell thickness",
        "Full shell: largest distance of its top and bottom from the surface, in mean edge "
        "lengths, above 0.",
        kAdvanced
    ));
    list.addParam(RichInt(
        "shell_smoothing_passes",
        shell.smoothingPasses,
        "Shell smoothing",
        "Rounds of averaging of the shell's directions, 0 or more.",
        kAdvanced
    ));
}

void addMethodParameters(RichParameterList& list) {
    list.addParam(RichEnum(
        "initial_curve",
        0,
        kInitialCurves,
        "Initial curve",
        "geodesic-fit: a fit to the path through the picks; control-polygon: Alg. 2 of the paper.",
        kAdvanced
    ));
    list.addParam(RichEnum(
        "field_guides_path",
        0,
        kSwitch,
        "Field guides the path",
        "on: the path through the picks, which the curve starts from, goes where the field costs "
        "little; off: it is the shortest one, as in the paper.",
        kAdvanced
    ));
    list.addParam(RichEnum(
        "quadrature",
        0,
        kQuadratures,
        "Quadrature",
        "Where energies are sampled. cells: exactly, cell by cell of the shell; samples: at even "
        "steps, as in the paper.",
        kAdvanced
    ));
    list.addParam(RichEnum(
        "barrier_width",
        0,
        kBarrierWidths,
        "Barrier width",
        "full: the whole shell; tight: narrowed around the current curve, (12) of the paper.",
        kAdvanced
    ));
    list.addParam(RichEnum(
        "distance_weight",
        0,
        kDistanceWeights,
        "Weight of distance",
        "schedule: grows from round to round; adaptive: (18) of the paper.",
        kAdvanced
    ));
    list.addParam(RichEnum(
        "interpolation",
        0,
        kInterpolations,
        "Interpolation",
        "How the spline is held at the picks. constraint: exactly; penalty: by (9) of the paper.",
        kAdvanced
    ));
    list.addParam(RichEnum(
        "knot_rule",
        0,
        kKnotRules,
        "Knot rule",
        "Where knots are inserted. energy-and-distance: where they help; feature-function: "
        "(19)-(23) of the paper.",
        kAdvanced
    ));
}

void addLimitParameters(RichParameterList& list) {
    const SolverOptions options;
    list.addParam(RichInt(
        "samples_per_span",
        options.samplesPerSpan,
        "Samples per span",
        "Samples per knot span where quadrature is samples, 4 or more.",
        kAdvanced
    ));
    list.addParam(RichInt(
        "max_rounds",
        options.maxRounds,
        "Rounds",
        "Most rounds of minimisation and knot insertion, 1 or more.",
        kAdvanced
    ));
    list.addParam(RichInt(
        "max_iterations",
        options.maxIterations,
        "Iterations",
        "Most Newton iterations a round, 1 or more.",
        kAdvanced
    ));
    list.addParam(RichFloat(
        "minimum_span",
        options.minimumSpan,
        "Shortest span",
        "No knot span is made shorter than this, as a share of the whole, above 0 and at most 0.1.",
        kAdvanced
    ));
}

// ---- reading ----

std::optional<FieldRequest> readField(const RichParameterList& parameters) {
    const int choice = choiceOf(parameters, "field", QStringList(kNoField) + fieldKindNames());
    if (choice == 0) {
        return std::nullopt;
    }
    return readFieldRequest(parameters, kFieldPrefix, choice - 1);
}

SolverOptions readSolverOptions(
    const RichParameterList& parameters, const std::optional<FieldRequest>& field
) {
    const SolverOptions standard;
    SolverOptions options =
        choiceOf(parameters, "preset", kPresets) == 1 ? paperPreset() : standard;
    options.degree = parameters.getInt("degree");
    options.closed = parameters.getBool("closed");
    options.tension = typedNumber(parameters.getDynamicFloat("tension"));
    options.fieldWeight = typedNumber(parameters.getFloat("field_weight"));
    if (const int cost = choiceOf(parameters, "field_cost", kFieldCosts); cost > 0) {
        options.fieldCost = static_cast<FieldCost>(cost - 1);
    } else if (field) {
        options.fieldCost = naturalCost(field->options.kind);
    }

    overridePreset(options.bending, parameters, "bending", kBendings);
    overridePreset(options.initialCurve, parameters, "initial_curve", kInitialCurves);
    overridePreset(options.fieldGuidesPath, parameters, "field_guides_path", kSwitch);
    overridePreset(options.quadrature, parameters, "quadrature", kQuadratures);
    overridePreset(options.barrierWidth, parameters, "barrier_width", kBarrierWidths);
    overridePreset(options.distanceWeight, parameters, "distance_weight", kDistanceWeights);
    overridePreset(options.interpolation, parameters, "interpolation", kInterpolations);
    overridePreset(options.knotRule, parameters, "knot_rule", kKnotRules);

    const auto number = [&](double& option, const char* name, double byDefault) {
        overridePreset(option, typedNumber(parameters.getFloat(name)), byDefault);
    };
    const auto count = [&](int& option, const char* name, int byDefault) {
        overridePreset(option, parameters.getInt(name), byDefault);
    };
    number(options.avoidMargin, "avoid_margin", standard.avoidMargin);
    number(options.normalBendingWeight, "normal_bending_weight", standard.normalBendingWeight);
    number(options.distanceTolerance, "distance_tolerance", standard.distanceTolerance);
    number(options.minimumSpan, "minimum_span", standard.minimumSpan);
    count(options.samplesPerSpan, "samples_per_span", standard.samplesPerSpan);
    count(options.maxRounds, "max_rounds", standard.maxRounds);
    count(options.maxIterations, "max_iterations", standard.maxIterations);
    return options;
}

}  // namespace

RichParameterList curveParameters(const MeshDocument& document) {
    RichParameterList list;
    addPickParameters(list, document);
    addShapeParameters(list, document);
    addAvoidParameters(list);
    addShellKindParameter(list);
    addFieldOptions(list, kFieldPrefix, kAdvanced);
    addPresetParameters(list);
    addShellParameters(list);
    addMethodParameters(list);
    addLimitParameters(list);
    return list;
}

CurveRequest readRequest(const RichParameterList& parameters) {
    CurveRequest request;
    request.surfaceLayer = parameters.getMeshId("surface_layer");
    request.picksLayer = parameters.getMeshId("picks_layer");
    request.picksFile = parameters.getOpenFileName("picks_file").trimmed();
    request.picksText = parameters.getString("picks").trimmed();
    request.field = readField(parameters);
    request.avoid = static_cast<Avoid>(choiceOf(parameters, "avoid", kAvoided));
    request.avoidThreshold = typedNumber(parameters.getFloat("avoid_threshold"));
    request.solver = readSolverOptions(parameters, request.field);
    request.shell.kind = static_cast<ShellKind>(choiceOf(parameters, "shell", kShells));
    request.shell.targetThickness = typedNumber(parameters.getFloat("target_thickness"));
    request.shell.targetEdgeLength = typedNumber(parameters.getFloat("target_edge_length"));
    request.shell.thickness = typedNumber(parameters.getFloat("shell_thickness"));
    request.shell.smoothingPasses = parameters.getInt("shell_smoothing_passes");
    request.sampling.samples = parameters.getInt("samples");
    request.sampling.maxSegmentLength = typedNumber(parameters.getAbsPerc("max_segment_length"));
    return request;
}

}  // namespace bspline_curve

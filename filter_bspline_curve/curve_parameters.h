// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "design/curve.h"
#include "filter_bspline_curve/field_parameters.h"
#include "shell/shell_options.h"
#include "solver/options.h"

#include <common/ml_document/mesh_document.h>
#include <common/parameters/rich_parameter_list.h>

#include <QString>
#include <optional>

namespace bspline_curve {

/// What a curve does not enter: a selection of the layer, or the faces over which the mean of the
/// field (without one, of the quality) is under or over a threshold.
enum class Avoid { Nothing, SelectedFaces, SelectedVertices, UnderThreshold, OverThreshold };

/// What the user asked for, as the host hands it over.
struct CurveRequest {
    unsigned int surfaceLayer = 0;
    unsigned int picksLayer = 0;  ///< the same as surfaceLayer: no layer of picks
    QString picksFile;            ///< empty: none
    QString picksText;            ///< empty: none
    std::optional<FieldRequest> field;
    Avoid avoid = Avoid::Nothing;
    double avoidThreshold = 0.0;
    SolverOptions solver;
    ShellOptions shell;
    SamplingOptions sampling;
};

/// The filter's parameters with their defaults, ranges and help, for a document that may be empty.
[[nodiscard]] RichParameterList curveParameters(const MeshDocument& document);

/// Throws MLException where an enumeration has no such choice. Ranges are checked where the options
/// are used.
[[nodiscard]] CurveRequest readRequest(const RichParameterList& parameters);

/// Name of the per-mesh attribute of a curve's layer that holds the id of the surface's layer.
inline constexpr const char* kSurfaceLayerAttribute = "bspline_curve_surface_layer";

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "design/curve.h"
#include "field/field_options.h"
#include "filters/parameter_values.h"
#include "shell/shell_options.h"
#include "solver/options.h"

#include <filesystem>
#include <optional>
#include <string>

// What users ask for, as the libraries take it.
namespace bspline_curve {

/// Which selection of a layer is a region.
enum class RegionSource { SelectedFaces, SelectedVertices };

/// A field that the user asked for.
struct FieldRequest {
    FieldOptions options;
    RegionSource region = RegionSource::SelectedFaces;
};

/// What a curve does not enter: a selection of the layer, or the faces over which the mean of the
/// field (without one, of the quality) is under or over a threshold.
enum class Avoid { Nothing, SelectedFaces, SelectedVertices, UnderThreshold, OverThreshold };

/// Where the picks of a curve come from; at most one of these may be given, and without any of them
/// the points of the host's own tool are taken.
struct PicksRequest {
    std::string text;            ///< empty: none
    std::filesystem::path file;  ///< empty: none
    LayerId layer;               ///< the surface itself, or no id: none
};

/// What a curve leaves besides its layer.
struct ExtrasRequest {
    double tubeRadius = 0.0;  ///< world units; 0: no tube
    bool controlPolygon = false;
    bool shellLayers = false;    ///< top and bottom of the shell
    std::filesystem::path save;  ///< the curve as a file, see writeCurve(); empty: none
};

struct CurveRequest {
    LayerId surface;
    PicksRequest picks;
    SolverOptions solver;
    SamplingOptions sampling;
    ShellOptions shell;
    std::optional<FieldRequest> field;
    Avoid avoid = Avoid::Nothing;
    double avoidThreshold = 0.0;
    ExtrasRequest extras;
};

/// What a user of curveFilter() asked for. Throws InputError (BadOption) naming the value and its
/// range where a number is outside.
[[nodiscard]] CurveRequest curveRequest(const ParameterValues& values);

/// What a user of fieldFilter() asked for. Throws likewise.
[[nodiscard]] FieldRequest fieldRequest(const ParameterValues& values);

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "bspline_curve/field.h"
#include "bspline_curve/options.h"
#include "bspline_curve/shell.h"
#include "filters/parameter_values.h"
#include "surface/mending.h"

#include <optional>
#include <string>

// What users ask for, as the libraries take it.
namespace bspline_curve {

/// Which selection of a layer is a region.
enum class RegionSource { SelectedFaces, SelectedVertices };

/// The choices of `field` for none, and for the quality if the mesh has one (see canBeFollowed()).
inline constexpr const char* kNoField = "none";
inline constexpr const char* kAutomaticField = "auto";

/// A field that the user asked for.
struct FieldRequest {
    FieldOptions options;
    RegionSource region = RegionSource::SelectedFaces;
    MendingOptions mending{};  ///< of fieldFilter()
    bool automatic = false;    ///< only where canBeFollowed() holds for the quality
};

/// What a curve does not enter: a selection of the layer, or the faces over which the mean of the
/// field (without one, of the quality) is under or over a threshold.
enum class Avoid { Nothing, SelectedFaces, SelectedVertices, UnderThreshold, OverThreshold };

struct CurveRequest {
    LayerId surface;
    // Where the picks come from: at most one of these is given, and where none is, the points of
    // the host's own tool are taken.
    LayerId picksLayer;     ///< the surface itself, or no id: none
    std::string picksFile;  ///< UTF-8; empty: none
    std::string picksText;  ///< empty: none
    std::optional<FieldRequest> field;
    Avoid avoid = Avoid::Nothing;
    double avoidThreshold = 0.0;
    SolverOptions solver;
    SamplingOptions sampling;
    ShellOptions shell;
    MendingOptions mending;
    // What the curve leaves besides its layer.
    double tubeRadius = 0.0;      ///< world units; 0: no tube
    std::string saveFile;         ///< UTF-8, the format by its extension; empty: none
    bool controlPolygon = false;  ///< as a layer
    bool shellLayers = false;     ///< top and bottom of the shell
    bool replace = false;         ///< in place of the curve whose picks were moved
};

/// Throws InputError (BadOption) where a length is negative or not finite; `what` names it.
void checkLength(const std::string& what, double length);

/// Whether faces to avoid are those under or over a threshold.
[[nodiscard]] bool hasThreshold(Avoid avoid);

/// `strict` and `weld` of any filter. Throws InputError (BadOption) where `weld` is outside of its
/// range, or where both are given.
[[nodiscard]] MendingOptions mendingOptions(const ParameterValues& values);

/// What a user of curveFilter() asked for. Throws InputError (BadOption) naming the value and its
/// range where a number is outside.
[[nodiscard]] CurveRequest curveRequest(const ParameterValues& values);

/// What a user of fieldFilter() asked for. Throws likewise.
[[nodiscard]] FieldRequest fieldRequest(const ParameterValues& values);

}  // namespace bspline_curve

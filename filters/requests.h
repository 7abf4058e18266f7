// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve_options.h"
#include "filters/parameter_values.h"

#include <string>

// What users ask for, as the libraries take it.
namespace bspline_curve {

/// The choices of `field` for none, and for the quality if the mesh has one (see canBeFollowed()).
inline constexpr const char* kNoField = "none";
inline constexpr const char* kAutomaticField = "auto";

/// A field for a layer.
struct FieldLayerRequest : FieldRequest {
    MendingOptions mending{};
};

struct CurveRequest : CurveOptions, PreparingOptions {
    LayerId surface;
    // Where the picks come from: at most one of these is given, and where none is, the points of
    // the host's own tool are taken.
    LayerId picksLayer;     ///< the surface itself, or no id: none
    std::string picksFile;  ///< UTF-8; empty: none
    std::string picksText;  ///< empty: none
    // What the curve leaves besides its layer.
    double tubeRadius = 0.0;      ///< world units; 0: no tube
    std::string saveFile;         ///< UTF-8, the format by its extension; empty: none
    bool controlPolygon = false;  ///< as a layer
    bool shellLayers = false;     ///< top and bottom of the shell
    bool replace = false;         ///< in place of the curve whose picks were moved
};

/// Throws InputError (BadOption) where a length is negative or not finite; `what` names it.
void checkLength(const std::string& what, double length);

/// `strict`, `weld` and `slits` of any filter. Throws InputError (BadOption) where `weld` is
/// outside of its range, or where both are given.
[[nodiscard]] MendingOptions mendingOptions(const ParameterValues& values);

/// What a user of curveFilter() asked for. Throws InputError (BadOption) naming the value and its
/// range where a number is outside.
[[nodiscard]] CurveRequest curveRequest(const ParameterValues& values);

/// What a user of fieldFilter() asked for. Throws likewise.
[[nodiscard]] FieldLayerRequest fieldRequest(const ParameterValues& values);

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "surface/mesh_checksum.h"
#include "surface/surface.h"
#include "workpiece/layer_input.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

// Layers of polylines, as curves on a surface.
namespace bspline_curve {

/// A layer with edges and without faces, without the elements that the host has deleted.
struct PolylineLayer {
    std::string label;         ///< for messages
    std::vector<Vec3> points;  ///< in world coordinates
    std::vector<std::array<int, 2>> edges;
    /// For each point its place on the surface's layer, where the layer knows it; else empty.
    std::vector<SurfacePoint> places;
    /// The mesh that the places are of.
    std::optional<MeshChecksum> drawnOn;
    bool isOptional = false;  ///< nobody chose it: it is left out where it is not near the surface
};

/// A surface and the layers of curves that a filter is to use on it.
struct CurvesOnLayer {
    LayerInput surface;
    MeshChecksum checksum;  ///< of the surface's layer, in its own coordinates
    std::vector<PolylineLayer> curves;
};

/// How curves come onto the surface.
struct Placing {
    double distance = 0.0;  ///< polylines farther away are refused; 0: kPickReachRelative
    bool project = false;   ///< also curves that know their places
};

/// A curve and the layer that it is of.
struct PlacedCurve {
    SurfacePolyline line;
    std::string label;
};

struct PlacedCurves {
    std::vector<PlacedCurve> curves;
    int projected = 0;                 ///< how many of them were
    std::vector<std::string> leftOut;  ///< labels of optional layers that are not near
};

/// The curves of all layers on the surface's input: the chains of edges of each, in order, cut
/// where more than two edges meet. By their places where they know them and lie there still,
/// exactly; else projected, see projectedPolyline(). Throws InputError (NoPath: no layer has a
/// curve, the mesh changed since a curve was drawn, or a curve is in no faces of it; PickTooFar,
/// NoPath: a layer is not near the surface), naming the layer. A curve may pass from sheet to sheet
/// where mending parts them.
[[nodiscard]] PlacedCurves placedCurves(
    const Surface& surface, const CurvesOnLayer& input, const Placing& placing
);

/// What to say of layers that were left out.
[[nodiscard]] std::vector<std::string> leftOutWarnings(
    const PlacedCurves& placed, const LayerInput& surface
);

}  // namespace bspline_curve

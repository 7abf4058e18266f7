// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "bspline_curve/lines.h"
#include "bspline_curve/mesh_checksum.h"
#include "filters/pick_candidates.h"
#include "surface/surface.h"

#include <array>
#include <cstddef>
#include <memory>
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
    /// What this plugin drew, with faces of the surface's layer and in world coordinates then;
    /// null: it is not known.
    std::shared_ptr<const Curve> drawn{};
    bool isOptional = false;  ///< nobody chose it: it is left out where it is not near the surface
    int id = -1;              ///< the host's own; -1: none
};

/// A surface and the layers of curves that a filter is to use on it.
struct CurvesOnLayer {
    LayerInput surface;
    MeshChecksum checksum;  ///< of the surface's layer, in its own coordinates
    std::vector<PolylineLayer> curves;
};

/// How curves come onto the surface.
struct Placing {
    double distance = 0.0;    ///< polylines farther away are refused; 0: see ProjectionOptions
    std::string direction{};  ///< "x y z"; empty: to the nearest points
    bool project = false;     ///< also curves that know their places

    /// Throws InputError (BadOption).
    [[nodiscard]] ProjectionOptions projection() const;
};

/// "x y z" or "x,y,z". Throws InputError (BadOption) where it is something else; `name`: of the
/// option.
[[nodiscard]] Vec3 parseDirection(std::string text, const std::string& name);

/// A curve and the layer that it is of.
struct PlacedCurve {
    SurfacePolyline line;  ///< with its picks, where its layer knows them
    std::string label;
    std::size_t layer = 0;  ///< of CurvesOnLayer
    /// PolylineLayer::drawn where the layer still is that; null: it is not, or none was known.
    std::shared_ptr<const Curve> drawn{};
    /// Of `drawn` where the line has its parameters; else null.
    const SplineData* spline = nullptr;
};

struct PlacedCurves {
    std::vector<PlacedCurve> curves;
    int projected = 0;                 ///< how many of them were
    std::vector<std::string> leftOut;  ///< labels of optional layers that are not near
    std::vector<std::string> notes;    ///< of layers that jump, or are beside the surface
};

/// The curves of all layers on the surface's input: the chains of edges of each, in order, cut
/// where more than two edges meet. By their places where they know them and lie there still,
/// exactly; else projected, see projectedLines(). Throws InputError (NoPath: no layer has a
/// curve, the mesh changed since a curve was drawn, or a curve is in no faces of it; PickTooFar,
/// NoPath: a layer is not near the surface), naming the layer. A curve may pass from sheet to sheet
/// where mending parts them.
[[nodiscard]] PlacedCurves placedCurves(
    const Surface& surface, const CurvesOnLayer& input, const Placing& placing
);

/// What to say of layers that were left out, or jump, in sentences.
[[nodiscard]] std::vector<std::string> placingWarnings(
    const PlacedCurves& placed, const LayerInput& surface
);

}  // namespace bspline_curve

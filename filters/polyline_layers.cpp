// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/polyline_layers.h"

#include "bspline_curve/error.h"
#include "bspline_curve/mesh.h"
#include "imprint/polyline_chains.h"
#include "imprint/projected_polyline.h"
#include "surface/error_messages.h"
#include "surface/lines_over_parted_edges.h"
#include "surface/picks.h"
#include "surface/strict_line.h"
#include "surface/triangle_tree.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace bspline_curve {

namespace {

/// A curve lies where it was drawn if its points are there up to this, relative to the diagonal and
/// the coordinates: hosts with floats round them.
constexpr double kSamePositionRelative = 1e-6;

[[noreturn]] void refuseLayer(
    InputErrorCode code, const PolylineLayer& layer, const std::string& message
) {
    throw InputError(code, "layer \"" + layer.label + "\" " + message);
}

class CurvePlacer {
public:
    CurvePlacer(const Surface& surface, const CurvesOnLayer& input, const Placing& placing)
        : surface_(surface), input_(input), placing_(placing) {
        if (placing_.distance == 0.0) {
            placing_.distance = kPickReachRelative * surface.diagonal();
        }
    }

    PlacedCurves place() {
        for (const PolylineLayer& layer : input_.curves) {
            try {
                addLayer(layer);
            } catch (const InputError& error) {
                if (!layer.isOptional) {
                    throw;
                }
                result_.leftOut.push_back(layer.label);
                if (!first_) {
                    first_.emplace(error);
                }
            }
        }
        if (result_.curves.empty()) {
            refuseNoCurves();
        }
        return std::move(result_);
    }

private:
    [[noreturn]] void refuseNoCurves() const {
        if (first_) {
            throw InputError(*first_);
        }
        throw InputError(
            InputErrorCode::NoPath,
            "there is no visible layer of polylines: draw a curve with B-spline Curve on Surface, "
            "or choose curve_layer"
        );
    }

    void addLayer(const PolylineLayer& layer) {
        const bool isExact = knowsPlaces(layer);
        std::vector<PlacedCurve> placed;
        int projected = 0;
        for (const PolylineChain& chain :
             chainsOf(static_cast<int>(layer.points.size()), layer.edges)) {
            SurfacePolyline line = isExact ? exact(layer, chain) : SurfacePolyline();
            if (line.points.empty()) {
                line = projectedChain(layer, chain);
                ++projected;
            }
            placed.push_back({.line = std::move(line), .label = layer.label});
        }
        std::ranges::move(placed, std::back_inserter(result_.curves));
        result_.projected += projected;
    }

    [[nodiscard]] bool knowsPlaces(const PolylineLayer& layer) const {
        if (placing_.project || layer.places.empty() || !layer.drawnOn) {
            return false;
        }
        if (*layer.drawnOn != input_.checksum) {
            refuseLayer(
                InputErrorCode::NoPath,
                layer,
                "was drawn on layer \"" + input_.surface.label +
                    "\", whose mesh changed since the curve was drawn: " +
                    describeChange(*layer.drawnOn, input_.checksum) +
                    "; draw it again, or switch project_curves on"
            );
        }
        return true;
    }

    /// Without points where the layer was moved or edited.
    [[nodiscard]] SurfacePolyline exact(
        const PolylineLayer& layer, const PolylineChain& chain
    ) const {
        const TriangleMesh& mesh = surface_.input();
        SurfacePolyline line;
        line.closed = chain.closed;
        for (const int index : chain.points) {
            const SurfacePoint& place = layer.places[index];
            if (place.face < 0 || place.face >= static_cast<int>(mesh.faces.size())) {
                return {};
            }
            const Vec3 position = positionOf(mesh, place);
            const double size = surface_.diagonal() + position.norm();
            if (!((position - layer.points[index]).norm() <= kSamePositionRelative * size)) {
                return {};
            }
            line.parameters.push_back(
                static_cast<double>(line.points.size()) / static_cast<double>(chain.points.size())
            );
            line.surfacePoints.push_back(place);
            line.points.push_back(position);
        }
        if (surface_.provenance().isIdentity()) {
            return isStrict(surface_, line) ? line : SurfacePolyline();
        }
        checkLine(surface_, line, "layer \"" + layer.label + "\"");
        return line;
    }

    SurfacePolyline projectedChain(const PolylineLayer& layer, const PolylineChain& chain) {
        if (!tree_) {
            tree_.emplace(surface_.vertices(), surface_.faces());
        }
        SpacePolyline line{.points = {}, .closed = chain.closed};
        for (const int index : chain.points) {
            line.points.push_back(layer.points[index]);
        }
        try {
            return projectedPolyline(surface_, *tree_, line, placing_.distance);
        } catch (const InputError& error) {
            std::vector<std::int64_t> vertices;
            for (const std::int64_t each : error.elements()) {
                vertices.push_back(chain.points[each]);
            }
            throw InputError(
                error.code(),
                "layer \"" + layer.label + "\" is not near layer \"" + input_.surface.label +
                    "\": " + error.what() + "; choose its surface, or a larger max_distance",
                std::move(vertices)
            );
        }
    }

    const Surface& surface_;
    const CurvesOnLayer& input_;
    Placing placing_;
    std::optional<TriangleTree> tree_;
    PlacedCurves result_;
    std::optional<InputError> first_;  // of the layers left out
};

}  // namespace

PlacedCurves placedCurves(
    const Surface& surface, const CurvesOnLayer& input, const Placing& placing
) {
    return CurvePlacer(surface, input, placing).place();
}

std::vector<std::string> leftOutWarnings(const PlacedCurves& placed, const LayerInput& surface) {
    std::vector<std::string> warnings;
    for (const std::string& label : placed.leftOut) {
        warnings.push_back(
            "Layer \"" + label + "\" was left out: it is not near layer \"" + surface.label + "\"."
        );
    }
    return warnings;
}

}  // namespace bspline_curve

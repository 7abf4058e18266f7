// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/polyline_layers.h"

#include "bspline_curve/error.h"
#include "bspline_curve/files.h"
#include "bspline_curve/mesh.h"
#include "imprint/polyline_chains.h"
#include "imprint/projected_polyline.h"
#include "surface/lines_over_parted_edges.h"
#include "surface/strict_line.h"
#include "surface/triangle_tree.h"
#include "text/error_messages.h"
#include "text/sentences.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
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
        : surface_(surface),
          input_(input),
          projects_(placing.project),
          projection_(placing.projection()) {}

    PlacedCurves place() {
        for (std::size_t i = 0; i < input_.curves.size(); ++i) {
            const PolylineLayer& layer = input_.curves[i];
            try {
                addLayer(i);
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

    void addLayer(std::size_t index) {
        const PolylineLayer& layer = input_.curves[index];
        const bool isExact = knowsPlaces(layer);
        std::vector<PlacedCurve> placed;
        int projected = 0;
        std::vector<ProjectedLines> lines;
        for (const PolylineChain& chain :
             chainsOf(static_cast<int>(layer.points.size()), layer.edges)) {
            SurfacePolyline line = isExact ? exact(layer, chain) : SurfacePolyline();
            if (!line.points.empty()) {
                placed.push_back({.line = std::move(line), .label = layer.label, .layer = index});
                if (layer.drawn && isAsDrawn(layer)) {
                    addDrawn(layer.drawn, placed.back());
                }
                continue;
            }
            lines.push_back(projectedChain(layer, chain));
            ++projected;
            for (SurfacePolyline& each : lines.back().lines) {
                placed.push_back({.line = std::move(each), .label = layer.label, .layer = index});
            }
        }
        if (placed.empty() && !lines.empty()) {
            refuseLayer(
                InputErrorCode::PickTooFar,
                layer,
                "does not meet layer \"" + input_.surface.label +
                    "\" along the direction; move it, or give another direction"
            );
        }
        if (const std::string note = projectionNote(lines); !note.empty()) {
            result_.notes.push_back("layer \"" + layer.label + "\": " + note);
        }
        std::ranges::move(placed, std::back_inserter(result_.curves));
        result_.projected += projected;
    }

    // Whether a layer still is the curve that it was drawn as, up to the rounding of hosts with
    // floats. Chains may begin elsewhere, and go the other way.
    [[nodiscard]] bool isAsDrawn(const PolylineLayer& layer) const {
        const SurfacePolyline& line = layer.drawn->polyline;
        const std::size_t count = line.points.size();
        if (layer.points.size() != count || layer.edges.size() != count - (line.closed ? 0 : 1)) {
            return false;
        }
        if (!areAt(line.points, layer.points)) {
            return false;
        }
        const auto last = static_cast<int>(count) - 1;
        return std::ranges::all_of(layer.edges, [&](const std::array<int, 2>& edge) {
            const auto [low, high] = std::minmax(edge[0], edge[1]);
            return high == low + 1 || (line.closed && low == 0 && high == last);
        });
    }

    /// Whether points are at the same places, up to the rounding of hosts with floats.
    [[nodiscard]] bool areAt(
        const std::vector<Vec3>& points, const std::vector<Vec3>& others
    ) const {
        return std::ranges::equal(points, others, [&](const Vec3& point, const Vec3& other) {
            const double size = surface_.diagonal() + point.norm();
            return (point - other).norm() <= kSamePositionRelative * size;
        });
    }

    /// What was drawn; with spline and picks where the line goes from its start on.
    void addDrawn(const std::shared_ptr<const Curve>& drawn, PlacedCurve& placed) const {
        placed.drawn = drawn;
        if (areAt(drawn->polyline.points, placed.line.points)) {
            placed.line.parameters = drawn->polyline.parameters;
            placed.line.picks = drawn->polyline.picks;
            placed.spline = &drawn->spline;
        }
    }

    [[nodiscard]] bool knowsPlaces(const PolylineLayer& layer) const {
        if (projects_ || layer.places.empty() || !layer.drawnOn) {
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

    ProjectedLines projectedChain(const PolylineLayer& layer, const PolylineChain& chain) {
        if (!tree_) {
            tree_.emplace(surface_.vertices(), surface_.faces());
        }
        SpacePolyline line{.points = {}, .closed = chain.closed};
        for (const int index : chain.points) {
            line.points.push_back(layer.points[index]);
        }
        try {
            return projectedLines(surface_, *tree_, line, projection_);
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
    bool projects_;  // all curves
    ProjectionOptions projection_;
    std::optional<TriangleTree> tree_;
    PlacedCurves result_;
    std::optional<InputError> first_;  // of the layers left out
};

}  // namespace

ProjectionOptions Placing::projection() const {
    ProjectionOptions options{.distance = distance};
    if (!direction.empty()) {
        options.direction = parseDirection(direction, "direction");
    }
    options.validate();
    return options;
}

Vec3 parseDirection(std::string text, const std::string& name) {
    std::ranges::replace(text, ',', ' ');
    const std::vector<Vec3> directions = parsePicksText(text);
    if (directions.size() != 1) {
        throw InputError(InputErrorCode::BadOption, name + " must be one direction, as \"x y z\"");
    }
    return directions.front();
}

PlacedCurves placedCurves(
    const Surface& surface, const CurvesOnLayer& input, const Placing& placing
) {
    return CurvePlacer(surface, input, placing).place();
}

std::vector<std::string> placingWarnings(const PlacedCurves& placed, const LayerInput& surface) {
    std::vector<std::string> warnings;
    for (const std::string& label : placed.leftOut) {
        warnings.push_back(
            "Layer \"" + label + "\" was left out: it is not near layer \"" + surface.label + "\"."
        );
    }
    addSentences(warnings, placed.notes);
    return warnings;
}

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/pattern_requests.h"

#include "bspline_curve/files.h"
#include "filters/binding_makers.h"
#include "text/text_parsing.h"

#include <string_view>

namespace bspline_curve {

namespace {

void checkDrawing(const PatternRequest& request) {
    if (request.drawingFile.empty() == request.text.empty()) {
        refuseChoice("give a drawing or a text, and not both");
    }
}

}  // namespace

Bindings<PatternRequest> patternBindings() {
    using R = PatternRequest;
    return {
        bound("drawing", &R::drawingFile),
        bound("text", &R::text),
        bound("font", &R::fontFile),
        bound("layers", &R::layers),
        chosen(
            "place",
            &R::place,
            Names<PatternPlace>{{"point", PatternPlace::Point}, {"curve", PatternPlace::Curve}}
        ),
        bound("centre", &R::centre),
        bound("up", &R::up),
    };
}

Bindings<DrawingScale> scaleBindings() {
    return {bound("size", &DrawingScale::size), bound("scale", &DrawingScale::scale)};
}

Bindings<RowLayout> rowBindings() {
    using L = RowLayout;
    return {
        bound("repeat", &L::repeat),
        bound("spacing", &L::spacing),
        bound("start", &L::start),
        bound("shift", &L::shift),
    };
}

Bindings<PatternOptions> carryingBindings() {
    using O = PatternOptions;
    return {
        bound("corner_angle", &O::cornerAngle),
        bound("tolerance", &O::tolerance),
        bound("smoothing", &O::smoothing),
    };
}

PatternRequest patternRequest(const ParameterValues& values) {
    PatternRequest request;
    request.use = curveUse(values);
    readAll(values, patternBindings(), request);
    readAll(values, scaleBindings(), request.row.scale);
    readAll(values, rowBindings(), request.row);
    readAll(values, carryingBindings(), request.pattern);
    request.row.validate();
    request.pattern.validate();
    checkDrawing(request);
    return request;
}

std::vector<std::string> patternLayers(const PatternRequest& request) {
    std::vector<std::string> layers;
    for (const std::string_view name : splitAt(request.layers, ',')) {
        if (!name.empty()) {
            layers.emplace_back(name);
        }
    }
    return layers;
}

Vec3 patternCentre(const PatternRequest& request, const std::vector<Vec3>& toolPoints) {
    const std::vector<Vec3> points =
        request.centre.empty() ? toolPoints : parsePicksText(request.centre);
    if (points.size() != 1) {
        refuseChoice(
            "there are " + std::to_string(points.size()) +
            " points for the centre: give one by the option centre, as \"x y z\", or pick one on "
            "the surface with "
            "Edit > PickPoints"
        );
    }
    return points.front();
}

std::optional<Vec3> patternUp(const PatternRequest& request) {
    if (request.up.empty()) {
        return std::nullopt;
    }
    const std::vector<Vec3> directions = parsePicksText(request.up);
    if (directions.size() != 1) {
        refuseChoice("up is a direction \"x y z\"");
    }
    return directions.front();
}

}  // namespace bspline_curve

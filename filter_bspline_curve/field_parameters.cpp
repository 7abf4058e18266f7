// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_bspline_curve/field_parameters.h"

#include "filter_bspline_curve/parameter_values.h"

#include <algorithm>
#include <cstddef>

namespace bspline_curve {

namespace {

// In the order of the enumerators.
const QStringList kRegionSources = {"selected-faces", "selected-vertices"};

void addShares(RichParameterList& list, const QString& prefix, bool isAdvanced) {
    const FieldOptions options;
    list.addParam(RichFloat(
        prefix + "curvature_scale",
        options.curvatureScale,
        "Scale of curvature",
        "Fields of curvature, ridges and valleys: radius that curvatures are averaged over, "
        "relative to the diagonal of the surface's box, from 0 to 1. More: less noise.",
        isAdvanced
    ));
    list.addParam(RichFloat(
        prefix + "crease_angle",
        options.creaseAngle,
        "Angle of creases",
        "Field of crease distance: creases are edges whose faces turn by more than this, in "
        "degrees, from 0 to 180.",
        isAdvanced
    ));
    list.addParam(RichFloat(
        prefix + "reach",
        options.reach,
        "Reach",
        "Fields of crease and boundary distance: the distance that becomes 1, relative to the "
        "diagonal, above 0 and at most 1.",
        isAdvanced
    ));
}

void addObstacles(RichParameterList& list, const QString& prefix, bool isAdvanced) {
    const FieldOptions options;
    list.addParam(RichEnum(
        prefix + "region",
        0,
        kRegionSources,
        "Region of obstacles",
        "Field of obstacles: the selected faces, or those all of whose vertices are selected.",
        isAdvanced
    ));
    list.addParam(RichFloat(
        prefix + "obstacle_value",
        options.obstacleValue,
        "Value of obstacles",
        "Field of obstacles: its value on the boundary of the region, 0 or more.",
        isAdvanced
    ));
    list.addParam(RichFloat(
        prefix + "obstacle_slope",
        options.obstacleSlope,
        "Slope of obstacles",
        "Field of obstacles: how steeply it grows from the boundary of the region inwards, per "
        "diagonal, above 0.",
        isAdvanced
    ));
}

void addValues(RichParameterList& list, const QString& prefix, bool isAdvanced) {
    const FieldOptions options;
    list.addParam(RichFloat(
        prefix + "smoothing",
        options.smoothing,
        "Smoothing of the field",
        "Radius that the values of any field are averaged over in the end, relative to the "
        "diagonal, from 0 (not at all) to 1.",
        isAdvanced
    ));
    list.addParam(RichBool(
        prefix + "normalised",
        options.normalised,
        "Normalised field",
        "Maps the values to [0, 1], between their quantiles of 1 % and 99 %.",
        isAdvanced
    ));
    list.addParam(RichBool(
        prefix + "inverted",
        options.inverted,
        "Inverted field",
        "Lets high and low values change places.",
        isAdvanced
    ));
}

}  // namespace

QStringList fieldKindNames() {
    QStringList names;
    for (const FieldKind kind : kFieldKinds) {
        names << name(kind);
    }
    return names;
}

QString fieldKindsHelp() {
    return "normal-variation: least product of the normals of a vertex and its faces; "
           "maximal-curvature, ridge, valley: curvature at a scale; crease-distance, "
           "boundary-distance: along the surface, to its own edges; quality: the per-vertex "
           "quality "
           "of the layer; obstacle: a hill on the selection.";
}

void addFieldOptions(RichParameterList& list, const QString& prefix, bool isAdvanced) {
    addShares(list, prefix, isAdvanced);
    addObstacles(list, prefix, isAdvanced);
    addValues(list, prefix, isAdvanced);
}

FieldRequest readFieldRequest(
    const RichParameterList& parameters, const QString& prefix, int kind
) {
    const auto number = [&](const char* name) {
        return typedNumber(parameters.getFloat(prefix + name));
    };
    FieldRequest request;
    request.options.kind = kFieldKinds.at(static_cast<std::size_t>(kind));
    request.options.curvatureScale = number("curvature_scale");
    request.options.creaseAngle = number("crease_angle");
    request.options.reach = number("reach");
    request.options.obstacleValue = number("obstacle_value");
    request.options.obstacleSlope = number("obstacle_slope");
    request.options.smoothing = number("smoothing");
    request.options.normalised = parameters.getBool(prefix + "normalised");
    request.options.inverted = parameters.getBool(prefix + "inverted");
    request.region =
        static_cast<RegionSource>(choiceOf(parameters, prefix + "region", kRegionSources));
    return request;
}

RichParameterList fieldParameters() {
    const auto* const standard = std::ranges::find(kFieldKinds, FieldOptions().kind);
    RichParameterList list;
    list.addParam(RichEnum(
        "kind",
        static_cast<int>(standard - kFieldKinds.begin()),
        fieldKindNames(),
        "Kind",
        "What the values are made from. " + fieldKindsHelp()
    ));
    addFieldOptions(list, "", false);
    return list;
}

FieldRequest readFieldRequest(const RichParameterList& parameters) {
    return readFieldRequest(parameters, "", choiceOf(parameters, "kind", fieldKindNames()));
}

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
// Curves as STEP (ISO 10303-21, application protocol 214): a part whose shape is a set of curves.
#include "bspline_curve/spline.h"
#include "bspline_curve/version.h"
#include "io/curve_formats.h"
#include "io/spline_knots.h"
#include "text/number_text.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace bspline_curve {

namespace {

/// A real as STEP and IGES have it, with a decimal point: "1.", "1.5E-09".
std::string stepReal(double value) {
    const std::string text = numberText(value);
    const std::size_t exponent = text.find('e');
    std::string mantissa = text.substr(0, exponent);
    if (mantissa.find('.') == std::string::npos) {
        mantissa += '.';
    }
    return exponent == std::string::npos ? mantissa : mantissa + "E" + text.substr(exponent + 1);
}

template <class Item, class TextOf>
std::string listOfItems(const std::vector<Item>& items, const TextOf& textOf) {
    std::string text = "(";
    for (const Item& item : items) {
        text.append(text.size() > 1 ? "," : "").append(textOf(item));
    }
    return text + ")";
}

std::string reference(int id) {
    std::string text = "#";
    text += std::to_string(id);
    return text;
}

/// Instances of a file, numbered from 1.
class StepText {
public:
    int add(const std::string& instance) {
        text_.append(reference(++last_)).append("=").append(instance).append(";\n");
        return last_;
    }

    int addPoint(const Vec3& p) {
        return add(
            "CARTESIAN_POINT('',(" + stepReal(p.x()) + "," + stepReal(p.y()) + "," +
            stepReal(p.z()) + "))"
        );
    }

    [[nodiscard]] const std::string& text() const { return text_; }

private:
    std::string text_;
    int last_ = 0;
};

std::string pointsOfCurve(StepText& step, const std::vector<Vec3>& points) {
    std::vector<int> ids;
    for (const Vec3& point : points) {
        ids.push_back(step.addPoint(point));
    }
    return listOfItems(ids, reference);
}

int addSpline(StepText& step, const SplineData& spline) {
    const SplineData written = clamped(spline);
    const std::vector<RepeatedKnot> knots = repeatedKnots(written.knots);
    const std::string points = pointsOfCurve(step, written.controlPoints);
    return step.add(
        "B_SPLINE_CURVE_WITH_KNOTS(''," + std::to_string(written.degree) + "," + points +
        ",.UNSPECIFIED.," + (written.closed ? ".T." : ".F.") + ",.F.," +
        listOfItems(
            knots, [](const RepeatedKnot& each) { return std::to_string(each.multiplicity); }
        ) +
        "," + listOfItems(knots, [](const RepeatedKnot& each) { return stepReal(each.knot); }) +
        ",.UNSPECIFIED.)"
    );
}

int addPolyline(StepText& step, const SurfacePolyline& polyline) {
    std::vector<Vec3> points = polyline.points;
    if (polyline.closed && !points.empty()) {
        points.push_back(points.front());
    }
    const std::string list = pointsOfCurve(step, points);
    return step.add("POLYLINE(''," + list + ")");
}

int addUnit(StepText& step, LengthUnit unit) {
    const LengthUnitNames& names = namesOf(unit);
    const auto metres = [&](std::string_view prefix) {
        return step.add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(" + std::string(prefix) + ",.METRE.))");
    };
    if (!names.stepPrefix.empty()) {
        return metres(names.stepPrefix);
    }
    const int millimetre = metres(".MILLI.");
    const int size = step.add(
        "LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(" + stepReal(names.millimetres) + ")," +
        reference(millimetre) + ")"
    );
    const int dimensions = step.add("DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.)");
    return step.add(
        "(CONVERSION_BASED_UNIT('" + std::string(names.name) + "'," + reference(size) +
        ")LENGTH_UNIT()NAMED_UNIT(" + reference(dimensions) + "))"
    );
}

/// The context that says what numbers mean.
int addContext(StepText& step, LengthUnit unit) {
    const int length = addUnit(step, unit);
    const int angle = step.add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))");
    const int solidAngle = step.add("(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())");
    const int uncertainty = step.add(
        "UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-07)," + reference(length) +
        ",'distance_accuracy_value','confusion accuracy')"
    );
    return step.add(
        "(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((" +
        reference(uncertainty) + "))GLOBAL_UNIT_ASSIGNED_CONTEXT((" + reference(length) + "," +
        reference(angle) + "," + reference(solidAngle) + "))REPRESENTATION_CONTEXT('',''))"
    );
}

/// The part that has the shape.
void addProduct(StepText& step, int shape) {
    const int application =
        step.add("APPLICATION_CONTEXT('core data for automotive mechanical design processes')");
    step.add(
        "APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000," +
        reference(application) + ")"
    );
    const int context = step.add("PRODUCT_CONTEXT(''," + reference(application) + ",'mechanical')");
    const int product = step.add("PRODUCT('curve','curve','',(" + reference(context) + "))");
    step.add("PRODUCT_RELATED_PRODUCT_CATEGORY('part','',(" + reference(product) + "))");
    const int formation =
        step.add("PRODUCT_DEFINITION_FORMATION('',''," + reference(product) + ")");
    const int definitionContext = step.add(
        "PRODUCT_DEFINITION_CONTEXT('part definition'," + reference(application) + ",'design')"
    );
    const int definition = step.add(
        "PRODUCT_DEFINITION('design',''," + reference(formation) + "," +
        reference(definitionContext) + ")"
    );
    const int productShape =
        step.add("PRODUCT_DEFINITION_SHAPE('',''," + reference(definition) + ")");
    step.add(
        "SHAPE_DEFINITION_REPRESENTATION(" + reference(productShape) + "," + reference(shape) + ")"
    );
}

std::string stepFile(
    std::span<const CurveContent> contents, int (*addCurve)(StepText&, const Curve&)
) {
    StepText step;
    std::vector<int> curves;
    for (const CurveContent& content : contents) {
        curves.push_back(addCurve(step, content.curve));
    }
    const LengthUnit unit = contents.empty() ? LengthUnit::Millimetre : contents.front().unit;
    const int set = step.add("GEOMETRIC_CURVE_SET(''," + listOfItems(curves, reference) + ")");
    const int context = addContext(step, unit);
    const int shape = step.add(
        "GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION('',(" + reference(set) + ")," +
        reference(context) + ")"
    );
    addProduct(step, shape);
    return "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION(('B-spline curves on a triangle mesh'),'2;1');"
           "\nFILE_NAME('','',(''),(''),'bspline_curve " BSPLINE_CURVE_VERSION
           "','bspline_curve','');\n"
           "FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));\nENDSEC;\nDATA;\n" +
           step.text() + "ENDSEC;\nEND-ISO-10303-21;\n";
}

}  // namespace

std::string splineStep(std::span<const CurveContent> contents) {
    return stepFile(contents, [](StepText& step, const Curve& curve) {
        return addSpline(step, curve.spline);
    });
}

std::string polylineStep(std::span<const CurveContent> contents) {
    return stepFile(contents, [](StepText& step, const Curve& curve) {
        return addPolyline(step, curve.polyline);
    });
}

}  // namespace bspline_curve

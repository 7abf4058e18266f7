// SPDX-License-Identifier: GPL-3.0-or-later
// Curves as IGES 5.3: rational B-spline curves (entity 126) and linear paths (entity 106, form 12),
// in lines of 80 characters.
#include "bspline_curve/spline.h"
#include "bspline_curve/version.h"
#include "io/curve_formats.h"
#include "text/number_text.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace bspline_curve {

namespace {

constexpr std::size_t kIgesColumns = 72;  // before the letter of the section
constexpr std::size_t kDataColumns = 64;  // of parameters, before the number of the entity

/// A real in double precision: "1.D0", "1.5D-09".
std::string igesReal(double value) {
    const std::string text = numberText(value);
    const std::size_t exponent = text.find('e');
    std::string mantissa = text.substr(0, exponent);
    if (mantissa.find('.') == std::string::npos) {
        mantissa += '.';
    }
    return mantissa + "D" + (exponent == std::string::npos ? "0" : text.substr(exponent + 1));
}

/// A text with its length: "2HMM".
std::string igesText(std::string_view text) {
    return std::to_string(text.size()) + "H" + std::string(text);
}

std::string rightAligned(const std::string& text, std::size_t width) {
    return std::string(width - std::min(width, text.size()), ' ') + text;
}

std::string leftAligned(const std::string& text, std::size_t width) {
    return text + std::string(width - std::min(width, text.size()), ' ');
}

/// The end of each line: the letter of its section, and its number there.
std::string lineEnd(char section, int number) {
    constexpr std::size_t kDigits = 7;
    return section + rightAligned(std::to_string(number), kDigits) + "\n";
}

/// Fields with commas between them in lines of a width; no field is broken.
std::vector<std::string> brokenLines(const std::vector<std::string>& fields, std::size_t width) {
    std::vector<std::string> lines{""};
    for (std::size_t i = 0; i < fields.size(); ++i) {
        const std::string field = fields[i] + (i + 1 < fields.size() ? "," : ";");
        if (lines.back().size() + field.size() > width) {
            lines.emplace_back();
        }
        lines.back() += field;
    }
    return lines;
}

/// An entity's type and form, and its parameters after the type.
struct IgesEntity {
    int type, form;
    std::vector<std::string> parameters;
};

void addReals(std::vector<std::string>& fields, const Vec3& point) {
    for (const double x : point) {
        fields.push_back(igesReal(x));
    }
}

IgesEntity igesSpline(const Curve& curve) {
    const SplineData spline = clamped(curve.spline);
    constexpr const char* kNotPlanar = "0";
    constexpr const char* kPolynomial = "1";
    constexpr const char* kNotPeriodic = "0";
    std::vector<std::string> fields{
        std::to_string(spline.controlPoints.size() - 1),
        std::to_string(spline.degree),
        kNotPlanar,
        spline.closed ? "1" : "0",
        kPolynomial,
        kNotPeriodic
    };
    for (const double knot : spline.knots) {
        fields.push_back(igesReal(knot));
    }
    fields.insert(fields.end(), spline.controlPoints.size(), igesReal(1.0));  // weights
    for (const Vec3& point : spline.controlPoints) {
        addReals(fields, point);
    }
    fields.push_back(igesReal(spline.knots.front()));
    fields.push_back(igesReal(spline.knots.back()));
    addReals(fields, Vec3::Zero());  // the normal of planar curves
    return {.type = 126, .form = 0, .parameters = fields};
}

IgesEntity igesPolyline(const Curve& curve) {
    std::vector<Vec3> points = curve.polyline.points;
    if (curve.polyline.closed && !points.empty()) {
        points.push_back(points.front());
    }
    constexpr const char* kTriples = "2";
    std::vector<std::string> fields{kTriples, std::to_string(points.size())};
    for (const Vec3& point : points) {
        addReals(fields, point);
    }
    return {.type = 106, .form = 12, .parameters = fields};
}

std::vector<std::string> globalFields(LengthUnit unit) {
    const LengthUnitNames& names = namesOf(unit);
    const std::string program = "bspline_curve " BSPLINE_CURVE_VERSION;
    const std::string noDate = igesText("20000101.000000");
    return {
        igesText(","),
        igesText(";"),
        igesText("curves"),
        igesText(""),
        igesText(program),
        igesText(program),
        "32",  // bits of integers
        "38",  // powers of ten and digits of floats
        "6",
        "308",  // likewise of doubles
        "15",
        igesText("curves"),
        "1.D0",
        std::to_string(names.igesFlag),
        igesText(names.igesName),
        "1",
        "0.01D0",
        noDate,
        "1.D-7",
        "0.D0",  // the largest coordinate is not told
        igesText(""),
        igesText(""),
        "11",  // version 5.3
        "0",
        noDate
    };
}

std::string igesFile(
    std::span<const CurveContent> contents, IgesEntity (*entityOf)(const Curve& curve)
) {
    std::string bytes = leftAligned("B-spline curves on a triangle mesh", kIgesColumns);
    bytes += lineEnd('S', 1);
    const LengthUnit unit = contents.empty() ? LengthUnit::Millimetre : contents.front().unit;
    int globals = 0;
    for (const std::string& line : brokenLines(globalFields(unit), kIgesColumns)) {
        bytes += leftAligned(line, kIgesColumns) + lineEnd('G', ++globals);
    }
    std::string directory;
    std::string data;
    int entries = 0;
    int parameters = 0;
    for (const CurveContent& content : contents) {
        const IgesEntity entity = entityOf(content.curve);
        std::vector<std::string> fields{std::to_string(entity.type)};
        fields.insert(fields.end(), entity.parameters.begin(), entity.parameters.end());
        const std::vector<std::string> lines = brokenLines(fields, kDataColumns);
        constexpr std::size_t kField = 8;
        const auto field = [](int value) { return rightAligned(std::to_string(value), kField); };
        const int entry = entries + 1;
        directory += field(entity.type) + field(parameters + 1) + field(0) + field(0) + field(0) +
                     field(0) + field(0) + field(0) + "00000000" + lineEnd('D', ++entries);
        directory += field(entity.type) + field(0) + field(0) +
                     field(static_cast<int>(lines.size())) + field(entity.form) +
                     std::string(2 * kField, ' ') + rightAligned("CURVE", kField) + field(0) +
                     lineEnd('D', ++entries);
        for (const std::string& line : lines) {
            data += leftAligned(line, kDataColumns) + field(entry) + lineEnd('P', ++parameters);
        }
    }
    bytes += directory + data;
    constexpr std::size_t kCount = 7;
    const auto count = [](char section, int number) {
        return section + rightAligned(std::to_string(number), kCount);
    };
    bytes += leftAligned(
        count('S', 1) + count('G', globals) + count('D', entries) + count('P', parameters),
        kIgesColumns
    );
    return bytes + lineEnd('T', 1);
}

}  // namespace

std::string splineIges(std::span<const CurveContent> contents) {
    return igesFile(contents, igesSpline);
}

std::string polylineIges(std::span<const CurveContent> contents) {
    return igesFile(contents, igesPolyline);
}

}  // namespace bspline_curve

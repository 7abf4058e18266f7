// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/error.h"
#include "bspline_curve/files.h"
#include "io/curve_formats.h"
#include "text/text_parsing.h"

#include <algorithm>
#include <cassert>
#include <string_view>

namespace bspline_curve {

namespace {

using std::filesystem::path;

#ifndef BSPLINE_CURVE_WITHOUT_JSON
constexpr CurveFormat kJson{.end = ".json", .bytes = curveJson, .bytesOfMany = curvesJson};
#endif

const std::vector<CurveFormat>& curveFormats() {
    static const std::vector<CurveFormat> formats = [] {
        const std::span<const CurveFormat> others = curveFormatsWithoutJson();
        std::vector<CurveFormat> all(others.begin(), others.end());
#ifndef BSPLINE_CURVE_WITHOUT_JSON  // the Python package writes that itself
        all.push_back(kJson);
#endif
        return all;
    }();
    return formats;
}

const CurveFormat& formatOf(const path& file) {
    const std::string name = lowerCase(file.filename().string());
    const auto found = std::ranges::find_if(curveFormats(), [&](const CurveFormat& format) {
        return name.size() > format.end.size() && name.ends_with(format.end);
    });
    if (found == curveFormats().end()) {
        throw InputError(
            InputErrorCode::UnwritableFile,
            file.string() + ": the extension " + inQuotes(lowerCaseExtension(file)) +
                " of the output is none of " + curveExtensions()
        );
    }
    return *found;
}

/// Refuses a format that holds one curve alone.
const CurveFormat& formatOfMany(const path& file) {
    const CurveFormat& format = formatOf(file);
    if (format.bytesOfMany == nullptr) {
        throw InputError(
            InputErrorCode::UnwritableFile,
            file.string() + ": a file " + std::string(format.end) +
                " holds one curve; several are written to one of " + manyCurvesExtensions()
        );
    }
    return format;
}

}  // namespace

std::string curveExtensions() {
    std::string text;
    for (const CurveFormat& format : curveFormats()) {
        text.append(text.empty() ? "" : ", ").append(format.end);
    }
    return text;
}

std::string manyCurvesExtensions() {
    std::string text;
    for (const CurveFormat& format : curveFormats()) {
        if (format.bytesOfMany != nullptr) {
            text.append(text.empty() ? "" : ", ").append(format.end);
        }
    }
    return text;
}

void checkManyCurvesExtension(const path& file) {
    static_cast<void>(formatOfMany(file));
}

void checkCurveExtension(const path& file) {
    static_cast<void>(formatOf(file));
}

std::string curveBytes(
    const path& file,
    const Curve& curve,
    std::span<const double> field,
    const std::optional<MeshChecksum>& mesh,
    LengthUnit unit
) {
    const CurveFormat& format = formatOf(file);
    assert(curve.polyline.surfacePoints.size() == curve.polyline.points.size());
    assert(curve.polyline.parameters.size() == curve.polyline.points.size());
    assert(field.empty() || field.size() == curve.polyline.points.size());
    return format.bytes({.curve = curve, .field = field, .mesh = mesh, .unit = unit});
}

std::string curvesBytes(
    const path& file,
    std::span<const Curve* const> curves,
    const std::optional<MeshChecksum>& mesh,
    LengthUnit unit
) {
    std::vector<CurveContent> contents;
    for (const Curve* const curve : curves) {
        contents.push_back({.curve = *curve, .field = {}, .mesh = mesh, .unit = unit});
    }
    return formatOfMany(file).bytesOfMany(contents);
}

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/curve_writer.h"

#include "bspline_curve/error.h"
#include "io/atomic_file.h"
#include "io/curve_formats.h"
#include "io/text_parsing.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <string_view>

namespace bspline_curve {

namespace {

using std::filesystem::path;

using Contents = std::span<const CurveContent>;

struct CurveFormat {
    std::string_view end;  ///< of the file's name, in lower case
    std::string (*bytes)(const CurveContent& content);
    std::string (*bytesOfMany)(Contents contents) = nullptr;  ///< null: it holds one curve alone
};

/// A format of several curves, for one.
template <std::string (*bytesOfMany)(Contents)>
std::string ofOne(const CurveContent& content) {
    return bytesOfMany(Contents(&content, 1));
}

// A name has the first format that it ends with, so longer ends go before shorter ones.
constexpr std::array kCurveFormats{
    CurveFormat{.end = ".ply", .bytes = ofOne<curvePly>, .bytesOfMany = curvePly},
    CurveFormat{.end = ".bspline.obj", .bytes = splineObj},
    CurveFormat{.end = ".obj", .bytes = ofOne<curveObj>, .bytesOfMany = curveObj},
    CurveFormat{.end = ".bspline.dxf", .bytes = splineDxf},
    CurveFormat{.end = ".dxf", .bytes = ofOne<curveDxf>, .bytesOfMany = curveDxf},
    CurveFormat{.end = ".vtu", .bytes = curveVtu},
    CurveFormat{.end = ".csv", .bytes = curveCsv},
    CurveFormat{.end = ".polyline.step", .bytes = ofOne<polylineStep>, .bytesOfMany = polylineStep},
    CurveFormat{.end = ".polyline.stp", .bytes = ofOne<polylineStep>, .bytesOfMany = polylineStep},
    CurveFormat{.end = ".step", .bytes = ofOne<splineStep>, .bytesOfMany = splineStep},
    CurveFormat{.end = ".stp", .bytes = ofOne<splineStep>, .bytesOfMany = splineStep},
    CurveFormat{.end = ".polyline.iges", .bytes = ofOne<polylineIges>, .bytesOfMany = polylineIges},
    CurveFormat{.end = ".polyline.igs", .bytes = ofOne<polylineIges>, .bytesOfMany = polylineIges},
    CurveFormat{.end = ".iges", .bytes = ofOne<splineIges>, .bytesOfMany = splineIges},
    CurveFormat{.end = ".igs", .bytes = ofOne<splineIges>, .bytesOfMany = splineIges},
    CurveFormat{.end = ".json", .bytes = curveJson, .bytesOfMany = curvesJson},
};

const CurveFormat& formatOf(const path& file) {
    const std::string name = lowerCase(file.filename().string());
    const auto* const found = std::ranges::find_if(kCurveFormats, [&](const CurveFormat& format) {
        return name.size() > format.end.size() && name.ends_with(format.end);
    });
    if (found == kCurveFormats.end()) {
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
    for (const CurveFormat& format : kCurveFormats) {
        text.append(text.empty() ? "" : ", ").append(format.end);
    }
    return text;
}

std::string manyCurvesExtensions() {
    std::string text;
    for (const CurveFormat& format : kCurveFormats) {
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

void writeCurve(
    const path& file,
    const Curve& curve,
    std::span<const double> field,
    const std::optional<MeshChecksum>& mesh
) {
    AtomicFile(file, curveBytes(file, curve, field, mesh)).commit();
}

}  // namespace bspline_curve

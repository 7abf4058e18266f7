// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/curve_formats.h"

#include <array>

namespace bspline_curve {

namespace {

using Contents = std::span<const CurveContent>;

/// A format of several curves, for one.
template <std::string (*bytesOfMany)(Contents)>
std::string ofOne(const CurveContent& content) {
    return bytesOfMany(Contents(&content, 1));
}

// Longer ends go before shorter ones.
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
};

}  // namespace

std::span<const CurveFormat> curveFormatsWithoutJson() {
    return kCurveFormats;
}

std::vector<std::pair<std::size_t, std::size_t>> segmentsOf(const SurfacePolyline& polyline) {
    std::vector<std::pair<std::size_t, std::size_t>> result;
    const std::size_t count = polyline.points.size();
    for (std::size_t i = 0; i + 1 < count; ++i) {
        result.emplace_back(i, i + 1);
    }
    if (polyline.closed && count > 1) {
        result.emplace_back(count - 1, 0);
    }
    return result;
}

std::vector<char> pickFlags(const SurfacePolyline& polyline) {
    std::vector<char> flags(polyline.points.size(), 0);
    for (const int vertex : polyline.picks) {
        flags[vertex] = 1;
    }
    return flags;
}

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "bspline_curve/mesh_checksum.h"
#include "io/length_unit.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// The formats of curves, one function each; curveBytes() and curvesBytes() choose among them.
namespace bspline_curve {

/// What a curve file is made from.
struct CurveContent {
    const Curve& curve;
    std::span<const double> field{};           ///< per vertex of the polyline; empty: there is none
    std::optional<MeshChecksum> mesh{};        ///< the one that its faces are of; none: not known
    LengthUnit unit = LengthUnit::Millimetre;  ///< for formats that name one

    /// What is shown along the curve: the field or, where there is none, t.
    [[nodiscard]] std::span<const double> quality() const {
        return field.empty() ? std::span<const double>(curve.polyline.parameters) : field;
    }
};

struct CurveFormat {
    std::string_view end;  ///< of a file's name, in lower case
    std::string (*bytes)(const CurveContent& content);
    /// Null: it holds one curve alone.
    std::string (*bytesOfMany)(std::span<const CurveContent> contents) = nullptr;
};

/// All formats but .json, which needs a library of its own. A name has the first format that it
/// ends with.
[[nodiscard]] std::span<const CurveFormat> curveFormatsWithoutJson();

/// Segments as pairs of vertices, in order along the curve; the last of a closed one leads back to
/// vertex 0.
[[nodiscard]] std::vector<std::pair<std::size_t, std::size_t>> segmentsOf(
    const SurfacePolyline& polyline
);

/// Per vertex: 1 where a pick is, else 0.
[[nodiscard]] std::vector<char> pickFlags(const SurfacePolyline& polyline);

// The polylines of one curve or several.
[[nodiscard]] std::string curvePly(std::span<const CurveContent> contents);
[[nodiscard]] std::string curveObj(std::span<const CurveContent> contents);
[[nodiscard]] std::string curveDxf(std::span<const CurveContent> contents);

// The polyline of one.
[[nodiscard]] std::string curveVtu(const CurveContent& content);
[[nodiscard]] std::string curveCsv(const CurveContent& content);

// Polyline and spline.
[[nodiscard]] std::string curveJson(const CurveContent& content);
/// Several curves of one mesh, as a list.
[[nodiscard]] std::string curvesJson(std::span<const CurveContent> contents);

// The spline alone.
[[nodiscard]] std::string splineObj(const CurveContent& content);
[[nodiscard]] std::string splineDxf(const CurveContent& content);

// For CAD: the splines of one curve or several, and their polylines.
[[nodiscard]] std::string splineStep(std::span<const CurveContent> contents);
[[nodiscard]] std::string polylineStep(std::span<const CurveContent> contents);
[[nodiscard]] std::string splineIges(std::span<const CurveContent> contents);
[[nodiscard]] std::string polylineIges(std::span<const CurveContent> contents);

}  // namespace bspline_curve

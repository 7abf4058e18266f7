// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/error.h"
#include "design/curve_designer.h"
#include "fuzz/byte_source.h"
#include "fuzz/fuzz_target.h"
#include "fuzz/mesh_of_bytes.h"
#include "imprint/imprint.h"
#include "surface/passages.h"
#include "surface/strict_line.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <span>
#include <vector>

namespace bspline_curve::fuzz {

namespace {

ShellOptions shellOf(ByteSource& bytes) {
    ShellOptions options;
    options.kind = bytes.oneIn(8)   ? ShellKind::Simplified
                   : bytes.oneIn(6) ? ShellKind::FullResolution
                                    : ShellKind::Local;
    if (bytes.oneIn(4)) {
        options.thickness = 0.01 + 2.0 * bytes.unit();
        options.smoothingPasses = bytes.integer(0, 5);
        options.targetThickness = 0.001 + 0.5 * bytes.unit();
    }
    return options;
}

SolverOptions solverOf(ByteSource& bytes) {
    SolverOptions options = bytes.oneIn(6) ? paperPreset() : SolverOptions{};
    options.closed = bytes.oneIn(2);
    if (bytes.oneIn(3)) {
        options.degree = bytes.integer(2, 4);
        options.tension = bytes.unit();
        options.distanceTolerance = 0.001 + bytes.unit();
    }
    if (bytes.oneIn(4)) {
        options.fieldCost = static_cast<FieldCost>(bytes.integer(0, 3));
        options.fieldGuidesPath = bytes.oneIn(2);
        options.bending = bytes.oneIn(2) ? Bending::Ambient : Bending::Geodesic;
        options.quadrature = bytes.oneIn(2) ? Quadrature::Cells : options.quadrature;
        options.maxRounds = bytes.integer(1, 30);
        options.maxIterations = bytes.integer(1, 60);
    }
    return options;
}

/// Mostly on the surface, now and then beside it.
std::vector<Vec3> picksOn(const TriangleMesh& mesh, ByteSource& bytes) {
    std::vector<Vec3> picks;
    const int count = bytes.integer(0, 7);
    for (int i = 0; i < count; ++i) {
        const auto& face = mesh.faces[bytes.integer(0, static_cast<int>(mesh.faces.size()) - 1)];
        double u = bytes.unit();
        double v = bytes.unit();
        if (u + v > 1.0) {
            u = 1.0 - u;
            v = 1.0 - v;
        }
        const Vec3& a = mesh.vertices[face[0]];
        Vec3 pick = a + u * (mesh.vertices[face[1]] - a) + v * (mesh.vertices[face[2]] - a);
        if (bytes.oneIn(20)) {
            pick += 0.5 * (mesh.vertices[face[1]] - a).cross(mesh.vertices[face[2]] - a);
        }
        picks.push_back(pick);
    }
    return picks;
}

/// Whether every segment lies in a face of the mesh as it was given: curves may pass between
/// sheets that mending has parted.
bool isStrictOnInput(const Surface& surface, const SurfacePolyline& line) {
    const auto& [vertices, faces] = surface.input();
    // By places, since seams are joined.
    const auto hasCorner = [&](const Triangle& corners, const Vec3& place) {
        return std::ranges::any_of(corners, [&](int v) { return vertices[v] == place; });
    };
    const auto holds = [&](const Triangle& corners, const SurfacePoint& point) {
        return std::ranges::all_of(std::array{0, 1, 2}, [&](int k) {
            return point.barycentric[k] == 0.0 ||
                   hasCorner(corners, vertices[faces[point.face][k]]);
        });
    };
    const std::vector<SurfacePoint>& points = line.surfacePoints;
    for (std::size_t i = line.closed ? 0 : 1; i < points.size(); ++i) {
        const SurfacePoint& before = points[i > 0 ? i - 1 : points.size() - 1];
        if (std::ranges::none_of(faces, [&](const Triangle& corners) {
                return holds(corners, before) && holds(corners, points[i]);
            })) {
            return false;
        }
    }
    return true;
}

/// Whether the surface has the line from face to face, without passing from sheet to sheet.
bool liesOn(const Surface& surface, const SurfacePolyline& line) {
    try {
        static_cast<void>(strictLine(surface, line, "it"));
        return true;
    } catch (const InputError&) {
        return false;
    }
}

void checkCurve(const Curve& curve) {
    const SurfacePolyline& line = curve.polyline;
    require(
        std::ranges::all_of(line.points, [](const Vec3& point) { return point.allFinite(); }),
        "the polyline is finite"
    );
    require(std::ranges::is_sorted(line.parameters), "parameters ascend");
    require(
        std::ranges::all_of(
            curve.spline.controlPoints, [](const Vec3& point) { return point.allFinite(); }
        ),
        "the spline is finite"
    );
    const SolveReport& report = curve.report;
    require(
        !report.usable || report.maxDistance <= report.allowedDistance,
        "a usable curve is within its tolerance"
    );
}

void checkImprint(const Surface& surface, const SurfacePolyline& line) {
    const ImprintedMesh imprinted = imprint(surface, std::span(&line, 1), {});
    const TriangleMesh before = withoutImprint(imprinted);
    require(before.vertices == surface.vertices(), "vertices come back as they were");
    require(before.faces == surface.faces(), "faces come back as they were");
}

void drawAndCheck(ByteSource& bytes) {
    const ShellOptions shell = shellOf(bytes);
    const SolverOptions options = solverOf(bytes);
    const MendingOptions mending{
        .strict = bytes.oneIn(10), .weld = bytes.oneIn(10) ? 1e-4 * bytes.unit() : 0.0
    };
    const bool hasField = bytes.oneIn(3);
    const bool avoids = bytes.oneIn(5);
    const TriangleMesh mesh = meshOf(bytes);
    const CurveDesigner designer(mesh, shell, mending);
    const Surface& surface = designer.surface();
    const std::vector<Vec3> picks = picksOn(designer.mesh(), bytes);
    std::vector<double> field;
    for (std::size_t i = 0; hasField && i < designer.mesh().vertices.size(); ++i) {
        field.push_back(bytes.unit());
    }
    std::vector<int> avoid;
    for (int i = 0; avoids && i < 4; ++i) {
        avoid.push_back(bytes.integer(0, static_cast<int>(designer.mesh().faces.size()) - 1));
    }
    const Curve curve = designer.design(picks, options, {}, {.field = field, .avoid = avoid});
    checkCurve(curve);
    if (liesOn(surface, curve.polyline)) {
        checkImprint(surface, curve.polyline);
        return;
    }
    require(
        !surface.provenance().isIdentity() && isStrictOnInput(surface, curve.polyline),
        "every segment of the polyline lies in a face"
    );
}

}  // namespace

void drawCurve(std::string_view bytes) {
    ByteSource source(bytes);
    try {
        drawAndCheck(source);
    } catch (const InputError&) {
        return;
    }
}

}  // namespace bspline_curve::fuzz

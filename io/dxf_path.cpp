// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/dxf_path.h"

#include "offset/face_layout.h"
#include "pattern/drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

namespace bspline_curve {

namespace {

using Vec2 = Eigen::Vector2d;

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kDegree = std::numbers::pi / 180.0;

/// A vertex of a polyline, and the tangent of a quarter of the angle of the arc after it.
struct BulgeVertex {
    Vec2 at;
    double bulge = 0.0;
};

SpaceArc lineBetween(const Vec3& from, const Vec3& to) {
    return {.points = {from, to}, .weights = {}};
}

/// Planar arcs at the height 0.
std::vector<SpaceArc> inSpace(const std::vector<DrawingArc>& arcs) {
    std::vector<SpaceArc> result;
    for (const DrawingArc& arc : arcs) {
        SpaceArc lifted{.points = {}, .weights = arc.weights};
        for (const Vec2& point : arc.points) {
            lifted.points.emplace_back(point.x(), point.y(), 0.0);
        }
        result.push_back(std::move(lifted));
    }
    return result;
}

SpacePath polylineThrough(std::vector<BulgeVertex> vertices, bool closed) {
    SpacePath path{.arcs = {}, .closed = closed};
    if (closed && !vertices.empty()) {
        vertices.push_back(vertices.front());
    }
    std::vector<DrawingArc> arcs;
    for (std::size_t i = 1; i < vertices.size(); ++i) {
        const auto& [from, bulge] = vertices[i - 1];
        const Vec2 to = vertices[i].at;
        if (from == to) {
            continue;
        }
        if (bulge == 0.0) {
            arcs.push_back({.points = {from, to}, .weights = {}});
            continue;
        }
        const Vec2 centre =
            0.5 * (from + to) + 0.25 * (1.0 / bulge - bulge) * turnedLeft(to - from);
        const Vec2 out = from - centre;
        std::vector<DrawingArc> bent =
            ellipticalArc(centre, out, turnedLeft(out), 0.0, 4.0 * std::atan(bulge));
        bent.front().points.front() = from;
        bent.back().points.back() = to;
        std::ranges::move(bent, std::back_inserter(arcs));
    }
    path.arcs = inSpace(arcs);
    return path;
}

SpacePath circleOf(const DxfEntity& entity) {
    const double radius = entity.numberOf(40, 0.0);
    if (!(radius > 0.0)) {
        entity.refuse("a radius that is not > 0");
    }
    const bool isWhole = entity.name() == "CIRCLE";
    const double from = isWhole ? 0.0 : entity.numberOf(50, 0.0) * kDegree;
    double sweep = isWhole ? kTurn : entity.numberOf(51, 360.0) * kDegree - from;
    sweep += sweep <= 0.0 ? kTurn * std::ceil(-sweep / kTurn + 1e-12) : 0.0;
    const Vec3 centre = entity.pointOf(10);
    return mapped(
        {.arcs = inSpace(ellipticalArc(
             centre.head<2>(), Vec2(radius, 0.0), Vec2(0.0, radius), from, std::min(sweep, kTurn)
         )),
         .closed = isWhole},
        ownDxfPlane(entity, centre.z())
    );
}

SpacePath ellipseOf(const DxfEntity& entity) {
    const Vec3 major = entity.pointOf(11);
    const Vec3 minor = entity.numberOf(40, 1.0) * Vec3(entity.axes().col(2)).cross(major);
    if (!(major.norm() > 0.0) || !(minor.norm() > 0.0)) {
        entity.refuse("an ellipse without size");
    }
    const double from = entity.numberOf(41, 0.0);
    double sweep = entity.numberOf(42, kTurn) - from;
    sweep += sweep <= 0.0 ? kTurn : 0.0;
    constexpr double kWhole = kTurn * (1.0 - 1e-9);
    const bool isWhole = sweep >= kWhole;
    Eigen::Affine3d plane = Eigen::Affine3d::Identity();
    plane.linear() << major, minor, Vec3::Zero();
    plane.translation() = entity.pointOf(10);
    return mapped(
        {.arcs = inSpace(ellipticalArc(
             Vec2::Zero(), Vec2::UnitX(), Vec2::UnitY(), from, isWhole ? kTurn : sweep
         )),
         .closed = isWhole},
        plane
    );
}

SpacePath lightPolylineOf(const DxfEntity& entity) {
    std::vector<BulgeVertex> vertices;
    for (const DxfPair& pair : entity.pairs()) {
        if (pair.code == 10) {
            vertices.push_back({.at = {entity.number(pair), 0.0}});
        } else if (pair.code == 20 && !vertices.empty()) {
            vertices.back().at.y() = entity.number(pair);
        } else if (pair.code == 42 && !vertices.empty()) {
            vertices.back().bulge = entity.number(pair);
        }
    }
    return mapped(
        polylineThrough(std::move(vertices), (entity.flags() & DxfFlag::kClosed) != 0),
        ownDxfPlane(entity, entity.numberOf(38, 0.0))
    );
}

SpacePath polylineInSpace(std::span<const DxfEntity> vertices, bool closed) {
    SpacePath path{.arcs = {}, .closed = closed};
    std::vector<Vec3> points;
    for (const DxfEntity& vertex : vertices) {
        points.push_back(vertex.pointOf(10));
    }
    if (closed && !points.empty()) {
        points.push_back(points.front());
    }
    for (std::size_t i = 1; i < points.size(); ++i) {
        if (points[i] != points[i - 1]) {
            path.arcs.push_back(lineBetween(points[i - 1], points[i]));
        }
    }
    return path;
}

SpacePath oldPolylineOf(const DxfEntity& entity, std::span<const DxfEntity> vertexEntities) {
    const int flags = entity.flags();
    if ((flags & DxfFlag::kMesh) != 0) {
        entity.refuse("a POLYLINE that is a mesh; give a curve");
    }
    std::vector<DxfEntity> vertices;
    std::ranges::copy_if(vertexEntities, std::back_inserter(vertices), [&](const DxfEntity& each) {
        return (flags & DxfFlag::kSplineFit) == 0 || (each.flags() & DxfFlag::kSplineFrame) == 0;
    });
    const bool closed = (flags & DxfFlag::kClosed) != 0;
    if ((flags & DxfFlag::kIn3d) != 0) {
        return polylineInSpace(vertices, closed);
    }
    std::vector<BulgeVertex> planar;
    for (const DxfEntity& vertex : vertices) {
        planar.push_back({.at = vertex.pointOf(10).head<2>(), .bulge = vertex.numberOf(42, 0.0)});
    }
    const double height = vertices.empty() ? 0.0 : vertices.front().pointOf(10).z();
    return mapped(
        polylineThrough(std::move(planar), closed),
        ownDxfPlane(entity, height != 0.0 ? height : entity.pointOf(10).z())
    );
}

std::vector<Vec3> pointsOf(const DxfEntity& entity, int code) {
    const std::vector<double> x = entity.numbersOf(code);
    const std::vector<double> y = entity.numbersOf(code + 10);
    const std::vector<double> z = entity.numbersOf(code + 20);
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
        points.emplace_back(x[i], y[i], i < z.size() ? z[i] : 0.0);
    }
    return points;
}

SpacePath splineOf(const DxfEntity& entity) {
    constexpr int kFitPoints = 11;
    const SpaceSpline spline{
        .degree = entity.integerOf(71, 3),
        .knots = entity.numbersOf(40),
        .points = pointsOf(entity, 10),
        .weights = entity.numbersOf(41)
    };
    SpacePath path;
    if (spline.points.empty()) {
        path.arcs = arcsThrough(
            pointsOf(entity, kFitPoints),
            entity.pointOf(12),
            entity.pointOf(13),
            (entity.flags() & DxfFlag::kClosed) != 0
        );
        if (path.arcs.empty()) {
            entity.refuse("a SPLINE without control points and without two fit points");
        }
    } else {
        try {
            path.arcs = arcsOf(spline);
        } catch (const std::invalid_argument& error) {
            entity.refuse(error.what());
        }
    }
    if (!path.arcs.empty()) {
        closeWhereEndsMeet(path);
    }
    return path;
}

}  // namespace

bool isDxfCurve(const DxfEntity& entity) {
    constexpr std::array<std::string_view, 7> kCurves{
        "LINE", "CIRCLE", "ARC", "ELLIPSE", "LWPOLYLINE", "POLYLINE", "SPLINE"
    };
    return std::ranges::find(kCurves, entity.name()) != kCurves.end();
}

SpacePath pathOfDxf(const DxfEntity& entity, std::span<const DxfEntity> vertices) {
    const std::string_view name = entity.name();
    if (name == "LINE") {
        return {.arcs = {lineBetween(entity.pointOf(10), entity.pointOf(11))}};
    }
    if (name == "CIRCLE" || name == "ARC") {
        return circleOf(entity);
    }
    if (name == "ELLIPSE") {
        return ellipseOf(entity);
    }
    if (name == "LWPOLYLINE") {
        return lightPolylineOf(entity);
    }
    if (name == "POLYLINE") {
        return oldPolylineOf(entity, vertices);
    }
    return name == "SPLINE" ? splineOf(entity) : SpacePath{};
}

/// From an entity's own coordinates, at a height, to those of the drawing.
Eigen::Affine3d ownDxfPlane(const DxfEntity& entity, double height) {
    Eigen::Affine3d map = Eigen::Affine3d::Identity();
    map.linear() = entity.axes();
    map.translation() = height * entity.axes().col(2);
    return map;
}

SpacePath mapped(SpacePath path, const Eigen::Affine3d& map) {
    for (SpaceArc& arc : path.arcs) {
        for (Vec3& point : arc.points) {
            point = map * point;
        }
    }
    return path;
}

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/curve_tube.h"

#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace bspline_curve {

namespace {

/// Of the radius: rings are at least this far apart.
constexpr double kRingSpacing = 0.25;
/// Below this the sum of two unit vectors has no direction: the polyline turns back on itself.
constexpr double kNoDirection = 1e-6;

/// The points that get a ring: the first, the last of an open polyline, and between them as many as
/// keep their distance.
std::vector<Vec3> thinned(std::span<const Vec3> points, bool closed, double spacing) {
    std::vector<Vec3> kept = {points.front()};
    for (const Vec3& point : points.subspan(1)) {
        if ((point - kept.back()).norm() >= spacing) {
            kept.push_back(point);
        }
    }
    const Vec3& last = closed ? points.front() : points.back();
    while (kept.size() > 1 && (kept.back() - last).norm() < spacing) {
        kept.pop_back();
    }
    if (!closed) {
        kept.push_back(last);
    }
    // A closed curve that is smaller than its tube is thick.
    return closed && kept.size() < 3 ? std::vector<Vec3>(points.begin(), points.end()) : kept;
}

/// Unit directions of the segments; a closed polyline's last leads back to the first point.
std::vector<Vec3> directionsOf(const std::vector<Vec3>& points, bool closed) {
    std::vector<Vec3> directions;
    const std::size_t count = closed ? points.size() : points.size() - 1;
    for (std::size_t i = 0; i < count; ++i) {
        directions.push_back((points[(i + 1) % points.size()] - points[i]).stableNormalized());
    }
    return directions;
}

/// Unit tangents at the points, half-way between the directions of their segments.
std::vector<Vec3> tangentsOf(
    const std::vector<Vec3>& directions, std::size_t pointCount, bool closed
) {
    std::vector<Vec3> tangents;
    for (std::size_t i = 0; i < pointCount; ++i) {
        const bool isFirst = i == 0 && !closed;
        const Vec3& before = directions[isFirst ? 0 : (i + pointCount - 1) % pointCount];
        const Vec3& after = i < directions.size() ? directions[i] : before;
        const Vec3 sum = before + after;
        tangents.push_back(sum.norm() > kNoDirection ? sum.normalized() : after);
    }
    return tangents;
}

/// The component of a vector across a unit tangent, as a unit vector.
Vec3 across(const Vec3& vector, const Vec3& tangent) {
    return (vector - vector.dot(tangent) * tangent).normalized();
}

Vec3 anyNormal(const Vec3& tangent) {
    Eigen::Index least = 0;
    tangent.cwiseAbs().minCoeff(&least);
    return across(Vec3::Unit(least), tangent);
}

/// A normal carried along by the least rotation that takes one tangent to the next.
Vec3 transported(const Vec3& normal, const Vec3& from, const Vec3& to) {
    const double cosine = from.dot(to);
    if (1.0 + cosine < kNoDirection) {
        return normal;  // half a turn about the normal itself
    }
    const Vec3 axis = from.cross(to);
    const Vec3 turned = axis.cross(normal);
    return across(normal + turned + axis.cross(turned) / (1.0 + cosine), to);
}

std::vector<Vec3> normalsOf(const std::vector<Vec3>& tangents) {
    std::vector<Vec3> normals = {anyNormal(tangents.front())};
    for (std::size_t i = 1; i < tangents.size(); ++i) {
        normals.push_back(transported(normals.back(), tangents[i - 1], tangents[i]));
    }
    return normals;
}

Vec3 rotated(const Vec3& normal, const Vec3& tangent, double angle) {
    return std::cos(angle) * normal + std::sin(angle) * tangent.cross(normal);
}

/// Turns the normals of a closed polyline back by what its holonomy turned them, evenly along it.
void closeUp(
    std::vector<Vec3>& normals, const std::vector<Vec3>& tangents, const std::vector<Vec3>& points
) {
    const Vec3 arrived = transported(normals.back(), tangents.back(), tangents.front());
    const double twist = std::atan2(
        tangents.front().dot(normals.front().cross(arrived)), normals.front().dot(arrived)
    );
    std::vector<double> lengths = {0.0};
    for (std::size_t i = 0; i < points.size(); ++i) {
        lengths.push_back(lengths.back() + (points[(i + 1) % points.size()] - points[i]).norm());
    }
    for (std::size_t i = 0; i < normals.size(); ++i) {
        normals[i] = rotated(normals[i], tangents[i], -twist * lengths[i] / lengths.back());
    }
}

}  // namespace

TriangleMesh makeTube(std::span<const Vec3> points, bool closed, double radius, int sides) {
    const std::vector<Vec3> centres = thinned(points, closed, kRingSpacing * radius);
    const std::vector<Vec3> tangents =
        tangentsOf(directionsOf(centres, closed), centres.size(), closed);
    std::vector<Vec3> normals = normalsOf(tangents);
    if (closed) {
        closeUp(normals, tangents, centres);
    }
    TriangleMesh mesh;
    for (std::size_t i = 0; i < centres.size(); ++i) {
        for (int j = 0; j < sides; ++j) {
            const double angle = 2.0 * std::numbers::pi * j / sides;
            mesh.vertices.emplace_back(
                centres[i] + radius * rotated(normals[i], tangents[i], angle)
            );
        }
    }
    const int rings = static_cast<int>(centres.size());
    const auto corner = [&](int ring, int j) { return ring % rings * sides + j % sides; };
    for (int ring = 0; ring < (closed ? rings : rings - 1); ++ring) {
        for (int j = 0; j < sides; ++j) {
            const int next = corner(ring + 1, j);
            mesh.faces.push_back({corner(ring, j), corner(ring, j + 1), next});
            mesh.faces.push_back({corner(ring, j + 1), corner(ring + 1, j + 1), next});
        }
    }
    if (!closed) {
        // Lids.
        const int apex = rings * sides;
        mesh.vertices.insert(mesh.vertices.end(), {centres.front(), centres.back()});
        for (int j = 0; j < sides; ++j) {
            mesh.faces.push_back({apex, corner(0, j + 1), corner(0, j)});
            mesh.faces.push_back({apex + 1, corner(rings - 1, j), corner(rings - 1, j + 1)});
        }
    }
    return mesh;
}

}  // namespace bspline_curve

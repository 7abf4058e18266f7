// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/error.h"
#include "bspline_curve/lines.h"
#include "spline/spline_sections.h"
#include "spline/spline_space.h"
#include "surface/surface_point.h"
#include "surface/vertex_normals.h"
#include "text/error_messages.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

namespace bspline_curve {

namespace {

/// How far, in the length of the curve, points are from that whose curvature is measured by them.
constexpr double kCurvatureReach = 0.01;

/// A polyline by its length; a closed one has its first vertex at the end as well.
class MeasuredLine {
public:
    explicit MeasuredLine(const SurfacePolyline& line) : line_(line) {
        const std::size_t count = line.points.size();
        for (std::size_t i = 1; i < count + (line.closed ? 1 : 0); ++i) {
            distances_.push_back(
                distances_.back() + (line.points[i % count] - line.points[i - 1]).norm()
            );
        }
    }

    [[nodiscard]] double length() const { return distances_.back(); }

    [[nodiscard]] double distanceOf(int vertex) const { return distances_[vertex]; }

    /// A segment, and how much of it is passed.
    struct Place {
        std::size_t segment = 0;
        double share = 0.0;
    };

    /// Of a closed line any distance.
    [[nodiscard]] Place placeAt(double distance) const {
        const double on = line_.closed ? distance - length() * std::floor(distance / length())
                                       : std::clamp(distance, 0.0, length());
        const auto after = std::ranges::upper_bound(distances_, on);
        const auto last = static_cast<std::ptrdiff_t>(distances_.size()) - 2;
        const auto segment = std::clamp<std::ptrdiff_t>(after - distances_.begin() - 1, 0, last);
        const double from = distances_[segment];
        const double step = distances_[segment + 1] - from;
        return {
            .segment = static_cast<std::size_t>(segment),
            .share = step > 0.0 ? (on - from) / step : 0.0
        };
    }

    [[nodiscard]] std::size_t after(std::size_t vertex) const {
        return (vertex + 1) % line_.points.size();
    }

    [[nodiscard]] Vec3 positionAt(double distance) const {
        const auto [segment, share] = placeAt(distance);
        return (1.0 - share) * line_.points[segment] + share * line_.points[after(segment)];
    }

    [[nodiscard]] double parameterAt(double distance) const {
        const auto [segment, share] = placeAt(distance);
        const double from = line_.parameters[segment];
        const double to = after(segment) == 0 ? 1.0 : line_.parameters[after(segment)];
        return (1.0 - share) * from + share * to;
    }

private:
    const SurfacePolyline& line_;
    std::vector<double> distances_{0.0};  // of the vertices
};

/// The first two derivatives of a curve by its length.
struct Derivatives {
    Vec3 tangent, bend;
};

Derivatives alongLine(const MeasuredLine& line, bool closed, double distance) {
    const double reach = kCurvatureReach * line.length();
    const double middle =
        closed ? distance : std::clamp(distance, reach, std::max(line.length() - reach, reach));
    const Vec3 before = line.positionAt(middle - reach);
    const Vec3 at = line.positionAt(middle);
    const Vec3 behind = line.positionAt(middle + reach);
    const Vec3 bend = (before - 2.0 * at + behind) / (reach * reach);
    const Vec3 slope = (behind - before) / (2.0 * reach) + (distance - middle) * bend;
    return {.tangent = slope, .bend = bend};
}

/// A smooth spline with simple knots, as all that are drawn here have between their corners.
class SmoothSpline {
public:
    /// None where it is another one.
    static std::optional<SmoothSpline> of(const SplineData& spline) {
        std::vector<double> breaks;
        std::ranges::copy_if(spline.knots, std::back_inserter(breaks), [](double knot) {
            return knot >= 0.0 && knot <= 1.0;
        });
        const auto repeated = std::ranges::unique(breaks);
        breaks.erase(repeated.begin(), repeated.end());
        const bool hasBreaks = spline.degree >= 2 && spline.degree <= kMaxPolynomialDegree &&
                               std::ranges::is_sorted(breaks) && breaks.size() >= 2 &&
                               breaks.front() == 0.0 && breaks.back() == 1.0;
        const auto degree = static_cast<std::size_t>(std::max(spline.degree, 0));
        const std::size_t needed = breaks.size() - 1 + degree;
        if (!hasBreaks || spline.controlPoints.size() != needed ||
            (spline.closed && breaks.size() < degree + 2)) {
            return std::nullopt;
        }
        return SmoothSpline(spline, std::move(breaks));
    }

    [[nodiscard]] Derivatives at(double t) const {
        const int span = space_.spanAt(std::clamp(t, 0.0, 1.0));
        const double step = space_.spanLength(span);
        const double tau = (t - space_.breaks()[span]) / step;
        const PolynomialCurve part = space_.polynomial(controls_, span);
        const Vec3 first = part.derivativeAt(tau) / step;
        const Vec3 second = part.secondDerivativeAt(tau) / (step * step);
        const double speed = first.norm();
        const Vec3 tangent = first / speed;
        return {
            .tangent = tangent, .bend = (second - second.dot(tangent) * tangent) / (speed * speed)
        };
    }

private:
    SmoothSpline(const SplineData& spline, std::vector<double> breaks)
        : space_(spline.degree, spline.closed, std::move(breaks)),
          controls_(space_.controlCount(), 3) {
        for (int i = 0; i < space_.controlCount(); ++i) {
            controls_.row(i) = spline.controlPoints[i].transpose();
        }
    }

    SplineSpace space_;
    ControlPoints controls_;
};

/// The spline of a curve; at a corner it is that behind it.
class CurveSpline {
public:
    /// None where it is none of those that are drawn here.
    static std::optional<CurveSpline> of(const SplineData& spline) {
        std::optional<SmoothSpline> whole = SmoothSpline::of(spline);
        CurveSpline result;
        if (whole) {
            result.parts_.push_back({0.0, 1.0, *std::move(whole)});
            return result;
        }
        const auto degree = static_cast<std::size_t>(std::max(spline.degree, 0));
        const std::size_t count = spline.controlPoints.size();
        if (degree < 2 || count <= degree || spline.knots.size() != count + degree + 1 ||
            !std::ranges::is_sorted(spline.knots)) {
            return std::nullopt;
        }
        for (auto& [from, to, part] : sectionsOf(spline)) {
            for (double& knot : part.knots) {
                knot = knot == to ? 1.0 : (knot - from) / (to - from);
            }
            std::optional<SmoothSpline> smooth = SmoothSpline::of(part);
            if (!smooth) {
                return std::nullopt;
            }
            result.parts_.push_back({from, to, *std::move(smooth)});
        }
        result.isClosedChain_ = spline.closed;
        return result.parts_.empty() ? std::nullopt : std::optional(std::move(result));
    }

    [[nodiscard]] Derivatives at(double t) const {
        const double on = isClosedChain_ && t >= parts_.back().to ? t - 1.0 : t;
        const auto after =
            std::ranges::find_if(parts_, [on](const Part& part) { return on < part.to; });
        const Part& part = after == parts_.end() ? parts_.back() : *after;
        return part.spline.at((on - part.from) / (part.to - part.from));
    }

private:
    struct Part {
        double from, to;
        SmoothSpline spline;
    };

    std::vector<Part> parts_;
    bool isClosedChain_ = false;  // over [a, a + 1]
};

Vec3 unitOrZero(const Vec3& v) {
    const double length = v.norm();
    return length > 0.0 ? Vec3(v / length) : Vec3(Vec3::Zero());
}

void checkOnCurve(double distance, double length, bool closed) {
    // Sums of lengths, as people make them, are allowed their rounding.
    constexpr double kRounding = 1e-9;
    const bool isOn = std::isfinite(distance) &&
                      (closed || (distance >= 0.0 && distance <= length * (1.0 + kRounding)));
    if (!isOn) {
        throw InputError(
            InputErrorCode::BadOption,
            "the distance " + describeNumber(distance) + " is not on the curve, which is " +
                describeNumber(length) + " long"
        );
    }
}

}  // namespace

std::vector<double> evenDistances(const SurfacePolyline& line, int count) {
    const double length = MeasuredLine(line).length();
    const int parts = line.closed ? count : count - 1;
    std::vector<double> distances;
    for (int i = 0; i < count; ++i) {
        distances.push_back(length * i / parts);
    }
    return distances;
}

std::vector<double> distancesOfPicks(const SurfacePolyline& line) {
    const MeasuredLine measured(line);
    std::vector<double> distances;
    for (const int pick : line.picks) {
        distances.push_back(measured.distanceOf(pick));
    }
    return distances;
}

CurvePoints::CurvePoints(const TriangleMesh& mesh)
    : mesh_(mesh), normals_(vertexNormals(mesh)), firstFace_(mesh.vertices.size() + 1, 0) {
    for (const Triangle& face : mesh.faces) {
        for (const int vertex : face) {
            ++firstFace_[vertex + 1];
        }
    }
    std::partial_sum(firstFace_.begin(), firstFace_.end(), firstFace_.begin());
    facesOf_.resize(static_cast<std::size_t>(firstFace_.back()));
    std::vector<int> next = firstFace_;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        for (const int vertex : mesh.faces[f]) {
            facesOf_[next[vertex]++] = static_cast<int>(f);
        }
    }
}

SurfacePoint CurvePoints::placeBetween(
    const SurfacePoint& from, const SurfacePoint& to, double share
) const {
    // Both as weights of vertices; a face that has all of these holds the segment.
    std::map<int, double> weights;
    for (const auto& [point, part] : {std::pair(from, 1.0 - share), std::pair(to, share)}) {
        for (int k = 0; k < 3; ++k) {
            if (std::abs(point.barycentric[k]) > kOnEdgeBarycentric) {
                weights[mesh_.faces[point.face][k]] += part * point.barycentric[k];
            }
        }
    }
    const int vertex = weights.begin()->first;
    const auto around = std::span(facesOf_).subspan(
        static_cast<std::size_t>(firstFace_[vertex]),
        static_cast<std::size_t>(firstFace_[vertex + 1] - firstFace_[vertex])
    );
    const auto holdsAll = [&](int face) {
        return std::ranges::all_of(weights, [&](const auto& each) {
            return cornerOf(mesh_.faces[face], each.first) >= 0;
        });
    };
    const auto found = std::ranges::find_if(around, holdsAll);
    if (found == around.end()) {
        return share < 0.5 ? from : to;  // between sheets that mending parts
    }
    SurfacePoint place{.face = *found, .barycentric = Vec3::Zero()};
    for (const auto& [id, weight] : weights) {
        place.barycentric[cornerOf(mesh_.faces[*found], id)] = weight;
    }
    return place;
}

std::vector<CurvePoint> CurvePoints::at(
    const SurfacePolyline& line, const SplineData* spline, std::span<const double> distances
) const {
    const MeasuredLine measured(line);
    const std::optional<CurveSpline> smooth =
        spline != nullptr && line.parameters.size() == line.points.size() ? CurveSpline::of(*spline)
                                                                          : std::nullopt;
    std::vector<CurvePoint> points;
    for (const double distance : distances) {
        checkOnCurve(distance, measured.length(), line.closed);
        const auto [segment, share] = measured.placeAt(distance);
        const SurfacePoint& from = line.surfacePoints[segment];
        const SurfacePoint& to = line.surfacePoints[measured.after(segment)];
        CurvePoint point;
        point.distance = distance;
        point.place = placeBetween(from, to, share);
        point.position = positionOf(mesh_, point.place);
        const Derivatives along = smooth ? smooth->at(measured.parameterAt(distance))
                                         : alongLine(measured, line.closed, distance);
        point.tangent = unitOrZero(along.tangent);
        Vec3 normal = Vec3::Zero();
        for (int k = 0; k < 3; ++k) {
            normal += point.place.barycentric[k] * normals_[mesh_.faces[point.place.face][k]];
        }
        point.normal = unitOrZero(normal - normal.dot(point.tangent) * point.tangent);
        point.left = point.normal.cross(point.tangent);
        point.curvature = along.bend.norm();
        point.normalCurvature = along.bend.dot(point.normal);
        point.geodesicCurvature = along.bend.dot(point.left);
        points.push_back(point);
    }
    return points;
}

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
// Polylines on coarse meshes are as fair as their splines.
#include "curve_checks.h"
#include "surface/surface_point.h"
#include "surface/triangle_tree.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <set>
#include <tuple>
#include <utility>

namespace bspline_curve {
namespace {

using namespace test_support;

constexpr int kPlaces = 400;

// ---- Meshes ----

// A torus with bumps.
TriangleMesh bumpyTorus(int majorSegments, int minorSegments) {
    TriangleMesh mesh = torus(majorSegments, minorSegments);
    for (Vec3& p : mesh.vertices) {
        const double around = std::atan2(p.y(), p.x());
        const Vec3 ring(std::cos(around), std::sin(around), 0.0);
        const Vec3 out = (p - ring).normalized();
        const double across = std::atan2(out.z(), out.dot(ring));
        p += 0.04 * std::sin(6.0 * around) * std::cos(2.0 * across) * out;
    }
    return mesh;
}

Vec3 areaOf(const TriangleMesh& mesh, const Triangle& face) {
    const Vec3& origin = mesh.vertices[face[0]];
    return (mesh.vertices[face[1]] - origin).cross(mesh.vertices[face[2]] - origin);
}

// Collapses an edge to its middle. False where this would turn a face by 25 degrees or more, or
// leave no manifold: `common` are the vertices that are neighbours of both ends.
bool collapse(TriangleMesh& mesh, int kept, int gone, std::size_t common) {
    if (common != 2) {
        return false;
    }
    TriangleMesh changed{mesh.vertices, {}};
    changed.vertices[kept] = 0.5 * (mesh.vertices[kept] + mesh.vertices[gone]);
    for (Triangle face : mesh.faces) {
        const Vec3 before = areaOf(mesh, face);
        const auto hits =
            std::ranges::count_if(face, [&](int v) { return v == kept || v == gone; });
        if (hits == 2) {
            continue;
        }
        std::ranges::replace(face, gone, kept);
        const Vec3 after = areaOf(changed, face);
        if (after.dot(before) < 0.9 * after.norm() * before.norm()) {
            return false;
        }
        changed.faces.push_back(face);
    }
    mesh = std::move(changed);
    return true;
}

// The same with the shortest edge for which that is possible. False where there is none.
bool collapseShortest(TriangleMesh& mesh) {
    std::vector<std::set<int>> neighbours(mesh.vertices.size());
    for (const Triangle& face : mesh.faces) {
        for (int k = 0; k < 3; ++k) {
            neighbours[face[k]].insert({face[(k + 1) % 3], face[(k + 2) % 3]});
        }
    }
    std::vector<std::tuple<double, int, int>> edges;
    for (int a = 0; a < static_cast<int>(neighbours.size()); ++a) {
        for (const int b : neighbours[a]) {
            if (a < b) {
                edges.emplace_back((mesh.vertices[a] - mesh.vertices[b]).norm(), a, b);
            }
        }
    }
    std::ranges::sort(edges);
    return std::ranges::any_of(edges, [&](const auto& edge) {
        const auto& [length, a, b] = edge;
        std::vector<int> common;
        std::ranges::set_intersection(neighbours[a], neighbours[b], std::back_inserter(common));
        return collapse(mesh, a, b, common.size());
    });
}

TriangleMesh decimated(TriangleMesh mesh, std::size_t faces) {
    while (mesh.faces.size() > faces && collapseShortest(mesh)) {
    }
    return mesh;
}

// ---- Measures ----

// Length times the integral of the squared geodesic curvature, of so many points evenly spaced by
// arc length, with the normals of the vertices, by areas, interpolated.
double bendingOf(const TriangleMesh& mesh, std::vector<Vec3> line, bool closed) {
    if (closed) {
        line.push_back(line.front());
    }
    std::vector<double> arc{0.0};
    for (std::size_t i = 1; i < line.size(); ++i) {
        arc.push_back(arc.back() + (line[i] - line[i - 1]).norm());
    }
    const double step = arc.back() / kPlaces;
    std::vector<Vec3> places;
    std::size_t next = 1;
    for (int i = 0; i <= kPlaces; ++i) {
        while (next + 1 < line.size() && arc[next] < i * step) {
            ++next;
        }
        const double share = (i * step - arc[next - 1]) / (arc[next] - arc[next - 1]);
        places.emplace_back((1.0 - share) * line[next - 1] + share * line[next]);
    }
    const TriangleTree tree(mesh.vertices, mesh.faces);
    std::vector<Vec3> normals(mesh.vertices.size(), Vec3::Zero());
    for (const Triangle& face : mesh.faces) {
        for (const int v : face) {
            normals[v] += areaOf(mesh, face);
        }
    }
    double sum = 0.0;
    for (int i = closed ? 0 : 1; i < kPlaces; ++i) {
        const auto found = tree.closestPoint(places[i]);
        Vec3 normal = Vec3::Zero();
        for (int k = 0; k < 3; ++k) {
            normal +=
                found.point.barycentric[k] * normals[mesh.faces[found.point.face][k]].normalized();
        }
        const Vec3 behind = places[i] - places[i > 0 ? i - 1 : kPlaces - 1];
        const Vec3 ahead = places[i + 1] - places[i];
        const Vec3 along = (ahead + behind).normalized();
        const double turn = (ahead - behind).dot(normal.normalized().cross(along)) / step;
        sum += turn * turn;
    }
    return kPlaces * sum;
}

double bendingOf(const TriangleMesh& mesh, const SplineData& spline, bool closed) {
    constexpr int kDense = 2000;
    std::vector<Vec3> points;
    for (int i = 0; i < kDense + (closed ? 0 : 1); ++i) {
        points.push_back(pointOfSpline(spline, static_cast<double>(i) / kDense));
    }
    return bendingOf(mesh, std::move(points), closed);
}

// By how many degrees a polyline turns to and fro within one face at most: the sum of its turns in
// a run of segments there, less the turn from the first to the last.
double worstStair(const Surface& surface, const SurfacePolyline& line) {
    double worst = 0.0;
    double all = 0.0;
    double net = 0.0;
    const auto faceOf = [&](std::size_t i) {
        return commonFace(surface, line.surfacePoints[i], line.surfacePoints[i + 1]);
    };
    for (std::size_t i = 1; i + 1 < line.points.size(); ++i) {
        const Vec3 before = line.points[i] - line.points[i - 1];
        const Vec3 after = line.points[i + 1] - line.points[i];
        if (faceOf(i) != faceOf(i - 1)) {
            all = net = 0.0;
            continue;
        }
        const Vec3 normal = surface.faceNormal(faceOf(i));
        const double turn = std::atan2(normal.dot(before.cross(after)), before.dot(after));
        all += std::abs(turn);
        net += turn;
        worst = std::max(worst, all - std::abs(net));
    }
    return worst * 180.0 / std::numbers::pi;
}

// ---- Tests ----

struct CoarseCase {
    std::string name;
    TriangleMesh mesh;
    double radius, height;  // about the z axis and along it, of the curves
};

std::ostream& operator<<(std::ostream& stream, const CoarseCase& coarse) {
    return stream << coarse.name;
}

class FairedShadows : public testing::TestWithParam<CoarseCase> {
protected:
    // In faces along a gentle wave about the z axis, so that curves bend little themselves.
    [[nodiscard]] std::vector<Vec3> picks(std::uint64_t seed) const {
        Random random(seed);
        const double start = random.uniform(0.0, 2.0 * std::numbers::pi);
        std::vector<Vec3> points;
        for (int i = 0; i < 4; ++i) {
            const double angle = start + 1.3 * i;
            const Vec3 wanted(
                GetParam().radius * std::cos(angle),
                GetParam().radius * std::sin(angle),
                GetParam().height + 0.05 * random.uniform(-1.0, 1.0)
            );
            const auto inside = [&](const Triangle& face) -> Vec3 {
                return 0.5 * mesh_.vertices[face[0]] + 0.3 * mesh_.vertices[face[1]] +
                       0.2 * mesh_.vertices[face[2]];
            };
            const auto nearest = std::ranges::min_element(mesh_.faces, {}, [&](const auto& face) {
                return (inside(face) - wanted).squaredNorm();
            });
            points.push_back(inside(*nearest));
        }
        return points;
    }

    TriangleMesh mesh_ = GetParam().mesh;
    CurveDesigner designer_{mesh_};
};

TEST_P(FairedShadows, BendAsMuchAsTheirSplines) {
    double logarithms = 0.0;
    int count = 0;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        for (const bool closed : {false, true}) {
            SCOPED_TRACE("seed " + std::to_string(seed) + (closed ? ", closed" : ", open"));
            const Curve curve = goodCurve(designer_, picks(seed), {.closed = closed});
            const double ofSpline = bendingOf(mesh_, curve.spline, closed);
            const double ratio = bendingOf(mesh_, curve.polyline.points, closed) / ofSpline;
            EXPECT_LT(ratio, 1.3);
            logarithms += std::log(ratio);
            ++count;
        }
    }
    EXPECT_LT(std::exp(logarithms / count), 1.15);
}

TEST_P(FairedShadows, HaveNoStairInAFace) {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const Curve curve = goodCurve(designer_, picks(seed));
        // Feet along fibres make stairs of over a degree.
        EXPECT_LT(worstStair(designer_.surface(), curve.polyline), 0.5);
    }
}

TEST_P(FairedShadows, StayWithinTheDistanceTolerance) {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const Curve curve = goodCurve(designer_, picks(seed));
        const double allowed = curve.report.allowedDistance * curve.report.meanEdgeLength;
        for (std::size_t i = 0; i < curve.polyline.points.size(); ++i) {
            const Vec3 p = pointOfSpline(curve.spline, curve.polyline.parameters[i]);
            EXPECT_LE((p - curve.polyline.points[i]).norm(), allowed) << "vertex " << i;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
    Coarse,
    FairedShadows,
    testing::Values(
        CoarseCase{"Sphere", withNoise(icosphere(2), 0.03, 7), 0.95, 0.3},
        CoarseCase{"BumpyTorus", decimated(bumpyTorus(60, 24), 1500), 1.28, 0.1}
    ),
    [](const auto& instance) { return instance.param.name; }
);

// Where the surface is plane, feet are fair as they are.
TEST(FairedShadow, LeavesACurveOnAPlaneAsItIs) {
    const CurveDesigner designer(jitteredPlate(12, 12, 0.2, 5));
    const Curve curve =
        goodCurve(designer, {Vec3(0.1, 0.1, 0.0), Vec3(0.5, 0.8, 0.0), Vec3(0.9, 0.2, 0.0)});
    for (std::size_t i = 0; i < curve.polyline.points.size(); ++i) {
        const Vec3 p = pointOfSpline(curve.spline, curve.polyline.parameters[i]);
        EXPECT_LT((p - curve.polyline.points[i]).norm(), 1e-9) << "vertex " << i;
    }
}

}  // namespace
}  // namespace bspline_curve

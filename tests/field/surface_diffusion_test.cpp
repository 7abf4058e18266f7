// SPDX-License-Identifier: GPL-3.0-or-later
#include "field/surface_diffusion.h"

#include "support/meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

/// A third of the area of the faces at each vertex.
Eigen::VectorXd massesOf(const Surface& surface) {
    Eigen::VectorXd masses = Eigen::VectorXd::Zero(surface.vertexCount());
    for (const Triangle& face : surface.faces()) {
        const Vec3& a = surface.vertices()[face[0]];
        const Vec3& b = surface.vertices()[face[1]];
        const Vec3& c = surface.vertices()[face[2]];
        for (const int corner : face) {
            masses[corner] += (b - a).cross(c - a).norm() / 6.0;
        }
    }
    return masses;
}

VertexValues<1> spikeIn(const Surface& surface, int vertex) {
    VertexValues<1> values = VertexValues<1>::Zero(surface.vertexCount());
    values[vertex] = 1.0;
    return values;
}

/// Nine columns of one value per vertex.
VertexValues<9> wavesOn(const Surface& surface) {
    return VertexValues<9>::NullaryExpr(
        surface.vertexCount(), 9, [](Eigen::Index v, Eigen::Index k) {
            return std::sin(static_cast<double>(v * (k + 1)));
        }
    );
}

TEST(SurfaceDiffusion, KeepsConstantsAndIntegrals) {
    const Surface surface(withNoise(icosphere(3), 0.02, 1));
    const SurfaceDiffusion diffusion(surface);
    const VertexValues<1> constant = VertexValues<1>::Constant(surface.vertexCount(), 7.0);
    EXPECT_LT((diffusion.smoothed<1>(constant, 0.3) - constant).cwiseAbs().maxCoeff(), 1e-9);
    const Eigen::VectorXd masses = massesOf(surface);
    const VertexValues<1> spike = spikeIn(surface, 17);
    EXPECT_NEAR(masses.dot(diffusion.smoothed<1>(spike, 0.3)), masses[17], 1e-4 * masses[17]);
}

// The variance of a disc: a spike's second moment about itself is radius^2 / 2 on a plane, exact
// for linear elements with lumped masses up to what the boundary cuts off.
TEST(SurfaceDiffusion, AveragesAsOverADisc) {
    const TriangleMesh mesh = plate(80, 80);
    const Surface surface(mesh);
    const int centre = 40 * 81 + 40;
    const Eigen::VectorXd masses = massesOf(surface);
    for (const double radius : {0.05, 0.1, 0.2}) {
        const VertexValues<1> smooth =
            SurfaceDiffusion(surface).smoothed<1>(spikeIn(surface, centre), radius);
        double moment = 0.0;
        for (int v = 0; v < surface.vertexCount(); ++v) {
            const Vec3 offset = mesh.vertices[v] - Vec3(0.5, 0.5, 0.0);
            moment += masses[v] * smooth[v] * offset.squaredNorm();
        }
        EXPECT_NEAR(moment / masses[centre], 0.5 * radius * radius, 0.01 * radius * radius);
    }
}

// No new extrema, also with obtuse faces.
TEST(SurfaceDiffusion, StaysBetweenTheValues) {
    const Surface surface(jitteredPlate(30, 6, 0.29, 2));
    const VertexValues<1> smooth = SurfaceDiffusion(surface).smoothed<1>(spikeIn(surface, 60), 0.1);
    EXPECT_GE(smooth.minCoeff(), -1e-6);
    EXPECT_LE(smooth.maxCoeff(), 1.0);
    EXPECT_LT(smooth[60], 0.5);
}

// On as many vertices as two threads share.
TEST(SurfaceDiffusion, IsTheSameEveryTimeOnTwoThreads) {
    const Surface surface(withNoise(icosphere(6), 0.001, 4));
    ASSERT_GT(surface.vertexCount(), 40000);
    const SurfaceDiffusion diffusion(surface);
    const VertexValues<9> values = wavesOn(surface);
    const VertexValues<9> first = diffusion.smoothed<9>(values, 0.1);
    for (int run = 0; run < 5; ++run) {
        ASSERT_EQ(diffusion.smoothed<9>(values, 0.1), first) << run;
    }
    const VertexValues<1> alone = diffusion.smoothed<1>(values.col(4), 0.1);
    EXPECT_LT((first.col(4) - alone).cwiseAbs().maxCoeff(), 1e-12);
}

// Rows lie in another order than vertices, and in the same one whatever that of the vertices is.
// Rounding differs after scaling. It must not choose which edges are strong.
TEST(SurfaceDiffusion, IsTheSameAtEachScale) {
    TriangleMesh mesh = plate(40, 40);
    const VertexValues<9> values = wavesOn(Surface(mesh));
    const VertexValues<9> large = SurfaceDiffusion(Surface(mesh)).smoothed<9>(values, 0.05);
    for (Vec3& vertex : mesh.vertices) {
        vertex *= 1e-3;
    }
    const VertexValues<9> small = SurfaceDiffusion(Surface(mesh)).smoothed<9>(values, 0.05e-3);
    EXPECT_LT((small - large).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(SurfaceDiffusion, GivesEachVertexItsOwnValue) {
    const TriangleMesh mesh = withNoise(icosphere(3), 0.02, 1);
    const auto smoothed = [](const TriangleMesh& one) {
        const Surface surface(one);
        VertexValues<1> heights(surface.vertexCount());
        for (int v = 0; v < surface.vertexCount(); ++v) {
            heights[v] = one.vertices[v].z();
        }
        return SurfaceDiffusion(surface).smoothed<1>(heights, 0.3);
    };
    const VertexValues<1> values = smoothed(mesh);
    std::map<double, double> ofHeight;
    for (int v = 0; v < static_cast<int>(values.size()); ++v) {
        const double height = mesh.vertices[v].z();
        EXPECT_NEAR(values[v], height, 0.05);
        ofHeight[height] = values[v];
    }
    const TriangleMesh other = renumbered(mesh, 7);
    const VertexValues<1> otherValues = smoothed(other);
    for (int v = 0; v < static_cast<int>(otherValues.size()); ++v) {
        const double height = other.vertices[v].z();
        EXPECT_NEAR(otherValues[v], ofHeight.at(height), 1e-12);
    }
}

TEST(SurfaceDiffusion, TreatsColumnsAlikeAndLeavesWhatHasNoFaces) {
    TriangleMesh mesh = joined(icosphere(2), plate(5, 5));
    mesh.vertices.emplace_back(9, 9, 9);
    const Surface surface(mesh);
    const SurfaceDiffusion diffusion(surface);
    const VertexValues<9> values = wavesOn(surface);
    const VertexValues<9> smooth = diffusion.smoothed<9>(values, 0.2);
    for (int k = 0; k < 9; ++k) {
        const VertexValues<1> alone = diffusion.smoothed<1>(values.col(k), 0.2);
        EXPECT_LT((smooth.col(k) - alone).cwiseAbs().maxCoeff(), 1e-12) << k;
    }
    EXPECT_EQ(smooth.row(surface.vertexCount() - 1), values.row(surface.vertexCount() - 1));
    EXPECT_EQ(diffusion.smoothed<9>(values, 0.0), values);
}

// Parts that are much less than the disc have their mean, however small, and the others what they
// have alone.
TEST(SurfaceDiffusion, GivesSmallPartsTheirMean) {
    const TriangleMesh large = plate(20, 20);
    TriangleMesh mesh = large;
    for (int i = 0; i < 40; ++i) {
        TriangleMesh grain = withNoise(icosphere(1), 0.1, 100 + i);
        for (Vec3& vertex : grain.vertices) {
            vertex = std::pow(10.0, -2 - i / 8) * vertex + Vec3(0.02 * i, 0.5, 1.0);
        }
        mesh = joined(mesh, grain);
    }
    const Surface surface(mesh);
    const VertexValues<9> values = wavesOn(surface);
    const VertexValues<9> smooth = SurfaceDiffusion(surface).smoothed<9>(values, 0.2);
    const Eigen::VectorXd masses = massesOf(surface);
    const auto plateSize = static_cast<Eigen::Index>(large.vertices.size());
    const auto grainSize = static_cast<Eigen::Index>(icosphere(1).vertices.size());
    for (Eigen::Index first = plateSize; first < smooth.rows(); first += grainSize) {
        const Eigen::VectorXd weights =
            masses.segment(first, grainSize) / masses.segment(first, grainSize).sum();
        const Eigen::RowVectorXd mean = weights.transpose() * values.middleRows(first, grainSize);
        for (Eigen::Index v = first; v < first + grainSize; ++v) {
            EXPECT_LT((smooth.row(v) - mean).cwiseAbs().maxCoeff(), 1e-3) << v;
        }
    }
    const VertexValues<9> alone =
        SurfaceDiffusion(Surface(large)).smoothed<9>(values.topRows(plateSize), 0.2);
    EXPECT_LT((smooth.topRows(plateSize) - alone).cwiseAbs().maxCoeff(), 1e-4);
}

TEST(SurfaceDiffusion, ReportsWhileItIsPrepared) {
    const Surface surface(openCylinder(400, 200));
    std::vector<double> shares;
    const SurfaceDiffusion diffusion(surface, [&](double share, const char*) {
        shares.push_back(share);
        return true;
    });
    EXPECT_GT(shares.size(), 5);
    EXPECT_TRUE(std::ranges::is_sorted(shares));
    for (std::size_t last = 0; last < shares.size(); ++last) {
        std::size_t reports = 0;
        const auto stop = [&](double, const char*) { return reports++ < last; };
        EXPECT_THROW(SurfaceDiffusion(surface, stop), Cancelled) << last;
    }
}

/// How often smoothing reports: once for each iteration of its steps.
int reportsOf(const Surface& surface, double radius) {
    int reports = 0;
    static_cast<void>(SurfaceDiffusion(surface).smoothed<1>(
        spikeIn(surface, 0), radius, [&](double, const char*) { return ++reports > 0; }
    ));
    return reports;
}

// Of slivers each edge around the cylinder outweighs all along it.
TEST(SurfaceDiffusion, TakesFewIterationsOnSlivers) {
    EXPECT_LT(reportsOf(Surface(renumbered(openCylinder(3000, 8), 3)), 0.3), 30);
    EXPECT_LT(reportsOf(Surface(renumbered(openCylinder(2000, 2), 3)), 1.0), 40);
}

}  // namespace
}  // namespace bspline_curve

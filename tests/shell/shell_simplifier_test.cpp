// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/shell_simplifier.h"

#include "bspline_curve/error.h"
#include "built_shell.h"
#include "support/meshes.h"
#include "support/seeds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

// ---- Valid on every kind of surface ----

/// Further properties that only simplified shells may trip over.
std::vector<NamedMesh> simplifierMeshes() {
    std::vector<NamedMesh> meshes = shellMeshes();
    Random random(1);
    // Up to 178 degrees between the normals of neighbours: a plate bent like a sheet of cardboard.
    TriangleMesh sharpFold = plate(20, 10);
    for (Vec3& p : sharpFold.vertices) {
        if (p.x() > 0.5) {
            p = Vec3(1.0 - p.x(), p.y(), 0.02 * (p.x() - 0.5));
        }
    }
    // Faces a hundred thousand times as long as high.
    TriangleMesh needles = plate(20, 20, 1.0, 2e-4);
    TriangleMesh genusThree = joined(torus(32, 12), torus(24, 16, 3.0, 0.5));
    meshes.insert(
        meshes.end(),
        {
            {"SharpFold", std::move(sharpFold)},
            {"Needles", std::move(needles)},
            {"LinkedTori", std::move(genusThree)},
            {"PuncturedSphere", withHoles(icosphere(4), 6, random)},
            {"PuncturedTorus", withHoles(torus(48, 24), 8, random)},
            {"LongCylinder", openCylinder(60, 30)},
            {"SphereInSphere", sphereInSphere()},
            {"DenseFoldedSheet", foldedSheet(120, 12, 0.05)},
            {"TwiceSubdividedBox", midpointSubdivide(midpointSubdivide(box(3)))},
        }
    );
    return meshes;
}

class SimplifyShell : public testing::TestWithParam<NamedMesh> {};

TEST_P(SimplifyShell, HoldsAllInvariants) {
    const SimplifiedShell simplified(GetParam().mesh);
    expectWhole(simplified);
    EXPECT_LE(simplified.shell().prisms().size(), simplified.extended.faces.size());
}

INSTANTIATE_TEST_SUITE_P(Meshes, SimplifyShell, testing::ValuesIn(simplifierMeshes()), nameOfParam);

// ---- Components ----

TEST(ShellSimplifier, SwallowsNoComponent) {
    for (const TriangleMesh& mesh :
         {sphereWithSatellite(),
          sphereInSphere(),
          joined(
              midpointSubdivide(midpointSubdivide(sphereWithSatellite())), icosphere(0, 0.001)
          )}) {
        for (const double thickness : {0.05, 0.135, 0.5, 1.0}) {
            SCOPED_TRACE("thickness " + std::to_string(thickness));
            const SimplifiedShell simplified(mesh, {.targetThickness = thickness});
            expectValid(simplified.check());
        }
    }
}

// ---- Few, thick, along creases ----

// Mean length of the pillars, bottom to top, relative to the longest side of the surface's box.
double meanThickness(const SimplifiedShell& simplified) {
    double total = 0.0;
    for (const Pillar& pillar : simplified.shell().pillars()) {
        total += (pillar.top - pillar.bottom).norm();
    }
    return total / static_cast<double>(simplified.shell().pillars().size()) /
           longestSideOf(simplified.extended);
}

TEST(ShellSimplifier, MakesFewAndThickPrismsOnASmoothSurface) {
    const SimplifiedShell simplified(icosphere(5));
    EXPECT_LT(simplified.shell().prisms().size(), 250U);
    EXPECT_GT(meanThickness(simplified), 0.12);
    EXPECT_LE(meanThickness(simplified), 0.135 * 1.5);
}

TEST(ShellSimplifier, KeepsMiddleEdgesAlongTheCreasesOfABox) {
    const Vec3 lengths(1.0, 0.8, 0.6);
    const SimplifiedShell simplified(box(10, lengths));
    EXPECT_LT(simplified.shell().prisms().size(), 400U);
    const ShellFrame& frame = simplified.extended.frame;
    // How many sides of the box hold a pillar's middle, each as a bit.
    const auto sidesOf = [&](int pillar) {
        const Vec3 p = frame.toUser(simplified.shell().pillars()[pillar].middle);
        unsigned sides = 0;
        for (int k = 0; k < 3; ++k) {
            sides |= static_cast<unsigned>(std::abs(p[k]) < 1e-12) << (2 * k);
            sides |= static_cast<unsigned>(std::abs(p[k] - lengths[k]) < 1e-12) << (2 * k + 1);
        }
        return sides;
    };
    std::set<std::pair<int, int>> creases;
    for (const Prism& prism : simplified.shell().prisms()) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto edge = std::minmax(prism.pillars[k], prism.pillars[(k + 1) % 3]);
            const unsigned common = sidesOf(edge.first) & sidesOf(edge.second);
            if ((common & (common - 1)) != 0) {
                creases.insert(edge);
            }
        }
    }
    double length = 0.0;
    for (const auto& [a, b] : creases) {
        length += frame.scale *
                  (simplified.shell().pillars()[a].middle - simplified.shell().pillars()[b].middle)
                      .norm();
    }
    EXPECT_NEAR(length, 4.0 * lengths.sum(), 1e-9);
}

TEST(ShellSimplifier, LeavesLongEdgesAlone) {
    const double longest = 0.1;
    const SimplifiedShell coarse(icosphere(4));
    const SimplifiedShell fine(icosphere(4), {.targetEdgeLength = longest});
    EXPECT_GT(fine.shell().prisms().size(), 2 * coarse.shell().prisms().size());
    expectValid(fine.check());
}

TEST(ShellSimplifier, MakesPillarsNoLongerThanAskedWhereTheStartIsNot) {
    for (const double thickness : {0.05, 0.135, 0.3}) {
        const SimplifiedShell simplified(icosphere(5), {.targetThickness = thickness});
        for (const Pillar& pillar : simplified.shell().pillars()) {
            const double side = longestSideOf(simplified.extended);
            EXPECT_LE((pillar.top - pillar.bottom).norm(), thickness * side * (1.0 + 1e-9));
        }
    }
}

// ---- Calls ----

std::shared_ptr<const ExtendedSurface> extendedSphere(int subdivisions) {
    return std::make_shared<ExtendedSurface>(extendSurface(Surface(icosphere(subdivisions)), 3));
}

TEST(ShellSimplifier, GivesTheSameShellEachTime) {
    const TriangleMesh mesh = withNoise(torus(48, 24), 0.01, 7);
    const SimplifiedShell first(mesh);
    const SimplifiedShell second(mesh);
    EXPECT_TRUE(areSame(first.shell(), second.shell()));
    const SimplifiedShell other(mesh, {.targetThickness = 0.05});
    EXPECT_FALSE(areSame(first.shell(), other.shell()));
}

// Pairs with the lower face first, both of them blocked.
void expectBlockedPairs(const ShellBuildReport& report) {
    EXPECT_FALSE(report.selfIntersections.empty());
    for (const auto& [f, g] : report.selfIntersections) {
        EXPECT_LT(f, g);
        EXPECT_TRUE(std::ranges::binary_search(report.blockedFaces, f));
        EXPECT_TRUE(std::ranges::binary_search(report.blockedFaces, g));
    }
}

TEST(ShellSimplifier, ReportsBlockedFacesAndSimplifiesTheRest) {
    const TriangleMesh crossing = midpointSubdivide(midpointSubdivide(crossingPlates()));
    const SimplifiedShell simplified(crossing);
    const ShellBuildReport& report = simplified.build.report;
    EXPECT_FALSE(report.blockedFaces.empty());
    EXPECT_TRUE(std::ranges::is_sorted(report.blockedFaces));
    expectBlockedPairs(report);
    EXPECT_EQ(report.blockedFaces, simplified.shell().blockedFaces());
    EXPECT_LT(
        simplified.shell().prisms().size(),
        simplified.extended.faces.size() - report.blockedFaces.size()
    );
    expectValid(simplified.check());
    // The same faces as at full resolution.
    const BuiltShell thin(crossing);
    EXPECT_EQ(report.blockedFaces, thin.blockedFaces());
    EXPECT_EQ(report.selfIntersections, thin.build.report.selfIntersections);
}

TEST(ShellSimplifier, ReportsFractionsThatNeverFall) {
    const auto extended = extendedSphere(4);
    std::vector<double> fractions;
    static_cast<void>(buildSimplifiedShell(extended, {}, [&](double fraction, const char* stage) {
        EXPECT_NE(stage, nullptr);
        fractions.push_back(fraction);
        return true;
    }));
    EXPECT_GT(fractions.size(), 5U);
    EXPECT_TRUE(std::ranges::is_sorted(fractions));
    EXPECT_GE(fractions.front(), 0.0);
    EXPECT_EQ(fractions.back(), 1.0);
}

TEST(ShellSimplifier, StopsWhereverItIsCancelled) {
    const auto extended = extendedSphere(4);
    // How many calls there are until one of them asks to stop, and whether that was done.
    const auto buildUntil = [&](int last) {
        int calls = 0;
        try {
            static_cast<void>(buildSimplifiedShell(extended, {}, [&](double, const char*) {
                return ++calls != last;
            }));
        } catch (const Cancelled&) {
            return std::pair(calls, true);
        }
        return std::pair(calls, false);
    };
    const auto [calls, wasCancelled] = buildUntil(-1);
    EXPECT_FALSE(wasCancelled);
    for (const int last : {1, 2, calls / 2, calls}) {
        EXPECT_EQ(buildUntil(last), std::pair(last, true));
    }
}

TEST(ShellSimplifier, RefusesOptionsOutOfRange) {
    const auto extended = extendedSphere(1);
    const auto refuses = [&](const ShellOptions& options) {
        try {
            static_cast<void>(buildSimplifiedShell(extended, options));
            return false;
        } catch (const InputError& error) {
            return error.code() == InputErrorCode::BadOption;
        }
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double bad : {0.0, -0.1, 1.1, nan}) {
        EXPECT_TRUE(refuses({.targetThickness = bad})) << bad;
        EXPECT_TRUE(refuses({.targetEdgeLength = bad})) << bad;
    }
    EXPECT_TRUE(refuses({.smoothingPasses = -1}));
    EXPECT_FALSE(refuses({.targetThickness = 1.0, .targetEdgeLength = 1.0}));
}

TEST(ShellSimplifier, BuildsTheKindThatTheOptionsName) {
    const auto extended = extendedSphere(2);
    EXPECT_TRUE(makeShell(extended, {.kind = ShellKind::FullResolution}).shell.isFullResolution());
    EXPECT_FALSE(makeShell(extended, {.kind = ShellKind::Simplified}).shell.isFullResolution());
}

}  // namespace
}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/band_shell.h"

#include "built_shell.h"
#include "random_mesh.h"
#include "shell/check_shell.h"
#include "shell/shell_cell.h"
#include "support/meshes.h"
#include "support/random.h"
#include "surface/index_sets.h"
#include "surface/input_error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <ostream>
#include <string>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

std::vector<int> allFaces(const Surface& surface) {
    std::vector<int> faces(at(surface.faceCount()));
    std::iota(faces.begin(), faces.end(), 0);
    return faces;
}

ShellCheck checkOf(const BandShell& built) {
    return checkShell(
        built.band.surface, *built.base, built.build.shell, built.build.report.blockedFaces
    );
}

// ---- Valid on every kind of band ----

struct BandCase {
    std::string name;
    TriangleMesh mesh;
    std::vector<int> path;
    int count;
};

std::ostream& operator<<(std::ostream& stream, const BandCase& band) {
    return stream << band.name;
}

// The faces whose centres are within a box.
std::vector<int> facesWithin(const TriangleMesh& mesh, const Vec3& low, const Vec3& high) {
    std::vector<int> faces;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        const Triangle& t = mesh.faces[f];
        const Vec3 centre =
            (mesh.vertices[at(t[0])] + mesh.vertices[at(t[1])] + mesh.vertices[at(t[2])]) / 3.0;
        if ((centre.array() >= low.array()).all() && (centre.array() <= high.array()).all()) {
            faces.push_back(static_cast<int>(f));
        }
    }
    return faces;
}

std::vector<BandCase> bandCases() {
    const TriangleMesh ring = torus(48, 24);
    const TriangleMesh bumpy = withNoise(icosphere(4), 0.01, 1);
    const TriangleMesh sheet = withNoise(plate(40, 40), 0.003, 2);
    const TriangleMesh apart = joined(icosphere(3), torus(32, 16, 3.0, 0.5));
    return {
        {"OneFace", icosphere(2), {5}, 1},
        {"Patch", bumpy, {17}, 300},
        {"NearlyAll", icosphere(3), {17}, 1270},
        {"All", icosphere(3), {17}, 5000},
        {"AlongTheBoundary", sheet, facesWithin(sheet, {0, -1, -1}, {1, 0.02, 1}), 400},
        {"AcrossFromBoundaryToBoundary",
         sheet,
         facesWithin(sheet, {0.45, -1, -1}, {0.55, 2, 1}),
         500},
        {"OneFaceOfTwoComponents", apart, {3, 2000}, 400},
        {"RoundAHandle", ring, facesWithin(ring, {0, -0.1, -1}, {2, 0.1, 1}), 300},
        {"RoundTheAxis", ring, facesWithin(ring, {-2, -2, 0.25}, {2, 2, 1}), 700},
        {"OverACrease", box(16), facesWithin(box(16), {0.4, 0.9, -1}, {0.6, 2, 2}), 200},
        {"TouchingItself", plate(24, 24), {100, 500, 510, 900}, 300},
    };
}

class BandShellOf : public testing::TestWithParam<BandCase> {
protected:
    void expectValid(ShellKind kind) const {
        const Surface whole(GetParam().mesh);
        const std::vector<int> faces = facesNear(whole, GetParam().path, GetParam().count);
        const BandShell built = buildBandShell(whole, faces, {.kind = kind});
        const ShellCheck check = checkOf(built);
        EXPECT_TRUE(check.passed()) << describe(check);
        EXPECT_TRUE(built.build.report.blockedFaces.empty());
        expectShadowsOnTheBandOnly(built);
    }

    // Points of the band are their own shadows; those beyond the rim have theirs on no face of it.
    static void expectShadowsOnTheBandOnly(const BandShell& built) {
        const Shell& shell = built.build.shell;
        const Vec3 inner(0.2, 0.5, 0.3);
        for (int f = 0; f < static_cast<int>(built.base->faces.size()); ++f) {
            const bool isBeyond = f >= built.band.surface.faceCount();
            if (isBeyond && shell.isBlocked(f)) {
                continue;
            }
            const SurfacePoint point{f, inner};
            const ShellCell cell(shell, point);
            ASSERT_EQ(cell.face, f);
            ASSERT_EQ(shell.isGhost(cell.face), isBeyond);
            const Vec3 shadow = cell.shadow(built.base->position(point));
            ASSERT_LT((shadow - inner).norm(), 1e-6) << "face " << f;
        }
    }
};

TEST_P(BandShellOf, IsValidAtFullResolution) {
    expectValid(ShellKind::FullResolution);
}

TEST_P(BandShellOf, IsValidSimplified) {
    expectValid(ShellKind::Simplified);
}

INSTANTIATE_TEST_SUITE_P(
    Bands, BandShellOf, testing::ValuesIn(bandCases()), [](const auto& instance) {
        return instance.param.name;
    }
);

TEST(BandShell, IsValidAroundRandomPathsOnRandomMeshes) {
    for (std::uint64_t seed = 1; seed <= 16; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const Surface whole(randomMesh(kRandomKinds[seed % kRandomKinds.size()], seed));
        std::vector<int> path;
        for (int i = random.integer(1, 5); i > 0; --i) {
            path.push_back(random.integer(0, whole.faceCount() - 1));
        }
        const std::vector<int> faces = facesNear(whole, path, random.integer(1, 1500));
        for (const ShellKind kind : {ShellKind::FullResolution, ShellKind::Simplified}) {
            const ShellCheck check = checkOf(buildBandShell(whole, faces, {.kind = kind}));
            EXPECT_TRUE(check.passed()) << describe(check);
        }
    }
}

TEST(BandShell, IsValidAroundFacesChosenAtRandom) {
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const Surface whole(withNoise(icosphere(3), 0.01, seed));
        std::vector<int> faces = {0};
        for (const int face : allFaces(whole)) {
            if (random.uniform(0.0, 1.0) < 0.1 * static_cast<double>(seed)) {
                faces.push_back(face);
            }
        }
        for (const ShellKind kind : {ShellKind::FullResolution, ShellKind::Simplified}) {
            const BandShell built = buildBandShell(whole, faces, {.kind = kind});
            const ShellCheck check = checkOf(built);
            EXPECT_TRUE(check.passed()) << describe(check);
            // Ghosts in notches are given up before the pillars next to them are needles.
            EXPECT_LT(built.build.report.intersectionRounds, 15);
        }
    }
}

// ---- As the whole surface has it ----

TEST(BandShell, HasTheDirectionsAndLengthsOfTheWholeSurfaceAwayFromTheRim) {
    const int passes = 2;
    const Surface whole(withNoise(torus(48, 24), 0.01, 5));
    const ShellBase base = makeShellBase(whole, passes);
    const std::vector<int> path = {1000, 1001, 1002};
    const BandShell built =
        buildBandShell(whole, facesNear(whole, path, 800), {.smoothingPasses = passes});
    EXPECT_EQ(built.base->frame.centre, base.frame.centre);
    EXPECT_EQ(built.base->frame.scale, base.frame.scale);
    // The rim is farther away from these than smoothing reaches.
    std::vector<int> inner;
    for (const int f : facesNear(whole, path, 120)) {
        const Triangle& face = whole.faces()[at(f)];
        inner.insert(inner.end(), face.begin(), face.end());
    }
    for (const int there : inner) {
        const auto v = at(indexIn(built.band.vertices, there));
        EXPECT_EQ(built.base->vertices[v], base.vertices[at(there)]);
        EXPECT_EQ(built.base->directions[v], base.directions[at(there)]);
        EXPECT_EQ(built.base->edgeLengths[v], base.edgeLengths[at(there)]);
    }
}

TEST(BandShell, OfAllFacesIsTheShellOfTheSurface) {
    const TriangleMesh mesh = withNoise(openCylinder(24, 8), 0.01, 4);
    const Surface whole(mesh);
    const BandShell built = buildBandShell(whole, allFaces(whole), {.kind = ShellKind::Simplified});
    const SimplifiedShell direct(mesh);
    ASSERT_EQ(built.build.shell.pillars().size(), direct.shell().pillars().size());
    for (std::size_t i = 0; i < direct.shell().pillars().size(); ++i) {
        EXPECT_EQ(built.build.shell.pillars()[i].bottom, direct.shell().pillars()[i].bottom);
        EXPECT_EQ(built.build.shell.pillars()[i].top, direct.shell().pillars()[i].top);
    }
    EXPECT_EQ(built.build.shell.tracks().faces, direct.shell().tracks().faces);
}

TEST(BandShell, IsAsThickAsAskedRelativeToTheWholeSurface) {
    const Surface whole(icosphere(5));
    const BandShell built = buildBandShell(
        whole,
        facesNear(whole, std::vector<int>{0}, 3000),
        {.kind = ShellKind::Simplified, .targetThickness = 0.1}
    );
    const double asked = 0.1 * longestSideOf(whole) / built.base->frame.scale;
    double longest = 0.0;
    for (const Pillar& pillar : built.build.shell.pillars()) {
        longest = std::max(longest, (pillar.top - pillar.bottom).norm());
    }
    EXPECT_NEAR(longest, asked, 1e-9);
}

// ---- Calls ----

TEST(BandShell, RefusesBadFacesAndOptions) {
    const Surface whole(icosphere(1));
    const auto refuses =
        [&](const std::vector<int>& faces, const ShellOptions& options, InputErrorCode code) {
            try {
                static_cast<void>(buildBandShell(whole, faces, options));
                return false;
            } catch (const InputError& error) {
                return error.code() == code;
            }
        };
    EXPECT_TRUE(refuses({}, {}, InputErrorCode::EmptyMesh));
    EXPECT_TRUE(refuses({80}, {}, InputErrorCode::IndexOutOfRange));
    EXPECT_TRUE(refuses({0}, {.targetThickness = 1.5}, InputErrorCode::BadOption));
    EXPECT_TRUE(refuses({0}, {.targetEdgeLength = 0.0}, InputErrorCode::BadOption));
}

TEST(BandShell, StopsWhereItIsCancelled) {
    const Surface whole(icosphere(3));
    EXPECT_THROW(
        static_cast<void>(buildBandShell(
            whole,
            facesNear(whole, std::vector<int>{0}, 300),
            {.kind = ShellKind::Simplified},
            [](double, const char*) { return false; }
        )),
        Cancelled
    );
}

}  // namespace
}  // namespace bspline_curve

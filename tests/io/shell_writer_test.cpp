// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/shell_writer.h"

#include "io/base64.h"
#include "io/json_values.h"
#include "io/shell_cells.h"
#include "io/shell_measures.h"
#include "io/temporary_files.h"
#include "support/meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <locale>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace bspline_curve::io_tests {

namespace {

struct Built {
    explicit Built(TriangleMesh mesh)
        : surface(std::move(mesh)),
          extended(extendSurface(surface, 3)),
          build(buildShell(extended, {})) {}

    [[nodiscard]] ShellCells cells() const { return makeShellCells(build.shell, extended.frame); }

    Surface surface;
    ExtendedSurface extended;
    ShellBuild build;
};

double volume(const ShellCells& cells, const std::array<int, 4>& tet) {
    const auto point = [&](std::size_t k) { return cells.points[tet[k]]; };
    return (point(1) - point(0)).cross(point(2) - point(0)).dot(point(3) - point(0)) / 6.0;
}

/// In how many tetrahedra each triangle is a face.
std::map<std::array<int, 3>, int> usesOfFaces(const ShellCells& cells) {
    std::map<std::array<int, 3>, int> uses;
    for (const auto& tet : cells.tetrahedra) {
        for (std::size_t k = 0; k < 4; ++k) {
            std::array<int, 3> face = {tet[(k + 1) % 4], tet[(k + 2) % 4], tet[(k + 3) % 4]};
            std::ranges::sort(face);
            ++uses[face];
        }
    }
    return uses;
}

/// Corners of a face's triangle in a layer (0 top, 1 middle, 2 bottom), and their sum.
struct LayerCorners {
    LayerCorners(const ShellCells& cells, std::size_t face, std::size_t layer)
        : heights(), sum(Vec3::Zero()) {
        for (std::size_t k = 0; k < 3; ++k) {
            const int point = cells.layers[3 * face + layer][k];
            heights[k] = ShellCells::height(point);
            sum += cells.points[point];
        }
    }

    Triangle heights;
    Vec3 sum;
};

/// One prism per pair of pillars given: the square [0, 2] x [0, 1] with pillars of two lengths.
Shell twoPrisms(double left, double right) {
    const auto pillar = [&](double x, double y, double length) {
        return Pillar{{x, y, -0.5 * length}, {x, y, 0.0}, {x, y, 0.5 * length}};
    };
    const std::vector<Pillar> pillars = {
        pillar(0, 0, left), pillar(0, 1, left), pillar(2, 0, right), pillar(2, 1, right)
    };
    Prism first;
    first.pillars = {0, 1, 2};
    first.neighbours = {1, -1, -1};
    first.orientation = -1;
    Prism second;
    second.pillars = {1, 2, 3};
    second.neighbours = {-1, -1, 0};
    second.orientation = -1;
    return {pillars, {first, second}, 2};
}

Surface twoByOne() {
    return Surface({{{0, 0, 0}, {0, 1, 0}, {2, 0, 0}, {2, 1, 0}}, {{0, 2, 1}, {1, 2, 3}}});
}

/// A locale that writes 1.5 as 1,5 and 1000 as 1.000.
class CommaLocale {
public:
    CommaLocale() : before_(std::locale::global(std::locale(std::locale(), new Comma))) {}

    ~CommaLocale() { std::locale::global(before_); }

    CommaLocale(const CommaLocale&) = delete;
    CommaLocale& operator=(const CommaLocale&) = delete;

private:
    struct Comma : std::numpunct<char> {
        [[nodiscard]] char do_decimal_point() const override { return ','; }

        [[nodiscard]] char do_thousands_sep() const override { return '.'; }

        [[nodiscard]] std::string do_grouping() const override { return "\3"; }
    };

    std::locale before_;
};

}  // namespace

TEST(Base64, WritesTheExamplesOfItsStandard) {
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foo"), "Zm9v");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
    EXPECT_EQ(base64(std::string("\0\xff\xfe", 3)), "AP/+");
}

TEST(ShellCells, TetrahedraArePositiveAndConforming) {
    const auto grown = Built(test_support::plate(4, 3));
    const auto closed = Built(test_support::torus(12, 8));
    for (const Built* const built : {&grown, &closed}) {
        const ShellCells cells = built->cells();
        EXPECT_TRUE(std::ranges::all_of(cells.tetrahedra, [&](const auto& tet) {
            return volume(cells, tet) > 0.0;
        }));
        std::map<int, int> counts;
        for (const auto& [face, count] : usesOfFaces(cells)) {
            ++counts[count];
        }
        EXPECT_EQ(counts.rbegin()->first, 2);
        // Only top and bottom are outside where there is no boundary.
        EXPECT_TRUE(built == &grown || counts[1] == 2 * built->surface.faceCount());
    }
}

TEST(ShellCells, LiveInTheUsersCoordinatesWithTheSurfaceInTheMiddle) {
    constexpr std::array<Triangle, 3> kHeights = {{{1, 1, 1}, {0, 0, 0}, {-1, -1, -1}}};
    Eigen::Isometry3d far = Eigen::Isometry3d::Identity();
    far.translation() = Vec3(100, 200, -50);
    const Built built(test_support::transformed(test_support::icosphere(2), far, 7.0));
    const ShellCells cells = built.cells();
    ASSERT_EQ(cells.layers.size(), 3 * built.surface.faces().size());
    for (std::size_t f = 0; f < built.surface.faces().size(); ++f) {
        const LayerCorners top(cells, f, 0);
        const LayerCorners middle(cells, f, 1);
        const LayerCorners bottom(cells, f, 2);
        EXPECT_EQ((std::array{top.heights, middle.heights, bottom.heights}), kHeights);
        Vec3 face = Vec3::Zero();
        for (const int vertex : built.surface.faces()[f]) {
            face += built.surface.vertices()[vertex];
        }
        EXPECT_LT((middle.sum - face).norm(), 1e-11);
        const Vec3 normal = built.surface.faceNormal(static_cast<int>(f));
        EXPECT_GT((top.sum - middle.sum).dot(normal), 0.0);
    }
}

TEST(ShellCells, GhostsAreFlagged) {
    const Built plate(test_support::plate(4, 3));
    const ShellCells cells = plate.cells();
    const auto isGhost = [&](std::size_t i) {
        return cells.prisms[i] >= plate.surface.faceCount();
    };
    ASSERT_GT(cells.prisms.size(), plate.surface.faces().size());
    for (std::size_t i = 0; i < cells.prisms.size(); ++i) {
        EXPECT_EQ(cells.ghost[i] != 0, isGhost(i));
    }
}

TEST(ShellCells, BlockedFacesAreLeftOut) {
    const Built crossing(test_support::crossingPlates());
    const std::vector<int>& blocked = crossing.build.report.blockedFaces;
    ASSERT_FALSE(blocked.empty());
    const ShellCells rest = crossing.cells();
    for (const int prism : rest.prisms) {
        EXPECT_FALSE(std::ranges::binary_search(blocked, prism));
    }
    EXPECT_EQ(rest.tetrahedra.size(), 6 * rest.prisms.size());
}

TEST(ShellCells, OfASimplifiedShellGhostsAreThePrismsThatNoFaceOfTheSurfaceMeets) {
    auto extended = std::make_shared<ExtendedSurface>(extendSurface(twoByOne(), 0));
    ASSERT_EQ(extended->surfaceFaceCount, 2);
    extended->faces.push_back({0, 1, 2});  // a ghost
    const Shell plain = twoPrisms(1.0, 1.0);
    const SurfaceTracks tracks{.offsets = {0, 2, 3}, .faces = {0, 2, 2}};
    const Shell shell(plain.pillars(), plain.prisms(), tracks, extended);
    EXPECT_FALSE(isGhostPrism(shell, 0));
    EXPECT_TRUE(isGhostPrism(shell, 1));
}

TEST(ShellWriter, WritesTheSameBytesInEveryLocale) {
    const Built built(test_support::icosphere(3));  // 1,280 faces: a thousands separator would show
    for (const char* const name : {"a.vtu", "a.msh", "a.PLY"}) {
        const std::string plain = shellBytes(name, built.build.shell, built.extended.frame);
        const CommaLocale comma;
        EXPECT_EQ(shellBytes(name, built.build.shell, built.extended.frame), plain) << name;
    }
}

TEST(ShellWriter, RefusesOtherExtensions) {
    const std::string line = refusal(
        [] {
            checkShellExtension("shell.vtk");
            return 0;
        },
        InputErrorCode::UnwritableFile
    );
    expectContains(line, ".vtk");
    expectContains(line, ".vtu");
}

TEST(ShellMeasures, ThicknessIsRelativeToTheLongestSideAndCountsEachPillarOnce) {
    const ShellThickness thickness =
        measureThickness(twoByOne(), {.centre = Vec3::Zero(), .scale = 4.0}, twoPrisms(0.1, 0.3));
    // In the frame's unit the longest side, 2, is 0.5.
    EXPECT_DOUBLE_EQ(thickness.mean, 0.4);
    EXPECT_DOUBLE_EQ(thickness.min, 0.2);
    EXPECT_DOUBLE_EQ(thickness.p5, 0.2);
}

TEST(ShellMeasures, ThePercentileIsInterpolated) {
    const Shell shell = [] {
        const Shell plain = twoPrisms(0.1, 0.3);
        std::vector<Pillar> pillars = plain.pillars();
        pillars[1].top = pillars[1].middle + Vec3(0, 0, 0.15);  // 0.2 long
        return Shell(pillars, plain.prisms(), 2);
    }();
    const ShellThickness thickness = measureThickness(twoByOne(), {.scale = 2.0}, shell);
    EXPECT_NEAR(thickness.p5, 0.1 + 0.05 * 3 * 0.1, 1e-15);
    EXPECT_NEAR(thickness.min, 0.1, 1e-15);
}

}  // namespace bspline_curve::io_tests

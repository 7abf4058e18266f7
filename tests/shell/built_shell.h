// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/check_shell.h"
#include "shell/shell_simplifier.h"
#include "support/random.h"
#include "surface/surface.h"

#include <memory>
#include <ostream>
#include <string>
#include <vector>

namespace bspline_curve::test_support {

/// A surface and its shell, built the way CurveDesigner does.
struct BuiltShell {
    explicit BuiltShell(TriangleMesh mesh, const ShellOptions& options = {});

    [[nodiscard]] const Shell& shell() const { return build.shell; }

    [[nodiscard]] const std::vector<int>& blockedFaces() const { return build.report.blockedFaces; }

    [[nodiscard]] ShellCheck check() const;
    /// The same check of another shell in place of the built one.
    [[nodiscard]] ShellCheck check(const Shell& other) const;

    Surface surface;
    ExtendedSurface extended;
    ShellBuild build;
};

/// A surface and its simplified shell.
struct SimplifiedShell {
    explicit SimplifiedShell(TriangleMesh mesh, const ShellOptions& options = {});

    [[nodiscard]] const Shell& shell() const { return build.shell; }

    [[nodiscard]] ShellCheck check() const;

    /// Mean length of its pillars, bottom to top, relative to the longest side of the surface's
    /// box.
    [[nodiscard]] double meanThickness() const;

    Surface surface;
    std::shared_ptr<const ExtendedSurface> extended;
    ShellBuild build;
};

struct NamedMesh {
    std::string name;
    TriangleMesh mesh;
};

/// For names of parameterised tests.
std::ostream& operator<<(std::ostream& stream, const NamedMesh& named);

/// Meshes on which every face must get a prism, one for each property that a shell may trip over.
[[nodiscard]] std::vector<NamedMesh> shellMeshes();

// ---- Meshes for shells ----

/// A plate folded over: two flat sheets `gap` apart joined by half a cylinder, one unit wide and
/// long.
[[nodiscard]] TriangleMesh foldedSheet(int columns, int rows, double gap);

/// Two equal plates, one `gap` above the other.
[[nodiscard]] TriangleMesh parallelPlates(int cells, double gap);

/// A plate from whose edge a slit of one cell's width runs inwards to its middle.
[[nodiscard]] TriangleMesh notchedPlate(int cells);

/// A plate whose middle vertex (4, 4) is a saddle so steep that no direction sees its faces well.
[[nodiscard]] TriangleMesh plateWithSingularVertex();

/// A fan of 12 faces about vertex 0 whose rim winds like the seam of a tennis ball: no direction
/// sees all faces, and the rim's mean is the vertex itself.
[[nodiscard]] TriangleMesh tennisBallVertex();

/// A coarse sphere (vertices 0 to 11) and a tiny one outside, close to the middle of its face 0.
[[nodiscard]] TriangleMesh sphereWithSatellite();

/// A large sphere and a tiny one in it, at its centre: no part of either is near the other.
[[nodiscard]] TriangleMesh sphereInSphere();

/// The mesh without the faces around some of its vertices, chosen at random, no two of which are
/// close: holes.
[[nodiscard]] TriangleMesh withHoles(const TriangleMesh& mesh, int count, Random& random);

/// What violates an invariant, as text for a failing test.
[[nodiscard]] std::string describe(const ShellCheck& check);

}  // namespace bspline_curve::test_support

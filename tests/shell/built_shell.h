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

/// A surface and its shell, built the way CurveDesigner does: of full resolution, unless the
/// options ask for a simplified one.
struct BuiltShell {
    explicit BuiltShell(TriangleMesh mesh, const ShellOptions& options = {});

    [[nodiscard]] const Shell& shell() const { return build.shell; }

    [[nodiscard]] const std::vector<int>& blockedFaces() const { return build.report.blockedFaces; }

    [[nodiscard]] ShellCheck check() const { return check(build.shell); }

    /// The same check of another shell in place of the built one.
    [[nodiscard]] ShellCheck check(const Shell& other) const {
        return checkShell(surface, extended, other, blockedFaces());
    }

    /// The same check of the shell with other pillars.
    [[nodiscard]] ShellCheck checkWith(const std::vector<Pillar>& pillars) const {
        return check(Shell(pillars, shell().prisms(), surface.faceCount()));
    }

    Surface surface;
    std::shared_ptr<const ExtendedSurface> sharedExtended;
    const ExtendedSurface& extended;
    ShellBuild build;
};

/// A surface and its simplified shell.
struct SimplifiedShell : BuiltShell {
    explicit SimplifiedShell(TriangleMesh mesh, ShellOptions options = {});
};

struct NamedMesh {
    std::string name;
    TriangleMesh mesh;
};

inline std::ostream& operator<<(std::ostream& stream, const NamedMesh& named) {
    return stream << named.name;
}

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

// ---- Expectations ----

/// Whether pillars, prisms and tracks are the same to the last bit.
[[nodiscard]] bool areSame(const Shell& a, const Shell& b);

using Names = std::vector<std::string>;

/// The names of the invariants that do not hold.
[[nodiscard]] Names brokenInvariants(const ShellCheck& check);

/// Expects that every invariant holds, and says which do not.
void expectValid(const ShellCheck& check);

/// Expects a valid shell without blocked faces.
void expectWhole(const BuiltShell& built);

}  // namespace bspline_curve::test_support

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/check_shell.h"
#include "shell/pillar_points.h"

#include <compare>
#include <initializer_list>

namespace bspline_curve {

/// A face of a tetrahedron by its points, ascending, and where it is: opposite to vertex k of
/// `tet`.
struct TetFace {
    Triangle points;
    int tet, k;

    auto operator<=>(const TetFace&) const = default;

    [[nodiscard]] int prism() const { return tet / kTetrahedraPerPrism; }

    /// Whether it belongs to top or bottom.
    [[nodiscard]] bool isLayer() const { return k == 0 && tet % 3 == 2; }
};

/// The plain data of a shell as points and tetrahedra, which is all that the checks rely on, and
/// what it is checked against.
struct CheckedShell {
    CheckedShell(
        const Shell& checked,
        const Surface& ofSurface,
        const ExtendedSurface& ofExtended,
        std::span<const int> blocked,
        const ShellCheckOptions& how
    );

    const Shell& shell;
    const Surface& surface;
    const ExtendedSurface& extended;
    std::span<const int> blockedFaces;
    const ShellCheckOptions& options;
    PillarPoints points;
    /// All faces of all tetrahedra, so that equal ones follow each other.
    std::vector<TetFace> faces;

    [[nodiscard]] const Vec3& point(int i) const { return points.points[i]; }

    [[nodiscard]] int prismCount() const { return static_cast<int>(shell.prisms().size()); }

    [[nodiscard]] const Prism& prism(int i) const { return shell.prisms()[i]; }

    /// False for a blocked face, which keeps its place among the prisms of full resolution.
    [[nodiscard]] bool isPresent(int i) const {
        return prism(i).orientation != 0 || !shell.isFullResolution();
    }

    /// The orientation of a prism's slots: from where they stand in the face in a shell of full
    /// resolution (0 where that makes no sense), else as the prism says.
    [[nodiscard]] int slotParity(int i) const;

    [[nodiscard]] std::array<int, 4> tetPoints(int tet) const {
        return tetrahedronPoints(
            prism(tet / kTetrahedraPerPrism).pillars, tet % kTetrahedraPerPrism
        );
    }

    /// The two points of the half pillar that a tetrahedron holds, lower one first: its fibres are
    /// parallel to that.
    [[nodiscard]] std::array<int, 2> halfPillar(int tet) const;

    /// Exact sign of the volume of four points.
    [[nodiscard]] int volumeSign(const std::array<int, 4>& corners) const;

    /// What volumeSign must be for the points of a tetrahedron.
    [[nodiscard]] int handedness(int tet) const;

    /// Calls visit(equal) for each set of equal faces.
    template <class Visitor>
    void forEachFace(const Visitor& visit) const {
        for (std::size_t first = 0; first < faces.size();) {
            std::size_t last = first + 1;
            while (last < faces.size() && faces[last].points == faces[first].points) {
                ++last;
            }
            visit(std::span(faces).subspan(first, last - first));
            first = last;
        }
    }

    /// The faces that only one tetrahedron has: top, bottom, and the walls where the shell ends.
    [[nodiscard]] std::vector<TetFace> boundary() const;
};

/// Where a check writes what it finds.
class Violations {
public:
    Violations(ShellInvariant& check, const ShellCheckOptions& options)
        : check_(check), maxIds_(options.maxReportedIds) {}

    void add(std::initializer_list<int> ids) {
        check_.holds = false;
        ++check_.violations;
        for (const int id : ids) {
            if (static_cast<int>(check_.firstIds.size()) < maxIds_) {
                check_.firstIds.push_back(id);
            }
        }
    }

    /// Adds the index of every flag that is set.
    void addAll(const std::vector<char>& flags) {
        for (int i = 0; i < static_cast<int>(flags.size()); ++i) {
            if (flags[i] != 0) {
                add({i});
            }
        }
    }

private:
    ShellInvariant& check_;
    int maxIds_;
};

// ---- Invariants of both forms ----

void checkTetrahedra(const CheckedShell& shell, Violations violations);
void checkLayers(const CheckedShell& shell, Violations violations);
void checkComponents(const CheckedShell& shell, Violations violations);
void checkNeighbours(const CheckedShell& shell, Violations violations);

/// Whether a face of the extended surface is that of the surface, and its vertices are those of the
/// surface, or listed as moved, or grown from its boundary.
[[nodiscard]] bool isOfSurface(const CheckedShell& shell, int face);

// ---- Full resolution ----

void checkMiddleSurface(const CheckedShell& shell, Violations violations);
void checkPrismPerFace(const CheckedShell& shell, Violations violations);

// ---- Simplified shells ----

/// Checks transversality, containment, fibres and tracking.
void checkSimplifiedShell(const CheckedShell& shell, ShellCheck& result);

}  // namespace bspline_curve

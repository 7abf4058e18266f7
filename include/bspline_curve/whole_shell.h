// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/progress.h"
#include "bspline_curve/shell.h"
#include "bspline_curve/workpiece.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

// The shell of a whole mesh by itself, and shells on disk from one run to the next.
namespace bspline_curve {

/// Lengths of the pillars of prisms with a face, from bottom to top, relative to the longest side
/// of the mesh's box.
struct ShellThickness {
    double mean = 0.0;
    double p5 = 0.0;  ///< 5th percentile, linear between the two nearest
    double min = 0.0;
};

struct ShellFigures {
    ShellKind kind = ShellKind::Simplified;
    int prisms = 0;
    int ghostPrisms = 0;  ///< of these, beyond a boundary
    int pillars = 0;
    int blockedFaces = 0;   ///< of the mended mesh, without a prism
    int movedVertices = 0;  ///< by less than rounding of floats, so that the shell fits
    ShellThickness thickness{};
    int boundaryEdges = 0;                             ///< of the mended mesh
    double longestSide = 0.0;                          ///< of the mesh's box, user's unit
    double extendedSeconds = 0.0, shellSeconds = 0.0;  ///< what making it took, by wall clock
};

/// Tetrahedra all around a mesh, which curves can be sought in: see docs/SHELLS.md.
class WholeShell {
public:
    /// Makes the shell of the workpiece's options, simplified or of full resolution; the workpiece
    /// must outlive it. `takesKept`: a simplified one that keep() has left on disk is taken. Throws
    /// InputError (BadOption: a local shell is none; NoShell: no face got a prism), Cancelled.
    explicit WholeShell(
        const Workpiece& workpiece, bool takesKept = true, const Progress& progress = {}
    );
    ~WholeShell();
    WholeShell(WholeShell&&) noexcept;
    WholeShell& operator=(WholeShell&&) noexcept;

    [[nodiscard]] const ShellFigures& figures() const;

    /// Every invariant, with exact predicates and by code that shares nothing with what makes
    /// shells. About as long as making it.
    [[nodiscard]] std::vector<ShellInvariant> check() const;

    /// Leaves a simplified shell on disk, where later runs find it. No trouble is an error.
    void keep();
    /// About what is on disk; empty where all is well.
    [[nodiscard]] const std::vector<std::string>& notes() const;

    /// The bytes of a file: .vtu or .msh (tetrahedra with f in [-1, 1]) or .ply (top, middle and
    /// bottom as triangles). Throws InputError (UnwritableFile) for other extensions.
    [[nodiscard]] std::string bytes(const std::filesystem::path& file) const;

    /// For the library itself.
    struct Parts;

    [[nodiscard]] const Parts& parts() const { return *parts_; }

private:
    std::unique_ptr<Parts> parts_;
};

/// Throws InputError (UnwritableFile) where a shell cannot be written under this name.
void checkShellExtension(const std::filesystem::path& file);

/// Workpiece::prepare(), with a simplified shell that is on disk; one that is made is left there.
/// Workpiece::shell() tells. Throws Cancelled.
void prepareWithKeptShell(const Workpiece& workpiece, const Progress& progress = {});

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/designer.h"
#include "bspline_curve/progress.h"
#include "surface/mesh_checksum.h"
#include "surface/surface.h"
#include "utility/threads.h"
#include "workpiece/curve_options.h"
#include "workpiece/layer_input.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace bspline_curve {

/// A curve that was drawn, with all that hosts show and write of it.
struct DesignedCurve {
    Curve curve;
    ScalarField field{};          ///< that it follows; empty: none
    Region avoid{};               ///< faces that it does not enter
    std::vector<double> along{};  ///< the field at the vertices of the polyline, or none
    double fieldSeconds = 0.0, seconds = 0.0;  ///< the second without the first
    std::vector<std::string> notes{};  ///< of this curve: what people must know, see asSentence()
};

/// A mesh that people draw on, prepared once for all curves on it and their uses. What every host
/// does lies here: mending, fields, regions, curves, notes; curve_uses.h goes on from there. All
/// ids are those of this mesh, the input of its surface. Several threads may use one.
class Workpiece {
public:
    /// Validates the mesh, mended where it must be. Throws InputError, Cancelled.
    Workpiece(
        TriangleMesh mesh, const PreparingOptions& options = {}, const Progress& progress = {}
    );

    [[nodiscard]] const TriangleMesh& mesh() const { return surface_->input(); }

    [[nodiscard]] const Surface& surface() const { return *surface_; }

    /// The same, to be kept longer than the workpiece.
    [[nodiscard]] std::shared_ptr<const Surface> sharedSurface() const { return surface_; }

    [[nodiscard]] const PreparingOptions& options() const { return options_; }

    /// By which files know the mesh again; computed when it is first asked for.
    [[nodiscard]] MeshChecksum checksum() const;

    /// Of making the surface.
    [[nodiscard]] double seconds() const { return seconds_; }

    /// What was mended; null: nothing.
    [[nodiscard]] const RepairReport* repair() const { return surface_->provenance().report(); }

    /// What draws curves: prepared when it is first asked for, with a shell of the `store` (null:
    /// none). Throws Cancelled.
    [[nodiscard]] const CurveDesigner& designer(
        const Progress& progress = {}, const ShellStore* store = nullptr
    ) const;

    /// The same, to be kept longer than the workpiece.
    [[nodiscard]] std::shared_ptr<const CurveDesigner> sharedDesigner(
        const Progress& progress = {}, const ShellStore* store = nullptr
    ) const;

    /// What people must know of the mesh: what was mended, how to have it otherwise. `strict`: the
    /// option that refuses such meshes, as the host calls it.
    [[nodiscard]] std::vector<std::string> notes(const std::string& strict = "strict") const;

    /// A field that is asked for. `with`: quality and selections of the mesh; its own mesh is not
    /// looked at. Throws as makeField(), and InputError (BadField) where there is no quality.
    [[nodiscard]] ScalarField field(
        const LayerInput& with, const FieldRequest& request, const Progress& progress = {}
    ) const;

    /// One curve through the picks. Throws as CurveDesigner::design() and field().
    [[nodiscard]] DesignedCurve draw(
        const std::vector<Vec3>& picks,
        const CurveOptions& options,
        const LayerInput& with,
        const Progress& progress = {}
    ) const;

    /// A smooth curve along a line. Throws as CurveDesigner::fit().
    [[nodiscard]] DesignedCurve fit(
        const std::vector<Vec3>& line,
        const FitOptions& fit,
        const CurveOptions& options,
        const Progress& progress = {}
    ) const;

    /// A curve that was drawn already, following a field (empty: none).
    [[nodiscard]] DesignedCurve finished(Curve curve, const ScalarField& field) const;

private:
    PreparingOptions options_;
    double seconds_ = 0.0;
    std::shared_ptr<const Surface> surface_;
    mutable Mutex mutex_;  // of all below
    mutable std::optional<MeshChecksum> checksum_;
    mutable std::shared_ptr<const CurveDesigner> designer_;
};

/// The workpiece of a layer, whose ids errors then name, see madeFrom(). Throws InputError,
/// Cancelled.
[[nodiscard]] std::shared_ptr<const Workpiece> workpieceOf(
    const LayerInput& layer, const PreparingOptions& options, const Progress& progress = {}
);

}  // namespace bspline_curve

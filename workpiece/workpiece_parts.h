// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/workpiece.h"
#include "design/curve_designer.h"
#include "surface/surface.h"
#include "utility/threads.h"

#include <memory>
#include <optional>

namespace bspline_curve {

/// What a workpiece is made of.
struct Workpiece::Parts {
    Parts(TriangleMesh mesh, const PreparingOptions& preparing, const Progress& progress);

    PreparingOptions options;
    double seconds = 0.0;  ///< of making the surface
    std::shared_ptr<const Surface> surface;
    mutable Mutex mutex;  // of all below
    mutable std::optional<MeshChecksum> checksum;
    mutable std::shared_ptr<const CurveDesigner> designer;  ///< null until it is asked for
};

/// The surface of a workpiece.
[[nodiscard]] inline const Surface& surfaceOf(const Workpiece& workpiece) {
    return *workpiece.parts().surface;
}

/// What draws its curves, to be kept longer than the workpiece: prepared when it is first asked
/// for, with a shell of the `store` (null: none). Throws Cancelled.
[[nodiscard]] std::shared_ptr<const CurveDesigner> sharedDesignerOf(
    const Workpiece& workpiece, const Progress& progress = {}, const ShellStore* store = nullptr
);

/// The same.
[[nodiscard]] inline const CurveDesigner& designerOf(const Workpiece& workpiece) {
    return *sharedDesignerOf(workpiece);
}

}  // namespace bspline_curve

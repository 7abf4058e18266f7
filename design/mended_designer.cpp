// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/mended_designer.h"

#include "design/designer_surface.h"

#include <utility>

namespace bspline_curve {

Mended<CurveDesigner> makeMendedDesigner(
    TriangleMesh mesh,
    const MendingOptions& mending,
    const ShellOptions& shell,
    const Progress& progress,
    const ShellStore* store
) {
    Mended<CurveDesigner> mended = makeMended(std::move(mesh), mending, [&](TriangleMesh given) {
        return CurveDesigner(std::move(given), shell, progress, store);
    });
    if (const MeshRepair* const repair = mended.repair();
        repair != nullptr && !repair->report.cutEdges.empty()) {
        letRejoin(mended.made, repair->vertexOrigins);
    }
    return mended;
}

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/find_designer.h"

#include "bspline_curve/error.h"
#include "design/mended_designer.h"
#include "filters/layer_ids.h"
#include "io/shell_cache.h"

#include <optional>

namespace bspline_curve {

DesignerCache::Found designerFor(
    const LayerInput& layer,
    const ShellOptions& shell,
    const MendingOptions& mending,
    DesignerCache& designers,
    const Progress& progress
) {
    return madeFrom(layer, [&] {
        const auto make = [&] {
            const std::optional<ShellCache> cache = ShellCache::ofUser();
            return makeMendedDesigner(
                layer.mesh, mending, shell, progress, cache ? &*cache : nullptr
            );
        };
        DesignerCache::Found found = designers.findOrMake(layer.mesh, shell, make, mending.weld);
        if (found.mending && found.mending->refusal && mending.strict) {
            throw InputError(*found.mending->refusal);
        }
        return found;
    });
}

}  // namespace bspline_curve

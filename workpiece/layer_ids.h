// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve_options.h"
#include "bspline_curve/error.h"

#include <string>

namespace bspline_curve {

/// Makes something from the arrays of a layer. Ids in errors count elements that are not deleted;
/// where the layer has others, a message with ids has to say so.
template <class Make>
auto madeFrom(const LayerInput& layer, const Make& make) {
    try {
        return make();
    } catch (const InputError& error) {
        if (layer.hasLayersIds || error.elements().empty()) {
            throw;
        }
        throw InputError(
            error.code(),
            error.what() + std::string(" (ids count without the layer's deleted elements)"),
            error.elements(),
            error.remedy()
        );
    }
}

}  // namespace bspline_curve

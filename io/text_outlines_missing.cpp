// SPDX-License-Identifier: GPL-3.0-or-later
// In place of text_outlines.cpp where FreeType was not there at build.
#include "bspline_curve/error.h"
#include "io/text_outlines.h"

namespace bspline_curve {

Drawing textOutlines(std::string_view /*text*/, const std::filesystem::path& /*font*/) {
    throw InputError(
        InputErrorCode::BadOption,
        "this was built without FreeType, so it cannot make outlines of text; turn the text into "
        "paths in a drawing program and give that drawing"
    );
}

}  // namespace bspline_curve

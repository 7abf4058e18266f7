// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/json_text.h"

namespace bspline_curve {

std::string jsonText(const Json& document) {
    constexpr int kIndent = 1;
    return document.dump(kIndent, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace bspline_curve

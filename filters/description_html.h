// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/filter_description.h"

#include <string>

namespace bspline_curve {

/// What a filter does and what it is founded on, in the HTML that Qt's dialogs show. Of Markdown it
/// knows what descriptions use: paragraphs, *emphasis* and `code`.
[[nodiscard]] std::string descriptionHtml(const FilterDescription& filter);

}  // namespace bspline_curve

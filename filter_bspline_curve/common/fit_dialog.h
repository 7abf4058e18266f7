// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/filter_description.h"

class QString;

namespace bspline_curve {

/// Fits the dialog that MeshLab's window is about to show for a filter, once it is there: it lies
/// on the screen with all its buttons, its parameters scroll where the screen is too small, and
/// Enter applies. Where paths are typed as text, a button beside them chooses a file. `title`: of
/// the dialog, the filter's name. Does nothing in hosts without a window, and to no other dialog.
void fitDialogSoon(const QString& title, const FilterDescription& filter);

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>

namespace bspline_curve {

/// A curve through three picks, as MeshLab's tool bar shows it. Needs a QGuiApplication.
[[nodiscard]] QIcon toolIcon();

}  // namespace bspline_curve

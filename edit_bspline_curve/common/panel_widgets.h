// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHBoxLayout>
#include <QToolButton>
#include <initializer_list>

// What the parts of the tool's panel are made of.
namespace bspline_curve {

inline constexpr int kPanelSpacing = 4;

/// A button that leaves keys to the view.
[[nodiscard]] QToolButton* buttonOf(const QString& text, const QString& help);

[[nodiscard]] QHBoxLayout* rowOf(std::initializer_list<QWidget*> widgets);

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/sketch.h"

#include <QString>
#include <QVariant>

/// What the drawing tool keeps from one start of the host to the next, in the host's settings.
namespace bspline_curve::kept {

[[nodiscard]] QVariant value(const QString& name, const QVariant& standard = {});
void setValue(const QString& name, const QVariant& value);

/// Of new curves.
[[nodiscard]] SketchColour colour();
void setColour(SketchColour colour);

/// The name of the unit that the mesh is in, as it is shown after lengths; empty: not known.
[[nodiscard]] QString unit();
void setUnit(const QString& unit);

/// Whether picks snap without a key.
[[nodiscard]] bool isMagnetOn();
void setMagnetOn(bool isOn);

/// Where curves were saved or opened last.
[[nodiscard]] QString folder();
void setFolder(const QString& folder);

}  // namespace bspline_curve::kept

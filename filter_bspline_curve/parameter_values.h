// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <common/parameters/rich_parameter_list.h>

#include <QString>
#include <QStringList>

// What the user typed and chose, as hosts hand it over.
namespace bspline_curve {

/// The number of a choice. Throws MLException where an enumeration has no such choice.
[[nodiscard]] int choiceOf(
    const RichParameterList& parameters, const QString& name, const QStringList& choices
);

/// MeshLab keeps a parameter as float even where its scalar is double, so 0.1 arrives as
/// 0.10000000149. The number that the user typed is the shortest decimal that rounds to that float.
[[nodiscard]] double typedNumber(Scalarm value);

}  // namespace bspline_curve

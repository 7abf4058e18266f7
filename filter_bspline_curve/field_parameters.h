// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "field/field_options.h"

#include <common/parameters/rich_parameter_list.h>

#include <QString>
#include <QStringList>

namespace bspline_curve {

/// Which selection of a layer is the region of obstacles.
enum class RegionSource { SelectedFaces, SelectedVertices };

/// A field that the user asked for.
struct FieldRequest {
    FieldOptions options;
    RegionSource region = RegionSource::SelectedFaces;
};

/// The names of the kinds, in the order of kFieldKinds.
[[nodiscard]] QStringList fieldKindNames();

/// A line on each kind, for the help of hosts.
[[nodiscard]] QString fieldKindsHelp();

/// Adds the parameters of fields without their kind; `prefix` goes before each name.
void addFieldOptions(RichParameterList& list, const QString& prefix, bool isAdvanced);

/// Reads what addFieldOptions added; `kind` is an index into kFieldKinds. Throws MLException where
/// an enumeration has no such choice. Ranges are checked where the options are used.
[[nodiscard]] FieldRequest readFieldRequest(
    const RichParameterList& parameters, const QString& prefix, int kind
);

/// The parameters of the filter that computes a field, with their defaults and help.
[[nodiscard]] RichParameterList fieldParameters();

/// Reads them. Throws MLException, as above.
[[nodiscard]] FieldRequest readFieldRequest(const RichParameterList& parameters);

}  // namespace bspline_curve

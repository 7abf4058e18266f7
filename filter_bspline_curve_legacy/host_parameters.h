// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/parameter_value.h"
#include "host_document.h"

#include <common/filter_parameter/rich_parameter_list.h>

#include <utility>

// What MeshLab's versions spell differently about parameters: here, 2020.09.
namespace bspline_curve::host {

using Percentage = RichAbsPerc;
using FileOpen = RichOpenFile;
using FileSave = RichSaveFile;

// What values of parameters are set with.
using EnumNumber = EnumValue;
using SliderNumber = DynamicFloatValue;
using PercentageNumber = AbsPercValue;

/// Whether what is typed into the widgets of files counts. Here only their buttons do, so a dialog
/// has text in their place.
constexpr bool kFileWidgetsTakeTyping = false;

/// Of a parameter that names a file, be it a text or not.
[[nodiscard]] inline QString pathOf(const RichParameterList& list, const QString& name) {
    const Value& value = list.getParameterByName(name).value();
    return value.isFileName() ? value.getFileName() : value.getString();
}

/// Adds a parameter; `values`: what its constructor takes between the name and the texts. These
/// dialogs fold nothing away.
template <class Rich, class... Values>
void add(
    RichParameterList& list,
    const QString& name,
    const QString& label,
    const QString& help,
    bool /*isFolded*/,
    Values&&... values
) {
    list.addParam(Rich(name, std::forward<Values>(values)..., label, help));
}

/// Adds nothing in a document without layers, where this host could not show the parameter.
inline void addLayer(
    RichParameterList& list,
    const QString& name,
    const QString& label,
    const QString& help,
    bool /*isFolded*/,
    const MeshModel* standard,
    DialogDocument& document
) {
    if (!document.meshList.isEmpty()) {
        MeshModel* const layer =
            standard == nullptr ? document.meshList.front() : document.getMesh(standard->id());
        list.addParam(RichMesh(name, layer, &document, label, help));
    }
}

/// Of a parameter that names a layer.
[[nodiscard]] inline MeshValue layerValue(MeshDocument& document, int id) {
    return {document.getMesh(id)};
}

[[nodiscard]] inline LayerId layerOf(const RichParameterList& list, const QString& name) {
    const MeshModel* const layer = list.getMesh(name);
    return layer == nullptr ? LayerId() : LayerId{layer->id()};
}

}  // namespace bspline_curve::host

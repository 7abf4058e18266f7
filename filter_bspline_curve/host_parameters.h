// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/parameter_value.h"
#include "host_document.h"

#include <common/parameters/rich_parameter_list.h>

#include <utility>

// What MeshLab's versions spell differently about parameters: here, 2022.02 and later.
namespace bspline_curve::host {

#if __has_include(<common/parameters/rich_parameters.h>)
using Percentage = RichPercentage;
using FileOpen = RichFileOpen;
using FileSave = RichFileSave;
#else  // 2022.02
using Percentage = RichAbsPerc;
using FileOpen = RichOpenFile;
using FileSave = RichSaveFile;
#endif

// What values of parameters are set with.
using EnumNumber = IntValue;
using SliderNumber = FloatValue;
using PercentageNumber = FloatValue;

/// Whether what is typed into the widgets of files counts.
constexpr bool kFileWidgetsTakeTyping = true;

/// Of a parameter that names a file.
[[nodiscard]] inline QString pathOf(const RichParameterList& list, const QString& name) {
    return list.getString(name);
}

/// Adds a parameter; `values`: what its constructor takes between the name and the texts.
template <class Rich, class... Values>
void add(
    RichParameterList& list,
    const QString& name,
    const QString& label,
    const QString& help,
    bool isFolded,
    Values&&... values
) {
    list.addParam(Rich(name, std::forward<Values>(values)..., label, help, isFolded));
}

inline void addLayer(
    RichParameterList& list,
    const QString& name,
    const QString& label,
    const QString& help,
    bool isFolded,
    const MeshModel* standard,
    DialogDocument& document
) {
    const unsigned int id = standard == nullptr ? 0U : static_cast<unsigned int>(standard->id());
    list.addParam(RichMesh(name, id, &document, label, help, isFolded));
}

/// Of a parameter that names a layer.
[[nodiscard]] inline IntValue layerValue(MeshDocument& /*document*/, int id) {
    return {id};
}

[[nodiscard]] inline LayerId layerOf(const RichParameterList& list, const QString& name) {
    return {static_cast<int>(list.getMeshId(name))};
}

}  // namespace bspline_curve::host

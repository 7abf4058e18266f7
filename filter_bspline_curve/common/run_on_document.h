// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/run_filters.h"
#include "filters/workpiece_cache.h"
#include "host_document.h"
#include "host_parameters.h"

#include <exception>
#include <functional>
#include <string>
#include <vector>

namespace bspline_curve {

/// All filters of the plugins, in the order of their numbers.
[[nodiscard]] const std::vector<const FilterDescription*>& allFilters();

/// Whether a filter computes the field of its layer; all others add layers.
[[nodiscard]] bool isField(const FilterDescription& filter);

/// Which of MeshLab's menus a filter stands in.
enum class Menu { Creation, Quality, Remeshing };

[[nodiscard]] Menu menuOf(const FilterDescription& filter);

/// What a filter changes in layers that were there: MM_NONE, MM_VERTQUALITY …
[[nodiscard]] int changesOf(const FilterDescription& filter);

/// What a filter answers with.
struct FilterAnswer {
    Figures figures;
    LogLines log;  ///< in words where there is a window
};

/// The last step of a filter: brings its results into the document, in the document's thread. Once.
using FilterBringing = std::function<FilterAnswer()>;

/// The step before: computes them. Touches no document, so any thread may do it. Once.
using FilterComputing = std::function<FilterBringing(const Progress&)>;

/// The first step of a filter: takes what it needs from the document, in the document's thread.
/// Document and `workpieces` must outlive the other steps, which look again whether the layer is
/// there. All three throw InputError, Cancelled, std::bad_alloc.
[[nodiscard]] FilterComputing startOnDocument(
    const FilterDescription& filter,
    MeshDocument& document,
    const RichParameterList& parameters,
    WorkpieceCache& workpieces
);

/// Runs a filter on a document and shows its results. Throws InputError, Cancelled, std::bad_alloc.
[[nodiscard]] FilterAnswer runOnDocument(
    const FilterDescription& filter,
    MeshDocument& document,
    const RichParameterList& parameters,
    WorkpieceCache& workpieces,
    const Progress& progress
);

/// What to tell the user about an exception of it: in a window with the labels of parameters.
[[nodiscard]] std::string failureOf(const FilterDescription& filter, const std::exception& error);

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/parameter_value.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

// What the filters are called, what they take and what people are told about it: filters.json, for
// hosts to make their dialogs, signatures, options and pages from. It is part of the library; no
// file is looked for when a host runs.
namespace bspline_curve {

enum class ParameterType {
    Layer,       ///< a layer of the document; "mesh" in the file
    Bool,        ///< "bool"
    Int,         ///< "int"
    Double,      ///< "double"
    Percentage,  ///< a length, in world units or as a share of the surface's diagonal; "absperc"
    Length,      ///< text: a length in world units or mean edges, see MeshLength; "length"
    Tolerances,  ///< text: such lengths of picks, see parsePickTolerances(); "tolerances"
    Picks,       ///< text: numbers of picks, see parsePickChoice(); "picks"
    Tangents,    ///< text: directions of picks, see parsePickDirections(); "tangents"
    Enum,        ///< "enum"
    Text,        ///< "string"
    OpenFile,    ///< a file to read; "openFile"
    SaveFile,    ///< a file to write; "saveFile"
};

/// A choice of an enumeration.
struct EnumOption {
    std::string id;     ///< as users type it
    std::string label;  ///< as dialogs show it
    std::string help;   ///< empty: the id says it all
    /// Only hosts with a selection can offer it; the program has files in its place.
    bool needsSelection = false;
};

/// What another parameter must be for this one to have an effect.
struct EnabledWhen {
    std::string parameter;
    std::vector<std::string> values;  ///< ids of enum options: one of these
};

struct ParameterDescription {
    std::string id;     ///< snake_case; the program has dashes in place of underscores
    std::string label;  ///< for dialogs
    std::string group;  ///< "main", "window", "further.…", "advanced" or "advanced.…"
    std::string help;   ///< one or a few sentences, without those of enum options
    ParameterType type = ParameterType::Bool;
    /// Of the type's own kind; a layer's is LayerId(), which is for the host to choose.
    ParameterValue defaultValue;
    std::optional<double> min, max;   ///< of Int, Double and Percentage; absent: no limit
    bool excludesMin = false;         ///< the values are above min
    bool isOnInWindow = false;        ///< of Bool: hosts with a window have it on by default
    bool isSlider = false;            ///< for dialogs: all of [min, max] within reach of the mouse
    int decimals = 3;                 ///< of Double and Percentage, for dialogs
    std::vector<EnumOption> options;  ///< of Enum
    std::vector<std::string> extensions;  ///< of OpenFile and SaveFile, with dots
    std::optional<EnabledWhen> enabledWhen;

    /// Whether it has a meaning in hosts with a window alone.
    [[nodiscard]] bool isOfWindow() const { return group == "window"; }

    /// Whether dialogs fold it away.
    [[nodiscard]] bool isFolded() const { return group != "main" && !isOfWindow(); }

    /// Whether few people ever need it.
    [[nodiscard]] bool isAdvanced() const { return group.starts_with("advanced"); }

    /// Position in `options`; none where there is no such id.
    [[nodiscard]] std::optional<std::size_t> indexOf(std::string_view optionId) const;

    /// Position of the default in `options`.
    [[nodiscard]] std::size_t defaultOption() const;

    /// `help` and what each enum option is, as one text; for hosts without selections without the
    /// options that need one.
    [[nodiscard]] std::string fullHelp(bool hasSelections = true) const;

    /// The ids of `options`; likewise.
    [[nodiscard]] std::vector<std::string> optionIds(bool hasSelections = true) const;
};

/// What a filter is founded on; an item of CSL-JSON.
struct Publication {
    std::string id;
    std::string title, container;
    int year = 0;
    std::string url;
};

struct FilterDescription {
    std::string id;
    std::string name;        ///< for menus
    std::string pythonName;  ///< of the function in Python
    std::vector<std::string> categories;
    std::string shortDescription;         ///< one sentence
    std::string longDescriptionMarkdown;  ///< paragraphs
    std::string inputDomain, outputDomain;
    std::vector<Publication> publications;
    std::vector<ParameterDescription> parameters;  ///< in the order of dialogs

    /// Throws std::out_of_range where there is none: a bug of the caller.
    [[nodiscard]] const ParameterDescription& parameter(std::string_view parameterId) const;
};

/// All filters of a description, in its order. Throws std::invalid_argument naming the place and
/// what is wrong with it: an unknown key or type, a missing text, a default outside its range …
[[nodiscard]] std::vector<FilterDescription> parseFilterDescriptions(std::string_view text);

/// The text of filters.json.
[[nodiscard]] std::string_view filterDescriptionsJson();

/// The filter that draws curves, parsed once.
[[nodiscard]] const FilterDescription& curveFilter();

/// The filter that computes fields, parsed once.
[[nodiscard]] const FilterDescription& fieldFilter();

// Those that use curves, parsed once.
[[nodiscard]] const FilterDescription& imprintFilter();
[[nodiscard]] const FilterDescription& cutFilter();
[[nodiscard]] const FilterDescription& segmentFilter();
[[nodiscard]] const FilterDescription& offsetFilter();
[[nodiscard]] const FilterDescription& patternFilter();

/// The filter that closes the holes of a mesh, parsed once.
[[nodiscard]] const FilterDescription& fillFilter();

/// The filter that places points along curves, parsed once.
[[nodiscard]] const FilterDescription& pointsFilter();

/// The filter that makes curves of boundaries of faces, parsed once.
[[nodiscard]] const FilterDescription& fitFilter();
[[nodiscard]] const FilterDescription& editFilter();

}  // namespace bspline_curve

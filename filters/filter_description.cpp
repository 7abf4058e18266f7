// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/filter_description.h"

#include "filters/description_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace bspline_curve {

extern const std::string_view kEmbeddedFilters;  // made from filters.json

namespace {

using nlohmann::json;

constexpr std::array<std::pair<const char*, ParameterType>, 13> kTypes = {{
    {"mesh", ParameterType::Layer},
    {"bool", ParameterType::Bool},
    {"int", ParameterType::Int},
    {"double", ParameterType::Double},
    {"absperc", ParameterType::Percentage},
    {"length", ParameterType::Length},
    {"tolerances", ParameterType::Tolerances},
    {"picks", ParameterType::Picks},
    {"tangents", ParameterType::Tangents},
    {"enum", ParameterType::Enum},
    {"string", ParameterType::Text},
    {"openFile", ParameterType::OpenFile},
    {"saveFile", ParameterType::SaveFile},
}};

constexpr const char* kCurrentLayer = "@currentMeshIndex";

ParameterType readType(DescriptionReader& reader) {
    const std::string word = reader.text("type");
    const auto* const found =
        std::ranges::find_if(kTypes, [&](const auto& type) { return word == type.first; });
    if (found == kTypes.end()) {
        reader.refuse("has an unknown type " + word);
    }
    return found->second;
}

bool isNumber(ParameterType type) {
    return type == ParameterType::Int || type == ParameterType::Double ||
           type == ParameterType::Percentage;
}

bool isFile(ParameterType type) {
    return type == ParameterType::OpenFile || type == ParameterType::SaveFile;
}

/// A default of the parameter's own type.
ParameterValue readDefault(DescriptionReader& reader, ParameterType type) {
    const json& value = reader.any("default");
    switch (type) {
        case ParameterType::Layer:
            if (value == kCurrentLayer) {
                return LayerId();
            }
            break;
        case ParameterType::Bool:
            if (value.is_boolean()) {
                return value.get<bool>();
            }
            break;
        case ParameterType::Int:
            if (value.is_number_integer()) {
                return value.get<int>();
            }
            break;
        case ParameterType::Double:
        case ParameterType::Percentage:
            if (value.is_number_float()) {
                return value.get<double>();
            }
            break;
        default:
            if (value.is_string()) {
                return value.get<std::string>();
            }
    }
    reader.refuse("has a default of another type");
}

EnumOption readOption(DescriptionReader& reader) {
    EnumOption option{
        .id = reader.text("id"),
        .label = reader.text("label"),
        .help = reader.textOr("help", ""),
        .needsSelection = reader.flagOr("needsSelection", false)
    };
    reader.end();
    return option;
}

/// What a number's default and limits say must fit together.
void checkNumber(const ParameterDescription& parameter, const DescriptionReader& reader) {
    const auto* const whole = std::get_if<int>(&parameter.defaultValue);
    const double value = whole != nullptr ? *whole : std::get<double>(parameter.defaultValue);
    const bool isAbove = !parameter.min ||
                         (parameter.excludesMin ? value > *parameter.min : value >= *parameter.min);
    if (!isAbove || (parameter.max && value > *parameter.max)) {
        reader.refuse("has a default out of its range");
    }
    if (parameter.excludesMin && !parameter.min) {
        reader.refuse("excludes a min that it does not have");
    }
    if (parameter.isSlider && (!parameter.min || !parameter.max)) {
        reader.refuse("is a slider without ends");
    }
}

void readEnum(ParameterDescription& parameter, DescriptionReader& reader) {
    for (DescriptionReader& option : reader.objects("enumOptions")) {
        parameter.options.push_back(readOption(option));
    }
    if (!parameter.indexOf(std::get<std::string>(parameter.defaultValue))) {
        reader.refuse("has a default that is none of its enumOptions");
    }
}

ParameterDescription readParameter(DescriptionReader& reader) {
    ParameterDescription parameter;
    parameter.id = reader.text("id");
    parameter.label = reader.text("label");
    parameter.group = reader.text("group");
    parameter.help = reader.text("help");
    parameter.type = readType(reader);
    parameter.defaultValue = readDefault(reader, parameter.type);
    if (parameter.type == ParameterType::Bool) {
        parameter.isOnInWindow = reader.flagOr("onInWindow", false);
    }
    if (isNumber(parameter.type)) {
        parameter.min = reader.number("min");
        parameter.max = reader.number("max");
        parameter.excludesMin = reader.flagOr("excludesMin", false);
        parameter.isSlider = reader.flagOr("slider", false);
        parameter.decimals = reader.countOr("decimals", parameter.decimals);
        checkNumber(parameter, reader);
    }
    if (parameter.type == ParameterType::Enum) {
        readEnum(parameter, reader);
    }
    if (isFile(parameter.type)) {
        parameter.extensions = reader.texts("extensions");
    }
    if (reader.has("enabledWhen")) {
        DescriptionReader condition = reader.object("enabledWhen");
        parameter.enabledWhen = {
            .parameter = condition.text("parameter"), .values = condition.texts("in")
        };
        condition.end();
    }
    reader.end();
    return parameter;
}

Publication readPublication(DescriptionReader& reader) {
    DescriptionReader issued = reader.object("issued");
    const json& dates = issued.any("date-parts");
    issued.end();
    if (!dates.is_array() || dates.empty() || !dates[0].is_array() || dates[0].empty() ||
        !dates[0][0].is_number_integer()) {
        issued.refuse("names no year");
    }
    Publication publication{
        .id = reader.text("id"),
        .title = reader.text("title"),
        .container = reader.text("container-title"),
        .year = dates[0][0].get<int>(),
        .url = reader.text("URL")
    };
    for (const char* const key : {"type", "DOI"}) {
        reader.ignore(key);
    }
    reader.end();
    return publication;
}

/// Ids are unique, and conditions name enumerations that come before and options of theirs.
void checkIds(const FilterDescription& filter, const DescriptionReader& reader) {
    std::vector<std::string> ids;
    for (const ParameterDescription& parameter : filter.parameters) {
        if (std::ranges::find(ids, parameter.id) != ids.end()) {
            reader.refuse("has the parameter " + parameter.id + " twice");
        }
        if (const auto& condition = parameter.enabledWhen) {
            if (std::ranges::find(ids, condition->parameter) == ids.end()) {
                reader.refuse("has no " + condition->parameter + " before " + parameter.id);
            }
            const ParameterDescription& other = filter.parameter(condition->parameter);
            for (const std::string& value : condition->values) {
                if (!other.indexOf(value)) {
                    reader.refuse(other.id + " is never " + value);
                }
            }
        }
        ids.push_back(parameter.id);
    }
}

FilterDescription readFilter(
    DescriptionReader& reader, const std::vector<Publication>& publications
) {
    FilterDescription filter;
    filter.id = reader.text("id");
    filter.name = reader.text("name");
    filter.pythonName = reader.text("pythonName");
    filter.categories = reader.texts("categories");
    filter.shortDescription = reader.text("shortDescription");
    filter.longDescriptionMarkdown = reader.text("longDescriptionMarkdown");
    filter.inputDomain = reader.text("inputDomain");
    filter.outputDomain = reader.text("outputDomain");
    for (const std::string& id : reader.texts("referenceIds")) {
        const auto found = std::ranges::find(publications, id, &Publication::id);
        if (found == publications.end()) {
            reader.refuse("names an unknown reference " + id);
        }
        filter.publications.push_back(*found);
    }
    for (DescriptionReader& parameter : reader.objects("parameters")) {
        filter.parameters.push_back(readParameter(parameter));
    }
    for (const char* const key : {"tags", "inputRequirements", "outputModifies"}) {
        reader.ignore(key);
    }
    reader.end();
    checkIds(filter, reader);
    return filter;
}

const FilterDescription& filterNamed(std::string_view id) {
    static const std::vector<FilterDescription> filters =
        parseFilterDescriptions(filterDescriptionsJson());
    const auto found = std::ranges::find(filters, id, &FilterDescription::id);
    if (found == filters.end()) {
        throw std::out_of_range("there is no filter " + std::string(id));
    }
    return *found;
}

}  // namespace

std::optional<std::size_t> ParameterDescription::indexOf(std::string_view optionId) const {
    const auto found = std::ranges::find(options, optionId, &EnumOption::id);
    return found == options.end() ? std::nullopt : std::optional(found - options.begin());
}

std::size_t ParameterDescription::defaultOption() const {
    return indexOf(std::get<std::string>(defaultValue)).value_or(0);  // parsing has checked it
}

std::string ParameterDescription::fullHelp(bool hasSelections) const {
    std::string text = help;
    const char* separator = " ";
    for (const EnumOption& option : options) {
        if (!option.help.empty() && (hasSelections || !option.needsSelection)) {
            text += separator + option.id + ": " + option.help;
            separator = "; ";
        }
    }
    return options.empty() ? text : text + ".";
}

std::vector<std::string> ParameterDescription::optionIds(bool hasSelections) const {
    std::vector<std::string> ids;
    for (const EnumOption& option : options) {
        if (hasSelections || !option.needsSelection) {
            ids.push_back(option.id);
        }
    }
    return ids;
}

const ParameterDescription& FilterDescription::parameter(std::string_view parameterId) const {
    const auto found = std::ranges::find(parameters, parameterId, &ParameterDescription::id);
    if (found == parameters.end()) {
        throw std::out_of_range(id + " has no parameter " + std::string(parameterId));
    }
    return *found;
}

std::vector<FilterDescription> parseFilterDescriptions(std::string_view text) {
    const json document = json::parse(text, nullptr, false);
    if (document.is_discarded()) {
        throw std::invalid_argument("description of the filters: no JSON");
    }
    DescriptionReader reader(document, "the file");
    reader.ignore("pluginId");
    std::vector<Publication> publications;
    for (DescriptionReader& reference : reader.objects("references")) {
        publications.push_back(readPublication(reference));
    }
    std::vector<FilterDescription> filters;
    for (DescriptionReader& filter : reader.objects("filters")) {
        filters.push_back(readFilter(filter, publications));
    }
    reader.end();
    return filters;
}

std::string_view filterDescriptionsJson() {
    return kEmbeddedFilters;
}

const FilterDescription& curveFilter() {
    return filterNamed("generate_bspline_curve_on_surface");
}

const FilterDescription& fieldFilter() {
    return filterNamed("compute_scalar_field_for_curves_per_vertex");
}

const FilterDescription& imprintFilter() {
    return filterNamed("imprint_curves");
}

const FilterDescription& cutFilter() {
    return filterNamed("cut_along_curves");
}

const FilterDescription& segmentFilter() {
    return filterNamed("segment_by_curves");
}

const FilterDescription& offsetFilter() {
    return filterNamed("offset_curve_on_surface");
}

const FilterDescription& patternFilter() {
    return filterNamed("pattern_on_surface");
}

const FilterDescription& fitFilter() {
    return filterNamed("fit_curve_to_selection_boundary");
}

const FilterDescription& editFilter() {
    return filterNamed("edit_curve_on_surface");
}

const FilterDescription& fillFilter() {
    return filterNamed("fill_holes");
}

const FilterDescription& pointsFilter() {
    return filterNamed("points_on_curve");
}

}  // namespace bspline_curve

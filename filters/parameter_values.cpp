// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/parameter_values.h"

#include "bspline_curve/error.h"

#include <stdexcept>
#include <utility>

namespace bspline_curve {

namespace {

[[noreturn]] void refuseOption(const ParameterDescription& parameter) {
    std::string options;
    for (const EnumOption& option : parameter.options) {
        options += (options.empty() ? "" : ", ") + option.id;
    }
    throw InputError(InputErrorCode::BadOption, parameter.id + " must be one of: " + options);
}

}  // namespace

ParameterValues::ParameterValues(const FilterDescription& filter) : filter_(&filter) {
    for (const ParameterDescription& parameter : filter.parameters) {
        values_.emplace(parameter.id, parameter.defaultValue);
    }
}

void ParameterValues::set(std::string_view id, ParameterValue value) {
    const ParameterDescription& parameter = filter_->parameter(id);
    if (value.index() != parameter.defaultValue.index()) {
        throw std::invalid_argument(parameter.id + " has values of another type");
    }
    if (parameter.type == ParameterType::Enum && !parameter.indexOf(std::get<std::string>(value))) {
        refuseOption(parameter);
    }
    values_.find(id)->second = std::move(value);
}

void ParameterValues::setOption(std::string_view id, int option) {
    const ParameterDescription& parameter = filter_->parameter(id);
    if (option < 0 || option >= static_cast<int>(parameter.options.size())) {
        refuseOption(parameter);
    }
    set(id, parameter.options[option].id);
}

const ParameterValue& ParameterValues::value(std::string_view id) const {
    const auto found = values_.find(id);
    if (found == values_.end()) {
        throw std::out_of_range(filter_->id + " has no parameter " + std::string(id));
    }
    return found->second;
}

}  // namespace bspline_curve

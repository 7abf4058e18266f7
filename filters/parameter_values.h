// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/filter_description.h"
#include "filters/parameter_value.h"

#include <map>
#include <string>
#include <string_view>

namespace bspline_curve {

/// A value for each parameter of a filter: what the user gave, else the default.
class ParameterValues {
public:
    /// All defaults. `filter` must outlive this.
    explicit ParameterValues(const FilterDescription& filter);

    /// Throws InputError (BadOption) where an enumeration has no such option, naming those that it
    /// has; std::out_of_range or std::invalid_argument where there is no such parameter or where it
    /// has another type: a bug of the caller. Ranges are checked by requests (see curveRequest()).
    void set(std::string_view id, ParameterValue value);

    /// The option with this number, of an enumeration. Throws as set() does.
    void setOption(std::string_view id, int option);

    template <class Value>
    [[nodiscard]] const Value& get(std::string_view id) const {
        return std::get<Value>(value(id));
    }

    [[nodiscard]] const ParameterValue& value(std::string_view id) const;

    [[nodiscard]] const FilterDescription& filter() const { return *filter_; }

private:
    const FilterDescription* filter_;
    std::map<std::string, ParameterValue, std::less<>> values_;
};

}  // namespace bspline_curve

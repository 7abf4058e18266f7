// SPDX-License-Identifier: GPL-3.0-or-later
#include "python/core/option_values.h"

#include "filters/option_bindings.h"

#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/variant.h>
#include <nanobind/stl/vector.h>

#include <array>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace bspline_curve::python {

namespace {

namespace nb = nanobind;

ParameterValue valueOf(nb::handle value) {
    if (nb::isinstance<nb::bool_>(value)) {
        return nb::cast<bool>(value);
    }
    if (nb::isinstance<nb::int_>(value)) {
        return nb::cast<int>(value);
    }
    if (nb::isinstance<nb::float_>(value)) {
        return nb::cast<double>(value);
    }
    if (nb::isinstance<nb::tuple>(value)) {  // tolerances of picks
        std::string list;
        for (const nb::handle each : value) {
            list.append(list.empty() ? "" : ",").append(nb::cast<std::string>(each));
        }
        return list;
    }
    return nb::cast<std::string>(value);
}

template <class Options>
void readChosen(const nb::dict& values, const Bindings<Options>& bindings, Options& options) {
    if (values.empty()) {
        return;
    }
    for (const Binding<Options>& binding : bindings) {
        const nb::str id(binding.id.c_str());
        if (values.contains(id)) {
            binding.read(valueOf(values[id]), options);
        }
    }
    options.validate();
}

}  // namespace

CurveOptions curveOptions(const nb::dict& values) {
    static const Bindings<SolverOptions> ofSolver = solverBindings();
    static const Bindings<SamplingOptions> ofSampling = samplingBindings();
    CurveOptions options;
    if (values.contains("preset") && nb::cast<std::string>(values["preset"]) == "paper") {
        options.solver = paperPreset();
    }
    readChosen(values, ofSolver, options.solver);
    readChosen(values, ofSampling, options.sampling);
    if (values.contains("pick_tolerance")) {
        options.pickTolerances =
            pickTolerancesOf(std::get<std::string>(valueOf(values["pick_tolerance"])));
    }
    if (values.contains("corners")) {
        const nb::handle corners = values["corners"];
        options.corners.areAll = nb::isinstance<nb::str>(corners);  // "all"
        if (!options.corners.areAll) {
            options.corners.ids = nb::cast<std::vector<int>>(corners);
        }
    }
    if (values.contains("tangents")) {
        for (const nb::handle entry : values["tangents"]) {
            // Of a corner two, or None.
            using Direction = std::array<double, 3>;
            using Two = std::pair<std::optional<Direction>, std::optional<Direction>>;
            const auto [pick, given] =
                nb::cast<std::pair<int, std::variant<Direction, Two>>>(entry);
            const auto vectorOf = [](const std::optional<Direction>& d) {
                return d ? Vec3((*d)[0], (*d)[1], (*d)[2]) : Vec3(Vec3::Zero());
            };
            const auto* const two = std::get_if<Two>(&given);
            options.tangents.entries.emplace_back(
                pick,
                two != nullptr ? PickTangent{vectorOf(two->first), vectorOf(two->second)}
                               : PickTangent::along(vectorOf(std::get<Direction>(given)))
            );
        }
    }
    return options;
}

PreparingOptions preparingOptions(const nb::dict& values) {
    static const Bindings<ShellOptions> ofShell = shellBindings();
    PreparingOptions options;
    readChosen(values, ofShell, options.shell);
    const auto read = [&](const char* id, auto& member) {
        if (values.contains(id)) {
            member = nb::cast<std::decay_t<decltype(member)>>(values[id]);
        }
    };
    read("strict", options.mending.strict);
    read("weld", options.mending.weld);
    read("slits", options.mending.slits);
    return options;
}

FieldOptions fieldOptions(const nb::dict& values) {
    static const Bindings<FieldOptions> bindings = fieldBindings("kind", "");
    FieldOptions options;
    readChosen(values, bindings, options);
    return options;
}

}  // namespace bspline_curve::python

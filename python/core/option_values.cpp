// SPDX-License-Identifier: GPL-3.0-or-later
#include "python/core/option_values.h"

#include "filters/option_bindings.h"

#include <nanobind/stl/string.h>

#include <string>

namespace bspline_curve::python {

namespace {

namespace nb = nanobind;

ParameterValue valueOf(nb::handle given) {
    if (nb::isinstance<nb::bool_>(given)) {
        return nb::cast<bool>(given);
    }
    if (nb::isinstance<nb::int_>(given)) {
        return nb::cast<int>(given);
    }
    if (nb::isinstance<nb::float_>(given)) {
        return nb::cast<double>(given);
    }
    return nb::cast<std::string>(given);
}

template <class Options>
void readGiven(const nb::dict& values, const Bindings<Options>& bindings, Options& options) {
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
    readGiven(values, ofSolver, options.solver);
    readGiven(values, ofSampling, options.sampling);
    return options;
}

ShellOptions shellOptions(const nb::dict& values) {
    static const Bindings<ShellOptions> bindings = shellBindings();
    ShellOptions options;
    readGiven(values, bindings, options);
    return options;
}

FieldOptions fieldOptions(const nb::dict& values) {
    static const Bindings<FieldOptions> bindings = fieldBindings("kind", "");
    FieldOptions options;
    readGiven(values, bindings, options);
    return options;
}

}  // namespace bspline_curve::python

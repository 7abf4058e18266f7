// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "bspline_curve/field.h"
#include "bspline_curve/options.h"
#include "bspline_curve/shell.h"
#include "filters/parameter_values.h"
#include "filters/requests.h"

#include <functional>
#include <string>
#include <vector>

// Which parameter of the filters sets which member of the libraries' options.
namespace bspline_curve {

template <class Options>
struct Binding {
    std::string id;  ///< of the parameter
    /// Sets the member. Options of enumerations that stand for no enumerator (preset, natural,
    /// none) leave it as it is.
    std::function<void(const ParameterValue&, Options&)> read;
    /// The value that sets the member to what it is.
    std::function<ParameterValue(const Options&)> write;
};

template <class Options>
using Bindings = std::vector<Binding<Options>>;

/// Sets all members that are bound to what the user gave.
template <class Options>
void readAll(const ParameterValues& values, const Bindings<Options>& bindings, Options& options) {
    for (const Binding<Options>& binding : bindings) {
        binding.read(values.value(binding.id), options);
    }
}

[[nodiscard]] Bindings<SolverOptions> solverBindings();
/// What the text of pick_tolerance says that SolverOptions::pickTolerance does not: none where it
/// is one length for all picks. Throws InputError (BadOption).
[[nodiscard]] PickTolerances pickTolerancesOf(const std::string& text);
[[nodiscard]] Bindings<SamplingOptions> samplingBindings();
[[nodiscard]] Bindings<ShellOptions> shellBindings();

/// `kind`: the parameter that says which field; `prefix` goes before the ids of the others.
[[nodiscard]] Bindings<FieldOptions> fieldBindings(
    const std::string& kind, const std::string& prefix
);

/// What the requests hold besides these.
[[nodiscard]] Bindings<CurveRequest> curveBindings();
[[nodiscard]] Bindings<FaceChoice> avoidBindings();
[[nodiscard]] Bindings<FaceChoice> regionBindings(const std::string& prefix);

}  // namespace bspline_curve

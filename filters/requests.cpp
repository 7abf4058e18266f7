// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/requests.h"

#include "bspline_curve/error.h"
#include "filters/option_bindings.h"
#include "text/error_messages.h"

#include <cmath>

namespace bspline_curve {

namespace {

// What is left at its default is what the preset says.
template <class Options>
void readBesidePreset(
    const ParameterValues& values, const Bindings<Options>& bindings, Options& options
) {
    for (const Binding<Options>& binding : bindings) {
        const ParameterValue& value = values.value(binding.id);
        if (value != curveFilter().parameter(binding.id).defaultValue) {
            binding.read(value, options);
        }
    }
}

FieldRequest readField(
    const ParameterValues& values, const std::string& kind, const std::string& prefix
) {
    FieldRequest request;
    readAll(values, fieldBindings(kind, prefix), request.options);
    readAll(values, regionBindings(prefix), request.region);
    request.options.validate();
    return request;
}

// The quality may have any unit, so it is mapped to [0, 1].
FieldRequest automaticField(const ParameterValues& values) {
    FieldRequest request = readField(values, "field", "field_");
    request.options.kind = FieldKind::Quality;
    request.options.normalised = true;
    request.automatic = true;
    return request;
}

}  // namespace

void checkLength(const std::string& what, double length) {
    if (!(length >= 0.0) || !std::isfinite(length)) {
        throw InputError(
            InputErrorCode::BadOption,
            what + " is " + describeNumber(length) + ", but must be finite and not negative"
        );
    }
}

MendingOptions mendingOptions(const ParameterValues& values) {
    const double most = values.filter().parameter("weld").max.value_or(0.0);
    const MendingOptions mending{
        .strict = values.get<bool>("strict"),
        .weld = values.get<double>("weld"),
        .slits = values.get<bool>("slits")
    };
    if (!(mending.weld >= 0.0) || mending.weld > most) {
        throw InputError(
            InputErrorCode::BadOption,
            "weld is " + describeNumber(mending.weld) + ", but must be in [0, " +
                describeNumber(most) + "]"
        );
    }
    mending.validate();
    return mending;
}

CurveRequest curveRequest(const ParameterValues& values) {
    CurveRequest request;
    readAll(values, curveBindings(), request);
    readAll(values, avoidBindings(), request.avoid);
    const auto& field = values.get<std::string>("field");
    if (field == kAutomaticField) {
        // A threshold of faces to avoid is a use of the quality already.
        if (!request.avoid.hasThreshold()) {
            request.field = automaticField(values);
        }
    } else if (field != kNoField) {
        request.field = readField(values, "field", "field_");
    }
    if (values.get<std::string>("preset") == "paper") {
        request.solver = paperPreset();
        request.shell.kind = ShellKind::Simplified;
        readBesidePreset(values, solverBindings(), request.solver);
    } else {
        readAll(values, solverBindings(), request.solver);
    }
    request.pickTolerances = pickTolerancesOf(values.get<std::string>("pick_tolerance"));
    readAll(values, samplingBindings(), request.sampling);
    readAll(values, shellBindings(), request.shell);
    request.solver.validate();
    request.sampling.validate();
    request.shell.validate();
    checkLength("tube radius", request.tubeRadius);
    request.mending = mendingOptions(values);
    return request;
}

FieldLayerRequest fieldRequest(const ParameterValues& values) {
    return {readField(values, "kind", ""), mendingOptions(values)};
}

}  // namespace bspline_curve

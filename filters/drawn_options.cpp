// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/drawn_options.h"

#include "filters/option_bindings.h"

#include <algorithm>

namespace bspline_curve {

namespace {

template <class Options>
bool areSame(const Bindings<Options>& bindings, const Options& a, const Options& b) {
    return std::ranges::all_of(bindings, [&](const Binding<Options>& binding) {
        return binding.write(a) == binding.write(b);
    });
}

bool areSame(const std::optional<FieldRequest>& a, const std::optional<FieldRequest>& b) {
    if (!a || !b) {
        return a.has_value() == b.has_value();
    }
    return areSame(fieldBindings("field", "field_"), a->options, b->options) &&
           areSame(regionBindings("field_"), a->region, b->region);
}

std::string avoidedOf(const CurveRequest& request) {
    return std::get<std::string>(avoidBindings().front().write(request.avoid));
}

std::string fieldOf(const CurveRequest& request) {
    if (!request.field) {
        return kNoField;
    }
    return request.field->automatic ? kAutomaticField : name(request.field->options.kind);
}

}  // namespace

const std::vector<std::string>& drawnParameters() {
    static const std::vector<std::string> ids = {
        "closed",
        "degree",
        "tension",
        "field",
        "field_weight",
        "pick_tolerance",
        "avoid",
        "avoid_threshold"
    };
    return ids;
}

ParameterValues valuesOf(const DrawnOptions& options) {
    ParameterValues values(curveFilter());
    values.set("closed", options.closed);
    values.set("degree", options.degree);
    values.set("tension", options.tension);
    values.set("pick_tolerance", options.pickTolerance);
    values.set("field", options.field);
    values.set("field_weight", options.fieldWeight);
    values.set("avoid", options.avoid);
    values.set("avoid_threshold", options.avoidThreshold);
    return values;
}

DrawnOptions drawnOptionsOf(const ParameterValues& values) {
    return {
        .closed = values.get<bool>("closed"),
        .degree = values.get<int>("degree"),
        .tension = values.get<double>("tension"),
        .pickTolerance = values.get<std::string>("pick_tolerance"),
        .field = values.get<std::string>("field"),
        .fieldWeight = values.get<double>("field_weight"),
        .avoid = values.get<std::string>("avoid"),
        .avoidThreshold = values.get<double>("avoid_threshold"),
    };
}

std::optional<DrawnOptions> drawnOptions(const CurveRequest& request) {
    const DrawnOptions options{
        .closed = request.solver.closed,
        .degree = request.solver.degree,
        .tension = request.solver.tension,
        .pickTolerance = describe(request.solver.pickTolerance),
        .field = fieldOf(request),
        .fieldWeight = request.solver.fieldWeight,
        .avoid = avoidedOf(request),
        .avoidThreshold = request.avoid.threshold,
    };
    CurveRequest same = curveRequest(valuesOf(options));
    same.solver.pickDistance = request.solver.pickDistance;  // what is drawn has its picks on it
    const bool isOffered = areSame(solverBindings(), request.solver, same.solver) &&
                           areSame(samplingBindings(), request.sampling, same.sampling) &&
                           areSame(shellBindings(), request.shell, same.shell) &&
                           areSame(request.field, same.field) && request.mending == same.mending &&
                           request.pickTolerances == same.pickTolerances;
    return isOffered ? std::optional(options) : std::nullopt;
}

}  // namespace bspline_curve

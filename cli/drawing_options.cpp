// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/drawing_options.h"

#include "cli/field_input.h"
#include "filters/requests.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>

namespace bspline_curve::cli {

namespace {

constexpr const char* kAdvanced = "Advanced options";
constexpr const char* kFieldGroup = "Options of the field";
constexpr const char* kFieldPrefix = "--field-";

/// Parameters of the filter that have no meaning here: layers, selections, and files, which the
/// program has options of its own for.
constexpr std::array<std::string_view, 10> kOfHosts = {
    "surface_layer",
    "picks_layer",
    "picks_file",
    "picks",
    "field_region",
    "tube_radius",
    "save",
    "control_polygon",
    "shell_layers",
    "replace"
};

/// Those that say how the mesh is mended.
constexpr std::array<std::string_view, 2> kOfMending = {"strict", "weld"};

std::string groupOf(const ParameterDescription& parameter) {
    if (parameter.group == "advanced.field") {
        return kFieldGroup;
    }
    return parameter.isAdvanced() ? kAdvanced : kMainGroup;
}

}  // namespace

DrawingOptions::DrawingOptions(CLI::App& app, CurveArguments& arguments)
    : app_(app), arguments_(arguments), options_(app, curveFilter()) {}

void DrawingOptions::addAll() {
    for (const ParameterDescription& parameter : curveFilter().parameters) {
        if (std::ranges::find(kOfHosts, parameter.id) == kOfHosts.end()) {
            options_.add(parameter.id, groupOf(parameter), extrasOf(parameter.id));
        }
    }
    addRegionOptions(app_, kFieldGroup, kFieldPrefix, arguments_.fieldRegion);
}

void DrawingOptions::addForUses(const std::string& group) {
    for (const ParameterDescription& parameter : curveFilter().parameters) {
        if (std::ranges::find(kOfHosts, parameter.id) != kOfHosts.end()) {
            continue;
        }
        const bool isOfMending = std::ranges::find(kOfMending, parameter.id) != kOfMending.end();
        options_.add(parameter.id, isOfMending ? kMainGroup : group, extrasOf(parameter.id));
    }
    addRegionOptions(app_, group, kFieldPrefix, arguments_.fieldRegion);
}

bool DrawingOptions::isAnyGivenForDrawing() const {
    return options_.isAnyGivenBut(kOfMending) || arguments_.fieldRegion.isGiven();
}

void DrawingOptions::finish() {
    if (!fieldFile_.empty()) {
        // The values of a file are treated as those of a mesh.
        options_.setDefault("field", std::string(name(FieldKind::Quality)));
    }
    const CurveRequest request = curveRequest(options_.values());
    arguments_.solver = request.solver;
    arguments_.sampling = request.sampling;
    arguments_.shell = request.shell;
    arguments_.mending = request.mending;
    setField(request);
    setAvoided(request);
}

OptionExtras DrawingOptions::extrasOf(std::string_view id) {
    if (id == "tension") {
        return {.aliases = ",--lambda"};
    }
    if (id == "field_weight") {
        return {.aliases = ",--mu"};
    }
    if (id == "field") {
        return {.file = &fieldFile_, .fileHelp = ".npy, or a text of one number per vertex."};
    }
    if (id == "avoid_threshold") {
        return {.hasDefault = false};  // --avoid needs it
    }
    if (id == "avoid") {
        return {
            .file = &avoidFile_,
            .fileHelp = "ids of the faces from 0 on, .npy of integers or a text."
        };
    }
    return {};
}

void DrawingOptions::setField(const CurveRequest& request) {
    arguments_.fieldOptions.kind = FieldKind::Quality;
    if (request.field) {
        arguments_.fieldOptions = request.field->options;
        arguments_.field = request.field->automatic ? kAutomaticField
                           : fieldFile_.empty()     ? name(arguments_.fieldOptions.kind)
                                                    : fieldFile_;
    }
    checkRegion(arguments_.fieldRegion, arguments_.fieldOptions.kind, kFieldPrefix);
}

void DrawingOptions::setAvoided(const CurveRequest& request) {
    const bool isUnder = request.avoid == Avoid::UnderThreshold;
    const bool isOver = request.avoid == Avoid::OverThreshold;
    const bool needsThreshold = avoidFile_.empty() && (isUnder || isOver);
    if (needsThreshold != options_.isGiven("avoid_threshold")) {
        throw CLI::ValidationError(
            "--avoid-threshold is for --avoid under-threshold and --avoid over-threshold, "
            "which "
            "need it"
        );
    }
    arguments_.avoid.file = avoidFile_;
    if (needsThreshold) {
        (isUnder ? arguments_.avoid.under : arguments_.avoid.over) = request.avoidThreshold;
    }
}

}  // namespace bspline_curve::cli

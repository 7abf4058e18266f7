// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/drawing_options.h"

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
constexpr std::array<std::string_view, 3> kOfMending = {"strict", "weld", "slits"};

std::string groupOf(const ParameterDescription& parameter) {
    if (parameter.group == "advanced.field") {
        return kFieldGroup;
    }
    return parameter.isAdvanced() ? kAdvanced : kMainGroup;
}

}  // namespace

DrawingOptions::DrawingOptions(CLI::App& app, DrawingArguments& arguments)
    : app_(app), arguments_(arguments), options_(app, curveFilter()) {}

void DrawingOptions::add(const std::string& group) {
    for (const ParameterDescription& parameter : curveFilter().parameters) {
        const std::string& id = parameter.id;
        if (std::ranges::find(kOfHosts, id) == kOfHosts.end()) {
            const bool isOfMending = std::ranges::find(kOfMending, id) != kOfMending.end();
            const std::string used = isOfMending ? kMainGroup : group;
            options_.add(id, extrasOf(id), group.empty() ? groupOf(parameter) : used);
        }
    }
    region_ =
        std::make_unique<RegionOptions>(app_, group.empty() ? kFieldGroup : group, kFieldPrefix);
}

bool DrawingOptions::isAnyGivenForDrawing() const {
    return options_.isAnyGivenBut(kOfMending) || region_->isGiven();
}

void DrawingOptions::finish() {
    if (!valuesFile_.empty()) {
        // The values of a file are treated as those of a mesh.
        options_.set("field", std::string(name(FieldKind::Quality)));
    }
    CurveRequest request = curveRequest(options_.values());
    const FaceChoice& region =
        region_->choice(request.field ? request.field->options.kind : FieldKind::Quality);
    if (request.field) {
        request.field->region = region;
    }
    checkThreshold(request.avoid);
    if (!avoidFile_.empty()) {
        request.avoid = {.by = FaceChoice::By::Ids};
    }
    arguments_.values = valuesFile_;
    arguments_.region = region_->file();
    arguments_.avoided = avoidFile_;
    static_cast<CurveOptions&>(arguments_) = static_cast<const CurveOptions&>(request);
    static_cast<PreparingOptions&>(arguments_) = static_cast<const PreparingOptions&>(request);
}

OptionExtras DrawingOptions::extrasOf(std::string_view id) {
    if (id == "tension") {
        return {.aliases = ",--lambda"};
    }
    if (id == "field_weight") {
        return {.aliases = ",--mu"};
    }
    if (id == "field") {
        return {
            .other = &valuesFile_,
            .otherHelp = "Or a file: .npy, or a text of one number per vertex."
        };
    }
    if (id == "avoid_threshold") {
        return {.hasDefault = false};  // --avoid needs it
    }
    if (id == "avoid") {
        return {
            .other = &avoidFile_,
            .otherHelp = "Or a file: ids of the faces from 0 on, .npy of integers or a text."
        };
    }
    return {};
}

void DrawingOptions::checkThreshold(const FaceChoice& avoid) const {
    const bool isNeeded = avoidFile_.empty() && avoid.hasThreshold();
    if (isNeeded != options_.isGiven("avoid_threshold")) {
        throw CLI::ValidationError(
            "--avoid-threshold is for --avoid under-threshold and --avoid over-threshold, which "
            "need it"
        );
    }
}

}  // namespace bspline_curve::cli

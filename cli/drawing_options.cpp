// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/drawing_options.h"

#include "cli/manual.h"
#include "filters/requests.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <utility>

namespace bspline_curve::cli {

namespace {

constexpr const char* kFieldGroup = "Field";
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

/// The groups of the filter's dialog, in fewer groups of the help.
constexpr std::array<std::pair<std::string_view, const char*>, 9> kGroups{{
    {"further.picks", "Picks"},
    {"further.field", kFieldGroup},
    {"advanced.field", kFieldGroup},
    {"further.avoid", "Faces to avoid"},
    {"advanced.avoid", "Faces to avoid"},
    {"further.polyline", "Polyline"},
    {"further.shell", "Shell and limits"},
    {"advanced.shell", "Shell and limits"},
    {"advanced.limits", "Shell and limits"},
}};

/// Settings of the method that are not of the paper alone.
constexpr std::array<std::string_view, 2> kOfMethod = {"preset", "distance_tolerance"};

bool isOfPaper(const ParameterDescription& parameter) {
    return parameter.group == "advanced.paper" ||
           (parameter.group == "advanced.method" &&
            std::ranges::find(kOfMethod, parameter.id) == kOfMethod.end());
}

std::string groupOf(const ParameterDescription& parameter) {
    if (isOfPaper(parameter)) {
        return std::string(kPaperGroup);
    }
    const auto* const found =
        std::ranges::find(kGroups, parameter.group, [](const auto& each) { return each.first; });
    return found == kGroups.end() ? kMainGroup : found->second;
}

}  // namespace

DrawingOptions::DrawingOptions(CLI::App& app, DrawingArguments& arguments)
    : app_(app), arguments_(arguments), options_(app, curveFilter()) {}

void DrawingOptions::add(const std::string& group) {
    for (const ParameterDescription& parameter : curveFilter().parameters) {
        const std::string& id = parameter.id;
        if (std::ranges::find(kOfHosts, id) == kOfHosts.end()) {
            const bool isSorted = group.empty() || isOfPaper(parameter);
            options_.add(id, extrasOf(id), isSorted ? groupOf(parameter) : group);
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

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve_options.h"
#include "cli/described_options.h"
#include "cli/region_options.h"

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace bspline_curve::cli {

/// What a command line says of drawing curves, whatever their picks.
struct DrawingArguments : CurveOptions, PreparingOptions {
    std::filesystem::path mesh;
    /// Values of the field, faces of its region and faces to avoid; empty: not from files.
    std::filesystem::path values, region, avoided;
    bool noCache = false;
};

/// The options that say how a curve is drawn, without files: of the verb curve, and of all that
/// take --picks.
class DrawingOptions {
public:
    /// Both must outlive this.
    DrawingOptions(CLI::App& app, DrawingArguments& arguments);

    /// Declares them, in groups of their own; or in one group, but those of mending, which are for
    /// every mesh, and the settings of the paper.
    void add(const std::string& group = "");

    /// Whether one of them was on the command line that is of use for drawing only.
    [[nodiscard]] bool isAnyGivenForDrawing() const;

    /// Makes the arguments of what was given, after parsing. Throws CLI::ParseError, InputError
    /// (BadOption).
    void finish();

private:
    [[nodiscard]] OptionExtras extrasOf(std::string_view id);
    /// Throws CLI::ValidationError where there is a threshold without a use, or none for one.
    void checkThreshold(const FaceChoice& avoid) const;

    CLI::App& app_;
    DrawingArguments& arguments_;
    std::string valuesFile_, avoidFile_;  // empty: none
    DescribedOptions options_;
    std::unique_ptr<RegionOptions> region_;
};

}  // namespace bspline_curve::cli

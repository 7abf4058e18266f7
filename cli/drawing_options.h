// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/curve_options.h"
#include "cli/described_options.h"

#include <string>
#include <string_view>

namespace bspline_curve {
struct CurveRequest;
}  // namespace bspline_curve

namespace bspline_curve::cli {

/// The options that say how a curve is drawn, without files: of the verb curve, and of all that
/// take --picks.
class DrawingOptions {
public:
    /// Both must outlive this.
    DrawingOptions(CLI::App& app, CurveArguments& arguments);

    /// Declares them, in groups of their own.
    void addAll();
    /// Declares them in one group; those of mending, which are for every mesh, with the main ones.
    void addForUses(const std::string& group);

    /// Whether one of them was on the command line that is of use for drawing only.
    [[nodiscard]] bool isAnyGivenForDrawing() const;

    /// Makes the arguments of what was given, after parsing. Throws CLI::ParseError, InputError
    /// (BadOption).
    void finish();

private:
    [[nodiscard]] OptionExtras extrasOf(std::string_view id);
    void setField(const CurveRequest& request);
    /// Throws CLI::ValidationError where there is a threshold without a use, or none for one.
    void setAvoided(const CurveRequest& request);

    CLI::App& app_;
    CurveArguments& arguments_;
    std::string fieldFile_, avoidFile_;  // empty: none
    DescribedOptions options_;
};

}  // namespace bspline_curve::cli

// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/region_options.h"

#include "bspline_curve/files.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <tuple>
#include <utility>

namespace bspline_curve::cli {

RegionOptions::RegionOptions(CLI::App& app, const std::string& group, std::string prefix)
    : prefix_(std::move(prefix)) {
    using By = FaceChoice::By;
    options_.push_back(
        app.add_option(
               prefix_ + "region",
               file_,
               "Obstacle: the region, as ids of faces from 0 on: a .npy file of integers or a text"
        )
            ->type_name("FILE")
    );
    for (const auto& [name, by, help] :
         {std::tuple(
              "region-under",
              By::UnderThreshold,
              "Obstacle: the region is the faces whose mean quality (of a .ply mesh) is under this"
          ),
          std::tuple("region-over", By::OverThreshold, "Likewise over this")}) {
        const auto keep = [this, kind = by](double threshold) {
            choice_ = {.by = kind, .threshold = threshold};
        };
        options_.push_back(
            app.add_option_function<double>(prefix_ + name, keep, help)->type_name("X")
        );
    }
    for (CLI::Option* const option : options_) {
        option->group(group);
    }
}

int RegionOptions::count() const {
    return static_cast<int>(std::ranges::count_if(options_, [](const CLI::Option* option) {
        return option->count() > 0;
    }));
}

const FaceChoice& RegionOptions::choice(FieldKind kind) const {
    const std::string names =
        prefix_ + "region, " + prefix_ + "region-under, " + prefix_ + "region-over";
    if (count() > 1) {
        throw CLI::ValidationError("only one of " + names + " can be used");
    }
    if (kind == FieldKind::Obstacle && !isGiven()) {
        throw CLI::ValidationError("the field obstacle needs one of " + names);
    }
    if (kind != FieldKind::Obstacle && isGiven()) {
        throw CLI::ValidationError(names + " are for the field obstacle only");
    }
    return choice_;
}

Region regionOf(const std::filesystem::path& file, const TriangleMesh& mesh) {
    return makeRegion(mesh, readFaceIds(file));
}

}  // namespace bspline_curve::cli

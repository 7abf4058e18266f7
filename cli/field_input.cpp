// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/field_input.h"

#include "cli/mesh_input.h"
#include "design/curve_on_given_mesh.h"
#include "io/region_reader.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdint>

namespace bspline_curve::cli {

namespace {

std::span<const double> qualityForThreshold(const GivenMesh& given) {
    if (given.quality.empty()) {
        refuseMissingQuality(given.file);
    }
    return given.quality;
}

}  // namespace

void addRegionOptions(
    CLI::App& app, const std::string& group, const std::string& prefix, RegionArguments& region
) {
    app.add_option(
           prefix + "region",
           region.file,
           "Obstacle: the region, as ids of faces from 0 on: a .npy file of integers or a text"
    )
        ->type_name("FILE")
        ->group(group);
    app.add_option(
           prefix + "region-under",
           region.under,
           "Obstacle: the region is the faces whose mean quality (of a .ply mesh) is under this"
    )
        ->type_name("X")
        ->group(group);
    app.add_option(prefix + "region-over", region.over, "Likewise over this")
        ->type_name("X")
        ->group(group);
}

void checkRegion(const RegionArguments& region, FieldKind kind, const std::string& prefix) {
    const int sources =
        (region.file.empty() ? 0 : 1) + (region.under ? 1 : 0) + (region.over ? 1 : 0);
    const std::string options =
        prefix + "region, " + prefix + "region-under, " + prefix + "region-over";
    if (sources > 1) {
        throw CLI::ValidationError("only one of " + options + " may be given");
    }
    if (kind == FieldKind::Obstacle && sources == 0) {
        throw CLI::ValidationError("the field obstacle needs one of " + options);
    }
    if (kind != FieldKind::Obstacle && sources > 0) {
        throw CLI::ValidationError(options + " are for the field obstacle only");
    }
}

std::optional<FieldKind> findFieldKind(const std::string& word) {
    const auto* const kind = std::ranges::find_if(kFieldKinds, [&](FieldKind candidate) {
        return word == name(candidate);
    });
    return kind == kFieldKinds.end() ? std::nullopt : std::optional(*kind);
}

Region readRegion(const RegionArguments& region, const Surface& surface, const GivenMesh& given) {
    if (!region.file.empty()) {
        const std::vector<std::int64_t> ids = readFaceIds(region.file);
        Region faces = makeRegion(given.faces, ids);
        return given.repair == nullptr ? faces : facesOfMended(faces, *given.repair);
    }
    if (region.under) {
        return facesUnder(surface, qualityForThreshold(given), *region.under);
    }
    return region.over ? facesOver(surface, qualityForThreshold(given), *region.over) : Region();
}

}  // namespace bspline_curve::cli

// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/field_input.h"

#include "cli/mesh_input.h"
#include "design/curve_on_given_mesh.h"
#include "io/region_reader.h"
#include "surface/error_messages.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdint>
#include <iterator>

namespace bspline_curve::cli {

namespace {

void refuseUnknownFaces(const std::vector<std::int64_t>& ids, int faceCount) {
    std::vector<std::int64_t> unknown;
    std::ranges::copy_if(ids, std::back_inserter(unknown), [&](std::int64_t id) {
        return id < 0 || id >= faceCount;
    });
    if (!unknown.empty()) {
        refuseElements(
            InputErrorCode::IndexOutOfRange,
            describeCount(unknown.size(), "id of the region is", "ids of the region are") +
                " no face of the mesh",
            "ids",
            unknown,
            "faces are numbered from 0 to " + std::to_string(faceCount - 1)
        );
    }
}

/// Ids of the mesh that was given as ids of the mended one: of every part of those faces.
std::vector<std::int64_t> carriedOver(
    const std::vector<std::int64_t>& ids, const GivenMesh& given
) {
    refuseUnknownFaces(ids, given.faces);
    const std::vector<int> faces =
        facesOfMended(std::vector<int>(ids.begin(), ids.end()), *given.repair);
    return {faces.begin(), faces.end()};
}

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
        return makeRegion(surface, given.repair == nullptr ? ids : carriedOver(ids, given));
    }
    if (region.under) {
        return facesUnder(surface, qualityForThreshold(given), *region.under);
    }
    return region.over ? facesOver(surface, qualityForThreshold(given), *region.over) : Region();
}

}  // namespace bspline_curve::cli

// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/field_input.h"

#include "cli/mesh_input.h"
#include "io/region_reader.h"
#include "surface/input_error.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace bspline_curve::cli {

namespace {

/// Ids of the mesh that was given as ids of the repaired one: of every part of those faces.
std::vector<std::int64_t> carriedOver(
    const std::vector<std::int64_t>& ids, const GivenMesh& given
) {
    std::vector<char> isNamed(static_cast<std::size_t>(given.faces), 0);
    std::vector<std::int64_t> unknown;
    for (const std::int64_t id : ids) {
        if (id < 0 || id >= given.faces) {
            unknown.push_back(id);
        } else {
            isNamed[static_cast<std::size_t>(id)] = 1;
        }
    }
    if (!unknown.empty()) {
        refuseElements(
            InputErrorCode::IndexOutOfRange,
            describeCount(unknown.size(), "id of the region is", "ids of the region are") +
                " no face of the mesh",
            "ids",
            unknown,
            "faces are numbered from 0 to " + std::to_string(given.faces - 1)
        );
    }
    std::vector<std::int64_t> result;
    for (std::size_t face = 0; face < given.repair->faceOrigins.size(); ++face) {
        if (isNamed[static_cast<std::size_t>(given.repair->faceOrigins[face])] != 0) {
            result.push_back(static_cast<std::int64_t>(face));
        }
    }
    return result;
}

std::span<const double> qualityForThreshold(const GivenMesh& given) {
    if (given.quality.empty()) {
        refuseMissingQuality(given.file);
    }
    return given.quality;
}

}  // namespace

void addFieldOptions(OptionTable<FieldOptions>& table, const std::string& prefix) {
    using F = FieldOptions;
    const auto number =
        [&](const char* flag, double F::* member, const Interval<double>& range, const char* help) {
            table.number((prefix + flag).c_str(), member, range, help);
        };
    number(
        "curvature-scale",
        &F::curvatureScale,
        within(0.0, 1.0),
        "Curvature, ridge, valley: radius that curvatures are averaged over, relative to the "
        "mesh's diagonal"
    );
    number(
        "crease-angle",
        &F::creaseAngle,
        within(0.0, 180.0),
        "Crease distance: creases turn by more than this, in degrees"
    );
    number(
        "reach",
        &F::reach,
        withinAbove(0.0, 1.0),
        "Crease and boundary distance: the distance that becomes 1, relative to the diagonal"
    );
    number(
        "obstacle-value",
        &F::obstacleValue,
        atLeast(0.0),
        "Obstacle: value on the region's boundary"
    );
    number(
        "obstacle-slope",
        &F::obstacleSlope,
        moreThan(0.0),
        "Obstacle: growth from the boundary inwards, per diagonal"
    );
    number(
        "smoothing",
        &F::smoothing,
        within(0.0, 1.0),
        "Radius that the values are averaged over in the end, relative to the diagonal; 0: none"
    );
    table.flag(
        (prefix + "normalised").c_str(),
        &F::normalised,
        "Map the values to [0, 1], between their quantiles of 1 % and 99 %"
    );
    table.flag(
        (prefix + "inverted").c_str(), &F::inverted, "Let high and low values change places"
    );
}

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

std::vector<std::string> fieldKindNames() {
    std::vector<std::string> names;
    for (const FieldKind kind : kFieldKinds) {
        names.emplace_back(name(kind));
    }
    return names;
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

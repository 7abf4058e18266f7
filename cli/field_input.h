// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/field.h"
#include "surface/region.h"
#include "surface/repair.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>

namespace CLI {
class App;
}  // namespace CLI

// The regions of fields, as every verb has them, and what they are made from.
namespace bspline_curve::cli {

/// A region of faces as the command line names it: at most one of these.
struct RegionArguments {
    std::filesystem::path file;  ///< of face ids
    std::optional<double> under, over;

    [[nodiscard]] bool isGiven() const { return !file.empty() || under || over; }
};

/// The options of a region; `prefix` goes before the name: "--" or "--field-".
void addRegionOptions(
    CLI::App& app, const std::string& group, const std::string& prefix, RegionArguments& region
);

/// Throws CLI::ValidationError where a region is missing, named more than once, or not used by the
/// kind.
void checkRegion(const RegionArguments& region, FieldKind kind, const std::string& prefix);

/// None where no kind has this name.
[[nodiscard]] std::optional<FieldKind> findFieldKind(const std::string& word);

/// The mesh that ids and values of a command line belong to.
struct GivenMesh {
    std::filesystem::path file;
    int faces = 0;                       ///< before it was mended
    std::span<const double> quality;     ///< as mended, or empty
    const MeshRepair* repair = nullptr;  ///< null: the mesh is as it was given
};

/// The region, on the surface as mended; empty where none was named. Throws
/// InputError.
[[nodiscard]] Region readRegion(
    const RegionArguments& region, const Surface& surface, const GivenMesh& given
);

}  // namespace bspline_curve::cli

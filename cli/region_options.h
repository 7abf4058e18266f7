// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve_options.h"

#include <filesystem>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace bspline_curve::cli {

/// The options of a field's region, which is a selection in other hosts: a file, or a threshold.
class RegionOptions {
public:
    /// `prefix` goes before the names: "--" or "--field-". `app` must outlive this.
    RegionOptions(CLI::App& app, const std::string& group, std::string prefix);
    RegionOptions(const RegionOptions&) = delete;
    RegionOptions& operator=(const RegionOptions&) = delete;

    [[nodiscard]] bool isGiven() const { return count() > 0; }

    /// What was said; where it is a file, that is to be read into its ids. Throws
    /// CLI::ValidationError where the kind of field needs a region and there is none or more than
    /// one, or does not use it.
    [[nodiscard]] const FaceChoice& choice(FieldKind kind) const;

    [[nodiscard]] const std::filesystem::path& file() const { return file_; }

private:
    [[nodiscard]] int count() const;

    std::string prefix_;
    FaceChoice choice_{.by = FaceChoice::By::Ids};
    std::filesystem::path file_;
    std::vector<CLI::Option*> options_;
};

/// The faces of a file of ids. Throws InputError.
[[nodiscard]] Region regionOf(const std::filesystem::path& file, const TriangleMesh& mesh);

}  // namespace bspline_curve::cli

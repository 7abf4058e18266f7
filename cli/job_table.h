// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/batch_options.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace bspline_curve::cli {

/// A line of a jobs file: a curve to draw.
struct Job {
    std::size_t number = 0;              ///< from 1, in the order of the file
    std::string mesh, picks, output;     ///< as the file has them
    std::vector<std::string> arguments;  ///< of the verb curve, in the folder of the file
    std::string preparation;           ///< the same for jobs that share a mesh and its preparation
    std::filesystem::path outputPath;  ///< from where the program runs
    std::filesystem::path reportPath;  ///< likewise; empty: none asked for

    /// As words for a shell.
    [[nodiscard]] std::string command() const;
};

/// The selected jobs of a file, each a command line that is in order, no two of which write the
/// same file. Whether meshes and picks are, shows when the jobs run. Throws InputError
/// (UnreadableFile, UnwritableFile, BadOption) naming the file and the line.
[[nodiscard]] std::vector<Job> readJobs(const BatchArguments& arguments);

}  // namespace bspline_curve::cli

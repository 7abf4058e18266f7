// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/command.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace bspline_curve::cli {

/// Which jobs of a file to run, by their numbers from 1.
class JobSelection {
public:
    /// All of them.
    JobSelection() = default;
    /// "3", "2-5" or several with commas between. Throws CLI::ValidationError.
    explicit JobSelection(const std::string& text);

    [[nodiscard]] bool isAll() const { return ranges_.empty(); }

    [[nodiscard]] bool contains(std::size_t job) const;
    /// The largest number that was named; 0 for all.
    [[nodiscard]] std::size_t last() const;

private:
    std::vector<std::pair<std::size_t, std::size_t>> ranges_;
};

/// Everything that the command line of the verb batch says.
struct BatchArguments {
    std::filesystem::path jobs;
    std::filesystem::path results;  ///< beside the jobs where none was named
    int atOnce = 1;
    bool resume = false;
    bool dryRun = false;
    JobSelection only;
    std::optional<std::uint64_t> jobMemoryBytes;
};

/// Reads the command line; or, after --help or a wrong one, says how the program ends. Prints help
/// to stdout and one line about what is wrong to stderr.
[[nodiscard]] std::variant<BatchArguments, ExitCode> parseBatchArguments(Arguments arguments);

}  // namespace bspline_curve::cli

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
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

/// That command line, see runParsed().
struct BatchParser {
    BatchParser();

    [[nodiscard]] BatchArguments finish();

    CLI::App app{
        "Draws many curves, each in a process of its own: whatever happens to one, the others go "
        "on.\n\n"
        "Exit status: 0 all jobs are done; 1 some are not, or a bad jobs file, before anything "
        "runs;\n"
        "2 wrong usage; 130 interrupted by Ctrl-C, --resume goes on.\n",
        "bspline_curve batch"
    };
    BatchArguments arguments;
    std::string only;
    std::optional<double> jobMemory;
};

}  // namespace bspline_curve::cli

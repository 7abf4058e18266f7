// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/batch_options.h"

#include "cli/value_checks.h"
#include "cli/verb_parser.h"
#include "text/text_parsing.h"

#include <algorithm>
#include <cmath>
#include <thread>

namespace bspline_curve::cli {

namespace {

/// The number of a job; throws CLI::ValidationError.
std::size_t jobNumber(std::string_view word) {
    const auto number = parseInteger(word);
    if (!number || *number < 1) {
        throw CLI::ValidationError(
            "--only: " + std::string(word) + " is no number of a job, such as 3 or 2-5 or 1,4-6"
        );
    }
    return static_cast<std::size_t>(*number);
}

}  // namespace

BatchParser::BatchParser() {
    arguments.atOnce = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    app.add_option(
           "JOBS",
           arguments.jobs,
           "CSV with a header and a line per curve: columns mesh, picks, output, and any "
           "option of a curve by its name; empty: its default. Paths are relative to this "
           "file"
    )
        ->required()
        ->type_name("");
    app.add_option(
           "--results",
           arguments.results,
           "CSV to write, a line for each job as it ends; default: JOBS with the extension "
           ".results.csv"
    )
        ->type_name("FILE.csv");
    constexpr int kMostAtOnce = 4096;
    constexpr double kMostGibibytes = 1 << 20;
    app.add_option("--jobs", arguments.atOnce, "So many jobs at once; default: one per core")
        ->check(Interval<int>{.low = 1, .high = kMostAtOnce}.validator())
        ->type_name("N");
    app.add_flag(
        "--resume",
        arguments.resume,
        "Go on with the results file: jobs that it says are done, and whose output is there, "
        "are not run again"
    );
    app.add_option("--only", only, "Run these jobs of the file, counted from 1: 3, 2-5, 1,4-6")
        ->type_name("JOBS");
    app.add_option(
           "--job-memory",
           jobMemory,
           "A job that needs more memory than this fails, in GiB of address space; default: "
           "no limit"
    )
        ->check(Interval<double>{.low = 0.0, .high = kMostGibibytes, .withLow = false}.validator())
        ->type_name("GIB");
    app.add_flag(
        "--dry-run",
        arguments.dryRun,
        "Check the jobs file and print the command of each job; run nothing"
    );
}

BatchArguments BatchParser::finish() {
    arguments.only = only.empty() ? JobSelection() : JobSelection(only);
    if (arguments.results.empty()) {
        arguments.results = arguments.jobs;
        arguments.results.replace_extension(".results.csv");
    }
    if (jobMemory) {
        constexpr double kGibibyte = 1024.0 * 1024.0 * 1024.0;
        arguments.jobMemoryBytes = static_cast<std::uint64_t>(std::llround(*jobMemory * kGibibyte));
    }
    return arguments;
}

JobSelection::JobSelection(const std::string& text) {
    for (const std::string_view part : splitAt(text, ',')) {
        const std::size_t dash = part.find('-');
        const std::size_t first = jobNumber(part.substr(0, dash));
        const std::size_t last =
            dash == std::string_view::npos ? first : jobNumber(part.substr(dash + 1));
        if (last < first) {
            throw CLI::ValidationError("--only: " + std::string(part) + " runs backwards");
        }
        ranges_.emplace_back(first, last);
    }
}

bool JobSelection::contains(std::size_t job) const {
    return isAll() || std::ranges::any_of(ranges_, [&](const auto& range) {
               return range.first <= job && job <= range.second;
           });
}

std::size_t JobSelection::last() const {
    std::size_t result = 0;
    for (const auto& [first, last] : ranges_) {
        result = std::max(result, last);
    }
    return result;
}

}  // namespace bspline_curve::cli

// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/error.h"
#include "cli/job_table.h"
#include "cli/reports/job_results.h"
#include "fuzz/fuzz_file.h"
#include "fuzz/fuzz_target.h"

namespace bspline_curve::fuzz {

void readJobsBytes(std::string_view bytes) {
    const FuzzFile file("jobs.csv", bytes);
    cli::BatchArguments arguments;
    arguments.jobs = file.path();
    try {
        std::size_t last = 0;
        for (const cli::Job& job : cli::readJobs(arguments)) {
            require(job.number > last, "jobs are in the order of the file");
            require(!job.command().empty(), "a job is a command");
            last = job.number;
        }
    } catch (const InputError&) {
        return;
    }
}

void readResultsBytes(std::string_view bytes) {
    const FuzzFile file("results", bytes);
    try {
        for (const cli::JobRecord& record : cli::readJobRecords(file.path())) {
            require(!record.line().empty(), "a line of results can be written again");
        }
    } catch (const InputError&) {
        // a report may be in it all the same
    }
    try {
        static_cast<void>(cli::readCurveFigures(file.path()));
    } catch (const InputError&) {
        return;
    }
}

}  // namespace bspline_curve::fuzz

// SPDX-License-Identifier: GPL-3.0-or-later
// bspline_curve batch JOBS.csv …: many curves, each in a process of its own. So a job that crashes
// ends alone, and its memory is the system's again as soon as it ends.
#include "cli/batch_options.h"
#include "cli/child_process.h"
#include "cli/command.h"
#include "cli/interrupt.h"
#include "cli/job_table.h"
#include "cli/progress_bar.h"
#include "cli/temporary_folder.h"
#include "cli/verb.h"
#include "io/job_results.h"
#include "io/text_parsing.h"
#include "surface/input_error.h"
#include "utility/stopwatch.h"

#include <poll.h>

#include <algorithm>
#include <csignal>
#include <cstring>
#include <deque>
#include <iostream>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <variant>
#include <vector>

namespace bspline_curve::cli {

namespace {

using std::filesystem::path;

/// What is still to be done, and the lines of the results file that stay.
struct Plan {
    std::vector<Job> jobs;
    std::string kept;
    std::size_t doneBefore = 0;
};

/// Leaves out the jobs that the results file says are done, if their output is there. Lines of jobs
/// that were not selected stay.
Plan planResumed(const BatchArguments& arguments, std::vector<Job> jobs) {
    Plan plan;
    std::map<std::string, JobRecord> records;
    for (JobRecord& record : readJobRecords(arguments.results)) {
        std::string command = record.command();
        records.insert_or_assign(std::move(command), std::move(record));
    }
    for (Job& job : jobs) {
        const auto record = records.extract(oneLine(job.command()));
        if (record && record.mapped().isDone && std::filesystem::exists(job.outputPath)) {
            plan.kept += record.mapped().lineAs(job.number);
            ++plan.doneBefore;
        } else {
            plan.jobs.push_back(std::move(job));
        }
    }
    for (const auto& [command, record] : records) {
        plan.kept += arguments.only.isAll() ? "" : record.line();
    }
    return plan;
}

Plan planFor(const BatchArguments& arguments) {
    std::vector<Job> jobs = readJobs(arguments);
    const bool isThere = std::filesystem::exists(arguments.results);
    if (isThere && arguments.resume) {
        return planResumed(arguments, std::move(jobs));
    }
    if (isThere && !arguments.dryRun) {
        throw InputError(
            InputErrorCode::UnwritableFile,
            arguments.results.string() +
                ": is there already; --resume goes on with it, --results names another"
        );
    }
    return {.jobs = std::move(jobs), .kept = {}, .doneBefore = 0};
}

/// The lines that a job printed as one, without the program's name before each.
std::string messageOf(std::string_view printed) {
    constexpr std::string_view kName = "bspline_curve: ";
    std::string message;
    LineReader lines(printed);
    while (lines.next()) {
        std::string_view line = trimmed(lines.line());
        if (line.starts_with(kName)) {
            line.remove_prefix(kName.size());
        }
        if (!line.empty()) {
            message.append(message.empty() ? "" : "; ").append(line);
        }
    }
    return message;
}

/// A job that runs.
struct RunningJob {
    Job job;
    path report;
    std::optional<std::filesystem::file_time_type> reportBefore;  ///< none: it was not there
    Stopwatch watch;
    std::unique_ptr<ChildProcess> process;
};

/// When a file was written; none where it is not there.
std::optional<std::filesystem::file_time_type> timeOf(const path& file) {
    std::error_code error;
    const auto time = std::filesystem::last_write_time(file, error);
    return error ? std::nullopt : std::optional(time);
}

void addFigures(const path& report, JobResult& result) {
    try {
        result.figures = readCurveFigures(report);
    } catch (const InputError& error) {
        result.message.append(result.message.empty() ? "" : "; ").append(error.what());
    }
}

/// Runs the jobs of a plan, so many at once, and writes a line for each as it ends.
class Batch {
public:
    Batch(const BatchArguments& arguments, Plan plan, ProgressBar& bar)
        : arguments_(arguments),
          results_(arguments.results, plan.kept),
          waiting_(
              std::make_move_iterator(plan.jobs.begin()), std::make_move_iterator(plan.jobs.end())
          ),
          total_(plan.jobs.size() + plan.doneBefore),
          done_(plan.doneBefore),
          bar_(bar) {}

    void run() {
        while (!running_.empty() || (!waiting_.empty() && !interrupted())) {
            show();
            startJobs();
            passOnInterrupt();
            takeWhatIsPrinted();
        }
    }

    [[nodiscard]] std::size_t done() const { return done_; }

    [[nodiscard]] std::size_t failed() const { return failed_; }

    [[nodiscard]] std::size_t total() const { return total_; }

    /// "job 3: …" of the first that failed.
    [[nodiscard]] const std::string& firstFailure() const { return firstFailure_; }

private:
    void show() {
        std::string text =
            std::to_string(done_ + failed_) + " of " + describeCount(total_, "job", "jobs");
        if (failed_ > 0) {
            text += ", " + std::to_string(failed_) + " failed";
        }
        bar_.show(
            static_cast<double>(done_ + failed_) /
                static_cast<double>(std::max<std::size_t>(total_, 1)),
            text
        );
    }

    void startJobs() {
        while (!interrupted() && !waiting_.empty() &&
               running_.size() < static_cast<std::size_t>(arguments_.atOnce)) {
            Job job = std::move(waiting_.front());
            waiting_.pop_front();
            start(std::move(job));
        }
    }

    void start(Job job) {
        RunningJob running{
            .job = std::move(job), .report = {}, .reportBefore = {}, .watch = {}, .process = nullptr
        };
        ChildProcess::Request request{
            .arguments = {"curve"},
            .directory = arguments_.jobs.has_parent_path() ? arguments_.jobs.parent_path() : ".",
            .memoryBytes = arguments_.jobMemoryBytes
        };
        const auto& words = running.job.arguments;
        request.arguments.insert(request.arguments.end(), words.begin(), words.end());
        running.report = running.job.reportPath;
        if (running.report.empty()) {
            running.report =
                reports_.path() / ("job-" + std::to_string(running.job.number) + ".json");
            request.arguments.push_back("--report=" + running.report.string());
        }
        running.reportBefore = timeOf(running.report);
        try {
            running.process = std::make_unique<ChildProcess>(request);
        } catch (const std::system_error& error) {
            finish(running, {.exitCode = 1}, std::string("cannot be started: ") + error.what());
            return;
        }
        running_.push_back(std::move(running));
    }

    void passOnInterrupt() {
        if (interrupted() && !std::exchange(isInterruptPassedOn_, true)) {
            for (const RunningJob& running : running_) {
                running.process->interrupt();
            }
        }
    }

    /// Waits a moment for jobs that print something or end.
    void takeWhatIsPrinted() {
        constexpr int kMilliseconds = 100;
        std::vector<pollfd> descriptors;
        for (const RunningJob& running : running_) {
            descriptors.push_back(
                {.fd = running.process->descriptor(), .events = POLLIN, .revents = 0}
            );
        }
        if (::poll(descriptors.data(), descriptors.size(), kMilliseconds) <= 0) {
            return;
        }
        std::vector<RunningJob> still;
        for (std::size_t i = 0; i < running_.size(); ++i) {
            RunningJob& running = running_[i];
            if (descriptors[i].revents == 0 || running.process->read()) {
                still.push_back(std::move(running));
                continue;
            }
            const ChildProcess::End end = running.process->wait();
            finish(running, end, messageOf(running.process->printed()));
        }
        running_ = std::move(still);
    }

    /// Writes the line of a job that ended. One that Ctrl-C ended has none: it did not fail.
    void finish(RunningJob& running, const ChildProcess::End& end, std::string message) {
        const bool isStopped =
            end.exitCode == static_cast<int>(ExitCode::Interrupted) || end.signal == SIGINT;
        if (isStopped && interrupted()) {
            return;
        }
        const Job& job = running.job;
        JobResult result{
            .job = job.number,
            .mesh = job.mesh,
            .picks = job.picks,
            .output = job.output,
            .status = end.exitCode == 0 ? JobStatus::Done : JobStatus::Failed,
            .seconds = running.watch.lap(),
            .figures = {},
            .peakMemoryBytes = end.peakMemoryBytes,
            .message = std::move(message),
            .command = job.command()
        };
        if (end.signal != 0) {
            result.status = JobStatus::Crashed;
            result.message.append(result.message.empty() ? "" : "; ")
                .append("ended by the signal ")
                .append(::strsignal(end.signal));
        } else if (timeOf(running.report) != running.reportBefore) {
            addFigures(running.report, result);
        }
        results_.append(jobResultLine(result));
        count(result);
    }

    void count(const JobResult& result) {
        if (result.status == JobStatus::Done) {
            ++done_;
            return;
        }
        ++failed_;
        if (firstFailure_.empty()) {
            firstFailure_ = "job " + std::to_string(result.job) + ": " + result.message;
        }
    }

    const BatchArguments& arguments_;
    TemporaryFolder reports_;
    JobResultsFile results_;
    std::deque<Job> waiting_;
    std::vector<RunningJob> running_;
    std::size_t total_, done_;
    std::size_t failed_ = 0;
    std::string firstFailure_;
    bool isInterruptPassedOn_ = false;
    ProgressBar& bar_;
};

/// Lines that a shell can run.
void printCommands(const std::vector<Job>& jobs) {
    for (const Job& job : jobs) {
        std::cout << job.command() << "  # job " << job.number << '\n';
    }
}

ExitCode runJobs(const BatchArguments& arguments, ProgressBar& bar) {
    Plan plan = planFor(arguments);
    if (arguments.dryRun) {
        printCommands(plan.jobs);
        return ExitCode::Success;
    }
    Batch batch(arguments, std::move(plan), bar);
    batch.run();
    bar.clear();
    if (batch.done() == batch.total()) {
        return ExitCode::Success;
    }
    const std::string ofAll = " of " + describeCount(batch.total(), "job", "jobs");
    if (interrupted()) {
        printError(
            "interrupted; " + std::to_string(batch.done()) + ofAll + " done, --resume goes on"
        );
        return ExitCode::Interrupted;
    }
    printError(
        std::to_string(batch.failed()) + ofAll + " failed; " + arguments.results.string() +
        " says why, first " + batch.firstFailure()
    );
    return ExitCode::Failure;
}

}  // namespace

ExitCode runBatch(Arguments arguments) {
    const auto parsed = parseBatchArguments(arguments);
    if (const auto* const code = std::get_if<ExitCode>(&parsed)) {
        return *code;
    }
    const auto& batch = std::get<BatchArguments>(parsed);
    constexpr bool kRepairs = true;  // no hint at an option that this verb does not have
    return runVerb(kRepairs, [&](ProgressBar& bar) { return runJobs(batch, bar); });
}

}  // namespace bspline_curve::cli

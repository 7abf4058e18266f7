// SPDX-License-Identifier: GPL-3.0-or-later
// bspline_curve batch JOBS.csv …: many curves, each in a process of its own, a copy of one that has
// read and prepared the mesh. So a job that crashes ends alone, and its memory is the system's
// again as soon as it ends.
#include "bspline_curve/error.h"
#include "cli/batch_options.h"
#include "cli/child_process.h"
#include "cli/command.h"
#include "cli/interrupt.h"
#include "cli/job_table.h"
#include "cli/packet_socket.h"
#include "cli/progress_bar.h"
#include "cli/reports/job_results.h"
#include "cli/temporary_folder.h"
#include "cli/verb_parser.h"
#include "text/error_messages.h"
#include "text/text_parsing.h"
#include "utility/stopwatch.h"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstring>
#include <deque>
#include <iostream>
#include <iterator>
#include <list>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
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

/// A process that prepares a mesh and draws curves on it, see runMeshProcess.
struct MeshProcess {
    std::string preparation;
    std::unique_ptr<ChildProcess> process;
    int socket = -1;

    explicit MeshProcess(const Job& job, ChildProcess::Request request)
        : preparation(job.preparation) {
        const auto [ours, theirs] = makePacketSockets();
        socket = ours;
        request.standardInput = theirs;
        try {
            process = std::make_unique<ChildProcess>(request);
        } catch (const std::system_error&) {
            ::close(ours);
            ::close(theirs);
            throw;
        }
        ::close(theirs);
    }

    ~MeshProcess() { ::close(socket); }

    MeshProcess(const MeshProcess&) = delete;
    MeshProcess& operator=(const MeshProcess&) = delete;

    /// Waits for its end.
    [[nodiscard]] ChildProcess::End wait() const {
        while (process->read()) {
        }
        return process->wait();
    }
};

/// A job that runs.
struct RunningJob {
    Job job;
    path report{};
    std::optional<std::filesystem::file_time_type> reportBefore{};  ///< none: it was not there
    Stopwatch watch{};
    const MeshProcess* mesh = nullptr;
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

/// Jobs that share a mesh one after the other; else in their order.
std::deque<Job> inTurn(std::vector<Job> jobs) {
    std::map<std::string, std::size_t> first;
    for (const Job& job : jobs) {
        first.emplace(job.preparation, job.number);
    }
    std::ranges::stable_sort(jobs, {}, [&](const Job& job) { return first.at(job.preparation); });
    return {std::make_move_iterator(jobs.begin()), std::make_move_iterator(jobs.end())};
}

/// Runs the jobs of a plan, so many at once, and writes a line for each as it ends.
class Batch {
public:
    Batch(const BatchArguments& arguments, Plan plan, ProgressBar& bar)
        : arguments_(arguments),
          results_(arguments.results, plan.kept),
          total_(plan.jobs.size() + plan.doneBefore),
          done_(plan.doneBefore),
          waiting_(inTurn(std::move(plan.jobs))),
          bar_(bar) {}

    void run() {
        while (!running_.empty() || (!waiting_.empty() && !interrupted())) {
            show();
            startJobs();
            passOnInterrupt();
            takeEnds();
        }
        results_.sortByJob();
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
        RunningJob running{.job = std::move(job)};
        std::vector<std::string> request{std::to_string(running.job.number)};
        const auto& words = running.job.arguments;
        request.insert(request.end(), words.begin(), words.end());
        running.report = running.job.reportPath;
        if (running.report.empty()) {
            running.report = reports_.path() / ("job-" + request.front() + ".json");
            request.push_back("--report=" + running.report.string());
        }
        running.reportBefore = timeOf(running.report);
        try {
            running.mesh = &processFor(running.job);
        } catch (const std::system_error& error) {
            finish(running, {.exitCode = 1}, std::string("cannot be started: ") + error.what());
            return;
        }
        // Where it has ended meanwhile, its end is the job's.
        static_cast<void>(sendPacket(running.mesh->socket, request));
        const bool isLast =
            waiting_.empty() || waiting_.front().preparation != running.job.preparation;
        if (isLast) {
            ::shutdown(running.mesh->socket, SHUT_WR);
        }
        running_.push_back(std::move(running));
    }

    const MeshProcess& processFor(const Job& job) {
        const auto found = std::ranges::find(meshes_, job.preparation, &MeshProcess::preparation);
        if (found != meshes_.end()) {
            return *found;
        }
        return meshes_.emplace_back(
            job,
            ChildProcess::Request{
                .arguments = {kMeshProcess},
                .directory =
                    arguments_.jobs.has_parent_path() ? arguments_.jobs.parent_path() : ".",
                .memoryBytes = arguments_.jobMemoryBytes
            }
        );
    }

    void passOnInterrupt() {
        if (interrupted() && !std::exchange(isInterruptPassedOn_, true)) {
            for (const MeshProcess& mesh : meshes_) {
                mesh.process->interrupt();
            }
        }
    }

    /// Waits a moment for jobs that end.
    void takeEnds() {
        constexpr int kMilliseconds = 100;
        std::vector<pollfd> descriptors;
        for (const MeshProcess& mesh : meshes_) {
            descriptors.push_back({.fd = mesh.socket, .events = POLLIN, .revents = 0});
        }
        if (::poll(descriptors.data(), descriptors.size(), kMilliseconds) <= 0) {
            return;
        }
        auto mesh = meshes_.begin();
        for (const pollfd& descriptor : descriptors) {
            const auto here = mesh++;
            if (descriptor.revents == 0) {
                continue;
            }
            if (const auto answer = receivePacket(here->socket)) {
                takeEnd(*answer);
            } else {
                takeEndOfMesh(*here);
                meshes_.erase(here);
            }
        }
    }

    void takeEnd(const std::vector<std::string>& answer) {
        const std::size_t number = std::stoull(answer.at(0));
        const auto running = std::ranges::find_if(running_, [&](const RunningJob& candidate) {
            return candidate.job.number == number;
        });
        const ChildProcess::End end{
            .exitCode = std::stoi(answer.at(1)),
            .signal = std::stoi(answer.at(2)),
            .peakMemoryBytes = std::stoll(answer.at(3))
        };
        finish(*running, end, messageOf(answer.at(4)));
        running_.erase(running);
    }

    /// What became of a mesh became of the jobs that run on it; where it was refused, of all jobs
    /// on it.
    void takeEndOfMesh(const MeshProcess& mesh) {
        const ChildProcess::End end = mesh.wait();
        const std::string message = messageOf(mesh.process->printed());
        const bool isRefused = end.signal == 0 && end.exitCode != 0;
        while (isRefused && !waiting_.empty() && waiting_.front().preparation == mesh.preparation) {
            running_.push_back({.job = std::move(waiting_.front()), .mesh = &mesh});
            waiting_.pop_front();
        }
        for (RunningJob& running : running_) {
            if (running.mesh == &mesh) {
                finish(running, end, message);
            }
        }
        std::erase_if(running_, [&](const RunningJob& running) { return running.mesh == &mesh; });
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
    std::size_t total_, done_;
    std::deque<Job> waiting_;  // those that share a mesh follow each other
    std::list<MeshProcess> meshes_;
    std::vector<RunningJob> running_;
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
        bar.tell(arguments.results, describeCount(batch.done(), "job", "jobs") + " done");
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
    return runParsed<BatchParser>(arguments, runJobs, AfterInterrupt::Finish);
}

}  // namespace bspline_curve::cli

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "text/csv.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

// The results file of a batch: CSV with a header and a line for each job that ended.
namespace bspline_curve::cli {

/// What the report of one curve says.
struct CurveFigures {
    bool usable = false;
    double length = 0.0;       ///< of the polyline, user's unit
    double maxDistance = 0.0;  ///< of the spline from the surface, in average edge lengths
    std::int64_t vertices = 0;
};

/// The figures of a report (.json). Throws InputError (UnreadableFile).
[[nodiscard]] CurveFigures readCurveFigures(const std::filesystem::path& report);

enum class JobStatus : std::uint8_t {
    Done,     ///< a curve was written; `usable` says more
    Failed,   ///< bad mesh, picks or options, or no usable curve where one is required; `message`
              ///< says why
    Crashed,  ///< ended by a signal
};

[[nodiscard]] const char* name(JobStatus status);

struct JobResult {
    std::size_t job = 0;  ///< from 1, in the order of the jobs file
    std::string mesh, picks, output;
    JobStatus status = JobStatus::Failed;
    double seconds = 0.0;
    std::optional<CurveFigures> figures;  ///< none where the job ended before there was a curve
    std::int64_t peakMemoryBytes = 0;
    std::string message;
    std::string command;  ///< what was run, as words for a shell
};

[[nodiscard]] std::string jobResultsHeader();
/// One line; line ends within fields become blanks.
[[nodiscard]] std::string jobResultLine(const JobResult& result);

/// A line of a results file, as far as going on with a batch asks.
struct JobRecord {
    std::vector<std::string> fields;
    bool isDone = false;

    [[nodiscard]] const std::string& command() const { return fields.back(); }

    /// The line with another number of the job.
    [[nodiscard]] std::string lineAs(std::size_t job) const;
    [[nodiscard]] std::string line() const;
};

/// The lines of a results file. A last line that was cut off while it was written is left out.
/// Throws InputError (UnreadableFile) where the file is none of ours.
[[nodiscard]] std::vector<JobRecord> readJobRecords(const std::filesystem::path& file);

/// How a command is compared with those of a file: line ends became blanks there.
[[nodiscard]] std::string oneLine(std::string text);

/// A results file that grows. Each line is on the disk before the next job's is written; a second
/// program cannot write to it meanwhile.
class JobResultsFile {
public:
    /// The file begins anew with the header and `kept`, whole lines. Throws InputError
    /// (UnwritableFile), also where another batch is writing to the file.
    JobResultsFile(std::filesystem::path file, const std::string& kept);
    ~JobResultsFile();
    JobResultsFile(const JobResultsFile&) = delete;
    JobResultsFile& operator=(const JobResultsFile&) = delete;

    /// Throws InputError (UnwritableFile).
    void append(const std::string& line);

    /// Brings the lines into the order of the jobs, once none is to follow. Throws InputError.
    void sortByJob() const;

private:
    std::filesystem::path file_;
    int descriptor_ = -1;
};

}  // namespace bspline_curve::cli

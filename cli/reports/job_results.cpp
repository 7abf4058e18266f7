// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/reports/job_results.h"

#include "bspline_curve/atomic_file.h"
#include "bspline_curve/error.h"
#include "text/error_messages.h"
#include "text/json_reader.h"
#include "text/number_text.h"
#include "text/text_parsing.h"

#include <fcntl.h>
#include <nlohmann/json.hpp>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <span>
#include <string_view>
#include <system_error>
#include <utility>

namespace bspline_curve::cli {

namespace {

using std::filesystem::path;

const std::vector<std::string>& columns() {
    static const std::vector<std::string> names{
        "job",
        "mesh",
        "picks",
        "output",
        "status",
        "seconds",
        "usable",
        "length",
        "max_distance",
        "vertices",
        "peak_memory_bytes",
        "message",
        "command",
    };
    return names;
}

constexpr std::size_t kStatusColumn = 4;

/// Open for appending, and nobody else's; -1 with errno where that cannot be.
int openLocked(const path& file, int flags) {
    const int descriptor = ::open(file.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC | flags, 0666);
    if (descriptor >= 0 && ::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
        const int reason = errno;
        ::close(descriptor);
        errno = reason;
        return -1;
    }
    return descriptor;
}

}  // namespace

CurveFigures readCurveFigures(const path& report) {
    try {
        const auto document = jsonOfBytes(report, readWholeFile(report));
        return {
            .usable = document.at("usable").get<bool>(),
            .length = document.at("curve").at("length").get<double>(),
            .maxDistance = document.at("max_distance").get<double>(),
            .vertices = document.at("curve").at("vertices").get<std::int64_t>()
        };
    } catch (const nlohmann::json::exception& error) {
        refuseFile(report, std::string("is no report of a curve: ") + error.what());
    }
}

const char* name(JobStatus status) {
    switch (status) {
        case JobStatus::Done:
            return "done";
        case JobStatus::Failed:
            return "failed";
        case JobStatus::Crashed:
            return "crashed";
    }
    return "";
}

std::string oneLine(std::string text) {
    std::ranges::replace_if(text, [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
    return text;
}

std::string jobResultsHeader() {
    return csvLine(columns());
}

std::string jobResultLine(const JobResult& result) {
    const auto& figures = result.figures;
    std::vector<std::string> fields{
        std::to_string(result.job),
        result.mesh,
        result.picks,
        result.output,
        name(result.status),
        numberText(result.seconds),
        figures ? (figures->usable ? "true" : "false") : "",
        figures ? numberText(figures->length) : "",
        figures ? numberText(figures->maxDistance) : "",
        figures ? std::to_string(figures->vertices) : "",
        std::to_string(result.peakMemoryBytes),
        result.message,
        result.command,
    };
    for (std::string& field : fields) {
        field = oneLine(std::move(field));
    }
    return csvLine(fields);
}

std::string JobRecord::lineAs(std::size_t job) const {
    std::vector<std::string> changed = fields;
    changed.front() = std::to_string(job);
    return csvLine(changed);
}

std::string JobRecord::line() const {
    return csvLine(fields);
}

std::vector<JobRecord> readJobRecords(const path& file) {
    std::string bytes = readWholeFile(file);
    bytes.resize(bytes.rfind('\n') + 1);  // npos + 1 is 0
    const CsvTable table = parseCsv(file, bytes);
    if (table.records.empty() || table.records.front().fields != columns()) {
        refuseFile(file, "is no results file of a batch (its first line is another)");
    }
    std::vector<JobRecord> records;
    for (const CsvRecord& record : std::span(table.records).subspan(1)) {
        if (record.fields.size() != columns().size()) {
            refuseLine(
                file,
                record.line,
                "has " + describeCount(record.fields.size(), "field", "fields") + ", not " +
                    std::to_string(columns().size())
            );
        }
        records.push_back(
            {.fields = record.fields,
             .isDone = record.fields[kStatusColumn] == name(JobStatus::Done)}
        );
    }
    return records;
}

JobResultsFile::JobResultsFile(path file, const std::string& kept) : file_(std::move(file)) {
    // Whoever writes to the old file must not lose it; a missing one is nobody's.
    const int old = openLocked(file_, 0);
    if (old < 0 && errno == EWOULDBLOCK) {
        refuseWriting(file_, "another batch is writing to it");
    }
    AtomicFile(file_, jobResultsHeader() + kept).commit();
    descriptor_ = openLocked(file_, 0);
    const int reason = errno;
    if (old >= 0) {
        ::close(old);
    }
    if (descriptor_ < 0) {
        errno = reason;
        refuseErrno(file_);
    }
}

JobResultsFile::~JobResultsFile() {
    if (descriptor_ >= 0) {
        ::close(descriptor_);
    }
}

void JobResultsFile::append(const std::string& line) {
    std::string_view rest = line;
    while (!rest.empty()) {
        const ssize_t written = ::write(descriptor_, rest.data(), rest.size());
        if (written < 0 && errno != EINTR) {
            refuseErrno(file_);
        }
        rest.remove_prefix(std::max<ssize_t>(written, 0));
    }
    // A device has nothing to bring to a disk.
    if (::fdatasync(descriptor_) != 0 && errno != EINVAL && errno != EROFS) {
        refuseErrno(file_);
    }
}

void JobResultsFile::sortByJob() const {
    if (!std::filesystem::is_regular_file(file_)) {
        return;
    }
    std::vector<JobRecord> records = readJobRecords(file_);
    const auto number = [](const JobRecord& record) {
        return parseInteger(record.fields.front()).value_or(0);
    };
    if (std::ranges::is_sorted(records, {}, number)) {
        return;
    }
    std::ranges::stable_sort(records, {}, number);
    std::string text = jobResultsHeader();
    for (const JobRecord& record : records) {
        text += record.line();
    }
    AtomicFile(file_, text).commit();
}

}  // namespace bspline_curve::cli

// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/job_table.h"

#include "bspline_curve/error.h"
#include "bspline_curve/files.h"
#include "cli/curve_options.h"
#include "cli/reports/curve_report.h"
#include "cli/result_files.h"
#include "text/csv.h"
#include "text/error_messages.h"
#include "text/number_text.h"
#include "text/text_parsing.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

namespace bspline_curve::cli {

namespace {

using std::filesystem::path;

constexpr const char* kMesh = "mesh";

/// "--Max_Rounds" is the column max-rounds.
std::string columnName(std::string_view word) {
    word.remove_prefix(std::min(word.find_first_not_of('-'), word.size()));
    std::string name = lowerCase(word);
    std::ranges::replace(name, '_', '-');
    return name;
}

/// A column of the table: the mesh or an option.
struct Column {
    std::string name;
    bool isFlag = false;
};

std::vector<Column> readHeader(const path& file, const CsvRecord& header) {
    const std::vector<CurveOption> options = curveOptions();
    std::vector<Column> columns;
    for (const std::string& field : header.fields) {
        const std::string name = columnName(field);
        const auto option = std::ranges::find(options, name, &CurveOption::name);
        if (name != kMesh && option == options.end()) {
            refuseLine(
                file,
                header.line,
                "the column " + inQuotes(field) +
                    " is neither mesh nor an option of a curve (bspline_curve curve --help lists "
                    "them)"
            );
        }
        if (std::ranges::find(columns, name, &Column::name) != columns.end()) {
            refuseLine(file, header.line, "there are two columns " + inQuotes(name));
        }
        columns.push_back({.name = name, .isFlag = name != kMesh && option->isFlag});
    }
    for (const std::string_view wanted : {"mesh", "picks", "output"}) {
        if (std::ranges::find(columns, wanted, &Column::name) == columns.end()) {
            refuseLine(file, header.line, "there is no column " + inQuotes(wanted));
        }
    }
    return columns;
}

/// Whether a cell sets a flag; none where it says neither yes nor no.
std::optional<bool> flagOf(const std::string& cell) {
    constexpr std::array<std::string_view, 4> kYes{"true", "yes", "on", "1"};
    constexpr std::array<std::string_view, 4> kNo{"false", "no", "off", "0"};
    const std::string word = lowerCase(cell);
    if (std::ranges::find(kYes, word) != kYes.end()) {
        return true;
    }
    return std::ranges::find(kNo, word) != kNo.end() ? std::optional(false) : std::nullopt;
}

/// What a process that prepares a mesh for curves depends on.
std::string preparationOf(const CurveArguments& curve) {
    const ShellOptions& shell = curve.shell;
    std::string text = curve.mesh.string() + '\n' + name(shell.kind);
    for (const double value :
         {shell.thickness,
          static_cast<double>(shell.smoothingPasses),
          shell.targetThickness,
          shell.targetEdgeLength,
          curve.mending.strict ? 1.0 : 0.0,
          curve.mending.weld,
          curve.mending.slits ? 1.0 : 0.0,
          curve.noCache ? 1.0 : 0.0}) {
        text += ' ' + numberText(value);
    }
    return text;
}

/// Takes the lines of a jobs file one by one.
class JobReader {
public:
    JobReader(const path& file, std::vector<Column> columns)
        : folder_(file.has_parent_path() ? file.parent_path() : path(".")),
          columns_(std::move(columns)) {}

    /// Throws InputError, without the file and line.
    [[nodiscard]] Job read(const CsvRecord& record, std::size_t number) const {
        if (record.fields.size() != columns_.size()) {
            throw InputError(
                InputErrorCode::UnreadableFile,
                "has " + describeCount(record.fields.size(), "field", "fields") +
                    ", the header has " + std::to_string(columns_.size())
            );
        }
        Job job;
        job.number = number;
        for (std::size_t i = 0; i < columns_.size(); ++i) {
            take(job, columns_[i], record.fields[i]);
        }
        for (const auto& [name, text] :
             {std::pair{"mesh", &job.mesh}, {"picks", &job.picks}, {"output", &job.output}}) {
            if (text->empty()) {
                throw InputError(
                    InputErrorCode::UnreadableFile, std::string("there is no ") + name
                );
            }
        }
        check(job);
        return job;
    }

private:
    static void take(Job& job, const Column& column, const std::string& cell) {
        if (cell.empty()) {
            return;
        }
        if (column.name == kMesh) {
            job.mesh = cell;
            job.arguments.push_back(cell.starts_with('-') ? "./" + cell : cell);
            return;
        }
        if (column.isFlag) {
            const std::optional<bool> isSet = flagOf(cell);
            if (!isSet) {
                throw InputError(
                    InputErrorCode::BadOption,
                    column.name + ": " + inQuotes(cell) + " is neither true nor false"
                );
            }
            if (*isSet) {
                job.arguments.push_back("--" + column.name);
            }
            return;
        }
        job.arguments.push_back("--" + column.name + "=" + cell);
        if (column.name == "picks") {
            job.picks = cell;
        } else if (column.name == "output") {
            job.output = cell;
        }
    }

    /// Refuses what could only fail when the job runs, as far as its own line tells.
    void check(Job& job) const {
        std::vector<const char*> words;
        for (const std::string& argument : job.arguments) {
            words.push_back(argument.c_str());
        }
        const CurveArguments curve = readCurveArguments(words);
        job.preparation = preparationOf(curve);
        job.outputPath = folder_ / curve.output;
        job.reportPath = curve.report.empty() ? path() : folder_ / curve.report;
        checkOutput(job.outputPath, checkCurveExtension);
        checkOutput(job.reportPath, checkReportExtension);
    }

    path folder_;
    std::vector<Column> columns_;
};

/// A path that is the same for all ways to write it, as far as the file system tells.
std::string plainPath(const path& file) {
    std::error_code error;
    const path whole = std::filesystem::absolute(file, error);
    const path plain = std::filesystem::weakly_canonical(whole, error);
    return (error ? file.lexically_normal() : plain).string();
}

/// The files that jobs write, and who does: so that none is written twice, or read as well.
class WrittenFiles {
public:
    explicit WrittenFiles(const BatchArguments& arguments) : jobs_(arguments.jobs) {
        add(arguments.jobs, "the jobs file");
        add(arguments.results, "the results file");
    }

    void addJob(const Job& job, std::size_t line) {
        const std::string writer = "line " + std::to_string(line);
        if (!add(job.outputPath, writer)) {
            refuse(line, job.outputPath);
        }
        if (!job.reportPath.empty() && !add(job.reportPath, writer)) {
            refuse(line, job.reportPath);
        }
    }

    /// A mesh or picks of a job, after all jobs were added.
    void checkInput(const path& file, std::size_t line) const {
        const auto found = writers_.find(plainPath(file));
        if (found != writers_.end()) {
            refuseLine(
                jobs_,
                line,
                "reads " + file.string() + ", which " + found->second +
                    " writes; jobs run in any order"
            );
        }
    }

private:
    bool add(const path& file, const std::string& writer) {
        return writers_.emplace(plainPath(file), writer).second;
    }

    [[noreturn]] void refuse(std::size_t line, const path& file) const {
        const std::string& first = writers_.at(plainPath(file));
        refuseLine(jobs_, line, "writes " + file.string() + ", as does " + first);
    }

    path jobs_;
    std::map<std::string, std::string> writers_;
};

std::string shellWord(const std::string& word) {
    constexpr std::string_view kPlain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=./,:@%";
    if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) {
        return word;
    }
    std::string quoted = "'";
    for (const char c : word) {
        quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    }
    return quoted + "'";
}

void checkSelection(const path& file, const JobSelection& only, std::size_t count) {
    if (count == 0) {
        refuseFile(file, "holds no jobs");
    }
    if (only.last() > count) {
        refuseFile(
            file,
            "has " + describeCount(count, "job", "jobs") + ", no job " + std::to_string(only.last())
        );
    }
}

}  // namespace

std::string Job::command() const {
    std::string text = "bspline_curve curve";
    for (const std::string& argument : arguments) {
        text.append(" ").append(shellWord(argument));
    }
    return text;
}

std::vector<Job> readJobs(const BatchArguments& arguments) {
    const path& file = arguments.jobs;
    const CsvTable table = parseCsv(file, readWholeFile(file));
    if (table.records.empty()) {
        refuseFile(file, "holds no header");
    }
    const JobReader reader(file, readHeader(file, table.records.front()));
    checkSelection(file, arguments.only, table.records.size() - 1);
    std::vector<Job> jobs;
    WrittenFiles written(arguments);
    for (std::size_t i = 1; i < table.records.size(); ++i) {
        if (!arguments.only.contains(i)) {
            continue;
        }
        const CsvRecord& record = table.records[i];
        try {
            jobs.push_back(reader.read(record, i));
        } catch (const InputError& error) {
            refuseLine(file, record.line, error.what());
        }
        written.addJob(jobs.back(), record.line);
    }
    const path folder = file.has_parent_path() ? file.parent_path() : path(".");
    for (const Job& job : jobs) {
        const std::size_t line = table.records[job.number].line;
        written.checkInput(folder / job.mesh, line);
        written.checkInput(folder / job.picks, line);
    }
    return jobs;
}

}  // namespace bspline_curve::cli

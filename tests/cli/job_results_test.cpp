// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/reports/job_results.h"

#include "io/temporary_files.h"

namespace bspline_curve::cli {

namespace {

using namespace io_tests;

class JobResults : public FileTest {};

JobResult result(std::size_t job, JobStatus status) {
    return {
        .job = job,
        .mesh = "a.ply",
        .picks = "p, 1.json",
        .output = "c.ply",
        .status = status,
        .seconds = 0.5,
        .figures = CurveFigures{.usable = true, .length = 0.1, .maxDistance = 1e-9, .vertices = 7},
        .peakMemoryBytes = 4096,
        .message = "two\nlines",
        .command = "bspline_curve curve a.ply"
    };
}

}  // namespace

TEST_F(JobResults, ALineHoldsEveryFigure) {
    EXPECT_EQ(
        jobResultLine(result(3, JobStatus::Crashed)),
        "3,a.ply,\"p, 1.json\",c.ply,crashed,0.5,true,0.1,1e-09,7,4096,two lines,"
        "bspline_curve curve a.ply\n"
    );
    JobResult without = result(4, JobStatus::Failed);
    without.figures.reset();
    expectContains(jobResultLine(without), "failed,0.5,,,,,4096,");
}

TEST_F(JobResults, LinesAreReadBackAndOnesThatWereCutOffAreNot) {
    {
        JobResultsFile file(path("r.csv"), "");
        file.append(jobResultLine(result(1, JobStatus::Done)));
        file.append(jobResultLine(result(2, JobStatus::Failed)));
    }
    auto records = readJobRecords(path("r.csv"));
    ASSERT_EQ(records.size(), 2U);
    EXPECT_TRUE(records[0].isDone);
    EXPECT_FALSE(records[1].isDone);
    EXPECT_EQ(records[0].command(), "bspline_curve curve a.ply");
    EXPECT_EQ(records[0].line(), jobResultLine(result(1, JobStatus::Done)));
    EXPECT_EQ(records[0].lineAs(9), jobResultLine(result(9, JobStatus::Done)));
    const std::string bytes = read(path("r.csv"));
    const std::size_t second = bytes.size() - jobResultLine(result(2, JobStatus::Failed)).size();
    for (std::size_t size = second; size < bytes.size(); ++size) {
        records = readJobRecords(write("cut.csv", bytes.substr(0, size)));
        EXPECT_EQ(records.size(), 1U) << size;
    }
}

TEST_F(JobResults, WhatIsKeptGoesBeforeNewLines) {
    const std::string kept = jobResultLine(result(1, JobStatus::Done));
    write("r.csv", "old");
    JobResultsFile file(path("r.csv"), kept);
    file.append("new\n");
    EXPECT_EQ(read(path("r.csv")), jobResultsHeader() + kept + "new\n");
}

TEST_F(JobResults, TwoCannotWriteAtOnceAndTheFileStays) {
    const JobResultsFile first(path("r.csv"), "kept\n");
    expectContains(
        refusal(
            [&] {
                const JobResultsFile second(path("r.csv"), "");
                return 0;
            },
            InputErrorCode::UnwritableFile
        ),
        "another batch"
    );
    EXPECT_EQ(read(path("r.csv")), jobResultsHeader() + "kept\n");
}

TEST_F(JobResults, RefusesOtherFiles) {
    const auto refused = [&](const std::string& bytes) {
        return refusal([&] { return readJobRecords(write("r.csv", bytes)); });
    };
    expectContains(refused("x,y,z\n1,2,3\n"), "no results file");
    expectContains(refused("job"), "no results file");
    expectContains(refused(jobResultsHeader() + "1,2\n"), "line 2: has 2 fields");
    expectContains(
        refusal([&] { return readCurveFigures(write("r.json", "{\"usable\": true}")); }), "r.json"
    );
}

TEST_F(JobResults, ReportsDoNotNestWithoutBound) {
    const std::string deep(1000000, '[');
    expectContains(refusal([&] { return readCurveFigures(write("deep.json", deep)); }), "deep");
}

TEST_F(JobResults, FiguresAreThoseOfTheReport) {
    const CurveFigures figures = readCurveFigures(write(
        "r.json",
        R"({"usable": true, "max_distance": 0.25, "curve": {"length": 1.5, "vertices": 12}})"
    ));
    EXPECT_TRUE(figures.usable);
    EXPECT_EQ(figures.length, 1.5);
    EXPECT_EQ(figures.maxDistance, 0.25);
    EXPECT_EQ(figures.vertices, 12);
}

}  // namespace bspline_curve::cli

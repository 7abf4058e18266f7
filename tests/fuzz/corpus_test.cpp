// SPDX-License-Identifier: GPL-3.0-or-later
// Every file of the corpus is an answer or a refusal, without a fuzzer: what was found once stays
// found.
#include "fuzz/fuzz_target.h"
#include "text/text_parsing.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace bspline_curve::fuzz {

namespace {

const std::filesystem::path kCorpus = BSPLINE_CURVE_CORPUS;

std::vector<std::filesystem::path> corpusOf(const FuzzTarget& target) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(kCorpus / target.name)) {
        files.push_back(entry.path());
    }
    return files;
}

class Corpus : public testing::TestWithParam<FuzzTarget> {};

}  // namespace

TEST_P(Corpus, IsReadOrRefused) {
    const auto files = corpusOf(GetParam());
    ASSERT_FALSE(files.empty());
    for (const auto& file : files) {
        SCOPED_TRACE(file.filename().string());
        const std::string bytes = readWholeFile(file);
        EXPECT_NO_THROW(GetParam().run(bytes));
    }
}

INSTANTIATE_TEST_SUITE_P(
    All,
    Corpus,
    testing::ValuesIn(fuzzTargets().begin(), fuzzTargets().end()),
    [](const auto& tested) { return std::string(tested.param.name); }
);

}  // namespace bspline_curve::fuzz

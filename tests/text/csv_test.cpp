// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/csv.h"

#include "io/temporary_files.h"

#include <vector>

namespace bspline_curve::io_tests {

namespace {

using Fields = std::vector<std::string>;

std::vector<Fields> fieldsOf(std::string_view text) {
    std::vector<Fields> result;
    for (const CsvRecord& record : parseCsv("a.csv", text).records) {
        result.push_back(record.fields);
    }
    return result;
}

}  // namespace

TEST(Csv, TakesFieldsApartAndDropsBlanksAroundThem) {
    EXPECT_EQ(fieldsOf("a,b , c\n1,,\n"), (std::vector<Fields>{{"a", "b", "c"}, {"1", "", ""}}));
    EXPECT_EQ(fieldsOf("a;b,c\r\nd;e"), (std::vector<Fields>{{"a", "b,c"}, {"d", "e"}}));
    EXPECT_EQ(fieldsOf("a\tb c\n\td\n"), (std::vector<Fields>{{"a", "b c"}, {"", "d"}}));
    EXPECT_EQ(
        fieldsOf(
            "\xEF\xBB\xBF"
            "a"
        ),
        (std::vector<Fields>{{"a"}})
    );
    EXPECT_TRUE(fieldsOf("").empty());
}

TEST(Csv, QuotedFieldsHoldSeparatorsLineEndsAndQuotes) {
    EXPECT_EQ(
        fieldsOf("\"a, b\", \"c \"\"d\"\"\"\r\n\"two\nlines\",\" x \"\n"),
        (std::vector<Fields>{{"a, b", "c \"d\""}, {"two\nlines", " x "}})
    );
    EXPECT_EQ(fieldsOf("5\" pipe,\"\"\n"), (std::vector<Fields>{{"5\" pipe", ""}}));
}

TEST(Csv, LeavesOutCommentsAndEmptyLinesButCountsThem) {
    const CsvTable table = parseCsv("a.csv", "# jobs\n\na,b\n  \n\"x\ny\",2\n# c\n3,4");
    std::vector<std::size_t> lines;
    for (const CsvRecord& record : table.records) {
        lines.push_back(record.line);
    }
    EXPECT_EQ(lines, (std::vector<std::size_t>{3, 5, 8}));
}

TEST(Csv, RefusesQuotesThatDoNotMatch) {
    const auto refused = [](std::string_view text) {
        return refusal([&] { return parseCsv("a.csv", text); });
    };
    expectContains(refused("a,b\n\"c,d\n"), "a.csv, line 2: a quote is opened and not closed");
    expectContains(refused("a,b\n1,\"c\" d\n"), "a.csv, line 2: \"d\" stands behind");
}

TEST(Csv, WrittenLinesAreReadBack) {
    const Fields fields{"plain", "a,b", "say \"hi\"", "two\nlines", " blank", "#", "", "€"};
    EXPECT_EQ(csvLine(std::vector<std::string>{"a", "", "b"}), "a,,b\n");
    EXPECT_EQ(fieldsOf(csvLine(fields)), (std::vector<Fields>{fields}));
}

}  // namespace bspline_curve::io_tests

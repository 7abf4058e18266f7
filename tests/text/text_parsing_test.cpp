// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/text_parsing.h"

#include <gtest/gtest.h>

namespace bspline_curve {

TEST(TextParsing, NumbersFillTheWholeToken) {
    EXPECT_EQ(parseNumber("1.5"), 1.5);
    EXPECT_EQ(parseNumber("+1e-3"), 1e-3);
    EXPECT_EQ(parseNumber("-.5"), -0.5);
    for (const char* word : {"", "+", "1.5x", "1,5", "+-1", " 1", "0x10", "one"}) {
        EXPECT_FALSE(parseNumber(word).has_value()) << word;
    }
    EXPECT_EQ(parseInteger("-12"), -12);
    EXPECT_FALSE(parseInteger("1.0").has_value());
    EXPECT_FALSE(parseInteger("99999999999999999999").has_value());
}

TEST(TextParsing, LinesEndWithOrWithoutCarriageReturn) {
    LineReader lines(
        "\xEF\xBB\xBF"
        "a\r\n\nlast"
    );
    ASSERT_TRUE(lines.next());
    EXPECT_EQ(lines.line(), "a");
    ASSERT_TRUE(lines.next());
    EXPECT_EQ(lines.line(), "");
    ASSERT_TRUE(lines.next());
    EXPECT_EQ(lines.line(), "last");
    EXPECT_EQ(lines.number(), 3U);
    EXPECT_FALSE(lines.next());
}

TEST(TextParsing, QuotedTokensHaveNoControlCharacters) {
    EXPECT_EQ(inQuotes("a\n\x1b[2Jb"), "\"a??[2Jb\"");
    EXPECT_LT(inQuotes(std::string(1000, 'a')).size(), 60U);
}

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/json_reader.h"

#include "bspline_curve/files.h"
#include "io/curve_reader.h"
#include "io/temporary_files.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

#include <string>

namespace bspline_curve::io_tests {

namespace {

class JsonReader : public FileTest {};

std::string nested(int depth) {
    return std::string(static_cast<std::size_t>(depth), '[') +
           std::string(static_cast<std::size_t>(depth), ']');
}

}  // namespace

TEST_F(JsonReader, ARefusalSaysWhere) {
    EXPECT_EQ(jsonOfBytes("a.json", "[1, 2]").size(), 2);
    expectContains(
        refusal([] { return jsonOfBytes("a.json", "[1,\n 2"); }),
        "a.json: is not JSON: parse error at line 2"
    );
}

TEST_F(JsonReader, NestingIsBounded) {
    EXPECT_TRUE(jsonOfBytes("a.json", nested(64)).is_array());
    expectContains(
        refusal([] { return jsonOfBytes("a.json", nested(65)); }),
        "a.json: nests arrays or objects more than 64 deep"
    );
    std::string objects;
    for (int i = 0; i < 65; ++i) {
        objects += "{\"a\":";
    }
    expectContains(refusal([&] { return jsonOfBytes("a.json", objects); }), "more than 64 deep");
}

TEST_F(JsonReader, EveryFileOfJsonHasThisBound) {
    // So deep that a message which quotes the value would exhaust the stack.
    const auto file = write("deep.json", R"({"picks": [)" + nested(1000000) + "]}");
    const Surface surface(test_support::icosphere(0));
    const MeshChecksum mesh = checksumOf(test_support::icosphere(0));
    expectContains(refusal([&] { return readPicks(file); }), "deep");
    expectContains(refusal([&] { return readCurve(file, surface, mesh); }), "deep");
}

}  // namespace bspline_curve::io_tests

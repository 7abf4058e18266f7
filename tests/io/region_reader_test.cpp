// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/files.h"
#include "io/npy_bytes.h"
#include "io/temporary_files.h"

namespace bspline_curve::io_tests {

namespace {

class RegionReader : public FileTest {};

const std::vector<std::int64_t> kIds{17, 0, 17, 300};

template <class Scalar>
std::string idBytes() {
    std::string bytes;
    for (const std::int64_t id : kIds) {
        bytes += bytesOf(static_cast<Scalar>(id));
    }
    return bytes;
}

}  // namespace

TEST_F(RegionReader, ReadsTextWithCommentsInAnyLayout) {
    EXPECT_EQ(readFaceIds(write("a.txt", "# faces\n17 0\n17 # again\n300\n")), kIds);
    EXPECT_EQ(readFaceIds(write("b", "17 0\r\n17\t300")), kIds);
    EXPECT_TRUE(readFaceIds(write("c.txt", "# none\n")).empty());
}

TEST_F(RegionReader, ReadsNpyOfIntegers) {
    const auto read = [&](const std::string& type, const std::string& data) {
        return readFaceIds(write("a.npy", npy(npyDictionary(type, "(4,)"), data)));
    };
    EXPECT_EQ(read("<i4", idBytes<std::int32_t>()), kIds);
    EXPECT_EQ(read("<u4", idBytes<std::uint32_t>()), kIds);
    EXPECT_EQ(read("<i8", idBytes<std::int64_t>()), kIds);
    EXPECT_EQ(read("<u8", idBytes<std::uint64_t>()), kIds);
}

TEST_F(RegionReader, RefusesWhatIsNoWholeNumber) {
    expectContains(refusal([&] { return readFaceIds(write("a.txt", "1\n2.5\n")); }), "line 2");
    expectContains(refusal([&] { return readFaceIds(write("a.txt", "1 x\n")); }), "whole number");
    expectContains(refusal([&] { return readFaceIds(path("none.txt")); }), "no such file");
    const std::string floats = npy(npyDictionary("<f8", "(4,)"), idBytes<double>());
    expectContains(refusal([&] { return readFaceIds(write("a.npy", floats)); }), "integers");
}

}  // namespace bspline_curve::io_tests

// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/files.h"
#include "io/npy_bytes.h"
#include "io/temporary_files.h"

namespace bspline_curve::io_tests {

namespace {

class FieldReader : public FileTest {};

const std::vector<double> kField{0.5, -2.0, 1e10};

template <class Scalar>
std::string fieldBytes() {
    std::string bytes;
    for (const double x : kField) {
        bytes += bytesOf(static_cast<Scalar>(x));
    }
    return bytes;
}

}  // namespace

TEST_F(FieldReader, ReadsTextWithCommentsInAnyLayout) {
    EXPECT_EQ(readField(write("a.txt", "# a field\n0.5\n-2\n1e10\n"), 3), kField);
    EXPECT_EQ(readField(write("b", "0.5 -2\r\n1e10"), 3), kField);
}

TEST_F(FieldReader, ReadsNpyOfFloatAndDouble) {
    EXPECT_EQ(
        readField(write("a.npy", npy(npyDictionary("<f8", "(3,)"), fieldBytes<double>())), 3),
        kField
    );
    EXPECT_EQ(
        readField(write("b.npy", npy(npyDictionary("<f4", "(3,)"), fieldBytes<float>())), 3), kField
    );
    EXPECT_EQ(
        readField(write("c.npy", npy(npyDictionary("<f8", "(3,)"), fieldBytes<double>(), 2)), 3),
        kField
    );
}

TEST_F(FieldReader, RefusesOtherArraysAndDamage) {
    const auto refused = [&](const std::string& bytes) {
        const auto file = write("a.npy", bytes);
        return refusal([&] { return readField(file, 3); });
    };
    expectContains(refused("no array at all"), ".npy");
    expectContains(refused(npy(npyDictionary("<i8", "(3,)"), std::string(24, 0))), "float");
    expectContains(refused(npy(npyDictionary(">f8", "(3,)"), std::string(24, 0))), "little-endian");
    expectContains(
        refused(npy(npyDictionary("<f8", "(3, 1)"), fieldBytes<double>())), "one dimension"
    );
    expectContains(refused(npy(npyDictionary("<f8", "()"), fieldBytes<double>())), "one dimension");
    expectContains(refused(npy("{'descr': '<f8'}", fieldBytes<double>())), "shape");
    const std::string noTuple = "{'descr': '<f8', 'shape':";
    expectContains(refused(npy(noTuple + "}", fieldBytes<double>())), "no tuple");
    expectContains(refused(npy(noTuple, fieldBytes<double>())), "no tuple");
    const std::string whole = npy(npyDictionary("<f8", "(3,)"), fieldBytes<double>());
    for (std::size_t size = 0; size < whole.size(); ++size) {
        SCOPED_TRACE(size);
        refused(whole.substr(0, size));
    }
    expectContains(refusal([&] { return readField(write("a.txt", "0.5\nx\n"), 3); }), "line 2");
    expectContains(refusal([&] { return readField(path("none.txt"), 3); }), "no such file");
}

TEST_F(FieldReader, RefusesOtherCountsThanVertices) {
    const std::string message =
        refusal([&] { return readField(write("a.txt", "1 2 3\n"), 4); }, InputErrorCode::BadField);
    expectContains(message, "3 values");
    expectContains(message, "4 vertices");
}

TEST_F(FieldReader, NamesTheVerticesOfValuesThatAreNotFinite) {
    try {
        static_cast<void>(readField(write("a.txt", "1 nan 3 inf\n"), 4));
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(error.code(), InputErrorCode::BadField);
        EXPECT_EQ(error.elements(), (std::vector<std::int64_t>{1, 3}));
    }
}

}  // namespace bspline_curve::io_tests

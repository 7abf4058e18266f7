// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/files.h"
#include "io/damage.h"
#include "io/temporary_files.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace bspline_curve::io_tests {

namespace {

class DamagedPicks : public FileTest {};

const std::vector<std::pair<std::string, std::string>> kFiles{
    {"a.pp",
     "<!DOCTYPE PickedPoints>\n<PickedPoints>\n <point x=\"1\" y=\"2\" z=\"3\" active=\"1\"/>\n"
     " <point x=\"4\" y=\"5\" z=\"6\" active=\"0\"/>\n</PickedPoints>\n"},
    {"a.json", R"({"picks": [[1, 2, 3], [4, 5, 6]], "closed": true})"},
    {"a.mrk.json",
     R"({"markups": [{"type": "ClosedCurve", "coordinateSystem": "RAS", "controlPoints": [
     {"position": [1, 2, 3], "positionStatus": "defined"}, {"position": [4, 5, 6]},
     {"position": "", "positionStatus": "undefined"}]}, {"type": "Plane"}]})"},
    {"a.xyz", "# x y z\n1 2 3\n4 5 6\n"},
    {"a.csv", "name,x,y,z\n\"a, \"\"b\"\"\",1,2,3\nc,4,5,6\n"},
};

/// Whether a file is refused by a line that names it, or read as finite picks.
bool isReadOrRefused(const std::filesystem::path& file) {
    try {
        const PicksFile result = readPicks(file);
        return !result.picks.empty() &&
               std::ranges::all_of(result.picks, [](const Vec3& p) { return p.allFinite(); });
    } catch (const InputError& error) {
        return error.code() == InputErrorCode::UnreadableFile &&
               std::string(error.what()).starts_with(file.string());
    }
}

}  // namespace

TEST_F(DamagedPicks, WholeFilesAreRead) {
    for (const auto& [name, bytes] : kFiles) {
        EXPECT_FALSE(readPicks(write(name, bytes)).picks.empty()) << name;
    }
}

TEST_F(DamagedPicks, EveryTruncationIsReadOrRefused) {
    for (const auto& [name, bytes] : kFiles) {
        for (std::size_t size = 0; size < bytes.size(); ++size) {
            SCOPED_TRACE(name + " of " + std::to_string(size) + " bytes");
            EXPECT_TRUE(isReadOrRefused(write(name, bytes.substr(0, size))));
        }
    }
}

TEST_F(DamagedPicks, OtherFilesUnderTheNameOfPicksAreRefused) {
    for (const auto& [name, whole] : kFiles) {
        for (const std::string& bytes :
             {std::string("Dear reader, these are no picks.\n"),
              std::string(500, '\0'),
              std::string(500, '\xff'),
              std::string("\n\n\n"),
              std::string(100000, '['),
              std::string(1000, '"')}) {
            const auto file = write(name, bytes);
            SCOPED_TRACE(name + ": " + bytes.substr(0, 20));
            expectContains(refusal([&] { return readPicks(file); }), file.string());
        }
    }
}

/// Each reading either works or throws InputError, and gives finite picks; run with the sanitizers.
TEST_F(DamagedPicks, RandomDamageNeverCrashes) {
    constexpr unsigned kSeed = 20260801;
    std::mt19937 random(kSeed);
    for (int round = 0; round < 1500; ++round) {
        const auto& [name, original] = kFiles[round % kFiles.size()];
        const std::string bytes = damaged(original, "0123456789 -.,;\"\\#[]{}<>/:eEnx\t\r", random);
        SCOPED_TRACE(
            "seed " + std::to_string(kSeed) + ", round " + std::to_string(round) + ": " + bytes
        );
        EXPECT_TRUE(isReadOrRefused(write(name, bytes)));
    }
}

}  // namespace bspline_curve::io_tests

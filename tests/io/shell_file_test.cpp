// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/shell_file.h"

#include "io/byte_stream.h"
#include "io/stored_shell.h"
#include "io/temporary_files.h"
#include "shell/shell_simplifier.h"

#include <cmath>

namespace bspline_curve::io_tests {

namespace {

using test_support::HandmadeShell;

constexpr std::string_view kParameters = "thickness 0.12";

class ShellFiles : public FileTest {
protected:
    ShellFiles() {
        saveShell(file_, *shell_.surface, *shell_.extended, kParameters, buildOf(shell_));
    }

    [[nodiscard]] ShellBuild load() const { return load(file_); }

    [[nodiscard]] ShellBuild load(const std::filesystem::path& file) const {
        return loadShell(file, *shell_.surface, shell_.extended, kParameters);
    }

    /// What a file of these bytes is refused for.
    [[nodiscard]] std::string refusalOf(std::string_view bytes) const {
        const std::filesystem::path file = write("changed.shell", bytes);
        std::string reason = refusal([&] { return load(file); });
        std::filesystem::remove(file);  // truncating it instead would wait for the disk
        return reason;
    }

    HandmadeShell shell_ = smallShell();
    std::filesystem::path file_ = path("small.shell");
};

/// The same content with a checksum that fits.
std::string resealed(std::string bytes) {
    bytes.resize(bytes.size() - 8);
    return bytes + bytesOf(checksumOf(bytes));
}

/// A hill with a boundary and a crease, by operations that are the same on every machine.
TriangleMesh creasedHill() {
    TriangleMesh mesh = test_support::plate(12, 12);
    for (Vec3& p : mesh.vertices) {
        p.z() = 2.0 * p.x() * (1.0 - p.x()) * p.y() * (1.0 - p.y()) + std::abs(p.x() - 0.5);
    }
    return mesh;
}

}  // namespace

TEST_F(ShellFiles, GiveBackWhatWasSaved) {
    const ShellBuild build = load();
    expectSame(build, buildOf(shell_));
    EXPECT_FALSE(build.shell.isFullResolution());
    const ShellCheck check =
        checkShell(*shell_.surface, *shell_.extended, build.shell, build.report.blockedFaces);
    EXPECT_TRUE(check.passed());
    EXPECT_EQ(fileCount(), 1U);
}

TEST_F(ShellFiles, AreTheSameBytesEveryTime) {
    saveShell(path("again.shell"), *shell_.surface, *shell_.extended, kParameters, load());
    EXPECT_EQ(read(file_), read(path("again.shell")));
}

TEST_F(ShellFiles, AreLittleEndian) {
    EXPECT_EQ(read(file_).substr(0, 12), std::string("BSCSHELL\x01\0\0\0", 12));
}

TEST_F(ShellFiles, AreRefusedWithAnyByteChanged) {
    const std::string bytes = read(file_);
    constexpr std::array<int, 3> kMasks = {0x01, 0x80, 0xFF};
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        std::string changed = bytes;
        changed[i] = static_cast<char>(changed[i] ^ kMasks[i % kMasks.size()]);
        EXPECT_NE(refusalOf(changed), "") << "byte " << i;
    }
}

TEST_F(ShellFiles, AreRefusedWhereverTheyAreCutOff) {
    const std::string bytes = read(file_);
    for (std::size_t length = 0; length < bytes.size(); length += 13) {
        EXPECT_NE(refusalOf(bytes.substr(0, length)), "") << length << " bytes";
    }
    EXPECT_NE(refusalOf(bytes + "x"), "");
}

TEST_F(ShellFiles, AreRefusedByName) {
    const std::string bytes = read(file_);
    expectContains(refusalOf("a picture"), "changed.shell: is not a shell file");
    expectContains(refusalOf(bytes.substr(0, 20)), "is cut off after 20 bytes");
    expectContains(
        refusalOf(bytes.substr(0, 500)), "has 500 bytes instead of " + std::to_string(bytes.size())
    );
    std::string changed = bytes;
    changed[8] = 2;
    expectContains(refusalOf(changed), "has version 2 of the format, this program reads 1");
    changed = bytes;
    changed[300] = static_cast<char>(changed[300] + 1);
    expectContains(refusalOf(changed), "is damaged (its checksum does not match)");
}

TEST_F(ShellFiles, AreRefusedForAnotherSurface) {
    TriangleMesh mesh{shell_.surface->vertices(), shell_.surface->faces()};
    mesh.vertices[5].x() = std::nextafter(mesh.vertices[5].x(), 10.0);
    const Surface moved(mesh);
    expectContains(
        refusal([&] { return loadShell(file_, moved, shell_.extended, kParameters); }),
        "was made for another surface"
    );
    mesh = {shell_.surface->vertices(), shell_.surface->faces()};
    std::swap(mesh.faces[0], mesh.faces[1]);
    const Surface renumbered(mesh);
    EXPECT_NE(
        refusal([&] { return loadShell(file_, renumbered, shell_.extended, kParameters); }), ""
    );
}

TEST_F(ShellFiles, AreRefusedForOtherParameters) {
    expectContains(
        refusal([&] {
            return loadShell(file_, *shell_.surface, shell_.extended, "thickness 0.13");
        }),
        R"(was made with other parameters: "thickness 0.12", not "thickness 0.13")"
    );
}

TEST_F(ShellFiles, AreRefusedForAnotherBase) {
    const auto extended =
        std::make_shared<const ExtendedSurface>(extendSurface(*shell_.surface, 0));
    expectContains(
        refusal([&] { return loadShell(file_, *shell_.surface, extended, kParameters); }),
        "prepares this surface in another way"
    );
}

// Whatever wrote such a file: no index leads out of an array.
TEST_F(ShellFiles, AreRefusedWithAnyIndexOutOfRange) {
    const std::string bytes = read(file_);
    const ShellBuild build = load();
    const std::size_t prisms = 40 + kParameters.size() + 28 + 72 * build.shell.pillars().size();
    const std::size_t tracks = prisms + 31 * build.shell.prisms().size();
    const auto withIndex = [&](std::size_t place, std::int32_t index) {
        std::string changed = bytes;
        changed.replace(place, 4, bytesOf(index));
        return resealed(changed);
    };
    EXPECT_NO_THROW(static_cast<void>(load(write("same.shell", resealed(bytes)))));
    constexpr std::array<std::int32_t, 3> kOutside = {
        1000000, -2, std::numeric_limits<std::int32_t>::min()
    };
    for (std::size_t i = 0; i < build.shell.prisms().size(); ++i) {
        for (std::size_t k = 0; k < 6; ++k) {
            const std::string changed = withIndex(prisms + 31 * i + 4 * k, kOutside[(i + k) % 3]);
            expectContains(refusalOf(changed), "is damaged");
        }
    }
    for (std::size_t place = tracks; place + 8 < bytes.size(); place += 4) {
        expectContains(refusalOf(withIndex(place, kOutside[place % 3])), "is damaged");
    }
    for (std::size_t k = 24; k < 31; ++k) {
        std::string changed = bytes;
        changed[prisms + k] = 3;
        expectContains(refusalOf(resealed(changed)), "is damaged");
    }
}

TEST_F(ShellFiles, AreRefusedWithACountThatDoesNotFit) {
    for (std::size_t i = 0; i < 5; ++i) {
        std::string changed = read(file_);
        changed.replace(40 + kParameters.size() + 4 * i, 4, bytesOf(std::int32_t{-1}));
        expectContains(refusalOf(resealed(changed)), "is damaged");
    }
    std::string changed = read(file_);
    changed.replace(36, 4, bytesOf(std::int32_t{-1}));
    expectContains(refusalOf(resealed(changed)), "its parameters are longer than the file");
}

TEST_F(ShellFiles, AreRefusedWithACoordinateThatIsNotFinite) {
    std::string changed = read(file_);
    changed.replace(
        40 + kParameters.size() + 28, 8, bytesOf(std::numeric_limits<double>::quiet_NaN())
    );
    expectContains(refusalOf(resealed(changed)), "a coordinate is not finite");
}

TEST_F(ShellFiles, SayWhereTheyCannotBeWritten) {
    const std::string text = refusal(
        [&] {
            saveShell(
                path("nowhere/a.shell"), *shell_.surface, *shell_.extended, "", buildOf(shell_)
            );
            return 0;
        },
        InputErrorCode::UnwritableFile
    );
    expectContains(text, "nowhere");
}

TEST_F(ShellFiles, ChangeOnlyTogetherWithTheVersionOfTheSimplifier) {
    const ShellOptions options;
    const Surface surface(creasedHill());
    const auto extended =
        std::make_shared<const ExtendedSurface>(extendSurface(surface, options.smoothingPasses));
    const ShellBuild build = buildSimplifiedShell(extended, options);
    saveShell(path("hill.shell"), surface, *extended, "", build);
    constexpr int kVersion = 6;
    constexpr std::uint64_t kChecksum = 18157527224980071819U;
    EXPECT_EQ(kSimplifierVersion, kVersion);
    EXPECT_EQ(checksumOf(read(path("hill.shell"))), kChecksum)
        << "other shells are built than before: let kSimplifierVersion grow, so that those in "
           "caches are not used any more, and put it and the new checksum here";
}

}  // namespace bspline_curve::io_tests

// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/atomic_file.h"

#include "io/temporary_files.h"

#include <sys/wait.h>
#include <unistd.h>

namespace bspline_curve::io_tests {

namespace {

namespace fs = std::filesystem;

class AtomicFiles : public FileTest {};

}  // namespace

TEST_F(AtomicFiles, AppearOnlyWithCommit) {
    {
        AtomicFile file(path("new.txt"), "content");
        EXPECT_FALSE(fs::exists(path("new.txt")));
        file.commit();
        EXPECT_EQ(read(path("new.txt")), "content");
    }
    EXPECT_EQ(fileCount(), 1U);
}

TEST_F(AtomicFiles, LeaveNothingAndTouchNothingWithoutCommit) {
    write("old.txt", "old");
    {
        const AtomicFile file(path("old.txt"), "new");
    }
    {
        const AtomicFile file(path("other.txt"), "new");
    }
    EXPECT_EQ(read(path("old.txt")), "old");
    EXPECT_EQ(fileCount(), 1U);
}

TEST_F(AtomicFiles, LeaveNothingWhereTheProcessEndsAtOnce) {
    write("old.txt", "old");
    const pid_t child = ::fork();
    if (child == 0) {
        const AtomicFile first(path("old.txt"), "new");
        const AtomicFile second(path("other.txt"), "new");
        AtomicFile::abandonAll();
        ::_exit(7);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 7);
    EXPECT_EQ(read(path("old.txt")), "old");
    EXPECT_EQ(fileCount(), 1U);
}

TEST_F(AtomicFiles, KeepLinksAndPermissions) {
    write("old.txt", "old");
    fs::permissions(path("old.txt"), fs::perms::owner_read | fs::perms::owner_write);
    fs::create_symlink("old.txt", path("link.txt"));
    AtomicFile(path("link.txt"), "new").commit();
    EXPECT_TRUE(fs::is_symlink(path("link.txt")));
    EXPECT_EQ(read(path("old.txt")), "new");
    EXPECT_EQ(
        fs::status(path("old.txt")).permissions(), fs::perms::owner_read | fs::perms::owner_write
    );
}

TEST_F(AtomicFiles, WriteToADeviceWithoutReplacingIt) {
    AtomicFile("/dev/null", "content").commit();
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(AtomicFiles, AreRefusedWhereTheyCannotBe) {
    const auto refused = [&](const fs::path& file) {
        return refusal(
            [&] {
                checkWritable(file);
                return 0;
            },
            InputErrorCode::UnwritableFile
        );
    };
    expectContains(refused(path("none/a.txt")), "does not exist");
    fs::create_directory(path("folder.ply"));
    expectContains(refused(path("folder.ply")), "directory");
    EXPECT_NO_THROW(checkWritable(path("fine.txt")));
    EXPECT_FALSE(fs::exists(path("fine.txt")));
}

}  // namespace bspline_curve::io_tests

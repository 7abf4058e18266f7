// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/shell_cache.h"

#include "io/environment_variable.h"
#include "io/stored_shell.h"
#include "io/temporary_files.h"

#include <sys/resource.h>

#include <chrono>
#include <csignal>
#include <thread>

namespace bspline_curve::io_tests {

namespace {

namespace fs = std::filesystem;
using test_support::HandmadeShell;

class ShellCaches : public FileTest {
protected:
    [[nodiscard]] ShellCache::Found find(const ShellCache& cache, std::string_view parameters) {
        return cache.find(*shell_.surface, shell_.extended, parameters);
    }

    [[nodiscard]] std::string store(const ShellCache& cache, std::string_view parameters) {
        return cache.store(*shell_.surface, *shell_.extended, parameters, buildOf(shell_));
    }

    /// That the cache has exactly this shell, and nothing to say about it.
    void expectFound(const HandmadeShell& shell, std::string_view parameters) {
        const ShellCache::Found found = find(cache_, parameters);
        EXPECT_EQ(found.note, "");
        if (found.build) {
            expectSame(*found.build, buildOf(shell));
        } else {
            ADD_FAILURE() << "no shell for " << parameters;
        }
    }

    /// That damage is noticed, reported once, and gone afterwards.
    void expectDeleted(const std::string& damaged) {
        ASSERT_EQ(store(cache_, "a"), "");
        std::ofstream(entries().front(), std::ios::binary) << damaged;
        const ShellCache::Found found = find(cache_, "a");
        EXPECT_FALSE(found.build.has_value());
        expectContains(found.note, "the stored shell was not used and deleted");
        EXPECT_TRUE(entries().empty());
        EXPECT_EQ(find(cache_, "a").note, "");
    }

    struct Served {
        int hits = 0, troubles = 0;
        std::string note;  // of the last trouble
    };

    /// Stores and looks for some shells in turn, as one of several processes would.
    [[nodiscard]] Served serve(const ShellCache& cache, int first) {
        Served served;
        for (int i = first; i < first + 50; ++i) {
            const std::string parameters = std::to_string(i % 5);
            const std::string note = store(cache, parameters);
            const ShellCache::Found found = find(cache, parameters);
            const bool isHit = found.build.has_value();
            const bool isRight = !isHit || found.build->shell.tracks().faces == shell_.tracks.faces;
            served.hits += isHit ? 1 : 0;
            if (!note.empty() || !found.note.empty() || !isRight) {
                ++served.troubles;
                served.note = note + found.note;
            }
        }
        return served;
    }

    [[nodiscard]] std::vector<fs::path> entries() const {
        std::vector<fs::path> files;
        for (const auto& item : fs::directory_iterator(folder_)) {
            files.push_back(item.path());
        }
        return files;
    }

    /// As if every entry had been used that long before.
    void age(std::chrono::seconds by) const {
        for (const fs::path& file : entries()) {
            fs::last_write_time(file, fs::last_write_time(file) - by);
        }
    }

    HandmadeShell shell_ = smallShell();
    fs::path folder_ = path("cache/shells");
    ShellCache cache_{folder_};
};

/// Files of this process cannot grow beyond a size for as long as it lives.
class FileSizeLimit {
public:
    explicit FileSizeLimit(rlim_t bytes) : oldHandler_(std::signal(SIGXFSZ, SIG_IGN)) {
        EXPECT_EQ(::getrlimit(RLIMIT_FSIZE, &old_), 0);
        const rlimit low{.rlim_cur = bytes, .rlim_max = old_.rlim_max};
        EXPECT_EQ(::setrlimit(RLIMIT_FSIZE, &low), 0);
    }

    ~FileSizeLimit() {
        EXPECT_EQ(::setrlimit(RLIMIT_FSIZE, &old_), 0);
        std::signal(SIGXFSZ, oldHandler_);
    }

    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;

private:
    void (*oldHandler_)(int);
    rlimit old_{};
};

}  // namespace

TEST_F(ShellCaches, MissAtFirstAndHitOnceStored) {
    EXPECT_FALSE(find(cache_, "a").build.has_value());
    EXPECT_EQ(find(cache_, "a").note, "");
    EXPECT_FALSE(fs::exists(folder_));
    EXPECT_EQ(store(cache_, "a"), "");
    expectFound(shell_, "a");
}

TEST_F(ShellCaches, MissForOtherParametersAndSurfaces) {
    ASSERT_EQ(store(cache_, "a"), "");
    EXPECT_FALSE(find(cache_, "b").build.has_value());
    EXPECT_EQ(find(cache_, "b").note, "");
    const HandmadeShell other = test_support::coarseSphere(0, 2);
    EXPECT_FALSE(cache_.find(*other.surface, other.extended, "a").build.has_value());
    EXPECT_TRUE(find(cache_, "a").build.has_value());
}

TEST_F(ShellCaches, ReplaceAnEntryThatIsStoredAgain) {
    ASSERT_EQ(store(cache_, "a"), "");
    const HandmadeShell thinner = smallShell(0.25);
    ASSERT_EQ(cache_.store(*thinner.surface, *thinner.extended, "a", buildOf(thinner)), "");
    EXPECT_EQ(entries().size(), 1U);
    expectFound(thinner, "a");
}

TEST_F(ShellCaches, DeleteAndReportDamagedEntries) {
    ASSERT_EQ(store(cache_, "a"), "");
    const std::string bytes = read(entries().front());
    std::string changed = bytes;
    changed[bytes.size() / 2] = static_cast<char>(changed[bytes.size() / 2] ^ 1);
    expectDeleted(changed);
    expectDeleted(bytes.substr(0, 700));
    expectDeleted("");
    ASSERT_EQ(store(cache_, "a"), "");
    expectFound(shell_, "a");
}

TEST_F(ShellCaches, DeleteWhatAnotherBaseMade) {
    ASSERT_EQ(store(cache_, "a"), "");
    const auto extended =
        std::make_shared<const ExtendedSurface>(extendSurface(*shell_.surface, 0));
    const ShellCache::Found found = cache_.find(*shell_.surface, extended, "a");
    EXPECT_FALSE(found.build.has_value());
    expectContains(found.note, "in another way");
    EXPECT_TRUE(entries().empty());
}

TEST_F(ShellCaches, DeleteWhatWasNotUsedForLongest) {
    ASSERT_EQ(store(cache_, "a"), "");
    const ShellCache small(folder_, 2 * fs::file_size(entries().front()));
    age(std::chrono::seconds(100));
    ASSERT_EQ(store(small, "b"), "");
    age(std::chrono::seconds(100));
    EXPECT_TRUE(find(small, "a").build.has_value());  // b is the older one now
    ASSERT_EQ(store(small, "c"), "");
    EXPECT_EQ(entries().size(), 2U);
    EXPECT_TRUE(find(small, "a").build.has_value());
    EXPECT_FALSE(find(small, "b").build.has_value());
    EXPECT_TRUE(find(small, "c").build.has_value());
}

TEST_F(ShellCaches, SayWhatIsTooLargeForThem) {
    const ShellCache tiny(folder_, 100);
    expectContains(store(tiny, "a"), "larger than the limit");
    EXPECT_TRUE(entries().empty());
}

TEST_F(ShellCaches, RemoveWhatAnEndedProcessLeftBehind) {
    ASSERT_EQ(store(cache_, "a"), "");
    std::ofstream(folder_ / ".old.shell.1-0.tmp") << "half a shell";
    age(std::chrono::hours(2));
    std::ofstream(folder_ / ".new.shell.1-0.tmp") << "half a shell";
    ASSERT_EQ(store(cache_, "b"), "");
    EXPECT_FALSE(fs::exists(folder_ / ".old.shell.1-0.tmp"));
    EXPECT_TRUE(fs::exists(folder_ / ".new.shell.1-0.tmp"));
    EXPECT_TRUE(find(cache_, "a").build.has_value());
}

TEST_F(ShellCaches, LeaveOtherFilesAlone) {
    fs::create_directories(folder_ / "folder.shell");
    std::ofstream(folder_ / "notes.txt") << std::string(5000, 'x');
    const ShellCache tiny(folder_, 100);
    EXPECT_NE(store(tiny, "a"), "");
    EXPECT_TRUE(fs::exists(folder_ / "notes.txt"));
    EXPECT_TRUE(fs::exists(folder_ / "folder.shell"));
}

TEST_F(ShellCaches, ReportAFolderThatCannotBeMade) {
    write("file", "in the way");
    const ShellCache cache(path("file/shells"));
    expectContains(store(cache, "a"), "the shell was not stored");
    EXPECT_FALSE(find(cache, "a").build.has_value());
}

TEST_F(ShellCaches, ReportAFullDisk) {
    ASSERT_EQ(store(cache_, "a"), "");
    std::string note;
    {
        const FileSizeLimit writingFailsHalfWay(500);
        note = store(cache_, "b");
    }
    expectContains(note, "the shell was not stored");
    EXPECT_EQ(entries().size(), 1U);
    EXPECT_TRUE(find(cache_, "a").build.has_value());
}

TEST_F(ShellCaches, ServeSeveralAtOnce) {
    // The limit is so low that entries vanish under their readers.
    ASSERT_EQ(store(cache_, "0"), "");
    const ShellCache small(folder_, 3 * fs::file_size(entries().front()));
    std::vector<Served> served(4);
    {
        std::vector<std::jthread> threads;
        for (std::size_t t = 0; t < served.size(); ++t) {
            threads.emplace_back([&, t] { served[t] = serve(small, static_cast<int>(t)); });
        }
    }
    for (const Served& one : served) {
        EXPECT_GT(one.hits, 0);
        EXPECT_EQ(one.troubles, 0) << one.note;
    }
    for (const fs::path& file : entries()) {
        EXPECT_EQ(file.extension(), ".shell");
    }
}

TEST(ShellCacheFolder, FollowsTheEnvironment) {
    using Folder = std::optional<fs::path>;
    const Variable home("HOME", "/home/someone");
    const Variable noCache("BSPLINE_CURVE_CACHE", nullptr);
    const Variable noXdg("XDG_CACHE_HOME", nullptr);
    EXPECT_EQ(ShellCache::defaultDirectory(), Folder("/home/someone/.cache/bspline_curve/shells"));
    const Variable relative("XDG_CACHE_HOME", "cache");
    EXPECT_EQ(ShellCache::defaultDirectory(), Folder("/home/someone/.cache/bspline_curve/shells"));
    const Variable xdg("XDG_CACHE_HOME", "/var/cache");
    EXPECT_EQ(ShellCache::defaultDirectory(), Folder("/var/cache/bspline_curve/shells"));
    const Variable chosen("BSPLINE_CURVE_CACHE", "/elsewhere");
    EXPECT_EQ(ShellCache::defaultDirectory(), Folder("/elsewhere/shells"));
    const Variable off("BSPLINE_CURVE_CACHE", "");
    EXPECT_EQ(ShellCache::defaultDirectory(), std::nullopt);
}

TEST(ShellCacheFolder, IsNoneWithoutAHome) {
    const Variable home("HOME", nullptr);
    const Variable noCache("BSPLINE_CURVE_CACHE", nullptr);
    const Variable noXdg("XDG_CACHE_HOME", nullptr);
    EXPECT_EQ(ShellCache::defaultDirectory(), std::nullopt);
}

}  // namespace bspline_curve::io_tests

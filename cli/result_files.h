// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/atomic_file.h"

#include <cstddef>
#include <filesystem>
#include <list>
#include <string>
#include <vector>

namespace bspline_curve::cli {

/// The files of a verb, which appear together or not at all.
class ResultFiles {
public:
    /// Throws InputError (UnwritableFile).
    void add(const std::filesystem::path& file, const std::string& bytes);

    /// The name of the next one of several files, which come first: FILE.ply, FILE-2.ply, …; also
    /// FILE-2.bspline.dxf. Throws InputError (UnwritableFile) for a second one of standard output.
    [[nodiscard]] std::filesystem::path nextAfter(const std::filesystem::path& first) const;

    /// Takes note of further files of an earlier run, behind those of this one: FILE-3.ply where
    /// this one ends with FILE-2.ply. Only files whose numbers follow each other, and that were
    /// written together with FILE.ply, count. Before commit(), which removes them.
    void replaceSeries(const std::filesystem::path& first);

    /// Names of the files that replaceSeries() found.
    [[nodiscard]] const std::vector<std::filesystem::path>& stale() const { return stale_; }

    /// Throws InputError (UnwritableFile), Cancelled.
    void commit();

private:
    std::list<AtomicFile> files_;
    std::string printed_;  // the file that is standard output; empty: none
    std::vector<std::filesystem::path> stale_;
};

/// The name of a file of a series by its number: FILE.ply, FILE-2.ply, …; also FILE-2.bspline.dxf.
[[nodiscard]] std::filesystem::path numbered(
    const std::filesystem::path& first, std::size_t number
);

/// "1 curve", or "3 curves, the last in FILE-3.ply": what the files of a series hold.
[[nodiscard]] std::string describeSeries(
    std::size_t count, const char* one, const char* many, const std::filesystem::path& last
);

/// Refuses a file, where one is asked for, that could not be written after the work. `check`: of
/// its extension. Throws InputError (UnwritableFile).
void checkOutput(
    const std::filesystem::path& file, void (*check)(const std::filesystem::path&) = nullptr
);

}  // namespace bspline_curve::cli

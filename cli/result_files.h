// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/atomic_file.h"

#include <filesystem>
#include <list>
#include <string>

namespace bspline_curve::cli {

/// The files of a verb, which appear together or not at all.
class ResultFiles {
public:
    /// Throws InputError (UnwritableFile).
    void add(const std::filesystem::path& file, const std::string& bytes) {
        files_.emplace_back(file, bytes);
    }

    /// The name of the next one of several files, which come first: FILE.ply, FILE-2.ply, …; also
    /// FILE-2.bspline.dxf.
    [[nodiscard]] std::filesystem::path nextAfter(const std::filesystem::path& first) const;

    /// Throws InputError (UnwritableFile), Cancelled.
    void commit();

private:
    std::list<AtomicFile> files_;
};

/// Refuses a file, where one is asked for, that could not be written after the work. `check`: of
/// its extension. Throws InputError (UnwritableFile).
void checkOutput(
    const std::filesystem::path& file, void (*check)(const std::filesystem::path&) = nullptr
);

}  // namespace bspline_curve::cli

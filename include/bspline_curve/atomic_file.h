// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace bspline_curve {

/// A file that appears whole or not at all: the bytes go to a temporary file beside it, and
/// commit() renames that. Without commit() the temporary file is removed and what was there before
/// stays. A device or a pipe is written to by commit(), since it must not be replaced.
class AtomicFile {
public:
    /// Throws InputError (UnwritableFile).
    AtomicFile(const std::filesystem::path& file, std::string_view bytes);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    /// Throws InputError (UnwritableFile).
    void commit();

    /// Before the process ends at once: removes the temporary files of all that are there. From now
    /// on whoever makes, commits or destroys one waits for ever.
    static void abandonAll();

private:
    void removeTemporary();

    std::filesystem::path file_;
    std::filesystem::path temporary_;  ///< empty: nothing to rename or to remove
    std::string deviceBytes_;          ///< what commit() writes to a device
};

/// Throws InputError (UnwritableFile) where a file cannot be written: no such directory, a
/// directory itself, no permission. For finding out before hours of work; the file is not touched.
void checkWritable(const std::filesystem::path& file);

}  // namespace bspline_curve

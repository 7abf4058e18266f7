// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace bspline_curve {

/// For as long as this lives, the bytes of the one file there is: readers of io/ read from here,
/// since a page has no file system.
class FileInMemory {
public:
    FileInMemory(std::filesystem::path file, std::string bytes);
    ~FileInMemory();
    FileInMemory(const FileInMemory&) = delete;
    FileInMemory& operator=(const FileInMemory&) = delete;
};

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace bspline_curve::fuzz {

/// Bytes as a file, in a folder of this process, for as long as the object lives.
class FuzzFile {
public:
    FuzzFile(const std::string& name, std::string_view bytes);
    ~FuzzFile();
    FuzzFile(const FuzzFile&) = delete;
    FuzzFile& operator=(const FuzzFile&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

}  // namespace bspline_curve::fuzz

// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/numbered_file.h"

#include <string>

namespace bspline_curve::cli {

std::filesystem::path numberedFile(const std::filesystem::path& file, std::size_t index) {
    if (index == 0) {
        return file;
    }
    const std::string name = file.filename().string();
    std::size_t end = name.size() - file.extension().string().size();
    const std::string bspline = ".bspline";
    if (end >= bspline.size() && name.compare(end - bspline.size(), bspline.size(), bspline) == 0) {
        end -= bspline.size();
    }
    return file.parent_path() /
           (name.substr(0, end) + "-" + std::to_string(index + 1) + name.substr(end));
}

}  // namespace bspline_curve::cli

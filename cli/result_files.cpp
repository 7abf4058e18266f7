// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/result_files.h"

#include "cli/interrupt.h"

namespace bspline_curve::cli {

std::filesystem::path ResultFiles::nextAfter(const std::filesystem::path& first) const {
    if (files_.empty()) {
        return first;
    }
    const std::string name = first.filename().string();
    const std::string bspline = ".bspline";
    std::size_t end = name.size() - first.extension().string().size();
    if (name.substr(0, end).ends_with(bspline)) {
        end -= bspline.size();
    }
    return first.parent_path() /
           (name.substr(0, end) + "-" + std::to_string(files_.size() + 1) + name.substr(end));
}

void ResultFiles::commit() {
    beginWriting();
    for (AtomicFile& file : files_) {
        file.commit();
    }
}

void checkOutput(const std::filesystem::path& file, void (*check)(const std::filesystem::path&)) {
    if (file.empty()) {
        return;
    }
    if (check != nullptr) {
        check(file);
    }
    checkWritable(file);
}

}  // namespace bspline_curve::cli

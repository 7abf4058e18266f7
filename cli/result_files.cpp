// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/result_files.h"

#include "bspline_curve/error.h"
#include "cli/interrupt.h"
#include "text/error_messages.h"
#include "text/text_parsing.h"

#include <chrono>
#include <iostream>
#include <string_view>
#include <system_error>

namespace bspline_curve::cli {

std::filesystem::path numbered(const std::filesystem::path& first, std::size_t number) {
    if (number <= 1) {
        return first;
    }
    const std::string name = first.filename().string();
    std::size_t end = name.size() - first.extension().string().size();
    for (const std::string_view kind : {".bspline", ".polyline"}) {
        if (name.substr(0, end).ends_with(kind)) {
            end -= kind.size();
        }
    }
    return first.parent_path() /
           (name.substr(0, end) + "-" + std::to_string(number) + name.substr(end));
}

void ResultFiles::add(const std::filesystem::path& file, const std::string& bytes) {
    if (!isStandardStream(file)) {
        files_.emplace_back(file, bytes);
        return;
    }
    if (!printed_.empty()) {
        refuseWriting(file, "standard output can take one file; name the others");
    }
    printed_ = bytes;
}

std::filesystem::path ResultFiles::nextAfter(const std::filesystem::path& first) const {
    if (!printed_.empty()) {
        refuseWriting(
            first, "there are several files, and standard output can take one; name them"
        );
    }
    return numbered(first, files_.size() + 1);
}

void ResultFiles::replaceSeries(const std::filesystem::path& first) {
    // Files of one run are written within seconds, in the order of their numbers.
    constexpr auto kTogether = std::chrono::seconds(60);
    std::error_code error;
    auto before = std::filesystem::last_write_time(first, error);
    for (std::size_t number = 2; !error; ++number) {
        const std::filesystem::path file = numbered(first, number);
        const auto written = std::filesystem::last_write_time(file, error);
        if (error || written < before - kTogether || written > before + kTogether) {
            return;
        }
        before = written;
        if (number > files_.size()) {
            stale_.push_back(file);
        }
    }
}

void ResultFiles::commit() {
    beginWriting();
    for (AtomicFile& file : files_) {
        file.commit();
    }
    if (!printed_.empty() && !(std::cout << printed_ << std::flush)) {
        throw InputError(InputErrorCode::UnwritableFile, "standard output cannot be written");
    }
    for (const std::filesystem::path& file : stale_) {
        std::error_code error;
        std::filesystem::remove(file, error);
        if (error) {
            throw InputError(
                InputErrorCode::UnwritableFile,
                file.string() + ", of an earlier run, cannot be removed: " + error.message()
            );
        }
    }
}

std::string describeSeries(
    std::size_t count, const char* one, const char* many, const std::filesystem::path& last
) {
    const std::string all = describeCount(count, one, many);
    return count == 1 ? all : all + ", the last in " + last.string();
}

void checkOutput(const std::filesystem::path& file, void (*check)(const std::filesystem::path&)) {
    if (file.empty()) {
        return;
    }
    if (check != nullptr) {
        check(file);
    }
    if (!isStandardStream(file)) {
        checkWritable(file);
    }
}

}  // namespace bspline_curve::cli

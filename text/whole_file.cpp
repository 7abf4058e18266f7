// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/text_parsing.h"

#include <array>
#include <cerrno>
#include <fstream>
#include <iostream>
#include <system_error>

namespace bspline_curve {

namespace {

std::string bytesOf(std::istream& stream, const std::filesystem::path& file) {
    std::string bytes;
    std::array<char, 1 << 16> block{};
    do {
        stream.read(block.data(), block.size());
        bytes.append(block.data(), stream.gcount());
    } while (stream);
    if (stream.bad()) {
        refuseFile(file, "cannot be read");
    }
    if (bytes.empty()) {
        refuseFile(file, "the file is empty");
    }
    return bytes;
}

/// Standard input can be read once, and is one file.
const std::string& standardInput(const std::filesystem::path& file) {
    static const std::filesystem::path kFirst = file;
    static const std::string kBytes = bytesOf(std::cin, file);
    if (file != kFirst) {
        refuseFile(file, "standard input is " + kFirst.string() + " already; name a file");
    }
    return kBytes;
}

}  // namespace

bool isStandardStream(const std::filesystem::path& file) {
    return file.native().starts_with("-.") && !file.has_parent_path();
}

std::optional<std::string> readWholeFileIfThere(const std::filesystem::path& file) {
    if (isStandardStream(file)) {
        return standardInput(file);
    }
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (!std::filesystem::exists(status)) {
        return std::nullopt;
    }
    if (std::filesystem::is_directory(status)) {
        refuseFile(file, "is a directory, not a file");
    }
    errno = 0;
    std::ifstream stream(file, std::ios::binary);
    if (!stream) {
        if (errno == ENOENT) {
            return std::nullopt;  // deleted meanwhile
        }
        refuseFile(file, "cannot be opened for reading");
    }
    return bytesOf(stream, file);
}

}  // namespace bspline_curve

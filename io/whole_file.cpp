// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/text_parsing.h"

#include <array>
#include <cerrno>
#include <fstream>
#include <system_error>

namespace bspline_curve {

std::optional<std::string> readWholeFileIfThere(const std::filesystem::path& file) {
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

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#include "web/core/files_in_memory.h"

#include "text/text_parsing.h"

#include <optional>
#include <utility>

namespace bspline_curve {

namespace {

struct NamedBytes {
    std::filesystem::path file;
    std::string bytes;
};

std::optional<NamedBytes>& onlyFile() {
    static std::optional<NamedBytes> file;
    return file;
}

}  // namespace

FileInMemory::FileInMemory(std::filesystem::path file, std::string bytes) {
    onlyFile() = NamedBytes{std::move(file), std::move(bytes)};
}

FileInMemory::~FileInMemory() {
    onlyFile().reset();
}

std::optional<std::string> readWholeFileIfThere(const std::filesystem::path& file) {
    const std::optional<NamedBytes>& there = onlyFile();
    if (!there || there->file != file) {
        return std::nullopt;
    }
    if (there->bytes.empty()) {
        refuseFile(file, "the file is empty");
    }
    return there->bytes;
}

}  // namespace bspline_curve

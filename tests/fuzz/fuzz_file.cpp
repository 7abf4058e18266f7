// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/fuzz_file.h"

#include <unistd.h>

#include <fstream>
#include <ios>

namespace bspline_curve::fuzz {

FuzzFile::FuzzFile(const std::string& name, std::string_view bytes)
    : path_(
          std::filesystem::temp_directory_path() /
          ("bspline curve fuzz " + std::to_string(::getpid())) / name
      ) {
    std::filesystem::create_directories(path_.parent_path());
    std::ofstream stream(path_, std::ios::binary);
    stream.exceptions(std::ios::failbit | std::ios::badbit);
    stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

FuzzFile::~FuzzFile() {
    std::error_code ignored;  // it is in a temporary folder
    std::filesystem::remove_all(path_.parent_path(), ignored);
}

}  // namespace bspline_curve::fuzz

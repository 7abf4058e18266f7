// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/temporary_files.h"

#include <cstdint>
#include <string>

namespace bspline_curve::io_tests {

/// The bytes of a .npy file of a version, from its header's dictionary and its data.
inline std::string npy(const std::string& dictionary, const std::string& data, char version = 1) {
    std::string header = dictionary + std::string(64 - dictionary.size() % 64, ' ') + "\n";
    std::string bytes = std::string("\x93NUMPY") + version + '\0';
    bytes += version == 1 ? bytesOf(static_cast<std::uint16_t>(header.size()))
                          : bytesOf(static_cast<std::uint32_t>(header.size()));
    return bytes + header + data;
}

inline std::string npyDictionary(const std::string& type, const std::string& shape) {
    return "{'descr': '" + type + "', 'fortran_order': False, 'shape': " + shape + ", }";
}

}  // namespace bspline_curve::io_tests

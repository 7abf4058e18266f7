// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace bspline_curve {

/// An element of an XML document.
struct XmlElement {
    std::string name;  ///< without its prefix
    std::vector<std::pair<std::string, std::string>> attributes;
    std::vector<XmlElement> children;
    std::string text;      ///< before its first child
    std::size_t line = 0;  ///< of the file, from 1

    /// The value of an attribute; empty where there is none.
    [[nodiscard]] std::string_view attribute(std::string_view key) const {
        for (const auto& [own, value] : attributes) {
            if (own == key) {
                return value;
            }
        }
        return {};
    }
};

/// The root element of a document. Throws InputError (UnreadableFile) with the line where it is not
/// XML.
[[nodiscard]] XmlElement xmlTreeOf(const std::filesystem::path& file, std::string_view bytes);

}  // namespace bspline_curve

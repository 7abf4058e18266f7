// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/ply_header.h"

#include "text/text_parsing.h"

#include <algorithm>
#include <array>
#include <utility>

namespace bspline_curve {

namespace {

constexpr std::array<std::pair<std::string_view, PlyScalar>, 16> kTypeNames{{
    {"char", PlyScalar::Int8},
    {"int8", PlyScalar::Int8},
    {"uchar", PlyScalar::UInt8},
    {"uint8", PlyScalar::UInt8},
    {"short", PlyScalar::Int16},
    {"int16", PlyScalar::Int16},
    {"ushort", PlyScalar::UInt16},
    {"uint16", PlyScalar::UInt16},
    {"int", PlyScalar::Int32},
    {"int32", PlyScalar::Int32},
    {"uint", PlyScalar::UInt32},
    {"uint32", PlyScalar::UInt32},
    {"float", PlyScalar::Float},
    {"float32", PlyScalar::Float},
    {"double", PlyScalar::Double},
    {"float64", PlyScalar::Double},
}};

PlyScalar typeNamed(std::string_view name) {
    const auto* const found =
        std::ranges::find(kTypeNames, name, &std::pair<std::string_view, PlyScalar>::first);
    return found == kTypeNames.end() ? PlyScalar::None : found->second;
}

class HeaderReader {
public:
    HeaderReader(const std::filesystem::path& file, std::string_view bytes)
        : file_(file), bytes_(bytes) {}

    PlyHeader run() {
        header_.size = bytes_.size() - withoutByteOrderMark(bytes_).size();
        const std::string_view rest = bytes_.substr(header_.size);
        if (trimmed(rest.substr(0, rest.find('\n'))) != "ply") {
            refuseFile(file_, "is not a PLY file (it does not start with \"ply\")");
        }
        bool ended = false;
        while (!ended) {
            ended = readLine();
        }
        if (!formatSeen_) {
            refuseFile(file_, "the PLY header names no format");
        }
        return std::move(header_);
    }

private:
    /// Takes one line; true at the last.
    bool readLine() {
        const std::size_t end = bytes_.find('\n', header_.size);
        if (end == std::string_view::npos) {
            refuseFile(file_, "the PLY header does not end");
        }
        const auto words = splitAtBlanks(bytes_.substr(header_.size, end - header_.size));
        header_.size = end + 1;
        ++line_;
        if (words.empty()) {
            refuse("an empty line in the header");
        }
        if (words[0] == "format") {
            readFormat(words);
        } else if (words[0] == "element") {
            readElement(words);
        } else if (words[0] == "property") {
            readProperty(words);
        }
        header_.lines = line_;
        return words[0] == "end_header";
    }

    void readFormat(const std::vector<std::string_view>& words) {
        const std::string_view name = words.size() > 1 ? words[1] : std::string_view();
        if (name == "ascii") {
            header_.format = PlyFormat::Ascii;
        } else if (name == "binary_little_endian") {
            header_.format = PlyFormat::LittleEndian;
        } else if (name == "binary_big_endian") {
            header_.format = PlyFormat::BigEndian;
        } else {
            refuse("unknown format " + inQuotes(name));
        }
        formatSeen_ = true;
    }

    void readElement(const std::vector<std::string_view>& words) {
        const auto count = parseInteger(words.size() == 3 ? words[2] : std::string_view());
        if (!count || *count < 0 || *count > 0x7fffffff) {
            refuse("an element needs a name and a count");
        }
        const auto same = [&](const PlyElement& element) { return element.name == words[1]; };
        if (std::ranges::any_of(header_.elements, same)) {
            refuse("the element " + inQuotes(words[1]) + " comes twice");
        }
        header_.elements.push_back({std::string(words[1]), static_cast<std::size_t>(*count), {}});
    }

    void readProperty(const std::vector<std::string_view>& words) {
        const bool isList = words.size() > 1 && words[1] == "list";
        if (header_.elements.empty() || words.size() != (isList ? 5U : 3U)) {
            refuse("a property that belongs nowhere or is not complete");
        }
        PlyProperty property;
        property.name = words.back();
        property.type = typeNamed(words[words.size() - 2]);
        property.countType = isList ? typeNamed(words[2]) : PlyScalar::None;
        if (property.type == PlyScalar::None ||
            (isList && (property.countType == PlyScalar::None || isFloating(property.countType)))) {
            refuse("unknown type in " + inQuotes(words[1]) + " … " + inQuotes(property.name));
        }
        header_.elements.back().properties.push_back(std::move(property));
    }

    [[noreturn]] void refuse(const std::string& reason) const { refuseLine(file_, line_, reason); }

    const std::filesystem::path& file_;
    std::string_view bytes_;
    PlyHeader header_;
    std::size_t line_ = 0;
    bool formatSeen_ = false;
};

}  // namespace

std::string nameOf(PlyScalar type) {
    const auto* const found =
        std::ranges::find(kTypeNames, type, &std::pair<std::string_view, PlyScalar>::second);
    return found == kTypeNames.end() ? "none" : std::string(found->first);
}

std::size_t sizeOf(PlyScalar type) {
    switch (type) {
        case PlyScalar::None:
            return 0;
        case PlyScalar::Int8:
        case PlyScalar::UInt8:
            return 1;
        case PlyScalar::Int16:
        case PlyScalar::UInt16:
            return 2;
        case PlyScalar::Int32:
        case PlyScalar::UInt32:
        case PlyScalar::Float:
            return 4;
        case PlyScalar::Double:
            return 8;
    }
    return 0;
}

bool isFloating(PlyScalar type) {
    return type == PlyScalar::Float || type == PlyScalar::Double;
}

const PlyProperty* findProperty(const PlyElement& element, std::string_view name) {
    const auto found = std::ranges::find(element.properties, name, &PlyProperty::name);
    return found == element.properties.end() ? nullptr : &*found;
}

PlyHeader readPlyHeader(const std::filesystem::path& file, std::string_view bytes) {
    return HeaderReader(file, bytes).run();
}

}  // namespace bspline_curve

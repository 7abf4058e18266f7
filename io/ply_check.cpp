// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/file_checks.h"
#include "io/text_parsing.h"
#include "surface/input_error.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

namespace bspline_curve {

namespace {

struct Property {
    std::string name;
    PlyScalar type = PlyScalar::None;
    PlyScalar countType = PlyScalar::None;  ///< None: not a list
};

struct Element {
    std::string name;
    std::size_t count = 0;
    std::vector<Property> properties;
};

enum class Format { Ascii, LittleEndian, BigEndian };

struct Header {
    Format format = Format::Ascii;
    std::vector<Element> elements;
    std::size_t size = 0;  ///< in bytes; the data follow
};

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

// ---------------------------------------------------------------- header

class HeaderReader {
public:
    HeaderReader(const std::filesystem::path& file, std::string_view bytes)
        : file_(file), bytes_(bytes) {}

    Header run() {
        if (!bytes_.starts_with("ply\n") && !bytes_.starts_with("ply\r\n")) {
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
        return words[0] == "end_header";
    }

    void readFormat(const std::vector<std::string_view>& words) {
        const std::string_view name = words.size() > 1 ? words[1] : std::string_view();
        if (name == "ascii") {
            header_.format = Format::Ascii;
        } else if (name == "binary_little_endian") {
            header_.format = Format::LittleEndian;
        } else if (name == "binary_big_endian") {
            header_.format = Format::BigEndian;
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
        const auto same = [&](const Element& element) { return element.name == words[1]; };
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
        Property property;
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
    Header header_;
    std::size_t line_ = 0;
    bool formatSeen_ = false;
};

const Property* find(const Element& element, std::string_view name) {
    const auto found = std::ranges::find(element.properties, name, &Property::name);
    return found == element.properties.end() ? nullptr : &*found;
}

// ---------------------------------------------------------------- data

/// Runs over the numbers of the data part. Where one is missing or is not a number, `failed` stays
/// true.
class DataCursor {
public:
    DataCursor(std::string_view data, Format format) : data_(data), format_(format) {}

    [[nodiscard]] bool failed() const { return failed_; }

    void skip(PlyScalar type) {
        if (format_ == Format::Ascii) {
            static_cast<void>(number(type));
        } else {
            static_cast<void>(take(sizeOf(type)));
        }
    }

    /// Many scalars at once, without looking at them; binary only.
    void skipBytes(std::size_t count) { static_cast<void>(take(count)); }

    double number(PlyScalar type) {
        if (format_ == Format::Ascii) {
            return asciiNumber(type);
        }
        switch (type) {
            case PlyScalar::None:
                return 0.0;
            case PlyScalar::Int8:
                return binaryNumber<std::int8_t>();
            case PlyScalar::UInt8:
                return binaryNumber<std::uint8_t>();
            case PlyScalar::Int16:
                return binaryNumber<std::int16_t>();
            case PlyScalar::UInt16:
                return binaryNumber<std::uint16_t>();
            case PlyScalar::Int32:
                return binaryNumber<std::int32_t>();
            case PlyScalar::UInt32:
                return binaryNumber<std::uint32_t>();
            case PlyScalar::Float:
                return static_cast<double>(binaryNumber<float>());
            case PlyScalar::Double:
                return binaryNumber<double>();
        }
        return 0.0;
    }

private:
    double asciiNumber(PlyScalar type) {
        constexpr std::string_view kBlanks = " \t\r\n";
        const std::size_t first = std::min(data_.find_first_not_of(kBlanks), data_.size());
        const std::size_t end = std::min(data_.find_first_of(kBlanks, first), data_.size());
        const std::string_view token = data_.substr(first, end - first);
        data_.remove_prefix(end);
        if (isFloating(type)) {
            const auto value = parseNumber(token);
            failed_ = failed_ || !value;
            return value.value_or(0.0);
        }
        const auto value = parseInteger(token);
        failed_ = failed_ || !value;
        return static_cast<double>(value.value_or(0));
    }

    std::string_view take(std::size_t count) {
        if (data_.size() < count) {
            failed_ = true;
            return {};
        }
        const std::string_view taken = data_.substr(0, count);
        data_.remove_prefix(count);
        return taken;
    }

    template <class Number>
    Number binaryNumber() {
        const std::string_view bytes = take(sizeof(Number));
        Number value{};
        if (bytes.size() != sizeof(Number)) {
            return value;
        }
        std::array<char, sizeof(Number)> copy{};
        std::ranges::copy(bytes, copy.begin());
        if (format_ == Format::BigEndian) {
            std::ranges::reverse(copy);
        }
        std::memcpy(&value, copy.data(), sizeof value);
        return value;
    }

    std::string_view data_;
    Format format_;
    bool failed_ = false;
};

class DataCheck {
public:
    DataCheck(const std::filesystem::path& file, const Header& header, std::string_view data)
        : file_(file), header_(header), cursor_(data, header.format) {}

    void run(ExpectedMesh& expected) {
        vertices_ = static_cast<double>(expected.vertices);
        for (const Element& element : header_.elements) {
            checkElement(element);
        }
        expected.triangles = triangles_;
        if (!repeating_.empty()) {
            throw InputError(
                InputErrorCode::DegenerateFace,
                file_.string() + ": " + std::to_string(repeating_.size()) +
                    " faces name a vertex twice: " + describeElements(repeating_) +
                    "; remove them (MeshLab: Remove Zero Area Faces)",
                repeating_
            );
        }
    }

private:
    void checkElement(const Element& element) {
        const bool hasList = std::ranges::any_of(element.properties, [](const Property& property) {
            return property.countType != PlyScalar::None;
        });
        if (!hasList && header_.format != Format::Ascii) {
            std::size_t size = 0;
            for (const Property& property : element.properties) {
                size += sizeOf(property.type);
            }
            cursor_.skipBytes(size * element.count);
            refuseIfFailed(element, element.count);
            return;
        }
        for (std::size_t i = 0; i < element.count; ++i) {
            for (const Property& property : element.properties) {
                checkProperty(element, property, i);
            }
            refuseIfFailed(element, i);
        }
    }

    void checkProperty(const Element& element, const Property& property, std::size_t i) {
        if (property.countType == PlyScalar::None) {
            cursor_.skip(property.type);
            return;
        }
        const double count = cursor_.number(property.countType);
        const bool isFace = element.name == "face" &&
                            (property.name == "vertex_indices" || property.name == "vertex_index");
        // vcglib has room for 255 corners, and takes those of the face before where there are
        // under 3.
        if (!cursor_.failed() && isFace && (count < 3 || count > 255)) {
            refuseFile(
                file_,
                "face " + std::to_string(i) + " has " +
                    std::to_string(static_cast<long long>(count)) + " corners"
            );
        }
        corners_.clear();
        for (double k = 0; k < count && !cursor_.failed(); ++k) {
            corners_.push_back(cursor_.number(property.type));
        }
        if (isFace && !cursor_.failed()) {
            checkFace(i);
        }
    }

    void checkFace(std::size_t i) {
        for (const double corner : corners_) {
            if (corner < 0 || corner >= vertices_) {
                refuseFile(
                    file_,
                    "face " + std::to_string(i) + " names vertex " +
                        std::to_string(static_cast<long long>(corner)) + " of " +
                        std::to_string(static_cast<long long>(vertices_)) + ", counted from 0"
                );
            }
        }
        triangles_ += corners_.size() - 2;
        std::ranges::sort(corners_);
        if (std::ranges::adjacent_find(corners_) != corners_.end()) {
            repeating_.push_back(static_cast<std::int64_t>(i));
        }
    }

    void refuseIfFailed(const Element& element, std::size_t i) const {
        if (!cursor_.failed()) {
            return;
        }
        refuseFile(
            file_,
            "is truncated or damaged: no " + element.name + " " +
                (i < element.count ? std::to_string(i) + " " : "data ") + "of " +
                std::to_string(element.count)
        );
    }

    const std::filesystem::path& file_;
    const Header& header_;
    DataCursor cursor_;
    double vertices_ = 0.0;
    std::size_t triangles_ = 0;
    std::vector<double> corners_;
    std::vector<std::int64_t> repeating_;
};

// ---------------------------------------------------------------- what vcglib needs of the header

ExpectedMesh expectVertices(const std::filesystem::path& file, const Header& header) {
    const auto vertex = std::ranges::find(header.elements, "vertex", &Element::name);
    if (vertex == header.elements.end() || vertex->count == 0) {
        refuseFile(file, "has no vertices");
    }
    ExpectedMesh expected;
    expected.vertices = vertex->count;
    for (const char* name : {"x", "y", "z"}) {
        const Property* const property = find(*vertex, name);
        if (property == nullptr || !isFloating(property->type)) {
            refuseFile(
                file, std::string("the vertices have no ") + name + " of type float or double"
            );
        }
        if (header.format == Format::BigEndian && property->type == PlyScalar::Double) {
            refuseFile(
                file, "big-endian double coordinates are not supported; save it little-endian"
            );
        }
    }
    const Property* const quality = find(*vertex, "quality");
    if (quality != nullptr && isFloating(quality->type) &&
        (header.format != Format::BigEndian || quality->type == PlyScalar::Float)) {
        expected.quality = quality->type;
    }
    return expected;
}

void checkElementsKnown(const std::filesystem::path& file, const Header& header) {
    for (const Element& element : header.elements) {
        if (element.name == "tristrips" || element.name == "range_grid") {
            refuseFile(file, "has " + inQuotes(element.name) + ", not faces; save it as triangles");
        }
        if (element.name == "edge" &&
            (find(element, "vertex1") == nullptr || find(element, "vertex2") == nullptr)) {
            refuseFile(file, "its edges have no vertex1 and vertex2");
        }
    }
}

}  // namespace

ExpectedMesh checkPly(const std::filesystem::path& file, std::string_view bytes) {
    const Header header = HeaderReader(file, bytes).run();
    ExpectedMesh expected = expectVertices(file, header);
    checkElementsKnown(file, header);
    const auto face = std::ranges::find(header.elements, "face", &Element::name);
    if (face == header.elements.end() || face->count == 0) {
        refuseFile(file, "has no faces");
    }
    const Property* indices = find(*face, "vertex_indices");
    indices = indices != nullptr ? indices : find(*face, "vertex_index");
    if (indices == nullptr || indices->countType == PlyScalar::None) {
        refuseFile(file, "the faces have no list vertex_indices");
    }
    if (isFloating(indices->type)) {
        refuseFile(file, "the faces' vertex indices are of type " + nameOf(indices->type));
    }
    DataCheck(file, header, bytes.substr(header.size)).run(expected);
    return expected;
}

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/file_checks.h"
#include "io/ply_header.h"
#include "io/text_parsing.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

namespace bspline_curve {

namespace {

/// Runs over the numbers of the data part. Where one is missing or is not a number, `failed` stays
/// true.
class DataCursor {
public:
    DataCursor(std::string_view data, PlyFormat format) : data_(data), format_(format) {}

    [[nodiscard]] bool failed() const { return failed_; }

    void skip(PlyScalar type) {
        if (format_ == PlyFormat::Ascii) {
            static_cast<void>(number(type));
        } else {
            static_cast<void>(take(sizeOf(type)));
        }
    }

    /// Many scalars at once, without looking at them; binary only.
    void skipBytes(std::size_t count) { static_cast<void>(take(count)); }

    double number(PlyScalar type) {
        if (format_ == PlyFormat::Ascii) {
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
        if (format_ == PlyFormat::BigEndian) {
            std::ranges::reverse(copy);
        }
        std::memcpy(&value, copy.data(), sizeof value);
        return value;
    }

    std::string_view data_;
    PlyFormat format_;
    bool failed_ = false;
};

class DataCheck {
public:
    DataCheck(const std::filesystem::path& file, const PlyHeader& header, std::string_view data)
        : file_(file), header_(header), cursor_(data, header.format) {}

    void run(ExpectedMesh& expected) {
        vertices_ = static_cast<double>(expected.vertices);
        for (const PlyElement& element : header_.elements) {
            checkElement(element);
        }
        expected.triangles = triangles_;
        expected.repeating = std::move(repeating_);
    }

private:
    void checkElement(const PlyElement& element) {
        const bool hasList =
            std::ranges::any_of(element.properties, [](const PlyProperty& property) {
                return property.countType != PlyScalar::None;
            });
        if (!hasList && header_.format != PlyFormat::Ascii) {
            std::size_t size = 0;
            for (const PlyProperty& property : element.properties) {
                size += sizeOf(property.type);
            }
            cursor_.skipBytes(size * element.count);
            refuseIfFailed(element, element.count);
            return;
        }
        for (std::size_t i = 0; i < element.count; ++i) {
            for (const PlyProperty& property : element.properties) {
                checkProperty(element, property, i);
            }
            refuseIfFailed(element, i);
        }
    }

    void checkProperty(const PlyElement& element, const PlyProperty& property, std::size_t i) {
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

    void refuseIfFailed(const PlyElement& element, std::size_t i) const {
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
    const PlyHeader& header_;
    DataCursor cursor_;
    double vertices_ = 0.0;
    std::size_t triangles_ = 0;
    std::vector<double> corners_;
    std::vector<std::int64_t> repeating_;
};

// ---------------------------------------------------------------- what vcglib needs of the header

ExpectedMesh expectVertices(const std::filesystem::path& file, const PlyHeader& header) {
    const auto vertex = std::ranges::find(header.elements, "vertex", &PlyElement::name);
    if (vertex == header.elements.end() || vertex->count == 0) {
        refuseFile(file, "has no vertices");
    }
    ExpectedMesh expected;
    expected.vertices = vertex->count;
    for (const char* name : {"x", "y", "z"}) {
        const PlyProperty* const property = findProperty(*vertex, name);
        if (property == nullptr || !isFloating(property->type)) {
            refuseFile(
                file, std::string("the vertices have no ") + name + " of type float or double"
            );
        }
        if (header.format == PlyFormat::BigEndian && property->type == PlyScalar::Double) {
            refuseFile(
                file, "big-endian double coordinates are not supported; save it little-endian"
            );
        }
    }
    const PlyProperty* const quality = findProperty(*vertex, "quality");
    if (quality != nullptr && isFloating(quality->type) &&
        (header.format != PlyFormat::BigEndian || quality->type == PlyScalar::Float)) {
        expected.quality = quality->type;
    }
    return expected;
}

void checkElementsKnown(const std::filesystem::path& file, const PlyHeader& header) {
    for (const PlyElement& element : header.elements) {
        if (element.name == "tristrips" || element.name == "range_grid") {
            refuseFile(file, "has " + inQuotes(element.name) + ", not faces; save it as triangles");
        }
        if (element.name == "edge" && (findProperty(element, "vertex1") == nullptr ||
                                       findProperty(element, "vertex2") == nullptr)) {
            refuseFile(file, "its edges have no vertex1 and vertex2");
        }
    }
}

}  // namespace

ExpectedMesh checkPly(const std::filesystem::path& file, std::string_view bytes) {
    const PlyHeader header = readPlyHeader(file, bytes);
    ExpectedMesh expected = expectVertices(file, header);
    checkElementsKnown(file, header);
    const auto face = std::ranges::find(header.elements, "face", &PlyElement::name);
    if (face == header.elements.end() || face->count == 0) {
        refuseFile(file, "has no faces");
    }
    const PlyProperty* indices = findProperty(*face, "vertex_indices");
    indices = indices != nullptr ? indices : findProperty(*face, "vertex_index");
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

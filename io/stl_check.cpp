// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/file_checks.h"
#include "io/text_parsing.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>

namespace bspline_curve {

namespace {

constexpr std::size_t kHeaderSize = 84;  // 80 characters and the count
constexpr std::size_t kTriangleSize = 50;

std::size_t binaryTriangles(std::string_view bytes) {
    static_assert(std::endian::native == std::endian::little);
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.data() + kHeaderSize - sizeof count, sizeof count);
    return count;
}

/// vcglib's rule: binary where the size fits the count, or where the beginning is not text.
bool isBinary(std::string_view bytes) {
    if (bytes.size() == kHeaderSize + kTriangleSize * binaryTriangles(bytes)) {
        return true;
    }
    const std::string_view start = bytes.substr(kHeaderSize, 1000);
    return std::ranges::any_of(start, [](char c) { return static_cast<unsigned char>(c) > 127; });
}

std::size_t checkBinary(const std::filesystem::path& file, std::string_view bytes) {
    const std::size_t triangles = binaryTriangles(bytes);
    const std::size_t expected = kHeaderSize + kTriangleSize * triangles;
    if (bytes.size() < expected) {
        refuseFile(
            file,
            "is truncated: " + std::to_string(triangles) + " triangles take " +
                std::to_string(expected) + " bytes, the file has " + std::to_string(bytes.size())
        );
    }
    return triangles;
}

void checkAsciiVertex(
    const std::filesystem::path& file, std::size_t line, const std::vector<std::string_view>& words
) {
    if (words.size() != 4 || !parseNumber(words[1]) || !parseNumber(words[2]) ||
        !parseNumber(words[3])) {
        refuseLine(file, line, "a vertex needs three coordinates");
    }
}

std::size_t checkAscii(const std::filesystem::path& file, std::string_view bytes) {
    LineReader lines(bytes);
    std::size_t facets = 0;
    std::size_t vertices = 0;
    bool ended = false;
    for (std::size_t statement = 0; lines.next();) {
        const auto words = splitAtBlanks(lines.line());
        if (words.empty()) {
            continue;
        }
        const std::string keyword = lowerCase(words[0]);
        if (statement++ == 0 && keyword != "solid") {
            refuseFile(file, "is neither a binary STL file nor a text that starts with \"solid\"");
        }
        if (keyword == "facet") {
            ++facets;
        } else if (keyword == "vertex") {
            checkAsciiVertex(file, lines.number(), words);
            ++vertices;
        }
        ended = keyword == "endsolid";
    }
    if (!ended || vertices != 3 * facets) {
        refuseFile(
            file,
            "is truncated or no STL file: " + std::to_string(facets) + " facets, " +
                std::to_string(vertices) + " vertices" +
                (ended ? "" : ", no \"endsolid\" at the end")
        );
    }
    return facets;
}

}  // namespace

ExpectedMesh checkStl(const std::filesystem::path& file, std::string_view bytes) {
    if (bytes.size() < kHeaderSize) {
        refuseFile(
            file, "is too short for an STL mesh (" + std::to_string(bytes.size()) + " bytes)"
        );
    }
    ExpectedMesh expected;
    expected.triangles = isBinary(bytes) ? checkBinary(file, bytes) : checkAscii(file, bytes);
    expected.vertices = 3 * expected.triangles;
    return expected;
}

}  // namespace bspline_curve

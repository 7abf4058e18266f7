// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/mesh_parsers.h"
#include "text/text_parsing.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

namespace bspline_curve {

namespace {

constexpr std::size_t kHeaderSize = 84;    // 80 characters and the count
constexpr std::size_t kTriangleSize = 50;  // normal, three corners and two bytes more

std::size_t binaryTriangles(std::string_view bytes) {
    static_assert(std::endian::native == std::endian::little);
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.data() + kHeaderSize - sizeof count, sizeof count);
    return count;
}

/// Whether one of the first lines starts with "facet", as no header does.
bool startsWithFacet(std::string_view bytes) {
    constexpr std::size_t kLongestStart = 4096;  // of names and comments before the first facet
    LineReader lines(bytes.substr(0, kLongestStart));
    while (lines.next()) {
        const std::string_view line = trimmed(lines.line());
        const std::string keyword = lowerCase(line.substr(0, line.find_first_of(" \t")));
        if (keyword == "facet" && line.find('\0') == std::string_view::npos) {
            return true;
        }
    }
    return false;
}

/// Binary where the size fits the count, or where the beginning is no text. Neither the word
/// "solid" tells, which binary files may start with, nor letters beyond ASCII, which names may
/// have.
bool isBinary(std::string_view bytes) {
    if (bytes.size() == kHeaderSize + kTriangleSize * binaryTriangles(bytes)) {
        return true;
    }
    if (startsWithFacet(bytes)) {
        return false;
    }
    const std::string_view start = bytes.substr(kHeaderSize, 1000);
    return std::ranges::any_of(start, [](char c) { return static_cast<unsigned char>(c) > 127; });
}

void parseBinary(const std::filesystem::path& file, std::string_view bytes, TriangleMesh& mesh) {
    const std::size_t triangles = binaryTriangles(bytes);
    const std::size_t expected = kHeaderSize + kTriangleSize * triangles;
    if (bytes.size() < expected) {
        refuseFile(
            file,
            "is truncated: " + std::to_string(triangles) + " triangles take " +
                std::to_string(expected) + " bytes, the file has " + std::to_string(bytes.size())
        );
    }
    mesh.vertices.reserve(3 * triangles);
    for (std::size_t i = 0; i < triangles; ++i) {
        std::array<float, 12> numbers{};  // the normal comes first
        std::memcpy(numbers.data(), bytes.data() + kHeaderSize + kTriangleSize * i, sizeof numbers);
        for (int k = 3; k < 12; k += 3) {
            mesh.vertices.emplace_back(numbers[k], numbers[k + 1], numbers[k + 2]);
        }
    }
}

Vec3 parseAsciiVertex(
    const std::filesystem::path& file, std::size_t line, const std::vector<std::string_view>& words
) {
    Vec3 point;
    for (std::size_t k = 1; words.size() == 4 && k < 4; ++k) {
        const auto number = parseFloat(words[k]);
        if (!number) {
            break;
        }
        point[static_cast<int>(k) - 1] = static_cast<double>(*number);
        if (k == 3) {
            return point;
        }
    }
    refuseLine(file, line, "a vertex needs three coordinates");
}

void parseAscii(const std::filesystem::path& file, std::string_view bytes, TriangleMesh& mesh) {
    LineReader lines(withoutTrailingZeros(bytes));
    std::size_t facets = 0;
    bool ended = false;
    while (lines.next()) {
        const auto words = splitAtBlanks(lines.line());
        if (words.empty()) {
            continue;
        }
        const std::string keyword = lowerCase(words[0]);
        if (keyword == "facet") {
            ++facets;
            ended = false;
        } else if (keyword == "vertex") {
            mesh.vertices.push_back(parseAsciiVertex(file, lines.number(), words));
        }
        const bool isTwoWords = keyword == "end" && words.size() > 1;
        ended = ended || keyword == "endsolid" || (isTwoWords && lowerCase(words[1]) == "solid");
    }
    if (facets == 0 && !ended) {
        refuseFile(file, "is neither a binary STL file nor a text with facets");
    }
    if (!ended || mesh.vertices.size() != 3 * facets) {
        refuseFile(
            file,
            "is truncated or no STL file: " + std::to_string(facets) + " facets, " +
                std::to_string(mesh.vertices.size()) + " vertices" +
                (ended ? "" : ", no \"endsolid\" at the end")
        );
    }
}

}  // namespace

ParsedMesh parseStl(const std::filesystem::path& file, std::string_view bytes) {
    if (bytes.size() < kHeaderSize) {
        refuseFile(
            file, "is too short for an STL mesh (" + std::to_string(bytes.size()) + " bytes)"
        );
    }
    ParsedMesh parsed;
    TriangleMesh& mesh = parsed.mesh;
    isBinary(bytes) ? parseBinary(file, bytes, mesh) : parseAscii(file, bytes, mesh);
    for (int i = 0; i + 2 < static_cast<int>(mesh.vertices.size()); i += 3) {
        mesh.faces.push_back({i, i + 1, i + 2});
    }
    return parsed;
}

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/mesh_checksum.h"

#include <bit>
#include <cstddef>

namespace bspline_curve {

namespace {

constexpr std::uint32_t kPolynomial = 0xEDB88320U;
constexpr std::size_t kBytes = 256;
constexpr unsigned kByteBits = 8U;
constexpr std::uint32_t kByteMask = 0xFFU;

// Table k: the remainder of a byte that k further bytes follow, so that four bytes are taken at
// once.
using Tables = std::array<std::array<std::uint32_t, kBytes>, 4>;

constexpr Tables makeTables() {
    Tables tables{};
    for (std::uint32_t byte = 0; byte < kBytes; ++byte) {
        std::uint32_t remainder = byte;
        for (unsigned bit = 0; bit < kByteBits; ++bit) {
            remainder = (remainder >> 1U) ^ ((remainder & 1U) != 0 ? kPolynomial : 0U);
        }
        tables[0][byte] = remainder;
    }
    for (std::size_t k = 1; k < tables.size(); ++k) {
        for (std::size_t byte = 0; byte < kBytes; ++byte) {
            const std::uint32_t before = tables[k - 1][byte];
            tables[k][byte] = (before >> kByteBits) ^ tables[0][before & kByteMask];
        }
    }
    return tables;
}

constexpr Tables kTables = makeTables();

}  // namespace

std::string MeshChecksum::digits() const {
    constexpr unsigned kDigits = 8U;
    constexpr unsigned kBitsOfDigit = 4U;
    constexpr std::uint32_t kDigitMask = 0xFU;
    std::string text;
    for (unsigned k = kDigits; k-- > 0;) {
        text += "0123456789abcdef"[(crc32 >> (kBitsOfDigit * k)) & kDigitMask];
    }
    return text;
}

void MeshChecksumBuilder::add(std::uint32_t word) {
    // A word stands for its bytes, the lowest first, whatever the machine's order is.
    const std::uint32_t mixed = register_ ^ word;
    register_ = kTables[3][mixed & kByteMask] ^ kTables[2][(mixed >> kByteBits) & kByteMask] ^
                kTables[1][(mixed >> (2U * kByteBits)) & kByteMask] ^
                kTables[0][mixed >> (3U * kByteBits)];
}

void MeshChecksumBuilder::addVertex(const Vec3& position) {
    ++counts_.vertices;
    for (const double x : position) {
        const float rounded = static_cast<float>(x) + 0.0F;  // -0 + 0 is 0
        add(std::bit_cast<std::uint32_t>(rounded));
    }
}

void MeshChecksumBuilder::addFace(const Triangle& face) {
    ++counts_.faces;
    for (const int vertex : face) {
        add(static_cast<std::uint32_t>(vertex));
    }
}

MeshChecksum MeshChecksumBuilder::checksum() const {
    MeshChecksum result = counts_;
    result.crc32 = ~register_;
    return result;
}

MeshChecksum checksumOf(const TriangleMesh& mesh) {
    MeshChecksumBuilder builder;
    for (const Vec3& vertex : mesh.vertices) {
        builder.addVertex(vertex);
    }
    for (const Triangle& face : mesh.faces) {
        builder.addFace(face);
    }
    return builder.checksum();
}

std::string describeChange(const MeshChecksum& then, const MeshChecksum& now) {
    const auto difference = [](std::int64_t before, std::int64_t after, const char* what) {
        return "it had " + std::to_string(before) + " " + what + " then and has " +
               std::to_string(after) + " now";
    };
    if (then.faces != now.faces) {
        return difference(then.faces, now.faces, "faces");
    }
    if (then.vertices != now.vertices) {
        return difference(then.vertices, now.vertices, "vertices");
    }
    return "coordinates, faces or their order are others";
}

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/append_binary.h"
#include "io/shell_cells.h"

#include <cstdint>

namespace bspline_curve {

std::string plyBytes(const ShellCells& cells) {
    using Colour = std::array<std::uint8_t, 4>;
    // Bottom, middle, top; with opacity.
    constexpr std::array<Colour, 3> kColours = {
        {{66, 110, 180, 255}, {205, 205, 205, 255}, {200, 80, 60, 255}}
    };
    std::string bytes =
        "ply\nformat binary_little_endian 1.0\ncomment shell: top, middle and bottom; quality is "
        "f\nelement vertex " +
        std::to_string(cells.points.size()) +
        "\nproperty double x\nproperty double y\nproperty double z\nproperty double quality\n"
        "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha\n"
        "element face " +
        std::to_string(cells.layers.size()) +
        "\nproperty list uchar int vertex_indices\nend_header\n";
    for (std::size_t i = 0; i < cells.points.size(); ++i) {
        const int height = ShellCells::height(static_cast<int>(i));
        for (const double x : cells.points[i]) {
            appendBinary(bytes, x);
        }
        appendBinary(bytes, static_cast<double>(height));
        for (const std::uint8_t x : kColours[i % kColours.size()]) {
            appendBinary(bytes, x);
        }
    }
    for (const Triangle& layer : cells.layers) {
        appendBinary(bytes, std::uint8_t{3});
        for (const int point : layer) {
            appendBinary(bytes, static_cast<std::int32_t>(point));
        }
    }
    return bytes;
}

}  // namespace bspline_curve

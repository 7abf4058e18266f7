// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/shell_layers.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace bspline_curve {

ShellLayers makeShellLayers(const Shell& shell, const ShellFrame& frame) {
    ShellLayers layers;
    // The pillars that prisms stand on, numbered in order of first use.
    std::vector<int> numbers(shell.pillars().size(), -1);
    std::vector<int> used;
    for (const Prism& prism : shell.prisms()) {
        if (prism.orientation == 0) {
            continue;
        }
        Triangle face{};
        for (std::size_t slot = 0; slot < face.size(); ++slot) {
            int& number = numbers[prism.pillars[slot]];
            if (number < 0) {
                number = static_cast<int>(used.size());
                used.push_back(prism.pillars[slot]);
            }
            face[slot] = number;
        }
        if (prism.orientation < 0) {
            std::swap(face[1], face[2]);
        }
        layers.top.faces.push_back(face);
    }
    layers.bottom.faces = layers.top.faces;
    for (const int pillar : used) {
        const Pillar& points = shell.pillars()[pillar];
        layers.top.vertices.push_back(frame.toUser(points.top));
        layers.bottom.vertices.push_back(frame.toUser(points.bottom));
    }
    return layers;
}

}  // namespace bspline_curve

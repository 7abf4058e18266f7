// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/shell_layers.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace bspline_curve {

namespace {

/// Numbers the pillars that prisms stand on, in order of first use.
class PillarNumbers {
public:
    explicit PillarNumbers(std::size_t pillarCount) : numbers_(pillarCount, -1) {}

    int numberOf(int pillar) {
        int& number = numbers_[pillar];
        if (number < 0) {
            number = static_cast<int>(used_.size());
            used_.push_back(pillar);
        }
        return number;
    }

    [[nodiscard]] const std::vector<int>& used() const { return used_; }

private:
    std::vector<int> numbers_, used_;
};

}  // namespace

ShellLayers makeShellLayers(const Shell& shell, const ShellFrame& frame) {
    ShellLayers layers;
    PillarNumbers numbers(shell.pillars().size());
    for (const Prism& prism : shell.prisms()) {
        if (prism.orientation == 0) {
            continue;
        }
        Triangle face{};
        for (std::size_t slot = 0; slot < face.size(); ++slot) {
            face[slot] = numbers.numberOf(prism.pillars[slot]);
        }
        if (prism.orientation < 0) {
            std::swap(face[1], face[2]);
        }
        layers.top.faces.push_back(face);
    }
    layers.bottom.faces = layers.top.faces;
    for (const int pillar : numbers.used()) {
        const Pillar& points = shell.pillars()[pillar];
        layers.top.vertices.push_back(frame.toUser(points.top));
        layers.bottom.vertices.push_back(frame.toUser(points.bottom));
    }
    return layers;
}

}  // namespace bspline_curve

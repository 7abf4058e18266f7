// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/simplify/export_shell.h"

#include <algorithm>
#include <compare>

namespace bspline_curve {
namespace {

// A wall of a prism by its pillars.
struct Wall {
    int low, high;
    int prism, slot;

    auto operator<=>(const Wall&) const = default;
};

void connect(std::vector<Prism>& prisms) {
    std::vector<Wall> walls;
    walls.reserve(3 * prisms.size());
    for (std::size_t i = 0; i < prisms.size(); ++i) {
        prisms[i].neighbours = {-1, -1, -1};
        for (std::size_t slot = 0; slot < 3; ++slot) {
            walls.push_back(
                {prisms[i].pillars[slot == 0 ? 1 : 0],
                 prisms[i].pillars[slot == 2 ? 1 : 2],
                 static_cast<int>(i),
                 static_cast<int>(slot)}
            );
        }
    }
    std::ranges::sort(walls);
    for (std::size_t i = 0; i + 1 < walls.size(); ++i) {
        const Wall& here = walls[i];
        const Wall& there = walls[i + 1];
        if (here.low == there.low && here.high == there.high) {
            prisms[here.prism].neighbours[here.slot] = there.prism;
            prisms[here.prism].neighbourWalls[here.slot] = static_cast<signed char>(there.slot);
            prisms[there.prism].neighbours[there.slot] = here.prism;
            prisms[there.prism].neighbourWalls[there.slot] = static_cast<signed char>(here.slot);
        }
    }
}

}  // namespace

Shell exportShell(
    const ShellEditor& editor, const std::shared_ptr<const ExtendedSurface>& extended
) {
    const PrismComplex& complex = editor.complex();
    std::vector<int> numbers(editor.pillarCount(), -1);
    std::vector<Pillar> pillars;
    for (int v = 0; v < editor.pillarCount(); ++v) {
        if (complex.hasPrisms(v)) {
            numbers[v] = static_cast<int>(pillars.size());
            pillars.push_back(editor.pillarAt(v));
        }
    }
    std::vector<Prism> prisms;
    SurfaceTracks tracks;
    tracks.offsets.push_back(0);
    for (int id = 0; id < complex.prismIdCount(); ++id) {
        if (!complex.isAlive(id)) {
            continue;
        }
        const Triangle& corners = complex.pillarsOf(id);
        const Triangle slots = slotsOf(corners);
        Prism prism;
        prism.orientation = static_cast<signed char>(orientationOf(corners));
        for (std::size_t slot = 0; slot < 3; ++slot) {
            prism.pillars[slot] = numbers[slots[slot]];
        }
        prisms.push_back(prism);
        const auto start = static_cast<std::ptrdiff_t>(tracks.faces.size());
        for (const int face : complex.facesOf(id)) {
            tracks.faces.push_back(editor.surface().originalFaces[face]);
        }
        std::sort(tracks.faces.begin() + start, tracks.faces.end());
        tracks.offsets.push_back(static_cast<int>(tracks.faces.size()));
    }
    connect(prisms);
    return {std::move(pillars), std::move(prisms), std::move(tracks), extended};
}

}  // namespace bspline_curve

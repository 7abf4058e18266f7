// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/progress.h"
#include "shell/simplify/shell_editor.h"

#include <compare>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace bspline_curve {

/// The crease edges of the middle surface while it is being simplified: collapses move them.
class Creases {
public:
    /// Edges, low pillar first, ascending.
    Creases(std::vector<std::pair<int, int>> edges, int pillarCount);

    [[nodiscard]] bool holdEdge(int a, int b) const;

    /// Number of crease edges at a pillar.
    [[nodiscard]] int degree(int pillar) const { return degrees_[pillar]; }

    /// Pillar `removed`, which has two crease edges, goes into `kept` along one of them.
    void collapse(int removed, int kept);

private:
    std::vector<std::pair<int, int>> edges_;
    std::vector<int> degrees_;
};

/// Makes pillars longer, up to `reach` on either side of the middle, turning them where that helps.
class Thickener {
public:
    explicit Thickener(ShellEditor& editor) : editor_(editor), failed_(editor.pillarCount(), -1) {}

    void run(double reach);

private:
    void thicken(int pillar, double reach);
    void lengthen(int pillar, Level level, double reach);
    [[nodiscard]] Vec3 directionAround(int pillar) const;

    ShellEditor& editor_;
    std::vector<int> failed_;  // editor's time when nothing helped
};

/// Collapses edges shorter than a length, shortest first, by half-edge collapses.
class Collapser {
public:
    Collapser(ShellEditor& editor, Creases& creases) : editor_(editor), creases_(creases) {}

    /// Throws Cancelled where the callback asks for it.
    void run(double length, const Progress& progress);

private:
    struct Edge {
        double length;
        int a, b;

        // Shorter ones first; ties by pillar.
        auto operator<=>(const Edge&) const = default;
    };

    void push(const Edge& edge);
    [[nodiscard]] Edge pop();
    void dropStale();
    void pushAll(double length);
    void pushAround(int pillar, double length);
    [[nodiscard]] bool exists(const Edge& edge);
    bool collapseEither(const Edge& edge, double length);
    bool collapse(int removed, int kept);
    [[nodiscard]] bool propose(int removed, int kept);
    [[nodiscard]] bool keepsTopology(int removed, int kept);
    [[nodiscard]] bool turnAndReplace(int removed, int kept);

    ShellEditor& editor_;
    Creases& creases_;
    std::vector<Edge> queue_;     // a heap, the shortest edge on top
    std::size_t queueLimit_ = 0;  // beyond it many entries are of edges that are no more
    std::unordered_map<std::uint64_t, int> failed_;  // editor's time when an edge was tried in vain
    std::vector<int> around_, ring_, near_;
};

/// Flips edges where that makes the worse of the two middle triangles better.
void flipEdges(ShellEditor& editor, const Creases& creases);

/// Moves pillars along the surface to where the prisms around them are better shaped.
class SampledSolver {
public:
    SampledSolver(ShellEditor& editor, const Creases& creases)
        : editor_(editor), creases_(creases), failed_(editor.pillarCount(), -1) {}

    void run();

private:
    void solveSampled(int pillar);

    ShellEditor& editor_;
    const Creases& creases_;
    std::vector<int> failed_;  // editor's time of the last attempt
};

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/progress.h"
#include "shell/simplify/creases.h"
#include "shell/simplify/shell_editor.h"

#include <compare>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace bspline_curve {

struct SimplifierConstants {
    // ---- Stages ----
    double startThickness = 0.5;  ///< half pillars of the first shell, in mean edges: all fit
    double firstStage = 1.6;      ///< target edge length of the first stage, in mean edges
    double stageFactor = 1.5;     ///< from stage to stage: each removes about half of the prisms
    double thicknessShare = 0.5;  ///< half pillars by the target edge length: prisms not too tall
    double leastProgress = 0.01;  ///< share of the prisms that a stage removes, or it is the last
    int maxStages = 60;           ///< 1.5^60 mean edges are longer than any surface
    double cellSize = 2.0;        ///< of the grid, in target edges: few cells for each prism
    // ---- Operations ----
    double lengthGain = 1.1;      ///< factor by which pillars have to grow
    double shorterStep = 0.4;     ///< share of a step in length that is tried where it fails
    double flipGain = 1.1;        ///< factor by which a flip has to make the worse triangle better
    double goodQuality = 0.9;     ///< stars whose worst triangle is this good stay
    double moveGain = 1.02;       ///< factor by which a move has to make the worst triangle better
    double leastQuality = 0.1;    ///< below, collapses do not make triangles worse
    std::size_t maxValence = 12;  ///< of a pillar after a collapse: larger stars hardly ever change
};

inline constexpr SimplifierConstants kSimplifier;

/// Makes pillars longer, up to a length on either side of the middle, turning them where that
/// helps.
class Thickener {
public:
    explicit Thickener(ShellEditor& editor) : editor_(editor), failed_(editor.pillarCount(), -1) {}

    void run(double length);

private:
    void thicken(int pillar, double length);
    void lengthen(int pillar, Vec3 Pillar::* tip, double length);
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

    void push(int a, int b, double length);
    [[nodiscard]] Edge pop();
    void dropStale();
    void pushAll(double length);
    void pushAround(int pillar, double length);
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
class PillarSmoother {
public:
    PillarSmoother(ShellEditor& editor, const Creases& creases)
        : editor_(editor), creases_(creases), failed_(editor.pillarCount(), -1) {}

    void run();

private:
    void move(int pillar);

    ShellEditor& editor_;
    const Creases& creases_;
    std::vector<int> failed_;  // editor's time of the last attempt
};

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/shell_report.h"

#include "io/json_text.h"
#include "io/repair_json.h"
#include "io/shell_cells.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace bspline_curve {

namespace {

/// The share-th quantile of ascending values, linear between the two nearest.
double quantile(const std::vector<double>& ascending, double share) {
    const double place = share * static_cast<double>(ascending.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, ascending.size() - 1);
    return std::lerp(ascending[below], ascending[above], place - static_cast<double>(below));
}

struct PrismCounts {
    int all = 0, ghosts = 0, pillars = 0;
};

PrismCounts countPrisms(const Shell& shell) {
    PrismCounts counts;
    std::vector<char> isUsed(shell.pillars().size(), 0);
    for (int i = 0; i < static_cast<int>(shell.prisms().size()); ++i) {
        const Prism& prism = shell.prisms()[i];
        if (prism.orientation != 0) {
            ++counts.all;
            counts.ghosts += isGhostPrism(shell, i) ? 1 : 0;
            for (const int pillar : prism.pillars) {
                isUsed[pillar] = 1;
            }
        }
    }
    counts.pillars = static_cast<int>(std::ranges::count(isUsed, 1));
    return counts;
}

Json meshOfShell(const Surface& surface, const std::string& file) {
    std::ptrdiff_t boundaryEdges = 0;
    for (const Triangle& neighbours : surface.faceNeighbours()) {
        boundaryEdges += std::ranges::count(neighbours, -1);
    }
    return {
        {"file", file},
        {"vertices", surface.vertexCount()},
        {"faces", surface.faceCount()},
        {"components", surface.componentCount()},
        {"boundary_edges", boundaryEdges},
        {"diagonal", surface.diagonal()},
        {"longest_side", longestSideOf(surface)},
        {"average_edge_length", surface.averageEdgeLength()},
    };
}

Json shellSeconds(const ShellRunFigures& figures) {
    const auto& seconds = figures.seconds;
    return {
        {"cpu", seconds.cpu},
        {"wall", seconds.wall},
        {"read", seconds.read},
        {"validate", seconds.validate},
        {"base", seconds.extended},
        {"shell", seconds.shell},
        {"check", seconds.check},
        {"write", seconds.write},
    };
}

Json checkOf(const ShellCheck* check) {
    if (check == nullptr) {
        return nullptr;
    }
    Json result;
    for (const InvariantCheck* const invariant : check->invariants()) {
        result[std::string(invariant->name)] = {
            {"holds", invariant->holds},
            {"violations", invariant->violations},
            {"first_ids", invariant->firstIds},
        };
    }
    return result;
}

}  // namespace

ShellThickness measureThickness(
    const Surface& surface, const ShellFrame& frame, const Shell& shell
) {
    std::vector<char> isMeasured(shell.pillars().size(), 0);
    for (int i = 0; i < static_cast<int>(shell.prisms().size()); ++i) {
        const Prism& prism = shell.prisms()[i];
        if (prism.orientation != 0 && !isGhostPrism(shell, i)) {
            for (const int pillar : prism.pillars) {
                isMeasured[pillar] = 1;
            }
        }
    }
    const double unit = longestSideOf(surface) / frame.scale;
    std::vector<double> lengths;
    for (std::size_t i = 0; i < isMeasured.size(); ++i) {
        if (isMeasured[i] != 0) {
            const Pillar& pillar = shell.pillars()[i];
            const double length =
                (pillar.top - pillar.middle).norm() + (pillar.middle - pillar.bottom).norm();
            lengths.push_back(length / unit);
        }
    }
    if (lengths.empty()) {
        return {};
    }
    std::ranges::sort(lengths);
    constexpr double kLowShare = 0.05;
    return {
        .mean = std::accumulate(lengths.begin(), lengths.end(), 0.0) /
                static_cast<double>(lengths.size()),
        .p5 = quantile(lengths, kLowShare),
        .min = lengths.front()
    };
}

std::string shellReportText(const ReportedShell& reported, const ShellRunFigures& figures) {
    const auto& [surface, extended, build, check] = reported;
    const PrismCounts counts = countPrisms(build.shell);
    const ShellThickness thickness = measureThickness(surface, extended.frame, build.shell);
    const Json document = {
        {"shell", name(build.shell.kind())},
        {"prisms", counts.all},
        {"ghost_prisms", counts.ghosts},
        {"pillars", counts.pillars},
        {"faces", figures.faces},
        {"blocked_faces", build.report.blockedFaces.size()},
        {"moved_vertices", extended.movedVertices.size()},
        {"thickness", {{"mean", thickness.mean}, {"p5", thickness.p5}, {"min", thickness.min}}},
        {"seconds", shellSeconds(figures)},
        {"peak_memory_bytes", figures.peakMemoryBytes},
        {"check", checkOf(check)},
        {"notes", figures.notes},
        {"repair", repairJson(figures.repair)},
        {"mesh", meshOfShell(surface, figures.meshFile)},
    };
    // A file name may hold bytes that are not UTF-8; they become replacement characters.
    return jsonText(document);
}

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#include "fill/capped_handles.h"

#include "utility/index_sets.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace bspline_curve {

namespace {

using Edges = std::vector<std::array<int, 2>>;

/// Rims of a mesh that was cut along edges, each with the edges that it is made of.
struct CutRim {
    std::vector<int> vertices;  // of the cut mesh
    Edges edges;                // of the mesh before, ascending
};

/// Those that are made of such edges alone, each of them once.
std::vector<CutRim> rimsAlong(const CutMesh& cut, const Edges& edges) {
    std::vector<CutRim> found;
    for (std::vector<int>& rim : rimsOf(cut.mesh.faces)) {
        Edges own;
        for (std::size_t i = 0; i < rim.size(); ++i) {
            const auto [low, high] =
                std::minmax(cut.source[rim[i]], cut.source[rim[(i + 1) % rim.size()]]);
            own.push_back({low, high});
        }
        sortUnique(own);
        if (own.size() == rim.size() && std::ranges::includes(edges, own)) {
            found.push_back({std::move(rim), std::move(own)});
        }
    }
    return found;
}

/// Those with the same edges.
std::vector<std::pair<CutRim, CutRim>> pairsOf(std::vector<CutRim> rims) {
    std::vector<std::pair<CutRim, CutRim>> pairs;
    std::map<Edges, CutRim> single;
    for (CutRim& rim : rims) {
        const auto other = single.find(rim.edges);
        if (other != single.end()) {
            pairs.emplace_back(std::move(other->second), std::move(rim));
            single.erase(other);
        } else {
            Edges key = rim.edges;
            single.emplace(std::move(key), std::move(rim));
        }
    }
    return pairs;
}

/// Adds a patch, whose points are those of a rim on one side of a cut.
void append(
    FilledParts& result,
    const std::vector<Triangle>& faces,
    const std::vector<Vec3>& points,
    int firstPoint,
    const CutRim& rim,
    const CutMesh& cut,
    bool isTurned
) {
    std::map<int, int> onRim;
    for (const int vertex : rim.vertices) {
        onRim[cut.source[vertex]] = vertex;
    }
    const auto firstNew = static_cast<int>(result.mesh.vertices.size());
    result.rims.push_back(rim.vertices);
    result.firstNew.push_back(firstNew);
    result.firstFace.push_back(static_cast<int>(result.mesh.faces.size()));
    result.mesh.vertices.insert(result.mesh.vertices.end(), points.begin(), points.end());
    for (Triangle face : faces) {
        for (int& corner : face) {
            corner = corner < firstPoint ? onRim.at(corner) : firstNew + corner - firstPoint;
        }
        if (isTurned) {
            std::swap(face[1], face[2]);
        }
        result.mesh.faces.push_back(face);
    }
}

}  // namespace

std::optional<FilledParts> cappedHandles(
    const ImprintedMesh& imprinted, const MeshParts& parts, const Progress& progress
) {
    // Slits pass their edges twice, and are left out.
    Edges edges;
    for (const CutRim& rim : rimsAlong(cutAlongCurves(imprinted), curveEdges(imprinted))) {
        edges.insert(edges.end(), rim.edges.begin(), rim.edges.end());
    }
    sortUnique(edges);
    const CutMesh cut = cutAlongEdges(imprinted.mesh, edges);
    const std::vector<std::pair<CutRim, CutRim>> pairs = pairsOf(rimsAlong(cut, edges));
    if (pairs.empty()) {
        return std::nullopt;
    }
    // Patches share the rim's vertices with both of its sides, so that they do not cross these.
    std::vector<std::vector<int>> rims;
    for (const auto& [one, other] : pairs) {
        std::vector<int>& rim = rims.emplace_back();
        for (const int vertex : one.vertices) {
            rim.push_back(cut.source[vertex]);
        }
    }
    const FilledMesh filled = fillHoles(imprinted.mesh, rims, FillShape::Flat, {}, progress);
    FilledParts result;
    result.mesh = cut.mesh;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const bool isLast = i + 1 == pairs.size();
        const auto endOf = [&](const std::vector<int>& firsts, std::size_t end) {
            return isLast ? static_cast<int>(end) : firsts[i + 1];
        };
        const auto faces = filled.mesh.faces.begin();
        const auto points = filled.mesh.vertices.begin();
        const std::vector<Triangle> patch(
            faces + filled.firstFace[i], faces + endOf(filled.firstFace, filled.mesh.faces.size())
        );
        const std::vector<Vec3> added(
            points + filled.firstNew[i],
            points + endOf(filled.firstNew, filled.mesh.vertices.size())
        );
        for (const int face : filled.crossing) {
            const int own = face - filled.firstFace[i];
            if (own >= 0 && own < std::ssize(patch)) {
                result.crossing.push_back(static_cast<int>(result.mesh.faces.size()) + own);
            }
        }
        append(result, patch, added, filled.firstNew[i], pairs[i].first, cut, false);
        append(result, patch, added, filled.firstNew[i], pairs[i].second, cut, true);
    }
    result.endOfNew = static_cast<int>(result.mesh.vertices.size());
    result.source = cut.source;
    result.source.resize(result.mesh.vertices.size(), -1);
    for (std::size_t f = 0; f < cut.mesh.faces.size(); ++f) {
        result.faces.push_back(static_cast<int>(f));
    }
    result.faces.resize(result.mesh.faces.size(), -1);
    result.labels = parts.labels;
    result.labels.resize(result.mesh.faces.size(), -1);
    return result;
}

}  // namespace bspline_curve

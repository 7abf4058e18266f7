// SPDX-License-Identifier: GPL-3.0-or-later
#include "fill/capped_parts.h"

#include "bspline_curve/progress.h"
#include "utility/index_sets.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace bspline_curve {

namespace {

// Of the progress, until the patches are there.
constexpr double kPatchedShare = 0.8;

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

/// For each rim the part that it is a rim of.
std::vector<int> partsOfRims(
    const std::vector<std::vector<int>>& rims, const CutMesh& cut, const MeshParts& parts
) {
    // An edge of a rim has one face.
    std::map<std::array<int, 2>, std::size_t> rimOf;
    for (std::size_t i = 0; i < rims.size(); ++i) {
        const std::vector<int>& rim = rims[i];
        const auto [low, high] = std::minmax(rim[0], rim[1]);
        rimOf[{low, high}] = i;
    }
    std::vector<int> partOf(rims.size(), -1);
    for (std::size_t f = 0; f < cut.mesh.faces.size(); ++f) {
        const Triangle& face = cut.mesh.faces[f];
        for (int k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax(face[k], face[(k + 1) % 3]);
            const auto found = rimOf.find({low, high});
            if (found != rimOf.end()) {
                partOf[found->second] = parts.labels[f];
            }
        }
    }
    return partOf;
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

/// Adds the patch of each pair of rims to both of them.
void addPatches(
    FilledParts& result,
    const FilledMesh& filled,
    const std::vector<std::pair<CutRim, CutRim>>& pairs,
    const CutMesh& cut
) {
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
        for (const bool isSecond : {false, true}) {
            for (const int face : filled.crossing) {
                const int own = face - filled.firstFace[i];
                if (own >= 0 && own < std::ssize(patch)) {
                    result.crossing.push_back(static_cast<int>(result.mesh.faces.size()) + own);
                }
            }
            const CutRim& rim = isSecond ? pairs[i].second : pairs[i].first;
            append(result, patch, added, filled.firstNew[i], rim, cut, isSecond);
        }
    }
}

}  // namespace

std::optional<CappedParts> cappedOnBothSides(
    const ImprintedMesh& imprinted, const MeshParts& parts, const Progress& progress
) {
    const auto goOn = [&] { report(progress, 0.0, "opening the mesh"); };
    goOn();
    // Slits pass their edges twice, and are left out.
    Edges edges;
    for (const CutRim& rim : rimsAlong(cutAlongCurves(imprinted), curveEdges(imprinted))) {
        edges.insert(edges.end(), rim.edges.begin(), rim.edges.end());
    }
    sortUnique(edges);
    goOn();
    const CutMesh cut = cutAlongEdges(imprinted.mesh, edges);
    goOn();
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
    const FilledMesh filled =
        fillHoles(imprinted.mesh, rims, FillShape::Flat, {}, partOf(progress, 0.0, kPatchedShare));
    report(progress, kPatchedShare, "joining the patches to the mesh");
    CappedParts capped;
    for (const auto& [one, other] : pairs) {
        capped.edges.insert(capped.edges.end(), one.edges.begin(), one.edges.end());
    }
    sortUnique(capped.edges);
    FilledParts& result = capped.whole;
    result.mesh = cut.mesh;
    addPatches(result, filled, pairs, cut);
    result.endOfNew = static_cast<int>(result.mesh.vertices.size());
    result.source = cut.source;
    result.source.resize(result.mesh.vertices.size(), -1);
    for (std::size_t f = 0; f < cut.mesh.faces.size(); ++f) {
        result.faces.push_back(static_cast<int>(f));
    }
    result.faces.resize(result.mesh.faces.size(), -1);
    result.labels = parts.labels;
    result.labels.resize(result.mesh.faces.size(), -1);
    capped.partOf = partsOfRims(result.rims, cut, parts);
    return capped;
}

FilledParts cappedParts(const CappedParts& capped, const std::vector<int>& chosen) {
    const FilledParts& whole = capped.whole;
    std::vector<int> owners = whole.labels;
    for (std::size_t i = 0; i < whole.rims.size(); ++i) {
        const auto first = owners.begin() + whole.firstFace[i];
        const auto end =
            i + 1 < whole.rims.size() ? owners.begin() + whole.firstFace[i + 1] : owners.end();
        std::fill(first, end, capped.partOf[i]);
    }
    SubMesh part = facesWithLabels(whole.mesh, owners, chosen);
    // Ids of the whole are in order in the part as well.
    const auto placeIn = [](const std::vector<int>& ids, int id) {
        return static_cast<int>(std::ranges::lower_bound(ids, id) - ids.begin());
    };
    FilledParts taken;
    for (std::size_t i = 0; i < whole.rims.size(); ++i) {
        if (!std::ranges::binary_search(chosen, capped.partOf[i])) {
            continue;
        }
        std::vector<int>& rim = taken.rims.emplace_back();
        for (const int vertex : whole.rims[i]) {
            rim.push_back(placeIn(part.vertices, vertex));
        }
        taken.firstNew.push_back(placeIn(part.vertices, whole.firstNew[i]));
        taken.firstFace.push_back(placeIn(part.faces, whole.firstFace[i]));
    }
    for (const int vertex : part.vertices) {
        taken.source.push_back(whole.source[vertex]);
    }
    for (const int face : part.faces) {
        taken.faces.push_back(whole.faces[face]);
        taken.labels.push_back(whole.labels[face]);
    }
    for (const int face : whole.crossing) {
        const int own = indexIn(part.faces, face);
        if (own >= 0) {
            taken.crossing.push_back(own);
        }
    }
    taken.endOfNew = static_cast<int>(part.vertices.size());
    taken.mesh = std::move(part.mesh);
    return taken;
}

}  // namespace bspline_curve

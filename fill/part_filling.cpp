// SPDX-License-Identifier: GPL-3.0-or-later
#include "fill/part_filling.h"

#include "bspline_curve/error.h"
#include "fill/harmonic_values.h"
#include "utility/index_sets.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <utility>

namespace bspline_curve {

std::vector<double> FilledParts::carried(std::span<const double> imprintedValues) const {
    std::vector<double> values;
    for (const int vertex : source) {
        values.push_back(vertex < 0 ? 0.0 : imprintedValues[vertex]);
    }
    for (std::size_t hole = 0; hole < rims.size(); ++hole) {
        const bool isLast = hole + 1 == rims.size();
        const int first = firstNew[hole];
        const int endOfHole = isLast ? endOfNew : firstNew[hole + 1];
        const auto endOfFaces = isLast ? static_cast<int>(mesh.faces.size()) : firstFace[hole + 1];
        std::vector<Triangle> patch(
            mesh.faces.begin() + firstFace[hole], mesh.faces.begin() + endOfFaces
        );
        std::vector<int> onRim;
        for (const Triangle& face : patch) {
            std::ranges::copy_if(face, std::back_inserter(onRim), [&](int v) {
                return v < first || v >= endOfHole;
            });
        }
        sortUnique(onRim);
        const auto rimCount = static_cast<int>(onRim.size());
        for (Triangle& face : patch) {
            for (int& corner : face) {
                const bool isNew = corner >= first && corner < endOfHole;
                corner = isNew ? rimCount + corner - first : indexIn(onRim, corner);
            }
        }
        std::vector<Vec3> points;
        ValueRows rimValues(rimCount, 1);
        for (const int vertex : onRim) {
            rimValues(std::ssize(points), 0) = values[vertex];
            points.push_back(mesh.vertices[vertex]);
        }
        points.insert(
            points.end(), mesh.vertices.begin() + first, mesh.vertices.begin() + endOfHole
        );
        const ValueRows carried = harmonicFrom(points, patch, rimValues);
        for (int v = first; v < endOfHole; ++v) {
            values[v] = carried(rimCount + v - first, 0);
        }
    }
    return values;
}

namespace {

// Of the progress of a fill: what opens the mesh, and all until its patches are there.
constexpr double kOpenedShare = 0.1;
constexpr double kFilledShare = 0.9;

/// A closed walk as loops that pass no vertex twice.
std::vector<std::vector<int>> simpleLoops(const std::vector<int>& walk) {
    std::vector<std::vector<int>> loops;
    std::vector<int> open;
    for (const int vertex : walk) {
        const auto before = std::ranges::find(open, vertex);
        if (before != open.end()) {
            loops.emplace_back(before, open.end());
            open.erase(before, open.end());
        }
        open.push_back(vertex);
    }
    loops.push_back(std::move(open));
    return loops;
}

/// The kept vertices of which a cut made copies, ascending.
std::vector<int> doubledIn(const CutMesh& cut, std::size_t uncutCount, const SubMesh& kept) {
    std::vector<int> doubled;
    for (std::size_t v = uncutCount; v < cut.source.size(); ++v) {
        const int vertex = indexIn(kept.vertices, cut.source[v]);
        if (vertex >= 0) {
            doubled.push_back(vertex);
        }
    }
    sortUnique(doubled);
    return doubled;
}

/// For each kept vertex the mean length of the sides of the faces around it, before curves divided
/// them.
std::vector<double> sizesAt(const ImprintedMesh& imprinted, const SubMesh& kept) {
    const TriangleMesh whole = withoutImprint(imprinted);
    std::size_t next = 0;
    std::vector<double> perFace(imprinted.mesh.faces.size());
    for (std::size_t f = 0; f < perFace.size(); ++f) {
        next += f > 0 && imprinted.ownParents[f] != imprinted.ownParents[f - 1] ? 1 : 0;
        const auto& [a, b, c] = whole.faces[next];
        const std::vector<Vec3>& points = whole.vertices;
        perFace[f] = ((points[a] - points[b]).norm() + (points[b] - points[c]).norm() +
                      (points[c] - points[a]).norm()) /
                     3.0;
    }
    std::vector<double> sums(kept.vertices.size(), 0.0);
    std::vector<int> counts(kept.vertices.size(), 0);
    for (std::size_t f = 0; f < kept.faces.size(); ++f) {
        for (const int corner : kept.mesh.faces[f]) {
            sums[corner] += perFace[kept.faces[f]];
            ++counts[corner];
        }
    }
    for (std::size_t v = 0; v < sums.size(); ++v) {
        sums[v] /= counts[v];
    }
    return sums;
}

/// Faces of no chosen part, with the vertices of the imprint.
TriangleMesh removedFrom(
    const ImprintedMesh& imprinted, const MeshParts& parts, const std::vector<int>& chosen
) {
    TriangleMesh removed{.vertices = imprinted.mesh.vertices, .faces = {}};
    for (std::size_t f = 0; f < parts.labels.size(); ++f) {
        if (!std::ranges::binary_search(chosen, parts.labels[f])) {
            removed.faces.push_back(imprinted.mesh.faces[f]);
        }
    }
    return removed;
}

/// Rims of the opened parts that are made of edges of curves alone, as loops of kept vertices;
/// counts those of which such edges are a part.
void findRims(
    const std::vector<std::array<int, 2>>& edges,
    const CutMesh& cut,
    const SubMesh& kept,
    FilledParts& result
) {
    std::vector<Triangle> opened;
    for (const int face : kept.faces) {
        opened.push_back(cut.mesh.faces[face]);
    }
    for (const std::vector<int>& rim : rimsOf(opened)) {
        std::size_t around = 0;
        std::vector<int> walk;
        for (std::size_t i = 0; i < rim.size(); ++i) {
            const int from = cut.source[rim[i]];
            const int to = cut.source[rim[(i + 1) % rim.size()]];
            const auto [low, high] = std::minmax(from, to);
            around += std::ranges::binary_search(edges, std::array{low, high}) ? 1 : 0;
            walk.push_back(indexIn(kept.vertices, from));
        }
        if (around == rim.size()) {
            for (std::vector<int>& loop : simpleLoops(walk)) {
                result.rims.push_back(std::move(loop));
            }
        } else if (around > 0) {
            ++result.openRims;
        }
    }
}

}  // namespace

void refuseNothingToFill() {
    throw InputError(
        InputErrorCode::NoPath,
        "there is no hole to fill: the boundary of the mesh is part of each rim that is cut; cut "
        "along closed curves, or fill nothing"
    );
}

FilledParts fillAround(
    const ImprintedMesh& imprinted,
    const MeshParts& parts,
    const std::vector<int>& chosen,
    FillShape shape,
    const Progress& progress
) {
    FilledParts filled = filledWherePossible(imprinted, parts, chosen, shape, progress);
    if (filled.rims.empty()) {
        refuseNothingToFill();
    }
    return filled;
}

FilledParts filledWherePossible(
    const ImprintedMesh& imprinted,
    const MeshParts& parts,
    const std::vector<int>& chosen,
    FillShape shape,
    const Progress& progress
) {
    const auto goOn = [&](double fraction) { report(progress, fraction, "opening the mesh"); };
    goOn(0.0);
    const std::vector<std::array<int, 2>> edges = edgesAround(imprinted, parts, chosen);
    // Rims are walked round the chosen faces. Where they meet themselves in a vertex, each loop is
    // a hole of its own, and the vertex is one again when all are filled.
    const CutMesh cut = cutAlongEdges(imprinted.mesh, edges);
    goOn(0.25 * kOpenedShare);
    const SubMesh kept = facesWithLabels(imprinted.mesh, parts.labels, chosen);
    goOn(0.5 * kOpenedShare);
    FilledParts result;
    findRims(edges, cut, kept, result);
    goOn(0.75 * kOpenedShare);
    if (result.rims.empty()) {
        FilledParts open = openParts(cut, parts, chosen);
        open.openRims = result.openRims;
        return open;
    }
    const FillSurroundings surroundings{
        .sizes = sizesAt(imprinted, kept), .removed = [&](std::size_t rim, std::size_t most) {
            std::vector<int> vertices;
            for (const int vertex : result.rims[rim]) {
                vertices.push_back(kept.vertices[vertex]);
            }
            return sheetBeside(removedFrom(imprinted, parts, chosen), vertices, false, most);
        }
    };
    FilledMesh filled = fillHoles(
        kept.mesh, result.rims, shape, surroundings, partOf(progress, kOpenedShare, kFilledShare)
    );
    const auto close = [&](double fraction) {
        report(progress, fraction, "joining the patches to the mesh");
    };
    close(kFilledShare);
    result.firstFace = std::move(filled.firstFace);
    result.crossing = std::move(filled.crossing);
    result.firstNew = std::move(filled.firstNew);
    result.endOfNew = static_cast<int>(filled.mesh.vertices.size());
    CutMesh parted = partFans(filled.mesh, doubledIn(cut, imprinted.mesh.vertices.size(), kept));
    close(0.5 * (kFilledShare + 1.0));
    result.mesh = std::move(parted.mesh);
    for (const int vertex : parted.source) {
        const bool isNew = vertex >= static_cast<int>(kept.vertices.size());
        result.source.push_back(isNew ? -1 : kept.vertices[vertex]);
    }
    for (const int face : kept.faces) {
        result.labels.push_back(parts.labels[face]);
    }
    result.faces = kept.faces;
    result.faces.resize(result.mesh.faces.size(), -1);
    result.labels.resize(result.mesh.faces.size(), -1);
    close(1.0);
    return result;
}

FilledParts wholeImprint(const ImprintedMesh& imprinted, const MeshParts& parts) {
    FilledParts whole;
    whole.mesh = imprinted.mesh;
    whole.source.resize(whole.mesh.vertices.size());
    std::iota(whole.source.begin(), whole.source.end(), 0);
    whole.faces.resize(whole.mesh.faces.size());
    std::iota(whole.faces.begin(), whole.faces.end(), 0);
    whole.labels = parts.labels;
    return whole;
}

FilledParts openParts(const CutMesh& cut, const MeshParts& parts, const std::vector<int>& chosen) {
    SubMesh part = facesWithLabels(cut.mesh, parts.labels, chosen);
    FilledParts taken;
    taken.mesh = std::move(part.mesh);
    for (const int vertex : part.vertices) {
        taken.source.push_back(cut.source[vertex]);
    }
    for (const int face : part.faces) {
        taken.labels.push_back(parts.labels[face]);
    }
    taken.faces = std::move(part.faces);
    return taken;
}

FilledParts takenParts(
    const ImprintedMesh& imprinted,
    const CutMesh& cut,
    const MeshParts& parts,
    const std::vector<int>& chosen,
    const std::optional<FillShape>& fill,
    const Progress& progress
) {
    return fill ? fillAround(imprinted, parts, chosen, *fill, progress)
                : openParts(cut, parts, chosen);
}

}  // namespace bspline_curve

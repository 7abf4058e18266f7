// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/rejoining.h"

#include "surface/mesh_checks.h"
#include "surface/repair_steps.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <span>
#include <tuple>
#include <utility>

namespace bspline_curve {

namespace {

/// Divides sides of faces, and knows which face each side has then. Sides of parts have numbers of
/// their own.
class SideDivider {
public:
    /// Must outlive this.
    explicit SideDivider(MeshRepair& repair)
        : repair_(repair), nextSide_(sideOf(static_cast<int>(repair.mesh.faces.size()), 0)) {}

    [[nodiscard]] int faceOf(int side) const {
        const auto found = faceOf_.find(side);
        return found == faceOf_.end() ? side / 3 : found->second;
    }

    /// The parts of some sides of one edge, each in order of the shares, which are ascending from
    /// the end with the lower coordinates; empty where a face would have no area.
    std::vector<std::vector<int>> divide(
        const std::vector<int>& sides, const std::vector<double>& shares
    ) {
        const auto [low, high] = endsOf(sides.front());
        std::vector<Vec3> places{low};
        for (const double share : shares) {
            places.emplace_back((1.0 - share) * low + share * high);
        }
        places.push_back(high);
        for (const int side : sides) {
            const Vec3& apex = positionAt(side, 0);
            for (std::size_t i = 0; i + 1 < places.size(); ++i) {
                if (!hasArea(apex, places[i], places[i + 1])) {
                    return {};
                }
            }
        }
        std::vector<Vec3>& vertices = repair_.mesh.vertices;
        const auto first = static_cast<int>(vertices.size());
        vertices.insert(vertices.end(), places.begin() + 1, places.end() - 1);
        std::vector<std::vector<int>> parts;
        for (const int side : sides) {
            parts.push_back(divide(side, first, shares, positionAt(side, 1) != low));
        }
        return parts;
    }

private:
    [[nodiscard]] const Vec3& positionAt(int side, int corner) const {
        return repair_.mesh.vertices[repair_.mesh.faces[faceOf(side)][(side + corner) % 3]];
    }

    [[nodiscard]] std::pair<Vec3, Vec3> endsOf(int side) const {
        const Vec3& a = positionAt(side, 1);
        const Vec3& b = positionAt(side, 2);
        const bool isLow = std::tie(a.x(), a.y(), a.z()) < std::tie(b.x(), b.y(), b.z());
        return isLow ? std::pair(a, b) : std::pair(b, a);
    }

    std::vector<int> divide(
        int side, int firstVertex, const std::vector<double>& shares, bool isReversed
    ) {
        const auto count = static_cast<int>(shares.size());
        const int k = side % 3;
        std::vector<int> parts;
        int face = faceOf(side);
        const auto addPart = [&] {
            parts.push_back(nextSide_);
            faceOf_[nextSide_] = face;
            sideAt_[sideOf(face, k)] = nextSide_++;
        };
        double before = 0.0;
        for (int i = 0; i < count; ++i) {
            const int at = isReversed ? count - 1 - i : i;
            const double share = isReversed ? 1.0 - shares[at] : shares[at];
            const double ofRest = (share - before) / (1.0 - before);
            const int part = repair_steps::divideFace(repair_, face, k, firstVertex + at, ofRest);
            // The last side goes to the new part.
            const int last = sideAt(face, (k + 1) % 3);
            if (last >= 0) {
                faceOf_[last] = part;
            }
            sideAt_[sideOf(part, (k + 1) % 3)] = last;
            sideAt_[sideOf(face, (k + 1) % 3)] = sideAt_[sideOf(part, (k + 2) % 3)] = -1;
            addPart();
            face = part;
            before = share;
        }
        addPart();
        if (isReversed) {
            std::ranges::reverse(parts);
        }
        return parts;
    }

    /// The number of a face's side, or -1: it is an inner one.
    [[nodiscard]] int sideAt(int face, int k) const {
        const auto found = sideAt_.find(sideOf(face, k));
        return found == sideAt_.end() ? sideOf(face, k) : found->second;
    }

    MeshRepair& repair_;
    int nextSide_;
    std::map<int, int> faceOf_;  // of sides whose face has changed
    std::map<int, int> sideAt_;  // by place, where that has changed
};

/// Divides edges, and gives the pairs of faces to be joined there.
std::vector<Passage> dividedPassages(
    SideDivider& divider, const PartedEdges& parted, const std::vector<Stretch>& stretches
) {
    std::vector<std::pair<int, int>> sidesOfPassages;  // whose faces may yet be divided
    for (auto first = stretches.begin(); first != stretches.end();) {
        const auto last = std::find_if(first, stretches.end(), [&](const Stretch& stretch) {
            return stretch.edge != first->edge;
        });
        const std::span<const Stretch> here(first, last);
        first = last;
        std::vector<double> shares;
        for (const Stretch& stretch : here) {
            if (stretch.end < 1.0) {
                shares.push_back(stretch.end);
            }
        }
        const std::vector<int>& sides = parted.edges()[here.front().edge].sides;
        const std::vector<std::vector<int>> parts =
            shares.empty() ? std::vector<std::vector<int>>() : divider.divide(sides, shares);
        for (std::size_t i = 0; i < here.size(); ++i) {
            const auto partAt = [&](int side) {
                const auto at = std::ranges::lower_bound(sides, side) - sides.begin();
                return parts.empty() ? side : parts[at][i];
            };
            const auto [a, b] = here[i].sides;
            sidesOfPassages.emplace_back(partAt(a), partAt(b));
        }
    }
    std::vector<Passage> passages;
    for (const auto& [a, b] : sidesOfPassages) {
        passages.emplace_back(std::minmax({divider.faceOf(a), divider.faceOf(b)}));
    }
    return passages;
}

}  // namespace

MeshRepair rejoined(
    const TriangleMesh& mended,
    const std::vector<int>& roots,
    const PartedEdges& parted,
    const Passages& passages
) {
    MeshRepair again;
    again.mesh = {.vertices = mended.vertices, .faces = facesBeforeParting(mended, roots)};
    again.faceOrigins.resize(mended.faces.size());
    std::iota(again.faceOrigins.begin(), again.faceOrigins.end(), 0);
    SideDivider divider(again);
    const std::vector<Passage> divided = dividedPassages(divider, parted, passages.stretches);
    std::vector<Passage> all = divided;
    for (const auto& [a, b] : passages.strips) {
        all.emplace_back(std::minmax({divider.faceOf(a), divider.faceOf(b)}));
    }
    repair_steps::Joints joints = repair_steps::joinAndOrient(again, all, {});
    repair_steps::splitVertices(again, std::move(joints), repair_steps::Crowded::Divide, divided);
    again.vertexOrigins.clear();
    return again;
}

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/near_shell.h"

#include "shell/full_prisms.h"
#include "shell/slab.h"
#include "surface/index_sets.h"
#include "surface/sparse_map.h"

#include <algorithm>
#include <utility>

namespace bspline_curve {
namespace {

// Pillars of inverted prisms shrink this often, by this factor.
constexpr int kShrinkRounds = 12;
constexpr double kShrink = 0.6;
// Beyond each boundary edge there are two ghosts.
constexpr int kGhostRings = 2;

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

// Grows a set of faces, each once, in the order in which they came.
class NearFaces {
public:
    NearFaces(const Surface& surface, const ShellBase& whole) : surface_(surface), whole_(whole) {}

    void add(int face) {
        if (std::exchange(known_.at(face, 0), char{1}) == 0) {
            faces_.push_back(face);
        }
    }

    // All faces around the vertices of those of the surface that are there.
    void addRing() {
        const std::size_t last = faces_.size();
        for (; ringed_ < last; ++ringed_) {
            if (isGhost(faces_[ringed_])) {
                continue;
            }
            const Triangle corners = whole_.faces[at(faces_[ringed_])];
            for (const int v : corners) {
                if (std::exchange(visited_.at(v, 0), char{1}) != 0) {
                    continue;
                }
                for (const int f : surface_.facesAround(v)) {
                    add(f);
                }
            }
        }
    }

    void addGhosts() {
        if (whole_.surfaceFaceCount == static_cast<int>(whole_.faces.size())) {
            return;
        }
        for (int ring = 0; ring < kGhostRings; ++ring) {
            const std::size_t count = faces_.size();
            for (std::size_t i = 0; i < count; ++i) {
                const Triangle neighbours = whole_.faceNeighbours[at(faces_[i])];
                for (const int there : neighbours) {
                    if (there >= 0 && isGhost(there)) {
                        add(there);
                    }
                }
            }
        }
        // What a ghost leads to, its neighbour 2 or that one's, holds the shadows of its points.
        for (std::size_t i = 0; i < faces_.size();) {
            const int face = faces_[i++];
            if (isGhost(face)) {
                add(whole_.faceNeighbours[at(face)][2]);
            }
        }
    }

    [[nodiscard]] std::vector<int> ascending() && {
        std::ranges::sort(faces_);
        return std::move(faces_);
    }

private:
    [[nodiscard]] bool isGhost(int face) const { return face >= whole_.surfaceFaceCount; }

    const Surface& surface_;
    const ShellBase& whole_;
    SparseMap<char> known_, visited_;
    std::vector<int> faces_;
    std::size_t ringed_ = 0;  // faces before this have their rings
};

std::vector<int> facesNear(
    const Surface& surface, const ShellBase& whole, const std::vector<int>& given, int rings
) {
    NearFaces near(surface, whole);
    for (const int face : given) {
        near.add(face);
    }
    for (int ring = 0; ring < rings; ++ring) {
        near.addRing();
    }
    near.addGhosts();
    return std::move(near).ascending();
}

bool isUpright(const Prism& prism, const std::vector<Pillar>& pillars) {
    for (const bool top : {true, false}) {
        const int wanted = top ? prism.orientation : -prism.orientation;
        const auto pointOf = [&](int slot, bool outer) -> const Vec3& {
            const Pillar& pillar = pillars[at(prism.pillars[at(slot)])];
            return !outer ? pillar.middle : (top ? pillar.top : pillar.bottom);
        };
        if (!slabIsUpright(wanted, pointOf)) {
            return false;
        }
    }
    return true;
}

// Shortens the pillars of prisms that are not upright; those that never are lose their place.
void makeUpright(std::vector<Prism>& prisms, std::vector<Pillar>& pillars) {
    std::vector<char> isChanged(pillars.size(), 1);  // since their prisms were checked
    std::vector<int> inverted;
    for (int round = 0; round <= kShrinkRounds; ++round) {
        inverted.clear();
        for (Prism& prism : prisms) {
            const auto& corners = prism.pillars;
            const bool isNew =
                std::ranges::any_of(corners, [&](int v) { return isChanged[at(v)]; });
            if (isNew && !isUpright(prism, pillars)) {
                inverted.insert(inverted.end(), corners.begin(), corners.end());
                if (round == kShrinkRounds) {
                    prism.orientation = 0;
                }
            }
        }
        if (inverted.empty()) {
            return;
        }
        sortUnique(inverted);
        std::ranges::fill(isChanged, 0);
        for (const int v : inverted) {
            Pillar& pillar = pillars[at(v)];
            pillar.bottom = pillar.middle + kShrink * (pillar.bottom - pillar.middle);
            pillar.top = pillar.middle + kShrink * (pillar.top - pillar.middle);
            isChanged[at(v)] = 1;
        }
    }
}

}  // namespace

NearShell::NearShell(
    const Surface& surface,
    const ShellBase& whole,
    const std::vector<int>& given,
    const NearShellSize& size
)
    : faces(facesNear(surface, whole, given, size.rings)) {
    std::vector<int> vertices;
    SparseMap<int> vertexHere;
    SparseMap<int> faceHere;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        faceHere.at(faces[i], static_cast<int>(i));
        for (const int v : whole.faces[at(faces[i])]) {
            if (!vertexHere.contains(v)) {
                vertexHere.at(v, 0);
                vertices.push_back(v);
            }
        }
    }
    // The same order as in the whole, so that prisms are split alike.
    std::ranges::sort(vertices);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        vertexHere.at(vertices[i], 0) = static_cast<int>(i);
    }
    base.frame = whole.frame;
    std::vector<Pillar> pillars;
    pillars.reserve(vertices.size());
    base.vertices.reserve(vertices.size());
    base.directions.reserve(vertices.size());
    base.edgeLengths.reserve(vertices.size());
    for (const int v : vertices) {
        const Vec3& middle = whole.vertices[at(v)];
        const double length = std::max(size.thickness * whole.edgeLengths[at(v)], size.least);
        const Vec3 half = length * whole.directions[at(v)];
        base.vertices.push_back(middle);
        base.directions.push_back(whole.directions[at(v)]);
        base.edgeLengths.push_back(whole.edgeLengths[at(v)]);
        pillars.push_back({middle - half, middle, middle + half});
        if (v < whole.surfaceVertexCount) {
            ++base.surfaceVertexCount;
        } else {
            base.ghostOrigin.push_back(*vertexHere.find(whole.surfaceVertex(v)));
        }
    }
    std::vector<Prism> prisms;
    prisms.reserve(faces.size());
    base.faces.reserve(faces.size());
    base.faceNeighbours.reserve(faces.size());
    for (const int f : faces) {
        Triangle face{};
        Triangle neighbours{};
        for (std::size_t k = 0; k < 3; ++k) {
            face[k] = *vertexHere.find(whole.faces[at(f)][k]);
            const int there = whole.faceNeighbours[at(f)][k];
            const int* const found = there >= 0 ? faceHere.find(there) : nullptr;
            neighbours[k] = found != nullptr ? *found : -1;
        }
        base.faces.push_back(face);
        base.faceNeighbours.push_back(neighbours);
        base.surfaceFaceCount += static_cast<int>(f < whole.surfaceFaceCount);
        prisms.push_back(prismOver(face));
    }
    makeUpright(prisms, pillars);
    connectPrisms(prisms, base.faceNeighbours);
    shell = Shell(std::move(pillars), std::move(prisms), base.surfaceFaceCount);
}

int NearShell::indexOf(int face) const {
    return indexIn(faces, face);
}

}  // namespace bspline_curve

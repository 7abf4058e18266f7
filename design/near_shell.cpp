// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/near_shell.h"

#include "surface/index_sets.h"
#include "surface/predicates.h"
#include "surface/surface_point.h"

#include <algorithm>
#include <utility>

namespace bspline_curve {
namespace {

constexpr int kRings = 2;
// Half a prism, in local mean edge lengths, and at least in tolerances of the curve.
constexpr double kThickness = 0.5;
constexpr double kLeastTolerances = 2.5;
// Pillars of inverted prisms shrink this often, by this factor.
constexpr int kShrinkRounds = 12;
constexpr double kShrink = 0.6;

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

std::vector<int> facesNear(
    const Surface& surface, const ShellBase& whole, const ShadowCurve& shadow
) {
    std::vector<int> faces = shadow.faces();
    sortUnique(faces);
    for (int ring = 0; ring < kRings; ++ring) {
        std::vector<int> vertices;
        for (const int f : faces) {
            if (f < whole.surfaceFaceCount) {
                vertices.insert(
                    vertices.end(), whole.faces[at(f)].begin(), whole.faces[at(f)].end()
                );
            }
        }
        sortUnique(vertices);
        for (const int v : vertices) {
            const Surface::FaceRange around = surface.facesAround(v);
            faces.insert(faces.end(), around.begin(), around.end());
        }
        sortUnique(faces);
    }
    // Beyond each boundary edge there are two ghosts.
    for (int ring = 0; ring < 2; ++ring) {
        const std::size_t count = faces.size();
        for (std::size_t i = 0; i < count; ++i) {
            for (const int there : whole.faceNeighbours[at(faces[i])]) {
                if (there >= whole.surfaceFaceCount) {
                    faces.push_back(there);
                }
            }
        }
        sortUnique(faces);
    }
    // What a ghost leads to, its neighbour 2 or that one's, holds the shadows of its points.
    const std::size_t count = faces.size();
    for (std::size_t i = 0; i < count; ++i) {
        int face = faces[i];
        while (face >= whole.surfaceFaceCount) {
            face = whole.faceNeighbours[at(face)][2];
            faces.push_back(face);
        }
    }
    sortUnique(faces);
    return faces;
}

// Slots ascending by vertex, as in every shell of full resolution.
Prism prismOver(const Triangle& face) {
    Prism prism;
    prism.pillars = face;
    std::ranges::sort(prism.pillars);
    for (std::size_t slot = 0; slot < 3; ++slot) {
        prism.faceCorner[slot] = static_cast<signed char>(cornerOf(face, prism.pillars[slot]));
    }
    prism.orientation = (prism.faceCorner[1] - prism.faceCorner[0] + 3) % 3 == 1 ? 1 : -1;
    prism.neighbours = {-1, -1, -1};
    return prism;
}

bool isUpright(const Prism& prism, const std::vector<Pillar>& pillars) {
    for (const bool top : {true, false}) {
        const int wanted = top ? prism.orientation : -prism.orientation;
        for (const auto& split : kSlabSplit) {
            std::array<const Vec3*, 4> p{};
            for (std::size_t k = 0; k < 4; ++k) {
                const Pillar& pillar = pillars[at(prism.pillars[at(split[k].slot)])];
                p[k] = !split[k].outer ? &pillar.middle : (top ? &pillar.top : &pillar.bottom);
            }
            if (orientationSign(*p[0], *p[1], *p[2], *p[3]) != wanted) {
                return false;
            }
        }
    }
    return true;
}

// Shortens the pillars of prisms that are not upright; those that never are lose their place.
void makeUpright(std::vector<Prism>& prisms, std::vector<Pillar>& pillars) {
    for (int round = 0; round <= kShrinkRounds; ++round) {
        std::vector<int> inverted;
        for (Prism& prism : prisms) {
            if (!isUpright(prism, pillars)) {
                inverted.insert(inverted.end(), prism.pillars.begin(), prism.pillars.end());
                if (round == kShrinkRounds) {
                    prism.orientation = 0;
                }
            }
        }
        sortUnique(inverted);
        for (const int v : inverted) {
            Pillar& pillar = pillars[at(v)];
            pillar.bottom = pillar.middle + kShrink * (pillar.bottom - pillar.middle);
            pillar.top = pillar.middle + kShrink * (pillar.top - pillar.middle);
        }
        if (inverted.empty()) {
            return;
        }
    }
}

void connect(std::vector<Prism>& prisms, const std::vector<Triangle>& faceNeighbours) {
    for (std::size_t f = 0; f < prisms.size(); ++f) {
        for (std::size_t slot = 0; prisms[f].orientation != 0 && slot < 3; ++slot) {
            const int there = faceNeighbours[f][at(prisms[f].faceCorner[slot])];
            if (there < 0 || prisms[at(there)].orientation == 0) {
                continue;
            }
            prisms[f].neighbours[slot] = there;
            for (std::size_t k = 0; k < 3; ++k) {
                if (faceNeighbours[at(there)][at(prisms[at(there)].faceCorner[k])] ==
                    static_cast<int>(f)) {
                    prisms[f].neighbourWalls[slot] = static_cast<signed char>(k);
                }
            }
        }
    }
}

}  // namespace

NearShell::NearShell(
    const Surface& surface, const ShellBase& whole, const ShadowCurve& shadow, double tolerance
)
    : faces(facesNear(surface, whole, shadow)) {
    std::vector<int> vertices;
    for (const int f : faces) {
        vertices.insert(vertices.end(), whole.faces[at(f)].begin(), whole.faces[at(f)].end());
    }
    sortUnique(vertices);
    base.frame = whole.frame;
    std::vector<Pillar> pillars;
    for (const int v : vertices) {
        const Vec3& middle = whole.vertices[at(v)];
        const Vec3 half =
            std::max(kThickness * whole.edgeLengths[at(v)], kLeastTolerances * tolerance) *
            whole.directions[at(v)];
        base.vertices.push_back(middle);
        base.directions.push_back(whole.directions[at(v)]);
        base.edgeLengths.push_back(whole.edgeLengths[at(v)]);
        pillars.push_back({middle - half, middle, middle + half});
        if (v < whole.surfaceVertexCount) {
            ++base.surfaceVertexCount;
        } else {
            base.ghostOrigin.push_back(indexIn(vertices, whole.surfaceVertex(v)));
        }
    }
    std::vector<Prism> prisms;
    for (const int f : faces) {
        Triangle face{};
        Triangle near{};
        for (std::size_t k = 0; k < 3; ++k) {
            face[k] = indexIn(vertices, whole.faces[at(f)][k]);
            near[k] = indexIn(faces, whole.faceNeighbours[at(f)][k]);
        }
        base.faces.push_back(face);
        base.faceNeighbours.push_back(near);
        base.surfaceFaceCount += static_cast<int>(f < whole.surfaceFaceCount);
        prisms.push_back(prismOver(face));
    }
    makeUpright(prisms, pillars);
    connect(prisms, base.faceNeighbours);
    shell = Shell(std::move(pillars), std::move(prisms), base.surfaceFaceCount);
}

int NearShell::indexOf(int face) const {
    return indexIn(faces, face);
}

}  // namespace bspline_curve

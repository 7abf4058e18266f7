// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/near_shell.h"

#include "shell/full_prisms.h"
#include "shell/slab.h"
#include "surface/index_sets.h"

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
    connectPrisms(prisms, base.faceNeighbours);
    shell = Shell(std::move(pillars), std::move(prisms), base.surfaceFaceCount);
}

int NearShell::indexOf(int face) const {
    return indexIn(faces, face);
}

}  // namespace bspline_curve

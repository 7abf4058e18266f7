// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/shell.h"

#include "shell/face_geometry.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace bspline_curve {
namespace {

// What lies across the face opposite to vertex k of tetrahedron i of a slab.
enum class Across : signed char { Tetrahedron, OtherSlab, Wall, Outside };

struct Adjacency {
    Across kind;
    signed char target;  // Tetrahedron: its index in the slab; walls: the wall's slot
};

constexpr Adjacency toWall(signed char slot) {
    return {Across::Wall, slot};
}

constexpr Adjacency toTetrahedron(signed char i) {
    return {Across::Tetrahedron, i};
}

// The tables follow kSlabSplit.
constexpr std::array<std::array<Adjacency, 4>, 3> kAdjacency = {
    {{{toWall(0), toWall(1), toTetrahedron(1), {Across::OtherSlab, 0}}},
     {{toWall(0), toTetrahedron(2), toWall(2), toTetrahedron(0)}},
     {{{Across::Outside, 0}, toTetrahedron(1), toWall(1), toWall(2)}}}
};

// A wall between slots p < q has its diagonal from Mp to Uq, hence a lower and an upper half: which
// of them a tetrahedron of a slab touches, by the slot opposite to the wall. Tetrahedra 0, 1 and 2
// meet the walls opposite to slots 2, 1 and 0 in the diagonal or in the outer edge alone, where
// they are as good as their neighbour.
constexpr std::array<std::array<bool, 3>, 3> kTouchesUpperHalf = {
    {{false, false, false}, {true, false, false}, {true, true, true}}
};

// The tetrahedron of a slab that holds the lower or the upper half of the wall opposite to a slot.
constexpr std::array<std::array<int, 3>, 2> kHolderOfHalf = {{{0, 0, 1}, {1, 2, 2}}};

// A tetrahedron holds points whose barycentric coordinates are above minus this: rounding.
constexpr double kHoldingDepth = 1e-12;

int countPrisms(const std::vector<Prism>& prisms) {
    return static_cast<int>(std::ranges::count_if(prisms, [](const Prism& prism) {
        return prism.orientation != 0;
    }));
}

}  // namespace

Shell::Shell(std::vector<Pillar> pillars, std::vector<Prism> prisms, int surfaceFaceCount)
    : pillars_(std::move(pillars)),
      prisms_(std::move(prisms)),
      prismCount_(countPrisms(prisms_)),
      surfaceFaceCount_(surfaceFaceCount) {}

Shell::Shell(
    std::vector<Pillar> pillars,
    std::vector<Prism> prisms,
    SurfaceTracks tracks,
    std::shared_ptr<const ExtendedSurface> extended
)
    : pillars_(std::move(pillars)),
      prisms_(std::move(prisms)),
      prismCount_(countPrisms(prisms_)),
      surfaceFaceCount_(extended->surfaceFaceCount),
      tracks_(std::move(tracks)),
      extended_(std::move(extended)) {
    prismOffsets_.assign(extended_->faces.size() + 1, 0);
    for (const int face : tracks_.faces) {
        ++prismOffsets_[face + 1];
    }
    std::partial_sum(prismOffsets_.begin(), prismOffsets_.end(), prismOffsets_.begin());
    std::vector<int> next(prismOffsets_.begin(), prismOffsets_.end() - 1);
    facePrisms_.resize(tracks_.faces.size());
    for (std::size_t prism = 0; prism < prisms_.size(); ++prism) {
        for (const int face : facesOf(static_cast<int>(prism))) {
            facePrisms_[next[face]++] = static_cast<int>(prism);
        }
    }
}

std::span<const int> Shell::facesOf(int prism) const {
    const int first = tracks_.offsets[prism];
    return std::span(tracks_.faces).subspan(first, tracks_.offsets[prism + 1] - first);
}

std::span<const int> Shell::prismsOf(int face) const {
    const int first = prismOffsets_[face];
    return std::span(facePrisms_).subspan(first, prismOffsets_[face + 1] - first);
}

std::vector<int> Shell::blockedFaces() const {
    std::vector<int> blocked;
    for (int face = 0; face < surfaceFaceCount_; ++face) {
        if (isBlocked(face)) {
            blocked.push_back(face);
        }
    }
    return blocked;
}

int Shell::neighbour(int tet, int k) const {
    const Adjacency adjacency = kAdjacency[tet % 3][k];
    const int first = tet - tet % 3;  // of the slab
    switch (adjacency.kind) {
        case Across::Outside:
            return -1;
        case Across::Tetrahedron:
            return first + adjacency.target;
        case Across::OtherSlab:
            return below(first);
        case Across::Wall:
            break;
    }
    const Prism& here = prisms_[tet / kTetrahedraPerPrism];
    return here.neighbours[adjacency.target] < 0 ? -1 : neighbourBehind(tet, adjacency.target);
}

int Shell::wallOf(int tet, int k) {
    const Adjacency adjacency = kAdjacency[tet % 3][k];
    return adjacency.kind == Across::Wall ? adjacency.target : -1;
}

int Shell::neighbourBehind(int tet, int wall) const {
    const Prism& here = prisms_[tet / kTetrahedraPerPrism];
    const std::size_t half = kTouchesUpperHalf[tet % 3][wall] ? 1 : 0;
    const int slab = tet % kTetrahedraPerPrism / 3;
    return here.neighbours[wall] * kTetrahedraPerPrism + slab * 3 +
           kHolderOfHalf[half][here.neighbourWalls[wall]];
}

int Shell::locate(const SurfacePoint& point) const {
    if (isBlocked(point.face)) {
        return -1;
    }
    if (isFullResolution()) {
        return point.face * kTetrahedraPerPrism;
    }
    const Vec3 p = extended_->position(point);
    const Vec3 normal = areaNormal(*extended_, point.face).normalized();
    int best = -1;
    double highest = -std::numeric_limits<double>::infinity();
    std::array<AffineForm, 4> lambda;
    for (const int prism : prismsOf(point.face)) {
        for (int tet = prism * kTetrahedraPerPrism; tet < (prism + 1) * kTetrahedraPerPrism;
             ++tet) {
            barycentrics(tet, lambda.data());
            const double depth =
                std::min({lambda[0].at(p), lambda[1].at(p), lambda[2].at(p), lambda[3].at(p)});
            // Cosines lie above -1, so a tetrahedron that holds the point comes first.
            const double score =
                depth >= -kHoldingDepth ? fibre(tet).normalized().dot(normal) : depth - 1.0;
            if (score > highest) {
                highest = score;
                best = tet;
            }
        }
    }
    return best;
}

Vec3 Shell::lift(const SurfacePoint& point, double w) const {
    Vec3 beta = Vec3::Zero();
    if (isFullResolution()) {
        const Prism& prism = prisms_[point.face];
        for (std::size_t slot = 0; slot < 3; ++slot) {
            beta[static_cast<Eigen::Index>(slot)] = point.barycentric[prism.faceCorner[slot]];
        }
        return onFibre(point.face, beta, w);
    }
    const int tet = locate(point);
    beta = inPrism(tet, extended_->position(point)).beta.cwiseMax(0.0);  // rounding, next to a wall
    return onFibre(tet / kTetrahedraPerPrism, beta / beta.sum(), w);
}

Vec3 Shell::fibre(int tet) const {
    const Prism& prism = prisms_[tet / kTetrahedraPerPrism];
    const Pillar& pillar = pillars_[prism.pillars[2 - tet % 3]];
    return tet % kTetrahedraPerPrism < 3 ? pillar.top - pillar.middle
                                         : pillar.middle - pillar.bottom;
}

Vec3 Shell::onFibre(int prism, const Vec3& beta, double w) const {
    // In the reference slab the fibre over beta rises from the middle through the tetrahedra whose
    // outer vertices are c, then c and b, then all three: outer weight goes to slot c first, up to
    // beta_c, then to b, then to a.
    double rest = std::abs(w);
    Vec3 outer;
    for (int slot = 3; slot-- > 0;) {
        outer[slot] = std::min(rest, beta[slot]);
        rest -= outer[slot];
    }
    Vec3 result = Vec3::Zero();
    for (int slot = 0; slot < 3; ++slot) {
        const Pillar& pillar = pillars_[prisms_[prism].pillars[slot]];
        result += (beta[slot] - outer[slot]) * pillar.middle +
                  outer[slot] * (w >= 0.0 ? pillar.top : pillar.bottom);
    }
    return result;
}

// The forms of a stretched tetrahedron lose digits, each others. A step of Newton's method makes
// them coordinates of one point again, which is p but for its own rounding: relative to p, corners
// lose nothing.
Shell::PrismPoint Shell::inPrism(int tet, const Vec3& p) const {
    std::array<AffineForm, 4> lambda;
    barycentrics(tet, lambda.data());
    std::array<double, 4> values{};
    Vec3 rest = Vec3::Zero();
    for (int k = 0; k < 4; ++k) {
        values[k] = lambda[k].at(p);
        rest -= values[k] * (position(tet, k) - p);
    }
    const double side = tet % kTetrahedraPerPrism < 3 ? 1.0 : -1.0;
    PrismPoint point;
    for (int k = 0; k < 4; ++k) {
        const double value = values[k] + lambda[k].gradient.dot(rest);
        const SplitVertex vertex = kSlabSplit[tet % 3][k];
        point.beta[vertex.slot] += value;
        point.height += vertex.outer ? side * value : 0.0;
    }
    return point;
}

void Shell::barycentrics(int tet, AffineForm* forms) const {
    const Prism& prism = prisms_[tet / kTetrahedraPerPrism];
    const int inPrism = tet % kTetrahedraPerPrism;
    const auto& split = kSlabSplit[inPrism % 3];
    const Vec3 Pillar::* const tip = inPrism < 3 ? &Pillar::top : &Pillar::bottom;
    const auto corner = [&](std::size_t k) -> const Vec3& {
        const Pillar& pillar = pillars_[prism.pillars[split[k].slot]];
        return split[k].outer ? pillar.*tip : pillar.middle;
    };
    const Vec3& first = corner(0);
    const Vec3 e1 = corner(1) - first;
    const Vec3 e2 = corner(2) - first;
    const Vec3 e3 = corner(3) - first;
    const Vec3 n1 = e2.cross(e3);
    const Vec3 n2 = e3.cross(e1);
    const Vec3 n3 = e1.cross(e2);
    const double inverseVolume = 1.0 / e1.dot(n1);
    forms[1].gradient = inverseVolume * n1;
    forms[2].gradient = inverseVolume * n2;
    forms[3].gradient = inverseVolume * n3;
    forms[0].gradient = -(forms[1].gradient + forms[2].gradient + forms[3].gradient);
    for (int k = 1; k < 4; ++k) {
        forms[k].offset = -forms[k].gradient.dot(first);
    }
    forms[0].offset = 1.0 - forms[1].offset - forms[2].offset - forms[3].offset;
}

Vec3 Shell::position(int tet, int k) const {
    const Prism& prism = prisms_[tet / kTetrahedraPerPrism];
    const int inPrism = tet % kTetrahedraPerPrism;
    const SplitVertex vertex = kSlabSplit[inPrism % 3][k];
    const Pillar& pillar = pillars_[prism.pillars[vertex.slot]];
    if (!vertex.outer) {
        return pillar.middle;
    }
    return inPrism < 3 ? pillar.top : pillar.bottom;
}

}  // namespace bspline_curve

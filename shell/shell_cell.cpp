// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/shell_cell.h"

#include "shell/extended_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace bspline_curve {
namespace {

double sideOf(int tet) {
    return tet % kTetrahedraPerPrism < 3 ? 1.0 : -1.0;
}

// What the barycentric coordinates of a tetrahedron say of the prism, by kSlabSplit.
struct PrismForms {
    std::array<AffineForm, 2> beta;  // of slots 1 and 2
    AffineForm height;
};

PrismForms prismForms(const AffineForm* lambda, int tet) {
    const double side = sideOf(tet);
    switch (tet % 3) {
        case 0:
            return {{lambda[1], lambda[2] + lambda[3]}, side * lambda[3]};
        case 1:
            return {{lambda[1] + lambda[3], lambda[2]}, side * (lambda[2] + lambda[3])};
        default:
            return {{lambda[2], lambda[3]}, side * (lambda[1] + lambda[2] + lambda[3])};
    }
}

AffineForm one() {
    return {Vec3::Zero(), 1.0};
}

}  // namespace

ShellCell::ShellCell(const Shell& shell, int tetrahedron) {
    setTetrahedron(shell, tetrahedron);
    shadowInOwnPrism(shell);
}

ShellCell::ShellCell(const Shell& shell, int tetrahedron, int footTetrahedron, int baseFace) {
    if (shell.isFullResolution()) {
        *this = ShellCell(shell, tetrahedron);
        return;
    }
    setTetrahedron(shell, tetrahedron);
    setFoot(shell, footTetrahedron);
    if (!setFace(shell, baseFace)) {
        throw std::logic_error(
            "tetrahedron " + std::to_string(foot) + " sees face " + std::to_string(face) +
            " from behind"
        );
    }
    compose();
}

ShellCell::ShellCell(const Shell& shell, const SurfacePoint& point) {
    const int located = shell.locate(point);
    if (located < 0) {
        throw std::logic_error("face " + std::to_string(point.face) + " has no prism");
    }
    *this = ShellCell(shell, located, located, point.face);
}

std::optional<ShellCell> ShellCell::find(const Shell& shell, int tetrahedron, const Vec3& p) {
    if (shell.isFullResolution()) {
        return ShellCell(shell, tetrahedron);
    }
    std::optional<ShellCell> found;
    double best = -std::numeric_limits<double>::infinity();
    ShellCell cell;
    cell.setTetrahedron(shell, tetrahedron);
    const std::array<double, 2> beta = {cell.beta_[0].at(p), cell.beta_[1].at(p)};
    for (int i = 0; i < kTetrahedraPerPrism; ++i) {
        cell.setFoot(shell, cell.prism * kTetrahedraPerPrism + i);
        for (const int candidate : shell.facesOf(cell.prism)) {
            // Most faces are elsewhere, which is seen without the whole cell.
            if (!cell.setFace(shell, candidate) || cell.insideFace(beta) < best) {
                continue;
            }
            cell.compose();
            // A prism may list faces beyond its top or bottom, where no wall ends its last foot.
            const double inside = std::min(
                cell.insideness(p, kFirstFaceWall) - cell.shadowRounding(),
                1.0 - std::abs(cell.surfaceHeight.at(p))
            );
            if (inside > best) {
                best = inside;
                found = cell;
            }
        }
    }
    return found;
}

ShellCell::Projection ShellCell::project(const Shell& shell, const Vec3& p) const {
    // The first takes what shadow() lost, further ones what the chart loses of that.
    constexpr int kMostSteps = 4;
    constexpr double kSettled = 0x1p-52;
    const Shell::PrismPoint here = shell.inPrism(tet, p);
    if (foot < 0) {
        const std::array<signed char, 3>& corner = shell.prisms()[prism].faceCorner;
        Projection result{.shadow = {}, .height = here.height};
        result.shadow[corner[0]] = 1.0 - here.beta[1] - here.beta[2];  // they add up to 1
        result.shadow[corner[1]] = here.beta[1];
        result.shadow[corner[2]] = here.beta[2];
        return result;
    }
    Projection result{.shadow = shadow(p), .height = here.height};
    for (int i = 0; i < kMostSteps; ++i) {
        const Shell::PrismPoint there =
            shell.inPrism(foot, shell.extended().position({face, result.shadow}));
        const double x = here.beta[1] - there.beta[1];
        const double y = here.beta[2] - there.beta[2];
        const double change1 = chart_.barycentric[0][0] * x + chart_.barycentric[0][1] * y;
        const double change2 = chart_.barycentric[1][0] * x + chart_.barycentric[1][1] * y;
        result.shadow[1] += change1;
        result.shadow[2] += change2;
        result.shadow[0] = 1.0 - result.shadow[1] - result.shadow[2];
        if (std::abs(change1) + std::abs(change2) < kSettled) {
            break;
        }
    }
    return result;
}

Entry ShellCell::enter(const Shell& shell, const ShellCell& from, int wall) {
    if (wall < kFirstFaceWall) {
        const int next = shell.neighbour(from.tet, wall);
        if (next < 0) {
            return Entry::Outside;
        }
        setTetrahedron(shell, next);
        if (shell.isFullResolution()) {
            shadowInOwnPrism(shell);
            return Entry::Entered;
        }
        if (prism == from.prism) {
            foot = from.foot;
            footBeta_ = from.footBeta_;
            footHeight_ = from.footHeight_;
            face = from.face;
            chart_ = from.chart_;
        } else {
            setFoot(shell, shell.neighbourBehind(from.foot, Shell::wallOf(from.tet, wall)));
            if (!setFace(shell, from.face)) {
                return Entry::Lost;
            }
        }
        compose();
        return Entry::Entered;
    }
    copyTetrahedron(from);
    int nextFace = from.face;
    if (wall < kFootFalls) {
        nextFace = shell.extended().faceNeighbours[from.face][wall - kFirstFaceWall];
        if (nextFace < 0 || shell.isBlocked(nextFace)) {
            return Entry::Outside;
        }
        foot = from.foot;
        footBeta_ = from.footBeta_;
        footHeight_ = from.footHeight_;
    } else {
        setFoot(shell, wall == kFootFalls ? Shell::below(from.foot) : Shell::above(from.foot));
    }
    if (!setFace(shell, nextFace)) {
        return Entry::Lost;
    }
    compose();
    return Entry::Entered;
}

double ShellCell::insideness(const Vec3& p, int firstWall) const {
    double smallest = std::numeric_limits<double>::infinity();
    for (int k = firstWall; k < wallCount; ++k) {
        smallest = std::min(smallest, walls[k].at(p));
    }
    return smallest;
}

// Next to a corner or an edge several faces hold a point as far as rounding tells; those that the
// fibres see nearly edge-on tell its shadow least exactly.
double ShellCell::shadowRounding() const {
    constexpr double kRelativeRounding = 0x1p-50;  // of coordinates up to 1, after a few operations
    double steepest = 0.0;
    for (std::size_t corner = 0; corner < 3; ++corner) {
        steepest = std::max(steepest, shadowForm(corner).gradient.squaredNorm());
    }
    return kRelativeRounding * std::sqrt(steepest);
}

void ShellCell::setTetrahedron(const Shell& shell, int tetrahedron) {
    tet = tetrahedron;
    prism = tetrahedron / kTetrahedraPerPrism;
    shell.barycentrics(tet, walls.data());
    const PrismForms forms = prismForms(walls.data(), tet);
    beta_ = forms.beta;
    height = forms.height;
}

void ShellCell::copyTetrahedron(const ShellCell& other) {
    tet = other.tet;
    prism = other.prism;
    std::copy_n(other.walls.begin(), kFirstFaceWall, walls.begin());
    beta_ = other.beta_;
    height = other.height;
}

// Full resolution: the prism's barycentric coordinates are those of the shadow.
void ShellCell::shadowInOwnPrism(const Shell& shell) {
    face = prism;
    wallCount = kFirstFaceWall;
    const std::array<signed char, 3>& corner = shell.prisms()[prism].faceCorner;
    walls[kFirstFaceWall + corner[0]] = one() - beta_[0] - beta_[1];
    walls[kFirstFaceWall + corner[1]] = beta_[0];
    walls[kFirstFaceWall + corner[2]] = beta_[1];
}

void ShellCell::setFoot(const Shell& shell, int tetrahedron) {
    foot = tetrahedron;
    if (foot == tet) {
        footBeta_ = beta_;
        footHeight_ = height;
        return;
    }
    std::array<AffineForm, 4> lambda;
    shell.barycentrics(foot, lambda.data());
    const PrismForms forms = prismForms(lambda.data(), foot);
    footBeta_ = forms.beta;
    footHeight_ = forms.height;
}

// Puts a face into the coordinates of the foot; false where it is not seen from above.
bool ShellCell::setFace(const Shell& shell, int newFace) {
    face = newFace;
    const ExtendedSurface& extended = shell.extended();
    const Triangle& corners = extended.faces[face];
    const Vec3& first = extended.vertices[corners[0]];
    const Vec3 edge1 = extended.vertices[corners[1]] - first;
    const Vec3 edge2 = extended.vertices[corners[2]] - first;
    const std::array<double, 2> d1 = {
        footBeta_[0].gradient.dot(edge1), footBeta_[1].gradient.dot(edge1)
    };
    const std::array<double, 2> d2 = {
        footBeta_[0].gradient.dot(edge2), footBeta_[1].gradient.dot(edge2)
    };
    const double area = d1[0] * d2[1] - d1[1] * d2[0];
    if (area * shell.prisms()[prism].orientation <= 0.0) {
        return false;
    }
    const double inverse = 1.0 / area;
    chart_.first = {footBeta_[0].at(first), footBeta_[1].at(first)};
    chart_.firstHeight = footHeight_.at(first);
    chart_.barycentric[0] = {inverse * d2[1], -inverse * d2[0]};
    chart_.barycentric[1] = {-inverse * d1[1], inverse * d1[0]};
    const double rise1 = footHeight_.gradient.dot(edge1);
    const double rise2 = footHeight_.gradient.dot(edge2);
    for (std::size_t i = 0; i < 2; ++i) {
        chart_.height[i] = rise1 * chart_.barycentric[0][i] + rise2 * chart_.barycentric[1][i];
    }
    return true;
}

// The least barycentric coordinate in the face of a point of the prism.
double ShellCell::insideFace(const std::array<double, 2>& beta) const {
    const double x = beta[0] - chart_.first[0];
    const double y = beta[1] - chart_.first[1];
    const double b1 = chart_.barycentric[0][0] * x + chart_.barycentric[0][1] * y;
    const double b2 = chart_.barycentric[1][0] * x + chart_.barycentric[1][1] * y;
    return std::min({b1, b2, 1.0 - b1 - b2});
}

// The forms that follow from tetrahedron, foot and face.
void ShellCell::compose() {
    AffineForm beta1 = beta_[0];
    AffineForm beta2 = beta_[1];
    beta1.offset -= chart_.first[0];
    beta2.offset -= chart_.first[1];
    AffineForm* const shadow = walls.data() + kFirstFaceWall;
    for (std::size_t i = 0; i < 2; ++i) {
        shadow[i + 1] = chart_.barycentric[i][0] * beta1 + chart_.barycentric[i][1] * beta2;
    }
    shadow[0] = one() - shadow[1] - shadow[2];
    surfaceHeight = chart_.height[0] * beta1 + chart_.height[1] * beta2;
    surfaceHeight.offset += chart_.firstHeight;

    // Where the foot ends, going along the fibre: see kSlabSplit.
    const AffineForm outward = sideOf(foot) * surfaceHeight;
    const AffineForm upper = beta_[0] + beta_[1];
    wallCount = kMaxWalls;
    switch (foot % 3) {
        case 0:
            walls[kFootFalls] = outward;
            walls[kFootRises] = beta_[1] - outward;
            break;
        case 1:
            walls[kFootFalls] = outward - beta_[1];
            walls[kFootRises] = upper - outward;
            break;
        default:
            walls[kFootFalls] = outward - upper;
            wallCount = kFootRises;  // the surface does not reach top or bottom
    }
}

Vec3 directionAt(const Shell& shell, const ExtendedSurface& extended, const SurfacePoint& shadow) {
    Vec3 direction = Vec3::Zero();
    if (shell.isFullResolution()) {
        const Prism& prism = shell.prisms()[shadow.face];
        for (std::size_t slot = 0; slot < 3; ++slot) {
            const Pillar& pillar = shell.pillars()[prism.pillars[slot]];
            direction += shadow.barycentric[prism.faceCorner[slot]] * (pillar.top - pillar.bottom);
        }
    } else {
        const Triangle& face = extended.faces[shadow.face];
        for (int corner = 0; corner < 3; ++corner) {
            direction += shadow.barycentric[corner] * extended.directions[face[corner]];
        }
    }
    return direction.normalized();
}

}  // namespace bspline_curve

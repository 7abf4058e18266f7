// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/cell_integrand.h"

#include "solver/term_takers.h"

namespace bspline_curve {

CellIntegrand::CellIntegrand(
    const CurveProblem& problem,
    const EnergyWeights& weights,
    const ShellCell& cell,
    double heightScale
)
    : terms_(CellGround{problem, weights, cell, heightScale}) {}

bool CellIntegrand::add(const Vec3& p, double weight, EnergyTerms& terms) const {
    return terms_.add(p, weight, TakeValue{terms});
}

bool CellIntegrand::add(
    const Vec3& p, double weight, EnergyTerms& terms, PointDerivatives& derivatives
) const {
    return terms_.add(p, weight, TakeDerivatives{terms, derivatives});
}

double CellIntegrand::room(const Vec3& p) const {
    double room = 1.0;
    (void)terms_.add(p, 1.0, TakeRoom{room});
    return room;
}

Vec3 CellIntegrand::gradient(const Vec3& p) const {
    TakeForce::Force sum;
    (void)terms_.add(p, 1.0, TakeForce{sum});
    return sum.force;
}

}  // namespace bspline_curve

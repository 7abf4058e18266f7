// SPDX-License-Identifier: GPL-3.0-or-later
#include "spline/span_moments.h"

namespace bspline_curve {
void SpanMoments::addForcesTo(
    Eigen::VectorXd& gradient,
    const SplineSpace& space,
    int span,
    const SplineSpace::BasisMatrix& basis
) const {
    if (!hasForces_) {
        return;
    }
    for (int j = 0; j < space.basisCount(); ++j) {
        Vec3 sum = Vec3::Zero();
        for (int k = 0; k <= degree_; ++k) {
            sum += basis(j, k) * forces_[k];
        }
        gradient.segment<3>(3 * static_cast<Eigen::Index>(space.control(span, j))) += sum;
    }
}

void SpanMoments::addMatricesTo(
    SpanBlocks& blocks, const SplineSpace::BasisMatrix& basis, int basisCount
) const {
    if (!hasMatrices_) {
        return;
    }
    // The products of two polynomials of the basis are combinations of the powers: moment k + l
    // belongs to coefficients k and l.
    const auto p = static_cast<std::size_t>(degree_);
    const auto addScaled = [](SymmetricMatrix& sum, double scale, const SymmetricMatrix& m) {
        for (std::size_t e = 0; e < m.size(); ++e) {
            sum[e] += scale * m[e];
        }
    };
    for (int j = 0; j < basisCount; ++j) {
        std::array<SymmetricMatrix, kMaxBasis> withJ{};
        for (std::size_t k = 0; k <= p; ++k) {
            for (std::size_t l = 0; l <= p; ++l) {
                addScaled(withJ[k], basis(j, static_cast<int>(l)), matrices_[k + l]);
            }
        }
        for (int i = 0; i <= j; ++i) {
            SymmetricMatrix m{};
            for (std::size_t k = 0; k <= p; ++k) {
                addScaled(m, basis(i, static_cast<int>(k)), withJ[k]);
            }
            blocks[blockIndex(j, i)] += m;
        }
    }
}

}  // namespace bspline_curve

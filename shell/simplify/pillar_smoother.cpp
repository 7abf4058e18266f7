// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/simplify/operations.h"
#include "surface/surface_point.h"

#include <optional>

namespace bspline_curve {
namespace {

// Stars whose worst middle triangle is this good stay.
constexpr double kGoodQuality = 0.9;
// A move has to make the worst triangle better by this factor.
constexpr double kWorthwhile = 1.02;

}  // namespace

void SampledSolver::run() {
    for (int pillar = 0; pillar < editor_.pillarCount(); ++pillar) {
        if (!editor_.isFrozen(pillar) && creases_.degree(pillar) == 0 &&
            editor_.complex().hasPrisms(pillar) && failed_[pillar] < editor_.changed(pillar)) {
            failed_[pillar] = editor_.time();
            solveSampled(pillar);
        }
    }
}

void SampledSolver::solveSampled(int pillar) {
    editor_.proposeStar(pillar);
    const double now = editor_.leastQuality();
    if (now > kGoodQuality) {
        return;
    }
    const PrismComplex& complex = editor_.complex();
    const Pillar before = editor_.pillarAt(pillar);
    Vec3 centre = Vec3::Zero();
    for (const Triangle& pillars : editor_.fresh) {
        const auto k = (cornerOf(pillars, pillar));
        centre += complex.point(pillars[(k + 1) % 3], Level::Middle);
    }
    centre /= static_cast<double>(editor_.fresh.size());
    const Vec3 normal = editor_.meanNormal();
    const double top = (before.top - before.middle).norm();
    const double bottom = (before.bottom - before.middle).norm();
    for (const double share : {1.0, 0.5}) {
        const std::optional<Vec3> middle =
            editor_.onSurface(before.middle + share * (centre - before.middle), normal);
        if (!middle) {
            continue;
        }
        editor_.setPillar(pillar, {*middle - bottom * normal, *middle, *middle + top * normal});
        if (editor_.leastQuality() > kWorthwhile * now && editor_.replace()) {
            return;
        }
        editor_.setPillar(pillar, before);
    }
}

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/paper/paper_variant.h"

#include "solver/paper/control_polygon.h"
#include "solver/paper/finite_differences.h"
#include "solver/paper/paper_settings.h"
#include "solver/paper/pick_penalty.h"

#include <memory>
#include <optional>
#include <vector>

namespace bspline_curve {
namespace {

class PaperVariant final : public SolveVariant {
public:
    [[nodiscard]] std::optional<SplineCurve> firstCurve(
        const CurveProblem& problem, const InitialPath& initialPath
    ) const override {
        return problem.options.initialCurve == InitialCurve::ControlPolygon
                   ? makeControlPolygon(problem)
                   : SolveVariant::firstCurve(problem, initialPath);
    }

    [[nodiscard]] std::vector<SplineSpace::BasisMatrix> bendingProducts(
        const CurveProblem& problem, const SplineSpace& space, const SampleRule& rule
    ) const override {
        return rule.isOfCurve ? differenceProducts(problem, space, rule)
                              : SolveVariant::bendingProducts(problem, space, rule);
    }

    [[nodiscard]] std::vector<std::unique_ptr<SplineTerm>> moreTerms(
        const CurveProblem& problem,
        const SplineSpace& space,
        const std::vector<InterpolationRow>& rows
    ) const override {
        std::vector<std::unique_ptr<SplineTerm>> terms;
        terms.push_back(std::make_unique<PickPenalty>(problem.chordLength, space, rows));
        return terms;
    }

    [[nodiscard]] std::unique_ptr<RoundVariant> rounds(const CurveProblem& problem) const override {
        return std::make_unique<PaperSettings>(problem);
    }
};

}  // namespace

const SolveVariant& paperVariant() {
    static const PaperVariant variant;
    return variant;
}

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#include "spline/spline_sections.h"

#include "bspline_curve/spline.h"
#include "utility/index_sets.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

namespace bspline_curve {

namespace {

bool isCornerAt(const SplineData& spline, double t) {
    const bool isEnd = !spline.closed && (t <= 0.0 || t >= 1.0);
    return spline.degree > 1 && !isEnd && std::ranges::count(spline.knots, t) >= spline.degree;
}

std::ptrdiff_t floorOfRatio(std::ptrdiff_t a, std::ptrdiff_t b) {
    return a >= 0 ? a / b : -((b - 1 - a) / b);
}

/// Open sections one after the other, clamped at both ends of them all.
SplineData chainOf(std::span<const SplineSection> sections) {
    SplineData chain = sections.front().spline;
    chain.closed = false;
    const auto clamp = static_cast<std::ptrdiff_t>(chain.degree) + 1;
    for (const SplineSection& section : sections.subspan(1)) {
        const SplineData& next = section.spline;
        chain.knots.pop_back();
        chain.knots.insert(chain.knots.end(), next.knots.begin() + clamp, next.knots.end());
        Vec3& corner = chain.controlPoints.back();
        corner = 0.5 * (corner + next.controlPoints.front());
        chain.controlPoints.insert(
            chain.controlPoints.end(), next.controlPoints.begin() + 1, next.controlPoints.end()
        );
    }
    return chain;
}

/// The knots in [0, 1), 0 among them, of a closed chain over [a, a + 1].
std::vector<double> knotsOfPeriod(const SplineData& chain) {
    const auto degree = static_cast<std::ptrdiff_t>(chain.degree);
    std::vector<double> period(chain.knots.begin() + 1, chain.knots.end() - degree - 1);
    const auto first = std::ranges::find_if(period, [](double t) { return t >= 0.0; });
    std::for_each(period.begin(), first, [](double& t) { t += 1.0; });
    std::ranges::rotate(period, first);
    if (period.empty() || period.front() > 0.0) {
        period.insert(period.begin(), 0.0);
    }
    return period;
}

/// Of the spans in [0, 1] on which a basis function is not zero, one that is not empty: in the
/// middle, or the last before, or the next.
std::size_t spanOfBasis(const SplineData& closed, std::ptrdiff_t index) {
    const auto degree = static_cast<std::ptrdiff_t>(closed.degree);
    const auto isEmpty = [&](std::ptrdiff_t span) {
        return closed.knots[span] == closed.knots[span + 1];
    };
    const std::ptrdiff_t first = std::max(degree, index);
    std::ptrdiff_t span = std::max(degree, index + degree / 2);
    while (span > first && isEmpty(span)) {
        --span;
    }
    while (isEmpty(span)) {
        ++span;
    }
    return static_cast<std::size_t>(span);
}

SplineData closedSpline(SplineData chain) {
    Vec3& start = chain.controlPoints.front();
    start = chain.controlPoints.back() = 0.5 * (start + chain.controlPoints.back());
    const double end = chain.knots.back();
    const std::vector<double> period = knotsOfPeriod(chain);
    const auto degree = static_cast<std::ptrdiff_t>(chain.degree);
    const std::ptrdiff_t distinct = std::ssize(period);
    SplineData closed;
    closed.degree = chain.degree;
    closed.closed = true;
    for (std::ptrdiff_t j = 0; j < distinct + 2 * degree + 1; ++j) {
        const std::ptrdiff_t i = j - degree;
        const std::ptrdiff_t round = floorOfRatio(i, distinct);
        closed.knots.push_back(period[i - round * distinct] + static_cast<double>(round));
    }
    closed.controlPoints.resize(static_cast<std::size_t>(distinct + degree));
    // From the one at a corner at 0 on: those before are of the end.
    const std::ptrdiff_t first = std::ranges::count(period, 0.0) - 1;
    for (std::ptrdiff_t i = first; i < first + distinct; ++i) {
        const auto span = static_cast<std::ptrdiff_t>(spanOfBasis(closed, i));
        const double middle = 0.5 * (closed.knots[span] + closed.knots[span + 1]);
        const double shift = middle > end ? 1.0 : 0.0;
        std::vector<double> arguments(
            closed.knots.begin() + i + 1, closed.knots.begin() + i + degree + 1
        );
        for (double& t : arguments) {
            t -= shift;
        }
        closed.controlPoints[i] = blossom(chain, spanHolding(chain, middle - shift), arguments);
    }
    for (std::ptrdiff_t i = 0; i < distinct + degree; ++i) {
        if (i < first) {
            closed.controlPoints[i] = closed.controlPoints[i + distinct];
        } else if (i >= first + distinct) {
            closed.controlPoints[i] = closed.controlPoints[i - distinct];
        }
    }
    return closed;
}

/// The knots and control points of a spline; those of a closed one go on for ever.
class Sequence {
public:
    explicit Sequence(const SplineData& spline)
        : spline_(spline),
          degree_(spline.degree),
          period_(std::ssize(spline.controlPoints) - (spline.closed ? degree_ : 0)) {}

    [[nodiscard]] double knot(std::ptrdiff_t index) const {
        const std::ptrdiff_t round = spline_.closed ? floorOfRatio(index, period_) : 0;
        return spline_.knots[index - round * period_] + static_cast<double>(round);
    }

    [[nodiscard]] const Vec3& control(std::ptrdiff_t index) const {
        return spline_
            .controlPoints[spline_.closed ? index - floorOfRatio(index, period_) * period_ : index];
    }

    /// Whether a corner's knots begin at an index.
    [[nodiscard]] bool isCorner(std::ptrdiff_t index) const {
        return knot(index) == knot(index + degree_ - 1);
    }

    /// The last knot of where the first section begins; none where there is no corner.
    [[nodiscard]] std::optional<std::ptrdiff_t> start() const {
        if (!spline_.closed) {
            const bool isClamped = knot(0) == knot(degree_) && isCorner(period_);
            return isClamped ? std::optional(degree_) : std::nullopt;
        }
        for (std::ptrdiff_t first = degree_; first > degree_ - period_; --first) {
            if (isCorner(first)) {
                return first + degree_ - 1;
            }
        }
        return std::nullopt;
    }

    [[nodiscard]] std::vector<SplineSection> sections() const {
        std::vector<SplineSection> sections;
        const std::optional<std::ptrdiff_t> first = start();
        if (!first) {
            return sections;
        }
        // Of the last knot where the last section ends.
        const std::ptrdiff_t end = spline_.closed ? *first + period_ : period_ + degree_ - 1;
        for (std::ptrdiff_t from = *first; from < end;) {
            std::ptrdiff_t to = from + 1;
            while (!isCorner(to)) {
                ++to;
            }
            sections.push_back(between(from, to));
            from = to + degree_ - 1;
        }
        return sections;
    }

private:
    /// From a corner's last knot to the next one's first.
    [[nodiscard]] SplineSection between(std::ptrdiff_t from, std::ptrdiff_t to) const {
        SplineSection section{.from = knot(from), .to = knot(to), .spline = {}};
        section.spline.degree = spline_.degree;
        std::vector<double>& knots = section.spline.knots;
        knots.assign(degree_ + 1, section.from);
        for (std::ptrdiff_t j = from + 1; j < to; ++j) {
            knots.push_back(knot(j));
        }
        knots.insert(knots.end(), degree_ + 1, section.to);
        for (std::ptrdiff_t i = from - degree_; i < to; ++i) {
            section.spline.controlPoints.push_back(control(i));
        }
        return section;
    }

    const SplineData& spline_;
    std::ptrdiff_t degree_, period_;
};

}  // namespace

std::size_t spanHolding(const SplineData& spline, double t) {
    const auto count = static_cast<std::ptrdiff_t>(spline.controlPoints.size());
    const auto first = spline.knots.begin() + spline.degree;
    const auto above = std::upper_bound(first + 1, spline.knots.begin() + count, t);
    return static_cast<std::size_t>(std::prev(above) - spline.knots.begin());
}

Vec3 blossom(const SplineData& spline, std::size_t span, std::span<const double> arguments) {
    const std::size_t degree = arguments.size();
    std::vector<Vec3> points(
        spline.controlPoints.begin() + static_cast<std::ptrdiff_t>(span - degree),
        spline.controlPoints.begin() + static_cast<std::ptrdiff_t>(span + 1)
    );
    for (std::size_t step = 1; step <= degree; ++step) {
        for (std::size_t j = degree; j >= step; --j) {
            const double low = spline.knots[span - degree + j];
            const double high = spline.knots[span + 1 + j - step];
            const double share = (arguments[step - 1] - low) / (high - low);
            points[j] = (1.0 - share) * points[j - 1] + share * points[j];
        }
    }
    return points[degree];
}

SplineData joinedSpline(std::span<const SplineSection> sections, bool closed) {
    SplineData chain = chainOf(sections);
    return closed ? closedSpline(std::move(chain)) : chain;
}

std::vector<SplineSection> sectionsOf(const SplineData& spline) {
    return Sequence(spline).sections();
}

std::vector<int> cornersOf(const SplineData& spline) {
    return indicesWhere<int>(spline.pickParameters.size(), [&](std::size_t i) {
        return isCornerAt(spline, spline.pickParameters[i]);
    });
}

PickTangent directionsAtPick(const SplineData& spline, int pick) {
    const double t = spline.pickParameters[pick];
    PickTangent tangent = PickTangent::along(derivativeOf(spline, t).normalized());
    if (isCornerAt(spline, t)) {
        const double end = t > 0.0 ? t : 1.0;
        for (const BezierPiece& piece : bezierPieces(spline)) {
            if (piece.to == end) {
                const std::vector<Vec3>& points = piece.controlPoints;
                tangent.before = (points.back() - points[points.size() - 2]).normalized();
            }
        }
    }
    return tangent;
}

std::vector<std::pair<int, PickTangent>> tangentsAtPicks(const Curve& curve) {
    std::vector<std::pair<int, PickTangent>> tangents;
    for (const MetTangent& met : curve.report.tangents) {
        PickTangent tangent = directionsAtPick(curve.spline, met.pick);
        if (!met.isBefore) {
            tangent.before.setZero();
        }
        if (!met.isAfter) {
            tangent.after.setZero();
        }
        tangents.emplace_back(met.pick, tangent);
    }
    return tangents;
}

}  // namespace bspline_curve

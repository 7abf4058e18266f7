// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/curve_sections.h"

#include "bspline_curve/curve.h"
#include "spline/spline_sections.h"
#include "utility/index_sets.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace bspline_curve {
namespace {

/// Worse ones are later.
bool isWorse(const SolveReport& a, const SolveReport& b) {
    return std::pair(!a.usable, a.status) > std::pair(!b.usable, b.status);
}

class SectionJoiner {
public:
    SectionJoiner(std::span<const DrawnSection> sections, bool closed)
        : sections_(sections), closed_(closed) {
        std::vector<double> lengths;
        double total = 0.0;
        for (const DrawnSection& section : sections) {
            lengths.push_back(lengthOf(section.curve.polyline));
            total += lengths.back();
            points_ += std::ssize(section.points) - 1;
        }
        points_ += closed ? 0 : 1;
        const DrawnSection& first = sections.front();
        const auto zero = std::ranges::find(first.points, 0);
        const SurfacePolyline& line = first.curve.polyline;
        zeroVertex_ = line.picks[zero - first.points.begin()];
        zero_ = line.parameters[zeroVertex_];
        double from = zeroVertex_ > 0 ? -zero_ * lengths.front() / total : 0.0;
        for (const double length : lengths) {
            bounds_.push_back(from);
            from += length / total;
        }
        bounds_.push_back(bounds_.front() + 1.0);
    }

    [[nodiscard]] Curve join() const {
        Curve curve;
        curve.polyline = polyline();
        curve.spline = spline();
        for (const int vertex : curve.polyline.picks) {
            curve.spline.pickParameters.push_back(curve.polyline.parameters[vertex]);
        }
        curve.report = report(static_cast<int>(curve.spline.knots.size()));
        for (const auto& [points, part] : sections_) {
            curve.shell = curve.shell ? curve.shell : part.shell;
            curve.prisms = std::max(curve.prisms, part.prisms);
            curve.facesPassed += part.facesPassed;
        }
        return curve;
    }

private:
    /// Of the whole curve, where it passes a section's parameter; below 0 before the first pick.
    [[nodiscard]] double parameterOf(std::size_t section, double t) const {
        if (section == 0 && t == zero_) {
            return 0.0;
        }
        const double from = bounds_[section];
        const double to = bounds_[section + 1];
        return t == 1.0 ? to : from + (to - from) * t;
    }

    [[nodiscard]] SurfacePolyline polyline() const {
        SurfacePolyline line;
        line.closed = closed_;
        line.picks.resize(points_);
        for (std::size_t s = 0; s < sections_.size(); ++s) {
            const auto& [points, curve] = sections_[s];
            const SurfacePolyline& part = curve.polyline;
            const int before = static_cast<int>(line.points.size());
            for (std::size_t i = 0; i < points.size(); ++i) {
                line.picks[points[i]] = before + part.picks[i];
            }
            // A corner is the first vertex of the section after it.
            const bool isLast = !closed_ && s + 1 == sections_.size();
            const std::size_t count = part.points.size() - (isLast ? 0 : 1);
            for (std::size_t i = 0; i < count; ++i) {
                line.points.push_back(part.points[i]);
                line.surfacePoints.push_back(part.surfacePoints[i]);
                const double t = parameterOf(s, part.parameters[i]);
                line.parameters.push_back(t < 0.0 ? t + 1.0 : t);
            }
        }
        const auto count = static_cast<int>(line.points.size());
        std::ranges::rotate(line.points, line.points.begin() + zeroVertex_);
        std::ranges::rotate(line.surfacePoints, line.surfacePoints.begin() + zeroVertex_);
        std::ranges::rotate(line.parameters, line.parameters.begin() + zeroVertex_);
        for (int& vertex : line.picks) {
            vertex = (vertex - zeroVertex_ + count) % count;
        }
        return line;
    }

    [[nodiscard]] SplineData spline() const {
        std::vector<SplineSection> parts;
        for (std::size_t s = 0; s < sections_.size(); ++s) {
            SplineSection part{
                .from = bounds_[s], .to = bounds_[s + 1], .spline = sections_[s].curve.spline
            };
            part.spline.pickParameters.clear();
            for (double& knot : part.spline.knots) {
                knot = parameterOf(s, knot);
            }
            parts.push_back(std::move(part));
        }
        return joinedSpline(parts, closed_);
    }

    [[nodiscard]] SolveReport report(int knots) const {
        const auto reportOf = [](const DrawnSection& section) -> const SolveReport& {
            return section.curve.report;
        };
        const SolveReport& worst = reportOf(
            *std::ranges::max_element(sections_, [&](const DrawnSection& a, const DrawnSection& b) {
                return isWorse(reportOf(b), reportOf(a));
            })
        );
        SolveReport all;
        all.status = worst.status;
        all.usable = worst.usable;
        all.farPart = farPart();
        all.isSampled = true;
        all.allowedDistance = worst.allowedDistance;
        for (std::size_t s = 0; s < sections_.size(); ++s) {
            addTo(all, reportOf(sections_[s]), bounds_[s + 1] - bounds_[s]);
        }
        // Sections share the knots of corners.
        int knotsOfSections = 0;
        for (const DrawnSection& section : sections_) {
            knotsOfSections += static_cast<int>(section.curve.spline.knots.size());
        }
        all.knotsFirst += knots - knotsOfSections;
        all.knotsLast = knots;
        return all;
    }

    /// `share`: of the parameters.
    static void addTo(SolveReport& all, const SolveReport& part, double share) {
        all.knotsFirst += part.knotsFirst;
        all.isSampled = all.isSampled && part.isSampled;
        all.maxDistance = std::max(all.maxDistance, part.maxDistance);
        all.maxPickGap = std::max(all.maxPickGap, part.maxPickGap);
        all.newtonIterations += part.newtonIterations;
        all.fieldShare = std::min(all.fieldShare, part.fieldShare);
        all.fieldCost += share * part.fieldCost;
        all.fieldAtRest = all.fieldAtRest && part.fieldAtRest;
        const auto rounds = static_cast<int>(all.rounds.size());
        all.rounds.insert(all.rounds.end(), part.rounds.begin(), part.rounds.end());
        for (IterationReport iteration : part.iterations) {
            iteration.round += rounds;
            all.iterations.push_back(iteration);
        }
        all.seconds.path += part.seconds.path;
        all.seconds.initial += part.seconds.initial;
        all.seconds.minimise += part.seconds.minimise;
        all.seconds.knots += part.seconds.knots;
        all.seconds.polyline += part.seconds.polyline;
        all.seconds.failedAttempts += part.seconds.failedAttempts;
        all.seconds.shell += part.seconds.shell;
    }

    /// From the first to the last of those of the sections.
    [[nodiscard]] std::optional<FarPart> farPart() const {
        std::optional<FarPart> all;
        for (std::size_t s = 0; s < sections_.size(); ++s) {
            const std::optional<FarPart>& part = sections_[s].curve.report.farPart;
            if (!part) {
                continue;
            }
            double from = parameterOf(s, part->from);
            double to = parameterOf(s, part->to);
            if (from < 0.0 && to >= 0.0) {
                from = 0.0;
                to = 1.0;
            } else if (from < 0.0) {
                from += 1.0;
                to += 1.0;
            }
            if (!all) {
                all = FarPart{from, to, {}};
            }
            all->from = std::min(all->from, from);
            all->to = std::max(all->to, to);
            all->faces.insert(all->faces.end(), part->faces.begin(), part->faces.end());
        }
        if (all) {
            sortUnique(all->faces);
        }
        return all;
    }

    std::span<const DrawnSection> sections_;
    bool closed_;
    std::ptrdiff_t points_ = 0;
    int zeroVertex_ = 0;          // of the first section, where the whole curve begins
    double zero_ = 0.0;           // its parameter there
    std::vector<double> bounds_;  // parameters of the corners, and of the ends
};

/// A section as a curve of its own; empty where the picks at its ends are not where it ends.
Curve curveOfSection(const Curve& whole, std::span<const int> points, SplineSection part) {
    constexpr double kSameParameter = 1e-9;
    const SurfacePolyline& line = whole.polyline;
    const auto count = static_cast<int>(line.points.size());
    const int first = line.picks[points.front()];
    int last = line.picks[points.back()];
    last += last <= first ? count : 0;
    const auto parameterOf = [&](double t) {
        return t == part.from ? 0.0 : t == part.to ? 1.0 : (t - part.from) / (part.to - part.from);
    };
    Curve section;
    for (int i = first; i <= last; ++i) {
        const int vertex = i % count;
        const double t = line.parameters[vertex] - (part.from < 0.0 && i < count ? 1.0 : 0.0);
        section.polyline.points.push_back(line.points[vertex]);
        section.polyline.surfacePoints.push_back(line.surfacePoints[vertex]);
        section.polyline.parameters.push_back(i == first ? 0.0 : i == last ? 1.0 : parameterOf(t));
    }
    const auto isAt = [&](double bound, int vertex) {
        const double gap = line.parameters[vertex % count] - bound;
        return std::abs(gap - std::round(gap)) < kSameParameter;
    };
    if (!isAt(part.from, first) || !(isAt(part.to, last))) {
        return {};
    }
    for (const int point : points) {
        const int vertex = line.picks[point] - first;
        section.polyline.picks.push_back(vertex < 0 ? vertex + count : vertex);
    }
    section.polyline.picks.back() = last - first;
    section.spline = std::move(part.spline);
    for (double& knot : section.spline.knots) {
        knot = parameterOf(knot);
    }
    for (const int vertex : section.polyline.picks) {
        section.spline.pickParameters.push_back(section.polyline.parameters[vertex]);
    }
    section.report.isSampled = whole.report.isSampled;
    section.report.rounds = whole.report.rounds;
    return section;
}

}  // namespace

std::vector<std::vector<int>> pointsOfSections(
    int count, std::span<const int> corners, bool closed
) {
    std::vector<int> bounds(corners.begin(), corners.end());
    if (closed) {
        if (bounds.empty()) {
            return {};
        }
        const bool isAtStart = bounds.front() == 0;
        bounds.insert(
            isAtStart ? bounds.end() : bounds.begin(), isAtStart ? count : bounds.back() - count
        );
    } else {
        bounds.insert(bounds.end(), {0, count - 1});
        sortUnique(bounds);
        if (bounds.size() == 2) {
            return {};
        }
    }
    std::vector<std::vector<int>> sections;
    for (std::size_t i = 0; i + 1 < bounds.size(); ++i) {
        std::vector<int>& points = sections.emplace_back();
        for (int point = bounds[i]; point <= bounds[i + 1]; ++point) {
            points.push_back((point + count) % count);
        }
    }
    return sections;
}

Curve joinedCurve(std::span<const DrawnSection> sections, bool closed) {
    return SectionJoiner(sections, closed).join();
}

std::vector<Curve> sectionsOfCurve(
    const Curve& whole, std::span<const std::vector<int>> pointsOfEach
) {
    std::vector<SplineSection> splines = sectionsOf(whole.spline);
    std::vector<Curve> sections;
    for (std::size_t s = 0; s < pointsOfEach.size() && s < splines.size(); ++s) {
        sections.push_back(curveOfSection(whole, pointsOfEach[s], std::move(splines[s])));
    }
    const bool isParted = splines.size() == pointsOfEach.size() &&
                          std::ranges::none_of(sections, [](const Curve& section) {
                              return section.polyline.points.empty();
                          });
    return isParted ? sections : std::vector<Curve>();
}

}  // namespace bspline_curve

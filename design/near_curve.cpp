// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/near_curve.h"

#include "bspline_curve/progress.h"
#include "design/solved_curve.h"
#include "solver/obstacles.h"
#include "surface/segment_distance.h"
#include "surface/surface_point.h"
#include "utility/index_sets.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace bspline_curve {
namespace {

struct NearConstants {
    /// Of a tolerance, for the path: the rest is for the spline beside it and the projection.
    double pathShare = 0.93;
    /// A path keeps its bounds along the surface. Where it is farther from a pick in space than
    /// this share of the tolerance, since faces are large and the surface curved, the bound
    /// shrinks, so many times, at last to nothing; and where there is no path within the bounds
    /// they are halved.
    double mostPathShare = 0.97;
    int mostPaths = 5;
    /// Of the progress, for the path, and for each curve along it.
    double fairedShare = 0.2, drawnShare = 0.5;
    /// Curves along the path, each through more of its points.
    int mostDrawn = 8;
};

constexpr NearConstants kNear;

class NearCurveMaker {
public:
    NearCurveMaker(const LocatedTask& task, std::span<const PickLeeway> leeways)
        : task_(task), leeways_(leeways) {
        for (const SurfacePoint& pick : task.picks) {
            positions_.push_back(task.prepared.surface().position(pick));
        }
    }

    [[nodiscard]] std::optional<NearCurve> make(const Progress& progress) const {
        const CurveSolver solver = task_.solver();
        const std::optional<PickPath> path = pathWithin(solver);
        if (!path) {
            return std::nullopt;
        }
        std::vector<int> passed = {0};
        for (std::size_t i = 0; i < task_.context.tangents.size(); ++i) {
            if (!task_.context.tangents[i].isZero(0.0)) {
                passed.push_back(static_cast<int>(i));
            }
        }
        if (!task_.options.closed) {
            passed.push_back(static_cast<int>(task_.picks.size()) - 1);
        }
        sortUnique(passed);
        const Progress rest = partOf(progress, kNear.fairedShare, kNear.drawnShare);
        for (int i = 0; i < kNear.mostDrawn; ++i) {
            std::optional<Solved> solved =
                solver.solveAlong(*path, passed, stepOf(rest, i, kNear.mostDrawn));
            if (!solved) {
                break;
            }
            NearCurve drawn = finished(*std::move(solved));
            const std::vector<int> missed = missedBy(drawn.curve);
            if (missed.empty()) {
                return drawn;
            }
            const std::size_t before = passed.size();
            for (const int pick : missed) {
                if (isApart(*path, passed, pick)) {
                    passed.insert(std::ranges::upper_bound(passed, pick), pick);
                }
            }
            if (passed.size() == before) {
                break;
            }
        }
        return throughAll(*path, partOf(progress, kNear.drawnShare, 1.0));
    }

private:
    // A path near all picks; nothing where there is none.
    [[nodiscard]] std::optional<PickPath> pathWithin(const CurveSolver& solver) const {
        const double scale = task_.prepared.extended()->frame.scale;
        std::vector<PickLeeway> leeways;
        for (const auto& [bound, weight] : leeways_) {
            leeways.push_back({kNear.pathShare * bound / scale, weight * scale * scale});
        }
        for (int i = 0; i < kNear.mostPaths; ++i) {
            std::optional<PickPath> path = solver.pathNear(leeways);
            if (!path) {
                for (PickLeeway& leeway : leeways) {
                    leeway.bound *= 0.5;
                }
                // Over a boundary it is mostly the ends that leave the surface.
                leeways.front().bound = leeways.back().bound = 0.0;
                continue;
            }
            bool isWithin = true;
            for (std::size_t k = 0; k < task_.picks.size(); ++k) {
                const Vec3 point = task_.prepared.surface().position(path->picks[k].point);
                const double distance = (point - positions_[k]).norm();
                if (leeways[k].bound > 0.0 && distance > kNear.mostPathShare * leeways_[k].bound) {
                    isWithin = false;
                    const bool isLast = i + 2 >= kNear.mostPaths;
                    leeways[k].bound *=
                        isLast ? 0.0 : kNear.pathShare * leeways_[k].bound / distance;
                }
            }
            if (isWithin) {
                return path;
            }
        }
        return std::nullopt;
    }

    // Whether a pick's point of the path is none that the curve passes.
    [[nodiscard]] static bool isApart(
        const PickPath& path, const std::vector<int>& passed, int pick
    ) {
        return std::ranges::none_of(passed, [&](int other) {
            return path.picks[other].parameter == path.picks[pick].parameter;
        });
    }

    [[nodiscard]] NearCurve finished(Solved solved) const {
        NearCurve drawn{{}, std::move(solved)};
        drawn.curve = curveOf(task_.prepared.surface(), drawn.solved, task_.sampling);
        return drawn;
    }

    [[nodiscard]] std::vector<int> missedBy(const Curve& curve) const {
        const std::vector<double> distances = distancesTo(curve.polyline, positions_);
        return indicesWhere<int>(distances.size(), [&](std::size_t i) {
            return distances[i] > leeways_[i].bound;
        });
    }

    // Through the path's points at all picks; where they are to be avoided, the pick itself.
    [[nodiscard]] std::optional<NearCurve> throughAll(
        const PickPath& path, const Progress& progress
    ) const {
        std::vector<SurfacePoint> points;
        std::vector<std::size_t> pointOf;
        std::vector<Vec3> tangents;
        for (std::size_t i = 0; i < task_.picks.size(); ++i) {
            if (i == 0 || path.picks[i].parameter != path.picks[i - 1].parameter) {
                const SurfacePoint& point = path.picks[i].point;
                const bool isClear = task_.context.obstacles == nullptr ||
                                     task_.context.obstacles->closeness(point) < 1.0;
                points.push_back(isClear ? point : task_.picks[i]);
                tangents.push_back(path.picks[i].tangent);
            }
            pointOf.push_back(points.size() - 1);
        }
        if (points.size() < (task_.options.closed ? 3U : 2U)) {
            return std::nullopt;
        }
        DesignContext context = task_.context;
        context.tangents = task_.context.tangents.empty() ? std::span<const Vec3>() : tangents;
        const LocatedTask same = {
            task_.prepared, points, task_.options, task_.sampling, context, task_.side
        };
        const CurveSolver solver = same.solver();
        Solved solved = solver.solve(progress);
        if (!solved.solution.report.usable) {
            return std::nullopt;
        }
        for (const std::size_t point : pointOf) {
            solved.problem.nearParameters.push_back(solved.problem.picks[point].parameter);
        }
        NearCurve drawn = finished(std::move(solved));
        return missedBy(drawn.curve).empty() ? std::optional(std::move(drawn)) : std::nullopt;
    }

    LocatedTask task_;
    std::span<const PickLeeway> leeways_;
    std::vector<Vec3> positions_;  // of the picks, user's unit
};

}  // namespace

std::optional<NearCurve> drawNear(
    const LocatedTask& task, std::span<const PickLeeway> leeways, const Progress& progress
) {
    return NearCurveMaker(task, leeways).make(progress);
}

std::vector<double> distancesTo(const SurfacePolyline& line, std::span<const Vec3> points) {
    std::vector<double> distances;
    const std::size_t count = line.points.size();
    const std::size_t segments = count - (line.closed ? 0 : 1);
    for (const Vec3& point : points) {
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < segments; ++i) {
            least = std::min(
                least, distanceToSegment(point, line.points[i], line.points[(i + 1) % count])
            );
        }
        distances.push_back(least);
    }
    return distances;
}

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/fitted_path.h"

#include "design/close_chords.h"
#include "design/surface_walk.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace bspline_curve {
namespace {

struct PathConstants {
    /// Nodes of the wave that is flattened, for the path.
    double nodesOfWave = 8.0;
    int leastNodes = 24;  // of each section
    /// The spread is reached where it differs by no more than this factor, or after so many tries.
    double nearFactor = 1.01;
    int mostTries = 20;
    /// Corners are looked for so often: with those that are found the line bends less elsewhere,
    /// and more is flattened.
    int mostSearches = 8;
    /// In wavelengths: as long are the waves that are flattened while corners are looked for. What
    /// turns at the wavelength itself may be noise.
    double cornerWaves = 1.5;
};

constexpr PathConstants kPath;

// The wavelength at which the spread is as wished; the spread grows with it.
void smoothTo(LineSmoother& smoother, const FitTarget& target, double first) {
    double low = target.shortest;
    double high = target.longest;
    double wavelength = std::clamp(first, low, high);
    for (int i = 0; i < kPath.mostTries; ++i) {
        const double ratio = target.spread / smoother.smooth(wavelength);
        if (ratio <= kPath.nearFactor && ratio * kPath.nearFactor >= 1.0) {
            break;
        }
        const bool isAtBound = wavelength == (ratio > 1.0 ? target.longest : target.shortest);
        (ratio > 1.0 ? low : high) = wavelength;
        if (low >= high || isAtBound) {
            break;
        }
        // About as the wavelength does, or by halves.
        const double next = wavelength * std::clamp(ratio, 0.25, 4.0);
        const bool isInside = next > low && next < high;
        const bool isAbove = high == target.longest && next >= high;
        const bool isBelow = low == target.shortest && next <= low;
        wavelength = isInside ? next : (isAbove ? high : (isBelow ? low : std::sqrt(low * high)));
    }
}

// The same with corners.
void smoothWithCorners(LineSmoother& smoother, const FitTarget& target) {
    smoothTo(smoother, target, target.wavelength);
    if (target.cornerAngle >= std::numbers::pi) {
        return;
    }
    double wavelength = smoother.wavelength();
    for (int i = 0; i < kPath.mostSearches; ++i) {
        smoother.smooth(std::max(target.cornerWave, kPath.cornerWaves * wavelength));
        if (!smoother.addCorners(target.cornerAngle)) {
            break;
        }
        smoothTo(smoother, target, wavelength);
        wavelength = smoother.wavelength();
    }
    smoother.smooth(wavelength);
    while (smoother.removeCorners(target.cornerAngle)) {
        smoothTo(smoother, target, smoother.wavelength());
    }
}

class PathMaker {
public:
    PathMaker(
        const ExtendedSurface& extended,
        const PatchLevels* patches,
        const MeasuredLine& line,
        const LineSmoother& smoother
    )
        : extended_(extended),
          patches_(patches),
          line_(line),
          smoother_(smoother),
          finder_(extended, patches) {}

    [[nodiscard]] std::optional<FittedPath> make(double chordDistance) const {
        FittedPath fitted{{}, smoother_.turns(), smoother_.spread(), smoother_.wavelength()};
        std::vector<double> bounds = smoother_.corners();
        const bool isRound = line_.closed && bounds.empty();
        if (!line_.closed || isRound) {
            bounds.insert(bounds.begin(), 0.0);
            bounds.push_back(1.0);
        } else {
            bounds.push_back(bounds.front() + 1.0);
        }
        std::vector<SurfaceNode> stops;
        for (std::size_t i = 0; i + 1 < bounds.size(); ++i) {
            stops.push_back(footAt(bounds[i]));
        }
        stops.push_back(line_.closed ? stops.front() : nodeAt(line_.path.points.back()));
        if (!line_.closed) {
            stops.front() = nodeAt(line_.path.points.front());
        }
        for (std::size_t i = 0; i + 1 < bounds.size(); ++i) {
            std::optional<InitialPath> section =
                between(bounds[i], stops[i], bounds[i + 1], stops[i + 1], chordDistance);
            if (!section) {
                return std::nullopt;
            }
            fitted.sections.push_back(*std::move(section));
        }
        return fitted;
    }

private:
    [[nodiscard]] SurfaceNode footAt(double parameter) const {
        const double own = withinOne(parameter);
        SurfaceNode node;
        node.foot = FootPoint::at(line_.path.points[line_.path.indexAt(own)].point);
        finder_.move(smoother_.positionAt(own), node.foot, node.frame);
        node.foot.height = 0.0;
        node.position = extended_.position({node.foot.face, node.foot.barycentric()});
        return node;
    }

    [[nodiscard]] SurfaceNode nodeAt(const InitialPath::Point& end) const {
        SurfaceNode node;
        node.foot = FootPoint::at(end.point);
        finder_.move(end.position, node.foot, node.frame);
        node.foot = FootPoint::at(end.point);
        node.position = end.position;
        return node;
    }

    // A parameter of a closed line, once round.
    [[nodiscard]] static double withinOne(double parameter) {
        return parameter > 1.0 ? parameter - 1.0 : parameter;
    }

    [[nodiscard]] bool isOnSurface(const SurfaceNode& node) const {
        return node.foot.face < extended_.surfaceFaceCount;
    }

    [[nodiscard]] bool follows(const SurfaceNode& before, const SurfaceNode& node) const {
        return isOnSurface(node) && areJoined(extended_, finder_, before, node);
    }

    // Where the foot of the smooth line jumps to another part of the surface, at a fold, the line's
    // own point takes its place.
    [[nodiscard]] std::optional<InitialPath> between(
        double from,
        const SurfaceNode& first,
        double to,
        const SurfaceNode& last,
        double chordDistance
    ) const {
        const double waves = (to - from) * line_.path.length() / smoother_.wavelength();
        const int segments =
            std::max(kPath.leastNodes, static_cast<int>(std::lround(kPath.nodesOfWave * waves)));
        std::vector<SurfacePoint> points;
        SurfaceNode before;
        for (int i = 0; i <= segments; ++i) {
            const double parameter = std::lerp(from, to, static_cast<double>(i) / segments);
            const bool isBetween = i > 0 && i < segments;
            SurfaceNode node = i == 0 ? first : (isBetween ? footAt(parameter) : last);
            bool goesOn = i == 0 ? isOnSurface(node) : follows(before, node);
            if (!goesOn && isBetween) {
                node = nodeAt(line_.path.points[line_.path.indexAt(withinOne(parameter))]);
                goesOn = follows(before, node);
            }
            if (!goesOn) {
                return std::nullopt;
            }
            points.push_back(node.foot.surfacePoint());
            before = node;
        }
        const auto close = withCloseChords(extended_, patches_, points, chordDistance);
        return close ? pathThrough(*close) : std::nullopt;
    }

    // Nothing where it has no length.
    [[nodiscard]] std::optional<InitialPath> pathThrough(
        const std::vector<SurfacePoint>& points
    ) const {
        InitialPath path;
        double way = 0.0;
        for (const SurfacePoint& point : points) {
            const Vec3 position = extended_.position(point);
            way += path.points.empty() ? 0.0 : (position - path.points.back().position).norm();
            path.points.push_back({way, point, position});
        }
        if (!(way > 0.0)) {
            return std::nullopt;
        }
        for (InitialPath::Point& point : path.points) {
            point.parameter /= way;
        }
        path.points.back().parameter = 1.0;
        return path;
    }

    const ExtendedSurface& extended_;
    const PatchLevels* patches_;
    const MeasuredLine& line_;
    const LineSmoother& smoother_;
    FibreProjector finder_;
};

}  // namespace

std::optional<FittedPath> fittedPath(
    const ExtendedSurface& extended,
    const PatchLevels* patches,
    const MeasuredLine& line,
    const FitTarget& target
) {
    LineSmoother smoother(extended, line, target.shortest, target.stiffness);
    smoothWithCorners(smoother, target);
    return PathMaker(extended, patches, line, smoother).make(target.chordDistance);
}

}  // namespace bspline_curve

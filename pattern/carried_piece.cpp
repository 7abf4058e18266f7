// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/carried_piece.h"

#include "design/curve_designer.h"
#include "offset/face_layout.h"
#include "surface/segment_distance.h"
#include "surface/surface.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <utility>

namespace bspline_curve {

namespace {

using Vec2 = Eigen::Vector2d;

/// Samples of an arc: enough to see it bend, and a bound on what fine meshes ask for.
constexpr int kLeastPerCurve = 12;
constexpr int kMostPerArc = 256;
/// Arcs between samples are this many tolerances from their chords at most; curves through samples
/// are much nearer to them.
constexpr double kBowPerTolerance = 4.0;
/// Samples of a piece, at least.
constexpr int kLeastPerPiece = 12;
/// Chords that the length of a part of an arc is the sum of.
constexpr int kChords = 16;
/// Picks that a drawing has at first where it turns by this angle.
constexpr double kFirstTurn = std::numbers::pi / 5;
/// Curves that are drawn until one is within the tolerance, at most.
constexpr int kMostPieceRounds = 10;
/// Vertices of a polyline between two picks, besides its crossings.
constexpr int kVerticesPerPick = 8;

/// A bound on how far an arc is from its chords where it is cut into `count` parts, times
/// count^2 (G. Wang 1984, for polynomials; weights that differ little change it little).
double bowOf(const DrawingArc& arc) {
    double largest = 0.0;
    const std::vector<Vec2>& points = arc.points;
    for (std::size_t i = 2; i < points.size(); ++i) {
        largest = std::max(largest, (points[i] - 2.0 * points[i - 1] + points[i - 2]).norm());
    }
    const auto degree = static_cast<double>(points.size() - 1);
    return degree * (degree - 1.0) / 8.0 * largest;
}

double lengthOf(const DrawingArc& arc, double from, double to) {
    if (arc.isLine()) {
        return (to - from) * (arc.points[1] - arc.points[0]).norm();
    }
    double length = 0.0;
    Vec2 last = arc.at(from);
    for (int i = 1; i <= kChords; ++i) {
        const Vec2 next = arc.at(from + (to - from) * i / kChords);
        length += (next - last).norm();
        last = next;
    }
    return length;
}

/// Draws a piece through more and more of its samples.
class PieceDrawer {
public:
    PieceDrawer(const CurveDesigner& designer, const CarriedPiece& piece, double tolerance)
        : designer_(designer),
          piece_(piece),
          tolerance_(tolerance),
          edge_(designer.surface().averageEdgeLength()) {}

    DrawnPiece draw() {
        choosePicks();
        for (int round = 1;; ++round) {
            drawThroughPicks();
            const std::vector<std::size_t> added = strayingSamples();
            if (added.empty() || round == kMostPieceRounds) {
                break;
            }
            picks_.insert(picks_.end(), added.begin(), added.end());
            std::ranges::sort(picks_);
        }
        measureDistortions();
        return std::move(drawn_);
    }

private:
    [[nodiscard]] const PieceSample& sample(std::size_t index) const {
        return piece_.samples[index % piece_.samples.size()];
    }

    [[nodiscard]] bool areApart(std::size_t a, std::size_t b) const {
        return (sample(a).position - sample(b).position).norm() >
               kSamePointRelative * designer_.surface().diagonal();
    }

    /// The ends, and where the drawing has turned.
    void choosePicks() {
        const std::size_t count = piece_.samples.size();
        picks_ = {0};
        double turn = 0.0;
        for (std::size_t i = 1; i + 1 < count; ++i) {
            turn += std::abs(angleBetween(
                sample(i).planar - sample(i - 1).planar, sample(i + 1).planar - sample(i).planar
            ));
            if (turn >= kFirstTurn && areApart(i, picks_.back()) && areApart(i, count - 1)) {
                picks_.push_back(i);
                turn = 0.0;
            }
        }
        if (!piece_.closed) {
            picks_.push_back(count - 1);
        } else if (picks_.size() < 3) {
            picks_ = {0, count / 3, 2 * count / 3};
        }
    }

    void drawThroughPicks() {
        std::vector<Vec3> through;
        for (const std::size_t pick : picks_) {
            through.push_back(sample(pick).position);
        }
        SolverOptions options;
        options.closed = piece_.closed;
        const SamplingOptions sampling{
            .samples = kVerticesPerPick * static_cast<int>(picks_.size())
        };
        drawn_.curve = designer_.design(through, options, sampling);
    }

    /// Calls visit(first sample, last sample, first vertex, last vertex) between picks. Numbers
    /// past the end of a closed curve go round it.
    template <class Visit>
    void forEachPart(const Visit& visit) const {
        const SurfacePolyline& line = drawn_.curve.polyline;
        for (std::size_t i = 0; i < picks_.size(); ++i) {
            const bool isLast = i + 1 == picks_.size();
            if (isLast && !piece_.closed) {
                return;
            }
            visit(
                picks_[i],
                isLast ? piece_.samples.size() : picks_[i + 1],
                static_cast<std::size_t>(line.picks[i]),
                isLast ? line.points.size() : static_cast<std::size_t>(line.picks[i + 1])
            );
        }
    }

    [[nodiscard]] const Vec3& vertex(std::size_t index) const {
        const std::vector<Vec3>& points = drawn_.curve.polyline.points;
        return points[index % points.size()];
    }

    [[nodiscard]] double distanceTo(const Vec3& point, std::size_t from, std::size_t to) const {
        double least = (vertex(from) - point).norm();
        for (std::size_t v = from; v < to; ++v) {
            least = std::min(least, distanceToSegment(point, vertex(v), vertex(v + 1)));
        }
        return least;
    }

    /// Of each part the sample that is farthest from the curve, where it is too far and another
    /// pick would help.
    std::vector<std::size_t> strayingSamples() {
        std::vector<std::size_t> straying;
        drawn_.deviation = 0.0;
        forEachPart([&](std::size_t first, std::size_t last, std::size_t from, std::size_t to) {
            double worst = 0.0;
            std::size_t farthest = first;
            for (std::size_t i = first + 1; i < last; ++i) {
                const double distance = distanceTo(sample(i).position, from, to);
                if (distance > worst) {
                    worst = distance;
                    farthest = i;
                }
            }
            drawn_.deviation = std::max(drawn_.deviation, worst);
            if (worst > tolerance_ && areApart(farthest, first) && areApart(farthest, last) &&
                isWorthAPick(first, farthest, last)) {
                straying.push_back(farthest);
            }
        });
        return straying;
    }

    /// Picks follow the drawing however near they come to each other, but not what single edges and
    /// vertices of the surface do to it.
    [[nodiscard]] bool isWorthAPick(std::size_t first, std::size_t middle, std::size_t last) const {
        const Vec2& at = sample(middle).planar;
        const double toFirst = (at - sample(first).planar).norm();
        const double toLast = (at - sample(last).planar).norm();
        return std::min(toFirst, toLast) >= edge_ ||
               distanceToSegment(at, sample(first).planar, sample(last).planar) > tolerance_;
    }

    void measureDistortions() {
        forEachPart([&](std::size_t first, std::size_t last, std::size_t from, std::size_t to) {
            double length = 0.0;
            for (std::size_t v = from; v < to; ++v) {
                length += (vertex(v + 1) - vertex(v)).norm();
            }
            const double end = last == piece_.samples.size() ? piece_.length : sample(last).along;
            drawn_.distortions.push_back(
                {.ratio = length / (end - sample(first).along),
                 .position = vertex(std::midpoint(from, to))}
            );
        });
    }

    const CurveDesigner& designer_;
    const CarriedPiece& piece_;
    double tolerance_;
    double edge_;
    std::vector<std::size_t> picks_;  // samples, ascending
    DrawnPiece drawn_;
};

}  // namespace

CarriedPiece samplesOf(const SmoothPiece& piece, double spacing, double tolerance) {
    CarriedPiece result{.samples = {}, .closed = piece.closed};
    const auto arcs = static_cast<int>(piece.arcs.size());
    const int leastPerLine = std::max(1, kLeastPerPiece / arcs);
    for (int a = 0; a < arcs; ++a) {
        const DrawingArc& arc = piece.arcs[a];
        const int least = arc.isLine() ? leastPerLine : kLeastPerCurve;
        const double bySpacing = lengthOf(arc, 0.0, 1.0) / spacing;
        const double byBow = std::sqrt(bowOf(arc) / (kBowPerTolerance * tolerance));
        const int count = static_cast<int>(
            std::clamp<double>(std::ceil(std::max(bySpacing, byBow)), least, kMostPerArc)
        );
        for (int i = 0; i < count; ++i) {
            const double share = 1.0 / count;
            result.samples.push_back({.planar = piece.at(a + i * share), .along = result.length});
            result.length += lengthOf(arc, i * share, (i + 1) * share);
        }
    }
    if (!piece.closed) {
        result.samples.push_back({.planar = piece.at(arcs), .along = result.length});
    }
    return result;
}

DrawnPiece drawnPiece(const CurveDesigner& designer, const CarriedPiece& piece, double tolerance) {
    return PieceDrawer(designer, piece, tolerance).draw();
}

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/warm_start.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

namespace bspline_curve {
namespace {

// Times the length of a piece, before or after.
constexpr double kLargestStretch = 2.0;

// The part of a curve between two picks.
struct Piece {
    double begin, end;         // parameters before
    std::size_t first, last;   // points of the polyline
    Vec3 firstMove, lastMove;  // of its picks, in the shell's frame
    double length = 0.0, newLength = 0.0;
    double newBegin = 0.0, newEnd = 0.0;

    // Between two values at its ends.
    template <class Value>
    [[nodiscard]] Value between(double parameter, const Value& from, const Value& to) const {
        const double s = (parameter - begin) / (end - begin);
        return (1.0 - s) * from + s * to;
    }

    [[nodiscard]] Vec3 move(double parameter) const {
        return between(parameter, firstMove, lastMove);
    }

    [[nodiscard]] double newParameter(double parameter) const {
        return between(parameter, newBegin, newEnd);
    }
};

class WarmStartMaker {
public:
    WarmStartMaker(
        const Curve& curve, const ExtendedSurface& extended, const std::vector<SurfacePoint>& picks
    )
        : curve_(curve), extended_(extended), picks_(picks) {
        const SurfacePolyline& line = curve.polyline;
        for (std::size_t i = 0; i < line.points.size(); ++i) {
            const SurfacePoint& point = line.surfacePoints[i];
            points_.push_back({line.parameters[i], point, extended.position(point)});
        }
        if (line.closed) {
            points_.push_back(points_.front());
            points_.back().parameter = 1.0;
        }
        addPieces();
    }

    [[nodiscard]] bool isSmall() const {
        return std::ranges::all_of(pieces_, [](const Piece& piece) {
            return piece.newLength < kLargestStretch * piece.length &&
                   piece.length < kLargestStretch * piece.newLength;
        });
    }

    WarmStart result() {
        setParameters();
        return {newPath(), newSpline()};
    }

private:
    [[nodiscard]] Vec3 positionIn(const Piece& piece, std::size_t i) const {
        return points_[i].position + piece.move(points_[i].parameter);
    }

    void addPieces() {
        const std::vector<int>& vertices = curve_.polyline.picks;
        const std::size_t count = curve_.polyline.closed ? picks_.size() : picks_.size() - 1;
        const auto moveOf = [&](std::size_t pick) -> Vec3 {
            return extended_.position(picks_[pick]) - points_[vertices[pick]].position;
        };
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t next = (i + 1) % picks_.size();
            Piece piece;
            piece.first = vertices[i];
            piece.last = next == 0 ? points_.size() - 1 : vertices[next];
            piece.begin = points_[piece.first].parameter;
            piece.end = points_[piece.last].parameter;
            piece.firstMove = moveOf(i);
            piece.lastMove = moveOf(next);
            for (std::size_t k = piece.first; k < piece.last; ++k) {
                piece.length += (points_[k + 1].position - points_[k].position).norm();
                piece.newLength += (positionIn(piece, k + 1) - positionIn(piece, k)).norm();
            }
            pieces_.push_back(piece);
        }
    }

    void setParameters() {
        double sum = 0.0;
        for (Piece& piece : pieces_) {
            piece.newBegin = sum;
            sum += (piece.end - piece.begin) * (piece.newLength / piece.length);
            piece.newEnd = sum;
        }
        for (Piece& piece : pieces_) {
            piece.newBegin /= sum;
            piece.newEnd /= sum;
        }
        pieces_.back().newEnd = 1.0;
    }

    [[nodiscard]] PickPath newPath() const {
        PickPath path;
        for (std::size_t i = 0; i < picks_.size(); ++i) {
            const double t = i < pieces_.size() ? pieces_[i].newBegin : 1.0;
            path.picks.push_back({picks_[i], extended_.position(picks_[i]), t});
        }
        for (const Piece& piece : pieces_) {
            for (std::size_t i = piece.first; i <= piece.last; ++i) {
                const InitialPath::Point& point = points_[i];
                path.path.points.push_back(
                    {piece.newParameter(point.parameter), point.point, positionIn(piece, i)}
                );
            }
        }
        path.path.points.back().parameter = 1.0;
        return path;
    }

    // A control point moves as the curve does where its basis function is largest, or nearly so: at
    // the mean of the knots inside (Greville's abscissa).
    [[nodiscard]] SplineCurve newSpline() const {
        const SplineData& spline = curve_.spline;
        SplineSpace space(spline.degree, spline.closed, newBreaks());
        ControlPoints controls(space.controlCount(), 3);
        for (int c = 0; c < space.controlCount(); ++c) {
            const auto inner = spline.knots.begin() + c + 1;
            const double sum = std::accumulate(inner, inner + spline.degree, 0.0);
            const double t = sum / spline.degree;
            const Vec3 move = moveAt(spline.closed ? t - std::floor(t) : t);
            controls.row(c) = (extended_.frame.toUnit(spline.controlPoints[c]) + move).transpose();
        }
        return {std::move(space), std::move(controls)};
    }

    [[nodiscard]] Vec3 moveAt(double parameter) const {
        const auto above = std::ranges::upper_bound(pieces_, parameter, {}, &Piece::begin);
        return (above == pieces_.begin() ? *above : *std::prev(above)).move(parameter);
    }

    [[nodiscard]] std::vector<double> newBreaks() const {
        const std::vector<double>& knots = curve_.spline.knots;
        const auto degree = static_cast<std::ptrdiff_t>(curve_.spline.degree);
        std::vector<double> breaks;
        auto piece = pieces_.begin();
        for (auto knot = knots.begin() + degree; knot != knots.end() - degree; ++knot) {
            while (std::next(piece) != pieces_.end() && *knot > piece->end) {
                ++piece;
            }
            breaks.push_back(piece->newParameter(*knot));
        }
        breaks.front() = 0.0;
        breaks.back() = 1.0;
        return breaks;
    }

    const Curve& curve_;
    const ExtendedSurface& extended_;
    const std::vector<SurfacePoint>& picks_;
    std::vector<InitialPath::Point> points_;  // of the polyline; closed: the first one once more
    std::vector<Piece> pieces_;
};

}  // namespace

std::optional<WarmStart> dragCurve(
    const Curve& curve, const ExtendedSurface& extended, const std::vector<SurfacePoint>& picks
) {
    WarmStartMaker drag(curve, extended, picks);
    return drag.isSmall() ? std::optional(drag.result()) : std::nullopt;
}

}  // namespace bspline_curve

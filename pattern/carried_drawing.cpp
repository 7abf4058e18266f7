// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/carried_drawing.h"

#include "bspline_curve/error.h"
#include "bspline_curve/progress.h"
#include "design/curve_designer.h"
#include "pattern/carried_piece.h"
#include "surface/surface.h"
#include "text/error_messages.h"
#include "utility/index_sets.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

namespace bspline_curve {

namespace {

constexpr double kRadians = std::numbers::pi / 180.0;

/// "path 3", or "path 3 of copy 2" where there are several.
std::string nameOf(const Drawing& drawing, int path) {
    const DrawingPath& named = drawing.paths[path];
    std::string name = "path ";
    name += std::to_string(named.number);
    if (drawing.paths.back().copy > 0) {
        name += " of copy ";
        name += std::to_string(named.copy);
    }
    return name;
}

double meanSize(const Drawing& drawing) {
    double sum = 0.0;
    for (const DrawingPath& path : drawing.paths) {
        sum += Drawing{.paths = {path}, .baseline = {}}.box().diagonal().norm();
    }
    return sum / static_cast<double>(drawing.paths.size());
}

/// All pieces of a drawing, carried. Refuses what cannot be.
class Carrier {
public:
    Carrier(const Surface& surface, const SurfaceChart& chart, const Drawing& drawing)
        : surface_(surface), chart_(chart), drawing_(drawing) {}

    std::vector<CarriedPiece> carry(const std::vector<SmoothPiece>& pieces, double tolerance) {
        std::vector<CarriedPiece> carried;
        for (const SmoothPiece& piece : pieces) {
            carried.push_back(samplesOf(piece, 0.5 * surface_.averageEdgeLength(), tolerance));
            for (PieceSample& sample : carried.back().samples) {
                place(sample, piece.path);
            }
            if (!piece.closed) {
                joinEnd(carried.back().samples.front());
                joinEnd(carried.back().samples.back());
            }
        }
        refuseFailed();
        return carried;
    }

private:
    struct Failure {
        int path;
        Eigen::Vector2d at;
        CarriedPoint::Status status;
    };

    void place(PieceSample& sample, int path) {
        const CarriedPoint carried = chart_.at(sample.planar);
        if (carried.status == CarriedPoint::Status::OnSurface) {
            sample.position = surface_.position(carried.point);
        } else if (failures_.empty() || failures_.back().path != path) {
            failures_.push_back({path, sample.planar, carried.status});
        }
    }

    /// Ends that only rounding keeps apart become one.
    void joinEnd(PieceSample& end) {
        const auto near = std::ranges::find_if(ends_, [&](const Vec3& other) {
            return (other - end.position).norm() <= kSamePointRelative * surface_.diagonal();
        });
        if (near == ends_.end()) {
            ends_.push_back(end.position);
        } else {
            end.position = *near;
        }
    }

    void refuseFailed() const {
        if (failures_.empty()) {
            return;
        }
        const Failure& first = failures_.front();
        std::vector<std::int64_t> numbers;
        for (const Failure& failure : failures_) {
            numbers.push_back(drawing_.paths[failure.path].number);
        }
        sortUnique(numbers);
        const bool isOffCurve = first.status == CarriedPoint::Status::BeyondCurve;
        throw InputError(
            InputErrorCode::NoPath,
            nameOf(drawing_, first.path) + " of the drawing cannot be carried to the surface: (" +
                describeNumber(first.at.x()) + ", " + describeNumber(first.at.y()) +
                (isOffCurve ? ") is beyond an end of the curve; give a smaller size, another "
                              "start or a longer curve"
                            : ") is beyond the boundary; give a smaller size or another place") +
                (numbers.size() > 1 ? " (paths " + describeElements(numbers) + ")" : ""),
            numbers
        );
    }

    const Surface& surface_;
    const SurfaceChart& chart_;
    const Drawing& drawing_;
    std::vector<Vec3> ends_;
    std::vector<Failure> failures_;
};

void takeDistortion(Pattern& pattern, const Distortion& part) {
    if (part.ratio < pattern.shortest.ratio) {
        pattern.shortest = part;
    }
    if (part.ratio > pattern.longest.ratio) {
        pattern.longest = part;
    }
}

}  // namespace

void PatternOptions::validate() const {
    constexpr double kMostDegrees = 179.0;
    if (std::isnan(cornerAngle) || cornerAngle <= 0.0 || cornerAngle > kMostDegrees) {
        throw InputError(
            InputErrorCode::BadOption, "corner angle must be above 0 and at most 179 degrees"
        );
    }
    if (!std::isfinite(tolerance) || tolerance < 0.0) {
        throw InputError(InputErrorCode::BadOption, "tolerance must be a number >= 0");
    }
    constexpr int kMostPasses = 1000;
    if (smoothing < 0 || smoothing > kMostPasses) {
        throw InputError(InputErrorCode::BadOption, "smoothing must be in [0, 1000]");
    }
}

Pattern carriedDrawing(
    const CurveDesigner& designer,
    const SurfaceChart& chart,
    const Drawing& drawing,
    const PatternOptions& options,
    const Progress& progress
) {
    options.validate();
    if (!std::ranges::all_of(drawing.paths, isUsablePath)) {
        throw InputError(InputErrorCode::BadOption, "the drawing has numbers that are too large");
    }
    const std::vector<SmoothPiece> pieces = smoothPieces(drawing, options.cornerAngle * kRadians);
    if (pieces.empty()) {
        throw InputError(InputErrorCode::BadOption, "the drawing has no paths");
    }
    const Surface& surface = designer.surface();
    Pattern pattern;
    pattern.tolerance =
        options.tolerance > 0.0 ? options.tolerance : kPatternToleranceRelative * meanSize(drawing);
    Carrier carrier(surface, chart, drawing);
    const std::vector<CarriedPiece> carried = carrier.carry(pieces, pattern.tolerance);
    bool isFirst = true;
    for (std::size_t i = 0; i < carried.size(); ++i) {
        const DrawingPath& path = drawing.paths[pieces[i].path];
        report(
            progress,
            static_cast<double>(i) / static_cast<double>(carried.size()),
            "drawing the pattern"
        );
        try {
            DrawnPiece drawn = drawnPiece(designer, carried[i], pattern.tolerance);
            pattern.largestDeviation = std::max(pattern.largestDeviation, drawn.deviation);
            for (Distortion& part : drawn.distortions) {
                part.path = path.number;
                part.copy = path.copy;
                if (isFirst) {
                    pattern.shortest = pattern.longest = part;
                    isFirst = false;
                }
                takeDistortion(pattern, part);
            }
            pattern.curves.push_back(
                {.curve = std::move(drawn.curve), .path = path.number, .copy = path.copy}
            );
        } catch (const InputError& error) {
            const bool isPoint = error.code() == InputErrorCode::CoincidentPicks;
            throw InputError(
                error.code(),
                nameOf(drawing, pieces[i].path) + " of the drawing" +
                    (isPoint ? " has a part that is a point on the surface; leave it out, or give "
                               "a larger size"
                             : std::string(": ") + error.what()),
                {path.number}
            );
        }
    }
    return pattern;
}

}  // namespace bspline_curve

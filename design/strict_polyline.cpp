// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/strict_polyline.h"

#include "bspline_curve/error.h"
#include "surface/surface_point.h"
#include "text/error_messages.h"

#include <algorithm>
#include <cmath>

namespace bspline_curve {
namespace {

// Vertices nearer than this to each other (relative to the diagonal) are one.
constexpr double kCoincident = 1e-10;
// A segment is halved at most this often to meet the maximal length.
constexpr int kMaxHalvings = 24;
/// More fill the memory before anybody can use them.
constexpr double kMostSegments = 1e7;

struct Vertex {
    double parameter;
    SurfacePoint point;
    Vec3 position;
    int pick;  // -1: none
};

class PolylineMaker {
public:
    PolylineMaker(const Surface& surface, const CurveProblem& problem, const FairedShadow& curve)
        : surface_(surface),
          problem_(problem),
          curve_(curve),
          pickParameters_(pickParametersOf(problem)) {}

    SurfacePolyline make(const SamplingOptions& sampling) {
        collect(sampling.samples);
        removeCoincident();
        if (sampling.maxSegmentLength > 0.0) {
            limitLengths(sampling.maxSegmentLength);
        }
        SurfacePolyline line;
        line.closed = problem_.options.closed;
        if (line.closed) {
            vertices_.pop_back();  // the first pick once more
        }
        line.surfacePoints.reserve(vertices_.size());
        line.points.reserve(vertices_.size());
        line.parameters.reserve(vertices_.size());
        line.picks.resize(pickParameters_.size());
        for (const Vertex& vertex : vertices_) {
            // Picks at one place have one vertex.
            for (auto pick = static_cast<std::size_t>(vertex.pick);
                 vertex.pick >= 0 && pick < pickParameters_.size() &&
                 pickParameters_[pick] == pickParameters_[vertex.pick];
                 ++pick) {
                line.picks[pick] = static_cast<int>(line.points.size());
            }
            line.surfacePoints.push_back(vertex.point);
            line.points.push_back(vertex.position);
            line.parameters.push_back(vertex.parameter);
        }
        return line;
    }

private:
    [[nodiscard]] Vertex makeVertex(
        double parameter, const SurfacePoint& point, int pick = -1
    ) const {
        const SurfacePoint exact = pick >= 0 ? point : snapped(point, kSnapBarycentric);
        return {parameter, exact, surface_.position(exact), pick};
    }

    void collect(int samples) {
        vertices_.reserve(
            pickParameters_.size() + 1 + curve_.crossings().size() + (std::max(samples, 0))
        );
        auto passed = problem_.picks.begin();
        for (std::size_t i = 0; i < pickParameters_.size(); ++i) {
            const double t = pickParameters_[i];
            if (i > 0 && t == pickParameters_[i - 1]) {
                continue;
            }
            while (passed != problem_.picks.end() && passed->parameter < t) {
                ++passed;
            }
            const bool isPassed = passed != problem_.picks.end() && passed->parameter == t;
            vertices_.push_back(makeVertex(
                t,
                isPassed ? passed->point : snapped(curve_.at(t), kSnapBarycentric),
                static_cast<int>(i)
            ));
        }
        if (problem_.options.closed) {
            vertices_.push_back(makeVertex(1.0, problem_.picks[0].point, 0));
        }
        const auto picks = static_cast<std::ptrdiff_t>(vertices_.size());
        for (const EdgeCrossing& crossing : curve_.crossings()) {
            vertices_.push_back(makeVertex(crossing.parameter, crossing.point));
        }
        mergeFrom(picks);
        const auto all = static_cast<std::ptrdiff_t>(vertices_.size());
        for (int i = 1; i < samples; ++i) {
            const double t = static_cast<double>(i) / samples;
            vertices_.push_back(makeVertex(t, curve_.at(t)));
        }
        mergeFrom(all);
    }

    // Vertices before and after this one are in order, each for themselves.
    void mergeFrom(std::ptrdiff_t second) {
        std::inplace_merge(
            vertices_.begin(),
            vertices_.begin() + second,
            vertices_.end(),
            [](const Vertex& a, const Vertex& b) { return a.parameter < b.parameter; }
        );
    }

    // Drops vertices that coincide with the one before or after and are not needed to stay in one
    // face; picks stay.
    void removeCoincident() {
        const double near = kCoincident * surface_.diagonal();
        std::vector<Vertex> kept;
        kept.reserve(vertices_.size());
        for (std::size_t i = 0; i < vertices_.size(); ++i) {
            const Vertex& vertex = vertices_[i];
            if (!kept.empty() && (vertex.position - kept.back().position).norm() <= near) {
                if (vertex.pick < 0 &&
                    (i + 1 == vertices_.size() ||
                     commonFace(surface_, kept.back().point, vertices_[i + 1].point) >= 0)) {
                    continue;
                }
                // Where coordinates are large, a crossing and a point in a face may be the same.
                const bool replaces = vertex.pick >= 0 || vertex.position == kept.back().position;
                if (replaces && kept.back().pick < 0 && kept.size() >= 2 &&
                    commonFace(surface_, kept[kept.size() - 2].point, vertex.point) >= 0) {
                    kept.back() = vertex;
                    continue;
                }
            }
            kept.push_back(vertex);
        }
        vertices_.swap(kept);
    }

    void limitLengths(double longest) {
        double length = 0.0;
        for (std::size_t i = 1; i < vertices_.size(); ++i) {
            length += (vertices_[i].position - vertices_[i - 1].position).norm();
        }
        if (length > kMostSegments * longest) {
            throw InputError(
                InputErrorCode::BadOption,
                "max segment length " + describeNumber(longest) +
                    " would part the curve, which is " + describeNumber(length) +
                    " long, into more than " + describeNumber(kMostSegments) +
                    " segments; give a larger one"
            );
        }
        std::vector<Vertex> finer{vertices_.front()};
        for (std::size_t i = 1; i < vertices_.size(); ++i) {
            halve(finer, vertices_[i], longest, 0);
        }
        vertices_.swap(finer);
    }

    // Appends `to` after finer.back(), with vertices between where the segment is too long.
    void halve(std::vector<Vertex>& finer, const Vertex& to, double longest, int depth) {
        const Vertex from = finer.back();
        if ((to.position - from.position).norm() > longest && depth < kMaxHalvings) {
            const double t = 0.5 * (from.parameter + to.parameter);
            const Vertex middle = makeVertex(t, curve_.at(t));
            if (commonFace(surface_, from.point, middle.point) >= 0 &&
                commonFace(surface_, middle.point, to.point) >= 0) {
                halve(finer, middle, longest, depth + 1);
                halve(finer, to, longest, depth + 1);
                return;
            }
        }
        finer.push_back(to);
    }

    const Surface& surface_;
    const CurveProblem& problem_;
    const FairedShadow& curve_;
    std::vector<double> pickParameters_;
    std::vector<Vertex> vertices_;
};

}  // namespace

SurfacePolyline makeStrictPolyline(
    const Surface& surface,
    const CurveProblem& problem,
    const FairedShadow& curve,
    const SamplingOptions& sampling
) {
    return PolylineMaker(surface, problem, curve).make(sampling);
}

}  // namespace bspline_curve

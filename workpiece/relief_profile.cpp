// SPDX-License-Identifier: GPL-3.0-or-later
#include "workpiece/relief_profile.h"

#include "bspline_curve/error.h"
#include "imprint/imprint.h"
#include "imprint/mesh_parts.h"
#include "imprint/part_choice.h"
#include "offset/distance_beams.h"
#include "offset/offset_curves.h"
#include "surface/lines_over_parted_edges.h"
#include "surface/strict_line.h"
#include "surface/surface_point.h"
#include "workpiece/imprint_source.h"
#include "workpiece/workpiece_parts.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <memory>
#include <numbers>
#include <span>
#include <string>
#include <utility>

namespace bspline_curve {

namespace {

/// Levels of a quarter of an ellipse; chords take 0.4 % of its area.
constexpr int kRoundLevels = 10;
/// Of a straight ramp: where ridges of narrow parts are as high as they should be.
constexpr int kRampLevels = 4;
constexpr double kStep = 0.1;  // see OffsetOptions
/// Lines at a distance are imprinted with this snapping distance at least: they are less exact than
/// that, and narrower faces may turn over in single precision.
constexpr double kLeastSnap = 1e-4;
/// So much more is known than the distance that is asked for.
constexpr double kBeyond = 1e-6;
/// Levels nearer than this to the lines of strokes, relative to their half width, are these lines.
constexpr double kOnSpine = 1e-6;

/// Where a profile has its edges, relative to its width, from 0 to 1.
std::vector<double> levelsOf(ReliefProfile profile) {
    std::vector<double> levels;
    const int count = profile == ReliefProfile::Round ? kRoundLevels : kRampLevels;
    for (int i = 1; i <= count; ++i) {
        const double share = static_cast<double>(i) / count;
        levels.push_back(
            profile == ReliefProfile::Round ? 1.0 - std::cos(std::numbers::pi / 2.0 * share) : share
        );
    }
    return levels;
}

/// The share of the height at a distance from the rim, relative to the width.
double shareAt(ReliefProfile profile, double distance) {
    const double within = std::clamp(distance, 0.0, 1.0);
    return profile == ReliefProfile::Round ? std::sqrt(within * (2.0 - within)) : within;
}

/// Of a vertex of an imprint, on the surface itself.
SurfacePoint placeOf(const Surface& surface, const ImprintedMesh& imprinted, int vertex) {
    if (vertex >= imprinted.surfaceVertexCount) {
        return imprinted.ownPlaces[vertex - imprinted.surfaceVertexCount];
    }
    const int face = *surface.facesAround(vertex).begin();
    return {.face = face, .barycentric = Vec3::Unit(cornerOf(surface.faces()[face], vertex))};
}

/// Polylines through vertices of an imprint, with the surface's own faces.
class ImprintLines {
public:
    ImprintLines(const Surface& surface, const ImprintedMesh& imprinted)
        : surface_(surface), imprinted_(imprinted) {}

    /// Whole curves that have an edge.
    [[nodiscard]] std::vector<SurfacePolyline> curves() const {
        std::vector<SurfacePolyline> lines;
        for (const ImprintedCurve& curve : imprinted_.curves) {
            if (curve.vertices.size() > 1) {
                lines.push_back(through(curve.vertices, curve.closed));
            }
        }
        return lines;
    }

    /// The stretches of curves that are made of some edges, each (lower, higher vertex), ascending.
    [[nodiscard]] std::vector<SurfacePolyline> along(
        const std::vector<std::array<int, 2>>& edges
    ) const {
        std::vector<SurfacePolyline> lines;
        for (const ImprintedCurve& curve : imprinted_.curves) {
            const std::size_t count = curve.vertices.size();
            std::vector<int> run;
            const auto endRun = [&] {
                if (run.size() > 1) {
                    lines.push_back(through(run, false));
                }
                run.clear();
            };
            for (std::size_t i = 0; i + (curve.closed ? 0 : 1) < count; ++i) {
                const int from = curve.vertices[i];
                const int to = curve.vertices[(i + 1) % count];
                const auto [low, high] = std::minmax(from, to);
                if (std::ranges::binary_search(edges, std::array{low, high})) {
                    run.resize(std::max<std::size_t>(run.size(), 1), from);
                    run.push_back(to);
                } else {
                    endRun();
                }
            }
            endRun();
        }
        return lines;
    }

private:
    [[nodiscard]] SurfacePolyline through(const std::vector<int>& vertices, bool closed) const {
        SurfacePolyline line;
        line.closed = closed;
        for (const int vertex : vertices) {
            line.surfacePoints.push_back(placeOf(surface_, imprinted_, vertex));
            line.points.push_back(imprinted_.mesh.vertices[vertex]);
        }
        return line;
    }

    const Surface& surface_;
    const ImprintedMesh& imprinted_;
};

/// The labels of an imprint at points of the surface.
class LabelsAt {
public:
    LabelsAt(const Surface& surface, const Imprint& imprint)
        : surface_(surface), imprinted_(*imprint.joined), labels_(imprint.parts.labels) {
        for (std::size_t f = labels_.size(); f-- > 0;) {
            first_[imprinted_.ownParents[f]] = static_cast<int>(f);
        }
    }

    [[nodiscard]] int at(const SurfacePoint& point) const {
        int best = first_[point.face];
        double deepest = -std::numeric_limits<double>::infinity();
        for (int f = best;
             f < static_cast<int>(labels_.size()) && imprinted_.ownParents[f] == point.face;
             ++f) {
            const double depth = depthIn(f, point);
            if (depth > deepest) {
                deepest = depth;
                best = f;
            }
        }
        return labels_[best];
    }

private:
    /// The least barycentric coordinate in a child.
    [[nodiscard]] double depthIn(int child, const SurfacePoint& point) const {
        Eigen::Matrix3d corners;
        for (int k = 0; k < 3; ++k) {
            corners.col(k) = ownPlace(surface_, imprinted_, child, k).barycentric;
        }
        return (corners.inverse() * point.barycentric).minCoeff();
    }

    const Surface& surface_;
    const ImprintedMesh& imprinted_;
    const std::vector<int>& labels_;
    std::vector<int> first_ = std::vector<int>(surface_.faceCount(), -1);  // child of each face
};

SurfacePoint middleOf(const Surface& surface, const ImprintedMesh& imprinted, int face) {
    SurfacePoint middle{.face = imprinted.ownParents[face]};
    for (int k = 0; k < 3; ++k) {
        middle.barycentric += ownPlace(surface, imprinted, face, k).barycentric / 3.0;
    }
    return middle;
}

/// For each part its largest face.
std::vector<int> largestFaces(const TriangleMesh& mesh, const MeshParts& parts) {
    std::vector<int> largest(parts.parts.size(), -1);
    std::vector<double> area(parts.parts.size(), -1.0);
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        const auto& [a, b, c] = mesh.faces[f];
        const Vec3& corner = mesh.vertices[a];
        const double own = (mesh.vertices[b] - corner).cross(mesh.vertices[c] - corner).norm();
        if (own > area[parts.labels[f]]) {
            area[parts.labels[f]] = own;
            largest[parts.labels[f]] = static_cast<int>(f);
        }
    }
    return largest;
}

/// What the heights of a relief go by.
struct RimDistance {
    std::vector<SurfacePolyline> lines;
    double reach;          // from these lines
    double halfWidth = 0;  // of strokes, of which these are the lines; 0: they are the rim

    [[nodiscard]] double fromLines(double fromRim) const { return std::abs(halfWidth - fromRim); }

    [[nodiscard]] double fromRim(double fromLines) const {
        return halfWidth > 0.0 ? halfWidth - fromLines : fromLines;
    }
};

RimDistance rimOfStrokes(const Imprint::Source& source) {
    return {.lines = source.spines, .reach = source.halfWidth, .halfWidth = source.halfWidth};
}

RimDistance rimOfParts(
    const Imprint& imprint, const ImprintLines& before, const std::vector<int>& parts, double width
) {
    return {
        .lines = before.along(edgesAround(*imprint.joined, imprint.parts, parts)), .reach = width
    };
}

/// Of an imprint that divides another one more finely: each part has the label of the one there.
void takeLabels(
    const Surface& surface,
    const LabelsAt& labels,
    const MeshParts& before,
    Imprint& finer,
    const GoOn& goOn
) {
    const ImprintedMesh& joined = *finer.joined;
    MeshParts parts = partsOf(joined, goOn);
    std::vector<int> labelOf;
    for (const int face : largestFaces(joined.mesh, parts)) {
        labelOf.push_back(labels.at(middleOf(surface, joined, face)));
    }
    std::ranges::transform(parts.labels, parts.labels.begin(), [&](int label) {
        return labelOf[label];
    });
    finer.parts = {
        .labels = std::move(parts.labels), .parts = before.parts, .strokes = before.strokes
    };
}

/// Keeps of an imprint's lines the curves alone, which are first.
void keepCurves(Imprint& imprint, std::size_t count) {
    const auto withCurvesAlone = [&](const ImprintedMesh& mesh) {
        ImprintedMesh alone = mesh;
        alone.curves.resize(count);
        return std::make_shared<const ImprintedMesh>(std::move(alone));
    };
    const bool isJoined = imprint.mesh == imprint.joined;
    imprint.joined = withCurvesAlone(*imprint.joined);
    imprint.mesh = isJoined ? imprint.joined : withCurvesAlone(*imprint.mesh);
}

}  // namespace

ProfiledImprint profiledImprint(
    const Imprint& imprint,
    const std::vector<int>& chosen,
    const CutChoice& choice,
    const Progress& progress
) {
    const Imprint::Source& source = *imprint.source;
    const Surface& surface = *source.surface;
    const bool areStrokes = !imprint.parts.strokes.empty() && chosen == imprint.parts.strokes;
    const double meant = areStrokes ? source.halfWidth : std::abs(choice.relief);
    double width = choice.profileWidth > 0.0 ? choice.profileWidth : meant;
    width = areStrokes ? std::min(width, source.halfWidth) : width;

    const ImprintLines before(surface, *imprint.joined);
    const RimDistance rim =
        areStrokes ? rimOfStrokes(source) : rimOfParts(imprint, before, chosen, width);
    const DistanceBeams beams(
        surface,
        rim.lines,
        {.from = 0.0, .to = (1.0 + kBeyond) * rim.reach},
        partOf(progress, 0.0, 0.5)
    );

    // Lines of equal height inside the parts, behind the curves, which alone bound parts.
    const LabelsAt labels(surface, imprint);
    std::vector<SurfacePolyline> lines = before.curves();
    const std::size_t curveCount = lines.size();
    const auto addInside = [&](const std::vector<SurfacePolyline>& more) {
        std::ranges::copy_if(more, std::back_inserter(lines), [&](const SurfacePolyline& line) {
            return std::ranges::binary_search(chosen, labels.at(line.surfacePoints.front()));
        });
    };
    for (const double level : levelsOf(choice.profile)) {
        const double distance = rim.fromLines(level * width);
        if (distance <= kOnSpine * rim.halfWidth) {
            addInside(rim.lines);
        } else {
            const double step = std::min(1.0, kStep * width / distance);
            addInside(wholeLinesAt(surface, beams, distance, step, partOf(progress, 0.5, 0.8)));
        }
    }
    for (SurfacePolyline& line : lines) {
        surface.provenance().bringToInput(line);
    }

    const auto goOn = [&] { report(progress, 0.8, "imprinting"); };
    ProfiledImprint result{
        .imprint = imprintOf(source, lines, {.snap = kLeastSnap}, goOn), .shares = {}
    };
    keepCurves(result.imprint, curveCount);
    takeLabels(surface, labels, imprint.parts, result.imprint, goOn);
    const ImprintedMesh& joined = *result.imprint.joined;

    report(progress, 0.9, "shaping a relief");
    result.shares.resize(joined.mesh.vertices.size(), 0.0);
    for (std::size_t v = 0; v < result.shares.size(); ++v) {
        const auto vertex = static_cast<int>(v);
        if (vertex >= joined.surfaceVertexCount || !surface.facesAround(vertex).empty()) {
            const double distance = beams.at(placeOf(surface, joined, vertex)).distance;
            result.shares[v] = shareAt(choice.profile, rim.fromRim(distance) / width);
        }
    }
    return result;
}

Imprint strokesOn(
    const Workpiece& workpiece,
    std::span<const SurfacePolyline> lines,
    double width,
    const ImprintOptions& options,
    const Progress& progress
) {
    if (!std::isfinite(width) || width <= 0.0) {
        throw InputError(
            InputErrorCode::BadOption, "the width of strokes must be a number above 0"
        );
    }
    const double half = width / 2.0;
    JoinedLines onSurface = joinedFor(workpiece.parts().surface, lines);
    Imprint::Source source{
        .surface = std::move(onSurface.surface), .spines = {}, .halfWidth = half
    };
    const Surface& surface = *source.surface;
    for (const SurfacePolyline& line : onSurface.lines) {
        source.spines.push_back(
            strictLine(surface, line, "curve " + std::to_string(source.spines.size()))
        );
    }
    const DistanceBeams beams(
        surface,
        source.spines,
        {.from = (1.0 - kBeyond) * half, .to = (1.0 + kBeyond) * half},
        partOf(progress, 0.0, 0.5)
    );
    std::vector<SurfacePolyline> sides =
        wholeLinesAt(surface, beams, half, kStep, partOf(progress, 0.5, 0.8));
    if (sides.empty()) {
        throw InputError(InputErrorCode::NoPath, kNothingBeside);
    }
    for (SurfacePolyline& side : sides) {
        surface.provenance().bringToInput(side);
    }
    options.validate();
    Imprint result =
        imprintOf(std::move(source), sides, {.snap = std::max(options.snap, kLeastSnap)}, [&] {
            report(progress, 0.8, "imprinting");
        });
    const ImprintedMesh& joined = *result.joined;
    result.parts = partsOf(joined, [&] { report(progress, 0.9, "finding parts"); });
    const std::vector<int> faces = largestFaces(joined.mesh, result.parts);
    for (std::size_t label = 0; label < faces.size(); ++label) {
        const SurfacePoint middle = middleOf(*result.source->surface, joined, faces[label]);
        if (beams.at(middle).distance < half) {
            result.parts.strokes.push_back(static_cast<int>(label));
        }
    }
    return result;
}

}  // namespace bspline_curve

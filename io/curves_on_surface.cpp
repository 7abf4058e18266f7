// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/curves_on_surface.h"

#include "bspline_curve/error.h"
#include "bspline_curve/files.h"
#include "imprint/projected_polyline.h"
#include "io/curve_reader.h"
#include "io/text_parsing.h"
#include "surface/lines_over_parted_edges.h"
#include "surface/picks.h"
#include "surface/surface_point.h"
#include "workpiece/workpiece_parts.h"

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

namespace bspline_curve {

namespace {

/// Positions that differ by more are those of another mesh (relative to the diagonal).
constexpr double kSamePlaceRelative = 1e-6;
/// Barycentric coordinates of a file sum to 1 as exactly as its digits allow.
constexpr double kWeightTolerance = 1e-9;

/// The polyline at the places that its file names; none where these are not on this mesh.
std::optional<SurfacePolyline> linePlaced(
    const Surface& surface, const SpacePolyline& line, const std::vector<SurfacePoint>& places
) {
    const TriangleMesh& mesh = surface.input();
    if (places.size() != line.points.size()) {
        return std::nullopt;
    }
    SurfacePolyline placed{
        .closed = line.closed,
        .surfacePoints = places,
        .points = line.points,
        .parameters = {},
        .picks = {}
    };
    const auto count = static_cast<double>(places.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
        const auto& [face, barycentric] = places[i];
        const bool isPlace = face >= 0 && face < static_cast<int>(mesh.faces.size()) &&
                             barycentric.minCoeff() >= -kWeightTolerance &&
                             std::abs(barycentric.sum() - 1.0) <= kWeightTolerance;
        if (!isPlace || !((positionOf(mesh, places[i]) - line.points[i]).norm() <=
                          kSamePlaceRelative * surface.diagonal())) {
            return std::nullopt;
        }
        placed.parameters.push_back(static_cast<double>(i) / count);
    }
    try {
        checkLine(surface, placed, "the polyline");
    } catch (const InputError&) {
        return std::nullopt;  // of another mesh with faces in these places: it is projected
    }
    return placed;
}

}  // namespace

CurvesOfFile CurvesOnSurface::read(const std::filesystem::path& file, const char* remedy) {
    if (lowerCaseExtension(file) == ".json") {
        return {
            .lines = readCurves(file, surface_, mesh_), .splines = readSplines(file), .notes = {}
        };
    }
    PolylineFile polylines = readPolylines(file, layers_);
    CurvesOfFile result{
        .lines = {},
        .splines = std::vector<std::optional<SplineData>>(polylines.lines.size()),
        .notes = std::move(polylines.notes)
    };
    for (std::size_t i = 0; i < polylines.lines.size(); ++i) {
        const SpacePolyline& line = polylines.lines[i];
        if (auto placed = linePlaced(surface_, line, polylines.places[i])) {
            result.lines.push_back(*std::move(placed));
            continue;
        }
        if (!tree_) {
            tree_.emplace(surface_.vertices(), surface_.faces());
        }
        try {
            result.lines.push_back(projectedPolyline(surface_, *tree_, line, distance_));
        } catch (const InputError& error) {
            const std::string which =
                polylines.lines.size() == 1 ? "" : "polyline " + std::to_string(i) + " of it ";
            throw InputError(
                error.code(),
                file.string() + ": " + which + "is not near the mesh: " + error.what() +
                    "; give the mesh that it belongs to, or " + remedy,
                error.elements()
            );
        }
    }
    return result;
}

SurfacePolyline CurvesOnSurface::readOne(const std::filesystem::path& file, const char* remedy) {
    CurvesOfFile read = this->read(file, remedy);
    if (read.lines.size() != 1) {
        refuseFile(
            file, "has " + std::to_string(read.lines.size()) + " curves, and one is needed here"
        );
    }
    return std::move(read.lines.front());
}

CurvesOfFile readCurvesOn(
    const Workpiece& workpiece,
    const std::filesystem::path& file,
    double distance,
    const std::vector<std::string>& layers,
    const char* remedy
) {
    const double reach = distance > 0.0 ? distance : kPickReachRelative * workpiece.diagonal();
    return CurvesOnSurface(surfaceOf(workpiece), workpiece.checksum(), reach, layers)
        .read(file, remedy);
}

}  // namespace bspline_curve

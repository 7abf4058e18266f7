// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/error.h"
#include "bspline_curve/files.h"
#include "imprint/projected_polyline.h"
#include "io/curve_reader.h"
#include "surface/lines_over_parted_edges.h"
#include "surface/surface_point.h"
#include "surface/triangle_tree.h"
#include "text/text_parsing.h"
#include "workpiece/workpiece_parts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

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

struct CurveFileReader::State {
    const Surface& surface;
    MeshChecksum mesh;
    CurveReading reading;
    std::optional<TriangleTree> tree{};  ///< made with the first polyline that needs it

    [[nodiscard]] ProjectedLines projected(
        const std::filesystem::path& file, const PolylineFile& polylines, std::size_t index
    );
};

CurveFileReader::CurveFileReader(const Workpiece& workpiece, CurveReading reading)
    : state_(new State{
          .surface = surfaceOf(workpiece),
          .mesh = workpiece.checksum(),
          .reading = std::move(reading)
      }) {}

CurveFileReader::~CurveFileReader() = default;
CurveFileReader::CurveFileReader(CurveFileReader&&) noexcept = default;
CurveFileReader& CurveFileReader::operator=(CurveFileReader&&) noexcept = default;

ProjectedLines CurveFileReader::State::projected(
    const std::filesystem::path& file, const PolylineFile& polylines, std::size_t index
) {
    if (!tree) {
        tree.emplace(surface.vertices(), surface.faces());
    }
    try {
        return projectedLines(surface, *tree, polylines.lines[index], reading.projection);
    } catch (const InputError& error) {
        const std::string which =
            polylines.lines.size() == 1 ? "" : "polyline " + std::to_string(index) + " of it ";
        throw InputError(
            error.code(),
            file.string() + ": " + which + "is not near the mesh: " + error.what() +
                "; give the mesh that it belongs to, or " + reading.remedy,
            error.elements()
        );
    }
}

CurvesOfFile CurveFileReader::read(const std::filesystem::path& file) {
    const auto& [surface, mesh, reading, tree] = *state_;
    reading.projection.validate();
    if (lowerCaseExtension(file) == ".json") {
        return {
            .lines = readCurves(file, surface, mesh), .splines = readSplines(file), .notes = {}
        };
    }
    PolylineFile polylines = readPolylines(file, reading.layers);
    CurvesOfFile result{.lines = {}, .splines = {}, .notes = std::move(polylines.notes)};
    std::vector<ProjectedLines> all(polylines.lines.size());
    for (std::size_t i = 0; i < polylines.lines.size(); ++i) {
        if (auto placed = linePlaced(surface, polylines.lines[i], polylines.places[i])) {
            result.lines.push_back(*std::move(placed));
            continue;
        }
        all[i] = state_->projected(file, polylines, i);
        std::ranges::move(all[i].lines, std::back_inserter(result.lines));
    }
    if (result.lines.empty()) {
        throw InputError(InputErrorCode::PickTooFar, file.string() + kNothingMet);
    }
    result.splines.resize(result.lines.size());
    if (const std::string note = projectionNote(all); !note.empty()) {
        result.notes.push_back(file.string() + ": " + note);
    }
    return result;
}

SurfacePolyline CurveFileReader::readOne(const std::filesystem::path& file) {
    CurvesOfFile read = this->read(file);
    if (read.lines.size() != 1) {
        refuseFile(
            file, "has " + std::to_string(read.lines.size()) + " curves, and one is needed here"
        );
    }
    return std::move(read.lines.front());
}

CurvesOfFile readCurvesOn(
    const Workpiece& workpiece, const std::filesystem::path& file, const CurveReading& reading
) {
    return CurveFileReader(workpiece, reading).read(file);
}

}  // namespace bspline_curve

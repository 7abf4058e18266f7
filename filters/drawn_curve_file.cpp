// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/drawn_curve_file.h"

#include "bspline_curve/atomic_file.h"
#include "bspline_curve/error.h"
#include "bspline_curve/files.h"
#include "bspline_curve/mesh.h"
#include "filters/curve_comments.h"
#include "filters/fitting_picks.h"
#include "surface/picks.h"
#include "surface/triangle_tree.h"
#include "text/error_messages.h"
#include "text/text_parsing.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>

namespace bspline_curve {

namespace {

using std::filesystem::path;

/// A pick is where it was up to this, relative to the diagonal: more than the rounding of floats.
constexpr double kSamePlaceRelative = 1e-6;

/// How far picks that are chosen along a polyline may leave it aside, relative to the diagonal.
constexpr double kFitRelative = 0.002;
constexpr std::size_t kMostFittedPicks = 200;
/// More are a drawing of something else, as the edges of a mesh.
constexpr std::size_t kMostPolylines = 1000;

double diagonalOf(const TriangleMesh& mesh) {
    Eigen::AlignedBox3d box;
    for (const Triangle& face : mesh.faces) {
        for (const int vertex : face) {
            box.extend(mesh.vertices[vertex]);
        }
    }
    return box.isEmpty() ? 0.0 : box.diagonal().norm();
}

/// None: that of no polylines.
std::optional<CommentStyle> commentStyleOf(const path& file) {
    const std::string extension = lowerCaseExtension(file);
    if (extension == ".obj") {
        return CommentStyle::Obj;
    }
    return extension == ".dxf" ? std::optional(CommentStyle::Dxf) : std::nullopt;
}

/// Polylines, and what their format cannot say in comments before them.
std::string commentedPolylines(CommentStyle style, const CurveRecords& records) {
    std::vector<const Curve*> curves;
    for (const CurveRecord& record : records.curves) {
        if (record.curve) {
            curves.push_back(record.curve.get());
        }
    }
    return asComments(style, shortRecordsText(records)) +
           curvesBytes(style == CommentStyle::Obj ? "a.obj" : "a.dxf", curves, records.mesh);
}

// ---- Opening ----

/// The polylines of a file that says nothing of picks, each described by a few of its vertices.
CurveRecords fittedRecords(const path& file, double diagonal, std::vector<std::string>& notes) {
    PolylineFile read = readPolylines(file);
    const std::vector<SpacePolyline>& lines = read.lines;
    std::ranges::move(read.notes, std::back_inserter(notes));
    if (lines.size() > kMostPolylines) {
        refuseFile(
            file,
            "has " + std::to_string(lines.size()) + " polylines, and at most " +
                std::to_string(kMostPolylines) + " are opened as curves"
        );
    }
    CurveRecords records;
    for (const SpacePolyline& line : lines) {
        double tolerance = kFitRelative * diagonal;
        std::vector<int> picks = fittingPicks(line, tolerance);
        while (picks.size() > kMostFittedPicks) {
            picks = fittingPicks(line, tolerance *= 2.0);
        }
        if (picks.size() < 2) {
            continue;  // all of it is one point
        }
        CurveRecord record;
        record.closed = line.closed && picks.size() >= 3;
        for (const int vertex : picks) {
            record.picks.push_back({.point = {}, .position = line.points[vertex]});
        }
        DrawnOptions options;
        options.closed = record.closed;
        record.options = options;
        records.curves.push_back(std::move(record));
    }
    notes.push_back(
        file.string() +
        " keeps no picks: they were chosen along its polylines, and the curves were drawn anew."
    );
    return records;
}

/// Puts picks onto a surface.
class PickPlacer {
public:
    /// `isSame`: whether faces and barycentric coordinates are of the surface as it was given.
    PickPlacer(const CurveFileSurface& surface, bool isSame)
        : surface_(surface), isSame_(isSame), diagonal_(diagonalOf(surface.mesh)) {}

    struct Placed {
        std::vector<SketchPick> picks;
        int projected = 0;      ///< how many were not where the file says
        double farthest = 0.0;  ///< how far they were from the surface
    };

    Placed place(const std::vector<SketchPick>& picks) {
        Placed placed;
        for (const SketchPick& pick : picks) {
            placed.picks.push_back(isSamePlace(pick) ? pick : projected(pick, placed));
        }
        return placed;
    }

    [[nodiscard]] bool isWithinReach(const Placed& placed) const {
        return placed.farthest <= kPickReachRelative * diagonal_;
    }

    /// Whether they were farther from the surface than rounding explains.
    [[nodiscard]] bool isOff(const Placed& placed) const {
        return placed.farthest > kSamePlaceRelative * diagonal_;
    }

private:
    [[nodiscard]] bool isSamePlace(const SketchPick& pick) const {
        const auto faces = static_cast<std::int64_t>(surface_.mesh.faces.size());
        if (!isSame_ || pick.point.face < 0 || pick.point.face >= faces) {
            return false;
        }
        const double gap = (positionOf(surface_.mesh, pick.point) - pick.position).norm();
        return gap <= kSamePlaceRelative * diagonal_;
    }

    SketchPick projected(const SketchPick& pick, Placed& placed) {
        const ClosestPoint closest = closestTo(pick.position);
        ++placed.projected;
        placed.farthest = std::max(placed.farthest, (closest.position - pick.position).norm());
        return {closest.place, closest.position, pick.isCorner, pick.tangent};
    }

    ClosestPoint closestTo(const Vec3& position) {
        if (surface_.workpiece != nullptr) {
            return surface_.workpiece->closestPoint(position);
        }
        if (!tree_) {
            tree_.emplace(surface_.mesh.vertices, surface_.mesh.faces);
        }
        const TriangleTree::Closest closest = tree_->closestPoint(position);
        return {.place = closest.point, .position = closest.position};
    }

    const CurveFileSurface& surface_;
    bool isSame_;
    double diagonal_;
    std::optional<TriangleTree> tree_;
};

/// "curve 2 (rim)".
std::string labelOf(std::size_t number, const std::string& name) {
    return "curve " + std::to_string(number) + (name.empty() ? "" : " (" + name + ")");
}

}  // namespace

std::string drawnCurvesBytes(
    const path& file, std::span<const CurveToSave> curves, const CurveFileSurface& surface
) {
    const bool isJson = lowerCaseExtension(file) == ".json";
    const std::optional<CommentStyle> style = commentStyleOf(file);
    if (!isJson && !style) {
        refuseWriting(file, "curves are saved as .json, .obj or .dxf");
    }
    if (curves.empty()) {
        refuseWriting(file, "there is no curve to be saved");
    }
    CurveRecords records{.mesh = surface.checksum, .curves = {}};
    for (const CurveToSave& curve : curves) {
        records.curves.push_back(recordOf(curve.drawn, curve.curve));
    }
    return isJson ? recordsText(records) : commentedPolylines(*style, records);
}

void saveDrawnCurves(
    const path& file, std::span<const CurveToSave> curves, const CurveFileSurface& surface
) {
    AtomicFile(file, drawnCurvesBytes(file, curves, surface)).commit();
}

OpenedCurves placedRecords(
    const path& file, const CurveRecords& records, const CurveFileSurface& surface
) {
    OpenedCurves opened{.curves = {}, .notes = records.notes};
    PickPlacer placer(surface, !records.mesh || *records.mesh == surface.checksum);
    std::size_t number = 0;
    for (const CurveRecord& record : records.curves) {
        const std::string label = file.string() + ", " + labelOf(++number, record.name);
        PickPlacer::Placed placed = placer.place(record.picks);
        if (!placer.isWithinReach(placed)) {
            opened.notes.push_back(
                label + " was left out: a pick is " + describeNumber(placed.farthest) +
                " from the surface."
            );
            continue;
        }
        // Picks that were chosen along a polyline were never on the surface.
        const bool wereOnSurface = record.picks.front().point.face >= 0;
        if (placed.projected > 0 && (wereOnSurface || placer.isOff(placed))) {
            opened.notes.push_back(
                label + ": " + std::to_string(placed.projected) + " of " +
                std::to_string(placed.picks.size()) + " picks were projected to the surface, by " +
                describeNumber(placed.farthest) + " at most" +
                (records.mesh && *records.mesh != surface.checksum
                     ? ", since the mesh changed: " +
                           describeChange(*records.mesh, surface.checksum)
                     : std::string()) +
                "."
            );
        }
        if (!record.options) {
            opened.notes.push_back(
                label + " was drawn with options that are not offered here; it has the usual ones."
            );
        }
        DrawnOptions options = record.options.value_or(DrawnOptions());
        options.closed = record.closed;
        opened.curves.push_back({std::move(placed.picks), options, record.name, record.colour});
    }
    if (opened.curves.empty()) {
        throw InputError(
            InputErrorCode::PickTooFar,
            file.string() +
                ": no curve is near the surface; choose the mesh that they were drawn on"
        );
    }
    return opened;
}

OpenedCurves openDrawnCurves(const path& file, const CurveFileSurface& surface) {
    if (lowerCaseExtension(file) == ".json") {
        return placedRecords(file, recordsOf(file, readWholeFile(file)), surface);
    }
    if (const std::optional<CommentStyle> style = commentStyleOf(file)) {
        if (const auto text = textOfComments(*style, readWholeFile(file))) {
            return placedRecords(file, recordsOf(file, *text), surface);
        }
    }
    std::vector<std::string> notes;
    const CurveRecords records = fittedRecords(file, diagonalOf(surface.mesh), notes);
    OpenedCurves opened = placedRecords(file, records, surface);
    std::ranges::move(notes, std::back_inserter(opened.notes));
    return opened;
}

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/drawn_curve_file.h"

#include "bspline_curve/error.h"
#include "design/curve_on_given_mesh.h"
#include "io/atomic_file.h"
#include "io/text_parsing.h"
#include "surface/error_messages.h"
#include "surface/picks.h"
#include "surface/points_on_mended.h"
#include "surface/surface_point.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

namespace bspline_curve {

namespace {

using std::filesystem::path;

/// A pick is where it was up to this, relative to the diagonal: more than the rounding of floats.
constexpr double kSamePlaceRelative = 1e-6;

double diagonalOf(const TriangleMesh& mesh) {
    Eigen::AlignedBox3d box;
    for (const Triangle& face : mesh.faces) {
        for (const int vertex : face) {
            box.extend(mesh.vertices[vertex]);
        }
    }
    return box.isEmpty() ? 0.0 : box.diagonal().norm();
}

CurveRecord givenRecord(const CurveToSave& saved, const CurveFileSurface& surface) {
    CurveRecord record = recordOf(saved.drawn, saved.curve);
    if (surface.repair == nullptr) {
        return record;
    }
    for (SketchPick& pick : record.picks) {
        pick.point = surface.repair->toOrigin(pick.point);
    }
    if (saved.curve) {
        Curve curve = *saved.curve;
        bringBack(curve, surface.repair);
        record.curve = std::make_shared<const Curve>(std::move(curve));
    }
    return record;
}

// ---- Opening ----

/// Puts picks onto a surface.
class PickPlacer {
public:
    /// `isSame`: whether faces and barycentric coordinates are of the surface as it was given.
    PickPlacer(const CurveFileSurface& surface, bool isSame)
        : surface_(surface), isSame_(isSame), diagonal_(diagonalOf(surface.mesh)) {
        if (isSame_ && surface.repair != nullptr) {
            mended_.emplace(*surface.repair);
        }
    }

    struct Placed {
        std::vector<SketchPick> picks;
        int projected = 0;      ///< how many were not where the file says
        double farthest = 0.0;  ///< how far they were from the surface
    };

    Placed place(const std::vector<SketchPick>& given) {
        Placed placed;
        for (const SketchPick& pick : given) {
            const std::optional<SketchPick> same = samePlace(pick);
            placed.picks.push_back(same ? *same : projected(pick, placed));
        }
        return placed;
    }

    [[nodiscard]] bool isWithinReach(const Placed& placed) const {
        return placed.farthest <= kPickReachRelative * diagonal_;
    }

    [[nodiscard]] double diagonal() const { return diagonal_; }

private:
    [[nodiscard]] std::optional<SketchPick> samePlace(const SketchPick& pick) const {
        const auto faces = static_cast<std::int64_t>(surface_.mesh.faces.size());
        const std::int64_t given = surface_.repair != nullptr ? surface_.checksum.faces : faces;
        if (!isSame_ || pick.point.face < 0 || pick.point.face >= given) {
            return std::nullopt;
        }
        const std::optional<SurfacePoint> point =
            mended_ ? mended_->pointAt(pick.point) : pick.point;
        if (!point) {
            return std::nullopt;
        }
        const double gap = (positionOf(surface_.mesh, *point) - pick.position).norm();
        return gap <= kSamePlaceRelative * diagonal_
                   ? std::optional(SketchPick{*point, pick.position})
                   : std::nullopt;
    }

    SketchPick projected(const SketchPick& pick, Placed& placed) {
        const TriangleTree::Closest closest = tree().closestPoint(pick.position);
        ++placed.projected;
        placed.farthest = std::max(placed.farthest, (closest.position - pick.position).norm());
        return {closest.point, closest.position};
    }

    const TriangleTree& tree() {
        if (surface_.tree != nullptr) {
            return *surface_.tree;
        }
        if (!own_) {
            own_.emplace(surface_.mesh.vertices, surface_.mesh.faces);
        }
        return *own_;
    }

    const CurveFileSurface& surface_;
    bool isSame_;
    double diagonal_;
    std::optional<PointsOnMended> mended_;
    std::optional<TriangleTree> own_;
};

/// "curve 2 (rim)".
std::string labelOf(std::size_t number, const std::string& name) {
    return "curve " + std::to_string(number) + (name.empty() ? "" : " (" + name + ")");
}

}  // namespace

void saveDrawnCurves(
    const path& file, std::span<const CurveToSave> curves, const CurveFileSurface& surface
) {
    const std::string extension = lowerCaseExtension(file);
    if (extension != ".json") {
        throw InputError(
            InputErrorCode::UnwritableFile, file.string() + ": curves are saved as .json"
        );
    }
    if (curves.empty()) {
        refuseWriting(file, "there is no curve to be saved");
    }
    CurveRecords records{.mesh = surface.checksum, .curves = {}};
    for (const CurveToSave& curve : curves) {
        records.curves.push_back(givenRecord(curve, surface));
    }
    AtomicFile(file, recordsText(records)).commit();
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
        if (placed.projected > 0) {
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
    return placedRecords(file, recordsOf(file, readWholeFile(file)), surface);
}

}  // namespace bspline_curve

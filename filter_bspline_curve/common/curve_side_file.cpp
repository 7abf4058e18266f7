// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_bspline_curve/common/curve_side_file.h"

#include "bspline_curve/atomic_file.h"
#include "bspline_curve/error.h"
#include "filter_bspline_curve/common/curve_source.h"
#include "filter_bspline_curve/common/layer_arrays.h"
#include "filter_bspline_curve/common/layer_making.h"
#include "filter_bspline_curve/common/polyline_layer.h"
#include "filters/curve_records.h"
#include "filters/utf8_path.h"
#include "text/text_parsing.h"
#include "utility/index_sets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

namespace bspline_curve {

namespace {

/// MeshLab 2020.09 writes six decimals into OBJ files, and its floats have seven digits.
constexpr double kRoundedDecimals = 1e-6;
constexpr double kRoundedRelative = 1e-6;

/// Formats in which MeshLab writes the edges of a layer without faces.
constexpr std::array kFormatsWithEdges = {"obj", "dxf"};

bool keepsEdges(const QString& extension) {
    return std::ranges::find(kFormatsWithEdges, extension.toLower()) != kFormatsWithEdges.end();
}

/// "curve.ply holds points only, since …"; empty where the format keeps edges.
std::string lossOf(const MeshModel& layer) {
    const QString extension = layer.suffixName();
    if (keepsEdges(extension)) {
        return {};
    }
    return layer.shortName().toStdString() + " holds points only, since " +
           extension.toUpper().toStdString() + " files of MeshLab have no edges";
}

bool isPolylineOfOurs(const MeshModel& layer) {
    return checksumOfSurface(layer) != nullptr && layer.cm.FN() == 0 && layer.cm.EN() > 0;
}

Curve inLayer(const Curve& curve, const FromWorld& fromWorld) {
    Curve moved = curve;
    for (Vec3& point : moved.polyline.points) {
        point = fromWorld.inDoubles(point);
    }
    for (Vec3& point : moved.spline.controlPoints) {
        point = fromWorld.inDoubles(point);
    }
    return moved;
}

/// A face of a layer as it is numbered without those that are deleted.
int faceWithoutDeleted(const MeshModel& surface, int face) {
    int count = 0;
    for (int f = 0; f < face && f < static_cast<int>(surface.cm.face.size()); ++f) {
        count += surface.cm.face[f].IsD() ? 0 : 1;
    }
    return count;
}

std::vector<SketchPick> picksInLayer(
    const CurveSource& source, const MeshModel* surface, const FromWorld& fromWorld
) {
    std::vector<SketchPick> picks;
    for (std::size_t i = 0; i < source.picks.size(); ++i) {
        SketchPick pick{.point = source.picks[i]};
        if (source.curve) {
            const SurfacePolyline& line = source.curve->polyline;
            pick.point = line.surfacePoints[line.picks[i]];
        } else if (surface != nullptr) {
            pick.point.face = faceWithoutDeleted(*surface, pick.point.face);
        }
        pick.position = fromWorld.inDoubles(source.positions[i]);
        pick.isCorner = contains(source.corners, static_cast<int>(i));
        picks.push_back(pick);
    }
    for (const auto& [pick, tangent] : source.tangents) {
        const auto inLayer = [&, pick = pick](const Vec3& direction) {
            return Vec3(
                fromWorld.inDoubles(source.positions[pick] + direction) - picks[pick].position
            );
        };
        picks[pick].tangent = {inLayer(tangent.before), inLayer(tangent.after)};
    }
    return picks;
}

CurveRecords recordsOfLayer(
    const MeshDocument& document, const MeshModel& layer, const CurveSource& source
) {
    const FromWorld fromWorld(source.toWorld);
    CurveRecord record{
        .name = layer.label().toStdString(),
        .colour = colourOf(layer),
        .closed = source.closed,
        .picks = picksInLayer(source, host::layerWithId(document, source.surface), fromWorld),
        .options = source.options,
        .curve = nullptr,
    };
    if (source.curve) {
        record.curve = std::make_shared<const Curve>(inLayer(*source.curve, fromWorld));
    }
    const MeshChecksum* const checksum = checksumOfSurface(layer);
    return {
        .mesh = checksum == nullptr ? std::nullopt : std::optional(*checksum),
        .curves = {std::move(record)}
    };
}

/// Whether there is nothing yet, or a file of curves.
bool isFreeOrOurs(const std::filesystem::path& file) {
    const std::optional<std::string> bytes = readWholeFileIfThere(file);
    if (!bytes) {
        return true;
    }
    try {
        static_cast<void>(recordsOf(file, *bytes));
    } catch (const InputError&) {
        return false;
    }
    return true;
}

SavedLine savedCurve(
    const MeshDocument& document, const MeshModel& layer, const CurveSource& source
) {
    const std::string name = layer.shortName().toStdString();
    const QString side = sideFileOf(layer.fullName());
    const std::string sideName = sideFileOf(layer.shortName()).toStdString();
    const std::filesystem::path file = utf8Path(side.toStdString());
    const CurveRecords records = recordsOfLayer(document, layer, source);
    const CurveRecord& record = records.curves.front();
    if (record.curve && !isLine(layer, record.curve->polyline)) {
        return {
            .text = "Picks and options of " + name +
                    " were not kept: the layer was changed since its curve was drawn.",
            .isWarning = true
        };
    }
    if (!isFreeOrOurs(file)) {
        return {
            .text = "Picks and options of " + name + " were not kept: " + sideName +
                    " is there and is no file of curves; save the layer by another name.",
            .isWarning = true
        };
    }
    AtomicFile(file, recordsText(records)).commit();
    const std::string loss = lossOf(layer);
    if (loss.empty()) {
        return {.text = "Picks and options of " + name + " are kept in " + sideName + "."};
    }
    return {
        .text = loss + ". Picks and options are kept in " + sideName +
                "; choose OBJ to keep the line as well."
    };
}

}  // namespace

QString sideFileOf(const QString& file) {
    return file + ".bspline.json";
}

SavedLine writeSideFile(const MeshDocument& document, const MeshModel& layer) {
    const CurveSource* const source = sourceOf(layer);
    if (source == nullptr) {
        const std::string loss = isPolylineOfOurs(layer) ? lossOf(layer) : std::string();
        return {.text = loss.empty() ? loss : loss + "; choose OBJ to keep the lines."};
    }
    try {
        return savedCurve(document, layer, *source);
    } catch (const std::exception& error) {
        return {
            .text = "Picks and options of " + layer.shortName().toStdString() +
                    " were not kept: " + error.what(),
            .isWarning = true
        };
    }
}

bool isLine(const MeshModel& layer, const SurfacePolyline& line) {
    if (layer.cm.vert.size() != line.points.size() ||
        layer.cm.VN() != static_cast<int>(line.points.size())) {
        return false;
    }
    double largest = 0.0;
    for (const Vec3& point : line.points) {
        largest = std::max(largest, point.cwiseAbs().maxCoeff());
    }
    const double tolerance = kRoundedDecimals + kRoundedRelative * largest;
    for (std::size_t i = 0; i < line.points.size(); ++i) {
        const Vec3 gap = toVec3(layer.cm.vert[i].cP()) - line.points[i];
        if (!(gap.cwiseAbs().maxCoeff() <= tolerance)) {
            return false;
        }
    }
    return true;
}

}  // namespace bspline_curve

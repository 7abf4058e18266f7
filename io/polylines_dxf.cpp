// SPDX-License-Identifier: GPL-3.0-or-later
// Polylines of DXF files (Autodesk, DXF reference): pairs of a group code and a value, a line each.
#include "io/polyline_formats.h"
#include "io/text_parsing.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace bspline_curve {

namespace {

struct DxfPair {
    int code = 0;
    std::string_view value;
    std::size_t line = 0;
};

/// One entity, or a vertex of a polyline: its name and its pairs.
struct DxfEntity {
    std::string_view name;
    std::size_t line = 0;
    std::vector<DxfPair> pairs{};
};

// Flags (code 70).
constexpr int kClosed = 1;
constexpr int kSplineFit = 4;
constexpr int kIn3d = 8;
constexpr int kMesh = 16 | 64;
constexpr int kSplineFrame = 16;  // of a vertex

/// Curves that are no polylines.
constexpr std::array<std::string_view, 7> kOtherCurves = {
    "ARC", "CIRCLE", "ELLIPSE", "HELIX", "INSERT", "MLINE", "SPLINE"
};

/// The axes of an entity's own coordinates, by the arbitrary axis algorithm of the reference.
Eigen::Matrix3d axesOf(const Vec3& extrusion) {
    constexpr double kNearZ = 1.0 / 64.0;
    const Vec3 z = extrusion.normalized();
    const bool isNearZ = std::abs(z.x()) < kNearZ && std::abs(z.y()) < kNearZ;
    const Vec3 x = (isNearZ ? Vec3::UnitY() : Vec3::UnitZ()).cross(z).normalized();
    Eigen::Matrix3d axes;
    axes << x, z.cross(x), z;
    return axes;
}

class DxfLines {
public:
    DxfLines(const std::filesystem::path& file, std::string_view bytes)
        : file_(file), lines_(bytes) {}

    PolylineGraph run() {
        for (const DxfEntity& entity : entities()) {
            add(entity);
        }
        addWaiting();
        return std::move(graph_);
    }

private:
    std::optional<DxfPair> nextPair() {
        if (!lines_.next()) {
            return std::nullopt;
        }
        DxfPair pair{.code = 0, .value = {}, .line = lines_.number()};
        const std::optional<long long> code = parseInteger(trimmed(lines_.line()));
        if (!code) {
            if (trimmed(lines_.line()).empty()) {
                return std::nullopt;  // blank lines at the end
            }
            refuseLine(
                file_, pair.line, inQuotes(lines_.line()) + " is no group code; is it a DXF text?"
            );
        }
        if (!lines_.next()) {
            refuseLine(file_, pair.line, "the file ends after a group code");
        }
        pair.code = static_cast<int>(*code);
        pair.value = trimmed(lines_.line());
        return pair;
    }

    /// Those of the section ENTITIES.
    std::vector<DxfEntity> entities() {
        std::vector<DxfEntity> found;
        bool isSectionStart = false;
        bool isInside = false;
        bool hasSection = false;
        while (const std::optional<DxfPair> pair = nextPair()) {
            if (pair->code == 0) {
                isSectionStart = pair->value == "SECTION";
                isInside = isInside && pair->value != "ENDSEC" && !isSectionStart;
                if (isInside) {
                    found.push_back({.name = pair->value, .line = pair->line});
                }
            } else if (isSectionStart && pair->code == 2) {
                isInside = pair->value == "ENTITIES";
                hasSection = hasSection || isInside;
                isSectionStart = false;
            } else if (isInside && !found.empty()) {
                found.back().pairs.push_back(*pair);
            }
        }
        if (!hasSection) {
            refuseFile(file_, "has no section ENTITIES; is it a DXF text?");
        }
        return found;
    }

    [[nodiscard]] double number(const DxfPair& pair) const {
        const std::optional<double> value = parseNumber(pair.value);
        if (!value || !std::isfinite(*value)) {
            refuseLine(file_, pair.line + 1, inQuotes(pair.value) + " is not a finite number");
        }
        return *value;
    }

    /// The value of the first pair of a code.
    [[nodiscard]] double numberOf(const DxfEntity& entity, int code, double otherwise) const {
        const auto found = std::ranges::find(entity.pairs, code, &DxfPair::code);
        return found == entity.pairs.end() ? otherwise : number(*found);
    }

    [[nodiscard]] int flagsOf(const DxfEntity& entity) const {
        return static_cast<int>(numberOf(entity, 70, 0.0));
    }

    /// A point, whose axes are `code`, `code` + 10 and `code` + 20.
    [[nodiscard]] Vec3 pointOf(const DxfEntity& entity, int code) const {
        return {
            numberOf(entity, code, 0.0),
            numberOf(entity, code + 10, 0.0),
            numberOf(entity, code + 20, 0.0)
        };
    }

    [[nodiscard]] Eigen::Matrix3d axesOfEntity(const DxfEntity& entity) const {
        const Vec3 extrusion(
            numberOf(entity, 210, 0.0), numberOf(entity, 220, 0.0), numberOf(entity, 230, 1.0)
        );
        if (!(extrusion.norm() > 0.0)) {
            refuseLine(file_, entity.line, "an extrusion without length");
        }
        return axesOf(extrusion);
    }

    void add(const DxfEntity& entity) {
        if (entity.name == "VERTEX" && isWaiting_) {
            addVertex(entity);
            return;
        }
        addWaiting();
        if (entity.name == "LINE") {
            addPolyline({pointOf(entity, 10), pointOf(entity, 11)}, false);
        } else if (entity.name == "LWPOLYLINE") {
            addLight(entity);
        } else if (entity.name == "POLYLINE") {
            const int flags = flagsOf(entity);
            if ((flags & kMesh) != 0) {
                refuseLine(file_, entity.line, "a POLYLINE that is a mesh; give a curve");
            }
            isWaiting_ = true;
            waitingFlags_ = flags;
            waitingAxes_ =
                (flags & kIn3d) != 0 ? Eigen::Matrix3d::Identity().eval() : axesOfEntity(entity);
        } else if (std::ranges::find(kOtherCurves, entity.name) != kOtherCurves.end()) {
            refuseLine(
                file_,
                entity.line,
                "has the entity " + std::string(entity.name) +
                    ", but only LINE, POLYLINE and LWPOLYLINE are read; explode it or write "
                    "polylines"
            );
        }
    }

    void addVertex(const DxfEntity& entity) {
        refuseBulge(entity);
        const bool isFrame =
            (waitingFlags_ & kSplineFit) != 0 && (flagsOf(entity) & kSplineFrame) != 0;
        if (!isFrame) {
            waiting_.emplace_back(waitingAxes_ * pointOf(entity, 10));
        }
    }

    /// The polyline whose vertices came last.
    void addWaiting() {
        if (isWaiting_) {
            addPolyline(waiting_, (waitingFlags_ & kClosed) != 0);
            waiting_.clear();
            isWaiting_ = false;
        }
    }

    void addLight(const DxfEntity& entity) {
        refuseBulge(entity);
        const Eigen::Matrix3d axes = axesOfEntity(entity);
        const double elevation = numberOf(entity, 38, 0.0);
        std::vector<Vec3> points;
        for (const DxfPair& pair : entity.pairs) {
            if (pair.code == 10) {
                points.emplace_back(number(pair), 0.0, elevation);
            } else if (pair.code == 20 && !points.empty()) {
                points.back().y() = number(pair);
            }
        }
        for (Vec3& point : points) {
            point = axes * point;
        }
        addPolyline(points, (flagsOf(entity) & kClosed) != 0);
    }

    void refuseBulge(const DxfEntity& entity) const {
        for (const DxfPair& pair : entity.pairs) {
            if (pair.code == 42 && number(pair) != 0.0) {
                refuseLine(file_, pair.line, "a segment that is an arc (bulge); write it as lines");
            }
        }
    }

    void addPolyline(const std::vector<Vec3>& points, bool closed) {
        for (std::size_t i = 1; i < points.size(); ++i) {
            addEdge(points[i - 1], points[i]);
        }
        if (closed && points.size() > 2) {
            addEdge(points.back(), points.front());
        }
    }

    void addEdge(const Vec3& from, const Vec3& to) {
        const int a = indexOf(from);
        const int b = indexOf(to);
        if (a != b) {
            graph_.edges.push_back({a, b});
        }
    }

    int indexOf(const Vec3& point) {
        const auto [entry, isNew] = indices_.try_emplace(
            {point.x(), point.y(), point.z()}, static_cast<int>(graph_.points.size())
        );
        if (isNew) {
            graph_.points.push_back(point);
        }
        return entry->second;
    }

    const std::filesystem::path& file_;
    LineReader lines_;
    bool isWaiting_ = false;  // for the vertices of a POLYLINE
    int waitingFlags_ = 0;
    Eigen::Matrix3d waitingAxes_ = Eigen::Matrix3d::Identity();
    std::vector<Vec3> waiting_;
    std::map<std::array<double, 3>, int> indices_;
    PolylineGraph graph_;
};

}  // namespace

PolylineGraph polylinesOfDxf(const std::filesystem::path& file, std::string_view bytes) {
    if (bytes.starts_with("AutoCAD Binary DXF")) {
        refuseFile(file, "is a binary DXF file; save it as text");
    }
    return DxfLines(file, bytes).run();
}

}  // namespace bspline_curve

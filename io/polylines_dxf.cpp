// SPDX-License-Identifier: GPL-3.0-or-later
// Polylines of DXF files, in space.
#include "io/dxf_entities.h"
#include "io/polyline_formats.h"

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <utility>

namespace bspline_curve {

namespace {

/// Curves that are no polylines.
constexpr std::array<std::string_view, 7> kOtherCurves = {
    "ARC", "CIRCLE", "ELLIPSE", "HELIX", "INSERT", "MLINE", "SPLINE"
};

class DxfLines {
public:
    PolylineGraph run(const std::vector<DxfEntity>& entities) {
        for (const DxfEntity& entity : entities) {
            add(entity);
        }
        addWaiting();
        return std::move(graph_);
    }

private:
    void add(const DxfEntity& entity) {
        const std::string_view name = entity.name();
        if (name == "VERTEX" && isWaiting_) {
            addVertex(entity);
            return;
        }
        addWaiting();
        if (name == "LINE") {
            addPolyline({entity.pointOf(10), entity.pointOf(11)}, false);
        } else if (name == "LWPOLYLINE") {
            addLight(entity);
        } else if (name == "POLYLINE") {
            waitingFlags_ = entity.flags();
            if ((waitingFlags_ & DxfFlag::kMesh) != 0) {
                entity.refuse("a POLYLINE that is a mesh; give a curve");
            }
            isWaiting_ = true;
            waitingAxes_ = (waitingFlags_ & DxfFlag::kIn3d) != 0
                               ? Eigen::Matrix3d::Identity().eval()
                               : entity.axes();
        } else if (std::ranges::find(kOtherCurves, name) != kOtherCurves.end()) {
            entity.refuse(
                "has the entity " + std::string(name) +
                ", but only LINE, POLYLINE and LWPOLYLINE are read; explode it or write polylines"
            );
        }
    }

    void addVertex(const DxfEntity& entity) {
        refuseBulge(entity);
        const bool isFrame = (waitingFlags_ & DxfFlag::kSplineFit) != 0 &&
                             (entity.flags() & DxfFlag::kSplineFrame) != 0;
        if (!isFrame) {
            waiting_.emplace_back(waitingAxes_ * entity.pointOf(10));
        }
    }

    /// The polyline whose vertices came last.
    void addWaiting() {
        if (isWaiting_) {
            addPolyline(waiting_, (waitingFlags_ & DxfFlag::kClosed) != 0);
            waiting_.clear();
            isWaiting_ = false;
        }
    }

    void addLight(const DxfEntity& entity) {
        refuseBulge(entity);
        const Eigen::Matrix3d axes = entity.axes();
        const double elevation = entity.numberOf(38, 0.0);
        std::vector<Vec3> points;
        for (const DxfPair& pair : entity.pairs()) {
            if (pair.code == 10) {
                points.emplace_back(entity.number(pair), 0.0, elevation);
            } else if (pair.code == 20 && !points.empty()) {
                points.back().y() = entity.number(pair);
            }
        }
        for (Vec3& point : points) {
            point = axes * point;
        }
        addPolyline(points, (entity.flags() & DxfFlag::kClosed) != 0);
    }

    static void refuseBulge(const DxfEntity& entity) {
        if (std::ranges::any_of(entity.numbersOf(42), [](double bulge) { return bulge != 0.0; })) {
            entity.refuse("a segment that is an arc (bulge); write it as lines");
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

    bool isWaiting_ = false;  // for the vertices of a POLYLINE
    int waitingFlags_ = 0;
    Eigen::Matrix3d waitingAxes_ = Eigen::Matrix3d::Identity();
    std::vector<Vec3> waiting_;
    std::map<std::array<double, 3>, int> indices_;
    PolylineGraph graph_;
};

}  // namespace

PolylineGraph polylinesOfDxf(const std::filesystem::path& file, std::string_view bytes) {
    return DxfLines().run(dxfContent(file, bytes).entities);
}

}  // namespace bspline_curve

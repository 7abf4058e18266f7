// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/dxf_curves.h"

#include "io/dxf_entities.h"
#include "io/left_out.h"
#include "io/text_parsing.h"
#include "offset/face_layout.h"
#include "pattern/drawing.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

namespace bspline_curve {

namespace {

using Vec2 = Eigen::Vector2d;

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kRadians = std::numbers::pi / 180.0;
/// Blocks in blocks, at most.
constexpr std::size_t kMostDepth = 64;
/// Entities and their arcs that blocks in blocks come to, at most: files of a kilobyte can ask for
/// any number.
constexpr std::size_t kMostInserted = 1000000;

/// Entities that show something, but are no curves of this reader.
constexpr std::array<std::string_view, 7> kDxfLeftOut{
    "TEXT", "MTEXT", "HATCH", "DIMENSION", "LEADER", "MLINE", "HELIX"
};

/// A vertex of a polyline, and the tangent of a quarter of the angle of the arc after it.
struct BulgeVertex {
    Vec2 at;
    double bulge = 0.0;
};

/// From an entity's own coordinates, at a height, to those of the drawing.
Eigen::Affine3d ownPlane(const DxfEntity& entity, double height) {
    Eigen::Affine3d map = Eigen::Affine3d::Identity();
    map.linear() = entity.axes();
    map.translation() = height * entity.axes().col(2);
    return map;
}

SpaceArc lineBetween(const Vec3& from, const Vec3& to) {
    return {.points = {from, to}, .weights = {}};
}

/// Planar arcs at the height 0.
std::vector<SpaceArc> inSpace(const std::vector<DrawingArc>& arcs) {
    std::vector<SpaceArc> result;
    for (const DrawingArc& arc : arcs) {
        SpaceArc lifted{.points = {}, .weights = arc.weights};
        for (const Vec2& point : arc.points) {
            lifted.points.emplace_back(point.x(), point.y(), 0.0);
        }
        result.push_back(std::move(lifted));
    }
    return result;
}

SpacePath polylineThrough(std::vector<BulgeVertex> vertices, bool closed) {
    SpacePath path{.arcs = {}, .closed = closed};
    if (closed && !vertices.empty()) {
        vertices.push_back(vertices.front());
    }
    std::vector<DrawingArc> arcs;
    for (std::size_t i = 1; i < vertices.size(); ++i) {
        const auto& [from, bulge] = vertices[i - 1];
        const Vec2 to = vertices[i].at;
        if (from == to) {
            continue;
        }
        if (bulge == 0.0) {
            arcs.push_back({.points = {from, to}, .weights = {}});
            continue;
        }
        const Vec2 centre =
            0.5 * (from + to) + 0.25 * (1.0 / bulge - bulge) * turnedLeft(to - from);
        const Vec2 out = from - centre;
        std::vector<DrawingArc> bent =
            ellipticalArc(centre, out, turnedLeft(out), 0.0, 4.0 * std::atan(bulge));
        bent.front().points.front() = from;
        bent.back().points.back() = to;
        std::ranges::move(bent, std::back_inserter(arcs));
    }
    path.arcs = inSpace(arcs);
    return path;
}

SpacePath mapped(SpacePath path, const Eigen::Affine3d& map) {
    for (SpaceArc& arc : path.arcs) {
        for (Vec3& point : arc.points) {
            point = map * point;
        }
    }
    return path;
}

// ---- one entity ----

SpacePath circleOf(const DxfEntity& entity) {
    const double radius = entity.numberOf(40, 0.0);
    if (!(radius > 0.0)) {
        entity.refuse("a radius that is not > 0");
    }
    const bool isWhole = entity.name() == "CIRCLE";
    const double from = isWhole ? 0.0 : entity.numberOf(50, 0.0) * kRadians;
    double sweep = isWhole ? kTurn : entity.numberOf(51, 360.0) * kRadians - from;
    sweep += sweep <= 0.0 ? kTurn * std::ceil(-sweep / kTurn + 1e-12) : 0.0;
    const Vec3 centre = entity.pointOf(10);
    return mapped(
        {.arcs = inSpace(ellipticalArc(
             centre.head<2>(), Vec2(radius, 0.0), Vec2(0.0, radius), from, std::min(sweep, kTurn)
         )),
         .closed = isWhole},
        ownPlane(entity, centre.z())
    );
}

SpacePath ellipseOf(const DxfEntity& entity) {
    const Vec3 major = entity.pointOf(11);
    const Vec3 minor = entity.numberOf(40, 1.0) * Vec3(entity.axes().col(2)).cross(major);
    if (!(major.norm() > 0.0) || !(minor.norm() > 0.0)) {
        entity.refuse("an ellipse without size");
    }
    const double from = entity.numberOf(41, 0.0);
    double sweep = entity.numberOf(42, kTurn) - from;
    sweep += sweep <= 0.0 ? kTurn : 0.0;
    constexpr double kWhole = kTurn * (1.0 - 1e-9);
    const bool isWhole = sweep >= kWhole;
    Eigen::Affine3d plane = Eigen::Affine3d::Identity();
    plane.linear() << major, minor, Vec3::Zero();
    plane.translation() = entity.pointOf(10);
    return mapped(
        {.arcs = inSpace(ellipticalArc(
             Vec2::Zero(), Vec2::UnitX(), Vec2::UnitY(), from, isWhole ? kTurn : sweep
         )),
         .closed = isWhole},
        plane
    );
}

SpacePath lightPolylineOf(const DxfEntity& entity) {
    std::vector<BulgeVertex> vertices;
    for (const DxfPair& pair : entity.pairs()) {
        if (pair.code == 10) {
            vertices.push_back({.at = {entity.number(pair), 0.0}});
        } else if (pair.code == 20 && !vertices.empty()) {
            vertices.back().at.y() = entity.number(pair);
        } else if (pair.code == 42 && !vertices.empty()) {
            vertices.back().bulge = entity.number(pair);
        }
    }
    return mapped(
        polylineThrough(std::move(vertices), (entity.flags() & DxfFlag::kClosed) != 0),
        ownPlane(entity, entity.numberOf(38, 0.0))
    );
}

SpacePath polylineInSpace(std::span<const DxfEntity> vertices, bool closed) {
    SpacePath path{.arcs = {}, .closed = closed};
    std::vector<Vec3> points;
    for (const DxfEntity& vertex : vertices) {
        points.push_back(vertex.pointOf(10));
    }
    if (closed && !points.empty()) {
        points.push_back(points.front());
    }
    for (std::size_t i = 1; i < points.size(); ++i) {
        if (points[i] != points[i - 1]) {
            path.arcs.push_back(lineBetween(points[i - 1], points[i]));
        }
    }
    return path;
}

SpacePath oldPolylineOf(const DxfEntity& entity, std::span<const DxfEntity> vertexEntities) {
    const int flags = entity.flags();
    if ((flags & DxfFlag::kMesh) != 0) {
        entity.refuse("a POLYLINE that is a mesh; give a curve");
    }
    std::vector<DxfEntity> vertices;
    std::ranges::copy_if(vertexEntities, std::back_inserter(vertices), [&](const DxfEntity& each) {
        return (flags & DxfFlag::kSplineFit) == 0 || (each.flags() & DxfFlag::kSplineFrame) == 0;
    });
    const bool closed = (flags & DxfFlag::kClosed) != 0;
    if ((flags & DxfFlag::kIn3d) != 0) {
        return polylineInSpace(vertices, closed);
    }
    std::vector<BulgeVertex> planar;
    for (const DxfEntity& vertex : vertices) {
        planar.push_back({.at = vertex.pointOf(10).head<2>(), .bulge = vertex.numberOf(42, 0.0)});
    }
    const double height = vertices.empty() ? 0.0 : vertices.front().pointOf(10).z();
    return mapped(
        polylineThrough(std::move(planar), closed),
        ownPlane(entity, height != 0.0 ? height : entity.pointOf(10).z())
    );
}

std::vector<Vec3> pointsOf(const DxfEntity& entity, int code) {
    const std::vector<double> x = entity.numbersOf(code);
    const std::vector<double> y = entity.numbersOf(code + 10);
    const std::vector<double> z = entity.numbersOf(code + 20);
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
        points.emplace_back(x[i], y[i], i < z.size() ? z[i] : 0.0);
    }
    return points;
}

SpacePath splineOf(const DxfEntity& entity) {
    constexpr int kFitPoints = 11;
    const SpaceSpline spline{
        .degree = entity.integerOf(71, 3),
        .knots = entity.numbersOf(40),
        .points = pointsOf(entity, 10),
        .weights = entity.numbersOf(41)
    };
    SpacePath path;
    if (spline.points.empty()) {
        path.arcs = arcsThrough(
            pointsOf(entity, kFitPoints),
            entity.pointOf(12),
            entity.pointOf(13),
            (entity.flags() & DxfFlag::kClosed) != 0
        );
        if (path.arcs.empty()) {
            entity.refuse("a SPLINE without control points and without two fit points");
        }
    } else {
        try {
            path.arcs = arcsOf(spline);
        } catch (const std::invalid_argument& error) {
            entity.refuse(error.what());
        }
    }
    if (!path.arcs.empty()) {
        closeWhereEndsMeet(path);
    }
    return path;
}

// ---- all entities ----

class DxfCurveReader {
public:
    DxfCurveReader(
        const std::filesystem::path& file,
        const DxfContent& content,
        const std::vector<std::string>& layers
    )
        : file_(file), leftOut_(file) {
        for (const std::string& layer : layers) {
            wanted_.insert(lowerCase(layer));
        }
        for (const DxfEntity& entry : content.tables) {
            if (entry.name() == "LAYER") {
                constexpr int kFrozen = 1;
                const std::string name = lowerCase(entry.textOf(2));
                layers_.insert(name);
                if (entry.integerOf(62, 1) < 0 || (entry.flags() & kFrozen) != 0) {
                    hiddenLayers_.insert(name);
                }
            }
        }
        collectBlocks(content);
        checkLayers(content, layers);
    }

    DxfCurves read(std::span<const DxfEntity> entities) {
        drawAll(entities, {.map = Eigen::Affine3d::Identity(), .layer = "0"});
        if (curves_.paths.empty()) {
            refuseEmpty();
        }
        for (const auto& [name, count] : others_) {
            curves_.notes.push_back(
                file_.filename().string() + ": " + std::to_string(count) + " " + name +
                " left out; turn text and hatches into lines in your drawing program"
            );
        }
        if (hidden_ > 0) {
            curves_.notes.push_back(
                file_.filename().string() + ": " + std::to_string(hidden_) +
                (hidden_ == 1 ? " entity" : " entities") + kHiddenWhere + " left out"
            );
        }
        if (!leftOut_.empty()) {
            curves_.notes.push_back(leftOut_.note("entity", "entities"));
        }
        return std::move(curves_);
    }

private:
    static constexpr const char* kHiddenWhere =
        " in paper space, invisible, or on layers that are off, frozen or not asked for";

    struct Block {
        Vec3 base;
        std::span<const DxfEntity> entities;
    };

    /// Where entities are drawn: what the entities of the layer 0 of a block take over.
    struct Placing {
        Eigen::Affine3d map;
        std::string layer;
    };

    void collectBlocks(const DxfContent& content) {
        for (std::size_t i = 0; i < content.blocks.size(); ++i) {
            if (content.blocks[i].name() != "BLOCK") {
                continue;
            }
            std::size_t end = i + 1;
            while (end < content.blocks.size() && content.blocks[end].name() != "ENDBLK") {
                ++end;
            }
            blocks_.emplace(
                lowerCase(content.blocks[i].textOf(2)),
                Block{
                    .base = content.blocks[i].pointOf(10),
                    .entities = std::span(content.blocks).subspan(i + 1, end - i - 1)
                }
            );
            i = end;
        }
    }

    /// Refuses names of layers that the file does not have.
    void checkLayers(const DxfContent& content, const std::vector<std::string>& asked) {
        for (const auto* const list : {&content.entities, &content.blocks}) {
            for (const DxfEntity& entity : *list) {
                layers_.insert(layerNamed(entity));
            }
        }
        for (const std::string& layer : asked) {
            if (!layers_.contains(lowerCase(layer))) {
                std::string known;
                for (const std::string& each : layers_) {
                    known.append(known.empty() ? "" : ", ").append(each);
                }
                refuseFile(file_, "has no layer " + inQuotes(layer) + " but " + known);
            }
        }
    }

    [[noreturn]] void refuseEmpty() const {
        if (!leftOut_.empty()) {
            leftOut_.refuse();
        }
        std::string reason = "has no curve";
        if (hidden_ > 0) {
            reason += ": all its entities are" + std::string(kHiddenWhere);
        } else if (!others_.empty()) {
            reason += "; turn text and hatches into lines in your drawing program";
        }
        refuseFile(file_, reason);
    }

    static std::string layerNamed(const DxfEntity& entity) {
        const std::string_view name = entity.textOf(8);
        return name.empty() ? "0" : lowerCase(name);
    }

    /// The layer that an entity shows on.
    static std::string layerOf(const DxfEntity& entity, const Placing& placing) {
        std::string name = layerNamed(entity);
        return name == "0" ? placing.layer : name;
    }

    [[nodiscard]] bool isHidden(const DxfEntity& entity, const Placing& placing) const {
        if (entity.integerOf(60, 0) != 0 || entity.integerOf(67, 0) != 0) {
            return true;
        }
        const std::string layer = layerOf(entity, placing);
        if (!wanted_.empty()) {
            // A block is looked into: what it holds has layers of its own.
            return entity.name() != "INSERT" && !wanted_.contains(layer);
        }
        return hiddenLayers_.contains(layer);
    }

    void drawAll(std::span<const DxfEntity> entities, const Placing& placing) {
        for (std::size_t i = 0; i < entities.size(); ++i) {
            const DxfEntity& entity = entities[i];
            std::size_t end = i + 1;
            while (entity.name() == "POLYLINE" && end < entities.size() &&
                   entities[end].name() == "VERTEX") {
                ++end;
            }
            const std::span<const DxfEntity> vertices = entities.subspan(i + 1, end - i - 1);
            i = end - 1;
            count(1);
            SpacePath path;
            try {
                if (isHidden(entity, placing)) {
                    hidden_ += isCurve(entity) ? 1 : 0;
                    continue;
                }
                if (entity.name() != "INSERT") {
                    path = mapped(curveOf(entity, vertices), placing.map);
                }
            } catch (const InputError& error) {
                leftOut_.add(error);
                continue;
            }
            if (entity.name() == "INSERT") {
                insert(entity, placing);
            }
            add(std::move(path), entity);
        }
    }

    static bool isCurve(const DxfEntity& entity) {
        constexpr std::array<std::string_view, 8> kCurves{
            "LINE", "CIRCLE", "ARC", "ELLIPSE", "LWPOLYLINE", "POLYLINE", "SPLINE", "INSERT"
        };
        return std::ranges::find(kCurves, entity.name()) != kCurves.end();
    }

    SpacePath curveOf(const DxfEntity& entity, std::span<const DxfEntity> vertices) {
        const std::string_view name = entity.name();
        if (name == "LINE") {
            return {.arcs = {lineBetween(entity.pointOf(10), entity.pointOf(11))}};
        }
        if (name == "CIRCLE" || name == "ARC") {
            return circleOf(entity);
        }
        if (name == "ELLIPSE") {
            return ellipseOf(entity);
        }
        if (name == "LWPOLYLINE") {
            return lightPolylineOf(entity);
        }
        if (name == "POLYLINE") {
            return oldPolylineOf(entity, vertices);
        }
        if (name == "SPLINE") {
            return splineOf(entity);
        }
        if (std::ranges::find(kDxfLeftOut, name) != kDxfLeftOut.end()) {
            ++others_[std::string(name)];
        }
        return {};
    }

    void add(SpacePath&& path, const DxfEntity& entity) {
        count(path.arcs.size());
        const bool isFinite = std::ranges::all_of(path.arcs, [](const SpaceArc& arc) {
            return std::ranges::all_of(arc.points, [](const Vec3& p) { return p.allFinite(); });
        });
        if (!isFinite) {
            leftOut_.add(entity.line(), "its numbers are too large");
        } else if (!path.arcs.empty()) {
            curves_.paths.push_back(std::move(path));
        }
    }

    /// Counts what blocks bring.
    void count(std::size_t parts) {
        inserted_ += open_.empty() ? 0 : parts;
        if (inserted_ > kMostInserted) {
            refuseFile(
                file_,
                "blocks in blocks come to more than " + std::to_string(kMostInserted) +
                    " entities; explode what you need into a file of its own"
            );
        }
    }

    void insert(const DxfEntity& entity, const Placing& outer) {
        const std::string name = lowerCase(entity.textOf(2));
        const auto found = blocks_.find(name);
        if (found == blocks_.end()) {
            leftOut_.add(entity.line(), "there is no block " + inQuotes(entity.textOf(2)));
            return;
        }
        if (open_.contains(name) || open_.size() >= kMostDepth) {
            leftOut_.add(entity.line(), "blocks insert each other without end");
            return;
        }
        Placing inner{.map = outer.map, .layer = layerOf(entity, outer)};
        open_.insert(name);
        try {
            const Vec3 at = entity.pointOf(10);
            const Vec2 steps(entity.numberOf(44, 0.0), entity.numberOf(45, 0.0));
            const int columns = std::max(1, entity.integerOf(70, 1));
            const int rows = std::max(1, entity.integerOf(71, 1));
            const double angle = entity.numberOf(50, 0.0) * kRadians;
            const Vec3 scale(
                entity.numberOf(41, 1.0), entity.numberOf(42, 1.0), entity.numberOf(43, 1.0)
            );
            for (int column = 0; column < columns; ++column) {
                for (int row = 0; row < rows; ++row) {
                    count(1);
                    inner.map = outer.map * ownPlane(entity, 0.0);
                    inner.map.translate(at)
                        .rotate(Eigen::AngleAxisd(angle, Vec3::UnitZ()))
                        .translate(Vec3(column * steps.x(), row * steps.y(), 0.0))
                        .scale(scale)
                        .translate(-found->second.base);
                    drawAll(found->second.entities, inner);
                }
            }
        } catch (const InputError& error) {
            open_.erase(name);
            if (inserted_ > kMostInserted) {
                throw;
            }
            leftOut_.add(error);
            return;
        }
        open_.erase(name);
    }

    const std::filesystem::path& file_;
    std::map<std::string, Block, std::less<>> blocks_;
    std::set<std::string> layers_, hiddenLayers_, wanted_;
    std::set<std::string> open_;  // blocks that are being drawn
    DxfCurves curves_;
    std::map<std::string, int> others_;
    LeftOut leftOut_;
    std::size_t inserted_ = 0;
    int hidden_ = 0;
};

}  // namespace

DxfCurves curvesOfDxf(
    const std::filesystem::path& file,
    std::string_view bytes,
    const std::vector<std::string>& layers
) {
    const DxfContent content = dxfContent(file, bytes);
    return DxfCurveReader(file, content, layers).read(content.entities);
}

}  // namespace bspline_curve

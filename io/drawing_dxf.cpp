// SPDX-License-Identifier: GPL-3.0-or-later
// Curves of DXF files as paths of the plane z = 0, seen from above.
#include "io/drawing_formats.h"
#include "io/dxf_entities.h"
#include "offset/face_layout.h"
#include "pattern/drawing_chains.h"
#include "pattern/spline_arcs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

namespace bspline_curve {

namespace {

using Vec2 = Eigen::Vector2d;

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kRadians = std::numbers::pi / 180.0;
/// Blocks that insert blocks, at most.
constexpr int kMostInserts = 32;

/// Entities that show something, but have no paths.
constexpr std::array<std::string_view, 7> kDxfLeftOut{
    "TEXT", "MTEXT", "HATCH", "DIMENSION", "LEADER", "MLINE", "HELIX"
};

/// A vertex of a polyline, and the tangent of a quarter of the angle of the arc after it.
struct BulgeVertex {
    Vec2 at;
    double bulge = 0.0;
};

void drawPolyline(DrawingBuilder& pen, std::vector<BulgeVertex> vertices, bool closed) {
    if (vertices.size() < 2) {
        return;
    }
    if (closed) {
        vertices.push_back(vertices.front());
    }
    pen.moveTo(vertices.front().at);
    for (std::size_t i = 1; i < vertices.size(); ++i) {
        const auto& [from, bulge] = vertices[i - 1];
        const Vec2 to = vertices[i].at;
        if (bulge == 0.0 || from == to) {
            pen.lineTo(to);
            continue;
        }
        const Vec2 centre =
            0.5 * (from + to) + 0.25 * (1.0 / bulge - bulge) * turnedLeft(to - from);
        const Vec2 out = from - centre;
        std::vector<DrawingArc> arcs =
            ellipticalArc(centre, out, turnedLeft(out), 0.0, 4.0 * std::atan(bulge));
        arcs.back().points.back() = to;
        pen.follow(arcs);
    }
    if (closed) {
        pen.close();
    }
}

class DxfDrawing {
public:
    DxfDrawing(const std::filesystem::path& file, const DxfContent& content) : file_(file) {
        for (std::size_t i = 0; i < content.blocks.size(); ++i) {
            if (content.blocks[i].name() == "BLOCK") {
                std::size_t end = i + 1;
                while (end < content.blocks.size() && content.blocks[end].name() != "ENDBLK") {
                    ++end;
                }
                blocks_.emplace(
                    content.blocks[i].textOf(2),
                    Block{
                        .base = content.blocks[i].pointOf(10).head<2>(),
                        .entities = std::span(content.blocks).subspan(i + 1, end - i - 1)
                    }
                );
                i = end;
            }
        }
    }

    DrawingFile read(std::span<const DxfEntity> entities) {
        drawAll(entities, Eigen::Affine2d::Identity());
        DrawingFile result;
        result.drawing = chained(drawing_);
        for (const auto& [name, count] : leftOut_) {
            result.notes.push_back(
                file_.filename().string() + ": " + std::to_string(count) + " " + name +
                " left out; turn text and hatches into lines in your drawing program"
            );
        }
        return result;
    }

private:
    struct Block {
        Vec2 base;
        std::span<const DxfEntity> entities;
    };

    void drawAll(std::span<const DxfEntity> entities, const Eigen::Affine2d& map) {
        for (std::size_t i = 0; i < entities.size(); ++i) {
            const DxfEntity& entity = entities[i];
            if (entity.name() == "INSERT") {
                insert(entity, map);
                continue;
            }
            DrawingBuilder pen;
            if (entity.name() == "POLYLINE") {
                std::size_t end = i + 1;
                while (end < entities.size() && entities[end].name() == "VERTEX") {
                    ++end;
                }
                drawOld(pen, entity, entities.subspan(i + 1, end - i - 1));
            } else {
                draw(pen, entity);
            }
            add(pen.take(), map, entity);
        }
    }

    void add(Drawing&& drawn, const Eigen::Affine2d& map, const DxfEntity& entity) {
        for (DrawingPath& path : mapped(std::move(drawn), map).paths) {
            drawing_.paths.push_back(std::move(path));
        }
        if (drawing_.paths.size() > kMostPaths) {
            entity.refuse("the file has more than 1000000 curves");
        }
    }

    /// From an entity's own coordinates, at a height, to x and y of the drawing.
    static Eigen::Affine2d ownPlane(const DxfEntity& entity, double height) {
        const Eigen::Matrix3d axes = entity.axes();
        Eigen::Affine2d map = Eigen::Affine2d::Identity();
        map.linear() = axes.topLeftCorner<2, 2>();
        map.translation() = height * axes.topRightCorner<2, 1>();
        return map;
    }

    void insert(const DxfEntity& entity, const Eigen::Affine2d& outer) {
        const auto found = blocks_.find(entity.textOf(2));
        if (found == blocks_.end()) {
            entity.refuse("there is no block \"" + std::string(entity.textOf(2)) + "\"");
        }
        if (++inserts_ > kMostInserts) {
            entity.refuse("blocks insert each other without end");
        }
        const Vec3 at = entity.pointOf(10);
        const Vec2 steps(entity.numberOf(44, 0.0), entity.numberOf(45, 0.0));
        const int columns = std::max(1, static_cast<int>(entity.numberOf(70, 1.0)));
        const int rows = std::max(1, static_cast<int>(entity.numberOf(71, 1.0)));
        const double angle = entity.numberOf(50, 0.0) * kRadians;
        for (int column = 0; column < columns; ++column) {
            for (int row = 0; row < rows; ++row) {
                Eigen::Affine2d map = outer * ownPlane(entity, at.z());
                map.translate(Vec2(at.head<2>()))
                    .rotate(angle)
                    .translate(Vec2(column * steps.x(), row * steps.y()))
                    .scale(Vec2(entity.numberOf(41, 1.0), entity.numberOf(42, 1.0)))
                    .translate(-found->second.base);
                drawAll(found->second.entities, map);
            }
        }
        --inserts_;
    }

    void draw(DrawingBuilder& pen, const DxfEntity& entity) {
        const std::string_view name = entity.name();
        if (name == "LINE") {
            pen.moveTo(entity.pointOf(10).head<2>());
            pen.lineTo(entity.pointOf(11).head<2>());
        } else if (name == "CIRCLE" || name == "ARC") {
            drawCircle(pen, entity);
        } else if (name == "ELLIPSE") {
            drawEllipse(pen, entity);
        } else if (name == "LWPOLYLINE") {
            drawLight(pen, entity);
        } else if (name == "SPLINE") {
            drawSpline(pen, entity);
        } else if (std::ranges::find(kDxfLeftOut, name) != kDxfLeftOut.end()) {
            ++leftOut_[std::string(name)];
        }
    }

    static void drawArcs(DrawingBuilder& pen, const std::vector<DrawingArc>& arcs, bool closed) {
        pen.moveTo(arcs.front().points.front());
        pen.follow(arcs);
        if (closed) {
            pen.close();
        }
    }

    static void drawCircle(DrawingBuilder& pen, const DxfEntity& entity) {
        const double radius = entity.numberOf(40, 0.0);
        if (!(radius > 0.0)) {
            entity.refuse("a radius that is not > 0");
        }
        const bool isWhole = entity.name() == "CIRCLE";
        const double from = isWhole ? 0.0 : entity.numberOf(50, 0.0) * kRadians;
        double sweep = isWhole ? kTurn : entity.numberOf(51, 360.0) * kRadians - from;
        sweep += sweep <= 0.0 ? kTurn * std::ceil(-sweep / kTurn + 1e-12) : 0.0;
        const Vec3 centre = entity.pointOf(10);
        const Eigen::Affine2d plane = ownPlane(entity, centre.z());
        drawArcs(
            pen,
            ellipticalArc(
                plane * Vec2(centre.head<2>()),
                plane.linear() * Vec2(radius, 0.0),
                plane.linear() * Vec2(0.0, radius),
                from,
                std::min(sweep, kTurn)
            ),
            isWhole
        );
    }

    static void drawEllipse(DrawingBuilder& pen, const DxfEntity& entity) {
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
        drawArcs(
            pen,
            ellipticalArc(
                entity.pointOf(10).head<2>(),
                major.head<2>(),
                minor.head<2>(),
                from,
                isWhole ? kTurn : sweep
            ),
            isWhole
        );
    }

    static void drawLight(DrawingBuilder& pen, const DxfEntity& entity) {
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
        drawOwn(pen, entity, vertices, entity.numberOf(38, 0.0));
    }

    /// A polyline in an entity's own coordinates.
    static void drawOwn(
        DrawingBuilder& pen,
        const DxfEntity& entity,
        std::vector<BulgeVertex> vertices,
        double height
    ) {
        const Eigen::Affine2d plane = ownPlane(entity, height);
        const double turn = plane.linear().determinant() < 0.0 ? -1.0 : 1.0;
        for (BulgeVertex& vertex : vertices) {
            vertex.at = plane * vertex.at;
            vertex.bulge *= turn;
        }
        drawPolyline(pen, std::move(vertices), (entity.flags() & DxfFlag::kClosed) != 0);
    }

    static void drawOld(
        DrawingBuilder& pen, const DxfEntity& entity, std::span<const DxfEntity> vertexEntities
    ) {
        const int flags = entity.flags();
        if ((flags & DxfFlag::kMesh) != 0) {
            return;  // a mesh is no curve
        }
        std::vector<BulgeVertex> vertices;
        for (const DxfEntity& vertex : vertexEntities) {
            if ((flags & DxfFlag::kSplineFit) != 0 &&
                (vertex.flags() & DxfFlag::kSplineFrame) != 0) {
                continue;
            }
            vertices.push_back(
                {.at = vertex.pointOf(10).head<2>(), .bulge = vertex.numberOf(42, 0.0)}
            );
        }
        if ((flags & DxfFlag::kIn3d) != 0) {
            drawPolyline(pen, std::move(vertices), (flags & DxfFlag::kClosed) != 0);
        } else {
            drawOwn(pen, entity, std::move(vertices), entity.pointOf(10).z());
        }
    }

    static void drawSpline(DrawingBuilder& pen, const DxfEntity& entity) {
        PlanarSpline spline{
            .degree = static_cast<int>(entity.numberOf(71, 3.0)),
            .knots = entity.numbersOf(40),
            .points = {},
            .weights = entity.numbersOf(41)
        };
        const std::vector<double> x = entity.numbersOf(10);
        const std::vector<double> y = entity.numbersOf(20);
        for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
            spline.points.emplace_back(x[i], y[i]);
        }
        if (spline.points.empty()) {
            entity.refuse("a SPLINE without control points; save it with them");
        }
        try {
            drawArcs(pen, arcsOf(spline), false);
        } catch (const std::invalid_argument& error) {
            entity.refuse(error.what());
        }
    }

    const std::filesystem::path& file_;
    std::map<std::string_view, Block> blocks_;
    Drawing drawing_;
    std::map<std::string, int> leftOut_;
    int inserts_ = 0;
};

}  // namespace

DrawingFile drawingOfDxf(const std::filesystem::path& file, std::string_view bytes) {
    const DxfContent content = dxfContent(file, bytes);
    return DxfDrawing(file, content).read(content.entities);
}

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "edit_bspline_curve/common/sketch_painter.h"
#include "offscreen_context.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace bspline_curve::test_support {

constexpr int kWidth = 640;
constexpr int kHeight = 480;
constexpr double kTangentPixels = 40.0;  // handles of directions are so far from their picks

/// The pixels of a view.
class Pixels {
public:
    Pixels();  ///< those of the current context

    /// Row 0 is the lowest. Black beside the view.
    [[nodiscard]] SketchColour at(int x, int y) const;

    [[nodiscard]] int count(const SketchColour& colour) const;
    /// Pixels within some distance of a place that have a colour.
    [[nodiscard]] int countNear(
        const Eigen::Vector2d& place, double radius, const SketchColour& colour
    ) const;

    /// As a PNG into the folder that the variable BSPLINE_CURVE_PICTURES of the environment names,
    /// if any.
    void save(const std::string& name) const;

private:
    std::vector<std::uint8_t> values_;
};

/// What a mesh looks like: of one colour, or with a texture of squares of two.
struct Look {
    SketchColour colour{192, 192, 192};
    SketchColour other;
    bool isChecked = false;
};

/// A mesh in a view, without light, and a session on it.
class PaintedScene {
public:
    /// Seen along -z, from a distance of 2.5 diagonals.
    explicit PaintedScene(const TriangleMesh& mesh);

    Look look;
    SketchColour behind{90, 90, 130};  ///< where there is no mesh
    bool isOrthographic = false;
    double ratio = 1.0;
    double zoom = 1.0;
    double tilt = 0.0;  ///< degrees, about the x axis: 90 shows what faces y
    double cut = 0.5;   ///< where the near plane is: 0 at the eye, 1 through the mesh's centre

    DrawingSession& session() { return *session_; }

    /// With the settings as they are, also for the next calls.
    Pixels withoutSketch();
    Pixels withSketch();

    /// Of the last drawing.
    [[nodiscard]] const View& view() const { return *view_; }

    /// Where a point is, in the pixels.
    [[nodiscard]] Eigen::Vector2d pixelOf(const Vec3& point) const;

    [[nodiscard]] Pointer over(const Vec3& point) const;

    void addPicks(const std::vector<Vec3>& points);
    /// The point of the surface nearest to one of space.
    [[nodiscard]] SurfacePoint nearest(const Vec3& point) const;
    [[nodiscard]] Vec3 positionOf(const SurfacePoint& point) const;
    /// Moves the pointer there, and waits for the preview.
    void preview(const Pointer& pointer);

private:
    void drawMesh();

    std::shared_ptr<const Workpiece> workpiece_;
    std::unique_ptr<DrawingSession> session_;
    std::unique_ptr<View> view_;
    Vec3 centre_;
    double diagonal_;
};

/// Contrast ratio of two colours, from 1 to 21, as the Web Content Accessibility Guidelines define
/// it.
[[nodiscard]] double contrast(const SketchColour& a, const SketchColour& b);

/// The largest contrast of a pixel within `radius` pixels of a place to what it covers.
[[nodiscard]] double contrastNear(
    const Pixels& with, const Pixels& without, const Eigen::Vector2d& place, double radius = 4.0
);

}  // namespace bspline_curve::test_support

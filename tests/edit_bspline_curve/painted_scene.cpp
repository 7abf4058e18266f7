// SPDX-License-Identifier: GPL-3.0-or-later
#include "painted_scene.h"

#include "bspline_curve/mesh.h"
#include "edit_bspline_curve/common/line_style.h"

#include <QImage>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <thread>

namespace bspline_curve::test_support {
namespace {

void useTexture(const Look& look) {
    constexpr int kSide = 64;  // squares
    std::vector<std::uint8_t> texels;
    for (int i = 0; i < kSide * kSide; ++i) {
        const bool isOdd = (i % kSide + i / kSide) % 2 == 1;
        const SketchColour& colour = isOdd && look.isChecked ? look.other : look.colour;
        texels.insert(texels.end(), {colour.red, colour.green, colour.blue});
    }
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(
        GL_TEXTURE_2D, 0, GL_RGB8, kSide, kSide, 0, GL_RGB, GL_UNSIGNED_BYTE, texels.data()
    );
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);
}

}  // namespace

Pixels::Pixels() : values_(std::size_t{3} * kWidth * kHeight) {
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, kWidth, kHeight, GL_RGB, GL_UNSIGNED_BYTE, values_.data());
}

SketchColour Pixels::at(int x, int y) const {
    if (x < 0 || y < 0 || x >= kWidth || y >= kHeight) {
        return {};
    }
    const std::uint8_t* const pixel = &values_[std::size_t{3} * (y * kWidth + x)];
    return {pixel[0], pixel[1], pixel[2]};
}

int Pixels::count(const SketchColour& colour) const {
    return countNear({kWidth / 2.0, kHeight / 2.0}, kWidth, colour);
}

int Pixels::countNear(
    const Eigen::Vector2d& place, double radius, const SketchColour& colour
) const {
    int found = 0;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const bool isNear = (Eigen::Vector2d(x + 0.5, y + 0.5) - place).norm() <= radius;
            found += isNear && at(x, y) == colour ? 1 : 0;
        }
    }
    return found;
}

void Pixels::save(const std::string& name) const {
    if (const char* const folder = std::getenv("BSPLINE_CURVE_PICTURES")) {
        const QImage image(values_.data(), kWidth, kHeight, 3 * kWidth, QImage::Format_RGB888);
        static_cast<void>(
            image.mirrored().save(QString::fromStdString(folder + ("/" + name + ".png")))
        );
    }
}

PaintedScene::PaintedScene(const TriangleMesh& mesh)
    : workpiece_(std::make_shared<const Workpiece>(mesh)),
      session_(
          std::make_unique<DrawingSession>(
              workpiece_, SessionSettings{.handlePixels = kTangentPixels}
          )
      ) {
    Vec3 low = mesh.vertices.front();
    Vec3 high = low;
    for (const Vec3& vertex : mesh.vertices) {
        low = low.cwiseMin(vertex);
        high = high.cwiseMax(vertex);
    }
    centre_ = 0.5 * (low + high);
    diagonal_ = (high - low).norm();
}

void PaintedScene::drawMesh() {
    useTexture(look);
    glColor4ub(255, 255, 255, 255);
    glBegin(GL_TRIANGLES);
    for (const Triangle& face : workpiece_->mesh().faces) {
        for (int k = 0; k < 3; ++k) {
            const Vec3& p = workpiece_->mesh().vertices[face[k]];
            glTexCoord2d(p.x() / diagonal_, p.y() / diagonal_);
            glVertex3d(p.x(), p.y(), p.z());
        }
    }
    glEnd();
}

Pixels PaintedScene::withoutSketch() {
    glViewport(0, 0, kWidth, kHeight);
    glClearColor(behind.red / 255.0F, behind.green / 255.0F, behind.blue / 255.0F, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    const double distance = 2.5 * diagonal_;
    const double near = cut * distance;
    const double half = 0.3 * diagonal_ / zoom;
    const double wide = half * kWidth / kHeight;
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    if (isOrthographic) {
        glOrtho(-wide, wide, -half, half, near, 2.0 * distance);
    } else {
        const double share = near / distance;
        glFrustum(-wide * share, wide * share, -half * share, half * share, near, 2.0 * distance);
    }
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glTranslated(0.0, 0.0, -distance);
    glRotated(tilt, 1.0, 0.0, 0.0);
    glTranslated(-centre_.x(), -centre_.y(), -centre_.z());
    drawMesh();
    view_ = std::make_unique<View>(ratio, kHeight);
    return {};
}

Pixels PaintedScene::withSketch() {
    static_cast<void>(withoutSketch());
    static_cast<void>(session_->update());
    paintSketch(*session_, *view_);
    return {};
}

Eigen::Vector2d PaintedScene::pixelOf(const Vec3& point) const {
    const QPointF place = ratio * view_->positionOf(point);
    return {place.x(), kHeight - place.y()};
}

Pointer PaintedScene::over(const Vec3& point) const {
    return view_->pointerAt(view_->positionOf(point));
}

void PaintedScene::addPicks(const std::vector<Vec3>& points) {
    for (const Vec3& point : points) {
        session_->addPick(nearest(point));
    }
    session_->settle();
}

SurfacePoint PaintedScene::nearest(const Vec3& point) const {
    return workpiece_->closestPoint(point).place;
}

Vec3 PaintedScene::positionOf(const SurfacePoint& point) const {
    return bspline_curve::positionOf(workpiece_->mesh(), point);
}

void PaintedScene::preview(const Pointer& pointer) {
    static_cast<void>(session_->move(pointer));
    while (!session_->preview()) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        static_cast<void>(session_->update());
    }
}

double contrast(const SketchColour& a, const SketchColour& b) {
    const double first = luminance(a) + 0.05;
    const double second = luminance(b) + 0.05;
    return std::max(first, second) / std::min(first, second);
}

double contrastNear(
    const Pixels& with, const Pixels& without, const Eigen::Vector2d& place, double radius
) {
    double most = 1.0;
    const auto reach = static_cast<int>(std::ceil(radius));
    for (int dy = -reach; dy <= reach; ++dy) {
        for (int dx = -reach; dx <= reach; ++dx) {
            const int x = static_cast<int>(std::floor(place.x())) + dx;
            const int y = static_cast<int>(std::floor(place.y())) + dy;
            const bool isNear = (Eigen::Vector2d(x + 0.5, y + 0.5) - place).norm() <= radius;
            if (isNear && !(with.at(x, y) == without.at(x, y))) {
                most = std::max(most, contrast(with.at(x, y), without.at(x, y)));
            }
        }
    }
    return most;
}

}  // namespace bspline_curve::test_support

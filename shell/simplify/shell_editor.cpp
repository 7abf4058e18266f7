// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/simplify/shell_editor.h"

#include "shell/face_geometry.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace bspline_curve {
namespace {

// Lines that pass an edge this close, in barycentric coordinates, still count.
constexpr double kEdgeMargin = 1e-9;

// The walls where the shell ends, as triangles.
std::vector<Triangle> endWallsOf(const Shell& start) {
    std::vector<Triangle> walls;
    for (const Prism& prism : start.prisms()) {
        for (std::size_t slot = 0; prism.orientation != 0 && slot < 3; ++slot) {
            if (prism.neighbours[slot] < 0) {
                const std::array<Triangle, 4> triangles = wallTriangles(prism.pillars, slot);
                walls.insert(walls.end(), triangles.begin(), triangles.end());
            }
        }
    }
    return walls;
}

}  // namespace

ShellEditor::ShellEditor(const TrackedSurface& surface, const Shell& start)
    : surface_(surface),
      complex_(start.pillars()),
      test_(surface, complex_),
      grid_(complex_, endWallsOf(start)),
      components_(surface, start),
      isFrozen_(start.pillars().size(), 0),
      faceStamps_(surface.extended.faces.size(), 0),
      changed_(start.pillars().size(), 0) {
    complex_.reserve(static_cast<int>(start.prisms().size()));
    for (int f = 0; f < static_cast<int>(start.prisms().size()); ++f) {
        const Prism& prism = start.prisms()[f];
        if (prism.orientation == 0) {
            continue;
        }
        components_.enter(complex_, complex_.addPrism(surface.extended.faces[f], {&f, 1}), f);
        for (std::size_t slot = 0; slot < 3; ++slot) {
            if (prism.neighbours[slot] < 0) {
                isFrozen_[prism.pillars[(slot + 1) % 3]] = 1;
                isFrozen_[prism.pillars[(slot + 2) % 3]] = 1;
            }
        }
    }
}

void ShellEditor::proposeStar(int pillar) {
    old.clear();
    complex_.appendPrismsAround(pillar, old);
    fresh.clear();
    for (const int prism : old) {
        fresh.push_back(complex_.pillarsOf(prism));
    }
}

// Cheap tests first: most proposals fail early.
bool ShellEditor::replace() {
    if (!std::ranges::all_of(fresh, [&](const Triangle& t) { return test_.isPositive(t); })) {
        return false;
    }
    gatherFaces();
    if (!test_.accepts(fresh, faces_) || grid_.collides(fresh, old) ||
        !components_.replace(complex_, fresh, old)) {
        return false;
    }
    for (const int prism : old) {
        complex_.removePrism(prism);
    }
    ++time_;
    for (std::size_t i = 0; i < fresh.size(); ++i) {
        const int prism = complex_.addPrism(fresh[i], test_.tracked(i));
        grid_.insert(prism);
        components_.setId(prism, i);
        for (const int pillar : fresh[i]) {
            changed_[pillar] = time_;
        }
    }
    return true;
}

bool ShellEditor::replaceWith(int pillar, const Pillar& value) {
    const Pillar before = pillarAt(pillar);
    setPillar(pillar, value);
    const bool done = replace();
    if (!done) {
        setPillar(pillar, before);
    }
    return done;
}

void ShellEditor::gatherFaces() {
    ++faceStamp_;
    faces_.clear();
    for (const int prism : old) {
        for (const int face : complex_.facesOf(prism)) {
            if (faceStamps_[face] != faceStamp_) {
                faceStamps_[face] = faceStamp_;
                faces_.push_back(face);
            }
        }
    }
}

double ShellEditor::quality(const Triangle& pillars) const {
    const Vec3& a = complex_.point(pillars[0], Level::Middle);
    const Vec3& b = complex_.point(pillars[1], Level::Middle);
    const Vec3& c = complex_.point(pillars[2], Level::Middle);
    const double squares = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
    return squares > 0.0 ? 2.0 * std::numbers::sqrt3 * (b - a).cross(c - a).norm() / squares : 0.0;
}

double ShellEditor::leastQuality() const {
    double least = 1.0;
    for (const Triangle& pillars : fresh) {
        least = std::min(least, quality(pillars));
    }
    return least;
}

double ShellEditor::middleLength(int a, int b) const {
    return (complex_.point(a, Level::Middle) - complex_.point(b, Level::Middle)).norm();
}

Vec3 ShellEditor::meanNormal() {
    gatherFaces();
    Vec3 sum = Vec3::Zero();
    for (const int face : faces_) {
        sum += areaNormal(surface_.extended, face);
    }
    return sum.normalized();
}

std::optional<Vec3> ShellEditor::onSurface(const Vec3& point, const Vec3& direction) {
    gatherFaces();
    double nearest = std::numeric_limits<double>::infinity();
    for (const int face : faces_) {
        const FaceBound& bound = surface_.bounds[face];
        const Vec3 centre = Eigen::Map<const Eigen::Vector3f>(bound.centre.data()).cast<double>();
        const auto radius = static_cast<double>(bound.radius);
        const double along = (centre - point).dot(direction);
        if ((centre - point).squaredNorm() - along * along > radius * radius ||
            std::abs(along) - radius > std::abs(nearest)) {
            continue;
        }
        if (areaNormal(surface_.extended, face).dot(direction) <= 0.0) {
            continue;
        }
        const std::optional<double> t =
            intersectLine(point, direction, cornersOf(surface_.extended, face), kEdgeMargin);
        if (t && std::abs(*t) < std::abs(nearest)) {
            nearest = *t;
        }
    }
    if (!std::isfinite(nearest)) {
        return std::nullopt;
    }
    return point + nearest * direction;
}

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/simplify/shell_editor.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace bspline_curve {
namespace {

// The walls where the shell ends, split like their prisms.
std::vector<LayerGrid::Wall> endWallsOf(const Shell& start) {
    std::vector<LayerGrid::Wall> walls;
    for (const Prism& prism : start.prisms()) {
        for (std::size_t slot = 0; prism.orientation != 0 && slot < 3; ++slot) {
            if (prism.neighbours[slot] >= 0) {
                continue;
            }
            const int low = prism.pillars[slot == 0 ? 1 : 0];
            const int high = prism.pillars[slot == 2 ? 1 : 2];
            const int middle = pointOf(low, Level::Middle);
            for (const Level outer : {Level::Top, Level::Bottom}) {
                walls.push_back({middle, pointOf(high, Level::Middle), pointOf(high, outer)});
                walls.push_back({middle, pointOf(high, outer), pointOf(low, outer)});
            }
        }
    }
    return walls;
}

}  // namespace

ShellEditor::ShellEditor(const TrackedSurface& surface, const Shell& start)
    : surface_(surface),
      complex_(static_cast<int>(start.pillars().size())),
      test_(surface, complex_),
      grid_(complex_, endWallsOf(start)),
      witnesses_(surface, start),
      volumes_(start) {
    const std::size_t pillarCount = start.pillars().size();
    complex_.points.reserve(3 * pillarCount);
    for (const Pillar& pillar : start.pillars()) {
        complex_.points.insert(complex_.points.end(), {pillar.bottom, pillar.middle, pillar.top});
    }
    isFrozen_.assign(pillarCount, 0);
    complex_.reserve(static_cast<int>(start.prisms().size()));
    for (int f = 0; f < static_cast<int>(start.prisms().size()); ++f) {
        const Prism& prism = start.prisms()[f];
        if (prism.orientation == 0) {
            continue;
        }
        volumes_.enter(complex_, complex_.addPrism(surface.extended.faces[f], {&f, 1}), f);
        for (std::size_t slot = 0; slot < 3; ++slot) {
            if (prism.neighbours[slot] < 0) {
                isFrozen_[prism.pillars[(slot + 1) % 3]] = 1;
                isFrozen_[prism.pillars[(slot + 2) % 3]] = 1;
            }
        }
    }
    faceStamps_.assign(surface.extended.faces.size(), 0);
    changed_.assign(pillarCount, 0);
}

void ShellEditor::proposeStar(int pillar) {
    old.clear();
    complex_.appendPrismsAround(pillar, old);
    fresh.clear();
    for (const int prism : old) {
        fresh.push_back(complex_.pillarsOf(prism));
    }
}

Pillar ShellEditor::pillarAt(int pillar) const {
    return {
        complex_.point(pillar, Level::Bottom),
        complex_.point(pillar, Level::Middle),
        complex_.point(pillar, Level::Top)
    };
}

void ShellEditor::setPillar(int pillar, const Pillar& value) {
    complex_.points[pointOf(pillar, Level::Bottom)] = value.bottom;
    complex_.points[pointOf(pillar, Level::Middle)] = value.middle;
    complex_.points[pointOf(pillar, Level::Top)] = value.top;
}

// Cheap tests first: most proposals fail early.
bool ShellEditor::replace() {
    if (!std::ranges::all_of(fresh, [&](const Triangle& t) { return test_.isUpright(t); })) {
        return false;
    }
    gatherFaces();
    // All faces that meet a patch belong to its component.
    if (!test_.accepts(fresh, faces_) || grid_.collides(fresh, old) ||
        witnesses_.areHeld(complex_, fresh, faces_.empty() ? -1 : faces_.front()) ||
        !volumes_.replace(complex_, fresh, old)) {
        return false;
    }
    for (const int prism : old) {
        complex_.removePrism(prism);
    }
    ++time_;
    for (std::size_t i = 0; i < fresh.size(); ++i) {
        const int prism = complex_.addPrism(fresh[i], test_.tracked(i));
        grid_.insert(prism);
        volumes_.setId(prism, i);
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
        const Vec3& a = surface_.corner(face, 0);
        sum += (surface_.corner(face, 1) - a).cross(surface_.corner(face, 2) - a);
    }
    return sum.normalized();
}

std::optional<Vec3> ShellEditor::onSurface(const Vec3& point, const Vec3& direction) {
    // Lines that pass an edge this close, in barycentric coordinates, still count.
    constexpr double kEdgeMargin = 1e-9;
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
        const Vec3& a = surface_.corner(face, 0);
        const Vec3 e1 = surface_.corner(face, 1) - a;
        const Vec3 e2 = surface_.corner(face, 2) - a;
        const Vec3 normal = e1.cross(e2);
        const double slope = normal.dot(direction);
        if (slope <= 0.0) {
            continue;
        }
        const Vec3 turn = direction.cross(a - point) / slope;
        const double u = -e2.dot(turn);
        const double v = e1.dot(turn);
        const double t = normal.dot(a - point) / slope;
        if (std::min({u, v, 1.0 - u - v}) >= -kEdgeMargin && std::abs(t) < std::abs(nearest)) {
            nearest = t;
        }
    }
    if (!std::isfinite(nearest)) {
        return std::nullopt;
    }
    return point + nearest * direction;
}

}  // namespace bspline_curve

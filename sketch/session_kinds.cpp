// SPDX-License-Identifier: GPL-3.0-or-later
// What a session's picks are, and the handles of those with a direction.
#include "bspline_curve/spline.h"
#include "sketch/session_parts.h"
#include "sketch/tangent_handles.h"
#include "surface/provenance.h"
#include "surface/surface.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace bspline_curve {

namespace {

/// The directions of a curve at one of its picks; zero where they are not known.
PickTangent directionsAt(const SketchCurve& curve, int pick) {
    const auto count = static_cast<int>(curve.picks.size());
    if (curve.settled && std::ssize(curve.settled->spline.pickParameters) == count) {
        return directionsAtPick(curve.settled->spline, pick);
    }
    const bool closed = curve.options.solver.closed;
    const int before = closed ? (pick + count - 1) % count : std::max(pick - 1, 0);
    const int after = closed ? (pick + 1) % count : std::min(pick + 1, count - 1);
    return PickTangent::along(curve.picks[after].position - curve.picks[before].position);
}

Vec3 alongPlane(const Vec3& direction, const Vec3& normal) {
    return (direction - direction.dot(normal) * normal).normalized();
}

}  // namespace

void DrawingSession::setKind(int pick, PickKind kind) {
    requirePick(pick);
    const SketchCurve& curve = *sketch_.activeCurve();
    switch (kind) {
        case PickKind::Automatic:
            if (curve.picks[pick].isCorner) {
                setCorner(pick, false);
            } else {
                setTangent(pick, {});
            }
            break;
        case PickKind::Aligned:
            if (kindOf(curve.picks[pick]) != PickKind::Aligned) {
                const Vec3 normal = normalAt(curve.picks[pick].point);
                const Vec3 along = directionsAt(curve, pick).after;
                setTangent(pick, PickTangent::along(alongPlane(along, normal)));
            }
            break;
        case PickKind::Corner:
            setCorner(pick, true);
            break;
        case PickKind::Free:
            setFree(pick);
            break;
    }
}

bool DrawingSession::changeKind() {
    if (sketch_.selected < 0) {
        return false;
    }
    const int pick = sketch_.selected;
    switch (kindOf(sketch_.activeCurve()->picks[pick])) {
        case PickKind::Automatic:
            setKind(pick, PickKind::Aligned);
            break;
        case PickKind::Aligned:
            setKind(pick, PickKind::Corner);
            break;
        case PickKind::Corner:
            setKind(pick, PickKind::Free);
            break;
        case PickKind::Free:
            setKind(pick, PickKind::Automatic);
            break;
    }
    return true;
}

void DrawingSession::setFree(int pick) {
    if (!staysWithoutDrag()) {
        return;
    }
    requirePick(pick);
    const SketchCurve& curve = *sketch_.activeCurve();
    if (kindOf(curve.picks[pick]) == PickKind::Free) {
        return;
    }
    const Vec3 normal = normalAt(curve.picks[pick].point);
    const PickTangent along = directionsAt(curve, pick);
    SketchPick& changedPick = changed().picks[pick];
    changedPick.isCorner = true;
    changedPick.tangent = {alongPlane(along.before, normal), alongPlane(along.after, normal)};
    sketch_.selected = pick;
    enter();
}

Vec3 DrawingSession::normalAt(const SurfacePoint& point) const {
    const Surface& surface = solver_->designer->surface();
    const std::optional<SurfacePoint> own =
        point.face < 0 ? std::nullopt : surface.provenance().fromInput(point);
    return own ? surface.faceNormal(own->face) : Vec3(Vec3::Zero());
}

std::optional<Vec3> DrawingSession::handle(
    const SketchPick& pick, int side, const Pointer& pointer
) const {
    return tangentHandle(pick, side, pointer, settings_.handlePixels);
}

int DrawingSession::handleUnder(const Pointer& pointer, const Seen& seen) const {
    if (settings_.handlePixels <= 0.0 || sketch_.selected < 0 ||
        sketch_.activeCurve()->look.isHidden) {
        return 0;
    }
    const double depth =
        seen.point.face >= 0 ? seen.distance : std::numeric_limits<double>::infinity();
    return tangentHandleUnder(
        pointer,
        depth,
        sketch_.activeCurve()->picks[sketch_.selected],
        settings_.handlePixels,
        settings_.radii.pick
    );
}

bool DrawingSession::pressHandle(const Pointer& pointer, const Seen& seen) {
    turning_ = handleUnder(pointer, seen);
    if (turning_ == 0) {
        return false;
    }
    const SketchPick& pick = sketch_.activeCurve()->picks[sketch_.selected];
    pressedAt_ =
        tangentHandle(pick, turning_, pointer, settings_.handlePixels).value_or(pick.position);
    closesOnRelease_ = false;
    mode_ = Mode::Pressed;
    dropLive();
    return true;
}

void DrawingSession::turn(const Pointer& pointer) {
    const SketchPick& pick = sketch_.activeCurve()->picks[sketch_.selected];
    if (const auto direction = directionTowards(pointer, pick, normalAt(pick.point))) {
        SketchPick& changedPick = changed().picks[sketch_.selected];
        const PickTangent turned = PickTangent::along(turning_ * *direction);
        PickTangent& tangent = changedPick.tangent;
        if (!changedPick.isCorner) {
            tangent = turned;
        } else {
            (turning_ > 0 ? tangent.after : tangent.before) = turned.after;
        }
        askLive();
    }
}

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/path_turn.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace bspline_curve {

TurnValue turnOf(double sine, double cosine) {
    const double size = std::sqrt(sine * sine + cosine * cosine);
    if (!(size > 0.0)) {
        return {0.0, 1.0};
    }
    const double c = cosine / size;
    const double half = std::sqrt(std::max(0.0, 0.5 * (1.0 + c)));  // cos(angle / 2)
    const double x =
        c > 0.0 ? 0.5 * sine / (size * half) : std::copysign(std::sqrt(0.5 * (1.0 - c)), sine);
    const double x2 = x * x;
    return {
        2.0 * x * (1.0 + x2 * (1.0 / 6.0 + x2 * (3.0 / 40.0 + x2 * (5.0 / 112.0)))),
        half * (1.0 + x2 * (1.0 / 2.0 + x2 * (3.0 / 8.0 + x2 * (5.0 / 16.0))))
    };
}

PathTurn pathTurn(
    const Vec3& in, const Vec3& out, const Vec3& normal, const std::array<const NodeWay*, 3>& ways
) {
    const Vec3 area = in.cross(out);
    const Vec3 sineByIn = out.cross(normal);
    const Vec3 sineByOut = normal.cross(in);
    const double sine = normal.dot(area);
    const double cosine = in.dot(out);
    const double squares = sine * sine + cosine * cosine;
    const double perSquares = squares > 0.0 ? 1.0 / squares : 0.0;
    const double inLength = in.norm();
    const double outLength = out.norm();
    PathTurn turn;
    const auto [value, byAngle] = turnOf(sine, cosine);
    turn.value = value;
    turn.length = 0.5 * (inLength + outLength);
    // Of the angle and the length by `in` and by `out`.
    const Vec3 angleByIn = byAngle * perSquares * (cosine * sineByIn - sine * out);
    const Vec3 angleByOut = byAngle * perSquares * (cosine * sineByOut - sine * in);
    const Vec3 lengthByIn = 0.5 / inLength * in;
    const Vec3 lengthByOut = 0.5 / outLength * out;
    const auto& [before, here, after] = ways;
    turn.valueBy = {
        -angleByIn.dot(before->across),
        (angleByIn - angleByOut).dot(here->across) +
            byAngle * perSquares * cosine * area.dot(here->turn),
        angleByOut.dot(after->across)
    };
    turn.lengthBy = {
        -lengthByIn.dot(before->across),
        (lengthByIn - lengthByOut).dot(here->across),
        lengthByOut.dot(after->across)
    };
    return turn;
}

HalfTurn halfTurn(
    const Vec3& way, bool isBefore, const Vec3& tangent, const Vec3& normal, const Vec3& across
) {
    // Before the pick the path goes along -way, and turns from there to the tangent.
    const double sign = isBefore ? -1.0 : 1.0;
    const Vec3 along = sign * way;
    const Vec3 moved = sign * across;
    const double sine = sign * normal.dot(tangent.cross(along));
    const double cosine = tangent.dot(along);
    const double squares = sine * sine + cosine * cosine;
    const double sineBy = sign * normal.dot(tangent.cross(moved));
    const double cosineBy = tangent.dot(moved);
    const double angleBy = squares > 0.0 ? (cosine * sineBy - sine * cosineBy) / squares : 0.0;
    const auto [value, byAngle] = turnOf(sine, cosine);
    const double length = way.norm();
    return {value, 0.5 * length, byAngle * angleBy, 0.5 * way.dot(across) / length};
}

}  // namespace bspline_curve

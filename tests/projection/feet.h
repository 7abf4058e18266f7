// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "projection/fibre_projector.h"
#include "shell/extended_surface.h"
#include "support/random.h"
#include "surface/surface.h"

/// Feet of points: P = q + height n(q).
namespace bspline_curve::test_support {

[[nodiscard]] int faceCountOf(const ExtendedSurface& extended);
[[nodiscard]] ExtendedSurface baseOf(const TriangleMesh& mesh);
[[nodiscard]] double meanEdge(const ExtendedSurface& extended);
[[nodiscard]] Vec3 normalOf(const ExtendedSurface& extended, int face);
[[nodiscard]] double distanceToSurface(const ExtendedSurface& extended, const Vec3& p);

[[nodiscard]] Vec3 directionAt(const ExtendedSurface& extended, const FootPoint& foot);
[[nodiscard]] Vec3 footPosition(const ExtendedSurface& extended, const FootPoint& foot);
[[nodiscard]] Vec3 pointOver(const ExtendedSurface& extended, const FootPoint& foot);
[[nodiscard]] FootPoint centreOf(int face);
[[nodiscard]] FootPoint randomFoot(const ExtendedSurface& extended, Random& random, double highest);

struct Found {
    FootPoint foot;
    FootFrame frame;
};

[[nodiscard]] Found find(const ExtendedSurface& extended, const Vec3& p, const FootPoint& start);

void expectFinite(const Found& found);
/// Expects that a foot lies under p by its fibre, or else is the nearest point of the faces that
/// hold it. Returns whether the first is so.
bool expectFootOrNearest(const ExtendedSurface& extended, const Vec3& p, const Found& found);

}  // namespace bspline_curve::test_support

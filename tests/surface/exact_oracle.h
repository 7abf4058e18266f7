// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

/// Exact answers for points with integer coordinates, by methods that share nothing with the code
/// under test.
namespace bspline_curve::exact_oracle {

__extension__ typedef __int128 Integer;  // NOLINT(modernize-use-using): needs __extension__
using Point = std::array<std::int64_t, 3>;

/// Sign of det(b - a, c - a, d - a). For coordinates below 2^38 in size.
int orientationSign(const Point& a, const Point& b, const Point& c, const Point& d);

/// Whether two triangles that share the given number of leading corners (0, 1 or 2) meet anywhere
/// else. For small coordinates.
///
/// Stated as whether a system of linear equations has a solution without negative unknowns, and
/// decided by trying all its basic solutions:
/// - 0 shared: convex combinations of the corners that are equal;
/// - 1 shared: rays from the corner into both triangles that are equal;
/// - 2 shared: a half-plane beyond the edge that holds both third corners.
bool trianglesMeet(const std::array<Point, 3>& a, const std::array<Point, 3>& b, int sharedCorners);

}  // namespace bspline_curve::exact_oracle

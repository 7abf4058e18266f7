// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/check/exact_overlap.h"

#include "surface/predicates.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace bspline_curve {
namespace {

// Weak separation. The planes with a tetrahedron on one side and a triangle on the other form a
// polyhedral cone, pointed since the tetrahedron has volume; if it is not empty it has an extreme
// ray: a plane through three of the seven points that span it. So it is enough to try those, and
// all signs are orientations of given points. The same holds one dimension lower.

// Whether the first `firstCount` signs lie on one side, not all zero, and the others on the other
// side.
template <std::size_t Count>
bool isSeparating(const std::array<int, Count>& signs, std::size_t firstCount) {
    int side = 0;
    for (std::size_t i = 0; i < firstCount; ++i) {
        if (signs[i] != 0) {
            if (signs[i] == -side) {
                return false;
            }
            side = signs[i];
        }
    }
    return side != 0 && std::all_of(
                            signs.begin() + static_cast<std::ptrdiff_t>(firstCount),
                            signs.end(),
                            [&](int sign) { return sign != side; }
                        );
}

using SevenPoints = std::array<const Vec3*, 7>;

bool planeSeparates(const SevenPoints& p, const std::array<std::size_t, 3>& plane) {
    std::array<int, 7> signs{};
    int side = 0;
    for (std::size_t i = 0; i < 7; ++i) {
        if (i == plane[0] || i == plane[1] || i == plane[2]) {
            continue;
        }
        signs[i] = orientationSign(*p[plane[0]], *p[plane[1]], *p[plane[2]], *p[i]);
        // Leave early where the tetrahedron is cut or the triangle is on its side.
        if (i < 4 ? signs[i] == -side && side != 0 : signs[i] == side && side != 0) {
            return false;
        }
        side = i < 4 && signs[i] != 0 ? signs[i] : side;
    }
    return isSeparating(signs, 4);
}

bool someMixedPlaneSeparates(const SevenPoints& p) {
    if (planeSeparates(p, {4, 5, 6})) {
        return true;
    }
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t f = 4; f < 7; ++f) {
            for (std::size_t j = i + 1; j < 4; ++j) {
                if (planeSeparates(p, {i, j, f})) {
                    return true;
                }
            }
            for (std::size_t g = f + 1; g < 7; ++g) {
                if (planeSeparates(p, {i, f, g})) {
                    return true;
                }
            }
        }
    }
    return false;
}

// Whether a triangle passes through the inside of another one of the same plane, which has area.
bool coplanarOverlap(
    const std::array<const Vec3*, 3>& face, const std::array<const Vec3*, 3>& triangle
) {
    int axis = 0;
    while (axis < 2 && projectedOrientationSign(*face[0], *face[1], *face[2], axis) == 0) {
        ++axis;
    }
    const std::array<const Vec3*, 6> p = {
        face[0], face[1], face[2], triangle[0], triangle[1], triangle[2]
    };
    for (std::size_t i = 0; i < 6; ++i) {
        for (std::size_t j = i + 1; j < 6; ++j) {
            std::array<int, 6> signs{};
            for (std::size_t k = 0; k < 6; ++k) {
                signs[k] = projectedOrientationSign(*p[i], *p[j], *p[k], axis);
            }
            if (isSeparating(signs, 3)) {
                return false;
            }
        }
    }
    return true;
}

// A sum of doubles without rounding: components that do not overlap, smallest first (Shewchuk
// 1997, Fig. 6).
class ExactSum {
public:
    void add(double value) {
        std::size_t kept = 0;
        for (const double component : components_) {
            const double sum = value + component;
            const double virtualPart = sum - value;
            const double error = (value - (sum - virtualPart)) + (component - virtualPart);
            if (error != 0.0) {
                components_[kept++] = error;
            }
            value = sum;
        }
        components_.resize(kept);
        if (value != 0.0) {
            components_.push_back(value);
        }
    }

    void addProduct(double a, double b, double c) {
        const double ab = a * b;
        const double error = std::fma(a, b, -ab);
        for (const double part : {ab, error}) {
            const double product = part * c;
            add(std::fma(part, c, -product));
            add(product);
        }
    }

    [[nodiscard]] int sign() const {
        if (components_.empty()) {
            return 0;
        }
        return components_.back() > 0.0 ? 1 : -1;
    }

private:
    std::vector<double> components_;
};

// a - b as the rounded difference and its error.
std::array<double, 2> exactDifference(double a, double b) {
    const double difference = a - b;
    const double virtualPart = a - difference;
    const double error = (a - (difference + virtualPart)) + (virtualPart - b);
    return {difference, error};
}

int exactDotSign(const std::array<Vec3, 3>& t, const Vec3& from, const Vec3& to) {
    ExactSum sum;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const int k = (i + 2) % 3;
        for (const double z : exactDifference(to[i], from[i])) {
            for (const double x : exactDifference(t[1][j], t[0][j])) {
                for (const double y : exactDifference(t[2][k], t[0][k])) {
                    sum.addProduct(x, y, z);
                }
            }
            for (const double x : exactDifference(t[1][k], t[0][k])) {
                for (const double y : exactDifference(t[2][j], t[0][j])) {
                    sum.addProduct(-x, y, z);
                }
            }
        }
    }
    return sum.sign();
}

}  // namespace

bool overlaps(const std::array<Vec3, 4>& tetrahedron, const std::array<Vec3, 3>& triangle) {
    constexpr std::array<Triangle, 4> kFaces = {{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};
    const std::array<Vec3, 4>& tet = tetrahedron;
    const auto& [a, b, c] = triangle;
    const int volume = orientationSign(tet[1], tet[2], tet[3], tet[0]);
    if (volume == 0) {
        return false;
    }
    std::array<bool, 3> isInside = {true, true, true};
    for (const Triangle& f : kFaces) {
        const std::array<const Vec3*, 3> face = {&tet[f[0]], &tet[f[1]], &tet[f[2]]};
        int highest = -1;
        int lowest = 1;
        for (std::size_t k = 0; k < 3; ++k) {
            const int side = volume * orientationSign(*face[0], *face[1], *face[2], triangle[k]);
            isInside[k] = isInside[k] && side > 0;
            highest = std::max(highest, side);
            lowest = std::min(lowest, side);
        }
        if (highest == 0 && lowest == 0) {
            return coplanarOverlap(face, {&a, &b, &c});
        }
        if (highest <= 0) {
            return false;
        }
    }
    if (isInside[0] || isInside[1] || isInside[2]) {
        return true;
    }
    return !someMixedPlaneSeparates({tet.data(), &tet[1], &tet[2], &tet[3], &a, &b, &c});
}

int normalDotSign(const std::array<Vec3, 3>& triangle, const Vec3& from, const Vec3& to) {
    const Vec3 u = triangle[1] - triangle[0];
    const Vec3 v = triangle[2] - triangle[0];
    const Vec3 w = to - from;
    double dot = 0.0;
    double permanent = 0.0;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const int k = (i + 2) % 3;
        const double left = u[j] * v[k];
        const double right = u[k] * v[j];
        dot += w[i] * (left - right);
        permanent += std::abs(w[i]) * (std::abs(left) + std::abs(right));
    }
    // A determinant of three rounded differences: fewer than 8 roundings on each path.
    const double bound = 16.0 * detail::kHalfUlp * permanent;
    if (std::abs(dot) > bound) {
        return dot > 0.0 ? 1 : -1;
    }
    return exactDotSign(triangle, from, to);
}

}  // namespace bspline_curve

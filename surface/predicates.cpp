// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/predicates.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace bspline_curve::detail {

namespace {

/// A number as the exact sum of doubles that do not overlap, the smallest first, none zero.
template <std::size_t Capacity>
struct Expansion {
    std::array<double, Capacity> terms;
    std::size_t size = 0;

    void append(double term) {
        if (term != 0.0) {
            terms[size++] = term;
        }
    }

    /// Adds a double, exactly: the rounding error of each sum becomes a term.
    void add(double value) {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < size; ++i) {
            const double sum = value + terms[i];
            const double part = sum - value;
            const double error = (value - (sum - part)) + (terms[i] - part);
            if (error != 0.0) {
                terms[kept++] = error;
            }
            value = sum;
        }
        size = kept;
        append(value);
    }

    template <std::size_t Other>
    void add(const Expansion<Other>& other, double sign = 1.0) {
        for (std::size_t i = 0; i < other.size; ++i) {
            add(sign * other.terms[i]);
        }
    }

    [[nodiscard]] int sign() const { return size == 0 ? 0 : (terms[size - 1] > 0.0 ? 1 : -1); }
};

using Difference = Expansion<2>;

Difference difference(double a, double b) {
    Difference result;
    result.append(a);
    result.add(-b);
    return result;
}

template <std::size_t M, std::size_t N>
Expansion<2 * M * N> product(const Expansion<M>& a, const Expansion<N>& b) {
    Expansion<2 * M * N> result;
    for (std::size_t i = 0; i < a.size; ++i) {
        for (std::size_t j = 0; j < b.size; ++j) {
            const double high = a.terms[i] * b.terms[j];
            result.add(std::fma(a.terms[i], b.terms[j], -high));
            result.add(high);
        }
    }
    return result;
}

/// a d - b c.
Expansion<16> determinant(
    const Difference& a, const Difference& b, const Difference& c, const Difference& d
) {
    Expansion<16> result;
    result.add(product(a, d));
    result.add(product(b, c), -1.0);
    return result;
}

}  // namespace

int exactOrientationSign(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const std::array<const Vec3*, 3> ends = {&b, &c, &d};
    std::array<std::array<Difference, 3>, 3> rows;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            rows[i][k] = difference((*ends[i])[static_cast<int>(k)], a[static_cast<int>(k)]);
        }
    }
    Expansion<192> volume;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto& next = rows[(i + 1) % 3];
        const auto& last = rows[(i + 2) % 3];
        volume.add(product(rows[i][2], determinant(next[0], next[1], last[0], last[1])));
    }
    return volume.sign();
}

int exactProjectedOrientationSign(const Vec3& a, const Vec3& b, const Vec3& c, int droppedAxis) {
    const int x = (droppedAxis + 1) % 3;
    const int y = (droppedAxis + 2) % 3;
    return determinant(
               difference(b[x], a[x]),
               difference(b[y], a[y]),
               difference(c[x], a[x]),
               difference(c[y], a[y])
    )
        .sign();
}

}  // namespace bspline_curve::detail

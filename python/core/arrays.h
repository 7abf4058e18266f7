// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

// numpy arrays as the core takes and gives them. The package's Python files see to it that arrays
// come in these types, without a copy where they have them already.
namespace bspline_curve::python {

namespace nb = nanobind;

template <class Scalar, int Columns>
using Rows = nb::ndarray<const Scalar, nb::shape<-1, Columns>, nb::c_contig, nb::device::cpu>;
template <class Scalar>
using Column = nb::ndarray<const Scalar, nb::ndim<1>, nb::c_contig, nb::device::cpu>;

using Points = Rows<double, 3>;                   ///< (n, 3)
using Faces32 = Rows<std::int32_t, 3>;            ///< (m, 3)
using Faces64 = Rows<std::int64_t, 3>;            ///< (m, 3)
using Values = Column<double>;                    ///< (n,)
using Ids = Column<std::int32_t>;                 ///< (k,)
using Array = nb::ndarray<nb::numpy>;             ///< of any type and shape, for results
using ReadOnly = nb::ndarray<nb::numpy, nb::ro>;  ///< a view of what the core holds

[[nodiscard]] std::vector<Vec3> toVectors(const Points& points);
/// Ids that are no int become -1, which validation refuses and names.
[[nodiscard]] std::vector<Triangle> toTriangles(const Faces32& faces);
[[nodiscard]] std::vector<Triangle> toTriangles(const Faces64& faces);

/// (n, 3), sharing memory with what `owner` keeps alive.
[[nodiscard]] ReadOnly viewOf(const std::vector<Vec3>& points, nb::handle owner);
[[nodiscard]] ReadOnly viewOf(const std::vector<Triangle>& faces, nb::handle owner);
[[nodiscard]] ReadOnly viewOf(const std::vector<double>& values, nb::handle owner);
[[nodiscard]] ReadOnly viewOf(const std::vector<int>& values, nb::handle owner);

/// An array that owns a vector's elements, `columns` of them in each row; 0: one dimension.
template <class Scalar>
[[nodiscard]] Array arrayOf(std::vector<Scalar>&& elements, std::size_t columns = 0) {
    auto* const kept = new std::vector<Scalar>(std::move(elements));
    const nb::capsule owner(kept, [](void* given) noexcept {
        delete static_cast<std::vector<Scalar>*>(given);
    });
    const std::size_t rows = columns == 0 ? kept->size() : kept->size() / columns;
    const std::array<std::size_t, 2> shape{rows, columns};
    return Array(
        kept->data(), columns == 0 ? 1 : 2, shape.data(), owner, nullptr, nb::dtype<Scalar>()
    );
}

/// (vertices, faces) of a mesh, copied.
[[nodiscard]] nb::tuple arraysOf(const TriangleMesh& mesh);

}  // namespace bspline_curve::python

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <type_traits>
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
using Values = Column<double>;                    ///< (n,)
using Ids = Column<std::int32_t>;                 ///< (k,)
using Array = nb::ndarray<nb::numpy>;             ///< of any type and shape, for results
using ReadOnly = nb::ndarray<nb::numpy, nb::ro>;  ///< a view of what the core holds

[[nodiscard]] inline std::vector<Vec3> toVectors(const Points& points) {
    std::vector<Vec3> result(points.shape(0));
    if (!result.empty()) {
        std::memcpy(result.data()->data(), points.data(), result.size() * sizeof(Vec3));
    }
    return result;
}

/// Ids that are no int become -1, which validation refuses and names.
template <class Id>
[[nodiscard]] std::vector<Triangle> toTriangles(const Rows<Id, 3>& faces) {
    std::vector<Triangle> result(faces.shape(0));
    const Id* next = faces.data();
    for (Triangle& face : result) {
        for (int& vertex : face) {
            const Id id = *next++;
            vertex = std::in_range<int>(id) ? static_cast<int>(id) : -1;
        }
    }
    return result;
}

/// Empty where there is no array.
template <class Scalar>
[[nodiscard]] std::vector<Scalar> toVector(const std::optional<Column<Scalar>>& values) {
    return values ? std::vector<Scalar>(values->data(), values->data() + values->shape(0))
                  : std::vector<Scalar>();
}

/// What an element is in an array: a number, or a row of three.
template <class Element>
struct Row {
    using Scalar = Element;
    static constexpr std::size_t kDimensions = 1;
};

template <>
struct Row<Vec3> {
    using Scalar = double;
    static constexpr std::size_t kDimensions = 2;
};

template <>
struct Row<Triangle> {
    using Scalar = std::int32_t;
    static constexpr std::size_t kDimensions = 2;
};

static_assert(sizeof(Vec3) == 3 * sizeof(double));
static_assert(sizeof(Triangle) == 3 * sizeof(std::int32_t));
static_assert(sizeof(int) == sizeof(std::int32_t));

/// An array of elements that `owner` keeps alive.
template <class Kind, class Element>
[[nodiscard]] Kind arrayOver(Element* first, std::size_t count, nb::handle owner) {
    using Layout = Row<std::remove_const_t<Element>>;
    const std::array<std::size_t, 2> shape{count, 3};
    return Kind(
        first,
        Layout::kDimensions,
        shape.data(),
        owner,
        nullptr,
        nb::dtype<typename Layout::Scalar>()
    );
}

/// An array that owns its elements.
template <class Element>
[[nodiscard]] Array arrayOf(std::vector<Element> elements) {
    auto* const kept = new std::vector<Element>(std::move(elements));
    const nb::capsule owner(kept, [](void* held) noexcept {
        delete static_cast<std::vector<Element>*>(held);
    });
    return arrayOver<Array>(kept->data(), kept->size(), owner);
}

/// A getter of a vector in an object: a view that keeps the object alive.
template <class Object, class Part>
[[nodiscard]] auto viewOf(Part part) {
    return [part](nb::handle self) {
        const auto& elements = part(nb::cast<const Object&>(self));
        return arrayOver<ReadOnly>(elements.data(), elements.size(), self);
    };
}

/// (vertices, faces), copied.
[[nodiscard]] inline nb::tuple arraysOf(const TriangleMesh& mesh) {
    return nb::make_tuple(arrayOf(mesh.vertices), arrayOf(mesh.faces));
}

/// (faces, barycentric coordinates).
[[nodiscard]] inline nb::tuple placesOf(const std::vector<SurfacePoint>& points) {
    std::vector<int> faces;
    std::vector<Vec3> weights;
    for (const auto& [face, barycentric] : points) {
        faces.push_back(face);
        weights.push_back(barycentric);
    }
    return nb::make_tuple(arrayOf(std::move(faces)), arrayOf(std::move(weights)));
}

}  // namespace bspline_curve::python

// SPDX-License-Identifier: GPL-3.0-or-later
#include "python/core/arrays.h"

#include <array>
#include <cstring>
#include <limits>

namespace bspline_curve::python {

namespace {

static_assert(sizeof(Vec3) == 3 * sizeof(double));
static_assert(sizeof(Triangle) == 3 * sizeof(int));
static_assert(sizeof(int) == sizeof(std::int32_t));

template <class Scalar>
ReadOnly view(const Scalar* data, std::size_t rows, std::size_t columns, nb::handle owner) {
    const std::array<std::size_t, 2> shape{rows, columns};
    return ReadOnly(data, columns == 0 ? 1 : 2, shape.data(), owner, nullptr, nb::dtype<Scalar>());
}

}  // namespace

std::vector<Vec3> toVectors(const Points& points) {
    std::vector<Vec3> result(points.shape(0));
    if (!result.empty()) {
        std::memcpy(result.data()->data(), points.data(), result.size() * sizeof(Vec3));
    }
    return result;
}

std::vector<Triangle> toTriangles(const Faces32& faces) {
    std::vector<Triangle> result(faces.shape(0));
    if (!result.empty()) {
        std::memcpy(result.data(), faces.data(), result.size() * sizeof(Triangle));
    }
    return result;
}

std::vector<Triangle> toTriangles(const Faces64& faces) {
    std::vector<Triangle> result(faces.shape(0));
    const std::int64_t* next = faces.data();
    const auto narrowed = [](std::int64_t id) {
        return id < 0 || id > std::numeric_limits<int>::max() ? -1 : static_cast<int>(id);
    };
    for (Triangle& face : result) {
        for (int& vertex : face) {
            vertex = narrowed(*next++);
        }
    }
    return result;
}

ReadOnly viewOf(const std::vector<Vec3>& points, nb::handle owner) {
    return view(reinterpret_cast<const double*>(points.data()), points.size(), 3, owner);
}

ReadOnly viewOf(const std::vector<Triangle>& faces, nb::handle owner) {
    return view(reinterpret_cast<const std::int32_t*>(faces.data()), faces.size(), 3, owner);
}

ReadOnly viewOf(const std::vector<double>& values, nb::handle owner) {
    return view(values.data(), values.size(), 0, owner);
}

ReadOnly viewOf(const std::vector<int>& values, nb::handle owner) {
    return view(values.data(), values.size(), 0, owner);
}

nb::tuple arraysOf(const TriangleMesh& mesh) {
    std::vector<double> vertices;
    for (const Vec3& vertex : mesh.vertices) {
        vertices.insert(vertices.end(), vertex.begin(), vertex.end());
    }
    std::vector<std::int32_t> faces;
    for (const Triangle& face : mesh.faces) {
        faces.insert(faces.end(), face.begin(), face.end());
    }
    return nb::make_tuple(arrayOf(std::move(vertices), 3), arrayOf(std::move(faces), 3));
}

}  // namespace bspline_curve::python

// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/meshes.h"

#include "support/random.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

namespace bspline_curve::test_support {

namespace {

double fraction(int i, int n) {
    return static_cast<double>(i) / n;
}

/// At an angle, in turns, about the z axis.
Vec3 aroundAxis(double turns, double radius, double z) {
    const double angle = 2.0 * std::numbers::pi * turns;
    return {radius * std::cos(angle), radius * std::sin(angle), z};
}

/// Adds the two faces of a quad a b c d (counter-clockwise), split along a c or b d.
void addQuad(TriangleMesh& mesh, const std::array<int, 4>& quad, bool splitAlongAc) {
    const auto [a, b, c, d] = quad;
    if (splitAlongAc) {
        mesh.faces.push_back({a, b, c});
        mesh.faces.push_back({a, c, d});
    } else {
        mesh.faces.push_back({a, b, d});
        mesh.faces.push_back({b, c, d});
    }
}

/// Adds the quads of a grid whose vertex (i, j) has the index vertexAt(i, j).
template <class VertexAt>
void addGrid(TriangleMesh& mesh, int columns, int rows, const VertexAt& vertexAt) {
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            addQuad(
                mesh,
                {vertexAt(i, j), vertexAt(i + 1, j), vertexAt(i + 1, j + 1), vertexAt(i, j + 1)},
                (i + j) % 2 == 0
            );
        }
    }
}

template <class T>
void shuffle(std::vector<T>& values, Random& random) {
    for (std::size_t i = values.size(); i > 1; --i) {
        const int other = random.integer(0, static_cast<int>(i) - 1);
        std::swap(values[i - 1], values[other]);
    }
}

TriangleMesh icosahedron() {
    constexpr double g = std::numbers::phi;
    return {
        .vertices =
            {{-1, g, 0},
             {1, g, 0},
             {-1, -g, 0},
             {1, -g, 0},
             {0, -1, g},
             {0, 1, g},
             {0, -1, -g},
             {0, 1, -g},
             {g, 0, -1},
             {g, 0, 1},
             {-g, 0, -1},
             {-g, 0, 1}},
        .faces = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                  {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                  {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                  {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}},
    };
}

}  // namespace

TriangleMesh plate(int columns, int rows, double width, double height) {
    TriangleMesh mesh;
    for (int j = 0; j <= rows; ++j) {
        for (int i = 0; i <= columns; ++i) {
            mesh.vertices.emplace_back(fraction(i, columns) * width, fraction(j, rows) * height, 0);
        }
    }
    addGrid(mesh, columns, rows, [&](int i, int j) { return j * (columns + 1) + i; });
    return mesh;
}

TriangleMesh jitteredPlate(int columns, int rows, double amount, std::uint64_t seed) {
    TriangleMesh mesh = plate(columns, rows);
    Random random(seed);
    for (int j = 1; j < rows; ++j) {
        for (int i = 1; i < columns; ++i) {
            const Vec3 offset = amount * random.point(-1.0, 1.0);
            mesh.vertices[j * (columns + 1) + i] +=
                Vec3(offset[0] / columns, offset[1] / rows, 0.0);
        }
    }
    return mesh;
}

TriangleMesh openCylinder(int segments, int rings, double radius, double height) {
    TriangleMesh mesh;
    for (int j = 0; j <= rings; ++j) {
        for (int i = 0; i < segments; ++i) {
            mesh.vertices.push_back(
                aroundAxis(fraction(i, segments), radius, height * fraction(j, rings))
            );
        }
    }
    addGrid(mesh, segments, rings, [&](int i, int j) { return j * segments + i % segments; });
    return mesh;
}

TriangleMesh icosphere(int subdivisions, double radius) {
    TriangleMesh mesh = icosahedron();
    for (int i = 0; i < subdivisions; ++i) {
        mesh = midpointSubdivide(mesh);
        for (Vec3& vertex : mesh.vertices) {
            vertex.normalize();
        }
    }
    for (Vec3& vertex : mesh.vertices) {
        vertex = radius * vertex.normalized();
    }
    return mesh;
}

TriangleMesh torus(int majorSegments, int minorSegments, double majorRadius, double minorRadius) {
    TriangleMesh mesh;
    for (int j = 0; j < minorSegments; ++j) {
        for (int i = 0; i < majorSegments; ++i) {
            const double tube = 2.0 * std::numbers::pi * fraction(j, minorSegments);
            mesh.vertices.push_back(aroundAxis(
                fraction(i, majorSegments),
                majorRadius + minorRadius * std::cos(tube),
                minorRadius * std::sin(tube)
            ));
        }
    }
    addGrid(mesh, majorSegments, minorSegments, [&](int i, int j) {
        return (j % minorSegments) * majorSegments + i % majorSegments;
    });
    return mesh;
}

TriangleMesh box(int cellsPerSide, const Vec3& lengths) {
    TriangleMesh mesh;
    std::map<std::array<int, 3>, int> vertexAtCell;
    const auto vertexAt = [&](const std::array<int, 3>& cell) {
        const auto [entry, isNew] =
            vertexAtCell.try_emplace(cell, static_cast<int>(mesh.vertices.size()));
        if (isNew) {
            mesh.vertices.emplace_back(
                lengths[0] * fraction(cell[0], cellsPerSide),
                lengths[1] * fraction(cell[1], cellsPerSide),
                lengths[2] * fraction(cell[2], cellsPerSide)
            );
        }
        return entry->second;
    };
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const bool far : {false, true}) {
            addGrid(mesh, cellsPerSide, cellsPerSide, [&](int i, int j) {
                std::array<int, 3> cell{};
                cell[axis] = far ? cellsPerSide : 0;
                // The next two axes, cyclic, turn counter-clockwise about this one.
                cell[(axis + 1) % 3] = far ? i : j;
                cell[(axis + 2) % 3] = far ? j : i;
                return vertexAt(cell);
            });
        }
    }
    return mesh;
}

TriangleMesh wedge(int cellsPerSide) {
    TriangleMesh mesh = box(cellsPerSide);
    for (Vec3& vertex : mesh.vertices) {
        vertex.x() *= 1.0 - 0.3 * (1.0 - vertex.z());
    }
    return mesh;
}

TriangleMesh twoComponents() {
    const TriangleMesh sphere = icosphere(1);
    Eigen::Isometry3d aside = Eigen::Isometry3d::Identity();
    aside.translation() = Vec3(4.0, 0.0, 0.0);
    return joined(sphere, transformed(sphere, aside));
}

TriangleMesh midpointSubdivide(const TriangleMesh& mesh) {
    TriangleMesh fine;
    fine.vertices = mesh.vertices;
    std::map<std::pair<int, int>, int> midpoints;
    const auto midpoint = [&](int a, int b) {
        const auto [entry, isNew] =
            midpoints.try_emplace(std::minmax(a, b), static_cast<int>(fine.vertices.size()));
        if (isNew) {
            fine.vertices.emplace_back(0.5 * mesh.vertices[a] + 0.5 * mesh.vertices[b]);
        }
        return entry->second;
    };
    for (const auto& [a, b, c] : mesh.faces) {
        const int ab = midpoint(a, b);
        const int bc = midpoint(b, c);
        const int ca = midpoint(c, a);
        fine.faces.push_back({a, ab, ca});
        fine.faces.push_back({b, bc, ab});
        fine.faces.push_back({c, ca, bc});
        fine.faces.push_back({ab, bc, ca});
    }
    return fine;
}

TriangleMesh transformed(const TriangleMesh& mesh, const Eigen::Isometry3d& motion, double scale) {
    TriangleMesh moved = mesh;
    for (Vec3& vertex : moved.vertices) {
        vertex = motion * Vec3(scale * vertex);
    }
    return moved;
}

TriangleMesh withNoise(TriangleMesh mesh, double amplitude, std::uint64_t seed) {
    Random random(seed);
    for (Vec3& vertex : mesh.vertices) {
        vertex += random.point(-amplitude, amplitude);
    }
    return mesh;
}

TriangleMesh renumbered(const TriangleMesh& mesh, std::uint64_t seed) {
    Random random(seed);
    std::vector<int> oldVertices(mesh.vertices.size());
    std::iota(oldVertices.begin(), oldVertices.end(), 0);
    shuffle(oldVertices, random);

    TriangleMesh result;
    std::vector<int> newVertices(mesh.vertices.size());
    for (const int old : oldVertices) {
        newVertices[old] = static_cast<int>(result.vertices.size());
        result.vertices.push_back(mesh.vertices[old]);
    }
    for (const auto& [a, b, c] : mesh.faces) {
        Triangle face{newVertices[a], newVertices[b], newVertices[c]};
        std::ranges::rotate(face, face.begin() + random.integer(0, 2));
        result.faces.push_back(face);
    }
    shuffle(result.faces, random);
    return result;
}

TriangleMesh joined(const TriangleMesh& first, const TriangleMesh& second) {
    TriangleMesh mesh = first;
    const auto offset = static_cast<int>(first.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), second.vertices.begin(), second.vertices.end());
    for (const auto& [a, b, c] : second.faces) {
        mesh.faces.push_back({a + offset, b + offset, c + offset});
    }
    return mesh;
}

TriangleMesh partedByLabels(TriangleMesh mesh, const std::vector<int>& labels) {
    std::vector<int> labelOf(mesh.vertices.size(), -1);
    std::map<std::pair<int, int>, int> copies;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        for (int& v : mesh.faces[f]) {
            const int label = labels[f];
            if (labelOf[v] < 0) {
                labelOf[v] = label;
            }
            if (labelOf[v] != label) {
                const auto [copy, isNew] =
                    copies.try_emplace({v, label}, static_cast<int>(mesh.vertices.size()));
                if (isNew) {
                    const Vec3 at = mesh.vertices[v];
                    mesh.vertices.push_back(at);
                }
                v = copy->second;
            }
        }
    }
    return mesh;
}

TriangleMesh slitAlongZ(TriangleMesh mesh) {
    std::vector<int> copies(mesh.vertices.size(), -1);
    for (Triangle& face : mesh.faces) {
        Vec3 middle = Vec3::Zero();
        for (const int v : face) {
            middle += mesh.vertices[v] / 3.0;
        }
        for (int& v : face) {
            const Vec3 at = mesh.vertices[v];
            if (std::abs(at.y()) < 1e-9 && at.x() > -1e-9 && middle.y() < 0.0 && middle.x() > 0.0) {
                if (copies[v] < 0) {
                    copies[v] = static_cast<int>(mesh.vertices.size());
                    mesh.vertices.push_back(at);
                }
                v = copies[v];
            }
        }
    }
    return mesh;
}

TriangleMesh withFaceReversed(TriangleMesh mesh, int face) {
    Triangle& corners = mesh.faces.at(face);
    std::swap(corners[1], corners[2]);
    return mesh;
}

TriangleMesh threeFacesAtAnEdge() {
    return {
        .vertices = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}},
        .faces = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}},
    };
}

TriangleMesh bowTie() {
    return {
        .vertices = {{0, 0, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}},
        .faces = {{0, 1, 2}, {0, 3, 4}},
    };
}

TriangleMesh moebiusStrip(int segments) {
    TriangleMesh mesh;
    for (int i = 0; i < segments; ++i) {
        const double half = std::numbers::pi * fraction(i, segments);
        for (const double side : {-0.3, 0.3}) {
            mesh.vertices.push_back(aroundAxis(
                fraction(i, segments), 1.0 + side * std::cos(half), side * std::sin(half)
            ));
        }
    }
    // After one round the two sides are swapped.
    addGrid(mesh, segments, 1, [&](int i, int j) { return i < segments ? 2 * i + j : 1 - j; });
    return mesh;
}

TriangleMesh crossingPlates() {
    const TriangleMesh flat = plate(4, 4);
    Eigen::Isometry3d upright(Eigen::AngleAxisd(0.5 * std::numbers::pi, Vec3::UnitX()));
    upright.pretranslate(Vec3(0.05, 0.55, -0.45));
    return joined(flat, transformed(flat, upright));
}

}  // namespace bspline_curve::test_support

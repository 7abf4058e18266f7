// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"

#include <cstddef>
#include <vector>

namespace bspline_curve {

/// The vertices of all rims, numbered.
class RimPlaces {
public:
    RimPlaces(const std::vector<std::vector<int>>& rims, std::size_t vertexCount)
        : placeOf_(vertexCount, -1) {
        for (const std::vector<int>& rim : rims) {
            for (const int vertex : rim) {
                if (placeOf_[vertex] < 0) {
                    placeOf_[vertex] = static_cast<int>(rimCounts_.size());
                    rimCounts_.push_back(0);
                }
                ++rimCounts_[placeOf_[vertex]];
            }
        }
    }

    [[nodiscard]] std::size_t count() const { return rimCounts_.size(); }

    /// -1 for a vertex on none of the rims.
    [[nodiscard]] int placeOf(int vertex) const { return placeOf_[vertex]; }

    /// Whether several rims meet there.
    [[nodiscard]] bool isShared(int place) const { return rimCounts_[place] > 1; }

private:
    std::vector<int> placeOf_;
    std::vector<int> rimCounts_;  // by place
};

struct MeanLength {
    double sum = 0.0;
    int count = 0;

    void add(double length) {
        sum += length;
        ++count;
    }

    [[nodiscard]] double mean() const { return sum / count; }
};

/// What is beside the vertex of a rim.
struct Beside {
    Vec3 laplacian = Vec3::Zero();  ///< as in RimSurroundings
    Vec3 normal = Vec3::Zero();
    MeanLength sides;             ///< of the faces' sides that end there
    MeanLength beyond;            ///< of those that end at its neighbours, and not on rims
    std::vector<int> neighbours;  ///< places with an edge to this one

    /// The length that edges have around. Beside a curve that was cut along edges are pieces of
    /// those of the mesh, so that those a step farther tell more.
    [[nodiscard]] double size() const { return beyond.count > 0 ? beyond.mean() : sides.mean(); }
};

/// By place. O(n).
[[nodiscard]] std::vector<Beside> besideRims(const TriangleMesh& mesh, const RimPlaces& places);

/// The lengths that edges at the rim should have: those beside it, averaged along the rim.
[[nodiscard]] std::vector<double> averagedAlong(std::vector<double> sizes);

}  // namespace bspline_curve

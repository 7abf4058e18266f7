// SPDX-License-Identifier: GPL-3.0-or-later
#include "fill/patch_retreat.h"

#include "bspline_curve/progress.h"

#include <algorithm>
#include <cstddef>

namespace bspline_curve {

namespace {

constexpr int kMostRetreats = 12;
/// Corners of faces that cross keep this share of their way, in each round.
constexpr double kBack = 0.5;
/// Ways shorter than this share are none.
constexpr double kLeastShare = 0.1;
/// Shares of neighbours differ by at most this, so that no step is left where points went back.
constexpr double kSteepest = 0.25;

/// Lowers shares until those of neighbours differ little.
void smoothShares(std::vector<double>& shares, const std::vector<Triangle>& faces) {
    for (bool isLowered = true; isLowered;) {
        isLowered = false;
        for (const Triangle& face : faces) {
            const double most =
                std::min({shares[face[0]], shares[face[1]], shares[face[2]]}) + kSteepest;
            for (const int corner : face) {
                isLowered = isLowered || shares[corner] > most;
                shares[corner] = std::min(shares[corner], most);
            }
        }
    }
}

}  // namespace

std::vector<Vec3> retreated(
    const std::vector<Vec3>& sound,
    const std::vector<Vec3>& wanted,
    const std::vector<Triangle>& faces,
    const CrossingFaces& crossing,
    const Progress& progress
) {
    std::vector<double> shares(sound.size(), 1.0);
    for (int round = 0; round < kMostRetreats; ++round) {
        report(progress, static_cast<double>(round) / kMostRetreats, "moving a patch back");
        std::vector<Vec3> points(sound.size());
        for (std::size_t i = 0; i < points.size(); ++i) {
            points[i] = sound[i] + shares[i] * (wanted[i] - sound[i]);
        }
        const std::vector<int> bad = crossing(points);
        if (bad.empty()) {
            return points;
        }
        std::vector<char> goesBack(points.size(), 0);
        for (const int face : bad) {
            for (const int corner : faces[face]) {
                goesBack[corner] = 1;
            }
        }
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (goesBack[i] != 0) {
                shares[i] *= kBack;
                shares[i] = shares[i] < kLeastShare ? 0.0 : shares[i];
            }
        }
        smoothShares(shares, faces);
    }
    return sound;
}

}  // namespace bspline_curve

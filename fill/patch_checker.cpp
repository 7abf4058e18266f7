// SPDX-License-Identifier: GPL-3.0-or-later
#include "fill/patch_checker.h"

#include "surface/mesh_checks.h"
#include "utility/index_sets.h"

#include <algorithm>

namespace bspline_curve {

namespace {

/// Edges shorter than this, relative to the largest coordinate, are too fine for single precision.
constexpr double kFineRelative = 1e-5;
/// Of single triangles for one rim: hundredths of a second. Of the flat fills looked at, those that
/// could be repaired needed at most 3300.
constexpr int kMostTests = 4000;
constexpr int kTestsBetween = 256;  // two calls of goOn

std::vector<Vec3> inSinglePrecision(std::vector<Vec3> points) {
    for (Vec3& point : points) {
        point = point.cast<float>().cast<double>();
    }
    return points;
}

}  // namespace

std::vector<int> PatchCrossings::all() const {
    std::vector<int> faces = clearly;
    faces.insert(faces.end(), narrowly.begin(), narrowly.end());
    sortUnique(faces);
    return faces;
}

std::pair<std::size_t, std::size_t> PatchCrossings::counts() const {
    return {clearly.size(), narrowly.size()};
}

bool hasFlatFace(const Patch& patch) {
    return std::ranges::any_of(patch.faces, [&](const Triangle& face) {
        return !hasArea(patch.points[face[0]], patch.points[face[1]], patch.points[face[2]]);
    });
}

std::vector<int> innerCorners(const Patch& patch, const std::vector<int>& faces) {
    std::vector<int> points;
    for (const int face : faces) {
        for (const int corner : patch.faces[face]) {
            if (!patch.isOnRim(corner)) {
                points.push_back(corner - patch.rimCount);
            }
        }
    }
    sortUnique(points);
    return points;
}

PatchChecker::PatchChecker(const TriangleMesh& mesh)
    : vertices_(mesh.vertices),
      rounded_(inSinglePrecision(mesh.vertices)),
      finder_(vertices_, mesh.faces, false),
      roundedFinder_(rounded_, mesh.faces, true) {
    for (const Vec3& vertex : mesh.vertices) {
        largest_ = std::max(largest_, vertex.cwiseAbs().maxCoeff());
    }
}

void PatchChecker::begin(const std::vector<int>& rim, double leastSize, GoOn goOn) {
    rim_ = rim;
    goOn_ = std::move(goOn);
    testsLeft_ = kMostTests;
    isFine_ = leastSize < kFineRelative * largest_;
}

void PatchChecker::keep(const Patch& patch) {
    const std::vector<Triangle> faces = placed(patch);
    const auto firstNew = patch.points.begin() + patch.rimCount;
    vertices_.insert(vertices_.end(), firstNew, patch.points.end());
    const std::vector<Vec3> rounded = inSinglePrecision({firstNew, patch.points.end()});
    rounded_.insert(rounded_.end(), rounded.begin(), rounded.end());
    finder_.keep(faces);
    roundedFinder_.keep(faces);
}

std::vector<Triangle> PatchChecker::placed(const Patch& patch) const {
    const auto firstNew = static_cast<int>(vertices_.size());
    std::vector<Triangle> faces = patch.faces;
    for (Triangle& face : faces) {
        for (int& corner : face) {
            corner = patch.isOnRim(corner) ? rim_[corner] : firstNew + corner - patch.rimCount;
        }
    }
    return faces;
}

template <class Use>
void PatchChecker::withPlaced(const Patch& patch, const Use& use) {
    const std::vector<Triangle> faces = placed(patch);
    const std::size_t count = vertices_.size();
    const auto firstNew = patch.points.begin() + patch.rimCount;
    vertices_.insert(vertices_.end(), firstNew, patch.points.end());
    const std::vector<Vec3> rounded = inSinglePrecision({firstNew, patch.points.end()});
    rounded_.insert(rounded_.end(), rounded.begin(), rounded.end());
    use(faces);
    vertices_.resize(count);
    rounded_.resize(count);
}

PatchCrossings PatchChecker::crossingsOf(const Patch& patch) {
    PatchCrossings crossing;
    goOn_();
    withPlaced(patch, [&](const std::vector<Triangle>& faces) {
        crossing.clearly = finder_.crossingsOf(faces, goOn_).faces();
        if (!crossing.clearly.empty() || isFine_) {
            return;
        }
        goOn_();
        crossing.narrowly = roundedFinder_.crossingsOf(faces, goOn_).faces();
        for (const int face : crossing.narrowly) {
            if (!roundedFinder_.isSliver(faces[face])) {
                crossing.clearly.push_back(face);
            }
        }
        if (!crossing.clearly.empty()) {
            crossing.narrowly.clear();
        }
    });
    return crossing;
}

std::vector<int> PatchChecker::badFaces(const Patch& patch, bool isStrict) {
    std::vector<int> flat = indicesWhere<int>(patch.faces.size(), [&](std::size_t f) {
        const auto& [a, b, c] = patch.faces[f];
        return !hasArea(patch.points[a], patch.points[b], patch.points[c]);
    });
    if (!flat.empty()) {
        return flat;
    }
    const PatchCrossings crossing = crossingsOf(patch);
    return isStrict ? crossing.all() : crossing.clearly;
}

std::vector<std::pair<int, int>> PatchChecker::crossingPairs(const Patch& patch) {
    std::vector<std::pair<int, int>> pairs;
    withPlaced(patch, [&](const std::vector<Triangle>& faces) {
        pairs = finder_.crossingsOf(faces, goOn_).pairs;
        if (pairs.empty() && !isFine_) {
            pairs = roundedFinder_.crossingsOf(faces, goOn_).pairs;
        }
    });
    return pairs;
}

bool PatchChecker::isFree(const Triangle& places) {
    if (--testsLeft_ < 0) {
        return false;
    }
    if (testsLeft_ % kTestsBetween == 0) {
        goOn_();
    }
    const Triangle face{rim_[places[0]], rim_[places[1]], rim_[places[2]]};
    return !finder_.crossesKept(face) && (isFine_ || !roundedFinder_.crossesKept(face));
}

}  // namespace bspline_curve

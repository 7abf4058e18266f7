// SPDX-License-Identifier: GPL-3.0-or-later
#include "fill/fill_holes.h"

#include "bspline_curve/error.h"
#include "bspline_curve/progress.h"
#include "fill/beside_rims.h"
#include "fill/harmonic_values.h"
#include "fill/patch_checker.h"
#include "fill/patch_fairing.h"
#include "fill/patch_retreat.h"
#include "fill/planar_triangulation.h"
#include "fill/rim_triangulation.h"
#include "surface/half_edges.h"
#include "surface/mesh_checks.h"
#include "text/error_messages.h"
#include "utility/index_sets.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

namespace bspline_curve {

namespace {

constexpr int kFairingSteps = 10;
/// Edges at a rim may be as short as its own ones, but not below this share of those around.
constexpr double kLeastSizeRelative = 0.3;
/// Where a patch is fair, edges at the end of a short one of the rim may at most be that much
/// longer, but again not be below a share of those around.
constexpr double kSizeOverShortest = 2.0;
constexpr double kLeastFineRelative = 0.1;
/// First, a patch is refined and faired in few steps, in turn, until its faces become less than
/// this many times more.
constexpr std::size_t kMostRefinements = 5;
constexpr int kFewFairingSteps = 3;
constexpr double kGrowth = 1.15;
/// Patches are first made with about so many faces, or twice those that their rim asks for, then
/// with four times as many as before, in turn.
constexpr double kFewFaces = 800.0;
constexpr double kMostDivisions = 8.0;
/// Points of a rim that is filled smoothly that are triangulated at once.
constexpr int kFewRimPoints = 120;
/// A patch is not divided into more than so many times the faces that it should have.
constexpr double kMostOverExpected = 4.0;
/// How far a middle in line with an edge is lifted off it, relative to the edges around.
constexpr double kLift = 1e-3;
/// Rims that are as near to a plane, relative to their extent, are triangulated in it.
constexpr double kPlanarRelative = 1e-3;
/// Triangulations tried, each without the triangles that crossed others before.
/// Smooth patches are untangled where at most one of so many faces crosses others.
constexpr std::size_t kFacesPerTangle = 5;
constexpr int kUntanglings = 12;
constexpr int kMostTriangulations = 12;
constexpr int kMostRings = 4;  // of faces around those that cross, to be triangulated anew
/// A sheet is first moved off the faces that it copies by this share of the length of its edges,
/// then by halves of it where it crosses.
constexpr double kSheetMove = 0.2;
/// Sheets of up to so many faces are looked for first.
constexpr std::size_t kSmallSheet = 5000;
constexpr int kSheetHalvings = 10;

/// The fewer of its faces cross others the better.
struct Attempt {
    Patch patch;
    PatchCrossings crossing;
};

/// For each point of a closed polygon the mean length of its two sides there.
std::vector<double> rimLengths(const std::vector<Vec3>& points) {
    const std::size_t count = points.size();
    std::vector<double> lengths(count);
    for (std::size_t i = 0; i < count; ++i) {
        lengths[i] = 0.5 * ((points[(i + 1) % count] - points[i]).norm() +
                            (points[(i + count - 1) % count] - points[i]).norm());
    }
    return lengths;
}

/// Has edges at short ones of the rim nearly as short as these.
void lowerSizesAtRim(Patch& patch) {
    for (int i = 0; i < patch.rimCount; ++i) {
        const int next = (i + 1) % patch.rimCount;
        const double length = (patch.points[next] - patch.points[i]).norm();
        for (const int end : {i, next}) {
            const double fine =
                std::max(kSizeOverShortest * length, kLeastFineRelative * patch.most[end]);
            patch.sizes[end] = std::min(patch.sizes[end], fine);
        }
    }
}

/// With inner points that are harmonic between those of the rim.
Patch stretched(Patch patch) {
    ValueRows rim(patch.rimCount, 3);
    for (int i = 0; i < patch.rimCount; ++i) {
        rim.row(i) = patch.points[i];
    }
    const ValueRows points = harmonicFrom(patch.points, patch.faces, rim);
    for (std::size_t i = patch.rimCount; i < patch.points.size(); ++i) {
        patch.points[i] = points.row(static_cast<Eigen::Index>(i));
    }
    return patch;
}

class HoleFiller {
public:
    HoleFiller(
        const TriangleMesh& mesh,
        const std::vector<std::vector<int>>& rims,
        const FillSurroundings& surroundings
    )
        : mesh_(mesh),
          rims_(rims),
          beyond_(surroundings),
          places_(rims, mesh.vertices.size()),
          beside_(besideRims(mesh, places_)),
          result_{.mesh = mesh, .firstNew = {}, .firstFace = {}, .crossing = {}},
          checker_(mesh) {}

    void fill(std::size_t rim, FillShape shape, const Progress& progress) {
        double reached = 0.0;
        const Progress noted = [&](double fraction, const char* stage) {
            reached = fraction;
            return !progress || progress(fraction, stage);
        };
        report(noted, reached, "filling a hole");
        rim_ = rim;
        best_.reset();
        goOn_ = [&] { report(noted, reached, "checking a patch"); };
        checker_.begin(rims_[rim], std::ranges::min(rimPatch().most), goOn_);
        if (shape == FillShape::Flat) {
            fillFlat(noted);
        } else {
            fillSmoothly(noted);
        }
        if (const std::optional<Attempt> best = std::exchange(best_, std::nullopt)) {
            append(*best);
        } else {
            refuse();
        }
    }

    [[nodiscard]] FilledMesh take() { return std::move(result_); }

private:
    /// Keeps a patch where it crosses less than others so far. Returns whether it crosses nothing.
    bool accept(Patch patch) {
        const bool isCopy = std::ssize(patch.points) == patch.rimCount && isFaceOfMesh();
        if (patch.faces.empty() || isCopy || hasFlatFace(patch)) {
            return false;
        }
        PatchCrossings crossing = checker_.crossingsOf(patch);
        if (!best_ || crossing.counts() < best_->crossing.counts()) {
            best_ = Attempt{.patch = std::move(patch), .crossing = std::move(crossing)};
        }
        return best_->crossing.isEmpty();
    }

    void fillFlat(const Progress& progress) {
        const Patch rim = rimPatch();
        if (!triangulate(rim) && !fillWithSheets(partOf(progress, 0.1, 0.5))) {
            fairFromRim(rim, surroundings(), partOf(progress, 0.5, 1.0));
        }
    }

    void fillSmoothly(const Progress& progress) {
        const RimSurroundings around = surroundings();
        const Patch rim = rimPatch();
        const Progress further = partOf(progress, 0.9, 1.0);
        if (fairFromRim(rim, around, partOf(progress, 0.0, 0.9)) ||
            fairFromFlat(rim, around, further) || fillWithSheets(further)) {
            return;
        }
        if (!best_) {
            Patch middle = rim;
            closeWithMiddle(middle);
            accept(std::move(middle));
        }
    }

    /// A coarse patch that is refined and faired.
    bool fairFromRim(const Patch& rim, const RimSurroundings& around, const Progress& progress) {
        Patch smooth = rim;
        // What is refined afterwards need not begin with the best triangulation.
        smooth.faces = triangulateRim(rim.points, rim.forbidden, goOn_, kFewRimPoints);
        if (smooth.faces.empty()) {
            smooth.faces = triangulateRim(rim.points, rim.forbidden, goOn_);
        }
        if (smooth.faces.empty() || isFaceOfMesh()) {
            closeWithMiddle(smooth);
        }
        const std::size_t divisions = divisionsOf(smooth);
        scaleSizes(smooth, std::exp2(static_cast<double>(divisions)));
        refinePatch(smooth, Relaxing::Free, partOf(progress, 0.1, 0.2));
        fairPatch(smooth, around, 1, partOf(progress, 0.2, 0.3));
        // A patch that bulges has longer edges than before, so that it is refined again.
        const Progress passes = partOf(progress, 0.3, 0.5);
        for (std::size_t pass = 0; pass < kMostRefinements; ++pass) {
            const std::size_t before = smooth.faces.size();
            const Progress step = stepOf(passes, pass, kMostRefinements);
            refinePatch(smooth, Relaxing::Tangential, partOf(step, 0.0, 0.5));
            const bool hasGrown =
                static_cast<double>(smooth.faces.size()) >= kGrowth * static_cast<double>(before);
            if (pass > 0 && !hasGrown) {
                break;
            }
            fairPatch(smooth, around, kFewFairingSteps, partOf(step, 0.5, 1.0));
        }
        fairPatch(smooth, around, kFairingSteps, partOf(progress, 0.5, 0.6));
        const Progress halvings = partOf(progress, 0.6, 0.9);
        for (std::size_t division = 0; division < divisions; ++division) {
            scaleSizes(smooth, 0.5);
            const Progress step = stepOf(halvings, division, divisions);
            refinePatch(smooth, Relaxing::Tangential, partOf(step, 0.0, 0.5));
            fairDivided(smooth, around, partOf(step, 0.5, 1.0));
        }
        if (divisions == 0) {  // else few of the faces are at the rim
            lowerSizesAtRim(smooth);
            refinePatch(smooth, Relaxing::Tangential, partOf(halvings, 0.0, 0.5));
            fairDivided(smooth, around, partOf(halvings, 0.5, 1.0));
        }
        report(progress, 0.9, "checking a patch");
        return accept(smooth) || accept(untangled(std::move(smooth)));
    }

    /// A patch of which few faces cross others, with the points there between their neighbours.
    [[nodiscard]] Patch untangled(Patch patch) {
        for (int round = 0; round < kUntanglings; ++round) {
            const std::vector<int> bad = checker_.badFaces(patch, true);
            if (bad.empty() || bad.size() * kFacesPerTangle > patch.faces.size()) {
                break;
            }
            relaxAround(patch, grown(patch.faces, bad, round / 2));
        }
        return patch;
    }

    /// How many faces there are when edges have their size.
    [[nodiscard]] static double expectedFaces(const Patch& patch) {
        double area = 0.0;
        for (const auto& [a, b, c] : patch.faces) {
            const Vec3& p = patch.points[a];
            area += 0.5 * (patch.points[b] - p).cross(patch.points[c] - p).norm();
        }
        double size = 0.0;
        for (int i = 0; i < patch.rimCount; ++i) {
            size += patch.most[i] / patch.rimCount;
        }
        return area / (0.25 * std::numbers::sqrt3 * size * size);  // equilateral triangles
    }

    /// How often edges are to be halved until they have their size, after there are few faces.
    [[nodiscard]] static std::size_t divisionsOf(const Patch& patch) {
        const double few = std::max(kFewFaces, 2.0 * patch.rimCount);
        const double divisions =
            std::ceil(0.5 * std::log2(std::max(expectedFaces(patch), 1.0) / few));
        return static_cast<std::size_t>(std::clamp(divisions, 0.0, kMostDivisions));
    }

    /// Has edges far from the rim longer so many times.
    static void scaleSizes(Patch& patch, double times) {
        for (std::size_t i = 0; i < patch.most.size(); ++i) {
            patch.most[i] *= times;
            patch.sizes[i] = std::min(patch.sizes[i], patch.most[i]);
        }
    }

    /// Triangulates a rim without new points, in one way after the other.
    bool triangulate(const Patch& rim) {
        if (isFaceOfMesh()) {
            return false;
        }
        const PlanarView view = planarView(rim.points);
        const auto inPlane = [&] {
            Patch patch = rim;
            patch.faces = triangulateSeen(rim.points, view, rim.forbidden);
            return accept(std::move(patch));
        };
        const bool isPlanar = view.deviation < kPlanarRelative;
        if (isPlanar && inPlane()) {
            return true;
        }
        Patch bent = rim;
        bent.faces = triangulateRim(rim.points, rim.forbidden, goOn_);
        return accept(std::move(bent)) || (!isPlanar && inPlane()) || repair() ||
               triangulateAround(rim);
    }

    /// Triangulates the best patch anew around its faces that cross, without triangles that cross
    /// what is kept.
    bool repair() {
        if (!best_ || std::ssize(best_->patch.points) > best_->patch.rimCount) {
            return false;
        }
        const Patch before = best_->patch;
        std::vector<int> region = best_->crossing.all();
        for (int rings = 1; rings <= kMostRings; rings *= 2) {
            region = grown(before.faces, region, rings);
            Patch patch = before;
            patch.faces = retriangulated(
                before.points,
                before.faces,
                before.forbidden,
                region,
                [&](const Triangle& places) { return checker_.isFree(places); },
                goOn_
            );
            if (accept(std::move(patch))) {
                return true;
            }
        }
        return false;
    }

    /// Without triangles that cross the mesh, or crossed each other in the attempt before.
    bool triangulateAround(const Patch& rim) {
        std::set<Triangle> refused;
        const auto isAllowed = [&](const Triangle& places) {
            return !refused.contains(places) && checker_.isFree(places);
        };
        for (int i = 0; i < kMostTriangulations; ++i) {
            Patch patch = rim;
            patch.faces =
                triangulateRim(rim.points, rim.forbidden, goOn_, kFewRimPoints, isAllowed);
            if (patch.faces.empty()) {
                return false;
            }
            const std::vector<std::pair<int, int>> pairs = checker_.crossingPairs(patch);
            if (accept(patch)) {
                return true;
            }
            const auto extent = [&](int face) {
                const auto& [a, b, c] = patch.faces[face];
                return (patch.points[a] - patch.points[b]).norm() +
                       (patch.points[b] - patch.points[c]).norm() +
                       (patch.points[c] - patch.points[a]).norm();
            };
            for (const auto& [one, other] : pairs) {
                refused.insert(patch.faces[extent(one) > extent(other) ? one : other]);
            }
        }
        return false;
    }

    /// A flat patch that crosses nothing, divided, and faired as far as it can be.
    bool fairFromFlat(const Patch& rim, const RimSurroundings& around, const Progress& progress) {
        std::optional<Attempt> before = std::exchange(best_, std::nullopt);
        triangulate(rim);
        const std::optional<Attempt> flat = std::exchange(best_, std::move(before));
        if (!flat || !flat->crossing.isEmpty()) {
            return false;
        }
        // Slivers that stay as they are are divided too often.
        const auto most = static_cast<std::size_t>(
            kMostOverExpected * (expectedFaces(flat->patch) + 2.0 * rim.rimCount)
        );
        for (const Relaxing relaxing : {Relaxing::Tangential, Relaxing::None}) {
            Patch divided = flat->patch;
            refinePatch(divided, relaxing, progress, most);
            if (divided.faces.size() > most || hasFlatFace(divided) ||
                !checker_.crossingsOf(divided).isEmpty()) {
                continue;
            }
            Patch fair = divided;
            fairPatch(fair, around, kFairingSteps, progress);
            if (accept(between(divided, fair, progress))) {
                return true;
            }
        }
        return accept(flat->patch);
    }

    /// Copies what was before the rim, or is behind it, whichever is smaller, moved towards a patch
    /// that is stretched over the rim.
    bool fillWithSheets(const Progress& progress) {
        for (const std::size_t most : {kSmallSheet, std::numeric_limits<std::size_t>::max()}) {
            const auto behind = sheetBeside(mesh_, rims_[rim_], true, most);
            const auto removed = beyond_.removed ? beyond_.removed(rim_, most) : std::nullopt;
            if (removed && (!behind || removed->faces.size() < behind->faces.size())) {
                return fillWith(*removed, progress);
            }
            if (behind) {
                return fillWith(movedOff(*behind), progress);
            }
        }
        return false;
    }

    /// Moves a sheet off the faces that it copies, so far as it crosses nothing.
    [[nodiscard]] Patch movedOff(const Patch& sheet) {
        const std::vector<Vec3> ways = waysOff(sheet);
        std::vector<double> shares(ways.size(), kSheetMove);
        Patch moved = sheet;
        for (int i = 0; i < kSheetHalvings; ++i) {
            for (std::size_t p = 0; p < shares.size(); ++p) {
                moved.points[p] = sheet.points[p] + shares[p] * ways[p];
            }
            std::set<int> corners;
            for (const int face : checker_.badFaces(moved, false)) {
                corners.insert(sheet.faces[face].begin(), sheet.faces[face].end());
            }
            if (corners.empty()) {
                break;
            }
            for (const int corner : corners) {
                shares[corner] *= 0.5;
            }
        }
        return moved;
    }

    bool fillWith(const Patch& sound, const Progress& progress) {
        accept(sound);
        return checker_.badFaces(sound, false).empty() &&
               accept(between(sound, stretched(sound), progress));
    }

    /// From a patch that crosses nothing clearly as far to one with the same faces as that is so,
    /// and nothing narrowly either if the first one does not.
    [[nodiscard]] Patch between(const Patch& sound, const Patch& wanted, const Progress& progress) {
        Patch patch = sound;
        const bool isStrict = !hasFlatFace(sound) && checker_.crossingsOf(sound).isEmpty();
        const auto crossing = [&](const std::vector<Vec3>& points) {
            patch.points = points;
            return checker_.badFaces(patch, isStrict);
        };
        patch.points = retreated(sound.points, wanted.points, sound.faces, crossing, progress);
        return patch;
    }

    /// Without faces.
    [[nodiscard]] Patch rimPatch() const {
        const std::vector<int>& vertices = rims_[rim_];
        Patch patch{
            .points = {},
            .sizes = {},
            .most = {},
            .faces = {},
            .rimCount = static_cast<int>(vertices.size()),
            .forbidden = {}
        };
        std::map<int, int> localOf;  // by place
        for (const int vertex : vertices) {
            const int place = places_.placeOf(vertex);
            localOf.emplace(place, static_cast<int>(patch.points.size()));
            patch.points.push_back(mesh_.vertices[vertex]);
            patch.most.push_back(
                beyond_.sizes.empty() ? beside_[place].size() : beyond_.sizes[vertex]
            );
        }
        patch.most = averagedAlong(std::move(patch.most));
        patch.sizes = averagedAlong(rimLengths(patch.points));
        for (std::size_t i = 0; i < patch.sizes.size(); ++i) {
            patch.sizes[i] =
                std::clamp(patch.sizes[i], kLeastSizeRelative * patch.most[i], patch.most[i]);
        }
        for (const auto& [place, local] : localOf) {
            for (const int neighbour : beside_[place].neighbours) {
                const auto other = localOf.find(neighbour);
                if (other != localOf.end()) {
                    const auto [low, high] = std::minmax(local, other->second);
                    patch.forbidden.insert({low, high});
                }
            }
        }
        return patch;
    }

    [[nodiscard]] bool isFaceOfMesh() const {
        const std::vector<int>& rim = rims_[rim_];
        return rim.size() == 3 &&
               std::ranges::any_of(result_.mesh.faces, [&](const Triangle& face) {
                   return std::ranges::all_of(face, [&](int v) { return contains(rim, v); });
               });
    }

    /// Fills a rim that has no triangulation of its own with faces round a new point.
    static void closeWithMiddle(Patch& patch) {
        const int count = patch.rimCount;
        Vec3 middle = Vec3::Zero();
        double size = 0.0;
        for (int i = 0; i < count; ++i) {
            middle += patch.points[i] / count;
            size += patch.most[i] / count;
        }
        patch.points.push_back(middle);
        patch.sizes.push_back(size);
        patch.most.push_back(size);
        patch.faces.clear();
        for (int i = 0; i < count; ++i) {
            patch.faces.push_back({i, (i + 1) % count, count});
        }
        if (hasFlatFace(patch)) {  // the middle is in line with an edge of the rim
            Vec3 area = Vec3::Zero();
            for (int i = 0; i < count; ++i) {
                area += (patch.points[i] - middle).cross(patch.points[(i + 1) % count] - middle);
            }
            patch.points.back() += kLift * size * area.normalized();
        }
    }

    [[nodiscard]] RimSurroundings surroundings() const {
        RimSurroundings around;
        for (const int vertex : rims_[rim_]) {
            const int place = places_.placeOf(vertex);
            around.laplacians.push_back(beside_[place].laplacian);
            around.normals.push_back(beside_[place].normal);
            // Where rims meet, faces of the other patches are missing.
            around.isKnown.push_back(places_.isShared(place) ? 0 : 1);
        }
        return around;
    }

    void append(const Attempt& attempt) {
        const Patch& patch = attempt.patch;
        const std::size_t firstNew = result_.mesh.vertices.size();
        const auto firstFace = static_cast<int>(result_.mesh.faces.size());
        result_.firstNew.push_back(static_cast<int>(firstNew));
        result_.firstFace.push_back(firstFace);
        result_.mesh.vertices.insert(
            result_.mesh.vertices.end(), patch.points.begin() + patch.rimCount, patch.points.end()
        );
        const std::vector<Triangle> faces = checker_.placed(patch);
        for (const int face : attempt.crossing.clearly) {
            result_.crossing.push_back(firstFace + face);
        }
        for (std::size_t f = 0; f < faces.size(); ++f) {
            result_.mesh.faces.push_back(faces[f]);
            for (int k = 0; k < 3; ++k) {
                if (patch.isOnRim(patch.faces[f][k]) &&
                    patch.isOnRim(patch.faces[f][(k + 1) % 3])) {
                    const int from = places_.placeOf(faces[f][k]);
                    const int to = places_.placeOf(faces[f][(k + 1) % 3]);
                    beside_[from].neighbours.push_back(to);
                    beside_[to].neighbours.push_back(from);
                }
            }
        }
        if (rim_ + 1 < rims_.size()) {
            checker_.keep(patch);
        }
    }

    [[noreturn]] void refuse() const {
        std::vector<std::int64_t> vertices(rims_[rim_].begin(), rims_[rim_].end());
        const std::string hole = "a hole of " + describeCount(vertices.size(), "edge", "edges");
        refuseElements(
            InputErrorCode::NoPath,
            hole + " cannot be filled: each way has a face without area",
            "vertices",
            std::move(vertices),
            "choose another shape to fill it with, or move the curve"
        );
    }

    const TriangleMesh& mesh_;
    const std::vector<std::vector<int>>& rims_;
    const FillSurroundings& beyond_;
    RimPlaces places_;
    std::vector<Beside> beside_;  // by place
    FilledMesh result_;
    PatchChecker checker_;
    std::size_t rim_ = 0;  // that is being filled
    GoOn goOn_ = [] {};
    std::optional<Attempt> best_;
};

}  // namespace

std::vector<std::vector<int>> rimsOf(const std::vector<Triangle>& faces) {
    std::map<int, int> next;
    forEachEdge(sortedHalfEdges(faces), [&](std::span<const HalfEdge> sides) {
        if (sides.size() == 1) {
            const Triangle& face = faces[sides[0].face];
            const int from = face[(sides[0].k + 2) % 3];
            if (!next.emplace(from, face[(sides[0].k + 1) % 3]).second) {
                throw std::logic_error("two rims meet at vertex " + std::to_string(from));
            }
        }
    });
    std::vector<std::vector<int>> rims;
    while (!next.empty()) {
        std::vector<int> rim;
        for (int vertex = next.begin()->first; next.contains(vertex);) {
            rim.push_back(vertex);
            const auto at = next.find(vertex);
            vertex = at->second;
            next.erase(at);
        }
        rims.push_back(std::move(rim));
    }
    return rims;
}

FilledMesh fillHoles(
    const TriangleMesh& mesh,
    const std::vector<std::vector<int>>& rims,
    FillShape shape,
    const FillSurroundings& surroundings,
    const Progress& progress
) {
    report(progress, 0.0, "looking at the rims");
    HoleFiller filler(mesh, rims, surroundings);
    for (std::size_t rim = 0; rim < rims.size(); ++rim) {
        filler.fill(rim, shape, stepOf(progress, rim, rims.size()));
    }
    return filler.take();
}

}  // namespace bspline_curve

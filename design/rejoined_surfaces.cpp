// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/rejoined_surfaces.h"

#include "bspline_curve/error.h"
#include "bspline_curve/progress.h"
#include "surface/field_on_surface.h"
#include "surface/rejoining.h"
#include "surface/surface_point.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <utility>

namespace bspline_curve {
namespace {

/// Ways that are not shorter by more than this are left alone.
constexpr double kWorthwhile = 1.05;

constexpr double kSurfaceShare = 0.1;  // of the progress, the rest is for a whole shell

/// See PartedEdges.
std::vector<int> rootsOf(const Surface& surface) {
    std::vector<int> roots = surface.provenance().vertexRoots();
    if (roots.empty()) {
        roots.resize(surface.vertices().size());
        std::iota(roots.begin(), roots.end(), 0);
    }
    return roots;
}

}  // namespace

RejoinedSurfaces::RejoinedSurfaces(const Surface& surface)
    : surface_(surface),
      roots_(rootsOf(surface)),
      parted_(surface, roots_, surface.leavesSlits() || surface.provenance().isOneSided()) {}

/// Whether a way of the length that is worthwhile can reach a parted edge.
bool RejoinedSurfaces::mayBeShorter(const CurveLeg& leg) const {
    const double longest = leg.length / kWorthwhile;
    const Vec3 from = surface_.position(leg.from);
    const Vec3 to = surface_.position(leg.to);
    return (to - from).norm() < longest &&
           std::ranges::any_of(
               parted_.edges(),
               [&](const PartedEdges::Edge& edge) {
                   const double least = (edge.middle - from).norm() + (edge.middle - to).norm();
                   return least - edge.length < longest;
               }
           );
}

/// Whether the mended surface does not go on at a step.
bool RejoinedSurfaces::isCrossed(const Step& step, bool isSlit) const {
    return step.edge >= 0 && parted_.edges()[step.edge].isSlit == isSlit &&
           surface_.faceNeighbours()[step.from / 3][step.from % 3] != step.to / 3;
}

bool RejoinedSurfaces::crosses(const FaceWay& way, bool isSlit) const {
    return std::ranges::any_of(way.steps, [&](const Step& s) { return isCrossed(s, isSlit); });
}

RejoinedSurfaces::Ways RejoinedSurfaces::waysFor(
    const std::vector<CurveLeg>& legs, std::span<const int> avoid, const Progress& progress
) const {
    WaysOverFaces finder(surface_, parted_, avoid);
    Ways ways;
    std::vector<std::optional<FaceWay>> found(legs.size());  // worthwhile ones
    bool isWorthwhile = false;
    const auto find = [&](const CurveLeg& leg, Crossing crossing, double longest) {
        return finder.find(leg.from, leg.to, crossing, longest, progress);
    };
    for (std::size_t i = 0; i < legs.size(); ++i) {
        const CurveLeg& leg = legs[i];
        if (!mayBeShorter(leg)) {
            continue;
        }
        const double longest = leg.length / kWorthwhile;
        const auto index = static_cast<int>(i);
        std::optional<FaceWay> way = find(leg, Crossing::Slits, longest);
        if (way && crosses(*way, true)) {
            const double shortest = way->length;
            way = find(leg, Crossing::Parted, longest);
            if (!way || way->length > kWorthwhile * shortest) {
                ways.shorter.push_back({index, leg.length, shortest, true});
            }
        }
        if (!way || !crosses(*way, false) ||
            find(leg, Crossing::Joined, kWorthwhile * way->length)) {
            continue;
        }
        ways.shorter.push_back({index, leg.length, way->length, false});
        found[i] = std::move(way);
        isWorthwhile = true;
    }
    for (std::size_t i = 0; isWorthwhile && i < legs.size(); ++i) {
        const std::optional<FaceWay> way =
            found[i] ? std::move(found[i])
                     : find(legs[i], Crossing::Joined, std::numeric_limits<double>::infinity());
        isWorthwhile = way.has_value();
        if (way) {
            ways.steps.insert(ways.steps.end(), way->steps.begin(), way->steps.end());
            ways.lengths.push_back(way->length);
        }
    }
    if (!isWorthwhile) {
        ways.steps.clear();
        ways.lengths.clear();
    }
    return ways;
}

std::shared_ptr<const SurfaceCurves> RejoinedSurfaces::curvesFor(
    const std::vector<Step>& steps, const ShellOptions& options, const Progress& progress
) {
    Passages passages = passagesOf(steps);
    {
        const MutexLock lock(mutex_);
        // Where sides agree everywhere, all that is not parted is joined whatever the ways are.
        if (last_ != nullptr && passages_.stretches == passages.stretches &&
            (!isOneSided_ || passages_.strips == passages.strips)) {
            return last_;
        }
    }
    MeshRepair again = rejoined(surface_.mesh(), roots_, parted_, passages);
    const bool isOneSided = again.isOneSided;
    TriangleMesh mesh = std::move(again.mesh);
    Provenance provenance(surface_.provenance(), surface_.mesh(), again);
    try {
        auto made = std::make_shared<const SurfaceCurves>(
            std::make_shared<const Surface>(std::move(mesh), std::move(provenance)),
            options,
            partOf(progress, 0.0, kSurfaceShare)
        );
        if (options.kind != ShellKind::Local) {
            static_cast<void>(made->wholeShell(partOf(progress, kSurfaceShare, 1.0)));
        }
        const MutexLock lock(mutex_);
        passages_ = std::move(passages);
        isOneSided_ = isOneSided;
        last_ = made;
        return made;
    } catch (const InputError&) {
        return nullptr;  // it is no surface
    }
}

ScalarField rejoinedField(
    const Surface& surface, const ScalarField& field, const Surface& rejoined
) {
    const auto values = valuesOn(surface, field);
    if (values == nullptr) {
        return {};
    }
    std::vector<double> there(rejoined.vertices().size(), 0.0);
    for (int f = rejoined.faceCount() - 1; f >= 0; --f) {  // the first face comes last
        for (int k = 0; k < 3; ++k) {
            const SurfacePoint corner{.face = f, .barycentric = Vec3::Unit(k)};
            const auto at = surface.provenance().fromInput(rejoined.provenance().toInput(corner));
            if (!at) {
                throw std::logic_error("a face that was joined anew comes from nowhere");
            }
            there[rejoined.faces()[f][k]] = valueAt(surface.faces(), *values, *at);
        }
    }
    auto own = std::make_shared<const ScalarField::OnSurface>(
        ScalarField::OnSurface{.surface = rejoined.provenance().key(), .values = std::move(there)}
    );
    return {field.values(), std::move(own)};
}

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/provenance.h"

#include "surface/surface_point.h"
#include "utility/index_sets.h"

#include <Eigen/LU>

#include <algorithm>
#include <numeric>
#include <utility>

namespace bspline_curve {

struct Provenance::Data {
    TriangleMesh input;
    MeshRepair repair;  // without its mesh
    std::optional<InputError> refusal;
    std::vector<int> byFace;  // faces of the surface by their face of the input, each ascending

    Data(TriangleMesh from, MeshRepair how, std::optional<InputError> why)
        : input(std::move(from)),
          repair(std::move(how)),
          refusal(std::move(why)),
          byFace(repair.faceOrigins.size()) {
        repair.mesh = {};
        std::iota(byFace.begin(), byFace.end(), 0);
        std::ranges::stable_sort(byFace, {}, [this](int f) { return repair.faceOrigins[f]; });
    }

    [[nodiscard]] auto partsOf(int inputFace) const {
        return std::ranges::equal_range(byFace, inputFace, {}, [this](int f) {
            return repair.faceOrigins[f];
        });
    }
};

namespace {

/// `second` after `first`: from what `second` leads from to what `first` leads to.
MeshRepair composed(const MeshRepair& first, const MeshRepair& second) {
    MeshRepair both;
    for (std::size_t f = 0; f < second.faceOrigins.size(); ++f) {
        const int between = second.faceOrigins[f];
        both.faceOrigins.push_back(first.faceOrigins[between]);
        const auto later = second.changedCorners.find(static_cast<int>(f));
        const auto earlier = first.changedCorners.find(between);
        Eigen::Matrix3d corners = Eigen::Matrix3d::Identity();
        if (later != second.changedCorners.end()) {
            corners = later->second;
        }
        if (earlier != first.changedCorners.end()) {
            corners = earlier->second * corners;
        }
        if (!corners.isIdentity(0.0)) {
            both.changedCorners.emplace(static_cast<int>(f), corners);
        }
    }
    return both;
}

/// The input's vertices at the corners of faces that `repair` has made of `between`.
std::vector<Triangle> cornersThrough(
    const Provenance& before, const TriangleMesh& between, const MeshRepair& repair
) {
    const std::span<const Triangle> earlier = before.inputCorners();
    std::vector<Triangle> corners(repair.faceOrigins.size(), {-1, -1, -1});
    for (std::size_t f = 0; f < corners.size(); ++f) {
        for (int k = 0; k < 3; ++k) {
            const auto [origin, place] =
                repair.toOrigin({.face = static_cast<int>(f), .barycentric = Vec3::Unit(k)});
            for (int j = 0; j < 3; ++j) {
                if (place[j] == 1.0) {
                    corners[f][k] = earlier.empty() ? before.inputVertex(between.faces[origin][j])
                                                    : earlier[origin][j];
                }
            }
        }
    }
    return corners;
}

}  // namespace

Provenance::Provenance(TriangleMesh input, MeshRepair repair, std::optional<InputError> refusal)
    : data_(std::make_shared<const Data>(std::move(input), std::move(repair), std::move(refusal))) {
}

Provenance::Provenance(
    const Provenance& before, const TriangleMesh& between, const MeshRepair& repair
) {
    MeshRepair all = before.isIdentity() ? repair : composed(before.data_->repair, repair);
    all.cornerOrigins = cornersThrough(before, between, repair);
    data_ = std::make_shared<const Data>(
        before.isIdentity() ? between : before.data_->input, std::move(all), before.refusal()
    );
}

const TriangleMesh* Provenance::input() const {
    return data_ ? &data_->input : nullptr;
}

const RepairReport* Provenance::report() const {
    return data_ ? &data_->repair.report : nullptr;
}

std::optional<InputError> Provenance::refusal() const {
    return data_ ? data_->refusal : std::nullopt;
}

bool Provenance::isOneSided() const {
    return data_ && data_->repair.isOneSided;
}

std::string Provenance::note() const {
    if (!data_) {
        return {};
    }
    const RepairReport& report = data_->repair.report;
    return "the mesh was mended: " + report.summary() +
           (report.joinedEdges.empty() ? "" : "; the option slits leaves these open");
}

int Provenance::inputVertex(int vertex) const {
    return data_ ? data_->repair.vertexOrigins[vertex] : vertex;
}

std::span<const Triangle> Provenance::inputCorners() const {
    return data_ ? std::span<const Triangle>(data_->repair.cornerOrigins)
                 : std::span<const Triangle>();
}

std::vector<int> Provenance::vertexRoots() const {
    return data_ ? data_->repair.vertexRoots() : std::vector<int>();
}

int Provenance::inputFace(int face) const {
    return data_ ? data_->repair.faceOrigins[face] : face;
}

SurfacePoint Provenance::toInput(const SurfacePoint& point) const {
    return data_ ? data_->repair.toOrigin(point) : point;
}

void Provenance::bringToInput(SurfacePolyline& line) const {
    if (data_) {
        for (SurfacePoint& point : line.surfacePoints) {
            point = toInput(point);
        }
    }
}

void Provenance::bringToInput(Curve& curve) const {
    if (!data_) {
        return;
    }
    bringToInput(curve.polyline);
    for (SurfacePoint& pick : curve.nearPicks) {
        pick = toInput(pick);
    }
    if (std::optional<FarPart>& part = curve.report.farPart) {
        for (int& face : part->faces) {
            face = inputFace(face);
        }
        sortUnique(part->faces);
    }
}

std::vector<char> Provenance::flagsOfInput(std::vector<char> flags) const {
    if (!data_) {
        return flags;
    }
    std::vector<char> all(data_->input.faces.size(), 0);
    for (std::size_t f = 0; f < flags.size(); ++f) {
        if (flags[f] != 0) {
            all[inputFace(static_cast<int>(f))] = 1;
        }
    }
    return all;
}

std::vector<double> Provenance::valuesOfInput(std::vector<double> values) const {
    if (data_) {
        values.resize(data_->input.vertices.size());
        const RepairReport& report = data_->repair.report;
        // Vertices were merged before some of them were joined.
        for (const auto* pairs : {&report.joinedVertices, &report.mergedVertices}) {
            for (const auto& [vertex, into] : *pairs) {
                values[vertex] = values[into];
            }
        }
    }
    return values;
}

std::optional<SurfacePoint> Provenance::fromInput(const SurfacePoint& point) const {
    if (!data_) {
        return point;
    }
    SurfacePoint best;
    bool isInSplit = false;
    for (const int face : data_->partsOf(point.face)) {
        SurfacePoint there{.face = face, .barycentric = point.barycentric};
        bool isTurnedOnly = true;
        const auto changed = data_->repair.changedCorners.find(face);
        if (changed != data_->repair.changedCorners.end()) {
            const Eigen::Matrix3d& corners = changed->second;
            there.barycentric = corners.inverse() * point.barycentric;
            isTurnedOnly = (corners.array() == corners.array().square()).all();
        }
        if (!there.barycentric.allFinite()) {
            continue;  // the part of a split face that has no width but for rounding
        }
        if (best.face < 0 || there.barycentric.minCoeff() > best.barycentric.minCoeff()) {
            best = there;
            isInSplit = !isTurnedOnly;
        }
    }
    if (best.face < 0) {
        return std::nullopt;
    }
    return isInSplit ? snapped(best, kSnapBarycentric) : best;
}

std::vector<int> Provenance::facesFromInput(std::span<const int> faces) const {
    std::vector<int> wanted(faces.begin(), faces.end());
    sortUnique(wanted);
    if (!data_) {
        return wanted;
    }
    std::vector<int> result;
    for (const int face : wanted) {
        const auto parts = data_->partsOf(face);
        result.insert(result.end(), parts.begin(), parts.end());
    }
    std::ranges::sort(result);
    return result;
}

std::vector<double> Provenance::valuesFromInput(std::span<const double> values) const {
    if (!data_) {
        return {values.begin(), values.end()};
    }
    std::vector<double> result;
    result.reserve(data_->repair.vertexOrigins.size());
    for (const int vertex : data_->repair.vertexOrigins) {
        result.push_back(values[vertex]);
    }
    return result;
}

}  // namespace bspline_curve

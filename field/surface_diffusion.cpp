// SPDX-License-Identifier: GPL-3.0-or-later
#include "field/surface_diffusion.h"

#include "bspline_curve/progress.h"
#include "surface/spatial_order.h"
#include "utility/index_sets.h"
#include "utility/worker_task.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <utility>

namespace bspline_curve {

namespace {

constexpr const char* kSmoothing = "smoothing";  // the stage

// Parts with less area than so many times the time of a step, which is radius^2 / 16, are small.
constexpr double kSmallArea = 16.0;

// Larger weights couple vertices strongly. Edges of equilateral triangles have 0.58, those of
// rectangles cut in two the ratio of their sides: 1 in grids of squares, where rounding would
// choose among them, and so the order, if this were 1.
constexpr double kStrongWeight = 1.37;

// What a factorisation leaves out of a row is made up for by its pivots (Axelsson and Lindskog
// 1986), but for this share of it, and at most for so many times the mass of the row. With all of
// it, rows whose neighbours come first would have pivots far too small; with more left out, what
// varies slowly would be solved slowly, the more the less the masses are.
constexpr double kMostLeftOut = 0.1;
constexpr double kMassesLeftOut = 32.0;

double clampedWeight(double weight) {
    constexpr double kLargest = 1000.0;  // beyond, rounding would swamp the masses
    return std::clamp(weight, 0.0, kLargest);
}

std::size_t cornerOf(const Surface& surface, int face, int vertex) {
    const Triangle& corners = surface.faces()[face];
    return corners[0] == vertex ? 0 : (corners[1] == vertex ? 1 : 2);
}

}  // namespace

/// What a face adds to the matrices of linear elements.
struct SurfaceDiffusion::FaceTerms {
    Vec3 halfCotangents;  ///< of the angles at its corners
    double area = 0.0;

    FaceTerms(const Surface& surface, const Triangle& face);
};

SurfaceDiffusion::FaceTerms::FaceTerms(const Surface& surface, const Triangle& face) {
    const std::array<Vec3, 3> corners{
        surface.vertices()[face[0]], surface.vertices()[face[1]], surface.vertices()[face[2]]
    };
    const double twiceArea = (corners[1] - corners[0]).cross(corners[2] - corners[0]).norm();
    area = 0.5 * twiceArea;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 next = corners[(k + 1) % 3] - corners[k];
        const Vec3 previous = corners[(k + 2) % 3] - corners[k];
        halfCotangents[static_cast<int>(k)] = 0.5 * next.dot(previous) / twiceArea;
    }
}

SurfaceDiffusion::SurfaceDiffusion(const Surface& surface, const Progress& progress) {
    constexpr double kAngles = 0.1, kAlongCurve = 0.25, kFirst = 0.5,
                     kOrdered = 0.75;  // of the time
    report(progress, 0.0, kSmoothing);
    const std::size_t count = surface.vertexCount();
    std::vector<FaceTerms> terms;
    terms.reserve(surface.faces().size());
    for (const Triangle& face : surface.faces()) {
        terms.emplace_back(surface, face);
    }
    report(progress, kAngles, kSmoothing);
    vertexOf_.reserve(count);
    const Vec3& somewhere = surface.vertices()[surface.faces().front()[0]];
    for (const MortonKey& key : spatialOrder(count, [&](std::size_t i) {
             const Vec3& vertex = surface.vertices()[i];
             return vertex.allFinite() ? vertex : somewhere;  // one that no face uses
         })) {
        vertexOf_.push_back(key.index);
    }
    assemble(surface, terms, partOf(progress, kAlongCurve, kFirst));
    std::vector<CoupledRows> strong = strongEdges();
    if (!strong.empty()) {
        std::vector<int> order = eliminationOrder(surface.vertexCount(), std::move(strong));
        for (int& row : order) {
            row = vertexOf_[row];
        }
        vertexOf_ = std::move(order);
        assemble(surface, terms, partOf(progress, kOrdered, 1.0));
    }
    report(progress, 1.0, kSmoothing);
    findParts();
}

std::vector<CoupledRows> SurfaceDiffusion::strongEdges() const {
    std::vector<CoupledRows> edges;
    for (int row = 0; row < static_cast<int>(vertexOf_.size()); ++row) {
        for (int i = middles_[row]; i < offsets_[row + 1]; ++i) {
            if (weights_[i] > kStrongWeight) {
                edges.push_back({.from = row, .to = neighbours_[i], .weight = weights_[i]});
            }
        }
    }
    return edges;
}

void SurfaceDiffusion::assemble(
    const Surface& surface, const std::vector<FaceTerms>& terms, const Progress& progress
) {
    constexpr int kReportEvery = 65536;
    const std::size_t count = vertexOf_.size();
    std::vector<int> rowOf(count);
    for (std::size_t row = 0; row < count; ++row) {
        rowOf[vertexOf_[row]] = static_cast<int>(row);
    }
    masses_.setZero(surface.vertexCount());
    weightSums_.setZero(surface.vertexCount());
    offsets_.clear();
    offsets_.reserve(count + 1);
    middles_.clear();
    middles_.reserve(count);
    neighbours_.clear();
    neighbours_.reserve(3 * surface.faces().size());
    weights_.clear();
    weights_.reserve(3 * surface.faces().size());
    std::vector<std::pair<int, double>> edges;  // of one row
    for (int row = 0; row < surface.vertexCount(); ++row) {
        if (row % kReportEvery == 0) {
            report(progress, static_cast<double>(row) / surface.vertexCount(), kSmoothing);
        }
        const int v = vertexOf_[row];
        edges.clear();
        // Counter-clockwise: the last edge of a face is the first one of the next.
        for (const int face : surface.facesAround(v)) {
            const Triangle& corners = surface.faces()[face];
            const int k = static_cast<int>(cornerOf(surface, face, v));
            const int next = (k + 1) % 3;
            const int previous = (k + 2) % 3;
            const auto& [cotangents, area] = terms[face];
            const int to = rowOf[corners[next]];
            if (edges.empty() || edges.back().first != to) {
                edges.emplace_back(to, 0.0);
            }
            edges.back().second += cotangents[previous];
            edges.emplace_back(rowOf[corners[previous]], cotangents[next]);
            masses_[row] += area / 3.0;
        }
        if (edges.empty()) {
            masses_[row] = 1.0;
        } else if (!surface.isBoundaryVertex(v)) {
            edges.front().second += edges.back().second;
            edges.pop_back();
        }
        std::ranges::sort(edges);
        offsets_.push_back(static_cast<int>(neighbours_.size()));
        middles_.push_back(offsets_.back());
        for (const auto& [to, weight] : edges) {
            middles_.back() += to < row ? 1 : 0;
            neighbours_.push_back(to);
            weights_.push_back(clampedWeight(weight));
            weightSums_[row] += weights_.back();
        }
    }
    offsets_.push_back(static_cast<int>(neighbours_.size()));
}

void SurfaceDiffusion::findParts() {
    constexpr std::size_t kMostRows = 5000;  // the factorisation of more would take long
    std::vector<bool> isSeen(vertexOf_.size());
    for (int first = 0; first < static_cast<int>(isSeen.size()); ++first) {
        if (isSeen[first]) {
            continue;
        }
        isSeen[first] = true;
        std::vector<int> part = {first};
        for (std::size_t next = 0; next < part.size(); ++next) {
            for (int i = offsets_[part[next]]; i < offsets_[part[next] + 1]; ++i) {
                if (weights_[i] > 0.0 && !isSeen[neighbours_[i]]) {
                    isSeen[neighbours_[i]] = true;
                    part.push_back(neighbours_[i]);
                }
            }
        }
        if (part.size() > 1 && part.size() <= kMostRows) {
            std::ranges::sort(part);
            parts_.push_back(std::move(part));
        }
    }
}

SurfaceDiffusion::SmallPart SurfaceDiffusion::smallPart(
    const std::vector<int>& rows, double time
) const {
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t at = 0; at < rows.size(); ++at) {
        const int row = rows[at];
        const auto here = static_cast<int>(at);
        entries.emplace_back(here, here, masses_[row] + time * weightSums_[row]);
        for (int i = offsets_[row]; i < offsets_[row + 1]; ++i) {
            if (weights_[i] > 0.0) {
                entries.emplace_back(here, indexIn(rows, neighbours_[i]), -time * weights_[i]);
            }
        }
    }
    const auto count = static_cast<Eigen::Index>(rows.size());
    Eigen::SparseMatrix<double> matrix(count, count);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return {rows, std::make_unique<const Cholesky>(matrix)};
}

SurfaceDiffusion::Factors SurfaceDiffusion::factorsFor(
    double time, const Progress& progress
) const {
    Factors factors{
        .time = time,
        .diagonal = masses_ + time * weightSums_,
        .pivots = Eigen::VectorXd(masses_.size()),
        .smallParts = {},
        .isSmall = std::vector<bool>(vertexOf_.size()),
    };
    for (const std::vector<int>& rows : parts_) {
        report(progress, 0.0, kSmoothing);
        double area = 0.0;
        for (const int row : rows) {
            area += masses_[row];
        }
        if (area < kSmallArea * time) {
            factors.smallParts.push_back(smallPart(rows, time));
            for (const int row : rows) {
                factors.isSmall[row] = true;
            }
        }
    }
    // A pivot is the diagonal less, for each neighbour before, the entry to it times what is made
    // up for in its row, over its pivot; here by sums of what is positive, without differences.
    const Eigen::VectorXd leftOut =
        (kMassesLeftOut * masses_.array() / factors.diagonal.array()).min(kMostLeftOut);
    Eigen::VectorXd toLater = Eigen::VectorXd::Zero(factors.pivots.size());
    Eigen::VectorXd rest = masses_;  // of a pivot, without what is to later rows
    for (int row = 0; row < factors.pivots.size(); ++row) {
        for (int i = middles_[row]; i < offsets_[row + 1]; ++i) {
            toLater[row] += time * weights_[i];
        }
        for (int i = offsets_[row]; i < middles_[row]; ++i) {
            const int before = neighbours_[i];
            const double entry = time * weights_[i];
            const double lost = leftOut[before] * std::max(0.0, toLater[before] - entry);
            rest[row] += entry * (rest[before] + lost) / factors.pivots[before];
        }
        factors.pivots[row] = toLater[row] + rest[row];
    }
    return factors;
}

/// Solves (M + time L) x = M values for some columns, by conjugate gradients with an incomplete
/// Cholesky factorisation C P^-1 C^T as preconditioner: C has the matrix's entries below its
/// diagonal and the pivots P on it, which make up for most of what is left out (Gustafsson 1978).
/// Its two sweeps take the place of the product with the matrix (Eisenstat 1981): with A = C + C^T
/// + D - 2 P, the operator C^-1 A C^-T takes p to t + C^-1 (p + (D - 2 P) t), where t = C^-T p.
template <int C>
class SurfaceDiffusion::ImplicitStep {
public:
    /// Overwrites the values.
    ImplicitStep(
        const SurfaceDiffusion& diffusion, const Factors& factors, const ColumnsRef<C>& values
    )
        : on_(diffusion),
          factors_(factors),
          values_(values),
          back_(values.rows(), C),
          forth_(values.rows(), C),
          residual_(values.rows(), C),
          direction_(Columns<C>::Zero(values.rows(), C)) {}

    /// Calls look(share) with the share of the work that is done, before each iteration.
    template <class Look>
    void solve(const Look& look) {
        constexpr int kMaxIterations = 2000;
        for (const SmallPart& part : factors_.smallParts) {
            look(0.0);
            solve(part);
        }
        const auto [enough, first] = begin();
        Row error = first;
        Row turn = Row::Zero();
        // Errors fall at about the same rate in all iterations.
        const double way = std::log(farthest(first, enough));
        double share = 0.0;
        for (int iteration = 0; iteration < kMaxIterations && (error > enough).any(); ++iteration) {
            share = std::max(share, 1.0 - std::log(farthest(error, enough)) / way);
            look(share);
            sweepBackwards(turn);
            const Row curvature = sweepForwards();
            const Row step = (error > enough).select(error / curvature, Row::Zero());
            const Row next = go(step);
            turn = (error > enough).select(next / error, Row::Zero());
            error = next;
        }
    }

private:
    using Row = Eigen::Array<double, 1, C>;

    // What C^-1 has at a row, from what it has at the rows before it.
    [[nodiscard]] Row solvedForwards(const Columns<C>& solved, int row, const Row& right) const {
        return broughtOver(solved, on_.offsets_[row], on_.middles_[row], right) /
               factors_.pivots[row];
    }

    // Likewise C^-T, from the rows after it.
    [[nodiscard]] Row solvedBackwards(const Columns<C>& solved, int row, const Row& right) const {
        return broughtOver(solved, on_.middles_[row], on_.offsets_[row + 1], right) /
               factors_.pivots[row];
    }

    // The right side with the neighbours from begin to end brought over.
    [[nodiscard]] Row broughtOver(const Columns<C>& solved, int begin, int end, Row right) const {
        for (int i = begin; i < end; ++i) {
            right += factors_.time * on_.weights_[i] * solved.row(on_.neighbours_[i]).array();
        }
        return right;
    }

    // The largest error that is not yet small enough, relative to one that is; else 1.
    [[nodiscard]] static double farthest(const Row& error, const Row& enough) {
        return (error > enough).select(error / enough, Row::Ones()).maxCoeff();
    }

    [[nodiscard]] int rows() const { return static_cast<int>(values_.rows()); }

    void solve(const SmallPart& part) {
        const auto count = static_cast<Eigen::Index>(part.rows.size());
        Eigen::Matrix<double, Eigen::Dynamic, C> right(count, C);
        for (Eigen::Index i = 0; i < count; ++i) {
            right.row(i) = on_.masses_[part.rows[i]] * values_.row(part.rows[i]);
        }
        right = part.factor->solve(right).eval();
        for (Eigen::Index i = 0; i < count; ++i) {
            values_.row(part.rows[i]) = right.row(i);
        }
    }

    // The residual of the values as they are; returns errors that are small enough, and its own.
    std::pair<Row, Row> begin() {
        constexpr double kTolerance = 1e-5;  // of the values, in the norm of the preconditioner
        Row enough = Row::Zero();
        Row error = Row::Zero();
        for (int row = 0; row < rows(); ++row) {
            if (factors_.isSmall[row]) {
                forth_.row(row).setZero();
                residual_.row(row).setZero();
                continue;
            }
            const Row own = values_.row(row);
            Row rest = -on_.weightSums_[row] * own;
            for (int i = on_.offsets_[row]; i < on_.offsets_[row + 1]; ++i) {
                rest += on_.weights_[i] * values_.row(on_.neighbours_[i]).array();
            }
            const Row right = solvedForwards(forth_, row, on_.masses_[row] * own);
            rest = solvedForwards(residual_, row, factors_.time * rest);
            forth_.row(row) = right.matrix();
            residual_.row(row) = rest.matrix();
            enough += kTolerance * kTolerance * factors_.pivots[row] * right * right;
            error += factors_.pivots[row] * rest * rest;
        }
        return {enough, error};
    }

    // The next direction p and t.
    void sweepBackwards(const Row& turn) {
        for (int row = rows() - 1; row >= 0; --row) {
            const Row here = factors_.pivots[row] * residual_.row(row).array() +
                             turn * direction_.row(row).array();
            direction_.row(row) = here.matrix();
            back_.row(row) = solvedBackwards(back_, row, here).matrix();
        }
    }

    // What the operator adds to t; returns p times the operator's p.
    Row sweepForwards() {
        Row curvature = Row::Zero();
        for (int row = 0; row < rows(); ++row) {
            const Row here = direction_.row(row);
            const Row there = back_.row(row);
            const double rest = factors_.diagonal[row] - 2.0 * factors_.pivots[row];
            const Row added = solvedForwards(forth_, row, here + rest * there);
            forth_.row(row) = added.matrix();
            curvature += here * (there + added);
        }
        return curvature;
    }

    // Moves the values along t; returns the error that is left.
    Row go(const Row& step) {
        Row error = Row::Zero();
        for (int row = 0; row < rows(); ++row) {
            const Row there = back_.row(row);
            values_.row(row).array() += step * there;
            const Row rest = residual_.row(row).array() - step * (there + forth_.row(row).array());
            residual_.row(row) = rest.matrix();
            error += factors_.pivots[row] * rest * rest;
        }
        return error;
    }

    const SurfaceDiffusion& on_;
    const Factors& factors_;
    ColumnsRef<C> values_;
    Columns<C> back_;       // t
    Columns<C> forth_;      // what the operator adds to it
    Columns<C> residual_;   // C^-1 times that of the values
    Columns<C> direction_;  // p
};

template <int K>
VertexValues<K> SurfaceDiffusion::smoothed(
    const VertexValues<K>& values, double radius, const Progress& progress
) const {
    constexpr int kSteps = 2;
    if (radius <= 0.0) {
        return values;
    }
    VertexValues<K> byRow(values.rows(), K);
    for (Eigen::Index row = 0; row < values.rows(); ++row) {
        byRow.row(row) = values.row(vertexOf_[row]);
    }
    // A disc has the variance radius^2 / 4 along each axis, diffusion for the time t has 2 t.
    const double time = radius * radius / 8.0;
    const Factors factors = factorsFor(time / kSteps, progress);
    const auto diffuse = [&]<int From, int Count>(const auto& look) {
        for (int step = 0; step < kSteps; ++step) {
            ImplicitStep<Count>(*this, factors, byRow.template middleCols<Count>(From))
                .solve([&](double share) { look((step + share) / kSteps); });
        }
    };
    const auto reported = [&](double share) { report(progress, share, kSmoothing); };
    // Columns do not depend on each other.
    constexpr int kHalf = (K + 1) / 2;
    if constexpr (K > 1) {
        std::atomic<bool> isCancelled = false;
        auto rest = startBeside(2 * vertexOf_.size(), [&] {
            diffuse.template operator()<kHalf, K - kHalf>([&](double) {
                if (isCancelled) {
                    throw Cancelled();
                }
            });
        });
        try {
            diffuse.template operator()<0, kHalf>(reported);
        } catch (...) {
            isCancelled = true;
            throw;
        }
        rest.get();
    } else {
        diffuse.template operator()<0, K>(reported);
    }
    VertexValues<K> result(values.rows(), K);
    for (Eigen::Index row = 0; row < values.rows(); ++row) {
        result.row(vertexOf_[row]) = byRow.row(row);
    }
    return result;
}

template VertexValues<1> SurfaceDiffusion::smoothed<1>(
    const VertexValues<1>&, double, const Progress&
) const;
template VertexValues<9> SurfaceDiffusion::smoothed<9>(
    const VertexValues<9>&, double, const Progress&
) const;

}  // namespace bspline_curve

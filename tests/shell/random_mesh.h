// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"

#include <array>
#include <cstdint>
#include <string>

namespace bspline_curve::test_support {

/// Kinds of surfaces that shells are simplified on, by what may go wrong there.
enum class RandomKind {
    NoisySphere,    ///< normals that scatter
    NoisyTorus,     ///< a handle, and both signs of curvature
    BumpyPlate,     ///< a boundary; bumps of several sizes
    Block,          ///< a box with creases, some of it thin, and noise on it
    Scan,           ///< smooth bumps, a little noise, holes
    Tube,           ///< two boundaries
    Folds,          ///< noise so strong that faces turn over and cross
    SeveralPieces,  ///< components near each other, of unlike size
};

inline constexpr std::array kRandomKinds = {
    RandomKind::NoisySphere,
    RandomKind::NoisyTorus,
    RandomKind::BumpyPlate,
    RandomKind::Block,
    RandomKind::Scan,
    RandomKind::Tube,
    RandomKind::Folds,
    RandomKind::SeveralPieces
};

/// A mesh of the kind, of 100 to 4,000 faces (smaller ones partly subdivided into coplanar faces),
/// with vertices and faces in random order, somewhere in space at some scale. Two-manifold,
/// oriented; but for Folds without self-intersections by intent, not by proof.
[[nodiscard]] TriangleMesh randomMesh(RandomKind kind, std::uint64_t seed);

/// For names of tests: "NoisySphere".
[[nodiscard]] std::string nameOf(RandomKind kind);

}  // namespace bspline_curve::test_support

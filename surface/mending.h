// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/error.h"
#include "surface/refused_mesh.h"
#include "surface/repair.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

// Meshes that Surface refuses are mended where that helps, and only then.
namespace bspline_curve {

/// What is done to a mesh before it is used.
struct MendingOptions {
    bool strict = false;  ///< nothing: one that is broken is refused
    double weld = 0.0;    ///< vertices within so many diagonals are joined first
};

/// How a mesh became one that Surface accepts.
struct Mending {
    MeshRepair repair;  ///< its own mesh has moved to what was made of it
    /// What was wrong with the mesh as it was given, with its ids; none where it was welded.
    std::optional<InputError> refusal;

    /// For users: "the mesh was mended: 1 vertex duplicated".
    [[nodiscard]] std::string note() const;

    /// A value per vertex of the mended mesh as one per vertex of the given mesh: vertices that
    /// were merged have the value of what they became.
    [[nodiscard]] std::vector<double> toOrigin(std::vector<double> values) const;
};

template <class Product>
struct Mended {
    Product made;
    std::optional<Mending> mending{};  ///< none: made of the mesh as it was given

    /// What was mended, or null.
    [[nodiscard]] const MeshRepair* repair() const { return mending ? &mending->repair : nullptr; }
};

/// Mends the mesh; throws the refusal where that is not among what repairMesh can mend.
[[nodiscard]] Mending mend(RefusedMesh& refused);

/// Throws InputError (BadOption) where the mesh is to be refused and to be welded.
void checkMending(const MendingOptions& options);

/// What `make` makes of a mesh, which validates it by constructing a Surface. A mesh that is
/// refused is mended first, unless that is to be `strict`; one that is fine costs nothing more.
/// Throws as `make` and checkMending(); ids are those of the given mesh where it cannot be mended
/// or must not be.
template <class Make>
auto makeMended(TriangleMesh mesh, const MendingOptions& options, const Make& make)
    -> Mended<decltype(make(std::move(mesh)))> {
    checkMending(options);
    if (options.weld > 0.0) {
        Mending mending{.repair = repairMesh(std::move(mesh), options.weld), .refusal = {}};
        auto made = make(std::move(mending.repair.mesh));
        if (mending.repair.report.isEmpty()) {
            return {.made = std::move(made)};
        }
        return {.made = std::move(made), .mending = std::move(mending)};
    }
    try {
        return {.made = make(std::move(mesh))};
    } catch (RefusedMesh& refused) {
        if (options.strict) {
            throw;
        }
        Mending mending = mend(refused);
        try {
            auto made = make(std::move(mending.repair.mesh));
            return {.made = std::move(made), .mending = std::move(mending)};
        } catch (const RefusedMesh&) {
            throw InputError(mending.refusal.value());
        }
    }
}

}  // namespace bspline_curve

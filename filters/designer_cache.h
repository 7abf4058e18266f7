// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/designer.h"
#include "surface/mending.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <optional>

namespace bspline_curve {

/// The designers of the last few surfaces, for further curves in the same session: mesh validated,
/// shell built. What belongs to a mesh is decided by its content alone (every bit of the vertices,
/// the faces, the options of the shell, the distance of MendingOptions::weld), so none is ever
/// stale, however a document changed, and an edit that was undone finds its designer again. Several
/// threads may use one cache.
class DesignerCache {
public:
    /// A designer takes about as much memory as its shell; few are kept.
    static constexpr std::size_t kDefaultCapacity = 3;

    explicit DesignerCache(std::size_t capacity = kDefaultCapacity) : capacity_(capacity) {}

    struct Found {
        std::shared_ptr<const CurveDesigner> designer;
        std::shared_ptr<const Mending> mending;  ///< null: the mesh is as it was given
        bool isKept = false;                     ///< from an earlier call

        [[nodiscard]] const MeshRepair* repair() const {
            return mending ? &mending->repair : nullptr;
        }
    };

    /// The designer for this mesh and these options: a kept one, else what `make` returns, which is
    /// then kept; beyond the capacity the one goes that was not used for longest. Whatever `make`
    /// throws goes through, and nothing is kept.
    [[nodiscard]] Found findOrMake(
        const TriangleMesh& mesh,
        const ShellOptions& options,
        const std::function<Mended<CurveDesigner>()>& make,
        double weld = 0.0
    );

private:
    struct Entry {
        std::uint64_t hash = 0;
        ShellOptions options;
        double weld = 0.0;
        std::shared_ptr<const CurveDesigner> designer;
        std::shared_ptr<const Mending> mending;
        TriangleMesh given{};  ///< only where it was mended; else the designer has it

        [[nodiscard]] const TriangleMesh& mesh() const {
            return mending ? given : designer->mesh();
        }
    };

    [[nodiscard]] std::optional<Found> find(
        std::uint64_t hash, const TriangleMesh& mesh, const ShellOptions& options, double weld
    );

    std::size_t capacity_;
    std::mutex mutex_;
    std::list<Entry> entries_;  ///< the one that was used last comes first
};

}  // namespace bspline_curve

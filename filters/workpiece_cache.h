// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/workpiece.h"
#include "utility/threads.h"

#include <cstddef>
#include <cstdint>
#include <list>
#include <memory>

namespace bspline_curve {

/// The workpieces of the last few meshes, for further curves in the same session. What belongs to a
/// mesh is decided by its content alone (every bit of the vertices, the faces, the options), so
/// none is ever stale, however a document changed, and an edit that was undone finds its workpiece
/// again. Several threads may use one cache.
class WorkpieceCache {
public:
    /// A designer takes about as much memory as its shell; few are kept.
    static constexpr std::size_t kDefaultCapacity = 3;

    explicit WorkpieceCache(std::size_t capacity = kDefaultCapacity) : capacity_(capacity) {}

    struct Found {
        std::shared_ptr<const Workpiece> workpiece;
        bool isKept = false;  ///< from an earlier call

        const Workpiece* operator->() const { return workpiece.get(); }
    };

    /// The workpiece of this mesh and these options: a kept one, or a new one, which is then kept;
    /// beyond the capacity the one goes that was not used for longest. What is thrown goes through,
    /// and nothing is kept.
    [[nodiscard]] Found findOrMake(
        const TriangleMesh& mesh, const PreparingOptions& options, const Progress& progress = {}
    );

    /// The same, prepared with a shell that may come from disk; for a mesh of this layer, whose ids
    /// errors then name, see madeFrom().
    [[nodiscard]] Found ready(
        const LayerInput& layer, const PreparingOptions& options, const Progress& progress = {}
    );

private:
    struct Entry {
        std::uint64_t hash = 0;
        std::shared_ptr<const Workpiece> workpiece;
    };

    std::size_t capacity_;
    Mutex mutex_;
    std::list<Entry> entries_;  ///< the one that was used last comes first
};

}  // namespace bspline_curve

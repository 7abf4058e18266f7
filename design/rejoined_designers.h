// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/designer.h"
#include "surface/passages.h"
#include "surface/repair.h"
#include "surface/surface.h"
#include "surface/triangle_tree.h"

#include <memory>
#include <mutex>
#include <span>
#include <vector>

namespace bspline_curve {

/// Designers for picks that mending has put on different components, each on the mesh joined anew
/// for its picks; the last one is kept. Several threads may use it at once.
class RejoinedDesigners {
public:
    /// `vertexOrigins`: of the mended mesh, see MeshRepair.
    explicit RejoinedDesigners(std::vector<int> vertexOrigins)
        : vertexOrigins_(std::move(vertexOrigins)) {}

    /// A designer on the mended mesh joined anew, see rejoined().
    struct Rejoined {
        std::vector<Passage> passages;
        MeshRepair repair;  ///< of the mended mesh; its own mesh has moved to the designer
        CurveDesigner designer;
    };

    /// For a curve through the picks, round the faces to avoid, ascending. Null where they lie on
    /// one component already, or have no way between them, or only one over an edge too short to
    /// be divided. Throws Cancelled.
    [[nodiscard]] std::shared_ptr<const Rejoined> find(
        const Surface& mended,
        const TriangleTree& tree,
        const std::vector<Vec3>& picks,
        bool closed,
        const std::vector<int>& avoid,
        const ShellOptions& options,
        const Progress& progress
    );

private:
    std::vector<int> vertexOrigins_;
    std::mutex mutex_;
    std::shared_ptr<const Rejoined> last_;
};

/// What curves on the mended mesh are drawn by, on the rejoined one: linear along divided edges;
/// where vertices became one, it has the value of the first face around it. Starts are left out.
struct RejoinedInputs {
    std::vector<double> field;
    std::vector<int> avoid;

    RejoinedInputs(
        const CurveInputs& inputs,
        const Surface& mended,
        const RejoinedDesigners::Rejoined& rejoined
    );
};

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/rejoined_designers.h"

#include "design/curve_on_given_mesh.h"
#include "surface/refused_mesh.h"
#include "surface/rejoining.h"
#include "utility/report_progress.h"

#include <utility>

namespace bspline_curve {
namespace {

constexpr double kWaysShare = 0.5;  // of the progress

}  // namespace

std::shared_ptr<const RejoinedDesigners::Rejoined> RejoinedDesigners::find(
    const Surface& mended,
    const TriangleTree& tree,
    const std::vector<Vec3>& picks,
    bool closed,
    const std::vector<int>& avoid,
    const ShellOptions& options,
    const Progress& progress
) {
    std::vector<int> faces;
    for (const Vec3& pick : picks) {
        faces.push_back(tree.closestPoint(pick).point.face);
    }
    if (closed) {
        faces.push_back(faces.front());
    }
    std::vector<Passage> passages =
        passagesBetween(mended, vertexOrigins_, faces, avoid, partOf(progress, 0.0, kWaysShare));
    if (passages.empty()) {
        return nullptr;
    }
    {
        const std::scoped_lock lock(mutex_);
        if (last_ != nullptr && last_->passages == passages) {
            return last_;
        }
    }
    try {
        MeshRepair repair = rejoined(mended.mesh(), vertexOrigins_, passages);
        CurveDesigner designer(std::move(repair.mesh), options, partOf(progress, kWaysShare, 1.0));
        auto made = std::make_shared<const Rejoined>(
            Rejoined{std::move(passages), std::move(repair), std::move(designer)}
        );
        const std::scoped_lock lock(mutex_);
        last_ = made;
        return made;
    } catch (const RefusedMesh&) {
        // Edges of a few digits' length cannot be divided: faces are left without area.
        return nullptr;
    }
}

RejoinedInputs::RejoinedInputs(
    const CurveInputs& inputs, const Surface& mended, const RejoinedDesigners::Rejoined& rejoined
) {
    avoid = facesOfMended(inputs.avoid, rejoined.repair);
    if (inputs.field.empty()) {
        return;
    }
    const TriangleMesh& mesh = rejoined.designer.mesh();
    const auto faceCount = static_cast<int>(mesh.faces.size());
    field.assign(mesh.vertices.size(), 0.0);
    for (int f = faceCount - 1; f >= 0; --f) {  // the first face comes last
        for (int k = 0; k < 3; ++k) {
            const auto [face, weights] = rejoined.repair.toOrigin({f, Vec3::Unit(k)});
            double value = 0.0;
            for (int corner = 0; corner < 3; ++corner) {
                value += weights[corner] * inputs.field[mended.faces()[face][corner]];
            }
            field[mesh.faces[f][k]] = value;
        }
    }
}

}  // namespace bspline_curve

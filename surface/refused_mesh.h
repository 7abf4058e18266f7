// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/error.h"
#include "bspline_curve/mesh.h"

#include <memory>
#include <utility>

namespace bspline_curve {

/// What Surface throws: the error with the mesh, which it had taken over, for those who can mend
/// it.
class RefusedMesh : public InputError {
public:
    RefusedMesh(const InputError& error, TriangleMesh mesh)
        : InputError(error), mesh_(std::make_shared<TriangleMesh>(std::move(mesh))) {}

    /// The mesh as it was given; once.
    [[nodiscard]] TriangleMesh takeMesh() { return std::move(*mesh_); }

private:
    std::shared_ptr<TriangleMesh> mesh_;  // copies of exceptions must not throw
};

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/mending.h"

namespace bspline_curve {

namespace {

/// Whether repairMesh can mend what a mesh was refused for.
bool canBeMended(InputErrorCode code) {
    return code == InputErrorCode::DegenerateFace || code == InputErrorCode::NonManifoldEdge ||
           code == InputErrorCode::NonManifoldVertex ||
           code == InputErrorCode::InconsistentOrientation;
}

/// The error without the mesh.
InputError errorOf(const RefusedMesh& refused) {
    return {refused.code(), refused.what(), refused.elements()};
}

}  // namespace

std::string Mending::note() const {
    return "the mesh was mended: " + repair.report.summary();
}

std::vector<double> Mending::toOrigin(std::vector<double> values) const {
    values.resize(repair.givenVertexCount());
    for (const auto& [vertex, into] : repair.report.mergedVertices) {
        values[vertex] = values[into];
    }
    return values;
}

void checkMending(const MendingOptions& options) {
    if (options.strict && options.weld > 0.0) {
        throw InputError(
            InputErrorCode::BadOption,
            "the options strict and weld exclude each other: one takes a mesh as it is, the other "
            "joins its vertices; choose one"
        );
    }
}

Mending mend(RefusedMesh& refused) {
    if (!canBeMended(refused.code())) {
        throw errorOf(refused);
    }
    return {.repair = repairMesh(refused.takeMesh()), .refusal = errorOf(refused)};
}

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#include "projection/curve_trace.h"

#include "surface/surface_point.h"

#include <algorithm>
#include <type_traits>

namespace bspline_curve {
namespace {

// A point that a cell or a face holds has coordinates in [0, 1] up to its tolerance.
Vec3 clamped(Vec3 barycentric) {
    barycentric = barycentric.cwiseMax(0.0);
    return barycentric / barycentric.sum();
}

int faceOf(const CellTrace::Piece& piece) {
    return piece.face;
}

int faceOf(const FibreTrace::Piece& piece) {
    return piece.foot.face;
}

int faceOf(const SheetTrace::Piece& piece) {
    return piece.face;
}

}  // namespace

SurfacePoint onSurface(const ExtendedSurface& extended, int face, const Vec3& barycentric) {
    const Vec3 shadow = clamped(barycentric);
    if (face < extended.surfaceFaceCount) {
        return {face, shadow};
    }
    int inner = face;
    while (inner >= extended.surfaceFaceCount) {
        inner = extended.faceNeighbours[inner][2];
    }
    SurfacePoint point{inner, Vec3::Zero()};
    for (int corner = 0; corner < 3; ++corner) {
        const int vertex = extended.surfaceVertex(extended.faces[face][corner]);
        point.barycentric[cornerOf(extended.faces[inner], vertex)] += shadow[corner];
    }
    return point;
}

const TraceProgress& progressOf(const CurveTrace& trace) {
    return std::visit([](const auto& kind) -> const TraceProgress& { return kind; }, trace);
}

int faceAt(const CurveTrace& trace, double t) {
    return std::visit(
        [&](const auto& kind) {
            using Piece = std::decay_t<decltype(kind.pieces)>::value_type;
            const auto found = std::ranges::lower_bound(kind.pieces, t, {}, &Piece::end);
            return faceOf(found == kind.pieces.end() ? kind.pieces.back() : *found);
        },
        trace
    );
}

std::vector<int> facesPassed(const CurveTrace& trace) {
    std::vector<int> faces;
    std::visit(
        [&](const auto& kind) {
            for (const auto& piece : kind.pieces) {
                const int face = faceOf(piece);
                if (faces.empty() || faces.back() != face) {
                    faces.push_back(face);
                }
            }
        },
        trace
    );
    return faces;
}

}  // namespace bspline_curve

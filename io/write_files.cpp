// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/atomic_file.h"
#include "bspline_curve/files.h"

namespace bspline_curve {

void writeBytes(const std::filesystem::path& file, std::string_view bytes) {
    AtomicFile(file, bytes).commit();
}

void writeMesh(
    const std::filesystem::path& file, const TriangleMesh& mesh, const MeshAttributes& attributes
) {
    writeBytes(file, meshBytes(file, mesh, attributes));
}

void writeCurve(
    const std::filesystem::path& file,
    const Curve& curve,
    std::span<const double> field,
    const std::optional<MeshChecksum>& mesh,
    LengthUnit unit
) {
    writeBytes(file, curveBytes(file, curve, field, mesh, unit));
}

void writeCurves(
    const std::filesystem::path& file,
    std::span<const Curve* const> curves,
    const std::optional<MeshChecksum>& mesh,
    LengthUnit unit
) {
    writeBytes(file, curvesBytes(file, curves, mesh, unit));
}

}  // namespace bspline_curve

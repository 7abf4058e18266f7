// SPDX-License-Identifier: GPL-3.0-or-later
// draw_to_step MESH PICKS OUT.step: a closed curve through picks, for CAD.
#include <bspline_curve/files.h>
#include <bspline_curve/workpiece.h>

#include <cstdio>

using namespace bspline_curve;

int main(int argc, char** argv) {
    try {
        if (argc != 4) {
            return 2;
        }
        const Workpiece workpiece(readMesh(argv[1]));  // a mesh with defects is mended
        for (const std::string& note : workpiece.notes()) {
            std::printf("note: %s\n", note.c_str());
        }
        SolverOptions options;
        options.closed = true;
        const Curve curve = workpiece.draw(readPicks(argv[2]).picks, options).curve;
        writeCurve(argv[3], curve, {}, workpiece.checksum(), LengthUnit::Millimetre);
        std::printf(
            "usable %d, length %g, %zu control points\n",
            static_cast<int>(curve.report.usable),
            lengthOf(curve.polyline),
            curve.spline.controlPoints.size()
        );
    } catch (const InputError& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}

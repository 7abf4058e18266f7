// SPDX-License-Identifier: GPL-3.0-or-later
// pattern MESH DRAWING.svg X Y Z OUT.obj: a drawing on a mesh, round a point.
#include <bspline_curve/files.h>
#include <bspline_curve/pattern.h>
#include <bspline_curve/workpiece.h>

#include <cstdio>
#include <cstdlib>

using namespace bspline_curve;

int main(int argc, char** argv) {
    try {
        if (argc != 7) {
            return 2;
        }
        const Workpiece workpiece(readMesh(argv[1]));
        const Drawing drawing = readDrawing(argv[2]).drawing;  // or textOutlines("text", font)
        const Vec3 near(std::atof(argv[3]), std::atof(argv[4]), std::atof(argv[5]));
        const Vec3 centre = workpiece.closestPoint(near).position;
        const Pattern pattern = patternRoundPoint(workpiece, drawing, centre);
        std::vector<const Curve*> curves;
        for (const PatternCurve& piece : pattern.curves) {
            curves.push_back(&piece.curve);
        }
        writeCurves(argv[6], curves, workpiece.checksum());
        std::printf(
            "%zu curves, lengths from %g to %g times those drawn\n",
            curves.size(),
            pattern.shortest.ratio,
            pattern.longest.ratio
        );
    } catch (const InputError& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}

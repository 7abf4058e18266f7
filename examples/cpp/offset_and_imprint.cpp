// SPDX-License-Identifier: GPL-3.0-or-later
// offset_and_imprint MESH PICKS DISTANCE OUT.ply: a band of constant width round a closed curve as
// parts of the mesh.
#include <bspline_curve/files.h>
#include <bspline_curve/offset.h>
#include <bspline_curve/parts.h>
#include <bspline_curve/workpiece.h>

#include <cstdio>
#include <cstdlib>

using namespace bspline_curve;

int main(int argc, char** argv) {
    try {
        if (argc != 5) {
            return 2;
        }
        const Workpiece workpiece(readMesh(argv[1]));
        SolverOptions options;
        options.closed = true;
        const Curve curve = workpiece.draw(readPicks(argv[2]).picks, options).curve;

        OffsetOptions offset;
        offset.distance = std::atof(argv[3]);
        const OffsetLines beside = linesBeside(workpiece, {&curve.polyline, 1}, offset);
        std::vector<SurfacePolyline> lines;
        for (const OffsetLines::Piece& piece : beside.pieces) {
            lines.push_back(piece.line.line);
        }
        const MadeMesh made = wholeMesh(imprintOn(workpiece, lines));
        writeMesh(argv[4], made.mesh(), {.faceLabels = made.labels()});
        std::printf("%zu lines\n", lines.size());
    } catch (const InputError& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}

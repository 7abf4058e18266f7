// SPDX-License-Identifier: GPL-3.0-or-later
// cut_and_fill MESH PICKS OUT.ply: cuts off what a closed curve surrounds, and closes the hole.
#include <bspline_curve/files.h>
#include <bspline_curve/parts.h>
#include <bspline_curve/workpiece.h>

#include <cstdio>

using namespace bspline_curve;

int main(int argc, char** argv) {
    try {
        if (argc != 4) {
            return 2;
        }
        const Workpiece workpiece(readMesh(argv[1]));
        SolverOptions options;
        options.closed = true;
        const Curve curve = workpiece.draw(readPicks(argv[2]).picks, options).curve;
        const Imprint imprint = imprintOn(workpiece, {&curve.polyline, 1});

        CutChoice choice;
        choice.keep = PartChoice{.which = PartChoice::Which::Largest};
        choice.fill = FillShape::Smooth;
        const CutMeshes cut = cutOn(imprint, choice);
        const MadeMesh& made = cut.pieces.front().mesh;
        writeMesh(argv[3], made.mesh(), {.faceLabels = made.labels()});
        std::printf("%d holes filled, %zu faces\n", cut.filledHoles, made.mesh().faces.size());
    } catch (const InputError& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}

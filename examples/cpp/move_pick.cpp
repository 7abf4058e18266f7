// SPDX-License-Identifier: GPL-3.0-or-later
// move_pick MESH PICKS: moves the second pick by a mean edge length, as while somebody drags it.
#include <bspline_curve/files.h>
#include <bspline_curve/workpiece.h>

#include <cstdio>

using namespace bspline_curve;

int main(int argc, char** argv) {
    try {
        if (argc != 3) {
            return 2;
        }
        const Workpiece workpiece(readMesh(argv[1]));
        std::vector<Vec3> picks = readPicks(argv[2]).picks;
        SolverOptions options;
        options.closed = true;
        const Curve before = workpiece.draw(picks, options).curve;

        const Vec3 moved = picks.at(1) + Vec3(workpiece.meanEdgeLength(), 0.0, 0.0);
        picks[1] = workpiece.closestPoint(moved).position;
        CurveInputs inputs;
        inputs.start = &before;  // a curve from there takes less time than one from scratch
        const Curve after = workpiece.draw(picks, options, {}, inputs).curve;
        std::printf(
            "usable %d, length %g before, %g after\n",
            static_cast<int>(after.report.usable),
            lengthOf(before.polyline),
            lengthOf(after.polyline)
        );
    } catch (const InputError& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}

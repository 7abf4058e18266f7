// SPDX-License-Identifier: GPL-3.0-or-later
// fit_boundary MESH OUT.json: smooth curves along the jagged line between two labels of faces.
#include <bspline_curve/files.h>
#include <bspline_curve/lines.h>
#include <bspline_curve/workpiece.h>

#include <cstdio>

using namespace bspline_curve;

int main(int argc, char** argv) {
    try {
        if (argc != 3) {
            return 2;
        }
        const Workpiece workpiece(readMesh(argv[1]));
        const TriangleMesh& mesh = workpiece.mesh();
        double height = 0.0;
        for (const Vec3& vertex : mesh.vertices) {
            height += vertex.z() / static_cast<double>(mesh.vertices.size());
        }
        std::vector<int> labels;  // here: whether a face is above the mean height
        for (const Triangle& face : mesh.faces) {
            labels.push_back(mesh.vertices[face[0]].z() > height ? 1 : 0);
        }
        const FittedLines fitted = fitLines(workpiece, linesBetween(mesh, labels));
        std::vector<const Curve*> curves;
        for (const DesignedCurve& drawn : fitted.curves) {
            curves.push_back(&drawn.curve);
            std::printf("deviation %g\n", drawn.curve.report.lineDistance.value_or(0.0));
        }
        writeCurves(argv[2], curves, workpiece.checksum());
    } catch (const InputError& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}

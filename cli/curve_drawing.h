// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "cli/curve_options.h"
#include "cli/prepared_mesh.h"
#include "cli/progress_bar.h"
#include "io/report_writer.h"
#include "surface/region.h"

#include <string>
#include <vector>

// Drawing a curve through the picks of a file, for every verb that takes --picks.
namespace bspline_curve::cli {

// Shares of the progress of a curve: up to the end of preparing the mesh, and of the field.
inline constexpr double kShellShare = 0.6;
inline constexpr double kFieldShare = 0.7;

/// What a curve is drawn by, besides the mesh.
struct Inputs {
    std::vector<Vec3> picks;
    std::vector<double> quality;  ///< of the mesh as given, then as mended
    std::vector<std::string> notes;
};

/// Refuses words for --field and --avoid that are neither one of their words nor files.
void checkDrawingFiles(const CurveArguments& arguments);

/// Sets arguments.solver.closed as well where the picks file asks for it.
[[nodiscard]] std::vector<Vec3> picksFor(CurveArguments& arguments);

/// Makes of a field that nobody chose the quality of the mesh, or none.
[[nodiscard]] Inputs inputsFor(
    CurveArguments& arguments, const LoadedMesh& loaded, std::vector<Vec3> picks
);

/// Makes of inputs of the mesh as given those of the mended one; null: it is as given.
void carryOver(Inputs& inputs, const MeshRepair* repair);

struct Drawn {
    std::vector<double> field;
    Region avoid;
    Curve curve;
    RunFigures figures;
};

/// The first curve, and the times of all that led to it. Throws InputError, Cancelled.
[[nodiscard]] Drawn drawCold(
    const CurveArguments& arguments,
    const Inputs& inputs,
    const PreparedMesh& prepared,
    ProgressBar& bar
);

}  // namespace bspline_curve::cli

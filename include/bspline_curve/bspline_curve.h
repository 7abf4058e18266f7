// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// All of the library. Begin with Workpiece in workpiece.h; docs/CPP.md tells the rest.
#include "bspline_curve/curve.h"
#include "bspline_curve/curve_options.h"
#include "bspline_curve/drawing_builder.h"
#include "bspline_curve/drawing_session.h"
#include "bspline_curve/error.h"
#include "bspline_curve/field.h"
#include "bspline_curve/imprint.h"
#include "bspline_curve/lines.h"
#include "bspline_curve/mesh.h"
#include "bspline_curve/mesh_checksum.h"
#include "bspline_curve/offset.h"
#include "bspline_curve/options.h"
#include "bspline_curve/parts.h"
#include "bspline_curve/pattern.h"
#include "bspline_curve/pieces.h"
#include "bspline_curve/progress.h"
#include "bspline_curve/repair.h"
#include "bspline_curve/report.h"
#include "bspline_curve/shell.h"
#include "bspline_curve/sketch.h"
#include "bspline_curve/spline.h"
#include "bspline_curve/tangent.h"
#include "bspline_curve/version.h"
#include "bspline_curve/workpiece.h"
#if __has_include("bspline_curve/files.h")  // not where the library was built without files
#include "bspline_curve/atomic_file.h"
#include "bspline_curve/files.h"
#include "bspline_curve/whole_shell.h"
#endif

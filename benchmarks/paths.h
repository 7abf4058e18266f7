// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "benchmarks/scene.h"

#include <functional>
#include <string>
#include <vector>

namespace bspline_curve::benchmarks {

/// A step of drawing a curve that is worth measuring alone.
struct MeasuredPath {
    std::string name;
    std::string item;  ///< what there are several of in one run
    int items = 1;
    std::function<void()> run;  ///< the same every time
};

/// All of them, on a scene, which they refer to.
[[nodiscard]] std::vector<MeasuredPath> measuredPaths(const Scene& scene);

}  // namespace bspline_curve::benchmarks

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "painted_scene.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace bspline_curve::test_support {

constexpr double kClear = 3.0;  // contrast

struct NamedLook {
    std::string name;
    Look look;
};

/// What meshes look like in tests whose pictures are kept.
const std::vector<NamedLook>& someLooks();
/// With these all greys in steps, and a few strong colours.
std::vector<NamedLook> allLooks();

const std::vector<Vec3>& arcOnPlate();

/// Contrasts along a line, of what is painted within 4 pixels to what it covers.
struct Contrasts {
    double least = 21.0, most = 1.0;

    void add(double found);
};

class APaintedSketch : public testing::Test {
protected:
    void SetUp() override;

    /// Not near handles, which are larger.
    static Contrasts along(PaintedScene& scene, const std::vector<Vec3>& points);
    /// Of the handles of the active curve, whose rims lie farther out.
    static double leastOfHandles(PaintedScene& scene);
    static bool isAtHandle(PaintedScene& scene, const Vec3& point, double within = 16.0);
    static const SketchCurve& curve(PaintedScene& scene, int c = 0);

    OffscreenContext context_{kWidth, kHeight};
};

}  // namespace bspline_curve::test_support

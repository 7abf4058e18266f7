// SPDX-License-Identifier: GPL-3.0-or-later
#include "painted_sketch.h"

#include <algorithm>

namespace bspline_curve::test_support {

const std::vector<NamedLook>& someLooks() {
    static const std::vector<NamedLook> looks = {
        {"white", {{255, 255, 255}, {}}},
        {"black", {{0, 0, 0}, {}}},
        {"red", {{225, 60, 30}, {}}},
        {"grey", {{128, 128, 128}, {}}},
        {"light-grey", {{192, 192, 192}, {}}},
        {"terracotta", {{190, 100, 70}, {}}},
        {"checker", {{0, 0, 0}, {255, 255, 255}, true}},
        {"red-and-white", {{225, 60, 30}, {255, 255, 255}, true}},
    };
    return looks;
}

std::vector<NamedLook> allLooks() {
    std::vector<NamedLook> looks = someLooks();
    const auto add = [&](const SketchColour& c) {
        const std::string name =
            std::to_string(c.red) + " " + std::to_string(c.green) + " " + std::to_string(c.blue);
        looks.push_back({name, {c, {}}});
    };
    for (int grey = 15; grey < 255; grey += 15) {
        const auto value = static_cast<std::uint8_t>(grey);
        add({value, value, value});
    }
    add({255, 0, 0});
    add({0, 255, 0});
    add({0, 0, 255});
    add({255, 255, 0});
    add({255, 128, 0});
    add({150, 90, 200});
    return looks;
}

const std::vector<Vec3>& arcOnPlate() {
    static const std::vector<Vec3> arc = {
        {0.15, 0.35, 0}, {0.35, 0.62, 0}, {0.5, 0.5, 0}, {0.65, 0.38, 0}, {0.8, 0.6, 0}
    };
    return arc;
}

void Contrasts::add(double found) {
    least = std::min(least, found);
    most = std::max(most, found);
}

void APaintedSketch::SetUp() {
    if (!context_.isThere()) {
        GTEST_SKIP() << "no OpenGL without a display (Debian: libegl1 libgl1-mesa-dri)";
    }
}

Contrasts APaintedSketch::along(PaintedScene& scene, const std::vector<Vec3>& points) {
    const Pixels without = scene.withoutSketch();
    const Pixels with = scene.withSketch();
    Contrasts contrasts;
    for (const Vec3& p : points) {
        if (!isAtHandle(scene, p)) {
            contrasts.add(contrastNear(with, without, scene.pixelOf(p)));
        }
    }
    return contrasts;
}

double APaintedSketch::leastOfHandles(PaintedScene& scene) {
    const Pixels without = scene.withoutSketch();
    const Pixels with = scene.withSketch();
    Contrasts contrasts;
    for (const Vec3& p : scene.session().sketch().activeCurve()->positions()) {
        contrasts.add(contrastNear(with, without, scene.pixelOf(p), 7.0));
    }
    return contrasts.least;
}

bool APaintedSketch::isAtHandle(PaintedScene& scene, const Vec3& point, double within) {
    const SketchCurve* const active = scene.session().sketch().activeCurve();
    return active != nullptr && std::ranges::any_of(active->picks, [&](const SketchPick& pick) {
               return (scene.pixelOf(pick.position) - scene.pixelOf(point)).norm() < within;
           });
}

const SketchCurve& APaintedSketch::curve(PaintedScene& scene, int c) {
    return *scene.session().sketch().curves.at(c);
}

}  // namespace bspline_curve::test_support

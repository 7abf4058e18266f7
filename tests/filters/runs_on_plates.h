// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/error.h"
#include "filters/run_filters.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

// The filters on a square plate, and what they answer.
namespace bspline_curve::test_support {

inline const std::vector<Vec3> kPicks = {{0.1, 0.15, 0.0}, {0.5, 0.8, 0.0}, {0.9, 0.2, 0.0}};

inline LayerInput plateLayer() {
    LayerInput layer;
    layer.label = "plate";
    layer.mesh = plate(8, 8);
    return layer;
}

template <class Value>
Value figure(const Figures& figures, const std::string& name) {
    for (const Figure& candidate : figures) {
        if (candidate.name == name) {
            return std::get<Value>(candidate.value);
        }
    }
    throw std::logic_error("no figure " + name);
}

inline CurveResult draw(
    const LayerInput& layer, const CurveRequest& request, WorkpieceCache& designers
) {
    return runCurveFilter(layer, {.tool = kPicks, .layer = {}}, request, designers);
}

inline CurveResult draw(const LayerInput& layer, const CurveRequest& request) {
    WorkpieceCache designers;
    return draw(layer, request, designers);
}

/// What the filter says when it refuses.
template <class Run>
std::string refusal(const Run& run) {
    try {
        static_cast<void>(run());
    } catch (const InputError& error) {
        return error.what();
    }
    return "it was accepted";
}

inline void expectPart(const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text << "\nis without: " << part;
}

}  // namespace bspline_curve::test_support

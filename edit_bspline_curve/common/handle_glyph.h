// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "edit_bspline_curve/common/screen_batch.h"

namespace bspline_curve {

struct HandleState {
    bool isBad = false, isHovered = false, isSelected = false;
    bool isCorner = false;

    [[nodiscard]] bool isSpecial() const { return isBad || isHovered || isSelected; }
};

/// A disc with a dark and a light rim. States differ by colour and by shape: what is selected has a
/// ring around it, what is hovered is larger, what is bad has a cross behind it, a corner lies in a
/// square.
void addHandle(ScreenBatch& batch, const ScreenNode& place, const HandleState& state, double ratio);

/// The handle of a pick's direction: a smaller disc at the end of a line from it.
void addDirection(
    ScreenBatch& batch, const ScreenNode& pick, const ScreenNode& end, bool isHovered, double ratio
);

/// The number of a pick beside its handle. `direction`: where, unit length.
void addHandleNumber(
    ScreenBatch& batch,
    const ScreenNode& place,
    const HandleState& state,
    const Eigen::Vector2d& direction,
    int number,
    double ratio
);

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"

#include <string>
#include <string_view>

namespace bspline_curve {

/// The text of a DXF file as it grows: pairs of a group code and a value, a line each.
class DxfText {
public:
    void add(int code, std::string_view value);
    void add(int code, int value);
    /// With a decimal point or an exponent, as reals are written; nothing is rounded.
    void add(int code, double value);
    /// A point: x under `code`, y under code + 10, z under code + 20.
    void add(int code, const Vec3& point);

    /// Many pairs, one a line: "0 SECTION\n2 HEADER\n". A code without a value has an empty one.
    void addPairs(std::string_view lines);

    [[nodiscard]] const std::string& text() const { return text_; }

private:
    std::string text_;
};

}  // namespace bspline_curve

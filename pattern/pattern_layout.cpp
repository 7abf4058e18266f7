// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/pattern_layout.h"

#include "bspline_curve/error.h"
#include "text/error_messages.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace bspline_curve {

namespace {

using Vec2 = Eigen::Vector2d;

/// What is longer than the curve by less than this, relative to its length, fits: rounding.
constexpr double kFitRelative = 1e-9;
/// Copies of one drawing, at most: what a mistaken spacing asks for is refused.
constexpr double kMostCopies = 100000.0;

[[noreturn]] void refuse(const std::string& message) {
    throw InputError(InputErrorCode::BadOption, message);
}

void checkLength(double value, const char* name) {
    if (!std::isfinite(value) || value < 0.0) {
        refuse(std::string(name) + " must be a number >= 0");
    }
}

Eigen::AlignedBox2d boxOf(const Drawing& drawing) {
    const Eigen::AlignedBox2d box = drawing.box();
    if (box.isEmpty() || !(box.sizes().maxCoeff() > 0.0)) {
        throw InputError(
            InputErrorCode::BadOption, "the drawing has no path that is longer than 0"
        );
    }
    return box;
}

/// Units of the surface for one of the drawing.
double factorOf(const DrawingScale& scale, double extent, double otherwise) {
    if (scale.scale > 0.0) {
        return scale.scale;
    }
    return (scale.size > 0.0 ? scale.size : otherwise) / extent;
}

/// How many copies there are, and how far they are apart.
struct Row {
    int count = 1;
    double step = 0.0;
};

int countFor(double copies) {
    if (copies > kMostCopies) {
        refuse("spacing asks for more than 100000 copies; give a larger one");
    }
    return std::max(1, static_cast<int>(copies));
}

Row rowOf(const RowLayout& layout, double width, double length, bool closed) {
    const double room = length - layout.start - width;
    Row row{.count = std::max(layout.repeat, 1), .step = layout.spacing};
    if (closed) {
        if (layout.repeat == 0 && layout.spacing > 0.0) {
            row.count = countFor(std::round(length / layout.spacing));
        }
        row.step = length / row.count;
    } else if (layout.repeat == 0 && layout.spacing > 0.0) {
        row.count = countFor(std::floor(room / layout.spacing * (1.0 + kFitRelative)) + 1.0);
    } else if (layout.spacing == 0.0 && row.count > 1) {
        row.step = room / (row.count - 1);
    }
    return row;
}

/// The width of a copy that touches the next.
double touchingWidth(const RowLayout& layout, double length, bool closed) {
    if (!closed && layout.spacing > 0.0) {
        return layout.spacing;
    }
    if (closed) {
        return rowOf(layout, 0.0, length, closed).step;
    }
    return (length - layout.start) / std::max(layout.repeat, 1);
}

}  // namespace

void DrawingScale::validate() const {
    checkLength(size, "size");
    checkLength(scale, "scale");
    if (size > 0.0 && scale > 0.0) {
        refuse("the options size and scale exclude each other; give one of them");
    }
}

void RowLayout::validate() const {
    scale.validate();
    checkLength(spacing, "spacing");
    checkLength(start, "start");
    if (repeat < 0 || repeat > static_cast<int>(kMostCopies)) {
        refuse("repeat must be in [0, 100000]");
    }
    if (!std::isfinite(shift)) {
        refuse("shift must be a number");
    }
}

Drawing laidRoundPoint(const Drawing& drawing, const DrawingScale& scale, double diagonal) {
    scale.validate();
    const Eigen::AlignedBox2d box = boxOf(drawing);
    const double factor = factorOf(scale, box.sizes().maxCoeff(), kDrawingSizeRelative * diagonal);
    Eigen::Affine2d map = Eigen::Affine2d::Identity();
    map.scale(factor).translate(-box.center());
    return mapped(drawing, map);
}

Drawing laidAlongCurve(
    const Drawing& drawing, const RowLayout& layout, double length, bool closed
) {
    layout.validate();
    const Eigen::AlignedBox2d box = boxOf(drawing);
    double factor = factorOf(layout.scale, box.sizes().maxCoeff(), 0.0);
    if (factor == 0.0) {
        if (!(box.sizes().x() > 0.0)) {
            refuse(
                "the drawing has no width that could fill the curve; give one of the options size "
                "and scale"
            );
        }
        factor = touchingWidth(layout, length, closed) / box.sizes().x();
    }
    const double width = factor * box.sizes().x();
    const Row row = rowOf(layout, width, length, closed);
    const double needed = closed ? width : layout.start + width + row.step * (row.count - 1);
    if (needed > length * (1.0 + kFitRelative) || row.step < 0.0) {
        refuse(
            "the drawing is longer than the curve: it needs " + describeNumber(needed) + " of " +
            describeNumber(length) + "; give a smaller size, fewer copies or another start"
        );
    }
    const Drawing scaled = mapped(
        drawing,
        Eigen::Affine2d(Eigen::Scaling(factor)) *
            Eigen::Translation2d(-box.min().x(), -drawing.baseline.value_or(box.center().y()))
    );
    Drawing result;
    for (int copy = 0; copy < row.count; ++copy) {
        const Eigen::Translation2d move(layout.start + copy * row.step, layout.shift);
        for (DrawingPath& path : mapped(scaled, Eigen::Affine2d(move)).paths) {
            path.copy = copy;
            result.paths.push_back(std::move(path));
        }
    }
    return result;
}

}  // namespace bspline_curve

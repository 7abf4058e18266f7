// SPDX-License-Identifier: GPL-3.0-or-later
// Path data and transforms of SVG (SVG 2, Sect. 9.3 and 9.5; CSS Transforms 1).
#include "bspline_curve/error.h"
#include "bspline_curve/files.h"
#include "io/drawing_formats.h"
#include "io/number_scanner.h"
#include "pattern/drawing.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

namespace bspline_curve {

namespace {

using Vec2 = Eigen::Vector2d;

constexpr double kPi = std::numbers::pi;

double angleOf(const Vec2& v) {
    return std::atan2(v.y(), v.x());
}

/// What the command A tells of an arc.
struct EllipseWords {
    Vec2 radii;
    double rotation;  // radians
    bool isLarge, isPositive;
};

/// Centre and angles from end points (SVG 2, Sect. B.2.4): in a frame in which the ellipse is the
/// unit circle.
std::vector<DrawingArc> arcBetween(const Vec2& from, const Vec2& to, const EllipseWords& words) {
    const Eigen::Matrix2d turned = Eigen::Rotation2Dd(words.rotation).toRotationMatrix();
    Vec2 radii = words.radii;
    const auto flat = [&](const Vec2& v) {
        return Vec2((turned.transpose() * v).cwiseQuotient(radii));
    };
    const double half = 0.5 * flat(to - from).norm();
    if (half > 1.0) {
        radii *= half;  // too small to reach
    }
    const Vec2 chord = flat(to - from);
    const double toCentre = std::sqrt(std::max(1.0 - 0.25 * chord.squaredNorm(), 0.0));
    const Vec2 across = Vec2(-chord.y(), chord.x()).normalized();
    const double side = words.isLarge == words.isPositive ? -1.0 : 1.0;
    const Vec2 centre = flat(from) + 0.5 * chord + side * toCentre * across;
    const double start = angleOf(flat(from) - centre);
    double sweep = angleOf(flat(to) - centre) - start;
    if (words.isPositive && sweep < 0.0) {
        sweep += 2 * kPi;
    } else if (!words.isPositive && sweep > 0.0) {
        sweep -= 2 * kPi;
    }
    std::vector<DrawingArc> arcs = ellipticalArc(
        turned * centre.cwiseProduct(radii),
        turned.col(0) * radii.x(),
        turned.col(1) * radii.y(),
        start,
        sweep
    );
    arcs.back().points.back() = to;
    return arcs;
}

/// Reads path data with a pen.
class PathReader {
public:
    PathReader(std::string_view data, DrawingBuilder& pen) : scanner_(data), pen_(pen) {}

    void read() {
        scanner_.skipBlanks();
        if (!scanner_.atEnd() && scanner_.peek() != 'M' && scanner_.peek() != 'm') {
            scanner_.refuse("path data do not begin with M");
        }
        while (!scanner_.atEnd()) {
            readCommand();
            scanner_.skipBlanks();
        }
    }

private:
    void readCommand() {
        const char command = scanner_.take();
        kind_ = static_cast<char>(command & ~0x20);  // in upper case
        isRelative_ = command != kind_;
        if (std::string_view("MLHVCSQTAZ").find(kind_) == std::string_view::npos) {
            scanner_.refuse(std::string("\"") + command + "\" is no command of path data, before");
        }
        if (kind_ == 'Z') {
            pen_.close();
            last_ = 'Z';
            return;
        }
        do {
            readOne();
            last_ = kind_;
            kind_ = kind_ == 'M' ? 'L' : kind_;
        } while (scanner_.hasNumber());
    }

    Vec2 readPoint() {
        const double x = scanner_.number();
        const Vec2 point(x, scanner_.number());
        return isRelative_ ? Vec2(pen_.pen() + point) : point;
    }

    /// The control point after the pen's place that continues the curve before smoothly.
    [[nodiscard]] Vec2 reflected(std::string_view kinds) const {
        return kinds.find(last_) == std::string_view::npos ? pen_.pen()
                                                           : Vec2(2.0 * pen_.pen() - control_);
    }

    void readOne() {
        switch (kind_) {
            case 'M':
                pen_.moveTo(readPoint());
                break;
            case 'L':
                pen_.lineTo(readPoint());
                break;
            case 'H':
            case 'V':
                readAlongAxis(kind_ == 'H' ? 0 : 1);
                break;
            case 'A':
                readArc();
                break;
            default:
                readCurve();
        }
    }

    void readAlongAxis(int axis) {
        Vec2 to = pen_.pen();
        to[axis] = (isRelative_ ? to[axis] : 0.0) + scanner_.number();
        pen_.lineTo(to);
    }

    void readCurve() {
        std::vector<Vec2> points;
        if (kind_ == 'S') {
            points.push_back(reflected("CS"));
        } else if (kind_ == 'T') {
            points.push_back(reflected("QT"));
        } else {
            points.push_back(readPoint());
        }
        if (kind_ == 'C' || kind_ == 'S') {
            points.push_back(readPoint());
        }
        control_ = points.back();
        points.push_back(readPoint());
        pen_.curveTo(points);
    }

    void readArc() {
        const double rx = scanner_.number();
        const double ry = scanner_.number();
        EllipseWords words{
            .radii = {std::abs(rx), std::abs(ry)},
            .rotation = scanner_.number() * kPi / 180.0,
            .isLarge = scanner_.flag(),
            .isPositive = false
        };
        words.isPositive = scanner_.flag();
        const Vec2 to = readPoint();
        if (words.radii.minCoeff() == 0.0) {
            pen_.lineTo(to);
        } else if (to != pen_.pen()) {
            pen_.follow(arcBetween(pen_.pen(), to, words));
        }
    }

    NumberScanner scanner_;
    DrawingBuilder& pen_;
    char kind_ = 'M';
    char last_ = '\0';
    bool isRelative_ = false;
    Vec2 control_ = Vec2::Zero();  // the last one of the curve before
};

Eigen::Affine2d transformOf(
    std::string_view name, const std::vector<double>& values, const NumberScanner& scanner
) {
    const std::size_t count = values.size();
    Eigen::Affine2d map = Eigen::Affine2d::Identity();
    if (name == "matrix" && count == 6) {
        map.matrix().topRows<2>() << values[0], values[2], values[4], values[1], values[3],
            values[5];
    } else if (name == "translate" && (count == 1 || count == 2)) {
        map.translate(Vec2(values[0], count == 2 ? values[1] : 0.0));
    } else if (name == "scale" && (count == 1 || count == 2)) {
        map.scale(Vec2(values[0], values.back()));
    } else if (name == "rotate" && (count == 1 || count == 3)) {
        const Vec2 centre = count == 3 ? Vec2(values[1], values[2]) : Vec2(Vec2::Zero());
        map.translate(centre).rotate(values[0] * kPi / 180.0).translate(-centre);
    } else if (name == "skewX" && count == 1) {
        map.matrix()(0, 1) = std::tan(values[0] * kPi / 180.0);
    } else if (name == "skewY" && count == 1) {
        map.matrix()(1, 0) = std::tan(values[0] * kPi / 180.0);
    } else {
        scanner.refuse(
            "there is no transform \"" + std::string(name) + "\" of " + std::to_string(count) +
            " numbers"
        );
    }
    return map;
}

}  // namespace

void drawSvgPath(std::string_view data, DrawingBuilder& pen) {
    PathReader(data, pen).read();
}

Drawing drawingOfSvgPath(std::string_view data) {
    DrawingBuilder pen;
    try {
        drawSvgPath(data, pen);
    } catch (const std::invalid_argument& error) {
        throw InputError(InputErrorCode::BadOption, std::string("the path data: ") + error.what());
    }
    return mapped(pen.take(), Eigen::Affine2d(Eigen::Scaling(1.0, -1.0)));
}

Eigen::Affine2d svgTransform(std::string_view text) {
    NumberScanner scanner(text);
    Eigen::Affine2d map = Eigen::Affine2d::Identity();
    scanner.skipSeparators();
    while (!scanner.atEnd()) {
        const std::string_view name = scanner.word();
        scanner.skipBlanks();
        if (scanner.peek() != '(') {
            scanner.refuse("a transform has no (");
        }
        scanner.take();
        std::vector<double> values;
        while (scanner.hasNumber()) {
            values.push_back(scanner.number());
        }
        scanner.skipBlanks();
        if (scanner.peek() != ')') {
            scanner.refuse("a transform has no )");
        }
        scanner.take();
        map = map * transformOf(name, values, scanner);
        scanner.skipSeparators();
    }
    return map;
}

}  // namespace bspline_curve

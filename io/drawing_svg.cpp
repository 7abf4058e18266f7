// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes of SVG files (SVG 2, Sect. 5, 8 to 10) as paths.
#include "bspline_curve/error.h"
#include "io/drawing_formats.h"
#include "io/left_out.h"
#include "io/number_scanner.h"
#include "io/svg_style.h"
#include "io/xml_tree.h"
#include "text/text_parsing.h"

#include <algorithm>
#include <array>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

namespace bspline_curve {

namespace {

using Element = XmlElement;
using Vec2 = Eigen::Vector2d;

constexpr double kMillimetresPerInch = 25.4;
constexpr double kPixelsPerInch = 96.0;
/// Uses of elements that use elements, at most.
constexpr std::size_t kMostUses = 32;

/// Elements whose children are drawn.
constexpr std::array<std::string_view, 5> kGroups{"g", "a", "svg", "switch", "symbol"};
/// Elements that would show something, but have no paths.
constexpr std::array<std::string_view, 3> kSvgLeftOut{"text", "image", "foreignObject"};

std::string_view attributeOf(const Element& element, const char* name) {
    return trimmed(element.attribute(name));
}

struct Unit {
    std::string_view name;
    double pixels;
};

constexpr std::array kUnits{
    Unit{.name = "mm", .pixels = kPixelsPerInch / kMillimetresPerInch},
    Unit{.name = "cm", .pixels = 10.0 * kPixelsPerInch / kMillimetresPerInch},
    Unit{.name = "in", .pixels = kPixelsPerInch},
    Unit{.name = "pt", .pixels = kPixelsPerInch / 72.0},
    Unit{.name = "pc", .pixels = kPixelsPerInch / 6.0},
    Unit{.name = "q", .pixels = 0.25 * kPixelsPerInch / kMillimetresPerInch},
};

/// A number with its unit, if it has one.
struct Length {
    double number;
    std::string unit;  // in lower case

    /// None where the unit is not a physical one.
    [[nodiscard]] std::optional<double> physicalPixels() const {
        const auto* const found = std::ranges::find(kUnits, unit, &Unit::name);
        return found == kUnits.end() ? std::nullopt : std::optional(number * found->pixels);
    }
};

Length lengthOfText(std::string_view text) {
    NumberScanner scanner(text);
    const double number = scanner.number();
    if (scanner.peek() == '%') {
        return {number, "%"};
    }
    return {number, lowerCase(scanner.word())};
}

/// Where shapes are drawn: the map to the file's unit, and the width and height of percentages.
struct Viewport {
    Eigen::Affine2d map;
    Vec2 size;
    bool isVisible = true;
};

struct ViewBox {
    Vec2 corner, size;
};

std::optional<ViewBox> viewBoxOf(const Element& element) {
    const std::string_view text = attributeOf(element, "viewBox");
    if (text.empty()) {
        return std::nullopt;
    }
    NumberScanner scanner(text);
    std::array<double, 4> values{};
    for (double& value : values) {
        value = scanner.number();
    }
    if (values[2] <= 0.0 || values[3] <= 0.0) {
        throw std::invalid_argument("width and height of viewBox must be > 0");
    }
    return ViewBox{.corner = {values[0], values[1]}, .size = {values[2], values[3]}};
}

class SvgReader {
public:
    SvgReader(const std::filesystem::path& file, const Element& root)
        : file_(file), styles_(root), broken_(file) {
        collectIds(root);
    }

    DrawingFile read(const Element& root) {
        keepingOthers(root, [&] { drawChildren(root, rootViewport(root)); });
        if (paths_.empty() && !broken_.empty()) {
            broken_.refuse();
        }
        DrawingFile result;
        for (std::size_t i = 0; i < paths_.size(); ++i) {
            paths_[i].number = static_cast<int>(i);
        }
        result.drawing.paths = std::move(paths_);
        if (drawnWhole_ > 0) {
            result.notes.push_back(
                file_.filename().string() + ": " + std::to_string(drawnWhole_) +
                (drawnWhole_ == 1 ? " clip path or mask is" : " clip paths or masks are") +
                " not applied; cut the paths in your drawing program"
            );
        }
        if (!broken_.empty()) {
            result.notes.push_back(broken_.note("element", "elements"));
        }
        for (const auto& [name, count] : leftOut_) {
            result.notes.push_back(
                file_.filename().string() + ": " + std::to_string(count) + " <" + name +
                "> left out; turn text into paths in your drawing program"
            );
        }
        return result;
    }

private:
    /// Leaves an element out where it goes wrong.
    template <class Work>
    void keepingOthers(const Element& element, const Work& work) {
        try {
            work();
        } catch (const std::invalid_argument& error) {
            broken_.add(element.line, "<" + element.name + ">: " + error.what());
        }
    }

    /// Counts what elements that use others bring.
    void count(std::size_t parts) {
        used_ += open_.empty() ? 0 : parts;
        if (used_ > kMostPaths || paths_.size() > kMostPaths) {
            refuseFile(
                file_,
                "its elements come to more than " + std::to_string(kMostPaths) +
                    " with those that they use; save what you need to a file of its own"
            );
        }
    }

    void collectIds(const Element& element) {
        if (const std::string_view id = attributeOf(element, "id"); !id.empty()) {
            ids_.emplace(id, &element);
        }
        for (const Element& child : element.children) {
            collectIds(child);
        }
    }

    /// A length in user units; percentages are of `whole`.
    [[nodiscard]] static double lengthOf(
        const Element& element, const char* name, double whole, double otherwise = 0.0
    ) {
        const std::string_view text = attributeOf(element, name);
        if (text.empty() || text == "auto") {
            return otherwise;
        }
        const Length length = lengthOfText(text);
        if (length.unit == "%") {
            return 0.01 * length.number * whole;
        }
        if (length.unit.empty() || length.unit == "px") {
            return length.number;
        }
        const std::optional<double> pixels = length.physicalPixels();
        if (!pixels) {
            throw std::invalid_argument(
                std::string(name) + " has the unit " + inQuotes(length.unit) +
                ", which is not known here"
            );
        }
        return *pixels;
    }

    /// Millimetres where the file has a physical width, else user units as they are.
    [[nodiscard]] static Viewport rootViewport(const Element& root) {
        const std::optional<ViewBox> box = viewBoxOf(root);
        Viewport viewport{
            .map = Eigen::Affine2d::Identity(), .size = box ? box->size : Vec2(Vec2::Zero())
        };
        const std::string_view width = attributeOf(root, "width");
        if (const auto pixels =
                width.empty() ? std::optional<double>() : lengthOfText(width).physicalPixels()) {
            const double millimetres = *pixels * kMillimetresPerInch / kPixelsPerInch;
            viewport.map.scale(
                box ? millimetres / box->size.x() : kMillimetresPerInch / kPixelsPerInch
            );
        }
        if (!box) {
            viewport.size = {lengthOf(root, "width", 0.0), lengthOf(root, "height", 0.0)};
        }
        return viewport;
    }

    /// Units of angles and lengths that transforms of CSS have, and those of SVG have not.
    static std::string withoutUnits(std::string_view text) {
        std::string plain(text);
        for (const std::string_view unit : {"deg", "px"}) {
            for (std::size_t at = plain.find(unit); at != std::string::npos;
                 at = plain.find(unit)) {
                plain.erase(at, unit.size());
            }
        }
        return plain;
    }

    void drawChildren(const Element& element, const Viewport& viewport) {
        for (const Element& child : element.children) {
            draw(child, viewport);
        }
    }

    /// The first child of a <switch> that asks for no extension or language.
    void drawFirst(const Element& element, const Viewport& viewport) {
        for (const Element& child : element.children) {
            if (attributeOf(child, "requiredExtensions").empty() &&
                attributeOf(child, "systemLanguage").empty()) {
                draw(child, viewport);
                return;
            }
        }
    }

    void draw(const Element& element, Viewport viewport) {
        const std::string& name = element.name;
        if (styles_.valueOf(element, "display") == "none") {
            return;
        }
        const std::string_view visibility = styles_.valueOf(element, "visibility");
        viewport.isVisible = visibility.empty() || visibility == "inherit"
                                 ? viewport.isVisible
                                 : visibility == "visible";
        for (const char* const cut : {"clip-path", "mask"}) {
            const std::string_view value = styles_.valueOf(element, cut);
            drawnWhole_ += value.empty() || value == "none" ? 0 : 1;
        }
        if (std::ranges::find(kSvgLeftOut, name) != kSvgLeftOut.end()) {
            ++leftOut_[name];
            return;
        }
        count(1);
        keepingOthers(element, [&] {
            viewport.map =
                viewport.map * svgTransform(withoutUnits(styles_.valueOf(element, "transform")));
            if (name == "use") {
                drawUsed(element, viewport);
            } else if (name == "svg") {
                drawChildren(element, innerViewport(element, viewport));
            } else if (name == "switch") {
                drawFirst(element, viewport);
            } else if (name != "symbol" && std::ranges::find(kGroups, name) != kGroups.end()) {
                drawChildren(element, viewport);
            } else {
                drawShape(element, name, viewport);
            }
        });
    }

    [[nodiscard]] static Vec2 sizeOf(
        const Element& element, const Vec2& outer, const Vec2& otherwise
    ) {
        return {
            lengthOf(element, "width", outer.x(), otherwise.x()),
            lengthOf(element, "height", outer.y(), otherwise.y())
        };
    }

    /// Of an <svg> inside another.
    [[nodiscard]] static Viewport innerViewport(const Element& element, const Viewport& outer) {
        return fittedViewport(element, outer, sizeOf(element, outer.size, outer.size));
    }

    [[nodiscard]] static Viewport fittedViewport(
        const Element& element, const Viewport& outer, const Vec2& size
    ) {
        Viewport inner = outer;
        inner.size = size;
        inner.map.translate(
            Vec2(lengthOf(element, "x", outer.size.x()), lengthOf(element, "y", outer.size.y()))
        );
        if (const std::optional<ViewBox> box = viewBoxOf(element)) {
            if (inner.size.minCoeff() > 0.0) {
                // In the middle, as large as fits.
                const double scale = inner.size.cwiseQuotient(box->size).minCoeff();
                inner.map.translate(Vec2(0.5 * (inner.size - scale * box->size))).scale(scale);
            }
            inner.map.translate(-box->corner);
            inner.size = box->size;
        }
        return inner;
    }

    void drawUsed(const Element& element, Viewport viewport) {
        std::string_view reference = attributeOf(element, "href");
        if (reference.empty()) {
            reference = attributeOf(element, "xlink:href");
        }
        const auto found = reference.starts_with('#') ? ids_.find(reference.substr(1)) : ids_.end();
        if (found == ids_.end()) {
            throw std::invalid_argument(
                "there is no element " + inQuotes(reference) + " in this file"
            );
        }
        if (open_.size() >= kMostUses || !open_.insert(found->second).second) {
            throw std::invalid_argument("elements use each other without end");
        }
        viewport.map.translate(Vec2(
            lengthOf(element, "x", viewport.size.x()), lengthOf(element, "y", viewport.size.y())
        ));
        const Element& used = *found->second;
        keepingOthers(used, [&] {
            if (used.name == "symbol") {
                // A symbol's size is that of its <use>, if that has one.
                const Vec2 own = sizeOf(used, viewport.size, viewport.size);
                const Vec2 size = sizeOf(element, viewport.size, own);
                drawChildren(used, fittedViewport(used, viewport, size));
            } else {
                draw(used, viewport);
            }
        });
        open_.erase(&used);
    }

    void drawShape(const Element& element, std::string_view name, const Viewport& viewport) {
        if (!viewport.isVisible) {
            return;
        }
        DrawingBuilder pen;
        const auto length = [&](const char* attribute, int axis) {
            return lengthOf(element, attribute, viewport.size[axis]);
        };
        if (name == "path") {
            drawSvgPath(attributeOf(element, "d"), pen);
        } else if (name == "line") {
            pen.moveTo({length("x1", 0), length("y1", 1)});
            pen.lineTo({length("x2", 0), length("y2", 1)});
        } else if (name == "polyline" || name == "polygon") {
            drawPoints(attributeOf(element, "points"), pen);
            if (name == "polygon") {
                pen.close();
            }
        } else if (name == "circle") {
            const double radius = length("r", 0);
            drawEllipse({length("cx", 0), length("cy", 1)}, {radius, radius}, pen);
        } else if (name == "ellipse") {
            drawEllipse(
                {length("cx", 0), length("cy", 1)}, {length("rx", 0), length("ry", 1)}, pen
            );
        } else if (name == "rect") {
            drawRectangle(element, viewport, pen);
        }
        add(pen.take(), viewport.map);
    }

    static void drawPoints(std::string_view text, DrawingBuilder& pen) {
        NumberScanner scanner(text);
        bool isFirst = true;
        while (scanner.hasNumber()) {
            const double x = scanner.number();
            const Vec2 point(x, scanner.number());
            if (std::exchange(isFirst, false)) {
                pen.moveTo(point);
            } else {
                pen.lineTo(point);
            }
        }
        scanner.skipBlanks();
        if (!scanner.atEnd()) {
            scanner.refuse("points are no numbers");
        }
    }

    static void drawEllipse(const Vec2& centre, const Vec2& radii, DrawingBuilder& pen) {
        if (radii.minCoeff() < 0.0) {
            throw std::invalid_argument("a radius is below 0");
        }
        if (radii.minCoeff() == 0.0) {
            return;
        }
        pen.moveTo(centre + Vec2(radii.x(), 0.0));
        pen.follow(ellipticalArc(
            centre, Vec2(radii.x(), 0.0), Vec2(0.0, radii.y()), 0.0, 2 * std::numbers::pi
        ));
        pen.close();
    }

    static void drawRectangle(
        const Element& element, const Viewport& viewport, DrawingBuilder& pen
    ) {
        const Vec2 whole = viewport.size;
        const Vec2 corner(lengthOf(element, "x", whole.x()), lengthOf(element, "y", whole.y()));
        const Vec2 size(
            lengthOf(element, "width", whole.x()), lengthOf(element, "height", whole.y())
        );
        if (size.minCoeff() < 0.0) {
            throw std::invalid_argument("width or height is below 0");
        }
        if (size.minCoeff() == 0.0) {
            return;
        }
        constexpr double kNone = -1.0;
        double rx = lengthOf(element, "rx", whole.x(), kNone);
        double ry = lengthOf(element, "ry", whole.y(), kNone);
        rx = rx < 0.0 ? std::max(ry, 0.0) : rx;
        ry = ry < 0.0 ? rx : ry;
        const Vec2 radii(std::min(rx, 0.5 * size.x()), std::min(ry, 0.5 * size.y()));
        pen.moveTo(corner + Vec2(radii.x(), 0.0));
        for (int k = 0; k < 4; ++k) {
            // The corner k of the rectangle, from its top right on; its arc begins before it.
            const Vec2 share(k < 2 ? 1.0 : 0.0, k == 1 || k == 2 ? 1.0 : 0.0);
            const Vec2 inwards = Vec2::Ones() - 2.0 * share;
            const Vec2 centre = corner + share.cwiseProduct(size) + inwards.cwiseProduct(radii);
            const double from = (k - 1) * std::numbers::pi / 2;
            const std::vector<DrawingArc> arcs = ellipticalArc(
                centre, Vec2(radii.x(), 0.0), Vec2(0.0, radii.y()), from, std::numbers::pi / 2
            );
            pen.lineTo(arcs.front().points.front());
            if (radii.minCoeff() > 0.0) {
                pen.follow(arcs);
            }
        }
        pen.close();
    }

    /// Adds what was drawn in the coordinates of an element, y downwards.
    void add(Drawing&& drawn, const Eigen::Affine2d& map) {
        const Eigen::Affine2d upwards = Eigen::Scaling(1.0, -1.0) * map;
        for (DrawingPath& path : mapped(std::move(drawn), upwards).paths) {
            if (!isUsablePath(path)) {
                throw std::invalid_argument("its numbers are too large");
            }
            count(path.arcs.size());
            paths_.push_back(std::move(path));
        }
    }

    const std::filesystem::path& file_;
    std::map<std::string, const Element*, std::less<>> ids_;
    std::vector<DrawingPath> paths_;
    std::map<std::string, int> leftOut_;
    SvgStyles styles_;
    int drawnWhole_ = 0;  // elements whose clip path or mask is not applied
    LeftOut broken_;
    std::set<const Element*> open_;  // that are being drawn because others use them
    std::size_t used_ = 0;
};

}  // namespace

DrawingFile drawingOfSvg(const std::filesystem::path& file, const XmlElement& root) {
    if (root.name != "svg") {
        refuseFile(file, "is not SVG (no <svg>)");
    }
    return SvgReader(file, root).read(root);
}

}  // namespace bspline_curve

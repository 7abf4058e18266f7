// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings of files, as paths.
#include "bspline_curve/files.h"
#include "pattern/drawing.h"
#include "temporary_files.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace bspline_curve::io_tests {

namespace {

using Vec2 = Eigen::Vector2d;

constexpr double kPi = std::numbers::pi;

class Drawings : public FileTest {
protected:
    /// The drawing of an SVG file with these elements; y is upwards in it.
    [[nodiscard]] Drawing svg(const std::string& body, const std::string& root = "") const {
        return readDrawing(write("a.svg", "<svg " + root + ">" + body + "</svg>")).drawing;
    }

    [[nodiscard]] Drawing path(const std::string& data) const {
        return svg("<path d='" + data + "'/>");
    }

    [[nodiscard]] std::string refusedSvg(const std::string& body) const {
        return refusal([&] { return svg(body); });
    }
};

/// Start, then the end of each arc.
std::vector<Vec2> joints(const DrawingPath& path) {
    std::vector<Vec2> points{path.arcs.front().points.front()};
    for (const DrawingArc& arc : path.arcs) {
        points.push_back(arc.points.back());
    }
    return points;
}

void expectNear(const std::vector<Vec2>& points, const std::vector<Vec2>& expected) {
    ASSERT_EQ(points.size(), expected.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_LT((points[i] - expected[i]).norm(), 1e-9)
            << i << ": " << points[i].transpose() << ", not " << expected[i].transpose();
    }
}

void expectJoints(const DrawingPath& path, const std::vector<Vec2>& expected) {
    expectNear(joints(path), expected);
}

TEST_F(Drawings, LinesOfPathsAreAbsoluteAndRelative) {
    const Drawing drawing = path("M1 2L3,4h-2v1l1-.5.5.25 H0 V-1z m1 1 2 2");
    ASSERT_EQ(drawing.paths.size(), 2U);
    expectJoints(
        drawing.paths[0],
        {{1, -2}, {3, -4}, {1, -4}, {1, -5}, {2, -4.5}, {2.5, -4.75}, {0, -4.75}, {0, 1}, {1, -2}}
    );
    EXPECT_TRUE(drawing.paths[0].closed);
    expectJoints(drawing.paths[1], {{2, -3}, {4, -5}});
    EXPECT_FALSE(drawing.paths[1].closed);
    EXPECT_EQ(drawing.paths[1].number, 1);
}

TEST_F(Drawings, CurvesOfPathsHaveTheirControlPoints) {
    const Drawing drawing = path("M0 0C1 1 2 1 3 0s2-1 3 0Q7 1 8 0t2 0T12 0");
    ASSERT_EQ(drawing.paths.size(), 1U);
    const std::vector<DrawingArc>& arcs = drawing.paths[0].arcs;
    ASSERT_EQ(arcs.size(), 5U);
    expectNear(arcs[0].points, {{0, 0}, {1, -1}, {2, -1}, {3, 0}});
    expectNear(arcs[1].points, {{3, 0}, {4, 1}, {5, 1}, {6, 0}});
    expectNear(arcs[2].points, {{6, 0}, {7, -1}, {8, 0}});
    expectNear(arcs[3].points, {{8, 0}, {9, 1}, {10, 0}});
    expectNear(arcs[4].points, {{10, 0}, {11, -1}, {12, 0}});
}

TEST_F(Drawings, SmoothCommandsWithoutACurveBeforeBeginAtThePen) {
    const Drawing drawing = path("M1 1S2 2 3 1M5 5T6 6");
    expectNear(drawing.paths[0].arcs[0].points, {{1, -1}, {1, -1}, {2, -2}, {3, -1}});
    expectNear(drawing.paths[1].arcs[0].points, {{5, -5}, {5, -5}, {6, -6}});
}

TEST_F(Drawings, ArcsOfPathsAreEllipses) {
    for (const std::string flags : {"0 0", "0 1", "1 0", "1 1"}) {
        SCOPED_TRACE(flags);
        // Compact flags, as editors write them.
        const std::string compact = flags.substr(0, 1) + flags.substr(2);
        const Drawing drawing = path("M2 1a3 2 30 " + compact + "1 1.5");
        const DrawingPath& arc = drawing.paths.front();
        EXPECT_LT((joints(arc).back() - Vec2(3, -2.5)).norm(), 1e-12);
        // All points are on one ellipse of these radii, and its turn is as the flags say.
        double turn = 0.0;
        const Vec2 right(std::cos(kPi / 6), -std::sin(kPi / 6));
        const Vec2 up(right.y(), -right.x());
        const auto flat = [&](const Vec2& p) { return Vec2(p.dot(right) / 3, p.dot(up) / 2); };
        std::vector<Vec2> points;
        for (const DrawingArc& each : arc.arcs) {
            for (int i = 0; i <= 8; ++i) {
                points.push_back(flat(each.at(i / 8.0)));
            }
        }
        const Vec2 first = points.front();
        const Vec2 last = points.back();
        const Vec2 middle = points[points.size() / 2];
        // The centre of the circle through three points.
        Eigen::Matrix2d rows;
        rows << (middle - first).transpose(), (last - first).transpose();
        const Vec2 centre = rows.inverse() * Vec2(
                                                 0.5 * (middle.squaredNorm() - first.squaredNorm()),
                                                 0.5 * (last.squaredNorm() - first.squaredNorm())
                                             );
        for (std::size_t i = 0; i < points.size(); ++i) {
            EXPECT_NEAR((points[i] - centre).norm(), 1.0, 1e-9);
            if (i > 0) {
                const Vec2 a = points[i - 1] - centre;
                const Vec2 b = points[i] - centre;
                turn += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
            }
        }
        EXPECT_EQ(std::abs(turn) > kPi, flags[0] == '1');
        EXPECT_EQ(turn > 0.0, flags[2] == '1');
    }
}

TEST_F(Drawings, ArcsThatAreTooSmallGrowAndFlatOnesAreLines) {
    const Drawing half = path("M0 0A1 1 0 0 1 4 0");
    const auto box = half.box();
    EXPECT_NEAR(box.sizes().x(), 4.0, 1e-9);
    EXPECT_NEAR(box.sizes().y(), 2.0, 1e-9);
    const Drawing line = path("M0 0A0 5 0 0 1 4 0");
    EXPECT_TRUE(line.paths[0].arcs[0].isLine());
}

TEST_F(Drawings, ShapesAreClosedPaths) {
    const Drawing drawing =
        svg("<circle cx='1' cy='2' r='3'/><ellipse cx='1' cy='2' rx='3' ry='1'/>"
            "<rect x='1' y='2' width='4' height='3'/><rect width='4' height='3' rx='1'/>"
            "<polygon points='0,0 1,0 1,1'/><polyline points='0 0 1 0, 1 1'/>"
            "<line x1='1' y1='1' x2='2' y2='3'/><circle r='0'/><path d=''/>");
    ASSERT_EQ(drawing.paths.size(), 7U);
    for (int i = 0; i < 7; ++i) {
        EXPECT_EQ(drawing.paths[i].closed, i < 5) << i;
    }
    const auto box = [&](int i) { return Drawing{.paths = {drawing.paths[i]}}.box(); };
    expectNear({box(0).min(), box(0).max()}, {{-2, -5}, {4, 1}});
    expectNear({box(1).min(), box(1).max()}, {{-2, -3}, {4, -1}});
    expectJoints(drawing.paths[2], {{1, -2}, {5, -2}, {5, -5}, {1, -5}, {1, -2}});
    expectJoints(
        drawing.paths[3],
        {{1, 0}, {3, 0}, {4, -1}, {4, -2}, {3, -3}, {1, -3}, {0, -2}, {0, -1}, {1, 0}}
    );
    EXPECT_EQ(smoothPieces({.paths = {drawing.paths[3]}}, 0.3).size(), 1U);
    expectJoints(drawing.paths[4], {{0, 0}, {1, 0}, {1, -1}, {0, 0}});
    expectJoints(drawing.paths[6], {{1, -1}, {2, -3}});
}

TEST_F(Drawings, TransformsAreAppliedFromTheInsideOut) {
    const Drawing drawing =
        svg("<g transform='translate(10 20) scale(2)'><path transform='rotate(90)' d='M1 0L2 0'/>"
            "<path transform='matrix(1 2 3 4 5 6)' d='M1 0L0 1'/></g>"
            "<path transform='rotate(180, 1, 1)' d='M0 0L1 0'/>"
            "<path transform='skewX(45)skewY(0)' d='M0 1L1 1'/>");
    expectJoints(drawing.paths[0], {{10, -22}, {10, -24}});
    expectJoints(drawing.paths[1], {{22, -36}, {26, -40}});
    expectJoints(drawing.paths[2], {{2, -2}, {1, -2}});
    expectJoints(drawing.paths[3], {{1, -1}, {2, -1}});
}

TEST_F(Drawings, UsedElementsAreDrawnWhereTheyAreUsed) {
    const Drawing drawing =
        svg("<defs><path id='a' d='M0 0L1 0'/><g id='b'><use href='#a' x='1'/></g>"
            "<symbol id='s' viewBox='0 0 10 10'><path d='M0 0L10 10'/></symbol></defs>"
            "<use xlink:href='#b' transform='scale(2)' y='3'/>"
            "<use href='#s' width='5' height='5'/>"
            "<g display='none'><path d='M0 0L9 9'/></g>"
            "<g style='fill:red; display:none'><path d='M0 0L9 9'/></g>");
    ASSERT_EQ(drawing.paths.size(), 2U);
    expectJoints(drawing.paths[0], {{2, -6}, {4, -6}});
}

TEST_F(Drawings, HaveMillimetresWhereTheirWidthIsAPhysicalOne) {
    const std::string line = "<path d='M0 0L10 0'/>";
    const auto length = [&](const std::string& root) { return svg(line, root).box().sizes().x(); };
    EXPECT_DOUBLE_EQ(length(""), 10.0);
    EXPECT_DOUBLE_EQ(length("viewBox='0 0 100 50'"), 10.0);
    EXPECT_DOUBLE_EQ(length("width='500px' viewBox='0 0 100 50'"), 10.0);
    EXPECT_DOUBLE_EQ(length("width='50mm' viewBox='0 0 100 50'"), 5.0);
    EXPECT_DOUBLE_EQ(length("width='5cm' viewBox='0 0 100 50'"), 5.0);
    EXPECT_DOUBLE_EQ(length("width='2in'"), 10.0 * 25.4 / 96.0);
}

TEST_F(Drawings, PercentagesAreOfTheViewBox) {
    const Drawing drawing =
        svg("<rect x='10%' width='50%' height='2mm'/>", "viewBox='0 0 200 100'");
    const auto box = drawing.box();
    EXPECT_NEAR(box.min().x(), 20.0, 1e-9);
    EXPECT_NEAR(box.sizes().x(), 100.0, 1e-9);
    EXPECT_NEAR(box.sizes().y(), 2.0 * 96.0 / 25.4, 1e-9);
}

TEST_F(Drawings, TextIsLeftOutAndToldOf) {
    const DrawingFile file = readDrawing(
        write("t.svg", "<svg><text>a</text><path d='M0 0L1 1'/><g><text>b</text></g></svg>")
    );
    ASSERT_EQ(file.notes.size(), 1U);
    expectContains(file.notes[0], "2 <text> left out");
    EXPECT_EQ(file.drawing.paths.size(), 1U);
}

TEST_F(Drawings, BadSvgIsRefusedWithItsLine) {
    expectContains(refusedSvg("<text>a</text>"), "no path");
    expectContains(refusedSvg("\n<path d='M0 0L1'/>"), "line 2: <path>: there is no number");
    expectContains(refusedSvg("<path d='L1 1'/>"), "begin with M");
    expectContains(refusedSvg("<path d='M0 0X1 1'/>"), "\"X\" is no command");
    expectContains(refusedSvg("<path d='M0 0A1 1 0 2 0 1 1'/>"), "no flag");
    expectContains(refusedSvg("<path d='M0 0L1e999 1'/>"), "no number");
    expectContains(refusedSvg("<path transform='turn(3)' d='M0 0L1 1'/>"), "no transform \"turn\"");
    expectContains(refusedSvg("<path transform='scale 3' d='M0 0L1 1'/>"), "no (");
    expectContains(refusedSvg("<circle r='-1'/>"), "below 0");
    expectContains(refusedSvg("<rect width='3em' height='1'/>"), "\"em\"");
    expectContains(refusedSvg("<use href='#no'/>"), "no element \"#no\"");
    expectContains(refusedSvg("<g id='a'><use href='#a'/></g>"), "without end");
    expectContains(refusedSvg("<svg viewBox='0 0 0 1'/>"), "viewBox");
    expectContains(refusal([&] { return readDrawing(write("b.svg", "<svg>")); }), "not XML");
    expectContains(refusal([&] { return readDrawing(write("c.svg", "<html/>")); }), "not SVG");
    expectContains(
        refusal([&] { return readDrawing(write("d.png", "x")); }), "read from .svg and .dxf"
    );
}

// ---- DXF ----

class DxfDrawings : public FileTest {
protected:
    /// The file of these pairs, "0 LINE|10 1|…", in the section ENTITIES.
    [[nodiscard]] Drawing dxf(const std::string& entities, const std::string& blocks = "") const {
        std::string pairs;
        if (!blocks.empty()) {
            pairs += "0 SECTION|2 BLOCKS|" + blocks + "|0 ENDSEC|";
        }
        pairs += "0 SECTION|2 ENTITIES|" + entities + "|0 ENDSEC|0 EOF|";
        std::string text;
        for (const char c : pairs) {
            text += c == ' ' || c == '|' ? '\n' : c;
        }
        return readDrawing(write("a.dxf", text)).drawing;
    }

    /// The file as a whole; sections before ENTITIES as they are.
    [[nodiscard]] DrawingFile file(
        const std::string& entities,
        const std::string& before = "",
        const std::vector<std::string>& layers = {}
    ) const {
        std::string text;
        for (const char c : before + "0 SECTION|2 ENTITIES|" + entities + "|0 ENDSEC|0 EOF|") {
            text += c == ' ' || c == '|' ? '\n' : c;
        }
        return readDrawing(write("b.dxf", text), layers);
    }
};

constexpr const char* kLine = "0 LINE|8 1|10 0|20 0|11 1|21 0";
/// Layers that are on, off, and frozen.
constexpr const char* kLayers =
    "0 SECTION|2 TABLES|0 TABLE|2 LAYER|0 LAYER|2 1|70 0|62 7|0 LAYER|2 Off|70 0|62 -7|0 LAYER|"
    "2 Frozen|70 1|62 7|0 ENDTAB|0 ENDSEC|";

std::string onLayer(const std::string& name) {
    return "|0 CIRCLE|8 " + name + "|10 5|20 5|40 1";
}

TEST_F(DxfDrawings, EntitiesThatCannotBeDrawnAreLeftOutWithOneNote) {
    const DrawingFile read = file(
        std::string("0 CIRCLE|8 1|10 0|20 0|40 0|") + kLine +
        "|0 INSERT|2 NONE|0 LINE|10 a|20 0|11 1|21 0|0 ELLIPSE|11 0|21 0|0 LINE|10 1e300|20 0|11 "
        "1|21 0"
    );
    EXPECT_EQ(read.drawing.paths.size(), 1U);
    ASSERT_EQ(read.notes.size(), 1U);
    EXPECT_EQ(
        read.notes[0], "b.dxf: 5 entities left out; the first, line 5: a radius that is not > 0"
    );
}

TEST_F(DxfDrawings, PaperSpaceAndHiddenEntitiesAreLeftOut) {
    const DrawingFile read = file(
        std::string(kLine) + onLayer("off") + onLayer("Frozen") +
            "|0 LINE|8 1|67 1|10 0|20 0|11 297|21 210|0 LINE|8 1|60 1|10 0|20 0|11 9|21 9",
        kLayers
    );
    EXPECT_EQ(read.drawing.paths.size(), 1U);
    ASSERT_EQ(read.notes.size(), 1U);
    expectContains(read.notes[0], "4 entities in paper space, invisible");
    expectContains(
        refusal([&] { return file("0 LINE|67 1|10 0|20 0|11 1|21 0"); }), "all its entities are in"
    );
}

TEST_F(DxfDrawings, LayersAreChosenAndBlocksTakeThatOfTheirInsert) {
    const std::string entities = std::string(kLine) + onLayer("Off");
    const DrawingFile chosen = file(entities, kLayers, {"OFF"});
    ASSERT_EQ(chosen.drawing.paths.size(), 1U);
    EXPECT_TRUE(chosen.drawing.paths[0].closed);
    expectContains(
        refusal([&] { return file(entities, kLayers, {"wall"}); }), "no layer \"wall\" but 1, "
    );
    const std::string blocks =
        std::string(kLayers) +
        "0 SECTION|2 BLOCKS|0 BLOCK|2 B|0 LINE|8 0|10 0|20 0|11 1|21 1|0 LINE|8 1|10 5|20 5|11 6|"
        "21 5|0 ENDBLK|0 ENDSEC|";
    EXPECT_EQ(file("0 INSERT|8 1|2 b", blocks).drawing.paths.size(), 2U);
    EXPECT_EQ(file("0 INSERT|8 0|2 B", blocks, {"1"}).drawing.paths.size(), 1U);
}

TEST_F(DxfDrawings, SplinesOfFitPointsPassThem) {
    // Through points of a circle a periodic cubic is near to it; an open one has straight ends.
    std::string points;
    constexpr int kCount = 12;
    for (int i = 0; i < kCount; ++i) {
        points += "|11 " + std::to_string(std::cos(2 * kPi * i / kCount)) + "|21 " +
                  std::to_string(std::sin(2 * kPi * i / kCount)) + "|31 0";
    }
    const Drawing closed = dxf("0 SPLINE|70 1|71 3" + points);
    ASSERT_EQ(closed.paths.size(), 1U);
    EXPECT_TRUE(closed.paths[0].closed);
    ASSERT_EQ(closed.paths[0].arcs.size(), 12U);
    for (int i = 0; i < kCount; ++i) {
        const DrawingArc& arc = closed.paths[0].arcs[static_cast<std::size_t>(i)];
        EXPECT_NEAR(arc.points.front().x(), std::cos(2 * kPi * i / kCount), 1e-6);
        EXPECT_NEAR(arc.at(0.5).norm(), 1.0, 3e-4);
    }
    const Drawing straight = dxf("0 SPLINE|71 3|11 0|21 0|11 1|21 1|11 3|21 3");
    for (const double t : {0.2, 0.7}) {
        const Vec2 at = straight.paths[0].arcs[1].at(t);
        EXPECT_NEAR(at.x(), at.y(), 1e-12);
    }
    const Drawing tangent = dxf("0 SPLINE|71 3|12 0|22 2|13 0|23 -1|11 0|21 0|11 2|21 0");
    EXPECT_NEAR(tangent.paths[0].arcs[0].startDirection().y(), 1.0, 1e-12);
    EXPECT_NEAR(tangent.paths[0].arcs[0].endDirection().y(), -1.0, 1e-12);
}

TEST_F(DxfDrawings, BlocksThatAskForTooMuchEndSoon) {
    std::string blocks = "0 SECTION|2 BLOCKS|";
    for (int i = 0; i < 20; ++i) {
        const std::string next = std::to_string(i + 1);
        blocks += "0 BLOCK|2 B" + std::to_string(i) + "|0 INSERT|2 B" + next + "|70 1000|71 1000" +
                  "|0 INSERT|2 B" + next + "|0 ENDBLK|";
    }
    blocks += "0 BLOCK|2 B20|0 ENDBLK|0 ENDSEC|";
    const auto start = std::chrono::steady_clock::now();
    expectContains(refusal([&] { return file("0 INSERT|2 B0", blocks); }), "more than 1000000");
    const std::string circle =
        "0 SECTION|2 BLOCKS|0 BLOCK|2 A|0 INSERT|2 B|0 INSERT|2 B|0 ENDBLK|0 BLOCK|2 B|0 INSERT|"
        "2 A|0 INSERT|2 A|0 ENDBLK|0 ENDSEC|";
    const DrawingFile rest = file(std::string("0 INSERT|2 A|") + kLine, circle);
    EXPECT_EQ(rest.drawing.paths.size(), 1U);
    expectContains(rest.notes.at(0), "without end");
    const std::string array = "0 INSERT|2 A|70 500|71 500";  // of what cannot be drawn
    const std::string bad = "0 SECTION|2 BLOCKS|0 BLOCK|2 A|0 LINE|10 x|0 ENDBLK|0 ENDSEC|";
    expectContains(refusal([&] { return file(array, bad); }), "more than 1000000");
    const std::string inner =
        "0 SECTION|2 BLOCKS|0 BLOCK|2 A|0 INSERT|2 B|10 x|0 ENDBLK|0 BLOCK|2 B|0 ENDBLK|0 ENDSEC|";
    expectContains(refusal([&] { return file(array, inner); }), "more than 1000000");
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(60));
}

TEST_F(DxfDrawings, LinesWhoseEndsMeetAreOnePath) {
    const Drawing drawing =
        dxf("0 LINE|10 0|20 0|11 1|21 0|0 LINE|10 1|20 1|11 1|21 0|0 LINE|10 5|20 5|11 6|21 6|"
            "0 ARC|10 0|20 1|40 1|50 0|51 90");
    ASSERT_EQ(drawing.paths.size(), 2U);
    expectJoints(drawing.paths[0], {{0, 0}, {1, 0}, {1, 1}, {0, 2}});
    EXPECT_FALSE(drawing.paths[0].closed);
    expectJoints(drawing.paths[1], {{5, 5}, {6, 6}});
}

TEST_F(DxfDrawings, LinesThatLeadBackAreClosedAndForksStayApart) {
    const std::string triangle =
        "0 LINE|10 0|20 0|11 1|21 0|0 LINE|10 1|20 0|11 0|21 1|0 LINE|10 0|20 0|11 0|21 1";
    const Drawing closed = dxf(triangle);
    ASSERT_EQ(closed.paths.size(), 1U);
    EXPECT_TRUE(closed.paths[0].closed);
    EXPECT_EQ(closed.paths[0].arcs.size(), 3U);
    // With a tail at the corner 0 0 the other two corners still join three lines to one.
    const Drawing forked = dxf(triangle + "|0 LINE|10 0|20 0|11 -1|21 -1");
    ASSERT_EQ(forked.paths.size(), 2U);
    EXPECT_EQ(forked.paths[0].arcs.size(), 3U);
    EXPECT_FALSE(forked.paths[0].closed);
}

TEST_F(DxfDrawings, BulgesAreArcs) {
    const Drawing drawing = dxf("0 LWPOLYLINE|90 2|70 1|10 0|20 0|42 1|10 2|20 0|42 1");
    ASSERT_EQ(drawing.paths.size(), 1U);
    EXPECT_TRUE(drawing.paths[0].closed);
    const auto box = drawing.box();
    expectNear({box.min(), box.max()}, {{0, -1}, {2, 1}});
    const Drawing quarter = dxf("0 LWPOLYLINE|10 1|20 0|42 0.41421356237309503|10 0|20 1");
    for (const double t : {0.2, 0.5, 0.9}) {
        EXPECT_NEAR(quarter.paths[0].arcs[0].at(t).norm(), 1.0, 1e-12);
    }
    const Drawing old = dxf(
        "0 POLYLINE|66 1|70 0|0 VERTEX|10 1|20 0|42 0.41421356237309503|0 VERTEX|10 0|20 1|0 SEQEND"
    );
    EXPECT_NEAR(old.paths[0].arcs[0].at(0.3).norm(), 1.0, 1e-12);
}

TEST_F(DxfDrawings, CirclesAndEllipsesAreClosed) {
    const Drawing drawing =
        dxf("0 CIRCLE|10 1|20 2|40 3|0 ELLIPSE|10 0|20 0|11 2|21 0|40 0.5|"
            "0 ELLIPSE|10 0|20 0|11 0|21 2|40 0.5|41 0|42 1.5707963267948966|"
            "0 CIRCLE|10 1|20 0|40 1|230 -1");
    ASSERT_EQ(drawing.paths.size(), 4U);
    EXPECT_TRUE(drawing.paths[0].closed);
    EXPECT_TRUE(drawing.paths[1].closed);
    const auto box = [&](int i) { return Drawing{.paths = {drawing.paths[i]}}.box(); };
    expectNear({box(0).min(), box(0).max()}, {{-2, -1}, {4, 5}});
    expectNear({box(1).min(), box(1).max()}, {{-2, -1}, {2, 1}});
    expectJoints(drawing.paths[2], {{0, 2}, {-1, 0}});
    expectNear({box(3).min(), box(3).max()}, {{-2, -1}, {0, 1}});  // seen from behind
}

TEST_F(DxfDrawings, SplinesAreTheirArcs) {
    // A quarter of a circle as a rational spline, and a cubic with a knot inside.
    const Drawing drawing =
        dxf("0 SPLINE|70 4|71 2|40 0|40 0|40 0|40 1|40 1|40 1|41 1|41 0.70710678118654757|41 1|"
            "10 1|20 0|10 1|20 1|10 0|20 1|"
            "0 SPLINE|71 3|40 0|40 0|40 0|40 0|40 0.5|40 1|40 1|40 1|40 1|"
            "10 4|20 0|10 5|20 1|10 6|20 0|10 7|20 1|10 8|20 0");
    ASSERT_EQ(drawing.paths.size(), 2U);
    for (const double t : {0.1, 0.5, 0.8}) {
        EXPECT_NEAR(drawing.paths[0].arcs[0].at(t).norm(), 1.0, 1e-12);
    }
    ASSERT_EQ(drawing.paths[1].arcs.size(), 2U);
    expectJoints(drawing.paths[1], {{4, 0}, {6, 0.5}, {8, 0}});
}

TEST_F(DxfDrawings, BlocksAreInserted) {
    const Drawing drawing =
        dxf("0 INSERT|2 B|10 10|20 0|41 2|42 2|50 90",
            "0 BLOCK|2 B|10 1|20 1|0 LINE|10 1|20 1|11 2|21 1|0 ENDBLK");
    ASSERT_EQ(drawing.paths.size(), 1U);
    expectJoints(drawing.paths[0], {{10, 0}, {10, 2}});
}

TEST_F(DxfDrawings, BadFilesAreRefused) {
    const auto refused = [&](const std::string& entities, const std::string& blocks = "") {
        return refusal([&] { return dxf(entities, blocks); });
    };
    expectContains(refused("0 TEXT|1 a"), "no curve; turn text");
    expectContains(refused("0 CIRCLE|40 0"), "radius");
    expectContains(refused("0 LINE|10 a|11 1"), "not a finite number");
    expectContains(refused("0 SPLINE|71 3|10 0|20 0"), "more points");
    expectContains(refused("0 SPLINE|71 1|40 0|40 0|40 1|10 0|20 0|10 1|20 0"), "knots");
    expectContains(refused("0 INSERT|2 B"), "no block \"B\"");
    expectContains(refused("0 INSERT|2 B", "0 BLOCK|2 B|0 INSERT|2 B|0 ENDBLK"), "without end");
    expectContains(refusal([&] { return readDrawing(write("b.dxf", "0\nEOF\n")); }), "ENTITIES");
    expectContains(refusal([&] { return readDrawing(write("c.dxf", "x\n")); }), "no group code");
}

// ---- elements that are left out ----

TEST_F(Drawings, ElementsThatCannotBeDrawnAreLeftOutWithOneNote) {
    const DrawingFile read = readDrawing(write(
        "b.svg",
        "<svg>\n<circle r='-1'/><rect width='1' height='1e308' ry='1' "
        "transform='rotate(30)'/><path d='M0 0L1 1'/><path d='M0 0X'/><use href='#no'/></svg>"
    ));
    EXPECT_EQ(read.drawing.paths.size(), 1U);
    ASSERT_EQ(read.notes.size(), 1U);
    EXPECT_EQ(
        read.notes[0],
        "b.svg: 4 elements left out; the first, line 2: <circle>: a radius is below 0"
    );
}

TEST_F(Drawings, UsesThatAskForTooMuchEndSoon) {
    std::string uses;
    for (int i = 0; i < 25; ++i) {
        const std::string next = "<use href='#a" + std::to_string(i + 1) + "'/>";
        uses += "<g id='a" + std::to_string(i) + "'>" + next + next + next + "</g>";
    }
    const auto start = std::chrono::steady_clock::now();
    expectContains(refusedSvg(uses + "<g id='a25'/>"), "more than 1000000");
    const std::string circle =
        "<g id='a'><use href='#b'/><use href='#b'/></g>"
        "<g id='b'><use href='#a'/><use href='#a'/></g>";
    EXPECT_EQ(svg(circle + "<path d='M0 0L1 1'/>").paths.size(), 1U);
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(60));
}

TEST_F(Drawings, SymbolsHaveTheSizeOfTheirUseAndSwitchesOneChild) {
    const Drawing drawing =
        svg("<symbol id='s' viewBox='0 0 10 10'><circle cx='5' cy='5' r='4'/></symbol>"
            "<use href='#s' x='10' y='10' width='30' height='30'/>"
            "<switch><circle r='1' systemLanguage='de'/><circle r='2'/><circle r='3'/></switch>");
    ASSERT_EQ(drawing.paths.size(), 2U);
    const auto box = [&](int i) { return Drawing{.paths = {drawing.paths[i]}}.box(); };
    expectNear({box(0).min(), box(0).max()}, {{13, -37}, {37, -13}});
    expectNear({box(1).min(), box(1).max()}, {{-2, -2}, {2, 2}});
}

TEST_F(Drawings, StyleSheetsHideAndTransform) {
    const std::string sheet =
        "<style>/* a */ .h, #no {display: none} rect.turned{transform:rotate(90deg)} "
        "circle { visibility : hidden }</style>";
    const Drawing drawing =
        svg(sheet +
            "<path class='a h' d='M0 0L1 1'/><path id='no' d='M0 0L1 1'/>"
            "<path class='h' style='display:inline' d='M0 0L7 0'/>"
            "<rect class='turned' width='3' height='1'/><circle r='1'/>"
            "<g visibility='hidden'><path d='M0 0L1 1'/><path visibility='visible' d='M0 0L9 0'/>"
            "</g><path style='transform:translate(5px,0)' d='M0 0L1 0'/>");
    ASSERT_EQ(drawing.paths.size(), 4U);
    expectJoints(drawing.paths[0], {{0, 0}, {7, 0}});
    const auto box = Drawing{.paths = {drawing.paths[1]}}.box();
    expectNear({box.min(), box.max()}, {{-1, -3}, {0, 0}});
    expectJoints(drawing.paths[2], {{0, 0}, {9, 0}});
    expectJoints(drawing.paths[3], {{5, 0}, {6, 0}});
    const DrawingFile clipped = readDrawing(
        write("c.svg", "<svg><circle r='2' clip-path='url(#c)'/><path d='M0 0L1 1'/></svg>")
    );
    EXPECT_EQ(clipped.drawing.paths.size(), 2U);
    expectContains(clipped.notes.at(0), "1 clip path or mask is not applied");
}

TEST_F(Drawings, SpecksAreNoPieces) {
    // A stadium whose straight sides are rounding, and a corner doubled at 1e-9.
    const Drawing pill =
        svg("<rect x='0.1' y='0.3' width='10' height='0.6000000000000001' ry='0.3'/>");
    EXPECT_EQ(smoothPieces(pill, 0.3).size(), 1U);
    const Drawing square = path("M0 0L1 0L1 1L0.5 1L0.5 1.000000001L0 1Z");
    EXPECT_EQ(smoothPieces(square, 0.3).size(), 4U);
}

// ---- text ----

TEST_F(Drawings, TextIsItsOutlinesOnTheBaseline) {
    const std::filesystem::path font = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
    if (!std::filesystem::exists(font)) {
        GTEST_SKIP() << "no " << font;
    }
    const Drawing drawing = textOutlines("oI \xC3\xA4", font);
    ASSERT_EQ(
        drawing.paths.size(), 2U + 1U + 4U
    );  // a letter a with dots has two contours of its own
    EXPECT_EQ(drawing.baseline, 0.0);
    for (const DrawingPath& path : drawing.paths) {
        EXPECT_TRUE(path.closed);
    }
    const auto letter = Drawing{.paths = {drawing.paths[2]}}.box();
    EXPECT_NEAR(letter.min().y(), 0.0, 1e-3);
    EXPECT_NEAR(letter.max().y(), 0.73, 0.02);  // an I is seven tenths of the em high
    EXPECT_GT(letter.min().x(), Drawing{.paths = {drawing.paths[0]}}.box().max().x());
    const auto refused = [&](std::string_view text, InputErrorCode code) {
        return refusal([&] { return textOutlines(text, font); }, code);
    };
    expectContains(refused("  ", InputErrorCode::BadOption), "blanks");
    expectContains(refused("a\xFF", InputErrorCode::BadOption), "UTF-8");
    expectContains(refused("\xF0\x9F\xA6\x84", InputErrorCode::UnreadableFile), "U+1F984");
    expectContains(
        refusal([&] { return textOutlines("a", write("no.ttf", "no font")); }), "no font file"
    );
}

}  // namespace

}  // namespace bspline_curve::io_tests

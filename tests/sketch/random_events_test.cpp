// SPDX-License-Identifier: GPL-3.0-or-later
// Any events in any order: nothing is lost, undo and redo lead to the same curves, and what the
// mouse reached is reached by keys and by calls as well.
#include "session_fixture.h"
#include "support/many_cases.h"
#include "support/meshes.h"
#include "support/random.h"
#include "workpiece/workpiece_parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <ostream>
#include <string>

namespace bspline_curve {
namespace {

using namespace test_support;

struct Ground {
    std::string name;
    TriangleMesh mesh;
};

std::ostream& operator<<(std::ostream& stream, const Ground& ground) {
    return stream << ground.name;
}

/// Two rays through a point meet the surface at the same place to within this.
constexpr double kSeenTwice = 1e-9;

class RandomEvents : public testing::TestWithParam<Ground> {};

Pointer randomPointer(const SessionFixture& s, Random& random) {
    const std::vector<Vec3>& vertices = s.workpiece->mesh().vertices;
    const auto last = static_cast<int>(vertices.size()) - 1;
    Pointer pointer =
        random.integer(0, 9) == 0
            ? s.camera.off()
            : s.camera.beside(vertices[random.integer(0, last)], random.uniform(0, 30));
    // Half of them where a pick is.
    const Sketch& sketch = s.session.sketch();
    if (!sketch.curves.empty() && random.integer(0, 1) == 0) {
        const auto& picks =
            sketch.curves[random.integer(0, static_cast<int>(sketch.curves.size()) - 1)]->picks;
        pointer = s.camera.beside(
            picks[random.integer(0, static_cast<int>(picks.size()) - 1)].position,
            random.uniform(0, 12)
        );
    }
    pointer.snaps = random.integer(0, 5) == 0;
    pointer.removes = random.integer(0, 3) == 0;
    return pointer;
}

// Renames, shows or hides any curve.
void changeALook(DrawingSession& session, Random& random) {
    session.cancel();  // the list cannot be clicked while a button is held
    const auto count = static_cast<int>(session.sketch().curves.size());
    if (count > 0) {
        const int curve = random.integer(0, count - 1);
        SketchLook look = session.sketch().curves[curve]->look;
        look.name = "curve " + std::to_string(random.integer(0, 9));
        look.isHidden = random.integer(0, 3) == 0;
        session.setLook(curve, look);
    }
}

void expectWhole(const DrawingSession& session) {
    const Sketch& sketch = session.sketch();
    ASSERT_LT(sketch.active, static_cast<int>(sketch.curves.size()));
    for (const std::shared_ptr<SketchCurve>& curve : sketch.curves) {
        ASSERT_FALSE(curve->picks.empty());
        ASSERT_TRUE(!curve->options.solver.closed || curve->picks.size() >= 3);
        static_cast<void>(curve->shownPoints());
    }
    std::vector<std::uint64_t> ids;
    for (const std::shared_ptr<SketchCurve>& curve : sketch.curves) {
        ids.push_back(curve->id);
    }
    std::ranges::sort(ids);
    ASSERT_TRUE(std::ranges::adjacent_find(ids) == ids.end());
    if (sketch.active >= 0) {
        ASSERT_FALSE(sketch.activeCurve()->look.isHidden);
    }
    if (sketch.selected >= 0) {
        ASSERT_GE(sketch.active, 0);
        ASSERT_LT(sketch.selected, static_cast<int>(sketch.activeCurve()->picks.size()));
    }
    ASSERT_LT(session.hovered().curve, static_cast<int>(sketch.curves.size()));
}

// Of the settled curves.
std::vector<std::vector<Vec3>> polylinesOf(const DrawingSession& session) {
    std::vector<std::vector<Vec3>> lines;
    for (const std::shared_ptr<SketchCurve>& curve : session.sketch().curves) {
        lines.push_back(curve->settled ? curve->settled->polyline.points : curve->positions());
    }
    return lines;
}

void expectSame(const Sketch& a, const Sketch& b, double tolerance) {
    ASSERT_EQ(a.curves.size(), b.curves.size());
    for (std::size_t c = 0; c < a.curves.size(); ++c) {
        const std::vector<Vec3> positions = a.curves[c]->positions();
        const std::vector<Vec3> others = b.curves[c]->positions();
        ASSERT_EQ(positions.size(), others.size());
        for (std::size_t i = 0; i < positions.size(); ++i) {
            EXPECT_LE((positions[i] - others[i]).norm(), tolerance);
        }
        EXPECT_EQ(a.curves[c]->options.solver.closed, b.curves[c]->options.solver.closed);
    }
    EXPECT_EQ(a.active, b.active);
    EXPECT_EQ(a.selected, b.selected);
}

void showAll(DrawingSession& session) {
    for (int c = 0; c < static_cast<int>(session.sketch().curves.size()); ++c) {
        SketchLook look = session.sketch().curves[c]->look;
        look.isHidden = false;
        session.setLook(c, look);
    }
}

// The same state by calls.
void reachByCalls(const SessionFixture& s) {
    DrawingSession calls(s.workpiece);
    const Sketch& wanted = s.session.sketch();
    for (const std::shared_ptr<SketchCurve>& curve : wanted.curves) {
        calls.newCurve();
        for (const SketchPick& pick : curve->picks) {
            calls.addPick(pick.point);
        }
        calls.setClosed(curve->options.solver.closed);
        for (int i = 0; i < static_cast<int>(curve->picks.size()); ++i) {
            calls.setCorner(i, curve->picks[i].isCorner);
            if (!curve->picks[i].tangent.isAny()) {
                calls.setTangent(i, curve->picks[i].tangent);
            }
        }
    }
    calls.newCurve();
    if (wanted.active >= 0) {
        calls.select(wanted.active, wanted.selected);
    }
    expectSame(calls.sketch(), wanted, 0.0);
    for (std::size_t c = 0; c < wanted.curves.size(); ++c) {
        EXPECT_EQ(calls.sketch().curves[c]->corners(), wanted.curves[c]->corners());
        EXPECT_EQ(calls.sketch().curves[c]->tangents(), wanted.curves[c]->tangents());
    }
}

// Whether the camera sees the picks of a sketch: those that were snapped may lie on its far side.
bool seesPicks(const SessionFixture& s, const Sketch& sketch) {
    for (const std::shared_ptr<SketchCurve>& curve : sketch.curves) {
        for (const Vec3& position : curve->positions()) {
            const Pointer pointer = s.camera.over(position);
            const TriangleTree::Hit seen =
                designerOf(*s.workpiece).tree().firstHit(pointer.start, pointer.direction);
            if (seen.point.face < 0 || (seen.position - position).norm() > kSeenTwice) {
                return false;
            }
        }
    }
    return true;
}

// A pick at the end of the active curve, wherever there is room for one.
void addSomewhere(SessionFixture& keys, Random& random) {
    const std::vector<Vec3>& vertices = keys.workpiece->mesh().vertices;
    const auto last = static_cast<int>(vertices.size()) - 1;
    while (true) {
        const Pointer pointer = keys.camera.over(vertices[random.integer(0, last)]);
        keys.session.move(pointer);
        if (keys.session.hovered() == SketchHit() && keys.session.key(SketchKey::Add, pointer)) {
            return;
        }
    }
}

// The same state by keys, where the mouse only points.
void reachByKeys(const SessionFixture& s, Random& random) {
    const Sketch& wanted = s.session.sketch();
    SessionFixture keys(s.workpiece->mesh(), Vec3::UnitZ());
    keys.camera = s.camera;
    const auto press = [&](SketchKey key) { keys.session.key(key, s.camera.off()); };
    for (const std::shared_ptr<SketchCurve>& curve : wanted.curves) {
        press(SketchKey::NewCurve);
        for (const Vec3& position : curve->positions()) {
            addSomewhere(keys, random);
            keys.session.key(SketchKey::Move, s.camera.over(position));
        }
        if (curve->options.solver.closed) {
            press(SketchKey::Close);
        }
    }
    if (wanted.active < 0) {
        press(SketchKey::NewCurve);
    } else {
        while (keys.session.sketch().active != wanted.active) {
            press(SketchKey::NextCurve);
        }
        press(SketchKey::Cancel);
        for (int i = 0; i <= wanted.selected; ++i) {
            press(SketchKey::Next);
        }
    }
    expectSame(keys.session.sketch(), wanted, kSeenTwice);
}

// How many, for long runs: BSPLINE_CURVE_SEQUENCES.
int sequenceCount() {
    const char* const asked = std::getenv("BSPLINE_CURVE_SEQUENCES");
    return asked == nullptr ? caseCount(25, 5) : std::stoi(asked);
}

TEST_P(RandomEvents, LoseNothing) {
    constexpr int kEvents = 60;
    const int sequences = sequenceCount();
    int reached = 0;
    for (int seed = 1; seed <= sequences; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        SessionFixture s(
            GetParam().mesh, random.point(-1.0, 1.0), {.handlePixels = seed % 2 == 0 ? 20.0 : 0.0}
        );
        for (int i = 0; i < kEvents; ++i) {
            const Pointer pointer = randomPointer(s, random);
            switch (random.integer(0, 8)) {
                case 0:
                case 1:
                    s.session.press(pointer);
                    break;
                case 2:
                case 3:
                    s.session.move(pointer);
                    break;
                case 4:
                case 5:
                    s.session.release(pointer);
                    break;
                case 6:
                    s.session.key(
                        static_cast<SketchKey>(
                            random.integer(0, static_cast<int>(SketchKey::Cancel))
                        ),
                        pointer
                    );
                    break;
                case 7:
                    changeALook(s.session, random);
                    break;
                default:
                    s.session.update();
            }
            expectWhole(s.session);
        }
        s.session.cancel();
        // The state of the newest entry.
        while (s.session.canRedo()) {
            s.session.redo();
        }
        s.session.settle();
        expectWhole(s.session);
        s.expectAsDrawn();
        const std::vector<std::vector<Vec3>> last = polylinesOf(s.session);
        int undone = 0;
        for (; s.session.canUndo(); ++undone) {
            s.session.undo();
            expectWhole(s.session);
        }
        EXPECT_TRUE(s.session.sketch().curves.empty());
        for (; undone > 0; --undone) {
            s.session.redo();
        }
        s.session.settle();
        EXPECT_EQ(polylinesOf(s.session), last);
        reachByCalls(s);
        showAll(s.session);
        if (seesPicks(s, s.session.sketch())) {
            reachByKeys(s, random);
            ++reached;
        }
    }
    EXPECT_GT(reached, 0);
}

INSTANTIATE_TEST_SUITE_P(
    All,
    RandomEvents,
    testing::Values(
        Ground{"Sphere", withNoise(icosphere(4), 0.003, 7)},
        Ground{"Box", box(10, {1.0, 0.8, 0.6})},
        Ground{"Plate", jitteredPlate(20, 20, 0.2, 5)},
        Ground{"TwoComponents", twoComponents()}
    ),
    [](const auto& testInfo) { return testInfo.param.name; }
);

}  // namespace
}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
// Drawing with a mouse, a pen or fingers: the session of sketch/. Every call answers stateJson().
#include "bspline_curve/files.h"
#include "filters/drawn_curve_file.h"
#include "filters/requests.h"
#include "filters/utf8_path.h"
#include "web/core/calls.h"
#include "web/core/files_in_memory.h"
#include "web/core/session_state.h"

#include <stdexcept>
#include <utility>

namespace bspline_curve::web {

namespace {

constexpr std::uint8_t kOpaque = 255;

std::shared_ptr<Session> of(const Json& arguments) {
    return sessionOf(arguments.at("session").get<int>());
}

SketchCurve sketchCurve(Session& session, const DrawnCurve& drawn) {
    SketchCurve curve;
    curve.look.name = drawn.name;
    if (drawn.colour) {
        curve.look.colour = {(*drawn.colour)[0], (*drawn.colour)[1], (*drawn.colour)[2]};
    }
    curve.picks = drawn.picks;
    curve.options = session.options.toSketch(drawn.options);
    return curve;
}

DrawnCurve drawnCurve(const Session& session, const SketchCurve& curve) {
    const SketchColour& colour = curve.look.colour;
    return {
        .picks = curve.picks,
        .options = session.options.fromSketch(curve.options),
        .name = curve.look.name,
        .colour = CurveColour{colour.red, colour.green, colour.blue, kOpaque}
    };
}

CurveFileSurface fileSurface(const Session& session) {
    const Workpiece& workpiece = *session.mesh->workpiece;
    return {.mesh = workpiece.mesh(), .checksum = workpiece.checksum(), .workpiece = &workpiece};
}

DrawnOptions drawnOptions(const Json& options) {
    return drawnOptionsOf(valuesOfJson(curveFilter(), options));
}

// {"mesh", "options", "radii": {"pick", "curve"}, "handles"}: a session; lengths in pixels.
Json begin(const Json& arguments, Reply& reply) {
    auto mesh = meshOf(arguments.at("mesh").get<int>());
    OptionBook book(mesh->workpiece, mesh->layer);
    SessionSettings settings;
    settings.options = book.toSketch(drawnOptions(arguments.value("options", Json())));
    if (arguments.contains("radii")) {
        settings.radii = {
            arguments["radii"].at("pick").get<double>(),
            arguments["radii"].at("curve").get<double>()
        };
    }
    settings.handlePixels = arguments.value("handles", 0.0);
    std::shared_ptr<const Workpiece> workpiece = mesh->workpiece;
    // NOLINTNEXTLINE(modernize-make-shared): an aggregate of what cannot be moved
    auto session = std::shared_ptr<Session>(new Session{
        .mesh = std::move(mesh),
        .options = std::move(book),
        .drawing = DrawingSession(std::move(workpiece), settings)
    });
    Json json{{"state", stateJson(*session, reply)}};
    json["session"] = keep(std::move(session));
    return json;
}

Pointer pointerOf(const Json& event) {
    Pointer pointer;
    pointer.start = pointOf(event.at("start"));
    pointer.direction = pointOf(event.at("direction")).normalized();
    pointer.pixel = event.at("pixel").get<double>();
    pointer.isOrthographic = event.value("orthographic", false);
    pointer.snaps = event.value("snaps", false);
    pointer.removes = event.value("removes", false);
    pointer.strokes = event.value("strokes", false);
    return pointer;
}

SketchKey keyOf(const std::string& name) {
    static const std::map<std::string, SketchKey> keys{
        {"add", SketchKey::Add},
        {"move", SketchKey::Move},
        {"next", SketchKey::Next},
        {"previous", SketchKey::Previous},
        {"next_curve", SketchKey::NextCurve},
        {"remove", SketchKey::Remove},
        {"close", SketchKey::Close},
        {"new_curve", SketchKey::NewCurve},
        {"kind", SketchKey::Kind},
        {"undo", SketchKey::Undo},
        {"redo", SketchKey::Redo},
        {"cancel", SketchKey::Cancel}
    };
    return keys.at(name);
}

bool carriedOut(DrawingSession& drawing, const Json& event) {
    const auto kind = event.at("event").get<std::string>();
    if (kind == "leave") {
        drawing.leave();
        return true;
    }
    const Pointer pointer = pointerOf(event);
    if (kind == "press") {
        return drawing.press(pointer);
    }
    if (kind == "move") {
        return drawing.move(pointer);
    }
    if (kind == "release") {
        return drawing.release(pointer);
    }
    if (kind == "key") {
        return drawing.key(keyOf(event.at("key").get<std::string>()), pointer);
    }
    throw std::invalid_argument("there is no event " + kind);
}

// {"session", "event": press, move, release, leave or key, "start", "direction", "pixel", …}:
// {"taken", "state"}. What was not taken is the camera's.
Json event(const Json& arguments, Reply& reply) {
    const auto session = of(arguments);
    const bool isTaken = carriedOut(session->drawing, arguments);
    return {{"taken", isTaken}, {"state", stateJson(*session, reply)}};
}

// {"session"}: solves one curve that waits, if there is one; {"changed", "state"}.
Json update(const Json& arguments, Reply& reply) {
    const auto session = of(arguments);
    const bool isChanged = session->drawing.update();
    return {{"changed", isChanged}, {"state", stateJson(*session, reply)}};
}

template <class Change>
Json changed(const Json& arguments, Reply& reply, const Change& change) {
    const auto session = of(arguments);
    change(*session);
    return {{"state", stateJson(*session, reply)}};
}

// {"picks", "corners": some of them, "tangents" and "tangents_before": of each, or of none,
// "options"}.
SketchCurve describedCurve(Session& session, const Json& described) {
    DrawnCurve drawn;
    for (const Vec3& position : pointsOf(described.at("picks"))) {
        const ClosestPoint closest = session.drawing.workpiece().closestPoint(position);
        drawn.picks.push_back({closest.place, closest.position});
    }
    for (const int pick : idsOf(described.at("corners"))) {
        drawn.picks.at(pick).isCorner = true;
    }
    const std::vector<Vec3> after = pointsOf(described.at("tangents"));
    const std::vector<Vec3> before = pointsOf(described.at("tangents_before"));
    for (std::size_t i = 0; i < after.size(); ++i) {
        drawn.picks.at(i).tangent = {before.at(i), after[i]};
    }
    drawn.options = drawnOptions(described.at("options"));
    return sketchCurve(session, drawn);
}

// {"session", "curves": as above}: adds them, as one entry of the history.
Json addCurves(const Json& arguments, Reply& reply) {
    return changed(arguments, reply, [&](Session& session) {
        std::vector<SketchCurve> curves;
        for (const Json& described : arguments.at("curves")) {
            curves.push_back(describedCurve(session, described));
        }
        session.drawing.add(std::move(curves));
    });
}

// {"session", "options", "live"}: of the active curve and of new ones.
Json setOptions(const Json& arguments, Reply& reply) {
    return changed(arguments, reply, [&](Session& session) {
        session.drawing.setOptions(
            session.options.toSketch(drawnOptions(arguments.at("options"))),
            arguments.value("live", false)
        );
    });
}

// {"session", "curve", "name", "colour", "hidden"}.
Json setLook(const Json& arguments, Reply& reply) {
    return changed(arguments, reply, [&](Session& session) {
        const int curve = arguments.at("curve").get<int>();
        SketchLook look = session.drawing.sketch().curves.at(curve)->look;
        look.name = arguments.value("name", look.name);
        look.isHidden = arguments.value("hidden", look.isHidden);
        if (arguments.contains("colour")) {
            const auto colour = arguments["colour"].get<std::array<std::uint8_t, 3>>();
            look.colour = {colour[0], colour[1], colour[2]};
        }
        session.drawing.setLook(curve, std::move(look));
    });
}

// {"session", "colour"}: of new curves.
Json setColour(const Json& arguments, Reply& reply) {
    return changed(arguments, reply, [&](Session& session) {
        const auto colour = arguments.at("colour").get<std::array<std::uint8_t, 3>>();
        session.drawing.setColour({colour[0], colour[1], colour[2]});
    });
}

// {"session", "curve", "pick"}.
Json select(const Json& arguments, Reply& reply) {
    return changed(arguments, reply, [&](Session& session) {
        session.drawing.select(arguments.at("curve").get<int>(), arguments.value("pick", -1));
    });
}

// {"session", "pick": of the active curve, "kind": a PickKind}.
Json setKind(const Json& arguments, Reply& reply) {
    return changed(arguments, reply, [&](Session& session) {
        session.drawing.setKind(
            arguments.at("pick").get<int>(), static_cast<PickKind>(arguments.at("kind").get<int>())
        );
    });
}

Json newCurve(const Json& arguments, Reply& reply) {
    return changed(arguments, reply, [](Session& session) { session.drawing.newCurve(); });
}

// {"session", "curve"}.
Json removeCurve(const Json& arguments, Reply& reply) {
    return changed(arguments, reply, [&](Session& session) {
        session.drawing.removeCurve(arguments.at("curve").get<int>());
    });
}

// {"session", "closed"}.
Json setClosed(const Json& arguments, Reply& reply) {
    return changed(arguments, reply, [&](Session& session) {
        session.drawing.setClosed(arguments.at("closed").get<bool>());
    });
}

Json undo(const Json& arguments, Reply& reply) {
    return changed(arguments, reply, [](Session& session) { session.drawing.undo(); });
}

Json redo(const Json& arguments, Reply& reply) {
    return changed(arguments, reply, [](Session& session) { session.drawing.redo(); });
}

// {"session", "name", "bytes", "first"}: adds the curves of a file; {"notes", "state"}. `first`:
// the history begins with them.
Json openDrawing(const Json& arguments, Reply& reply) {
    const auto session = of(arguments);
    const std::filesystem::path path = utf8Path(arguments.at("name").get<std::string>());
    const FileInMemory file(path, std::string(bytesOf(arguments.at("bytes"))));
    const OpenedCurves opened = openDrawnCurves(path, fileSurface(*session));
    std::vector<SketchCurve> curves;
    for (const DrawnCurve& drawn : opened.curves) {
        curves.push_back(sketchCurve(*session, drawn));
    }
    if (arguments.value("first", false)) {
        session->drawing.begin(std::move(curves));
    } else {
        session->drawing.add(std::move(curves));
    }
    return {{"notes", opened.notes}, {"state", stateJson(*session, reply)}};
}

// {"session", "name"}: {"bytes"} of a drawing, to be gone on with.
Json saveDrawing(const Json& arguments, Reply& reply) {
    const auto session = of(arguments);
    std::vector<CurveToSave> curves;
    for (const std::shared_ptr<SketchCurve>& curve : session->drawing.sketch().curves) {
        curves.push_back({drawnCurve(*session, *curve), curve->settled});
    }
    return {
        {"bytes",
         reply.bytes(drawnCurvesBytes(
             utf8Path(arguments.at("name").get<std::string>()), curves, fileSurface(*session)
         ))}
    };
}

// {"session", "name"}: {"bytes"} of the picks of all curves, for other programs.
Json savePicks(const Json& arguments, Reply& reply) {
    const auto session = of(arguments);
    std::vector<PointsOfCurve> all;
    for (const std::shared_ptr<SketchCurve>& curve : session->drawing.sketch().curves) {
        PointsOfCurve& points = all.emplace_back();
        points.closed = curve->options.solver.closed;
        for (const SketchPick& pick : curve->picks) {
            CurvePoint& point = points.points.emplace_back();
            point.place = pick.point;
            point.position = pick.position;
        }
    }
    const std::filesystem::path file = utf8Path(arguments.at("name").get<std::string>());
    return {{"bytes", reply.bytes(pointsBytes(file, all))}};
}

// {"session", "curve"}: curveJson() of one that is settled, to be used.
Json settledCurve(const Json& arguments, Reply& reply) {
    const auto session = of(arguments);
    const SketchCurve& sketched =
        *session->drawing.sketch().curves.at(arguments.at("curve").get<int>());
    if (!sketched.settled) {
        throw InputError(
            InputErrorCode::TooFewPicks,
            sketched.problem.message.empty() ? "the curve is not finished: add picks"
                                             : sketched.problem.message
        );
    }
    const auto& guides = sketched.options.guides;
    auto made = std::make_shared<DrawnOnMesh>();
    made->mesh = session->mesh;
    made->drawn = session->mesh->workpiece->finished(
        *sketched.settled, guides ? guides->values().field : ScalarField()
    );
    return curveJson(std::move(made), reply);
}

}  // namespace

const Calls& sessionCalls() {
    static const Calls calls{
        {"session.begin", begin},
        {"session.event", event},
        {"session.update", update},
        {"session.add_curves", addCurves},
        {"session.set_options", setOptions},
        {"session.set_look", setLook},
        {"session.set_colour", setColour},
        {"session.select", select},
        {"session.set_kind", setKind},
        {"session.new_curve", newCurve},
        {"session.remove_curve", removeCurve},
        {"session.set_closed", setClosed},
        {"session.undo", undo},
        {"session.redo", redo},
        {"session.open", openDrawing},
        {"session.save", saveDrawing},
        {"session.save_picks", savePicks},
        {"session.curve", settledCurve}
    };
    return calls;
}

}  // namespace bspline_curve::web

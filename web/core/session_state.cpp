// SPDX-License-Identifier: GPL-3.0-or-later
#include "web/core/session_state.h"

#include "web/core/calls.h"

#include <set>
#include <utility>

namespace bspline_curve::web {

namespace {

double lengthOfShown(const std::vector<Vec3>& points, bool isClosed) {
    double length = 0.0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        length += (points[i + 1] - points[i]).norm();
    }
    return isClosed && !points.empty() ? length + (points.front() - points.back()).norm() : length;
}

std::vector<Vec3> positionsOf(const std::vector<SketchPick>& picks) {
    std::vector<Vec3> positions;
    for (const SketchPick& pick : picks) {
        positions.push_back(pick.position);
    }
    return positions;
}

// Of the faces that the picks are on; zero where there is none.
std::vector<Vec3> normalsAt(const TriangleMesh& mesh, const std::vector<SketchPick>& picks) {
    std::vector<Vec3> normals;
    for (const SketchPick& pick : picks) {
        const auto& [a, b, c] = mesh.faces[pick.point.face];
        const Vec3& corner = mesh.vertices[a];
        normals.push_back(
            (mesh.vertices[b] - corner).cross(mesh.vertices[c] - corner).normalized()
        );
    }
    return normals;
}

Json newsOf(const Session& session, const SketchCurve& curve, Reply& reply) {
    const SketchColour& colour = curve.look.colour;
    std::vector<Vec3> points = curve.shownPoints();
    const double length = lengthOfShown(points, curve.options.solver.closed);
    const Workpiece& workpiece = *session.mesh->workpiece;
    std::vector<int> kinds;
    std::vector<Vec3> before, after;
    for (const SketchPick& pick : curve.picks) {
        kinds.push_back(static_cast<int>(kindOf(pick)));
        before.push_back(pick.tangent.before);
        after.push_back(pick.tangent.after);
    }
    Json json{
        {"id", curve.id},
        {"name", curve.look.name},
        {"colour", {colour.red, colour.green, colour.blue}},
        {"hidden", curve.look.isHidden},
        {"options", optionsJson(session.options.fromSketch(curve.options))},
        {"picks", reply.array(curve.positions())},
        {"kinds", reply.array(std::move(kinds))},
        {"tangents", reply.array(std::move(after))},
        {"tangents_before", reply.array(std::move(before))},
        {"normals", reply.array(normalsAt(workpiece.mesh(), curve.picks))},
        {"leeway", curve.options.solver.pickTolerance.in(workpiece.meanEdgeLength())},
        {"points", reply.array(std::move(points))},
        {"length", length},
        {"settled", curve.isSettled()},
        {"usable", curve.settled == nullptr || curve.settled->report.usable},
        {"notes", Json::array()}
    };
    if (curve.settled) {
        json["notes"] = workpiece.finished(*curve.settled, {}).notes;
    }
    if (!curve.problem.message.empty()) {
        json["problem"] = {
            {"message", messageOf(curve.problem.message, curve.problem.remedy)},
            {"picks", curve.problem.picks}
        };
    }
    return json;
}

Json curvesJson(Session& session, Reply& reply) {
    Json curves = Json::array();
    std::set<std::uint64_t> there;
    const Sketch& sketch = session.drawing.sketch();
    for (const std::shared_ptr<SketchCurve>& curve : sketch.curves) {
        there.insert(curve->id);
        Session::Told& told = session.told[curve->id];
        // The active one changes in place while it is dragged.
        const bool isChanging = session.drawing.isDragging() && curve.get() == sketch.activeCurve();
        const bool isKnown = told.curve == curve && told.settled == curve->settled &&
                             told.last == curve->last && !isChanging &&
                             curve->problem.message.empty();
        if (isKnown) {
            curves.push_back({{"id", curve->id}});
        } else {
            curves.push_back(newsOf(session, *curve, reply));
            told = {curve, curve->settled, curve->last};
        }
    }
    std::erase_if(session.told, [&](const auto& told) { return !there.contains(told.first); });
    return curves;
}

}  // namespace

Json optionsJson(const DrawnOptions& options) {
    return {
        {"closed", options.closed},
        {"degree", options.degree},
        {"tension", options.tension},
        {"pick_tolerance", options.pickTolerance},
        {"field", options.field},
        {"field_weight", options.fieldWeight},
        {"avoid", options.avoid},
        {"avoid_threshold", options.avoidThreshold}
    };
}

Json stateJson(Session& session, Reply& reply) {
    const DrawingSession& drawing = session.drawing;
    const Sketch& sketch = drawing.sketch();
    const SketchHit& hovered = drawing.hovered();
    const auto& preview = drawing.preview();
    return {
        {"curves", curvesJson(session, reply)},
        {"active", sketch.active},
        {"selected", sketch.selected},
        {"hovered",
         {{"curve", hovered.curve},
          {"pick", hovered.pick},
          {"after", hovered.after},
          {"handle", hovered.handle}}},
        {"stroke", reply.array(positionsOf(drawing.stroke()))},
        {"dragging", drawing.isDragging()},
        {"can_undo", drawing.canUndo()},
        {"can_redo", drawing.canRedo()},
        {"snapped", nameOf(drawing.snapped().kind)},
        {"preview", preview ? reply.view(preview, preview->polyline.points) : Json()},
        {"is_settled", drawing.isSettled()}
    };
}

}  // namespace bspline_curve::web

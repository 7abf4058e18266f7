// SPDX-License-Identifier: GPL-3.0-or-later
// What is made of curves: imprints, cuts, parts, offsets.
#include "filters/imprint_requests.h"
#include "web/core/calls.h"

#include <utility>

namespace bspline_curve::web {

namespace {

// {"curves", "options"}: {"imprint": number, "parts": [{"area", …}], …}.
Json imprintCurves(const Json& arguments, Reply& reply) {
    const auto curves = curvesOf(arguments.at("curves"));
    const ImprintRequest request =
        imprintRequest(valuesOfJson(imprintFilter(), arguments.value("options", Json())));
    if (curves.empty()) {
        throw InputError(InputErrorCode::NoPath, "there is no curve to imprint");
    }
    std::vector<SurfacePolyline> lines;
    for (const auto& curve : curves) {
        lines.push_back(curve->drawn.curve.polyline);
    }
    auto made = std::make_shared<ImprintOnMesh>();
    made->mesh = curves.front()->mesh;
    made->imprint = imprintOn(*made->mesh->workpiece, lines, request.imprint, hostProgress());
    Json parts = Json::array();
    for (const MeshPart& part : made->imprint.parts.parts) {
        parts.push_back(
            {{"faces", part.faces},
             {"area", part.area},
             {"perimeter", part.perimeter},
             {"centroid", {part.centroid.x(), part.centroid.y(), part.centroid.z()}},
             {"euler", part.euler}}
        );
    }
    const ImprintedMesh& mesh = *made->imprint.mesh;
    Json json{
        {"parts", std::move(parts)},
        {"labels",
         reply.view(std::shared_ptr<const ImprintOnMesh>(made), made->imprint.parts.labels)},
        {"vertices", reply.view(made->imprint.mesh, mesh.mesh.vertices)},
        {"faces", reply.view(made->imprint.mesh, mesh.mesh.faces)},
        {"parents", reply.view(made->imprint.mesh, mesh.parents)},
        {"crossings", reply.view(made->imprint.mesh, mesh.crossings)},
        {"largest_move", mesh.largestMove}
    };
    json["imprint"] = keep(std::shared_ptr<const ImprintOnMesh>(std::move(made)));
    return json;
}

Json pieceJson(const Mesh& of, const MadeMesh& made, Reply& reply) {
    Json json = meshJson(madeMesh(of, made), reply);
    json["labels"] = reply.array(std::vector<int>(made.labels()));
    return json;
}

// {"imprint"}: the whole imprint as a mesh.
Json whole(const Json& arguments, Reply& reply) {
    const auto imprint = imprintOf(arguments.at("imprint").get<int>());
    return pieceJson(*imprint->mesh, wholeMesh(imprint->imprint), reply);
}

Json cutJson(const ImprintOnMesh& of, const CutMeshes& cut, Reply& reply) {
    Json pieces = Json::array();
    for (const CutMeshes::Piece& piece : cut.pieces) {
        Json json = pieceJson(*of.mesh, piece.mesh, reply);
        json["parts"] = piece.parts;
        pieces.push_back(std::move(json));
    }
    return {
        {"pieces", std::move(pieces)},
        {"dropped", cut.dropped},
        {"filled_holes", cut.filledHoles},
        {"notes", cut.notes}
    };
}

// {"imprint", "options"}: {"pieces": [meshes], "dropped", "filled_holes", "notes"}.
Json cut(const Json& arguments, Reply& reply) {
    const auto imprint = imprintOf(arguments.at("imprint").get<int>());
    const CutRequest request =
        cutRequest(valuesOfJson(cutFilter(), arguments.value("options", Json())));
    return cutJson(
        *imprint, cutOn(imprint->imprint, cutChoice(request.words, {}), hostProgress()), reply
    );
}

// The same without opening the mesh: a label for each part.
Json segment(const Json& arguments, Reply& reply) {
    const auto imprint = imprintOf(arguments.at("imprint").get<int>());
    const SegmentRequest request =
        segmentRequest(valuesOfJson(segmentFilter(), arguments.value("options", Json())));
    return cutJson(*imprint, segmentsOf(imprint->imprint, request.split), reply);
}

OffsetSides sidesOf(const Json& arguments) {
    const auto side = arguments.value("side", std::string("both"));
    if (side == "left") {
        return OffsetSides::Left;
    }
    if (side == "right") {
        return OffsetSides::Right;
    }
    if (side != "both") {
        throw InputError(
            InputErrorCode::BadOption, "side is \"" + side + "\", but it is left, right or both"
        );
    }
    return OffsetSides::Both;
}

// {"curve", "distance", "side"}: {"curves"} beside it, the longest first.
Json offset(const Json& arguments, Reply& reply) {
    const auto curve = curveOf(arguments.at("curve").get<int>());
    const OffsetOptions options{
        .distance = arguments.at("distance").get<double>(), .sides = sidesOf(arguments)
    };
    OffsetLines lines = linesBeside(
        *curve->mesh->workpiece, {&curve->drawn.curve.polyline, 1}, options, false, hostProgress()
    );
    if (lines.pieces.empty()) {
        throw InputError(InputErrorCode::NoPath, kNothingBeside);
    }
    Json curves = Json::array();
    for (auto& [fitted, of] : lines.pieces) {
        auto made = std::make_shared<DrawnOnMesh>();
        made->mesh = curve->mesh;
        made->deviation = fitted.deviation;
        made->drawn.curve.polyline = std::move(fitted.line);
        made->drawn.curve.spline = std::move(fitted.spline);
        made->drawn.curve.report.usable = true;
        curves.push_back(curveJson(std::move(made), reply));
    }
    return {{"curves", std::move(curves)}};
}

}  // namespace

std::shared_ptr<const Mesh> madeMesh(const Mesh& of, const MadeMesh& made) {
    auto mesh = std::make_shared<Mesh>();
    mesh->workpiece = std::make_shared<const Workpiece>(
        made.mesh(),
        PreparingOptions{.mending = {.slits = true}, .shell = of.workpiece->options().shell},
        hostProgress()
    );
    mesh->workpiece->prepare();
    mesh->layer = of.layer;
    mesh->layer.selectedVertices.clear();
    mesh->layer.selectedFaces.clear();
    if (!of.layer.quality.empty()) {
        mesh->layer.quality = made.carried(of.layer.quality);
    }
    mesh->extras = carriedExtras(of.extras, made, of.workpiece->mesh().faces);
    return mesh;
}

const Calls& useCalls() {
    static const Calls calls{
        {"curves.imprint", imprintCurves},
        {"imprint.mesh", whole},
        {"imprint.cut", cut},
        {"imprint.segment", segment},
        {"curve.offset", offset}
    };
    return calls;
}

}  // namespace bspline_curve::web

// SPDX-License-Identifier: GPL-3.0-or-later
// Curves through picks, along lines, and in files.
#include "bspline_curve/files.h"
#include "bspline_curve/lines.h"
#include "bspline_curve/spline.h"
#include "filters/fit_requests.h"
#include "filters/requests.h"
#include "filters/utf8_path.h"
#include "web/core/calls.h"
#include "web/core/files_in_memory.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

namespace bspline_curve::web {

namespace {

// Curves that are drawn one after the other mostly have the same options, and reading these takes a
// tenth of the time of a curve.
CurveRequest requestFor(const Json& options) {
    static std::string last;
    static std::optional<CurveRequest> request;
    std::string text = options.dump();
    if (!request || text != last) {
        request = curveRequest(valuesOfJson(curveFilter(), options));
        last = std::move(text);
    }
    return *request;
}

CurveRequest requestOf(const Json& arguments) {
    CurveRequest request = requestFor(arguments.value("options", Json()));
    if (arguments.contains("field")) {
        const std::span<const double> values = numbersOf(arguments["field"]);
        request.field.emplace();
        request.field->options.kind = FieldKind::Quality;
        request.field->values.assign(values.begin(), values.end());
    }
    if (arguments.contains("avoid")) {
        const std::span<const int> ids = idsOf(arguments["avoid"]);
        request.avoid = {.by = FaceChoice::By::Ids, .ids = Region(ids.begin(), ids.end())};
    }
    return request;
}

// {"mesh", "picks", "options", "field", "avoid", "start"}: a curve. `field`: a value for each
// vertex; `avoid`: faces; `start`: a curve through as many picks, to go on from.
Json draw(const Json& arguments, Reply& reply) {
    const auto mesh = meshOf(arguments.at("mesh").get<int>());
    const std::vector<Vec3> picks = pointsOf(arguments.at("picks"));
    const CurveRequest request = requestOf(arguments);
    auto made = std::make_shared<DrawnOnMesh>();
    made->mesh = mesh;
    const auto start =
        arguments.contains("start") ? curveOf(arguments["start"].get<int>()) : nullptr;
    made->drawn = mesh->workpiece->draw(
        picks, request, mesh->layer, hostProgress(), start ? &start->drawn.curve : nullptr
    );
    return curveJson(std::move(made), reply);
}

std::vector<LineToFit> linesOf(const Json& arguments, const TriangleMesh& mesh) {
    if (arguments.contains("labels")) {
        const std::span<const int> labels = idsOf(arguments["labels"]);
        if (labels.size() != mesh.faces.size()) {
            throw InputError(
                InputErrorCode::BadOption,
                "there are " + std::to_string(labels.size()) + " labels, but the mesh has " +
                    std::to_string(mesh.faces.size()) + " faces: give one for each"
            );
        }
        return linesBetween(mesh, labels);
    }
    if (arguments.contains("faces")) {
        const std::span<const int> ids = idsOf(arguments["faces"]);
        const std::vector<std::int64_t> faces(ids.begin(), ids.end());
        return linesRound(mesh, makeRegion(mesh, faces));
    }
    return {
        {.points = pointsOf(arguments.at("line")),
         .closed = arguments.value("closed", false),
         .name = "the line"}
    };
}

// {"mesh", "line" and "closed", or "faces", or "labels", "options"}: {"curves": […], "notes"},
// smooth curves along the line, along the boundary of the faces, or between labels.
Json fit(const Json& arguments, Reply& reply) {
    const auto mesh = meshOf(arguments.at("mesh").get<int>());
    const FitRequest request =
        fitRequest(valuesOfJson(fitFilter(), arguments.value("options", Json())));
    const Workpiece& workpiece = *mesh->workpiece;
    FittedLines fitted = fitLines(
        workpiece, linesOf(arguments, workpiece.mesh()), request.fit, request.curve, hostProgress()
    );
    Json curves = Json::array();
    for (DesignedCurve& curve : fitted.curves) {
        auto made = std::make_shared<DrawnOnMesh>();
        made->mesh = mesh;
        made->drawn = std::move(curve);
        curves.push_back(curveJson(std::move(made), reply));
    }
    return {{"curves", std::move(curves)}, {"notes", fitted.notes}};
}

LengthUnit unitOf(const Json& arguments) {
    const auto word = arguments.value("unit", std::string("mm"));
    const std::optional<LengthUnit> unit = lengthUnitOf(word);
    if (!unit) {
        throw InputError(InputErrorCode::BadOption, "there is no unit " + word);
    }
    return *unit;
}

// {"curves", "name", "unit"}: the bytes of a file of these curves of one mesh.
Json saveCurves(const Json& arguments, Reply& reply) {
    const auto curves = curvesOf(arguments.at("curves"));
    const std::filesystem::path file = utf8Path(arguments.at("name").get<std::string>());
    if (curves.empty()) {
        throw InputError(
            InputErrorCode::UnwritableFile, file.string() + ": there is no curve to be saved"
        );
    }
    const DrawnOnMesh& first = *curves.front();
    const MeshChecksum checksum = first.mesh->workpiece->checksum();
    const LengthUnit unit = unitOf(arguments);
    if (curves.size() == 1) {
        return {
            {"bytes",
             reply.bytes(curveBytes(file, first.drawn.curve, first.drawn.along, checksum, unit))}
        };
    }
    std::vector<const Curve*> all;
    for (const auto& curve : curves) {
        all.push_back(&curve->drawn.curve);
    }
    return {{"bytes", reply.bytes(curvesBytes(file, all, checksum, unit))}};
}

// {"mesh", "name", "bytes"}: {"curves": […], "notes"} of a file.
Json readCurves(const Json& arguments, Reply& reply) {
    const auto mesh = meshOf(arguments.at("mesh").get<int>());
    const std::filesystem::path path = utf8Path(arguments.at("name").get<std::string>());
    const FileInMemory file(path, std::string(bytesOf(arguments.at("bytes"))));
    CurvesOfFile found =
        readCurvesOn(*mesh->workpiece, path, {.remedy = "draw them nearer to the mesh"});
    Json curves = Json::array();
    for (std::size_t i = 0; i < found.lines.size(); ++i) {
        auto made = std::make_shared<DrawnOnMesh>();
        made->mesh = mesh;
        made->drawn.curve.polyline = std::move(found.lines[i]);
        if (i < found.splines.size()) {
            made->drawn.curve.spline = std::move(found.splines[i]).value_or(SplineData());
        }
        made->drawn.curve.report.usable = true;
        curves.push_back(curveJson(std::move(made), reply));
    }
    return {{"curves", std::move(curves)}, {"notes", found.notes}};
}

}  // namespace

std::vector<std::shared_ptr<const DrawnOnMesh>> curvesOf(const Json& numbers) {
    std::vector<std::shared_ptr<const DrawnOnMesh>> curves;
    for (const Json& number : numbers) {
        curves.push_back(curveOf(number.get<int>()));
        if (curves.back()->mesh->workpiece != curves.front()->mesh->workpiece) {
            throw InputError(InputErrorCode::NoPath, "the curves are of different meshes");
        }
    }
    return curves;
}

Json curveJson(std::shared_ptr<const DrawnOnMesh> curve, Reply& reply) {
    const auto& [line, nearPicks, nearPickPositions, spline, report, shell, prisms, passed] =
        curve->drawn.curve;
    std::vector<int> faces;
    std::vector<Vec3> barycentrics;
    for (const SurfacePoint& place : line.surfacePoints) {
        faces.push_back(place.face);
        barycentrics.push_back(place.barycentric);
    }
    Json json{
        {"closed", line.closed},
        {"points", reply.view(curve, line.points)},
        {"faces", reply.array(std::move(faces))},
        {"barycentrics", reply.array(std::move(barycentrics))},
        {"t", reply.view(curve, line.parameters)},
        {"picks", reply.view(curve, line.picks)},
        {"corners", reply.array(cornersOf(spline))},
        {"degree", spline.degree},
        {"knots", reply.view(curve, spline.knots)},
        {"control_points", reply.view(curve, spline.controlPoints)},
        {"pick_parameters", reply.view(curve, spline.pickParameters)},
        {"length", lengthOf(line)},
        {"usable", report.usable},
        {"status", name(report.status)},
        {"seconds", curve->drawn.seconds},
        {"deviation", curve->deviation},
        {"notes", curve->drawn.notes}
    };
    json["curve"] = keep(std::move(curve));
    return json;
}

const Calls& curveCalls() {
    static const Calls calls{
        {"curve.draw", draw},
        {"mesh.fit", fit},
        {"curves.save", saveCurves},
        {"curves.read", readCurves}
    };
    return calls;
}

}  // namespace bspline_curve::web

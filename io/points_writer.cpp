// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/error.h"
#include "bspline_curve/files.h"
#include "text/json_text.h"
#include "text/number_text.h"
#include "text/text_parsing.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace bspline_curve {

namespace {

using Curves = std::span<const PointsOfCurve>;

/// The numbers of a vector with a separator between them.
std::string numbersOf(const Vec3& v, char separator) {
    std::string text = numberText(v.x());
    for (const double x : {v.y(), v.z()}) {
        text += separator;
        text += numberText(x);
    }
    return text;
}

/// Which point of which curve, from 1: "C2-7".
std::string labelOf(std::size_t curve, std::size_t point) {
    std::string label = "C";
    label += std::to_string(curve + 1);
    label += '-';
    label += std::to_string(point + 1);
    return label;
}

std::string pointsCsv(Curves curves) {
    std::string text =
        "curve,number,x,y,z,distance,tangent_x,tangent_y,tangent_z,normal_x,normal_y,normal_z,"
        "left_x,left_y,left_z,curvature,normal_curvature,geodesic_curvature,face,b0,b1,b2\n";
    for (std::size_t c = 0; c < curves.size(); ++c) {
        for (std::size_t i = 0; i < curves[c].points.size(); ++i) {
            const CurvePoint& point = curves[c].points[i];
            text += std::to_string(c + 1) + ',' + std::to_string(i + 1) + ',';
            text += numbersOf(point.position, ',') + ',' + numberText(point.distance) + ',';
            for (const Vec3& direction : {point.tangent, point.normal, point.left}) {
                text += numbersOf(direction, ',') + ',';
            }
            for (const double curvature :
                 {point.curvature, point.normalCurvature, point.geodesicCurvature}) {
                text += numberText(curvature) + ',';
            }
            text += std::to_string(point.place.face) + ',';
            text += numbersOf(point.place.barycentric, ',') + '\n';
        }
    }
    return text;
}

Json tripleOf(const Vec3& v) {
    return {v.x(), v.y(), v.z()};
}

std::string pointsJsonText(Curves curves) {
    Json picks = Json::array();
    Json list = Json::array();
    for (const PointsOfCurve& curve : curves) {
        Json points = Json::array();
        for (const CurvePoint& point : curve.points) {
            if (&curve == curves.data()) {
                picks.push_back(tripleOf(point.position));
            }
            points.push_back({
                {"position", tripleOf(point.position)},
                {"distance", point.distance},
                {"tangent", tripleOf(point.tangent)},
                {"normal", tripleOf(point.normal)},
                {"left", tripleOf(point.left)},
                {"curvature", point.curvature},
                {"normal_curvature", point.normalCurvature},
                {"geodesic_curvature", point.geodesicCurvature},
                {"face", point.place.face},
                {"barycentric", tripleOf(point.place.barycentric)},
            });
        }
        list.push_back({{"closed", curve.closed}, {"points", std::move(points)}});
    }
    const bool closed = !curves.empty() && curves.front().closed;
    return jsonText(
        Json{{"picks", std::move(picks)}, {"closed", closed}, {"curves", std::move(list)}}
    );
}

std::string pointsMarkups(Curves curves) {
    Json markups = Json::array();
    for (std::size_t c = 0; c < curves.size(); ++c) {
        Json points = Json::array();
        for (std::size_t i = 0; i < curves[c].points.size(); ++i) {
            const CurvePoint& point = curves[c].points[i];
            Json orientation = Json::array();
            for (int row = 0; row < 3; ++row) {  // of the matrix whose columns are the axes
                for (const Vec3& axis : {point.tangent, point.left, point.normal}) {
                    orientation.push_back(axis[row]);
                }
            }
            points.push_back({
                {"id", std::to_string(i + 1)},
                {"label", labelOf(c, i)},
                {"position", tripleOf(point.position)},
                {"orientation", std::move(orientation)},
                {"selected", true},
                {"locked", false},
                {"visibility", true},
                {"positionStatus", "defined"},
            });
        }
        markups.push_back({
            {"type", curves[c].closed ? "ClosedCurve" : "Curve"},
            {"coordinateSystem", "LPS"},
            {"controlPoints", std::move(points)},
        });
    }
    return jsonText(
        Json{
            {"@schema",
             "https://raw.githubusercontent.com/slicer/slicer/master/Modules/Loadable/Markups/"
             "Resources/Schema/markups-schema-v1.0.3.json#"},
            {"markups", std::move(markups)}
        }
    );
}

std::string pointsSlicerList(Curves curves) {
    std::string text =
        "# Markups fiducial file version = 4.11\n# CoordinateSystem = LPS\n"
        "# columns = id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID\n";
    std::size_t id = 0;
    for (std::size_t c = 0; c < curves.size(); ++c) {
        for (std::size_t i = 0; i < curves[c].points.size(); ++i) {
            text += std::to_string(++id) + ',' + numbersOf(curves[c].points[i].position, ',') +
                    ",0,0,0,1,1,1,0," + labelOf(c, i) + ",,\n";
        }
    }
    return text;
}

std::string pointsPickPoints(Curves curves) {
    std::string text = "<!DOCTYPE PickedPoints>\n<PickedPoints>\n";
    for (std::size_t c = 0; c < curves.size(); ++c) {
        for (std::size_t i = 0; i < curves[c].points.size(); ++i) {
            const Vec3& p = curves[c].points[i].position;
            text.append(R"( <point x=")").append(numberText(p.x()));
            text.append(R"(" y=")").append(numberText(p.y()));
            text.append(R"(" z=")").append(numberText(p.z()));
            text.append(R"(" active="1" name=")").append(labelOf(c, i)).append("\"/>\n");
        }
    }
    return text + "</PickedPoints>\n";
}

std::string pointsXyz(Curves curves) {
    std::string text;
    for (const PointsOfCurve& curve : curves) {
        for (const CurvePoint& point : curve.points) {
            text += numbersOf(point.position, ' ') + '\n';
        }
    }
    return text;
}

struct PointsFormat {
    std::string_view end;
    std::string (*bytes)(Curves curves);
};

// A name has the first format that it ends with.
constexpr std::array kPointsFormats{
    PointsFormat{.end = ".csv", .bytes = pointsCsv},
    PointsFormat{.end = ".mrk.json", .bytes = pointsMarkups},
    PointsFormat{.end = ".json", .bytes = pointsJsonText},
    PointsFormat{.end = ".fcsv", .bytes = pointsSlicerList},
    PointsFormat{.end = ".pp", .bytes = pointsPickPoints},
    PointsFormat{.end = ".xyz", .bytes = pointsXyz}
};

const PointsFormat& pointsFormatOf(const std::filesystem::path& file) {
    const std::string name = lowerCase(file.filename().string());
    const auto* const found = std::ranges::find_if(kPointsFormats, [&](const PointsFormat& each) {
        return name.size() > each.end.size() && name.ends_with(each.end);
    });
    if (found == kPointsFormats.end()) {
        throw InputError(
            InputErrorCode::UnwritableFile,
            file.string() + ": points are written as " + kPointsExtensions +
                "; change the name's end"
        );
    }
    return *found;
}

}  // namespace

void checkPointsExtension(const std::filesystem::path& file) {
    static_cast<void>(pointsFormatOf(file));
}

std::string pointsBytes(const std::filesystem::path& file, Curves curves) {
    return pointsFormatOf(file).bytes(curves);
}

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes: from files and arrays, to files and arrays; fields on them.
#include "bspline_curve/files.h"
#include "bspline_curve/progress.h"
#include "filters/requests.h"
#include "filters/utf8_path.h"
#include "web/core/calls.h"
#include "web/core/files_in_memory.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace bspline_curve::web {

namespace {

// Of progress: reading bytes is quick.
constexpr double kSurfaceShare = 0.4;

ParameterValue valueOfJson(const ParameterDescription& parameter, const Json& value) {
    const bool isWhole = value.is_number_integer() ||
                         (value.is_number() && value == std::floor(value.get<double>()));
    switch (parameter.type) {
        case ParameterType::Bool:
            if (value.is_boolean()) {
                return value.get<bool>();
            }
            break;
        case ParameterType::Int:
            if (isWhole) {
                return value.get<int>();
            }
            break;
        case ParameterType::Double:
        case ParameterType::Percentage:
            if (value.is_number()) {
                return value.get<double>();
            }
            break;
        case ParameterType::Length:
        case ParameterType::Tolerances:
            if (value.is_number()) {
                return value.dump();
            }
            [[fallthrough]];
        default:
            if (value.is_string()) {
                return value.get<std::string>();
            }
    }
    throw InputError(
        InputErrorCode::BadOption,
        parameter.id + " is " + value.dump() + ", which is of another type"
    );
}

PreparingOptions preparingOptions(const Json& options) {
    const CurveRequest request = curveRequest(valuesOfJson(curveFilter(), options));
    return {.mending = request.mending, .shell = request.shell};
}

// Colours of vertices, 0 to 255; empty: there are none.
std::vector<std::uint8_t> coloursOf(const MeshExtras& extras, std::size_t vertexCount) {
    std::vector<std::uint8_t> colours;
    int position = 0;
    for (const char* const name : {"red", "green", "blue"}) {
        const auto channel = std::ranges::find(extras.vertices, name, &MeshChannel::name);
        if (channel == extras.vertices.end() || channel->values.size() != vertexCount) {
            return {};
        }
        colours.resize(3 * vertexCount);
        const bool isShare =
            channel->type == PlyScalar::Float || channel->type == PlyScalar::Double;
        for (std::size_t i = 0; i < vertexCount; ++i) {
            const double value = channel->values[i] * (isShare ? 255.0 : 1.0);
            colours[3 * i + position] =
                static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
        }
        ++position;
    }
    return colours;
}

std::vector<double> cornerTextureOf(const MeshExtras& extras) {
    std::vector<double> coordinates;
    coordinates.reserve(6 * extras.cornerTexture.size());
    for (const auto& corners : extras.cornerTexture) {
        for (const Eigen::Vector2d& uv : corners) {
            coordinates.insert(coordinates.end(), {uv.x(), uv.y()});
        }
    }
    return coordinates;
}

std::shared_ptr<const Mesh> prepared(
    LayerInput layer, MeshExtras extras, const PreparingOptions& options
) {
    const Progress progress = hostProgress();
    auto mesh = std::make_shared<Mesh>();
    mesh->workpiece = workpieceOf(layer, options, partOf(progress, 0.0, kSurfaceShare));
    mesh->workpiece->prepare(partOf(progress, kSurfaceShare, 1.0));
    layer.mesh = {};  // the workpiece has it
    mesh->layer = std::move(layer);
    mesh->extras = std::move(extras);
    return mesh;
}

// {"name", "bytes", "options"}: a file; its format by the end of its name.
Json loadMesh(const Json& arguments, Reply& reply) {
    const PreparingOptions options = preparingOptions(arguments.value("options", Json()));
    const auto name = arguments.at("name").get<std::string>();
    LayerInput layer{
        .label = name, .mesh = {}, .quality = {}, .selectedVertices = {}, .selectedFaces = {}
    };
    layer.isFile = true;
    MeshExtras extras;
    {
        const std::filesystem::path path = utf8Path(name);
        const FileInMemory file(path, std::string(bytesOf(arguments.at("bytes"))));
        const auto repeated =
            options.mending.strict ? RepeatedVertices::Refuse : RepeatedVertices::Keep;
        MeshFile read = readMeshFile(path, repeated);
        layer.mesh = std::move(read.mesh);
        layer.quality = std::move(read.quality);
        extras = readMeshExtras(path);
    }
    return meshJson(prepared(std::move(layer), std::move(extras), options), reply);
}

// {"vertices", "faces", "options"}: arrays.
Json makeMesh(const Json& arguments, Reply& reply) {
    const PreparingOptions options = preparingOptions(arguments.value("options", Json()));
    LayerInput layer{
        .label = arguments.value("name", "mesh"),
        .mesh = {},
        .quality = {},
        .selectedVertices = {},
        .selectedFaces = {}
    };
    layer.mesh.vertices = pointsOf(arguments.at("vertices"));
    const std::span<const int> ids = idsOf(arguments.at("faces"));
    layer.mesh.faces.reserve(ids.size() / 3);
    for (std::size_t i = 0; i + 2 < ids.size(); i += 3) {
        layer.mesh.faces.push_back({ids[i], ids[i + 1], ids[i + 2]});
    }
    return meshJson(prepared(std::move(layer), {}, options), reply);
}

// {"mesh", "name"}: the bytes of a file.
Json saveMesh(const Json& arguments, Reply& reply) {
    const auto mesh = meshOf(arguments.at("mesh").get<int>());
    const std::filesystem::path file = utf8Path(arguments.at("name").get<std::string>());
    return {
        {"bytes",
         reply.bytes(meshBytes(
             file,
             mesh->workpiece->mesh(),
             {.vertexQuality = mesh->layer.quality, .extras = &mesh->extras}
         ))},
        {"lost", lostExtras(file, mesh->extras)}
    };
}

// {"mesh", "options", "quality", "region"}: a value for each vertex.
Json field(const Json& arguments, Reply& reply) {
    const auto mesh = meshOf(arguments.at("mesh").get<int>());
    FieldLayerRequest request =
        fieldRequest(valuesOfJson(fieldFilter(), arguments.value("options", Json())));
    if (arguments.contains("quality")) {
        const std::span<const double> values = numbersOf(arguments["quality"]);
        request.values.assign(values.begin(), values.end());
    }
    if (arguments.contains("region")) {
        const std::span<const int> ids = idsOf(arguments["region"]);
        request.region = {.by = FaceChoice::By::Ids, .ids = Region(ids.begin(), ids.end())};
    }
    return {
        {"values",
         reply.array(
             std::vector<double>(
                 mesh->workpiece->field(mesh->layer, request, hostProgress()).values()
             )
         )}
    };
}

// {"mesh", "points"}: the closest points, {"faces", "barycentrics", "points"}.
Json project(const Json& arguments, Reply& reply) {
    const auto mesh = meshOf(arguments.at("mesh").get<int>());
    std::vector<int> faces;
    std::vector<Vec3> barycentrics;
    std::vector<Vec3> points;
    for (const Vec3& query : pointsOf(arguments.at("points"))) {
        const ClosestPoint closest = mesh->workpiece->closestPoint(query);
        faces.push_back(closest.place.face);
        barycentrics.push_back(closest.place.barycentric);
        points.push_back(closest.position);
    }
    return {
        {"faces", reply.array(std::move(faces))},
        {"barycentrics", reply.array(std::move(barycentrics))},
        {"points", reply.array(std::move(points))}
    };
}

// {"object"}: what is freed.
Json freeObject(const Json& arguments, Reply& /*reply*/) {
    forget(arguments.at("object").get<int>());
    return {{"objects", objectCount()}};
}

}  // namespace

ParameterValues valuesOfJson(const FilterDescription& filter, const Json& options) {
    ParameterValues values(filter);
    if (options.is_null()) {
        return values;
    }
    for (const auto& [id, value] : options.items()) {
        const auto parameter = std::ranges::find(filter.parameters, id, &ParameterDescription::id);
        if (parameter == filter.parameters.end()) {
            throw InputError(InputErrorCode::BadOption, "there is no option " + id);
        }
        values.set(id, valueOfJson(*parameter, value));
    }
    return values;
}

Json meshJson(std::shared_ptr<const Mesh> mesh, Reply& reply) {
    const Workpiece& workpiece = *mesh->workpiece;
    const TriangleMesh& shown = workpiece.mesh();
    std::vector<std::uint8_t> colours = coloursOf(mesh->extras, shown.vertices.size());
    Json json{
        {"vertices", reply.view(mesh->workpiece, shown.vertices)},
        {"faces", reply.view(mesh->workpiece, shown.faces)},
        {"colours", colours.empty() ? Json() : reply.array(std::move(colours))},
        {"diagonal", workpiece.diagonal()},
        {"components", workpiece.componentCount()},
        {"mending", workpiece.mending()},
        {"notes", workpiece.notes()}
    };
    if (!mesh->extras.cornerTexture.empty()) {
        json["texture_coordinates"] = reply.array(cornerTextureOf(mesh->extras));
    }
    json["mesh"] = keep(std::move(mesh));
    return json;
}

const Calls& meshCalls() {
    static const Calls calls{
        {"mesh.load", loadMesh},
        {"mesh.make", makeMesh},
        {"mesh.save", saveMesh},
        {"mesh.field", field},
        {"mesh.project", project},
        {"object.free", freeObject}
    };
    return calls;
}

}  // namespace bspline_curve::web

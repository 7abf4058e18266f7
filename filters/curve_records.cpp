// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/curve_records.h"

#include "bspline_curve/error.h"
#include "bspline_curve/spline.h"
#include "filters/requests.h"
#include "io/curve_json.h"
#include "io/picks_formats.h"
#include "text/error_messages.h"
#include "text/json_reader.h"
#include "text/text_parsing.h"
#include "utility/index_sets.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>
#include <variant>

namespace bspline_curve {

namespace {

using nlohmann::json;
using std::filesystem::path;

constexpr std::int64_t kNoInt = std::numeric_limits<std::int64_t>::max();

// ---- Writing ----

Json optionsJson(const DrawnOptions& options) {
    Json result = Json::object();
    const ParameterValues values = valuesOf(options);
    for (const std::string& id : drawnParameters()) {
        if (id == "closed") {
            continue;  // the curve's own
        }
        std::visit(
            [&](const auto& value) {
                if constexpr (!std::is_same_v<std::decay_t<decltype(value)>, LayerId>) {
                    result[id] = value;
                }
            },
            values.value(id)
        );
    }
    return result;
}

Json picksJson(const std::vector<SketchPick>& picks) {
    std::vector<Vec3> positions;
    std::vector<SurfacePoint> points;
    for (const SketchPick& pick : picks) {
        positions.push_back(pick.position);
        points.push_back(pick.point);
    }
    Json result = surfacePointsJson(positions, points);
    const auto corners =
        indicesWhere<int>(picks.size(), [&](std::size_t i) { return picks[i].isCorner; });
    if (!corners.empty()) {
        result["corners"] = corners;
    }
    return result;
}

Json recordJson(const CurveRecord& record, bool isShort) {
    Json result = Json::object();
    if (!record.name.empty()) {
        result["name"] = record.name;
    }
    if (record.colour) {
        result["colour"] = *record.colour;
    }
    result["closed"] = record.closed;
    result["picks"] = picksJson(record.picks);
    result["options"] = record.options ? optionsJson(*record.options) : Json();
    if (record.curve && !isShort) {
        result.update(contentJson({.curve = *record.curve}));
    }
    result.erase("tangents");  // the picks' own, as they were asked for
    std::vector<std::pair<int, PickTangent>> tangents;
    for (std::size_t i = 0; i < record.picks.size(); ++i) {
        if (!record.picks[i].tangent.isAny()) {
            tangents.emplace_back(static_cast<int>(i), record.picks[i].tangent);
        }
    }
    addTangents(tangents, result);
    return result;
}

Json recordsJson(const CurveRecords& records, bool isShort) {
    Json document = Json::object();
    if (records.curves.size() == 1) {
        document = recordJson(records.curves.front(), isShort);
    } else {
        document["curves"] = Json::array();
        for (const CurveRecord& record : records.curves) {
            document["curves"].push_back(recordJson(record, isShort));
        }
    }
    if (records.mesh) {
        document["mesh"] = meshJson(*records.mesh);
    }
    return document;
}

// ---- Reading ----

class RecordReader {
public:
    RecordReader(path name, std::vector<std::string>& notes)
        : file_(std::move(name)), notes_(notes) {}

    CurveRecord read(const json& curve) {
        CurveRecord record;
        record.closed = flagOfJson(file_, curve, "closed");
        if (curve.contains("polyline")) {
            Curve read;
            read.polyline = polylineOfJson(file_, curve);
            if (curve.contains("spline")) {
                read.spline = splineOfJson(file_, curve.at("spline"));
            }
            record.curve = std::make_shared<const Curve>(std::move(read));
        }
        record.name = nameOf(curve);
        record.colour = colourOf(curve);
        record.picks = picksOf(curve, record);
        record.options = optionsOf(curve, record);
        return record;
    }

private:
    [[nodiscard]] std::string nameOf(const json& curve) const {
        if (!curve.contains("name")) {
            return {};
        }
        if (!curve.at("name").is_string()) {
            refuseFile(file_, R"("name" is no text)");
        }
        return curve.at("name").get<std::string>();
    }

    [[nodiscard]] std::optional<CurveColour> colourOf(const json& curve) const {
        if (!curve.contains("colour")) {
            return std::nullopt;
        }
        constexpr std::int64_t kMost = std::numeric_limits<std::uint8_t>::max();
        const json& value = curve.at("colour");
        const bool isColour = value.is_array() && value.size() == CurveColour().size() &&
                              std::ranges::all_of(value, [](const json& channel) {
                                  return channel.is_number_integer() &&
                                         channel.get<std::int64_t>() >= 0 &&
                                         channel.get<std::int64_t>() <= kMost;
                              });
        if (!isColour) {
            refuseFile(file_, R"("colour" is not four whole numbers in [0, 255])");
        }
        return value.get<CurveColour>();
    }

    [[nodiscard]] std::vector<SketchPick> picksOf(
        const json& curve, const CurveRecord& record
    ) const {
        std::vector<SketchPick> picks;
        if (curve.contains("picks")) {
            const PointsOfJson read =
                surfacePointsOfJson(file_, curve.at("picks"), "picks", [](std::size_t index) {
                    return describePicks({static_cast<std::int64_t>(index)});
                });
            for (std::size_t i = 0; i < read.points.size(); ++i) {
                picks.push_back({read.points[i], read.positions[i]});
            }
            const nlohmann::json& written = curve.at("picks");
            for (const int corner : cornersOfJson(file_, written, picks.size())) {
                picks[corner].isCorner = true;
            }
        } else if (record.curve) {
            const SurfacePolyline& line = record.curve->polyline;
            for (const int vertex : line.picks) {
                picks.push_back({line.surfacePoints[vertex], line.points[vertex]});
            }
            for (const int corner : cornersOf(record.curve->spline)) {
                if (corner < static_cast<int>(picks.size())) {
                    picks[corner].isCorner = true;
                }
            }
        }
        for (const auto& [pick, tangent] : tangentsOfJson(file_, curve, picks.size()).entries) {
            picks[pick].tangent = tangent;
        }
        if (picks.empty()) {
            refuseFile(file_, R"(has neither "picks" nor a "polyline" with "picks")");
        }
        return picks;
    }

    std::optional<DrawnOptions> optionsOf(const json& curve, const CurveRecord& record) {
        DrawnOptions options;
        options.closed = record.closed;
        if (!curve.contains("options")) {
            if (record.curve && !record.curve->spline.knots.empty()) {
                options.degree = record.curve->spline.degree;
            }
        } else if (curve.at("options").is_null()) {
            return std::nullopt;
        } else if (!curve.at("options").is_object()) {
            refuseFile(file_, R"("options" is no object)");
        } else {
            readOptions(curve.at("options"), options);
        }
        return checked(options);
    }

    void readOptions(const json& object, DrawnOptions& options) {
        ParameterValues values = valuesOf(options);
        for (const auto& [id, value] : object.items()) {
            const bool isKnown = id != "closed" && std::ranges::find(drawnParameters(), id) !=
                                                       drawnParameters().end();
            if (isKnown) {
                set(values, id, value);
            } else {
                notes_.push_back(
                    file_.string() + ": the option " + inQuotes(id) + " is not known here"
                );
            }
        }
        options = drawnOptionsOf(values);
    }

    void set(ParameterValues& values, const std::string& id, const json& value) const {
        const auto refuse = [&](const char* wanted) {
            refuseFile(file_, "option " + inQuotes(id) + " is not " + wanted);
        };
        ParameterValue read = values.value(id);
        if (auto* const number = std::get_if<double>(&read)) {
            if (!value.is_number()) {
                refuse("a number");
            }
            *number = value.get<double>();
        } else if (auto* const whole = std::get_if<int>(&read)) {
            const auto written = value.is_number_integer() ? value.get<std::int64_t>() : kNoInt;
            if (written != static_cast<int>(written)) {
                refuse("a whole number");
            }
            *whole = static_cast<int>(written);
        } else if (auto* const text = std::get_if<std::string>(&read)) {
            if (!value.is_string()) {
                refuse("a text");
            }
            *text = value.get<std::string>();
        }
        try {
            values.set(id, std::move(read));
        } catch (const InputError& error) {
            refuseFile(file_, error.what());
        }
    }

    /// Refuses numbers outside of their ranges.
    [[nodiscard]] DrawnOptions checked(const DrawnOptions& options) const {
        try {
            static_cast<void>(curveRequest(valuesOf(options)));
        } catch (const InputError& error) {
            refuseFile(file_, error.what());
        }
        return options;
    }

    path file_;  // as messages name it
    std::vector<std::string>& notes_;
};

}  // namespace

CurveRecord recordOf(const DrawnCurve& drawn, std::shared_ptr<const Curve> curve) {
    return {
        .name = drawn.name,
        .colour = drawn.colour,
        .closed = drawn.options.closed,
        .picks = drawn.picks,
        .options = drawn.options,
        .curve = std::move(curve),
    };
}

std::string recordsText(const CurveRecords& records) {
    return recordsJson(records, false).dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string shortRecordsText(const CurveRecords& records) {
    const std::string text =
        recordsJson(records, true).dump(-1, ' ', true, Json::error_handler_t::replace);
    std::string result;
    for (const char byte : text) {
        byte == ' ' ? result.append("\\u0020") : result.append(1, byte);  // within texts
    }
    return result;
}

CurveRecords recordsOf(const path& file, std::string_view text) {
    const json document = jsonOfBytes(file, text);
    CurveRecords records;
    records.mesh = meshOfJson(file, document);
    if (!document.is_object() || !document.contains("curves")) {
        records.curves.push_back(RecordReader(file, records.notes).read(document));
        return records;
    }
    const json& list = document.at("curves");
    if (!list.is_array() || list.empty()) {
        refuseFile(file, R"("curves" is no list of curves)");
    }
    for (const json& curve : list) {
        const path name = file.string() + ", curve " + std::to_string(records.curves.size() + 1);
        records.curves.push_back(RecordReader(name, records.notes).read(curve));
    }
    return records;
}

}  // namespace bspline_curve

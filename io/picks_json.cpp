// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/error.h"
#include "io/picks_formats.h"
#include "text/error_messages.h"
#include "text/json_reader.h"
#include "text/text_parsing.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace bspline_curve {

using std::filesystem::path;

Vec3 pointOfJson(const path& file, const nlohmann::json& value, const std::string& name) {
    const bool isPoint =
        value.is_array() && value.size() == 3 &&
        std::ranges::all_of(value, [](const nlohmann::json& x) { return x.is_number(); });
    if (!isPoint) {
        refuseFile(file, name + " is not [x, y, z] but " + inQuotes(value.dump()));
    }
    const Vec3 point(value[0].get<double>(), value[1].get<double>(), value[2].get<double>());
    if (!point.allFinite()) {
        refuseFile(file, name + " is not finite");
    }
    return point;
}

std::vector<int> cornersOfJson(const path& file, const nlohmann::json& object, std::size_t picks) {
    std::vector<int> corners;
    if (!object.contains("corners")) {
        return corners;
    }
    const nlohmann::json& written = object.at("corners");
    const auto count = static_cast<std::int64_t>(picks);
    const bool areIndices =
        written.is_array() && std::ranges::all_of(written, [&](const nlohmann::json& id) {
            return id.is_number_integer() && id.get<std::int64_t>() >= 0 &&
                   id.get<std::int64_t>() < count;
        });
    if (!areIndices) {
        refuseFile(
            file,
            "\"corners\" is no list of indices of picks, in [0, " + std::to_string(count - 1) + "]"
        );
    }
    for (const nlohmann::json& id : written) {
        corners.push_back(id.get<int>());
    }
    return corners;
}

PickDirections tangentsOfJson(const path& file, const nlohmann::json& object, std::size_t picks) {
    PickDirections tangents;
    if (!object.contains("tangents")) {
        return tangents;
    }
    const nlohmann::json& written = object.at("tangents");
    const auto count = static_cast<std::int64_t>(picks);
    const bool areOfPicks =
        written.is_array() && std::ranges::all_of(written, [&](const nlohmann::json& each) {
            return each.is_object() && each.contains("pick") &&
                   (each.contains("direction") || each.contains("before") ||
                    each.contains("after")) &&
                   each.at("pick").is_number_integer() &&
                   each.at("pick").get<std::int64_t>() >= 0 &&
                   each.at("pick").get<std::int64_t>() < count;
        });
    if (!areOfPicks) {
        refuseFile(
            file,
            R"("tangents" is no list of {"pick": …, "direction": [x, y, z]}, or of a corner "before" and "after", with picks in [0, )" +
                std::to_string(count - 1) + "]"
        );
    }
    for (const nlohmann::json& each : written) {
        const int pick = each.at("pick").get<int>();
        const auto directionOf = [&](const char* key, const Vec3& otherwise) {
            if (!each.contains(key)) {
                return otherwise;
            }
            const Vec3 direction =
                pointOfJson(file, each.at(key), "the direction of " + describePicks({pick}));
            if (direction.isZero(0.0)) {
                refuseFile(file, "the direction of " + describePicks({pick}) + " is zero");
            }
            return direction;
        };
        const Vec3 both = directionOf("direction", Vec3::Zero());
        tangents.entries.emplace_back(
            pick, PickTangent{directionOf("before", both), directionOf("after", both)}
        );
    }
    return tangents;
}

PickTolerances tolerancesOfJson(const path& file, const nlohmann::json& object, std::size_t picks) {
    PickTolerances tolerances;
    if (!object.contains("tolerances")) {
        return tolerances;
    }
    const nlohmann::json& written = object.at("tolerances");
    if (!written.is_array() || written.size() != picks) {
        refuseFile(
            file,
            R"("tolerances" is no list of )" + describeCount(picks, "entry", "entries") +
                ", one for each pick"
        );
    }
    for (const nlohmann::json& each : written) {
        const std::string text = each.is_string() ? each.get<std::string>() : each.dump();
        try {
            const PickTolerances one = parsePickTolerances(text, R"("tolerances")");
            tolerances.entries.push_back(one.entries.front());
        } catch (const InputError& error) {
            refuseFile(file, error.what());
        }
    }
    return tolerances;
}

PicksFile picksOfJson(const path& file, const std::string& bytes) {
    const nlohmann::json document = jsonOfBytes(file, bytes);
    if (document.is_object() && document.contains("markups")) {
        return picksOfMarkups(file, document);
    }
    // A curve that was saved with its picks has where on its mesh they are, too.
    const nlohmann::json::json_pointer plain("/picks");
    const nlohmann::json::json_pointer ofCurve("/picks/points");
    const auto& where = document.contains(ofCurve) ? ofCurve : plain;
    if (!document.contains(where) || !document.at(where).is_array()) {
        refuseFile(file, R"(needs {"picks": [[x, y, z], …]}, or the "markups" of 3D Slicer)");
    }
    PicksFile result;
    for (const nlohmann::json& value : document.at(where)) {
        result.picks.push_back(pointOfJson(file, value, describePicks({std::ssize(result.picks)})));
    }
    const nlohmann::json& beside = &where == &ofCurve ? document.at("picks") : document;
    result.corners = cornersOfJson(file, beside, result.picks.size());
    result.tangents = tangentsOfJson(file, document, result.picks.size());
    result.tolerances = tolerancesOfJson(file, beside, result.picks.size());
    if (document.contains("closed")) {
        if (!document["closed"].is_boolean()) {
            refuseFile(file, R"("closed" must be true or false)");
        }
        result.closed = document["closed"].get<bool>();
    }
    return result;
}

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/json_reader.h"
#include "io/picks_formats.h"
#include "io/text_parsing.h"
#include "surface/error_messages.h"

#include <nlohmann/json.hpp>

#include <algorithm>

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
    if (document.contains("closed")) {
        if (!document["closed"].is_boolean()) {
            refuseFile(file, R"("closed" must be true or false)");
        }
        result.closed = document["closed"].get<bool>();
    }
    return result;
}

}  // namespace bspline_curve

// SPDX-License-Identifier: GPL-3.0-or-later
// Markups of 3D Slicer (.mrk.json, its schema 1.0): point lists, lines and curves with control
// points in LPS or RAS. Picks are given in LPS, the system that Slicer writes meshes in.
#include "io/picks_formats.h"
#include "text/text_parsing.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace bspline_curve {

namespace {

using nlohmann::json;
using std::filesystem::path;

/// A markup that picks can be, with its place in the file for messages.
struct Markup {
    std::string name;
    PicksFile picks;
};

/// The text under a key; empty where there is none.
std::string textOf(const path& file, const json& object, const char* key, const std::string& name) {
    if (!object.contains(key)) {
        return {};
    }
    if (!object[key].is_string()) {
        refuseFile(file, name + ": " + inQuotes(key) + " is not a text");
    }
    return object[key].get<std::string>();
}

/// Whether positions are in RAS; without a word they are in LPS. Old scenes have 0 and 1.
bool isRas(const path& file, const json& markup, const std::string& name) {
    if (!markup.contains("coordinateSystem")) {
        return false;
    }
    const json& value = markup["coordinateSystem"];
    const std::string system = value.is_string() ? value.get<std::string>() : value.dump();
    if (system != "RAS" && system != "LPS" && system != "0" && system != "1") {
        refuseFile(
            file, name + ": the coordinateSystem " + inQuotes(system) + " is neither LPS nor RAS"
        );
    }
    return system == "RAS" || system == "0";
}

/// Whether a control point was placed: those that were not have no position, or one that follows
/// the mouse.
bool isPlaced(const path& file, const json& point, const std::string& name) {
    const std::string status = textOf(file, point, "positionStatus", name);
    const std::array<std::string_view, 3> others{"undefined", "preview", "missing"};
    if (status.empty() || status == "defined") {
        return true;
    }
    if (std::ranges::find(others, status) == others.end()) {
        refuseFile(file, name + ": the positionStatus " + inQuotes(status) + " is not known");
    }
    return false;
}

std::vector<Vec3> placedPoints(const path& file, const json& markup, const std::string& name) {
    std::vector<Vec3> points;
    if (!markup.contains("controlPoints")) {
        return points;
    }
    if (!markup["controlPoints"].is_array()) {
        refuseFile(file, name + R"(: "controlPoints" is not a list)");
    }
    const double flip = isRas(file, markup, name) ? -1.0 : 1.0;
    std::size_t number = 0;
    for (const json& point : markup["controlPoints"]) {
        std::string pointName = name;
        pointName.append(", control point ").append(std::to_string(++number));
        if (!point.is_object()) {
            refuseFile(file, pointName + " is not {…}");
        }
        if (!isPlaced(file, point, pointName)) {
            continue;
        }
        if (!point.contains("position")) {
            refuseFile(file, pointName + " has no position");
        }
        const Vec3 p = pointOfJson(file, point["position"], pointName + ": its position");
        points.emplace_back(flip * p.x(), flip * p.y(), p.z());
    }
    return points;
}

/// A type of markup that picks can be, and what it says about closed.
struct MarkupKind {
    std::string_view type;
    std::optional<bool> closed;
};

constexpr std::array kKinds{
    MarkupKind{.type = "Fiducial", .closed = std::nullopt},
    MarkupKind{.type = "Curve", .closed = false},
    MarkupKind{.type = "ClosedCurve", .closed = true},
    MarkupKind{.type = "Line", .closed = false},
};

}  // namespace

PicksFile picksOfMarkups(const path& file, const json& document) {
    const json& list = document["markups"];
    if (!list.is_array()) {
        refuseFile(file, R"("markups" is not a list)");
    }
    std::vector<Markup> found;
    std::string others;
    std::size_t number = 0;
    for (const json& markup : list) {
        const std::string name = "markup " + std::to_string(++number);
        if (!markup.is_object()) {
            refuseFile(file, name + " is not {…}");
        }
        const std::string type = textOf(file, markup, "type", name);
        const auto* const kind = std::ranges::find(kKinds, type, &MarkupKind::type);
        if (kind == kKinds.end()) {
            others.append(others.empty() ? " but " : ", ").append(inQuotes(type));
            continue;
        }
        Markup candidate{.name = name, .picks = {}};
        candidate.name.append(" (").append(type).append(")");
        candidate.picks.closed = kind->closed;
        candidate.picks.picks = placedPoints(file, markup, name);
        if (!candidate.picks.picks.empty()) {
            found.push_back(std::move(candidate));
        }
    }
    if (found.empty()) {
        refuseFile(
            file, "holds no picks: no Fiducial, Curve, ClosedCurve or Line with points" + others
        );
    }
    if (found.size() > 1) {
        refuseFile(
            file,
            "holds several markups with points, among them " + found[0].name + " and " +
                found[1].name + ": save the one to use to a file of its own"
        );
    }
    return std::move(found.front().picks);
}

}  // namespace bspline_curve

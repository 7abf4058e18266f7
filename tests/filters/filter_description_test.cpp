// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/filter_description.h"

#include "bspline_curve/error.h"
#include "filters/description_html.h"
#include "filters/fit_requests.h"
#include "filters/labels.h"
#include "filters/parameter_values.h"
#include "filters/requests.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <string>

namespace bspline_curve {
namespace {

using nlohmann::json;

/// A description of one filter with one number and one enumeration.
json smallDescription() {
    return json::parse(R"({
        "pluginId": "p",
        "references": [{"id": "r", "type": "book", "title": "T", "container-title": "C",
                        "issued": {"date-parts": [[2001]]}, "URL": "https://example.org"}],
        "filters": [{
            "id": "f", "name": "F", "pythonName": "f", "categories": ["Other"],
            "shortDescription": "s", "longDescriptionMarkdown": "l", "referenceIds": ["r"],
            "inputDomain": "SingleMesh", "outputDomain": "NewMeshes",
            "parameters": [
                {"id": "e", "label": "E", "group": "main", "type": "enum", "default": "a", "help": "h",
                 "enumOptions": [{"id": "a", "label": "A", "help": "one"}, {"id": "b", "label": "B"}]},
                {"id": "n", "label": "N", "group": "advanced.x", "type": "int", "default": 2,
                 "min": 1, "max": 3, "help": "h", "enabledWhen": {"parameter": "e", "in": ["b"]}}
            ]
        }]})");
}

FilterDescription parsed(const json& document) {
    return parseFilterDescriptions(document.dump()).at(0);
}

TEST(FilterDescription, TheEmbeddedOneIsWhole) {
    EXPECT_EQ(parseFilterDescriptions(filterDescriptionsJson()).size(), 11u);
    EXPECT_EQ(curveFilter().name, "B-spline Curve on Surface");
    EXPECT_EQ(fieldFilter().name, "Scalar Field for Curves");
    EXPECT_EQ(imprintFilter().name, "Imprint Curves");
    EXPECT_EQ(cutFilter().name, "Cut along Curves");
    EXPECT_EQ(segmentFilter().name, "Segment by Curves");
    EXPECT_EQ(offsetFilter().name, "Offset Curve on Surface");
    EXPECT_EQ(patternFilter().name, "Pattern on Surface");
    EXPECT_EQ(fitFilter().name, "Fit Curve to Selection Boundary");
    EXPECT_EQ(editFilter().name, "Edit Curve on Surface");
    EXPECT_EQ(pointsFilter().name, "Points on Curve");
    EXPECT_EQ(fillFilter().name, "Fill Holes");
    EXPECT_EQ(curveFilter().publications.at(0).year, 2023);
}

TEST(FilterDescription, KeepsWhatTheFileSays) {
    const FilterDescription filter = parsed(smallDescription());
    const ParameterDescription& number = filter.parameter("n");
    EXPECT_EQ(number.type, ParameterType::Int);
    EXPECT_EQ(std::get<int>(number.defaultValue), 2);
    EXPECT_EQ(number.min, 1.0);
    EXPECT_EQ(number.max, 3.0);
    EXPECT_TRUE(number.isAdvanced());
    EXPECT_EQ(number.enabledWhen->parameter, "e");
    const ParameterDescription& choice = filter.parameter("e");
    EXPECT_FALSE(choice.isAdvanced());
    EXPECT_EQ(choice.indexOf("b"), 1u);
    EXPECT_EQ(choice.indexOf("c"), std::nullopt);
    EXPECT_EQ(choice.defaultOption(), 0u);
    EXPECT_EQ(choice.fullHelp(), "h a: one.");
    EXPECT_THROW(static_cast<void>(filter.parameter("m")), std::out_of_range);
}

TEST(FilterDescription, LeavesOutWhatNeedsASelectionForHostsWithout) {
    json document = smallDescription();
    json& option = document["filters"][0]["parameters"][0]["enumOptions"][1];
    option["help"] = "two";
    option["needsSelection"] = true;
    const FilterDescription filter = parsed(document);
    const ParameterDescription& choice = filter.parameter("e");
    EXPECT_EQ(choice.fullHelp(), "h a: one; b: two.");
    EXPECT_EQ(choice.fullHelp(false), "h a: one.");
    EXPECT_EQ(choice.optionIds(), (std::vector<std::string>{"a", "b"}));
    EXPECT_EQ(choice.optionIds(false), std::vector<std::string>{"a"});
}

TEST(FilterDescription, WhatIsMalformedIsRefusedWithItsPlace) {
    using Damage = std::function<void(json&, json&, json&)>;  // filter, enumeration, number
    const std::vector<std::pair<Damage, std::string>> damages = {
        {[](json& f, json&, json&) { f.erase("name"); }, "filters[0] has no name"},
        {[](json& f, json&, json&) { f["nmae"] = "F"; }, "unknown key nmae"},
        {[](json& f, json&, json&) { f["referenceIds"] = {"s"}; }, "unknown reference s"},
        {[](json&, json& e, json&) { e["type"] = "enumm"; }, "parameters[0] has an unknown type"},
        {[](json&, json& e, json&) { e["default"] = "c"; }, "none of its enumOptions"},
        {[](json&, json& e, json&) { e["default"] = 0; }, "default of another type"},
        {[](json&, json& e, json&) { e["help"] = ""; }, "help"},
        {[](json&, json& e, json&) { e["min"] = 1; }, "unknown key min"},
        {[](json&, json&, json& n) { n["default"] = 4; }, "parameters[1] has a default out of"},
        {[](json&, json&, json& n) {
             n["default"] = 1;
             n["excludesMin"] = true;
         },
         "out of its range"},
        {[](json&, json&, json& n) { n["default"] = 2.0; }, "another type"},
        {[](json&, json&, json& n) { n["min"] = "1"; }, "no number"},
        {[](json&, json&, json& n) { n["id"] = "e"; }, "parameter e twice"},
        {[](json&, json&, json& n) { n["enabledWhen"]["in"] = {"c"}; }, "e is never c"},
        {[](json&, json&, json& n) { n["enabledWhen"]["parameter"] = "m"; }, "no m before n"},
        {[](json&, json&, json& n) { n["slider"] = 1; }, "neither true nor false"},
    };
    for (const auto& [damage, message] : damages) {
        json document = smallDescription();
        json& filter = document["filters"][0];
        damage(filter, filter["parameters"][0], filter["parameters"][1]);
        try {
            static_cast<void>(parsed(document));
            ADD_FAILURE() << "accepted although: " << message;
        } catch (const std::invalid_argument& error) {
            EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
        }
    }
    EXPECT_THROW(static_cast<void>(parseFilterDescriptions("{")), std::invalid_argument);
}

TEST(FilterDescription, BothFiltersSayTheSameOfTheSameParameters) {
    for (const ParameterDescription& parameter : fieldFilter().parameters) {
        if (parameter.id == "kind") {
            continue;
        }
        const std::string prefix = parameter.group == "advanced.limits" ? "" : "field_";
        const ParameterDescription& other = curveFilter().parameter(prefix + parameter.id);
        EXPECT_EQ(parameter.label, other.label);
        EXPECT_EQ(parameter.fullHelp(), other.fullHelp());
        EXPECT_EQ(parameter.defaultValue, other.defaultValue) << parameter.id;
        EXPECT_EQ(parameter.min, other.min) << parameter.id;
        EXPECT_EQ(parameter.max, other.max) << parameter.id;
        EXPECT_EQ(parameter.excludesMin, other.excludesMin) << parameter.id;
        EXPECT_EQ(parameter.decimals, other.decimals) << parameter.id;
    }
    const auto& kinds = fieldFilter().parameter("kind").options;
    const auto& fields = curveFilter().parameter("field").options;
    ASSERT_EQ(fields.size(), kinds.size() + 2);
    EXPECT_EQ(fields.front().id, "none");
    EXPECT_EQ(fields.back().id, kAutomaticField);
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        EXPECT_EQ(kinds[i].id, fields[i + 1].id);
        EXPECT_EQ(kinds[i].label, fields[i + 1].label);
        EXPECT_EQ(kinds[i].help, fields[i + 1].help);
    }
}

TEST(FilterDescription, FiltersThatUseCurvesSayTheSameOfTheSameParameters) {
    for (const FilterDescription* const filter :
         {&cutFilter(), &segmentFilter(), &offsetFilter(), &editFilter()}) {
        for (const ParameterDescription& parameter : imprintFilter().parameters) {
            const bool imprints = filter != &offsetFilter() && filter != &editFilter();
            if (!imprints && parameter.id == "snap") {
                continue;
            }
            const ParameterDescription& other = filter->parameter(parameter.id);
            EXPECT_EQ(parameter.label, other.label);
            EXPECT_EQ(parameter.help, other.help);
            EXPECT_EQ(parameter.group, other.group);
            EXPECT_EQ(parameter.defaultValue, other.defaultValue) << parameter.id;
            EXPECT_EQ(parameter.min, other.min) << parameter.id;
            EXPECT_EQ(parameter.max, other.max) << parameter.id;
        }
    }
}

TEST(FilterDescription, TheFitSaysTheSameOfParametersOfCurves) {
    for (const std::string& id : fittedParameters()) {
        const ParameterDescription& of = curveFilter().parameter(id);
        const ParameterDescription& here = fitFilter().parameter(id);
        EXPECT_EQ(of.help, here.help);
        EXPECT_EQ(of.group, here.group);
        EXPECT_EQ(of.defaultValue, here.defaultValue) << id;
        EXPECT_EQ(of.max, here.max) << id;
    }
}

TEST(FilterDescription, HasEightParametersAboveTheFoldAtMost) {
    const auto isShown = [](const ParameterDescription& parameter) {
        return !parameter.isFolded();
    };
    for (const FilterDescription& filter : parseFilterDescriptions(filterDescriptionsJson())) {
        const auto shown = std::ranges::count_if(filter.parameters, isShown);
        EXPECT_LE(shown, filter.id == fieldFilter().id ? 10 : 8) << filter.name;
    }
    EXPECT_TRUE(curveFilter().parameter("replace").isOfWindow());
    EXPECT_TRUE(cutFilter().parameter("split").isOnInWindow);
    EXPECT_FALSE(segmentFilter().parameter("split").isOnInWindow);
    EXPECT_TRUE(curveFilter().parameter("picks").isFolded());
    EXPECT_FALSE(curveFilter().parameter("picks").isAdvanced());
}

TEST(Labels, TakeThePlaceOfIds) {
    EXPECT_EQ(
        withLabels("picks_layer: layer \"a\" has faces; give picks_file.", curveFilter()),
        "\"Picks: layer\": layer \"a\" has faces; give \"Picks: file\"."
    );
    const std::string unchanged =
        "µ is 7, x_picks_file and picks_files are none of ours, nor degree";
    EXPECT_EQ(withLabels(unchanged, curveFilter()), unchanged);
    EXPECT_EQ(withLabels("", curveFilter()), "");
    EXPECT_EQ(withLabels("tube_radius", curveFilter()), "\"Radius of the tube\"");
}

TEST(FilterDescription, BecomesHtml) {
    FilterDescription filter = parsed(smallDescription());
    filter.longDescriptionMarkdown = "From *A > B* & `c`.\n\nMore.";
    EXPECT_EQ(
        descriptionHtml(filter),
        "From <i>A &gt; B</i> &amp; <i>c</i>.<br>More.<br>See:<br><a "
        "href=\"https://example.org\"><b>\"T\"</b></a><br>C, 2001."
    );
}

TEST(ParameterValues, AreTheDefaultsUntilTheyAreSet) {
    const FilterDescription filter = parsed(smallDescription());
    ParameterValues values(filter);
    EXPECT_EQ(values.get<int>("n"), 2);
    EXPECT_EQ(values.get<std::string>("e"), "a");
    values.set("n", 3);
    values.setOption("e", 1);
    EXPECT_EQ(values.get<int>("n"), 3);
    EXPECT_EQ(values.get<std::string>("e"), "b");
}

TEST(ParameterValues, RefuseOptionsThatDoNotExistByNamingThoseThatDo) {
    const FilterDescription filter = parsed(smallDescription());
    ParameterValues values(filter);
    for (const auto& attempt : {
             std::function<void()>([&] { values.set("e", std::string("c")); }),
             std::function<void()>([&] { values.setOption("e", 2); }),
             std::function<void()>([&] { values.setOption("e", -1); }),
         }) {
        try {
            attempt();
            ADD_FAILURE() << "accepted";
        } catch (const InputError& error) {
            EXPECT_EQ(error.code(), InputErrorCode::BadOption);
            EXPECT_STREQ(error.what(), "e must be one of: a, b");
        }
    }
    EXPECT_EQ(values.get<std::string>("e"), "a");
}

TEST(ParameterValues, AreOfTheParametersType) {
    const FilterDescription filter = parsed(smallDescription());
    ParameterValues values(filter);
    EXPECT_THROW(values.set("n", 2.0), std::invalid_argument);
    EXPECT_THROW(values.set("m", 2), std::out_of_range);
    EXPECT_THROW(static_cast<void>(values.value("m")), std::out_of_range);
}

}  // namespace
}  // namespace bspline_curve

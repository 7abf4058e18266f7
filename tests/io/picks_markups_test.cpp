// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/files.h"
#include "io/temporary_files.h"

namespace bspline_curve::io_tests {

namespace {

const std::string kPoints =
    R"("controlPoints": [{"id": "1", "label": "F-1", "position": [1, 2, 3]},
    {"position": [9, 9, 9], "positionStatus": "preview"},
    {"position": "", "positionStatus": "undefined"}, {"positionStatus": "missing"},
    {"position": [-0.5, 1e-3, 0], "orientation": [-1, 0, 0, 0, -1, 0, 0, 0, 1],
     "positionStatus": "defined"}])";
const std::vector<Vec3> kLps{{1, 2, 3}, {-0.5, 1e-3, 0}};
const std::vector<Vec3> kRas{{-1, -2, 3}, {0.5, -1e-3, 0}};

std::string file(const std::string& markups) {
    return R"({"@schema": "https://…/markups-schema-v1.0.3.json#", "markups": [)" + markups + "]}";
}

std::string markup(const std::string& type, const std::string& more = "") {
    return R"({"type": ")" + type + "\", " + more + kPoints + "}";
}

class PicksMarkups : public FileTest {
protected:
    PicksFile picks(const std::string& text) const { return readPicks(write("a.mrk.json", text)); }

    std::string refused(const std::string& text) const {
        const auto place = write("a.mrk.json", text);
        std::string message = refusal([&] { return readPicks(place); });
        expectContains(message, place.string());
        return message;
    }
};

}  // namespace

TEST_F(PicksMarkups, ReadsThePlacedPointsOfListsCurvesAndLines) {
    for (const auto& [type, closed] :
         {std::pair<std::string, std::optional<bool>>{"Fiducial", std::nullopt},
          {"Curve", false},
          {"Line", false},
          {"ClosedCurve", true}}) {
        const PicksFile result = picks(file(markup(type)));
        EXPECT_EQ(result.picks, kLps) << type;
        EXPECT_EQ(result.closed, closed) << type;
    }
    EXPECT_EQ(readPicks(write("a.json", file(markup("Curve")))).picks, kLps);
}

TEST_F(PicksMarkups, GivesPicksInLps) {
    const auto in = [&](const std::string& system) {
        return picks(file(markup("Curve", "\"coordinateSystem\": " + system + ", "))).picks;
    };
    EXPECT_EQ(in("\"LPS\""), kLps);
    EXPECT_EQ(in("\"1\""), kLps);
    EXPECT_EQ(in("1"), kLps);
    EXPECT_EQ(in("\"RAS\""), kRas);
    EXPECT_EQ(in("\"0\""), kRas);
    EXPECT_EQ(in("0"), kRas);
}

TEST_F(PicksMarkups, NumbersStayInTheUnitOfTheFile) {
    for (const std::string unit : {R"("mm")", R"("um")", R"(["mm", "UCUM", "millimeter"])"}) {
        EXPECT_EQ(picks(file(markup("Curve", "\"coordinateUnits\": " + unit + ", "))).picks, kLps);
    }
}

TEST_F(PicksMarkups, MarkupsWithoutPointsAndOfOtherTypesArePassedOver) {
    const std::string empty = R"({"type": "Curve", "controlPoints": []}, {"type": "Fiducial"}, )";
    EXPECT_EQ(picks(file(empty + markup("Plane") + ", " + markup("Fiducial"))).picks, kLps);
    expectContains(
        refused(file(empty + markup("Plane") + ", " + markup("ROI"))),
        "no Fiducial, Curve, ClosedCurve or Line with points but \"Plane\", \"ROI\""
    );
    expectContains(refused(file("")), "holds no picks");
}

TEST_F(PicksMarkups, RefusesSeveralMarkupsWithPoints) {
    expectContains(
        refused(file(markup("Fiducial") + ", " + markup("Plane") + ", " + markup("Curve"))),
        "among them markup 1 (Fiducial) and markup 3 (Curve): save the one"
    );
}

TEST_F(PicksMarkups, SaysWhatIsWrongAndWhere) {
    const auto points = [](const std::string& list) {
        return file(R"({"type": "Curve", "controlPoints": )" + list + "}");
    };
    expectContains(
        refused(file(markup("Curve", R"("coordinateSystem": "IJK", )"))),
        "markup 1: the coordinateSystem \"IJK\" is neither LPS nor RAS"
    );
    expectContains(
        refused(points(R"([{"position": [1, 2, 3]}, {"position": [1, 2]}])")),
        "markup 1, control point 2: its position is not [x, y, z] but \"[1,2]\""
    );
    expectContains(refused(points(R"([{"position": ""}])")), "control point 1: its position");
    expectContains(refused(points(R"([{"position": [1, 2, null]}])")), "[1,2,null]");
    expectContains(refused(points(R"([{"label": "F"}])")), "control point 1 has no position");
    expectContains(
        refused(points(R"([{"position": [1, 2, 3], "positionStatus": "lost"}])")), "\"lost\""
    );
    expectContains(
        refused(points(R"([{"position": [1, 2, 3], "positionStatus": 2}])")), "not a text"
    );
    expectContains(refused(points("[1]")), "control point 1 is not {");
    expectContains(refused(points("{}")), "\"controlPoints\" is not a list");
    expectContains(refused(file("7")), "markup 1 is not {");
    expectContains(refused(R"({"markups": {}})"), "\"markups\" is not a list");
    expectContains(refused(R"({"markups": [)"), "is not JSON");
}

}  // namespace bspline_curve::io_tests

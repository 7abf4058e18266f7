// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/files.h"
#include "io/temporary_files.h"

namespace bspline_curve::io_tests {

namespace {

class PicksReader : public FileTest {
protected:
    std::string refused(const std::string& name, std::string_view bytes) {
        const auto file = write(name, bytes);
        std::string message = refusal([&] { return readPicks(file); });
        expectContains(message, file.string());
        return message;
    }
};

const std::vector<Vec3> kPicks{{1, 2, 3}, {-0.5, 1e-3, 0}};

}  // namespace

TEST_F(PicksReader, ReadsPickPointsInAnyOrderOfAttributes) {
    const PicksFile file = readPicks(write(
        "a.pp",
        "<!DOCTYPE PickedPoints>\n<PickedPoints>\n <DocumentData>\n  <DateTime time=\"1\" "
        "date=\"2\"/>\n"
        "  <templateName name=\"none\"/>\n </DocumentData>\n"
        " <point x=\"1\" y=\"2\" z=\"3\" active=\"1\" name=\"0\"/>\n"
        " <!-- <point x=\"7\" y=\"7\" z=\"7\"/> -->\n"
        " <point name=\"a &lt; b\" active=\"0\" z=\"9\" y=\"9\" x=\"9\"/>\n"
        " <point name='1' active='1' z='0' y='0.001' x='-0.5'></point>\n</PickedPoints>\n"
    ));
    EXPECT_EQ(file.picks, kPicks);
    EXPECT_FALSE(file.closed.has_value());
}

TEST_F(PicksReader, RefusesWrongPickPointsWithTheLine) {
    expectContains(
        refused("a.pp", "<PickedPoints>\n <point x=\"1\" y=\"2\"/>\n</PickedPoints>"),
        "line 2: the point has no z"
    );
    expectContains(
        refused("b.pp", "<PickedPoints>\n\n <point x=\"1\" y=\"2\" z=\"x\"/>\n</PickedPoints>"),
        "line 3"
    );
    expectContains(
        refused("c.pp", "<PickedPoints>\n <point x=\"1\" y=\"2\" z=\"nan\"/>\n</PickedPoints>"),
        "finite"
    );
    expectContains(refused("d.pp", "<PickedPoints>\n <point x=\"1\"\n"), "XML");
    expectContains(refused("e.pp", "<html/>"), "PickedPoints");
    expectContains(refused("f.pp", "<PickedPoints/>"), "no picks");
}

TEST_F(PicksReader, ReadsCornersFromJson) {
    const std::string picks = R"({"picks": [[1, 2, 3], [-0.5, 1e-3, 0]], "corners": )";
    EXPECT_EQ(readPicks(write("a.json", picks + "[1, 0]}")).corners, (std::vector<int>{1, 0}));
    const std::string ofCurve =
        R"({"picks": {"points": [[1, 2, 3], [-0.5, 1e-3, 0]], "corners": [1]}, "corners": [7]})";
    EXPECT_EQ(readPicks(write("a.json", ofCurve)).corners, std::vector<int>{1});
    for (const char* const wrong : {"[2]}", "[-1]}", "[0.5]}", "1}", "\"all\"}"}) {
        expectContains(refused("a.json", picks + wrong), "corners");
    }
}

TEST_F(PicksReader, ReadsJsonAndWhetherItIsClosed) {
    const std::string picks = R"("picks": [[1, 2, 3], [-0.5, 1e-3, 0]])";
    EXPECT_EQ(readPicks(write("a.json", "{" + picks + "}")).picks, kPicks);
    EXPECT_FALSE(readPicks(write("a.json", "{" + picks + "}")).closed.has_value());
    EXPECT_EQ(
        readPicks(write("b.json", "{\"name\": \"x\", \"closed\": true, " + picks + "}")).closed,
        true
    );
    EXPECT_EQ(readPicks(write("c.json", "{\"closed\": false, " + picks + "}")).closed, false);
}

TEST_F(PicksReader, ReadsThePicksOfACurve) {
    const PicksFile file = readPicks(write(
        "a.json",
        R"({"closed": true, "picks": {"points": [[1, 2, 3], [-0.5, 1e-3, 0]], "faces": [1, 2]}})"
    ));
    EXPECT_EQ(file.picks, kPicks);
    EXPECT_EQ(file.closed, true);
}

TEST_F(PicksReader, RefusesWrongJson) {
    expectContains(refused("a.json", "{\"picks\": [[1, 2, 3],\n [1, 2]]}"), "pick 2");
    expectContains(refused("b.json", "{\"picks\": [[1, 2, \"3\"]]}"), "pick 1");
    expectContains(refused("i.json", R"({"picks": {"points": [[1, 2]]}})"), "pick 1");
    expectContains(refused("j.json", R"({"picks": {"points": 1}})"), "needs");
    expectContains(refused("c.json", "{\"picks\": \n[[1, 2, 3]"), "line 2");
    expectContains(refused("d.json", "{\"points\": []}"), "picks");
    expectContains(refused("e.json", "[[1, 2, 3]]"), "picks");
    expectContains(refused("f.json", "{\"picks\": []}"), "no picks");
    expectContains(refused("g.json", "{\"picks\": [[1, 2, 3]], \"closed\": 1}"), "closed");
    expectContains(refused("h.json", "{\"picks\": [[1, 2, 1e999]]}"), "");
}

TEST_F(PicksReader, ReadsXyzWithCommentsAndFurtherColumns) {
    EXPECT_EQ(
        readPicks(write("a.xyz", "# x y z\n1 2 3 0 0 1\n\n\t-0.5 1e-3  0 # second\r\n")).picks,
        kPicks
    );
    expectContains(refused("b.xyz", "1 2 3\n1 2\n"), "line 2");
    expectContains(refused("c.xyz", "1 2 three\n"), "\"three\"");
    expectContains(refused("d.xyz", "# nothing\n"), "no picks");
}

TEST_F(PicksReader, ReadsCsvOfEitherSeparator) {
    EXPECT_EQ(readPicks(write("a.csv", "1,2,3\n-0.5,1e-3,0\n")).picks, kPicks);
    EXPECT_EQ(readPicks(write("b.csv", "# picks\n1; 2; 3\n-0,5; 0,001; 0\n")).picks, kPicks);
    EXPECT_EQ(
        readPicks(write("c.csv", "name,Z,Y,X\r\na,3,2,1\r\nb,0,0.001,-0.5\r\n")).picks, kPicks
    );
    EXPECT_EQ(
        readPicks(write("d.csv", "\xEF\xBB\xBF\"x\",\"y\",\"z\"\n\"1\",\"2\",\"3\"\n-0.5,1e-3,0\n"))
            .picks,
        kPicks
    );
    EXPECT_EQ(
        readPicks(write("f.csv", "z,label,y,x\n3,\"a, b\",2,1\n0,\"say \"\"c\"\"\",0.001,-0.5\n"))
            .picks,
        kPicks
    );
    EXPECT_EQ(readPicks(write("e.csv", "x\ty\tz\n1\t2\t3\n-0.5\t1e-3\t0\n")).picks, kPicks);
}

TEST_F(PicksReader, ReadsListsOfOtherPrograms) {
    const std::string head = "# Markups fiducial file version = 4.11\n";
    const std::string columns = "# columns = id,x,y,z,ow,label\n";
    EXPECT_EQ(
        readPicks(write(
                      "a.fcsv",
                      head + "# CoordinateSystem = LPS\n" + columns +
                          "1,1,2,3,0,A\n2,-0.5,1e-3,0,0,B\n"
                  ))
            .picks,
        kPicks
    );
    EXPECT_EQ(
        readPicks(write("b.fcsv", head + "# CoordinateSystem = 0\n1,-1,-2,3\n2,0.5,-0.001,0\n"))
            .picks,
        kPicks
    );
    for (const char* const text :
         {"1,2,3\n-0.5,1e-3,0\n",
          "A-1,1,2,3\nA-2,-0.5,1e-3,0\n",
          "//X Y Z\n1 2 3 255\n-0.5 1e-3 0 255\n",
          "x y z\n1 2 3\n-0.5 1e-3 0\n",
          "1; 2; 3\n-0,5; 0,001; 0\n"}) {
        for (const char* const name : {"a.txt", "a.asc", "a.xyz"}) {
            EXPECT_EQ(readPicks(write(name, text)).picks, kPicks) << name << ": " << text;
        }
    }
    for (const char* const header :
         {"\"Points:0\",\"Points:1\",\"Points:2\"", "x [mm],y [mm],z [mm]", "X(mm),Y(mm),Z(mm)"}) {
        EXPECT_EQ(
            readPicks(write("a.csv", std::string(header) + "\n1,2,3\n-0.5,1e-3,0\n")).picks, kPicks
        ) << header;
    }
    EXPECT_EQ(readPicks(write("b.csv", "A-1,1,2,3\nA-2,-0.5,1e-3,0\n")).picks, kPicks);
    expectContains(refused("c.xyz", "0,1 0,2 0,3\n"), "write decimal points, not commas");
}

TEST_F(PicksReader, RefusesWrongCsvWithTheLine) {
    expectContains(refused("a.csv", "x,y,z\n1,2,3\n1,2\n"), "line 3");
    expectContains(refused("b.csv", "x,y,z\n1,2,c\n"), "\"c\"");
    expectContains(refused("c.csv", "x,y,w\n1,2,3\n"), "column \"z\"");
    expectContains(refused("d.csv", "x,y,z\n1,2,\n"), "line 2");
    expectContains(refused("e.csv", "1,2,inf\n"), "finite");
    expectContains(refused("f.csv", "x,y,z\n"), "no picks");
}

TEST_F(PicksReader, RefusesMissingEmptyAndUnknownFiles) {
    expectContains(refusal([&] { return readPicks(path("none.pp")); }), "no such file");
    expectContains(refused("a.doc", "1 2 3\n"), ".doc");
    for (const char* name : {"a.pp", "a.json", "a.xyz", "a.csv"}) {
        expectContains(refused(name, ""), "empty");
    }
}

TEST(PicksText, TakesSemicolonsOrLinesAndCommasBetweenCoordinates) {
    EXPECT_EQ(parsePicksText("1 2 3; -0.5 1e-3 0"), kPicks);
    EXPECT_EQ(parsePicksText("1, 2, 3\n-0.5,1e-3,0;\n"), kPicks);
    EXPECT_TRUE(parsePicksText("  ").empty());
}

TEST(PicksText, NamesThePickThatIsWrong) {
    expectContains(refusal([] { return parsePicksText("1 2 3; 1 2"); }), "pick 2");
    expectContains(refusal([] { return parsePicksText("1 2 3 4"); }), "pick 1");
    expectContains(refusal([] { return parsePicksText("1 2 x"); }), "\"x\"");
    expectContains(refusal([] { return parsePicksText("1 2 inf"); }), "finite");
}

}  // namespace bspline_curve::io_tests

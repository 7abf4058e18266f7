// SPDX-License-Identifier: GPL-3.0-or-later
// The font of a text for which none is given.
#include "io/font_search.h"

#include "io/environment_variable.h"
#include "io/temporary_files.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace bspline_curve::io_tests {

namespace {

using Paths = std::vector<std::filesystem::path>;

class FontSearch : public FileTest {
protected:
    /// Makes an empty file, and the folders that it is in.
    std::filesystem::path make(const std::string& name) const {
        std::filesystem::create_directories(path(name).parent_path());
        return write(name, "");
    }
};

TEST_F(FontSearch, TakesTheFirstWellKnownFontWhereverItIs) {
    make("first/arial.ttf");
    make("first/deep/NotoSans-Regular.ttf");
    const auto expected = make("second/truetype/liberation/LiberationSans-Regular.ttf");
    make("second/LiberationSans-Bold.ttf");
    EXPECT_EQ(findFont(Paths{path("first"), path("second")}), expected);
}

TEST_F(FontSearch, PrefersTheFirstFolderAndThereTheFirstPath) {
    const auto first = make("a/x/DejaVuSans.ttf");
    make("a/y/DejaVuSans.ttf");
    make("b/DejaVuSans.ttf");
    EXPECT_EQ(findFont(Paths{path("a"), path("b")}), first);
    EXPECT_EQ(findFont(Paths{path("b"), path("a")}), path("b/DejaVuSans.ttf"));
}

TEST_F(FontSearch, TakesUpperAndLowerCaseAsOne) {
    const auto font = make("fonts/ARIAL.TTF");
    EXPECT_EQ(findFont(Paths{path("fonts")}), font);
}

TEST_F(FontSearch, FindsNothingAmongOtherFilesAndInFoldersThatAreNot) {
    make("fonts/DejaVuSans-Oblique.ttf");
    make("fonts/DejaVuSans.txt");
    std::filesystem::create_directories(path("fonts/Arial.ttf"));  // a folder
    EXPECT_EQ(findFont(Paths{path("fonts"), path("missing")}), std::nullopt);
    EXPECT_EQ(findFont(Paths{}), std::nullopt);
}

TEST_F(FontSearch, GivesBackAFontThatIsGiven) {
    EXPECT_EQ(fontOrDefault("my own.otf"), "my own.otf");
}

#if !defined(_WIN32) && !defined(__APPLE__)

TEST_F(FontSearch, LooksWhereTheEnvironmentSays) {
    const Variable home("HOME", "/home/someone");
    const Variable roots("XDG_DATA_DIRS", "/opt/share::relative:/usr/share");
    const Variable own("XDG_DATA_HOME", "/data");
    EXPECT_EQ(
        fontFolders(),
        (Paths{
            "/opt/share/fonts",
            "/usr/share/fonts",
            "/data/fonts",
            "/home/someone/.local/share/fonts",
            "/home/someone/.fonts"
        })
    );
}

TEST_F(FontSearch, LooksWhereSystemsKeepFontsWhereTheEnvironmentSaysNothing) {
    const Variable home("HOME", nullptr);
    const Variable roots("XDG_DATA_DIRS", "");
    const Variable own("XDG_DATA_HOME", nullptr);
    EXPECT_EQ(fontFolders(), (Paths{"/usr/local/share/fonts", "/usr/share/fonts"}));
}

TEST_F(FontSearch, SaysWhatToDoWhereThereIsNone) {
    const auto nowhere = path("").string();
    const Variable home("HOME", nowhere.c_str());
    const Variable roots("XDG_DATA_DIRS", nowhere.c_str());
    const Variable own("XDG_DATA_HOME", nowhere.c_str());
    const auto said = refusal([] { return fontOrDefault({}); }, InputErrorCode::BadOption);
    EXPECT_NE(said.find("give a font file"), std::string::npos) << said;
    const auto font = make("fonts/arial.ttf");
    EXPECT_EQ(fontOrDefault({}), font);
}

#endif

}  // namespace

}  // namespace bspline_curve::io_tests

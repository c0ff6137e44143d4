#include "tests/core/sheet/fixed_lettering.h"
#include "texplorer/sheet/label_text.h"

#include <gmock/gmock.h>

namespace texplorer::label_text_test {
namespace {

using sheet_test::letterWidth;
using testing::ElementsAre;
using testing::IsEmpty;

int measured(std::string_view text) {
    return sheet_test::FixedLettering().width(sheet::TextRole::Label, text);
}

std::string shortened(std::string_view text, int letters) {
    return sheet::shortenedMiddle(text, letters * letterWidth, measured);
}

std::vector<std::string> lines(std::string_view text, int letters, std::size_t most) {
    return sheet::labelLines(text, letters * letterWidth, most, measured);
}

TEST(ShortenedLabel, KeepsItsBeginningAndItsEnd) {
    EXPECT_EQ(shortened("GL_NEAREST", 10), "GL_NEAREST");
    EXPECT_EQ(shortened("GL_NEAREST", 9), "GL_N…REST");
    EXPECT_EQ(shortened("GL_NEAREST", 7), "GL_…EST");
    EXPECT_EQ(shortened("GL_NEAREST", 6), "GL_…ST");
    EXPECT_EQ(shortened("GL_NEAREST", 2), "G…");
    EXPECT_EQ(shortened("GL_NEAREST", 1), "…");
    EXPECT_EQ(shortened("GL_NEAREST", 0), "…");
    EXPECT_EQ(shortened("", 0), "");
}

TEST(ShortenedLabel, CutsNoCharacter) {
    EXPECT_EQ(shortened("größe", 5), "größe");
    EXPECT_EQ(shortened("größe", 4), "gr…e");
    EXPECT_EQ(shortened("öäüß", 3), "ö…ß");
    EXPECT_EQ(shortened("a\xff\xfe\xfd z", 4), "a\xff…z"); // what is no UTF-8 stays what it is
}

TEST(BrokenLabel, BreaksBehindWhatJoinsWords) {
    EXPECT_THAT(lines("GL_LINEAR", 9, 2), ElementsAre("GL_LINEAR"));
    EXPECT_THAT(lines("GL_NEAREST_MIPMAP_LINEAR", 13, 2), ElementsAre("GL_NEAREST_", "MIPMAP_LINEAR"));
    EXPECT_THAT(lines("GL_NEAREST_MIPMAP_LINEAR", 18, 2), ElementsAre("GL_NEAREST_MIPMAP_", "LINEAR"));
    EXPECT_THAT(lines("Nearest texel, best level", 14, 2), ElementsAre("Nearest texel,", "best level"));
    EXPECT_THAT(lines("0.25,0.5,0.75,1", 9, 2), ElementsAre("0.25,0.5,", "0.75,1"));
}

TEST(BrokenLabel, ShortensWhatHasNoRoom) {
    EXPECT_THAT(lines("GL_NEAREST_MIPMAP_LINEAR", 12, 2), ElementsAre("GL_NEAREST_", "MIPMAP…INEAR"));
    EXPECT_THAT(lines("abcdefghij klm", 5, 2), ElementsAre("ab…ij", "klm"));
    EXPECT_THAT(lines("a b c d", 1, 3), ElementsAre("a", "b", "…"));
    EXPECT_THAT(lines("", 5, 2), IsEmpty());
    EXPECT_THAT(lines("abc", 5, 0), IsEmpty());
}

} // namespace
} // namespace texplorer::label_text_test

#include "texplorer/emit/excerpt.h"
#include "texplorer/emit/program.h"
#include "texplorer/scene/scene.h"

#include <gmock/gmock.h>

namespace texplorer::excerpt_test {
namespace {

using emit::Line;
using emit::Part;
using testing::ElementsAre;
using testing::IsEmpty;

Line heading(const std::string& text, int depth = 0) {
    Line line{{{Part::Kind::Comment, text}}};
    line.heading = true;
    line.depth = depth;
    return line;
}
Line remark(const std::string& text) {
    return {{{Part::Kind::Plain, "    "}, {Part::Kind::Comment, text}}, true, false, 1};
}
Line call(const std::string& name, const std::string& path) {
    return {{{Part::Kind::Plain, "    "}, {Part::Kind::Call, name, path}, {Part::Kind::Plain, ");"}},
            true,
            false,
            1};
}

std::vector<std::string> textsOf(const emit::Excerpt& excerpt) {
    std::vector<std::string> texts;
    for (const Line& line : excerpt.lines)
        texts.push_back(textOf(line));
    return texts;
}

const std::vector<Line>& program() {
    static const std::vector<Line> lines = [] {
        std::vector<Line> made{heading("/* texture */"),
                               {{{Part::Kind::Plain, "static void load(void)"}}},
                               remark("/* to the left */"),
                               call("wrap(", "textures[0].wrapS"),
                               call("name(", "textures[0].wrapSome"),
                               heading("/* a frame */"),
                               call("corner(", "models[0].texCoords0[2]"),
                               call("corner(", "models[0].texCoords0[3]")};
        made.insert(made.begin() + 4, call("hidden(", "textures[0].wrapS"));
        made[4].needed = false;
        return made;
    }();
    return lines;
}

TEST(Excerpts, AreTheLinesAboutAParameterBelowTheirHeadings) {
    EXPECT_THAT(textsOf(excerptOf(program(), {"textures[0].wrapS"}, 9)),
                ElementsAre("/* texture */", "/* to the left */", "wrap();"));
    EXPECT_THAT(textsOf(excerptOf(program(), {"textures[0].wrapS", "models[0].texCoords0"}, 9)),
                ElementsAre("/* texture */", "/* to the left */", "wrap();", "", "/* a frame */", "corner();",
                            "corner();"));
    EXPECT_THAT(textsOf(excerptOf(program(), {"view.distance"}, 9)), IsEmpty());
}

TEST(Excerpts, SayHowManyLinesAreTooMany) {
    const emit::Excerpt excerpt = excerptOf(program(), {"textures[0].wrapS", "models[0].texCoords0"}, 1);
    EXPECT_THAT(textsOf(excerpt), ElementsAre("/* texture */", "/* to the left */", "wrap();"));
    EXPECT_EQ(excerpt.left, 2U);
}

TEST(Excerpts, HaveFourOfMoreOfTheSame) {
    std::vector<Line> lines{heading("/* a shape */")};
    for (int i = 0; i < 9; ++i)
        lines.push_back(call("corner(", "models[0].texCoords0[" + std::to_string(i) + "]"));
    lines.push_back(call("wrap(", "textures[0].wrapS"));
    const emit::Excerpt excerpt = excerptOf(lines, {"textures[0].wrapS", "models[0].texCoords0"}, 9);
    EXPECT_THAT(textsOf(excerpt),
                ElementsAre("/* a shape */", "corner();", "corner();", "corner();", "corner();", "wrap();"));
    EXPECT_EQ(excerpt.left, 5U);
}

TEST(Excerpts, AreWhatTheProgramBeforeHasNot) {
    std::vector<Line> before = program();
    before[3] = call("before(", "textures[0].wrapS");
    EXPECT_THAT(textsOf(newIn(program(), before, 9)),
                ElementsAre("/* texture */", "/* to the left */", "wrap();"));
    EXPECT_THAT(textsOf(newIn(program(), program(), 9)), IsEmpty());
    EXPECT_THAT(textsOf(newIn(program(), {}, 9)), IsEmpty());
}

TEST(Excerpts, SayEachWordOnceAndTakeNoHeadingOfOthersForVariables) {
    const std::vector<Line> lines{
        heading("/* functions */"),         {{{Part::Kind::Number, "distance = 1;", "view.distance"}}},
        heading("/* texture 0 */"),         remark("/* to the left */"),
        call("wrap(", "textures[0].wrapS"), heading("/* texture 1 */"),
        remark("/* to the left */"),        call("wrap(", "textures[1].wrapS")};
    EXPECT_THAT(textsOf(excerptOf(lines, {"view.distance", "textures[0].wrapS", "textures[1].wrapS"}, 9)),
                ElementsAre("distance = 1;", "", "/* texture 0 */", "    /* to the left */", "    wrap();",
                            "", "/* texture 1 */", "    wrap();"));
}

TEST(Excerpts, LoseWhatAllAreIndentedBy) {
    const std::vector<Line> lines{heading("    /* unit 0 */", 1), call("one(", "a.b"), call("two(", "a.b")};
    EXPECT_THAT(textsOf(excerptOf(lines, {"a"}, 9)), ElementsAre("/* unit 0 */", "one();", "two();"));
}

TEST(Excerpts, OfAProgramAreLinesOfItsText) {
    emit::TextureCodes codes;
    const auto lines = emit::program(emit::Flavour::Fixed, defaultScene(), {},
                                     {.explained = {"textures[0].minFilter"}}, codes);
    ASSERT_TRUE(lines);
    const std::vector<std::string> texts = textsOf(excerptOf(*lines, {"textures[0].minFilter"}, 9));
    ASSERT_EQ(texts.size(), 3U);
    EXPECT_EQ(texts[2], "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);");
    for (const std::string& each : texts)
        EXPECT_NE(textOf(*lines, false).find(each + "\n"), std::string::npos) << each;
}

} // namespace
} // namespace texplorer::excerpt_test

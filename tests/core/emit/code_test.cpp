#include "texplorer/emit/code.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace texplorer::code_test {
namespace {

using emit::Line;
using emit::Part;
using testing::ElementsAre;

Line lineOf(const std::string& text) {
    return {{{Part::Kind::Plain, text}}};
}

std::vector<std::string> textsOf(const std::vector<std::vector<Part>>& rows) {
    std::vector<std::string> texts;
    for (const std::vector<Part>& row : rows)
        texts.push_back(textOf(Line{row}));
    return texts;
}

std::vector<std::string> wrap(const std::string& text, std::size_t columns) {
    return textsOf(emit::wrapped(lineOf(text), columns));
}

TEST(WrappedCode, BreaksAfterCommasAndKeepsNumbersTogether) {
    EXPECT_THAT(wrap("glEnable(GL_BLEND);", 40), ElementsAre("glEnable(GL_BLEND);"));
    EXPECT_THAT(wrap("glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);", 40),
                ElementsAre("glTexParameteri(GL_TEXTURE_2D,", "    GL_TEXTURE_WRAP_S, GL_REPEAT);"));
    EXPECT_THAT(wrap("GLfloat ambient[] = {0.5f, 0.5f, 0.5f, 1.0f};", 40),
                ElementsAre("GLfloat ambient[] =", "    {0.5f, 0.5f, 0.5f, 1.0f};"));
    EXPECT_THAT(wrap(std::string(100, 'x'), 20), ElementsAre(std::string(100, 'x')));
}

TEST(WrappedCode, BreaksCommentsAfterWords) {
    EXPECT_THAT(wrap("/* one two three four five */", 16),
                ElementsAre("/* one two three", "    four five */"));
}

TEST(WrappedCode, IndentsWhatIsIndentedFurther) {
    EXPECT_THAT(wrap("    glTexCoord2f(0.0f, 1.0f); glVertex3f(1.0f, 1.0f, 1.0f);", 40),
                ElementsAre("    glTexCoord2f(0.0f, 1.0f);", "        glVertex3f(1.0f, 1.0f, 1.0f);"));
}

TEST(WrappedCode, LosesNothingAndCutsNoValue) {
    const Line line{{{Part::Kind::Call, "glTexParameterfv"},
                     {Part::Kind::Plain, "(GL_TEXTURE_2D, "},
                     {Part::Kind::Choice, "GL_TEXTURE_BORDER_COLOR", "textures[0].borderColor"},
                     {Part::Kind::Plain, ", {"},
                     {Part::Kind::Number, "0.25f", "textures[0].borderColor", 0},
                     {Part::Kind::Plain, ", "},
                     {Part::Kind::Number, "1.0f", "textures[0].borderColor", 1},
                     {Part::Kind::Plain, "});"}}};
    for (std::size_t columns = 0; columns < 100; ++columns) {
        std::string joined;
        std::vector<Part> values;
        for (const std::vector<Part>& row : emit::wrapped(line, columns)) {
            const std::string text = textOf(Line{row});
            joined += (joined.ends_with(',') ? " " : "") + text.substr(text.find_first_not_of(' '));
            std::ranges::copy_if(row, std::back_inserter(values),
                                 [](const Part& part) { return !part.path.empty(); });
        }
        EXPECT_EQ(joined, textOf(line)) << columns;
        EXPECT_THAT(values, ElementsAre(line.parts[2], line.parts[4], line.parts[6])) << columns;
    }
}

TEST(CodeText, LeavesOutWhatIsNotNeeded) {
    Line heading = lineOf("/* unit 0 */");
    heading.heading = true;
    Line idle = lineOf("glDisable(GL_BLEND);");
    idle.needed = false;
    const std::vector<Line> lines{lineOf("glEnable(GL_FOG);"), heading, idle};
    EXPECT_EQ(textOf(lines, false), "glEnable(GL_FOG);\n\n/* unit 0 */\n");
    EXPECT_EQ(textOf(lines, true), "glEnable(GL_FOG);\n\n/* unit 0 */\nglDisable(GL_BLEND);\n");
    EXPECT_FALSE(mentions(idle, ""));
}

} // namespace
} // namespace texplorer::code_test

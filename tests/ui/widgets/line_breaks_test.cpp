#include "app/ui/widgets/line_breaks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace texplorer::ui::line_breaks_test {
namespace {

using testing::ElementsAre;

/// A typewriter's: one for what is a byte or two in UTF-8, two for what is longer, as an ideograph is.
float typed(std::string_view text) {
    float width = 0;
    for (const char letter : text) {
        const auto byte = static_cast<unsigned char>(letter);
        width += byte < 0x80 || (byte >= 0xC0 && byte < 0xE0) ? 1.0F : byte >= 0xE0 ? 2.0F : 0.0F;
    }
    return width;
}

std::vector<std::string> lines(std::string_view text, float room) {
    std::vector<std::string> found;
    for (const std::string_view line : linesOf(text, room, typed))
        found.emplace_back(line);
    return found;
}

TEST(LineBreaks, WordsArePartedAtBlanksWhichGo) {
    EXPECT_THAT(lines("one two three", 7), ElementsAre("one two", "three"));
    EXPECT_THAT(lines("one two three", 6), ElementsAre("one", "two", "three"));
    EXPECT_THAT(lines("one two", 7), ElementsAre("one two"));
    EXPECT_THAT(lines("one two ", 7), ElementsAre("one two"));
    EXPECT_THAT(lines("a.b, c;d", 5), ElementsAre("a.b,", "c;d")) << "not within a.b";
}

TEST(LineBreaks, LineEndsStayAndSoDoEmptyLines) {
    EXPECT_THAT(lines("a\nb", 9), ElementsAre("a", "b"));
    EXPECT_THAT(lines("a\n\nb", 9), ElementsAre("a", "", "b"));
    EXPECT_THAT(lines("a\n", 9), ElementsAre("a", ""));
    EXPECT_THAT(lines("", 9), ElementsAre(""));
    EXPECT_THAT(lines("  a b", 4), ElementsAre("  a", "b")) << "what is indented stays so";
}

TEST(LineBreaks, IdeographsArePartedAnywhere) {
    EXPECT_THAT(lines("纹理坐标", 4), ElementsAre("纹理", "坐标"));
    EXPECT_THAT(lines("纹理坐标", 5), ElementsAre("纹理", "坐标"));
    EXPECT_THAT(lines("用 GL_LINEAR 过滤纹理", 12), ElementsAre("用 GL_LINEAR", "过滤纹理"));
    EXPECT_THAT(lines("纹理texture坐标", 11), ElementsAre("纹理texture", "坐标"));
    EXPECT_THAT(lines("纹理texture坐标", 10), ElementsAre("纹理", "texture坐", "标"));
}

// 避头尾: GB/T 15834-2011, 5.1.2 to 5.1.4.
TEST(LineBreaks, NoLineBeginsWithAMarkThatEndsSomething) {
    EXPECT_THAT(lines("放大时，取", 6), ElementsAre("放大", "时，取")) << "the letter before it comes along";
    EXPECT_THAT(lines("放大时，取", 8), ElementsAre("放大时，", "取"));
    for (const std::string mark : {"，", "。", "、", "；", "：", "！", "？", "）", "》", "」", "”", "’"})
        EXPECT_THAT(lines("放大时" + mark, 6).back().find(mark), 3U) << mark << " stands behind a letter";
    EXPECT_THAT(lines("用（括号）。", 10), ElementsAre("用（括", "号）。")) << "two marks in a row";
    EXPECT_THAT(lines("up to 87 %", 9), ElementsAre("up to", "87 %"));
    EXPECT_THAT(lines("точка — цвет", 8), ElementsAre("точка —", "цвет")) << "nor with a dash";
}

TEST(LineBreaks, NoLineEndsWithAMarkThatOpensSomething) {
    EXPECT_THAT(lines("看（图）", 4), ElementsAre("看", "（图", "）")) << "a mark that has no room at all";
    EXPECT_THAT(lines("看见（图）", 6), ElementsAre("看见", "（图）"));
    EXPECT_THAT(lines("看“图”吧", 6), ElementsAre("看", "“图”", "吧"));
    EXPECT_THAT(lines("书名《红》", 6), ElementsAre("书名", "《红》"));
}

TEST(LineBreaks, WhatIsWiderThanTheColumnIsPartedWhereItMustBe) {
    EXPECT_THAT(lines("abcdefgh", 3), ElementsAre("abc", "def", "gh"));
    EXPECT_THAT(lines("a bcdefg h", 3), ElementsAre("a", "bcd", "efg", "h"));
    EXPECT_THAT(lines("abc", 0), ElementsAre("a", "b", "c")) << "a letter in each at least";
    EXPECT_THAT(lines("жук", 1), ElementsAre("ж", "у", "к")) << "no half of a letter";
}

TEST(LineBreaks, TheWidestPieceIsWhatMustStayTogether) {
    EXPECT_EQ(widestPiece("a window shows", typed), 6);
    EXPECT_EQ(widestPiece("", typed), 0);
    EXPECT_EQ(widestPiece("纹理，坐标", typed), 4) << "the comma stays with the letter before it";
}

TEST(LineBreaks, WhatIsNoUtf8ComesThrough) {
    const std::string broken = "a\xE7\xBA b\xFF\xC3";
    std::string joined;
    for (const std::string& line : lines(broken, 2))
        joined += line;
    EXPECT_EQ(joined, "a\xE7\xBA"
                      "b\xFF\xC3");
}

} // namespace
} // namespace texplorer::ui::line_breaks_test

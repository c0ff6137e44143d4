#include "texplorer/text/name_pattern.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

namespace texplorer::name_pattern_test {
namespace {

std::string filled(std::string_view text, const std::map<std::string, std::string>& values) {
    const Result<NamePattern> pattern = NamePattern::parse(text);
    return pattern ? pattern->fill([&](const std::string& place) { return values.at(place); })
                   : pattern.error().message.english();
}

TEST(NamePattern, FillsEachPlace) {
    EXPECT_EQ(filled("out/{a}-{b}{a}.png", {{"a", "one"}, {"b", "2"}}), "out/one-2one.png");
    EXPECT_EQ(filled("{textures[0].minFilter}.png", {{"textures[0].minFilter", "GL_LINEAR"}}),
              "GL_LINEAR.png");
    EXPECT_EQ(filled("plain.png", {}), "plain.png");
    EXPECT_EQ(filled("", {}), "");
}

TEST(NamePattern, DoubledBracesAreBraces) {
    EXPECT_EQ(filled("{{a}}.png", {}), "{a}.png");
    EXPECT_EQ(filled("{{{a}}}", {{"a", "1"}}), "{1}");
    EXPECT_EQ(filled("a}b", {}), "a}b");
}

TEST(NamePattern, NamesItsPlacesOnce) {
    EXPECT_THAT(NamePattern::parse("{b}{a}x{b}")->places(), testing::ElementsAre("b", "a"));
    EXPECT_THAT(NamePattern::parse("{{b}}")->places(), testing::IsEmpty());
}

TEST(NamePattern, APlaceThatIsNoneIsRefused) {
    for (const char* text : {"{", "a{b", "{}.png", "{a}{", "{{{"}) {
        const Result<NamePattern> pattern = NamePattern::parse(text);
        ASSERT_FALSE(pattern) << text;
        EXPECT_EQ(pattern.error().message,
                  "expected a name and } after each {, found \"" + std::string(text) + "\"; {{ is a brace");
    }
}

struct Part {
    const char* name;
    std::string value;
    std::string part;
};

class FileNamePart : public testing::TestWithParam<Part> {};

TEST_P(FileNamePart, LeadsNowhereElse) {
    EXPECT_EQ(fileNamePart(GetParam().value), GetParam().part);
}

INSTANTIATE_TEST_SUITE_P(
    All, FileNamePart,
    testing::Values(Part{"Enumerant", "GL_LINEAR_MIPMAP_LINEAR", "GL_LINEAR_MIPMAP_LINEAR"},
                    Part{"Colour", "0.5,-1,1e-05,1", "0.5,-1,1e-05,1"}, Part{"Above", "../../x", "_._.._x"},
                    Part{"Dots", "..", "_."}, Part{"Hidden", ".profile", "_profile"},
                    Part{"Root", "/etc/passwd", "_etc_passwd"}, Part{"Empty", "", "_"},
                    Part{"Markup", "<script>", "_script_"}, Part{"Letters", "größe 日本", "größe_日本"},
                    Part{"Control", std::string("a\n\x1b\0b", 5), "a___b"},
                    Part{"NoUtf8", "a\xff\x80", "a__"}, Part{"Direction", "a\u202eb", "a_b"},
                    Part{"Long", std::string(300, 'x'), std::string(100, 'x')},
                    Part{"LongLetters", std::string(99, 'x') + "ö", std::string(99, 'x')}),
    [](const auto& test) { return std::string(test.param.name); });

} // namespace
} // namespace texplorer::name_pattern_test

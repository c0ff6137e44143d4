#include "texplorer/text/printable.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace texplorer::printable_test {
namespace {

struct Row {
    const char* name;
    std::string text;
    std::string shown;
};

class Printable : public testing::TestWithParam<Row> {};

TEST_P(Printable, SteersNothing) {
    EXPECT_EQ(printable(GetParam().text), GetParam().shown);
}

// The bytes of the characters are written down by hand from RFC 3629.
INSTANTIATE_TEST_SUITE_P(
    Rows, Printable,
    testing::Values(Row{"Empty", "", ""}, Row{"Ascii", "a file ~/x.png", "a file ~/x.png"},
                    Row{"Letters", "Grüße, 日本, 🂡", "Grüße, 日本, 🂡"},
                    Row{"Colour", "\x1B[31mred.png", "\\u001b[31mred.png"},
                    Row{"Lines", "one\ntwo\r\tthree", "one\\u000atwo\\u000d\\u0009three"},
                    Row{"Nul", std::string("a\0b", 3), "a\\u0000b"}, Row{"Bell", "\a", "\\u0007"},
                    Row{"Delete", "\x7F", "\\u007f"},
                    Row{"C1", "\xC2\x80\xC2\x9B\xC2\x9F", "\\u0080\\u009b\\u009f"},
                    Row{"NoBreakSpaceStays", "\xC2\xA0", "\xC2\xA0"},
                    Row{"Override", "gpj.\xE2\x80\xAEx.png", "gpj.\\u202ex.png"},
                    Row{"Isolates", "\xE2\x81\xA6\xE2\x81\xA9", "\\u2066\\u2069"},
                    Row{"Marks", "\xE2\x80\x8E\xE2\x80\x8F\xD8\x9C", "\\u200e\\u200f\\u061c"},
                    Row{"Separators", "\xE2\x80\xA8\xE2\x80\xA9", "\\u2028\\u2029"},
                    Row{"JoinersStay", "\xE2\x80\x8D", "\xE2\x80\x8D"},
                    Row{"BareContinuation",
                        "\x9B"
                        "31m",
                        "\xEF\xBF\xBD"
                        "31m"},
                    Row{"Latin1", "caf\xE9.png", "caf\xEF\xBF\xBD.png"},
                    Row{"CutAtTheEnd", "\xE2\x80", "\xEF\xBF\xBD\xEF\xBF\xBD"},
                    Row{"LongerThanNeeded", "\xC0\x9B", "\xEF\xBF\xBD\xEF\xBF\xBD"},
                    Row{"LongerThanNeededOfThree", "\xE0\x82\x9B", "\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD"},
                    Row{"Surrogate", "\xED\xA0\x80", "\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD"},
                    Row{"BeyondUnicode", "\xF4\x90\x80\x80",
                        "\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD"},
                    Row{"LastCharacter", "\xF4\x8F\xBF\xBF", "\xF4\x8F\xBF\xBF"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(PrintableLines, AreKeptWhereTheTextHasSeveral) {
    EXPECT_EQ(printable("one\ttwo\n\rthree\x1B", LineBreaks::Keep), "one\ttwo\n\\u000dthree\\u001b");
}

TEST(PrintableJson, StaysTheSameJson) {
    const nlohmann::json document{{"k\x7F\n", "\x1B[31m \xC2\x9B \xE2\x80\xAE Grüße \\u001b"}};
    const std::string shown = printable(document.dump(2), LineBreaks::Keep);
    EXPECT_EQ(nlohmann::json::parse(shown), document);
    EXPECT_EQ(shown.find('\x7F'), std::string::npos);
    EXPECT_EQ(shown.find("\xC2\x9B"), std::string::npos);
    EXPECT_EQ(shown.find("\xE2\x80\xAE"), std::string::npos);
}

} // namespace
} // namespace texplorer::printable_test

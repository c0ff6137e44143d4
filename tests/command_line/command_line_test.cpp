#include "app/command_line/command_line.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>

namespace texplorer::command_line_test {
namespace {

using testing::ElementsAre;

/// A program that has an option of each kind.
struct Painter {
    CommandLine line{"painter", "1.2.3", "Paints."};
    std::string color = "red";
    std::string frame;
    std::string canvas;
    std::vector<std::string> layers;
    std::vector<std::string> tags;
    std::uint8_t coats = 2;
    bool varnish = false;
    bool matt = false;
    const Option* colorOption = nullptr;
    const Option* coatsOption = nullptr;

    Painter() {
        line.option("CANVAS", canvas, "What is painted on.", {.required = true});
        colorOption = &line.option("-c,--color", color, "Of the paint.",
                                   {.value = "NAME",
                                    .environment = "PAINTER_COLOR",
                                    .showsDefault = true,
                                    .check = [](const auto& text) {
                                        return text == "none"
                                                   ? std::string("expected a colour, found \"none\"")
                                                   : std::string();
                                    }});
        coatsOption = &line.number("--coats", coats, 1, 255, "How many.", {.showsDefault = true});
        line.option("--layer", layers, "One of them.", {.value = "LAYER", .oneEach = true});
        line.option("--tag", tags, "Some of them.", {.value = "TAG"});
        const Option& varnished = line.flag("--varnish", varnish, "Then varnishes.");
        line.flag("--matt", matt, "Without a gloss.", {.excludes = &varnished});
        line.option("--frame", frame, "Around the varnished picture.",
                    {.value = "WOOD", .needs = &varnished});
        line.footer("Exit status: 0.");
    }

    Result<std::optional<std::string>> parse(std::vector<const char*> words) {
        words.insert(words.begin(), "painter");
        return line.parse(static_cast<int>(words.size()), words.data());
    }
};

TEST(CommandLine, WhatIsGivenReplacesWhatWasThere) {
    Painter painter;
    const auto parsed = painter.parse({"linen", "-c", "blue", "--coats=255", "--varnish", "--frame", "oak"});
    ASSERT_TRUE(parsed) << parsed.error().message;
    EXPECT_FALSE(*parsed);
    EXPECT_EQ(painter.canvas, "linen");
    EXPECT_EQ(painter.color, "blue");
    EXPECT_EQ(painter.coats, 255);
    EXPECT_TRUE(painter.varnish);
    EXPECT_EQ(painter.frame, "oak");
}

TEST(CommandLine, WhatIsNotGivenStays) {
    Painter painter;
    ASSERT_TRUE(painter.parse({"linen"}));
    EXPECT_EQ(painter.color, "red");
    EXPECT_EQ(painter.coats, 2);
    EXPECT_FALSE(painter.varnish);
    EXPECT_FALSE(painter.colorOption->isGiven());
}

TEST(CommandLine, AListTakesOneEachOrAllThatFollow) {
    Painter painter;
    ASSERT_TRUE(painter.parse({"--layer", "a", "linen", "--layer", "b", "--tag", "c", "d"}));
    EXPECT_THAT(painter.layers, ElementsAre("a", "b"));
    EXPECT_THAT(painter.tags, ElementsAre("c", "d"));
    EXPECT_EQ(painter.canvas, "linen");
}

TEST(CommandLine, AVariableOfTheEnvironmentIsAValueAndNotGiven) {
    ::setenv("PAINTER_COLOR", "green", 1);
    Painter asked;
    Painter told;
    const bool asksWell = asked.parse({"linen"}).has_value();
    const bool toldWell = told.parse({"linen", "--color", "blue"}).has_value();
    const bool askedIsGiven = asked.colorOption->isGiven();
    const bool toldIsGiven = told.colorOption->isGiven();
    ::unsetenv("PAINTER_COLOR");
    ASSERT_TRUE(asksWell && toldWell);
    EXPECT_EQ(asked.color, "green");
    EXPECT_FALSE(askedIsGiven);
    EXPECT_EQ(told.color, "blue");
    EXPECT_TRUE(toldIsGiven);
}

TEST(CommandLine, AnOptionIsCalledByTheLongerOfItsNames) {
    Painter painter;
    EXPECT_EQ(painter.colorOption->name(), "--color");
    EXPECT_EQ(painter.coatsOption->name(), "--coats");
    EXPECT_EQ(painter.line.options().size(), 8U);
}

TEST(CommandLine, HelpIsFilledUpTo80ColumnsAndNamesWhatIsTaken) {
    const auto help = Painter().parse({"--help"});
    ASSERT_TRUE(help && *help);
    EXPECT_EQ(**help, R"(Paints.
Usage: painter [OPTIONS] CANVAS

Positionals:
  CANVAS                  What is painted on.

Options:
  -h,--help               Print this help message and exit
  --version               Display program version information and exit
  -c,--color NAME         Of the paint. Default: red. The environment variable
                          PAINTER_COLOR does the same.
  --coats NUMBER          How many. From 1 to 255. Default: 2.
  --layer LAYER           One of them.
  --tag TAG               Some of them.
  --varnish               Then varnishes.
  --matt                  Without a gloss.
  --frame WOOD            Around the varnished picture.

Exit status: 0.
)");
}

TEST(CommandLine, TheVersionIsTheProgramsNameAndItsNumber) {
    const auto version = Painter().parse({"--version"});
    ASSERT_TRUE(version && *version);
    EXPECT_EQ(**version, "painter 1.2.3\n");
}

struct WrongCall {
    const char* name;
    std::vector<const char*> words;
    const char* sentence;
};

class WrongCalls : public testing::TestWithParam<WrongCall> {};

TEST_P(WrongCalls, GetOneSentence) {
    const auto parsed = Painter().parse(GetParam().words);
    ASSERT_FALSE(parsed);
    EXPECT_EQ(parsed.error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(describe(parsed.error()), GetParam().sentence);
}

INSTANTIATE_TEST_SUITE_P(
    Each, WrongCalls,
    testing::Values(
        WrongCall{"Nothing", {}, "CANVAS is required"},
        WrongCall{"Unknown", {"linen", "--oil"}, "there is no option --oil; see painter --help"},
        WrongCall{
            "OneMore", {"linen", "silk"}, "expected no further argument, found \"silk\"; see painter --help"},
        WrongCall{"NoValue", {"linen", "--color"}, "--color: expected a value, found none"},
        WrongCall{"Refused", {"linen", "--color", "none"}, "--color: expected a colour, found \"none\""},
        WrongCall{"TooFew",
                  {"linen", "--coats", "0"},
                  "--coats: expected a whole number from 1 to 255, found \"0\""},
        WrongCall{"TooMany",
                  {"linen", "--coats", "256"},
                  "--coats: expected a whole number from 1 to 255, found \"256\""},
        WrongCall{"NoNumber",
                  {"linen", "--coats", "2x"},
                  "--coats: expected a whole number from 1 to 255, found \"2x\""},
        WrongCall{"TooLarge",
                  {"linen", "--coats", "99999999999999999999"},
                  "--coats: expected a whole number from 1 to 255, found \"99999999999999999999\""},
        WrongCall{"Needs", {"linen", "--frame", "oak"}, "--frame requires --varnish"},
        WrongCall{"Excludes", {"linen", "--matt", "--varnish"}, "--varnish excludes --matt"}),
    [](const auto& each) { return std::string(each.param.name); });

/// A program with two commands.
struct Kitchen {
    CommandLine line{"kitchen", "1.0.0", "Cooks."};
    bool salt = false;

    Kitchen() {
        Command& boil = line.command("boil", "In water.");
        boil.flag("--salt", salt, "In it.");
        boil.onCall([this] { return salt ? 3 : 4; });
        line.command("fry", "In oil.").onCall([] { return 5; });
    }

    Result<std::optional<std::string>> parse(std::vector<const char*> words) {
        words.insert(words.begin(), "kitchen");
        return line.parse(static_cast<int>(words.size()), words.data());
    }
};

TEST(CommandLine, TheCommandThatIsCalledRuns) {
    Kitchen salted;
    ASSERT_TRUE(salted.parse({"boil", "--salt"}));
    EXPECT_EQ(salted.line.run(), 3);
    Kitchen plain;
    ASSERT_TRUE(plain.parse({"boil"}));
    EXPECT_EQ(plain.line.run(), 4);
    Kitchen frying;
    ASSERT_TRUE(frying.parse({"fry"}));
    EXPECT_EQ(frying.line.run(), 5);
}

TEST(CommandLine, WhatIsNoCommandIsToldWithThoseThatThereAre) {
    const auto sentence = [](const std::vector<const char*>& words) {
        const auto parsed = Kitchen().parse(words);
        return parsed ? std::string("taken") : describe(parsed.error());
    };
    EXPECT_EQ(sentence({}), "a command is missing; expected one of boil, fry");
    EXPECT_EQ(sentence({"bake"}), "there is no command \"bake\"; expected one of boil, fry");
    EXPECT_EQ(sentence({"--bake"}), "there is no command \"--bake\"; expected one of boil, fry");
    EXPECT_EQ(sentence({""}), "there is no command \"\"; expected one of boil, fry");
    EXPECT_EQ(sentence({"fry", "--salt"}), "there is no option --salt; see kitchen fry --help");
}

TEST(CommandLine, EachCommandHasAHelpOfItsOwn) {
    const auto help = Kitchen().parse({"boil", "--help"});
    ASSERT_TRUE(help && *help);
    EXPECT_EQ(**help, R"(In water.
Usage: kitchen boil [OPTIONS]

Options:
  -h,--help               Print this help message and exit
  --salt                  In it.

)");
}

} // namespace
} // namespace texplorer::command_line_test

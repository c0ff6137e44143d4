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

Arguments:
  CANVAS                  What is painted on.

Options:
  -h,--help               Print this help.
  --version               Print the version.
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
        WrongCall{"Nothing", {}, "CANVAS is missing; see painter --help"},
        WrongCall{"Unknown", {"linen", "--oil"}, "there is no option --oil; see painter --help"},
        WrongCall{
            "OneMore", {"linen", "silk"}, "expected no further argument, found \"silk\"; see painter --help"},
        WrongCall{
            "Misspelt", {"linen", "--colour", "red"}, "there is no option --colour; did you mean --color?"},
        WrongCall{"MisspeltWithItsValue",
                  {"linen", "--colr=red"},
                  "there is no option --colr=red; did you mean --color?"},
        WrongCall{"MisspeltBeforeWhatIsMissing",
                  {"--varnsh"},
                  "there is no option --varnsh; did you mean --varnish?"},
        WrongCall{"OneDash", {"linen", "-varnish"}, "there is no option -varnish; did you mean --varnish?"},
        WrongCall{"Beginning", {"linen", "--va"}, "there is no option --va; did you mean --varnish?"},
        WrongCall{"OneLetter", {"linen", "-x"}, "there is no option -x; see painter --help"},
        WrongCall{"Twice",
                  {"linen", "--color", "red", "-c", "blue"},
                  "--color: expected one value, found \"red\" and \"blue\""},
        WrongCall{"FlagWithAValue", {"linen", "--matt=maybe"}, "--matt: expected no value"},
        WrongCall{"FlagSwitchedOff", {"linen", "--matt=false"}, "--matt: expected no value"},
        WrongCall{"EmptyValue", {"linen", "--color", ""}, "--color: expected a value, found an empty one"},
        WrongCall{"EmptyArgument", {""}, "CANVAS: expected a value, found an empty one"},
        WrongCall{"OptionForAValue",
                  {"linen", "--color", "--matt"},
                  "--color: expected a value, found the option --matt"},
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
        WrongCall{"Excludes", {"linen", "--matt", "--varnish"}, "--varnish and --matt exclude each other"}),
    [](const auto& each) { return std::string(each.param.name); });

/// A program with two commands.
struct Kitchen {
    CommandLine line{"kitchen", "1.0.0", "Cooks."};
    bool salt = false;
    bool quiet = false;
    bool loud = false;

    Kitchen() {
        line.everywhere("--quiet", quiet, "Without a word.");
        line.everywhere("--loud", loud, "With a song.", "--quiet");
        line.group("Wet");
        Command& boil = line.command("boil", "In water.");
        boil.flag("--salt", salt, "In it.");
        boil.usage({"POT", "-o PAN"});
        boil.onCall([this] { return salt ? 3 : 4; });
        line.group("Dry");
        line.command("fry", "In oil.").onCall([] { return 5; });
        line.addHelp();
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
        return parsed ? std::string("taken") : describe(parsed.error()).english();
    };
    EXPECT_EQ(sentence({}), "a command is missing; see kitchen --help");
    EXPECT_EQ(sentence({"--quiet"}), "a command is missing; see kitchen --help");
    EXPECT_EQ(sentence({"bake"}), "there is no command \"bake\"; expected one of boil, fry, help");
    EXPECT_EQ(sentence({"--bake"}), "expected a command, found \"--bake\"; see kitchen --help");
    EXPECT_EQ(sentence({"--verson"}), "expected a command, found \"--verson\"; did you mean --version?");
    EXPECT_EQ(sentence({"boyl"}), "there is no command \"boyl\"; did you mean \"boil\"?");
    EXPECT_EQ(sentence({"--quiet", "fr"}), "there is no command \"fr\"; did you mean \"fry\"?");
    EXPECT_EQ(sentence({"boil", "--quit"}), "there is no option --quit; did you mean --quiet?");
    EXPECT_EQ(sentence({"boil", "--quiet", "--loud"}), "--quiet and --loud exclude each other");
    EXPECT_EQ(sentence({"help", "boyl"}), "there is no command \"boyl\"; did you mean \"boil\"?");
    EXPECT_EQ(sentence({"help", "boil", "fry"}),
              "expected no further argument, found \"fry\"; see kitchen help --help");
    EXPECT_EQ(sentence({""}), "there is no command \"\"; expected one of boil, fry, help");
    EXPECT_EQ(sentence({"fry", "--salt"}), "there is no option --salt; see kitchen fry --help");
}

TEST(CommandLine, EachCommandHasAHelpOfItsOwn) {
    const auto help = Kitchen().parse({"boil", "--help"});
    ASSERT_TRUE(help && *help);
    EXPECT_EQ(**help, R"(In water.
Usage: kitchen boil [OPTIONS] POT
       kitchen boil [OPTIONS] -o PAN

Options:
  --salt                  In it.

Common options:
  -h,--help               Print this help.
  --version               Print the version.
  --quiet                 Without a word.
  --loud                  With a song.

)");
}

TEST(CommandLine, HelpSaysWhatHelpOfACommandDoes) {
    const auto text = [](const std::vector<const char*>& words) {
        const auto parsed = Kitchen().parse(words);
        return parsed && *parsed ? **parsed : std::string("nothing");
    };
    EXPECT_EQ(text({"help", "boil"}), text({"boil", "--help"}));
    EXPECT_EQ(text({"help", "help"}), text({"help", "--help"}));
    EXPECT_EQ(text({"help"}), text({"--help"}));
    EXPECT_EQ(text({"--quiet", "help", "fry"}), text({"fry", "-h"}));
    EXPECT_EQ(text({"help"}), R"(Cooks.
Usage: kitchen [OPTIONS] COMMAND

Wet:
  boil        In water.

Dry:
  fry         In oil.
  help        Help for a command.

Common options:
  -h,--help               Print this help.
  --version               Print the version.
  --quiet                 Without a word.
  --loud                  With a song.

)");
}

TEST(CommandLine, EveryCommandHasTheVersion) {
    for (const std::vector<const char*>& words : {std::vector<const char*>{"--version"},
                                                  {"boil", "--version"},
                                                  {"help", "--version"},
                                                  {"--quiet", "--version"}}) {
        const auto parsed = Kitchen().parse(words);
        ASSERT_TRUE(parsed && *parsed);
        EXPECT_EQ(**parsed, "kitchen 1.0.0\n");
    }
}

TEST(CommandLine, AFlagOfEveryCommandStandsBeforeOrBehindIt) {
    Kitchen before;
    ASSERT_TRUE(before.parse({"--quiet", "boil", "--salt"}));
    EXPECT_TRUE(before.quiet && before.salt);
    EXPECT_EQ(before.line.run(), 3);
    Kitchen behind;
    ASSERT_TRUE(behind.parse({"boil", "--quiet"}));
    EXPECT_TRUE(behind.quiet && !behind.loud);
    Kitchen twice;
    EXPECT_TRUE(twice.parse({"--quiet", "boil", "--quiet"}));
}

TEST(CommandLine, TellsWhatWasDeclared) {
    const Painter painter;
    std::vector<std::string> said;
    for (const Option& each : painter.line.options()) {
        std::string names;
        for (const std::string& name : each.names())
            names += name + " ";
        said.push_back(names + (each.isArgument() ? "argument " : "") + (each.isFlag() ? "flag " : "") +
                       (each.isList() ? "list " : "") + each.rules().value);
    }
    EXPECT_THAT(said, ElementsAre("CANVAS argument ", "-c --color NAME", "--coats ", "--layer list LAYER",
                                  "--tag list TAG", "--varnish flag ", "--matt flag ", "--frame WOOD"));
    EXPECT_EQ(painter.line.options().front().help(), "What is painted on.");
    EXPECT_TRUE(painter.line.options().front().rules().required);

    const Kitchen kitchen;
    EXPECT_EQ(kitchen.line.help(), "Cooks.");
    EXPECT_EQ(kitchen.line.commands().size(), 3U);
    const Command& boil = *kitchen.line.commands().front();
    EXPECT_EQ(boil.name() + ", " + boil.group() + ", " + boil.help(), "boil, Wet, In water.");
    EXPECT_EQ(boil.options().size(), 1U) << "its own";
    EXPECT_EQ(boil.sharedOptions().size(), 4U);
    EXPECT_THAT(boil.usage(), ElementsAre("POT", "-o PAN"));
}

} // namespace
} // namespace texplorer::command_line_test

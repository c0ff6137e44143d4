#include "app/command_line/manual.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

namespace texplorer::manual_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// A program with a command, of which each has what roff takes for its own.
struct Painter {
    CommandLine line{"painter", "1.2.3", "Paints pictures. On \\canvas\\."};
    std::string canvas;
    std::string color = "red";
    std::vector<std::string> layers;
    bool varnish = false;

    Painter() {
        line.footer(".Paint dries.\nExit status: 0 done.");
        Command& wall = line.command("wall", "Paints a wall.");
        wall.option("WALL", canvas, "Which one.", {.required = true});
        wall.option("LAYERS", layers, "What comes first. 'Under' it.");
        wall.option("-c,--color", color, "Of the paint.",
                    {.value = "NAME", .environment = "PAINTER_COLOR", .showsDefault = true});
        wall.flag("--varnish", varnish, "Then varnishes.");
        line.addWords();
        ::setenv("SOURCE_DATE_EPOCH", "951782400", 1); // NOLINT(concurrency-mt-unsafe): 2000-02-29
    }
    ~Painter() { ::unsetenv("SOURCE_DATE_EPOCH"); } // NOLINT(concurrency-mt-unsafe)
};

TEST(Manual, HasAPageForEachCommand) {
    const Painter painter;
    EXPECT_THAT(manualPages(painter.line), ElementsAre("painter", "painter-wall"));
    EXPECT_EQ(manualPage(painter.line, "list").value(), "painter\npainter-wall\n");
    const Result<std::string> none = manualPage(painter.line, "wall");
    ASSERT_FALSE(none);
    EXPECT_EQ(describe(none.error()), "--manual: expected one of painter, painter-wall, found \"wall\"");
}

TEST(Manual, ReadsLikeThis) {
    const Painter painter;
    const std::string page = manualPage(painter.line, "painter-wall").value();
    EXPECT_THAT(page, HasSubstr(R"(.TH PAINTER\-WALL 1 2000-02-29 "painter 1.2.3" "User Commands"
.ad l
.SH NAME
painter\-wall \- Paints a wall
.SH SYNOPSIS
.B painter wall
[\fIOPTIONS\fR] \fIWALL\fR [\fILAYERS\fR...]
.SH DESCRIPTION
Paints a wall.
.SH ARGUMENTS
.TP
\fIWALL\fR
Which one.
.TP
\fILAYERS\fR
What comes first.
\&'Under' it.
.SH OPTIONS
.TP
\fB\-c\fR, \fB\-\-color\fR \fINAME\fR
Of the paint.
Default: red.
The environment variable PAINTER_COLOR does the same.
.TP
\fB\-\-varnish\fR
Then varnishes.
)"));
    EXPECT_THAT(page, HasSubstr(".BR painter (1)"));
    EXPECT_THAT(page, Not(HasSubstr("painter\\-wall (1)"))) << "itself";
}

TEST(Manual, ExamplesAndTablesStandInHelpAndOnThePage) {
    Painter painter;
    Command& wall = *painter.line.commands().front();
    wall.examples({"painter wall 'a~b'", "painter wall --varnish"});
    wall.table({"Colours", "What there is.", {{"red", "As it dries."}}});
    const std::string page = manualPage(painter.line, "painter-wall").value();
    EXPECT_THAT(page, HasSubstr(".SH EXAMPLES\n.RS\n.nf\npainter wall \\(aqa\\(tib\\(aq\n"
                                "painter wall \\-\\-varnish\n.fi\n.RE\n"));
    EXPECT_THAT(page, HasSubstr(".SH COLOURS\nWhat there is.\n.TP\n\\fBred\\fR\nAs it dries.\n"));
    const char* const words[]{"painter", "wall", "--help"};
    const Result<std::optional<std::string>> help = painter.line.parse(3, words);
    ASSERT_TRUE(help && *help);
    EXPECT_THAT(**help, HasSubstr("\nExamples:\n  painter wall 'a~b'\n  painter wall --varnish\n"));
    EXPECT_THAT(**help, HasSubstr("\nColours:\nWhat there is.\n  red                     As it dries.\n"));
}

TEST(Manual, WhatRoffWouldTakeForItsOwnIsText) {
    const Painter painter;
    const std::string page = manualPage(painter.line, "painter").value();
    EXPECT_THAT(page, HasSubstr("\nOn \\ecanvas\\e.\n"));
    EXPECT_THAT(page, HasSubstr(".SH NOTES\n\\&.Paint dries.\n.SH EXIT STATUS\n0 done.\n"));
    EXPECT_THAT(page, HasSubstr(".SH COMMANDS\n.TP\n\\fBwall\\fR\nPaints a wall.\n"));
}

TEST(Manual, ADateThatIsNoneIsLeftAlone) {
    const Painter painter;
    ::setenv("SOURCE_DATE_EPOCH", "yesterday", 1); // NOLINT(concurrency-mt-unsafe)
    EXPECT_THAT(manualPage(painter.line, "painter").value(), Not(HasSubstr("yesterday")));
}

} // namespace
} // namespace texplorer::manual_test

#include "app/command_line/completion.h"
#include "app/command_line/completion_rows.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace texplorer::completion_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

struct Painter {
    CommandLine line{"painter", "1.2.3", "Paints."};
    std::string text;
    std::vector<std::string> texts;
    bool varnish = false;

    Painter() {
        Command& wall = line.command("wall", "Paints a wall. Or two.");
        wall.option("WALL", text, "Which one.", {.required = true});
        wall.option("--color", text, "Of [the] paint's shine: red.",
                    {.value = "NAME", .offers = {[] {
                                          return std::vector<std::string>{"red", "blue"};
                                      }}});
        wall.option("--mix", text, "Several.",
                    {.value = "A,B",
                     .offers = {[] {
                                    return std::vector<std::string>{"red", "blue"};
                                },
                                true}});
        wall.option("--set", texts, "Changes.",
                    {.value = "PATH=VALUE",
                     .oneEach = true,
                     .offers = {.assigned = [] {
                         return std::vector<Assigned>{{"rooms[].color", {"red"}}, {"height", {}}};
                     }}});
        wall.option("--tags", texts, "Some.", {.value = "TAG"});
        wall.option("-o,--out", text, "Where to.", {.value = "FILE"});
        wall.option("--folder", text, "Where to.", {.value = "DIR"});
        wall.flag("--varnish", varnish, "Then varnishes.");
        line.addWords();
    }
};

const CompletionRow& rowNamed(const CompletionTable& table, std::string_view name) {
    for (const CompletionRow& row : table.options)
        if (std::ranges::find(row.names, name) != row.names.end())
            return row;
    throw std::runtime_error("there is no such option");
}

TEST(CompletionRows, SayWhatIsOffered) {
    const Painter painter;
    const std::vector<CompletionTable> tables = completionTables(painter.line);
    ASSERT_EQ(tables.size(), 2U);
    EXPECT_EQ(tables[0].command, "");
    EXPECT_THAT(rowNamed(tables[0], "--completion").words, ElementsAre("bash", "zsh", "fish"));
    EXPECT_THAT(rowNamed(tables[0], "--manual").words, ElementsAre("painter", "painter-wall"));
    const CompletionTable& wall = tables[1];
    EXPECT_EQ(wall.summary, "Paints a wall");
    EXPECT_EQ(rowNamed(wall, "--color").offered, Offered::Words);
    EXPECT_EQ(rowNamed(wall, "--mix").offered, Offered::Joined);
    EXPECT_EQ(rowNamed(wall, "--set").offered, Offered::Assigned);
    EXPECT_EQ(rowNamed(wall, "--out").offered, Offered::Files);
    EXPECT_THAT(rowNamed(wall, "-o").names, ElementsAre("-o", "--out"));
    EXPECT_EQ(rowNamed(wall, "--folder").offered, Offered::Folders);
    EXPECT_EQ(rowNamed(wall, "--tags").offered, Offered::Nothing);
    EXPECT_TRUE(rowNamed(wall, "--tags").takesMany);
    EXPECT_FALSE(rowNamed(wall, "--set").takesMany);
    EXPECT_TRUE(rowNamed(wall, "--set").isList);
    EXPECT_EQ(rowNamed(wall, "--varnish").value, "");
    EXPECT_EQ(rowNamed(wall, "--help").value, "");
    ASSERT_EQ(wall.arguments.size(), 1U);
    EXPECT_EQ(wall.arguments[0].offered, Offered::Files);
    EXPECT_EQ(assignedBy(painter.line).size(), 2U);
}

/// The scripts are worked with in tests/end_to_end/texshot/completion_test.py; here is what could break them.
TEST(Completion, HelpIsQuotedAsTheShellNeedsIt) {
    const Painter painter;
    EXPECT_THAT(completionScript(painter.line, Shell::Zsh),
                HasSubstr(R"('--color=[Of \[the\] paint'\''s shine\: red]:NAME:(red blue)')"));
    EXPECT_THAT(completionScript(painter.line, Shell::Fish),
                HasSubstr(R"(-d 'Of [the] paint\'s shine: red')"));
    EXPECT_THAT(completionScript(painter.line, Shell::Bash),
                HasSubstr("'wall --color') offer=words words='red blue' ;;"));
}

TEST(Completion, IsAskedForByTheShellsName) {
    Painter painter;
    const std::vector<const char*> call{"painter", "--completion", "bash"};
    EXPECT_EQ(painter.line.parse(3, call.data()).value(), completionScript(painter.line, Shell::Bash));
    const std::vector<const char*> wrong{"painter", "--completion=nu"};
    EXPECT_EQ(describe(painter.line.parse(2, wrong.data()).error()),
              "--completion: expected one of bash, zsh, fish, found \"nu\"");
}

} // namespace
} // namespace texplorer::completion_test

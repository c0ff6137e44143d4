#include "texplorer/suite/case_command.h"

#include <gmock/gmock.h>

namespace texplorer::suite::case_command_test {
namespace {

struct Row {
    const char* run;
    const char* name;
    const char* command;
};

TEST(CaseCommand, RunsTheCaseAloneAsTheRunDid) {
    for (
        const Row& row :
        {Row{"texshot test s.suite.json", "grey/fixed@8x8",
             "texshot test s.suite.json --only grey/fixed@8x8"},
         Row{"texshot test 'my suites' --tolerance 2", "a b/c",
             "texshot test 'my suites' --tolerance 2 --only 'a b/c'"},
         Row{"texshot test a --only 'b *' --only c --renderer shader --shard 2/4 --durations d.json --context egl",
             "c", "texshot test a --renderer shader --context egl --only c"},
         Row{"texshot test 'it'\\''s --only here' b", "c", "texshot test 'it'\\''s --only here' b --only c"},
         Row{"texshot test 'a'\"$(printf '\\011')\"'b' --only x", "c",
             "texshot test 'a'\"$(printf '\\011')\"'b' --only c"},
         Row{"texshot test b --only 'a'\"$(printf '\\011')\"'b' --context egl", "c",
             "texshot test b --context egl --only c"}})
        EXPECT_EQ(commandOfCase(row.run, row.name), row.command);
}

// As a shell undoes the quotes, and --only the backslashes.
TEST(CaseCommand, NamesNoOtherCase) {
    EXPECT_EQ(commandOfCase("t", "a*[b]?\\'"), R"(t --only 'a'\\'*'\\'[b]'\\'?'\\''\\''\''')");
}

TEST(CaseCommand, IsNoneWhereAShellCouldNotBeGivenTheName) {
    EXPECT_EQ(commandOfCase("", "a"), "");
    EXPECT_EQ(commandOfCase("texshot test s", "a\nb"), "");
    EXPECT_EQ(commandOfCase("texshot test s", "a\xFF"), "");
}

} // namespace
} // namespace texplorer::suite::case_command_test

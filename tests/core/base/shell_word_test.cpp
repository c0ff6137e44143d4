#include "core/base/file_io.h"
#include "core/base/printable.h"
#include "core/base/shell_word.h"
#include "tests/support/temp_dir.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

namespace texplorer::shell_word_test {
namespace {

TEST(ShellWord, IsReadBackByBashAndSteersNoTerminal) {
    const test::TempDir folder;
    const std::string script = (folder / "script").string();
    const std::string out = (folder / "out").string();
    for (const std::string word :
         {"plain.png", "with space", "it's", "$HOME `id` \\", "\x1b[31mred\n\ttab\x7f", "\u202ebidi'\\",
          "latin \xe9", "Урок 1", "!x ~ *", ""}) {
        const std::string said = shellWord(word);
        EXPECT_EQ(printable(said), said);
        ASSERT_TRUE(writeFileAtomically(script, viewBytes("printf %s " + said + " >'" + out + "'")));
        ASSERT_EQ(std::system(("bash '" + script + "'").c_str()), 0) << said;
        EXPECT_EQ(readText(out).value(), word) << said;
    }
}

/// What a shell prints that reads a line.
std::string printedBy(const std::string& shell, const std::string& line) {
    const std::string command = shell + " -c " + shellWord("printf %s " + line);
    std::string printed;
    FILE* pipe = popen(command.c_str(), "r");
    if (pipe == nullptr)
        return "no shell";
    for (int byte = std::fgetc(pipe); byte != EOF; byte = std::fgetc(pipe))
        printed += static_cast<char>(byte);
    return pclose(pipe) == 0 ? printed : shell + " refuses " + line;
}

TEST(ShellWord, IsTheSameInEveryShell) {
    for (const char* shell : {"sh", "bash", "zsh -f", "fish --no-config"})
        for (const std::string word : {"textures[0].minFilter=GL_NEAREST",
                                       "=ls",
                                       "%1",
                                       "~",
                                       "it's",
                                       "a\\b",
                                       "\\'",
                                       "ends\\",
                                       "$HOME",
                                       "`ls`",
                                       "*",
                                       "?",
                                       "{a,b}",
                                       "a b",

                                       "!!",
                                       "#",
                                       "(x)",
                                       "a=~",
                                       "x^y",
                                       "\"",
                                       "plain"})
            EXPECT_EQ(printedBy(shell, shellWord(word)), word) << shell;
}

TEST(ShellWord, StaysAsItIsWhereNothingInItMeansAnything) {
    EXPECT_EQ(shellWord("view.distance=9"), "view.distance=9");
    EXPECT_EQ(shellWord(""), "''");
}

} // namespace
} // namespace texplorer::shell_word_test

#include "texplorer/text/printable.h"
#include "texplorer/text/shell_word.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

namespace texplorer::shell_word_test {
namespace {

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

// As of names with a tab or a line break, and of what would steer a terminal: nothing of it is printed as it
// is.
TEST(ShellWord, IsTheSameInEveryShellWhateverItSteers) {
    for (const std::string word :
         {"a\tb", "\t", "a\nb", "\nfirst", "last\n\n", "\n", "a\néb", "a\r\nb\t'c'\\",
          "\x1b[31mred\n\ttab\x7f", "\u202ebidi'\\", "latin \xe9", "Урок\t1", "$HOME `id`\t\\", "%s\t%"}) {
        const std::string said = shellWord(word);
        EXPECT_EQ(printable(said, LineBreaks::Keep), said);
        EXPECT_EQ(said.find('\t'), std::string::npos) << "typed, it would complete the word";
        EXPECT_EQ(said.find('\n') != std::string::npos, word.ends_with('\n'))
            << "one line, where it can be one";
        for (const char* shell : {"sh", "bash", "zsh -f", "fish --no-config"})
            EXPECT_EQ(printedBy(shell, said), word) << shell << ": " << said;
    }
}

TEST(ShellWord, StaysAsItIsWhereNothingInItMeansAnything) {
    EXPECT_EQ(shellWord("view.distance=9"), "view.distance=9");
    EXPECT_EQ(shellWord(""), "''");
}

} // namespace
} // namespace texplorer::shell_word_test

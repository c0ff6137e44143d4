#include "core/base/file_io.h"
#include "core/base/printable.h"
#include "core/base/shell_word.h"
#include "tests/support/temp_dir.h"

#include <gtest/gtest.h>

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

} // namespace
} // namespace texplorer::shell_word_test

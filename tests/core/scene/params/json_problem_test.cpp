#include "texplorer/scene/params/json_problem.h"

#include <gtest/gtest.h>

namespace texplorer::json_problem_test {
namespace {

/// Versions of the library say it differently.
TEST(JsonProblem, AnEmptyFileEndsBeforeItsValue) {
    for (const char* said :
         {"syntax error while parsing value - unexpected end of input; expected '[', '{', or a literal",
          "[json.exception.parse_error.101] parse error at line 1, column 1: attempting to parse an empty "
          "input; check that your input string or stream contains the expected JSON",
          "attempting to parse an empty input; check that your input string or stream contains the expected "
          "JSON"})
        EXPECT_EQ(readableProblem(said, ""), "the file ends; expected a value") << said;
}

TEST(JsonProblem, WhatIsNoJsonIsNamed) {
    struct Row {
        std::string_view text;
        std::size_t position;
        std::string_view word;
    };
    for (const auto& [text, position, word] : {
             Row{"{} x", 4, "'x'"},
             Row{"{} 'x'", 4, "'''"},
             Row{"[NaN]", 2, "'NaN'"},
             Row{"[-Infinity]", 3, "'Infinity'"},
             Row{"[nul]", 5, "'nul'"},
             Row{"[nul", 5, "'nul'"},
             Row{"[true/", 6, "'/'"},
             Row{"[truex", 6, "'truex'"},
             Row{"[\xC3\xA9]", 2, "'\xC3\xA9'"},
             Row{"[\x1B]", 2, R"('\u001b')"},
             Row{"[", 9, ""},
             Row{"", 0, ""},
         })
        EXPECT_EQ(wordAt(text, position), word) << text;
}

TEST(JsonProblem, TheLastThatWasReadIsLeftOut) {
    const auto problem = [](const std::string& said) {
        return readableProblem("syntax error while parsing " + said, "'x'");
    };
    EXPECT_EQ(problem("value - invalid literal; last read: '1} x'; expected end of input"),
              "expected the end of the file, found 'x'");
    EXPECT_EQ(problem("array - invalid literal; last read: '1 x'; expected ']'"),
              "expected ',' or ']', found 'x'");
    EXPECT_EQ(
        problem("value - invalid number; expected digit after '-'; last read: '-x'; expected end of input"),
        "invalid number; expected digit after '-'");
    EXPECT_EQ(problem("another - kind; last read: '\xFF'"), "syntax error while parsing another - kind");
}

} // namespace
} // namespace texplorer::json_problem_test

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
        EXPECT_EQ(readableProblem(said), "the file ends; expected a value") << said;
}

} // namespace
} // namespace texplorer::json_problem_test

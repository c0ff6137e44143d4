#include "tests/core/suite/sample_run.h"
#include "tests/support/python.h"
#include "tests/support/temp_dir.h"
#include "texplorer/suite/junit.h"

#include <gmock/gmock.h>

#include <fstream>

namespace texplorer::suite::junit_test {
namespace {

/// Python's own parser, libxml2 with the schema, and what both must find there.
TEST(Junit, IsWhatTheSchemaOfJenkinsSays) {
    const test::TempDir folder;
    RunRecord run = samples::sampleRun();
    run.cases[1].name = run.names[1] = "failed/\"<&>'\x01\x1B[2J\xEF\xBF\xBE\t\n\xF0\x9F\x98\x80";
    run.cases[1].sentence = "]]> 3 < 4 & \"5\"\r\n";
    std::ofstream(folder / "junit.xml") << asJunit(run);
    EXPECT_TRUE(test::runPython("core/suite/check_junit.py", folder / "junit.xml"));
}

TEST(Junit, SeveralSuitesAreSeveral) {
    RunRecord run;
    run.suites = {"sub", "sub/textures"};
    run.names = {"sub/textures/a/fixed@1x1", "sub/b/fixed@1x1"};
    run.cases = {{.name = run.names[0], .state = State::Passed},
                 {.name = run.names[1], .state = State::Failed}};
    const std::string xml = asJunit(run);
    EXPECT_THAT(xml, testing::HasSubstr(R"(<testsuite name="sub" tests="1" failures="1")"));
    EXPECT_THAT(xml, testing::HasSubstr(R"(<testsuite name="sub/textures" tests="1" failures="0")"));
}

} // namespace
} // namespace texplorer::suite::junit_test

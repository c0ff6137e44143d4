#include "tests/support/python.h"
#include "tests/support/temp_dir.h"
#include "texplorer/suite/suite.h"

#include <gtest/gtest.h>

#include <fstream>

namespace texplorer::suite::suite_schema_test {
namespace {

/// Python's jsonschema holds good and bad suites against it, and parseSuite must say the same of each.
TEST(SuiteSchema, SaysWhatTheReaderSays) {
    const test::TempDir folder;
    std::ofstream(folder / "schema.json") << suiteSchema();
    EXPECT_TRUE(test::runPython("core/suite/check_schema.py", folder.path()));
    std::size_t count = 0;
    for (const auto& file : std::filesystem::directory_iterator(folder / "good")) {
        const Result<Suite> suite = readSuite(file.path());
        EXPECT_TRUE(suite) << describe(suite.error());
        ++count;
    }
    for (const auto& file : std::filesystem::directory_iterator(folder / "bad")) {
        EXPECT_FALSE(readSuite(file.path())) << file.path();
        ++count;
    }
    EXPECT_GT(count, 20U);
}

} // namespace
} // namespace texplorer::suite::suite_schema_test

// The suites of assets/suites, and the one that docs/suites.md shows.

#include "texplorer/files/file_io.h"
#include "texplorer/suite/case_scene.h"
#include "texplorer/suite/suite_folder.h"

#include <gtest/gtest.h>

namespace texplorer::suite::suite_assets_test {
namespace {

const std::filesystem::path source = TEXPLORER_SOURCE_DIR;

TEST(SuiteAssets, CanBePlannedAndOpened) {
    const Result<std::vector<Suite>> suites = suitesAt(source / "assets/suites");
    ASSERT_TRUE(suites) << describe(suites.error());
    const Result<Plan> plan = planOf(*suites);
    ASSERT_TRUE(plan) << describe(plan.error());
    EXPECT_GE(plan->cases.size(), 36U);
    for (const Case& each : plan->cases) {
        ASSERT_FALSE(each.problem) << each.name << ": " << describe(*each.problem);
        Result<CaseScene> scene = openScene(*plan, each);
        ASSERT_TRUE(scene) << each.name << ": " << describe(scene.error());
        const Result<void> loaded = scene->load();
        EXPECT_TRUE(loaded) << each.name << ": " << describe(loaded.error());
    }
}

TEST(SuiteAssets, WhatIsDocumentedIsRead) {
    const Result<std::string> text = readText(source / "docs/suites.md");
    ASSERT_TRUE(text) << describe(text.error());
    const std::size_t start = text->find("```json\n{\n  \"suite\": 1");
    ASSERT_NE(start, std::string::npos);
    const std::string example = text->substr(start + 8, text->find("```", start + 8) - start - 8);
    const Result<Suite> suite = parseSuite(example);
    EXPECT_TRUE(suite) << describe(suite.error());
}

} // namespace
} // namespace texplorer::suite::suite_assets_test

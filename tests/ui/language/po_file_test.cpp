#include "app/ui/language/po_file.h"

#include <gmock/gmock.h>

#include <string>
#include <vector>

namespace texplorer::ui::po_file_test {
namespace {

TEST(PoTemplate, IsReadAgainAsItsTexts) {
    const std::vector<std::string> texts{"One", "Say \"a\\b\"",          "Two\nlines\tand a tab",
                                         "One", "The texel has {color}", ""};
    const Result<std::vector<PoEntry>> entries = readPoFile(poTemplate(texts, "lesson.json"), "texts.pot");
    ASSERT_TRUE(entries) << describe(entries.error());
    std::vector<std::string> keys;
    for (const PoEntry& entry : *entries)
        keys.push_back(entry.key);
    EXPECT_THAT(keys, testing::ElementsAre("", "One", "Say \"a\\b\"", "Two\nlines\tand a tab",
                                           "The texel has {color}"));
    EXPECT_FALSE(entries->at(1).isTranslated());
}

TEST(PoTemplate, MarksTextsWithPlaceholdersForGettextsTools) {
    const std::string text = poTemplate(std::vector<std::string>{"One", "{color}"}, "lesson.json");
    EXPECT_THAT(text, testing::EndsWith(
                          "\n#: lesson.json\nmsgid \"One\"\nmsgstr \"\"\n"
                          "\n#: lesson.json\n#, python-brace-format\nmsgid \"{color}\"\nmsgstr \"\"\n"));
}

} // namespace
} // namespace texplorer::ui::po_file_test

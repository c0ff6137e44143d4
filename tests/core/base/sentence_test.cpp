#include "texplorer/base/sentence.h"
#include "texplorer/base/sentence_format.h"

#include <gmock/gmock.h>

namespace texplorer::sentence_test {
namespace {

using testing::ElementsAre;

TEST(Sentence, HasItsKeyAndItsArguments) {
    const Sentence sentence("expected {0} bytes of {1}, found {2}", 54, "a.bmp", 3U);
    EXPECT_EQ(sentence.english(), "expected 54 bytes of a.bmp, found 3");
    EXPECT_EQ(sentence.key(), "expected {0} bytes of {1}, found {2}");
    EXPECT_THAT(sentence.arguments(), ElementsAre("54", "a.bmp", "3"));
    EXPECT_EQ(sentence.arguments()[0].number(), 54U);
    EXPECT_EQ(sentence.arguments()[1].number(), std::nullopt);
}

TEST(Sentence, FormatsEachArgumentAsItsPlaceholderSays) {
    const Sentence sentence("{1:.2f} of {0:04X}, {{{1:.2f}}}", 255, 0.75);
    EXPECT_EQ(sentence, "0.75 of 00FF, {0.75}");
    EXPECT_THAT(sentence.arguments(), ElementsAre("00FF", "0.75"));
    EXPECT_TRUE(sentence.arguments()[1].isName()) << "a number is the same in all languages";
}

TEST(Sentence, ContainsOtherSentencesAndNames) {
    const Sentence inner("{0} has no level {1}", ProperName{"Level 0"}, 7);
    const Sentence sentence("{0}: {1}", ProperName{"{0}"}, inner);
    EXPECT_EQ(sentence, "{0}: Level 0 has no level 7") << "arguments are not read as keys";
    EXPECT_TRUE(sentence.arguments()[0].isName());
    EXPECT_EQ(sentence.arguments()[1].key(), "{0} has no level {1}");
    EXPECT_TRUE(sentence.arguments()[1].arguments()[0].isName());
}

TEST(Sentence, ATextIsItsOwnKey) {
    const Sentence sentence = "not enough memory";
    EXPECT_EQ(sentence.key(), "");
    EXPECT_THAT(sentence.arguments(), testing::IsEmpty());
    EXPECT_EQ(fmt::format("{}.", sentence), "not enough memory.");
}

} // namespace
} // namespace texplorer::sentence_test

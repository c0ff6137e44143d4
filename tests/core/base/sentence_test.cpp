#include "texplorer/base/sentence.h"
#include "texplorer/base/sentence_format.h"

#include <gmock/gmock.h>

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

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
    EXPECT_TRUE(sentence.arguments()[1].isNumber()) << "a number is the same in all languages";
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

TEST(Sentence, HasThePluralOfANumber) {
    EXPECT_EQ(Sentence::plural("{0} byte", "{0} bytes", 0), "0 bytes");
    EXPECT_EQ(Sentence::plural("{0} byte", "{0} bytes", 1), "1 byte");
    EXPECT_EQ(Sentence::plural("{0} bit", "{0} bits", std::uint8_t{65}), "65 bits");
    EXPECT_EQ(
        Sentence::plural("{0} texel", "{0} texels", std::numeric_limits<std::uint64_t>::max()).english(),
        "18446744073709551615 texels");
    EXPECT_EQ(Sentence::plural("{0} level of {1}", "{0} levels of {1}", 2U, "brick").key(),
              "{0} levels of {1}");
}

TEST(Sentence, JoinsSentences) {
    EXPECT_EQ(Sentence::joined("{0}, {1}", {}), "");
    const std::vector<Sentence> all{"a", ProperName{"b"}, {"c {0}", 1}};
    EXPECT_EQ(Sentence::joined("{0}, {1}", std::span(all).first(1)), "a");
    const Sentence joined = Sentence::joined("{0}, {1}", all);
    EXPECT_EQ(joined, "a, b, c 1");
    EXPECT_EQ(joined.arguments().back().key(), "c {0}");
}

TEST(Sentence, InsertsItsArgumentsIntoAnotherForm) {
    const Sentence sentence("{0} from {1:.1f} to {0}", "a", 0.25);
    const auto marked = [](const Sentence& argument) { return "<" + argument.english() + ">"; };
    EXPECT_EQ(sentence.in("{1:.1f}: {0} {{0}}", marked), "<0.2>: <a> {0}");
    EXPECT_EQ(sentence.in("{7} {", marked), " {") << "no such argument";
}

} // namespace
} // namespace texplorer::sentence_test

#include "app/ui/widgets/fitted_text.h"

#include <gtest/gtest.h>

namespace texplorer::ui::fitted_text_test {
namespace {

std::string cut(std::string_view text, std::size_t fits) {
    return std::string(text.substr(0, sensibleEnd(text, fits)));
}

TEST(FittedText, EndsAfterAClauseOrAWord) {
    const std::string_view sentence =
        "Repeat reaches beyond the edge, which shows as a seam; some drivers clamp.";
    EXPECT_EQ(cut(sentence, 60), "Repeat reaches beyond the edge, which shows as a seam");
    EXPECT_EQ(cut(sentence, 50), "Repeat reaches beyond the edge");
    EXPECT_EQ(cut(sentence, 28), "Repeat reaches beyond the");
    EXPECT_EQ(cut(sentence, 25), "Repeat reaches beyond the");
    EXPECT_EQ(cut(sentence, 4), "Repe") << "half of a word is better than none";
    EXPECT_EQ(cut("a: GL_TEXTURE_CUBE_MAP_POSITIVE_X", 20), "a: GL_TEXTURE_CUBE_M") << "most of it stays";
    EXPECT_EQ(cut("Built-in pattern", 11), "Built-in pa") << "a label";
    EXPECT_EQ(cut(sentence, 500), sentence);
    EXPECT_EQ(cut("", 0), "");
}

} // namespace
} // namespace texplorer::ui::fitted_text_test

#include "app/ui/services/pattern_pictures.h"
#include "texplorer/image/thumbnail.h"

#include <gtest/gtest.h>

#include <latch>

namespace texplorer::ui::pattern_pictures_test {
namespace {

TEST(PatternPictures, AreSmallOnesOfEachPattern) {
    PatternPictures pictures(When::AtOnce);
    EXPECT_TRUE(pictures.ask());
    EXPECT_FALSE(pictures.ask());
    for (const EnumRow& row : patternRows) {
        const auto pattern = static_cast<Pattern>(row.value);
        const std::shared_ptr<const Image> picture = pictures.find(pattern);
        ASSERT_TRUE(picture) << row.name;
        EXPECT_EQ(*picture, thumbnailOf(drawPattern(pattern), 64)) << row.name;
        EXPECT_EQ(picture, pictures.find(pattern)) << "it stays the same one";
    }
}

TEST(PatternPictures, ComeOneAfterTheOtherBesideTheWindow) {
    std::latch all(static_cast<std::ptrdiff_t>(patternRows.size()));
    PatternPictures pictures(When::WhenReady, [&] { all.count_down(); });
    (void)pictures.ask();
    all.wait();
    (void)pictures.ask();
    for (const EnumRow& row : patternRows)
        EXPECT_TRUE(pictures.find(static_cast<Pattern>(row.value))) << row.name;
}

} // namespace
} // namespace texplorer::ui::pattern_pictures_test

#include "app/ui/services/pattern_pictures.h"
#include "texplorer/image/thumbnail.h"

#include <gtest/gtest.h>

#include <semaphore>

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
    std::counting_semaphore<> made(0);
    PatternPictures pictures(When::WhenReady, [&] { made.release(); });
    bool hasArrived = false;
    for (std::size_t i = 0; i < patternRows.size(); ++i) {
        hasArrived |= pictures.ask(); // a fast one arrives at once
        made.acquire();
    }
    hasArrived |= pictures.ask();
    EXPECT_TRUE(hasArrived);
    for (const EnumRow& row : patternRows)
        EXPECT_TRUE(pictures.find(static_cast<Pattern>(row.value))) << row.name;
}

} // namespace
} // namespace texplorer::ui::pattern_pictures_test

#include "app/stage/picture_cache.h"

#include <gmock/gmock.h>

#include <vector>

namespace texplorer::stage::picture_cache_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using view::PictureHandle;
using Use = Graphics::Use;

class PictureCacheTest : public testing::Test {
protected:
    std::vector<Image> made;
    std::vector<PictureHandle> dropped;
    PictureCache cache{{[this](const Image& image, Use /*use*/) {
                            made.push_back(image);
                            return static_cast<PictureHandle>(made.size());
                        },
                        [this](PictureHandle picture) { dropped.push_back(picture); }}};
};

std::shared_ptr<const Image> grey(int level) {
    Image image = Image::uninitialised(PixelFormat::Luminance8, 1, 1);
    image.pixels[0] = static_cast<std::byte>(level);
    return std::make_shared<const Image>(std::move(image));
}

TEST_F(PictureCacheTest, APictureIsMadeOnceAndDroppedWhenItIsNoLongerShown) {
    const auto first = grey(1);
    const auto second = grey(2);
    EXPECT_EQ(cache.show(first, Use::Scaled), PictureHandle{1});
    EXPECT_EQ(cache.show(second, Use::Scaled), PictureHandle{2});
    EXPECT_EQ(cache.show(first, Use::Scaled), PictureHandle{1});
    cache.endFrame();
    EXPECT_EQ(cache.show(second, Use::Scaled), PictureHandle{2});
    EXPECT_THAT(dropped, IsEmpty());
    cache.endFrame();
    EXPECT_THAT(dropped, ElementsAre(PictureHandle{1}));
    EXPECT_EQ(made.size(), 2U);
}

TEST_F(PictureCacheTest, TheHostGetsRgba8) {
    EXPECT_NE(cache.show(grey(7), Use::Enlarged), PictureHandle::None);
    ASSERT_EQ(made.size(), 1U);
    EXPECT_EQ(made[0].format, PixelFormat::Rgba8);
    EXPECT_THAT(made[0].pixels, ElementsAre(std::byte{7}, std::byte{7}, std::byte{7}, std::byte{255}));
}

TEST_F(PictureCacheTest, ThereIsNoPictureOfNothing) {
    EXPECT_EQ(cache.show(nullptr, Use::Scaled), PictureHandle::None);
    EXPECT_EQ(cache.show(std::make_shared<const Image>(), Use::Scaled), PictureHandle::None);
    EXPECT_THAT(made, IsEmpty());
}

TEST_F(PictureCacheTest, WhatTheHostHasLostIsMadeAgain) {
    const auto image = grey(1);
    EXPECT_EQ(cache.show(image, Use::Scaled), PictureHandle{1});
    cache.forget();
    EXPECT_EQ(cache.show(image, Use::Scaled), PictureHandle{2});
    EXPECT_THAT(dropped, IsEmpty());
}

TEST(PictureCacheEndTest, TheEndDropsAllPictures) {
    std::vector<PictureHandle> dropped;
    {
        PictureCache cache({[](const Image& /*image*/, Use /*use*/) { return PictureHandle{9}; },
                            [&](PictureHandle picture) { dropped.push_back(picture); }});
        EXPECT_EQ(cache.show(grey(1), Use::Scaled), PictureHandle{9});
    }
    EXPECT_THAT(dropped, ElementsAre(PictureHandle{9}));
}

} // namespace
} // namespace texplorer::stage::picture_cache_test

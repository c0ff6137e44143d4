#include "app/ui/services/thumbnails.h"
#include "tests/support/raw_file.h"
#include "tests/support/small_bmp.h"
#include "tests/support/temp_dir.h"

#include <gtest/gtest.h>

#include <latch>

namespace texplorer::ui::thumbnails_test {
namespace {

class ThumbnailCache : public testing::Test {
protected:
    std::filesystem::path bmp(const std::string& name, char red) {
        test::writeRaw(folder / name, test::onePixelBmp({0, 0, red}));
        return folder / name;
    }
    /// Requested in a frame, and available in the next one.
    std::shared_ptr<const Image> shown(const std::filesystem::path& file,
                                       std::filesystem::file_time_type modified = {}) {
        thumbnails.ask(file, modified);
        thumbnails.wait();
        (void)thumbnails.receive();
        thumbnails.ask(file, modified);
        return thumbnails.find(file);
    }
    static int redOf(const std::shared_ptr<const Image>& image) {
        return image ? std::to_integer<int>(image->pixels[0]) : -1;
    }

    test::TempDir folder;
    Thumbnails thumbnails{{}};
};

TEST_F(ThumbnailCache, APictureComesWhenItIsMade) {
    const auto file = bmp("a.bmp", 50);
    thumbnails.ask(file, {});
    EXPECT_EQ(thumbnails.find(file), nullptr);
    thumbnails.wait();
    EXPECT_TRUE(thumbnails.receive());
    EXPECT_EQ(redOf(thumbnails.find(file)), 50);
    EXPECT_FALSE(thumbnails.receive());
}

TEST_F(ThumbnailCache, AFileThatHoldsNoneIsAskedOnce) {
    test::writeRaw(folder / "text.bmp", std::string("Hello"));
    EXPECT_EQ(shown(folder / "text.bmp"), nullptr);
    EXPECT_FALSE(thumbnails.receive());
    EXPECT_EQ(shown(folder / "text.bmp"), nullptr);
}

TEST_F(ThumbnailCache, AChangedFileGetsANewPicture) {
    using std::filesystem::file_time_type;
    EXPECT_EQ(redOf(shown(bmp("a.bmp", 50), file_time_type(file_time_type::duration(1)))), 50);
    EXPECT_EQ(redOf(shown(bmp("a.bmp", 60), file_time_type(file_time_type::duration(2)))), 60);
}

TEST_F(ThumbnailCache, WhatIsOutOfSightIsCancelled) {
    std::latch seen{1}; // the file must not be done before it is out of sight
    Thumbnails held{[&seen] { seen.wait(); }};
    const auto gone = bmp("a.bmp", 50);
    held.ask(gone, {});
    (void)held.receive(); // not requested in this frame
    (void)held.receive();
    seen.count_down();
    held.wait();
    EXPECT_FALSE(held.receive());
    held.ask(gone, {});
    EXPECT_EQ(held.find(gone), nullptr) << "it was requested again";
}

TEST_F(ThumbnailCache, HoldsABoundedNumber) {
    const auto first = bmp("first.bmp", 50);
    ASSERT_NE(shown(first), nullptr);
    for (std::size_t i = 0; i < Thumbnails::maxPictures + 5; ++i)
        ASSERT_EQ(redOf(shown(bmp("other" + std::to_string(i) + ".bmp", 7))), 7);
    EXPECT_EQ(thumbnails.find(first), nullptr) << "the oldest had to go";
}

} // namespace
} // namespace texplorer::ui::thumbnails_test

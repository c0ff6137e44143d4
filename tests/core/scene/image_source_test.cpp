#include "core/scene/image_source.h"
#include "tests/support/raw_file.h"
#include "tests/support/small_bmp.h"
#include "tests/support/temp_dir.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace texplorer {
namespace {

using namespace std::string_literals;

Texture fileTexture(const std::string& file) {
    Texture texture;
    texture.source = SourceKind::File;
    texture.file = file;
    return texture;
}

Scene sceneOf(std::vector<Texture> textures) {
    Scene scene;
    scene.textures = std::move(textures);
    return scene;
}

class Images : public testing::Test {
protected:
    Images() {
        test::writeRaw(folder_ / "red.bmp", test::onePixelBmp("\1\2\3"));
        test::writeRaw(folder_ / "text.bmp", "not a picture"s);
    }
    test::TempDir folder_;
    ImageSource source_{folder_.path()};
};

TEST_F(Images, EveryPatternIsThereWithoutLoading) {
    for (const EnumRow& row : patternRows) {
        Texture texture;
        texture.pattern = static_cast<Pattern>(row.value);
        const auto image = source_.find(texture);
        ASSERT_NE(image, nullptr) << row.name;
        EXPECT_EQ(uprightImage(*image), drawPattern(texture.pattern)) << row.name;
        EXPECT_FALSE(image->fileTopFirst) << row.name << ": there is no file that could begin at the top";
        EXPECT_EQ(source_.find(texture), image) << "the pointer must stay the same";
        EXPECT_EQ(ImageSource().find(texture), image) << "sources share it";
    }
}

TEST_F(Images, AFileIsFoundOnceItIsLoaded) {
    const Texture red = fileTexture("red.bmp");
    EXPECT_EQ(source_.find(red), nullptr);
    ASSERT_TRUE(source_.load(sceneOf({red})));
    const auto image = source_.find(red);
    ASSERT_NE(image, nullptr);
    const Image picture = uprightImage(*image);
    EXPECT_EQ(picture.width, 1);
    EXPECT_EQ(picture.at(0, 0)[0], std::byte{3});
    EXPECT_EQ(image->format, "BMP");

    ASSERT_TRUE(source_.load(sceneOf({red, red})));
    EXPECT_EQ(source_.find(red), image) << "what is loaded is not loaded again";
    const ImageSource copy = source_;
    EXPECT_EQ(copy.find(red), image) << "copies share the pixels";
}

TEST_F(Images, AnAbsolutePathIsTakenAsItIs) {
    ImageSource elsewhere("/nowhere");
    const Texture red = fileTexture((folder_ / "red.bmp").string());
    ASSERT_TRUE(elsewhere.load(sceneOf({red})));
    EXPECT_NE(elsewhere.find(red), nullptr);
}

TEST_F(Images, TheFileNameOfAPatternIsNotRead) {
    Texture texture = fileTexture("missing.bmp");
    texture.source = SourceKind::Pattern;
    EXPECT_TRUE(source_.load(sceneOf({texture})));
}

TEST_F(Images, TheFirstErrorIsReportedAndTheOthersAreLoadedAllTheSame) {
    const Texture red = fileTexture("red.bmp");
    const Result<void> loaded =
        source_.load(sceneOf({fileTexture("none.bmp"), fileTexture("text.bmp"), red, fileTexture("")}));
    ASSERT_FALSE(loaded);
    EXPECT_EQ(loaded.error().code, ErrorCode::NotFound);
    EXPECT_EQ(loaded.error().where, "textures[0].file");
    EXPECT_THAT(loaded.error().message, testing::StartsWith((folder_ / "none.bmp").string() + ": "));
    EXPECT_NE(source_.find(red), nullptr);
    EXPECT_EQ(source_.find(fileTexture("text.bmp")), nullptr);
}

TEST_F(Images, AFileThatIsNoImageIsNamed) {
    const Result<void> loaded = source_.load(sceneOf({fileTexture("text.bmp")}));
    ASSERT_FALSE(loaded);
    EXPECT_EQ(loaded.error().code, ErrorCode::Unsupported);
    EXPECT_EQ(loaded.error().where, "textures[0].file");
    EXPECT_THAT(loaded.error().message, testing::StartsWith((folder_ / "text.bmp").string() + ": "));
    EXPECT_THAT(loaded.error().message, testing::HasSubstr("6e 6f 74 20"));
}

TEST_F(Images, ATextureWithoutAFileNameIsNamed) {
    const Result<void> loaded = source_.load(sceneOf({Texture{}, fileTexture("")}));
    ASSERT_FALSE(loaded);
    EXPECT_EQ(loaded.error().where, "textures[1].file");
}

TEST_F(Images, WhatIsPutThereNeedsNoFileAndReplacesWhatWas) {
    const Texture made = fileTexture("made up");
    source_.put(made.file, drawPattern(Pattern::Checker));
    EXPECT_TRUE(source_.load(sceneOf({made}))) << "it is there, so that no file is read";
    const auto first = source_.find(made);
    ASSERT_NE(first, nullptr);
    source_.put(made.file, drawPattern(Pattern::CheckerRed));
    EXPECT_EQ(uprightImage(*source_.find(made)), drawPattern(Pattern::CheckerRed));
    EXPECT_EQ(uprightImage(*first), drawPattern(Pattern::Checker)) << "whoever holds the old one keeps it";
}

TEST_F(Images, AFileThatFailedIsTriedAgain) {
    const Texture late = fileTexture("late.bmp");
    EXPECT_FALSE(source_.load(sceneOf({late})));
    test::writeRaw(folder_ / "late.bmp", test::onePixelBmp("\1\2\3"));
    EXPECT_TRUE(source_.load(sceneOf({late})));
    EXPECT_NE(source_.find(late), nullptr);
}

} // namespace
} // namespace texplorer

#include "tests/support/raw_file.h"
#include "tests/support/small_bmp.h"
#include "tests/support/temp_dir.h"
#include "texplorer/s3tc/surface_pixels.h"
#include "texplorer/texture/image_source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace texplorer::image_source_test {
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
    EXPECT_EQ(loaded.error().where, "textures[0].file: " + (folder_ / "none.bmp").string());
    EXPECT_NE(source_.find(red), nullptr);
    EXPECT_EQ(source_.find(fileTexture("text.bmp")), nullptr);
}

TEST_F(Images, AFileThatIsNoImageIsNamed) {
    const Result<void> loaded = source_.load(sceneOf({fileTexture("text.bmp")}));
    ASSERT_FALSE(loaded);
    EXPECT_EQ(loaded.error().code, ErrorCode::Unsupported);
    EXPECT_EQ(loaded.error().where.steps().front().text, "textures[0].file");
    EXPECT_EQ(loaded.error().where.inside(), (folder_ / "text.bmp").string());
    EXPECT_THAT(loaded.error().message, testing::HasSubstr("6e 6f 74 20"));
}

TEST_F(Images, ATextureWithoutAFileNameIsNamed) {
    const Result<void> loaded = source_.load(sceneOf({Texture{}, fileTexture("")}));
    ASSERT_FALSE(loaded);
    EXPECT_EQ(loaded.error().where.steps().front().text, "textures[1].file");
}

TEST_F(Images, WhatIsPutThereNeedsNoFileAndReplacesWhatWas) {
    const Texture made = fileTexture("made up");
    source_.put(made.file, drawPattern(Pattern::Checker));
    EXPECT_TRUE(source_.load(sceneOf({made}))) << "it is there, so that no file is read";
    const auto first = source_.find(made);
    ASSERT_NE(first, nullptr);
    source_.put(made.file, drawPattern(Pattern::CheckerRed));
    EXPECT_EQ(uprightImage(*source_.find(made)), drawPattern(Pattern::CheckerRed));
    EXPECT_EQ(uprightImage(*first), drawPattern(Pattern::Checker)) << "a pointer to the old one keeps it";
}

TEST_F(Images, AFileThatFailedIsTriedAgain) {
    const Texture late = fileTexture("late.bmp");
    EXPECT_FALSE(source_.load(sceneOf({late})));
    test::writeRaw(folder_ / "late.bmp", test::onePixelBmp("\1\2\3"));
    EXPECT_TRUE(source_.load(sceneOf({late})));
    EXPECT_NE(source_.find(late), nullptr);
}

TEST_F(Images, AFileIsDecodedOnceWhateverItIsCalled) {
    std::filesystem::create_symlink("red.bmp", folder_ / "link.bmp");
    std::filesystem::create_hard_link(folder_ / "red.bmp", folder_ / "other.bmp");
    const std::vector<Texture> names{fileTexture("red.bmp"), fileTexture("./red.bmp"),
                                     fileTexture("link.bmp"), fileTexture("other.bmp"),
                                     fileTexture((folder_.path() / "red.bmp").string())};
    constexpr std::size_t onePixel = 3;
    ASSERT_TRUE(source_.load(sceneOf(names), onePixel)) << "it counts once, too";
    for (const Texture& each : names)
        EXPECT_EQ(source_.find(each), source_.find(names[0])) << each.file;
    EXPECT_EQ(source_.bytesOf(filesOf(sceneOf(names))), onePixel);
}

TEST_F(Images, DifferentFilesAreAddedUpAgainstTheBudget) {
    test::writeRaw(folder_ / "green.bmp", test::onePixelBmp("\1\2\4"));
    test::writeRaw(folder_ / "blue.bmp", test::onePixelBmp("\1\2\5"));
    const Scene scene = sceneOf({fileTexture("red.bmp"), fileTexture("green.bmp"), fileTexture("blue.bmp")});
    const auto expectRefusal = [&](const Error& error) {
        EXPECT_EQ(error.code, ErrorCode::TooLarge);
        EXPECT_EQ(error.where.steps().front().text, "textures[2].file");
        EXPECT_EQ(describe({error.code, error.message, error.where.inside()}),
                  (folder_ / "blue.bmp").string() +
                      ": the image needs 3 bytes, but of the 2147483648 for all images of a "
                      "scene, 2 are left");
    };
    const Result<void> loaded = source_.load(scene, 8);
    ASSERT_FALSE(loaded);
    expectRefusal(loaded.error());
    EXPECT_NE(source_.find(scene.textures[1]), nullptr);
    EXPECT_EQ(source_.find(scene.textures[2]), nullptr);
    EXPECT_FALSE(source_.load(scene, 8)) << "what is loaded counts";
    EXPECT_TRUE(source_.load(sceneOf({scene.textures[2]}), 8)) << "what the scene doesn't name doesn't";
    const auto errors = ImageSource(folder_.path()).loadAll(scene, Decoding::Outline, 8);
    ASSERT_EQ(errors.size(), 1U);
    expectRefusal(errors[0]);
}

TEST_F(Images, AnOutlineHasExtentsAndNoPixels) {
    const Texture red = fileTexture("red.bmp");
    const auto errors = source_.loadAll(
        sceneOf({red, fileTexture("text.bmp"), fileTexture("none.bmp"), Texture{}}), Decoding::Outline);
    ASSERT_EQ(errors.size(), 2U);
    EXPECT_EQ(errors[0].where.steps().front().text, "textures[1].file");
    EXPECT_EQ(errors[1].where.steps().front().text, "textures[2].file");
    EXPECT_EQ(errors[1].code, ErrorCode::NotFound);
    const auto outline = source_.find(red);
    ASSERT_NE(outline, nullptr);
    EXPECT_FALSE(hasPixels(*outline));
    EXPECT_EQ(widthOf(outline->surfaces.at(0)), 1);
    EXPECT_EQ(byteCount(*outline), 3U);
}

Texture levelsTexture(const std::string& level, const std::string& other) {
    Texture texture = fileTexture("red.bmp");
    texture.mipmaps = MipPolicy::Given;
    texture.levels = {{.file = "not used"}, {.source = SourceKind::File, .file = level}};
    texture.preparation = {{.op = ImageOp::Invert, .source = SourceKind::File, .file = "not used"},
                           {.op = ImageOp::AlphaFrom, .source = SourceKind::File, .file = other}};
    return texture;
}

TEST_F(Images, LevelsAndPreparationNameFilesToo) {
    test::writeRaw(folder_ / "green.bmp", test::onePixelBmp("\1\2\4"));
    const Scene scene = sceneOf({levelsTexture("green.bmp", "none.bmp")});
    EXPECT_EQ(filesOf(scene), (std::set<std::string>{"red.bmp", "green.bmp", "none.bmp"}));
    const Result<void> loaded = source_.load(scene);
    ASSERT_FALSE(loaded);
    EXPECT_EQ(loaded.error().where.steps().front().text, "textures[0].preparation[1].file");
    const TexturePictures pictures = source_.picturesOf(scene.textures[0]);
    EXPECT_NE(pictures.base, nullptr);
    EXPECT_EQ(pictures.levels.at(1), source_.contentOf("green.bmp"));
    EXPECT_EQ(pictures.others, (std::vector<TexturePictures::Picture>{nullptr, nullptr}));
}

TEST_F(Images, AFileThatALevelWantsMustBeNamed) {
    const auto errors = source_.loadAll(sceneOf({levelsTexture("", "")}), Decoding::Outline);
    ASSERT_EQ(errors.size(), 2U);
    EXPECT_EQ(errors[0].where.steps().front().text, "textures[0].levels[1].file");
    EXPECT_EQ(errors[1].where.steps().front().text, "textures[0].preparation[1].file");
}

TEST_F(Images, FilesOfLevelsCountAgainstTheBudget) {
    test::writeRaw(folder_ / "green.bmp", test::onePixelBmp("\1\2\4"));
    const Result<void> loaded = source_.load(sceneOf({levelsTexture("green.bmp", "red.bmp")}), 5);
    ASSERT_FALSE(loaded);
    EXPECT_EQ(loaded.error().code, ErrorCode::TooLarge);
    EXPECT_EQ(loaded.error().where.steps().front().text, "textures[0].levels[1].file");
}

TEST_F(Images, OfKeyFramesAreNamedLoadedAndRenamedToo) {
    Scene scene;
    scene.textures.resize(2);
    scene.textures[0].source = SourceKind::File;
    scene.textures[0].file = "never.png";
    scene.textures[1].file = "later.png";
    scene.timeline.keys = {{0, "textures[0].file", "a.png"},
                           {1, "textures[0].file", "b.png"},
                           {0, "textures[1].source", "pattern"},
                           {1, "textures[1].source", "file"}};
    EXPECT_EQ(filesOf(scene), (std::set<std::string>{"a.png", "b.png", "later.png"}));
    renameFiles(scene, [](const std::string& file) { return "x/" + file; });
    EXPECT_EQ(filesOf(scene), (std::set<std::string>{"x/a.png", "x/b.png", "x/later.png"}));
    EXPECT_EQ(scene.textures[0].file, "x/never.png");
}

TEST_F(Images, AreRenamedWhereverTheyAreNamed) {
    Scene scene = sceneOf({levelsTexture("green.bmp", ""), fileTexture("red.bmp")});
    renameFiles(scene, [](const std::string& file) { return "x/" + file; });
    const std::vector<FileName> names = fileNamesOf(scene);
    ASSERT_EQ(names.size(), 6U);
    EXPECT_EQ(names[0], (FileName{"textures[0].file", "x/red.bmp", true}));
    EXPECT_EQ(names[1], (FileName{"textures[0].levels[0].file", "x/not used", false}));
    EXPECT_EQ(names[2], (FileName{"textures[0].levels[1].file", "x/green.bmp", true}));
    EXPECT_EQ(names[4], (FileName{"textures[0].preparation[1].file", "", true}));
    EXPECT_EQ(names[5].path, "textures[1].file");
    scene.textures[0].mipmaps = MipPolicy::None;
    EXPECT_FALSE(fileNamesOf(scene)[2].used) << "they are read where they are wanted";
}

} // namespace
} // namespace texplorer::image_source_test

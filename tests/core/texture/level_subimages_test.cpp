// Parts of levels that are replaced after the upload (OpenGL 2.1, section 3.8.2).

#include "texplorer/texture/level_plan.h"
#include "texplorer/texture/texture_levels.h"

#include <gmock/gmock.h>

namespace texplorer::level_subimages_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

std::shared_ptr<const TextureImage> grey(int width, int height, int value, int depth = 1) {
    Image image = Image::uninitialised(PixelFormat::Luminance8, width, height, depth);
    std::ranges::fill(image.pixels, static_cast<std::byte>(value));
    auto texture = textureOf(std::move(image), "PNG");
    return std::make_shared<const TextureImage>(std::move(texture));
}

/// 4 x 4 texels of 0 with a part of 2 x 1 texels of 200 at (1, 2).
struct Subject {
    Texture texture{};
    TexturePictures pictures{grey(4, 4, 0)};

    Subject() {
        texture.subimages = {{.x = 1, .y = 2, .source = SourceKind::File, .file = "part.png"}};
        pictures.subimages = {grey(2, 1, 200)};
    }
    TextureLevels levels(Target target = Target::Texture2D) const {
        return *prepareLevels(texture, pictures, target);
    }
    std::string note() const {
        const TextureLevels made = levels();
        return made.notes.empty() ? "" : made.notes.back().english();
    }
};

std::vector<int> redsOf(const TextureLevels& levels, std::size_t index, int row, int slice = 0) {
    const Image& image = std::get<Image>(*levels.levels.at(index).surface);
    std::vector<int> reds;
    for (int x = 0; x < image.width; ++x)
        reds.push_back(std::to_integer<int>(image.at(x, row, slice)[0]));
    return reds;
}

TEST(Subimages, ReplaceTexelsFromTheirOffset) {
    const TextureLevels levels = Subject().levels();
    EXPECT_THAT(redsOf(levels, 0, 1), ElementsAre(0, 0, 0, 0));
    EXPECT_THAT(redsOf(levels, 0, 2), ElementsAre(0, 200, 200, 0));
    EXPECT_THAT(redsOf(levels, 0, 3), ElementsAre(0, 0, 0, 0));
    EXPECT_THAT(levels.notes, IsEmpty());
}

TEST(Subimages, AreMadeInTheirOrder) {
    Subject subject;
    subject.texture.subimages.push_back({.x = 2, .y = 2, .source = SourceKind::File, .file = "dot.png"});
    subject.pictures.subimages.push_back(grey(1, 1, 50));
    EXPECT_THAT(redsOf(subject.levels(), 0, 2), ElementsAre(0, 200, 50, 0));
    std::swap(subject.texture.subimages[0], subject.texture.subimages[1]);
    std::swap(subject.pictures.subimages[0], subject.pictures.subimages[1]);
    EXPECT_THAT(redsOf(subject.levels(), 0, 2), ElementsAre(0, 200, 200, 0));
}

TEST(Subimages, AreScaledIfTheyAreBuiltIn) {
    Subject subject;
    subject.texture.subimages = {{.x = 0, .y = 0, .width = 4, .height = 2, .pattern = Pattern::CheckerRed}};
    subject.pictures.subimages = {grey(4, 4, 255)}; // in place of the pattern
    EXPECT_THAT(redsOf(subject.levels(), 0, 1), ElementsAre(255, 255, 255, 255));
    EXPECT_THAT(redsOf(subject.levels(), 0, 2), ElementsAre(0, 0, 0, 0));
}

TEST(Subimages, OfColoursLeaveDepths) {
    Subject subject;
    subject.texture.internalFormat = InternalFormat::DepthComponent24;
    EXPECT_EQ(subject.note(), "subimages[0]: colours cannot replace depths; not changed");
    EXPECT_THAT(redsOf(subject.levels(), 0, 2), ElementsAre(0, 0, 0, 0));
}

// Levels that a program makes before the call stay as they were: only the named one changes.
TEST(Subimages, ChangeOneLevelOfThoseThatAProgramMakes) {
    Subject subject;
    subject.texture.mipmaps = MipPolicy::Generated;
    EXPECT_THAT(redsOf(subject.levels(), 0, 2), ElementsAre(0, 200, 200, 0));
    EXPECT_THAT(redsOf(subject.levels(), 1, 1), ElementsAre(0, 0));
    subject.texture.subimages[0] = {.level = 1, .x = 0, .y = 1, .source = SourceKind::File};
    EXPECT_THAT(redsOf(subject.levels(), 0, 2), ElementsAre(0, 0, 0, 0));
    EXPECT_THAT(redsOf(subject.levels(), 1, 1), ElementsAre(200, 200));
}

// GL_GENERATE_MIPMAP makes the levels again when level 0 changes (section 3.8.8), and so does a later call of
// glGenerateMipmap: a quarter of 200 twice.
TEST(Subimages, ChangeAllLevelsThatTheDriverMakes) {
    Subject subject;
    for (const MipPolicy policy : {MipPolicy::OnUpload, MipPolicy::GenerateMipmap}) {
        subject.texture.mipmaps = policy;
        const TextureLevels levels = subject.levels();
        EXPECT_TRUE(levels.madeByDriver);
        EXPECT_THAT(redsOf(levels, 1, 1), ElementsAre(50, 50));
        EXPECT_THAT(redsOf(levels, 1, 0), ElementsAre(0, 0));
    }
}

TEST(Subimages, ReplaceASliceOfAVolumeAndAFaceOfACubeMap) {
    Subject subject;
    subject.pictures.base = grey(4, 4, 0, 2);
    subject.texture.subimages[0].z = 1;
    const TextureLevels volume = subject.levels(Target::Texture3D);
    EXPECT_THAT(redsOf(volume, 0, 2, 0), ElementsAre(0, 0, 0, 0));
    EXPECT_THAT(redsOf(volume, 0, 2, 1), ElementsAre(0, 200, 200, 0));
    subject.pictures.base = grey(4, 4, 0);
    const TextureLevels cube = subject.levels(Target::CubeMap);
    ASSERT_THAT(cube.levels, SizeIs(6));
    EXPECT_THAT(redsOf(cube, 0, 2), ElementsAre(0, 0, 0, 0));
    EXPECT_THAT(redsOf(cube, 1, 2), ElementsAre(0, 200, 200, 0)) << "face 1, -x";
}

TEST(Subimages, CountFromInsideTheBorder) {
    Subject subject;
    subject.texture.border = 1;
    const TextureLevels levels = subject.levels(); // 6 x 6 with it
    EXPECT_THAT(redsOf(levels, 0, 3), ElementsAre(0, 0, 200, 200, 0, 0));
}

TEST(Subimages, AreRefusedAsOpenGlDoes) {
    Subject subject;
    subject.texture.subimages[0].x = 3;
    EXPECT_EQ(subject.note(),
              "subimages[0]: GL_INVALID_VALUE: the columns 3 to 4 are to change, but the level "
              "has 4; not changed");
    EXPECT_THAT(redsOf(subject.levels(), 0, 2), ElementsAre(0, 0, 0, 0));
    const LevelPlan plan = planLevels(subject.texture, subject.pictures, Target::Texture2D);
    ASSERT_THAT(plan.refusedSubimages, SizeIs(1));
    EXPECT_EQ(plan.refusedSubimages[0].index, 0U);
    subject.texture.subimages[0] = {.x = 0, .y = 4, .source = SourceKind::File};
    EXPECT_THAT(subject.note(), HasSubstr("the rows 4 to 4"));
    subject.texture.subimages[0] = {.level = 1, .source = SourceKind::File};
    EXPECT_THAT(subject.note(), HasSubstr("GL_INVALID_OPERATION: there is no level 1"));
    subject.texture.subimages[0] = {.x = 16383, .y = 16383, .source = SourceKind::File};
    EXPECT_THAT(subject.note(), HasSubstr("16383 to 16384"));
    subject.texture.subimages[0] = {.source = SourceKind::File};
    EXPECT_EQ(subject.note(), "");
    subject.texture.compression = Compression::Cached;
    EXPECT_THAT(subject.note(), HasSubstr("blocks"));
    subject.texture.compression = {};
    subject.pictures.subimages = {nullptr};
    EXPECT_THAT(subject.note(), HasSubstr("no file is chosen"));
}

TEST(Subimages, AreRefusedByALevelThatIsLeftOut) {
    Subject subject;
    subject.texture.mipmaps = MipPolicy::Missing; // of 4 x 4 texels level 1
    subject.texture.subimages[0] = {.level = 1, .source = SourceKind::File};
    EXPECT_THAT(subject.note(), HasSubstr("there is no level 1"));
    const LevelPlan plan = planLevels(subject.texture, subject.pictures, Target::Texture2D);
    ASSERT_THAT(plan.refusedSubimages, SizeIs(1));
    EXPECT_TRUE(plan.refusedSubimages[0].isCalled) << "a program makes the call";
}

TEST(Subimages, ReplaceWhatACustomUploadRead) {
    Subject subject;
    subject.texture.flip = FlipMode::Pixels;
    subject.texture.upload = {.custom = true, .format = TransferFormat::Luminance};
    const TextureLevels levels = subject.levels();
    EXPECT_THAT(redsOf(levels, 0, 2), ElementsAre(0, 200, 200, 0));
    EXPECT_FALSE(levels.levels[0].memory) << "it is uploaded as its pixels";
}

} // namespace
} // namespace texplorer::level_subimages_test

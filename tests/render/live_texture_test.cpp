// A texture that is uploaded in parts is the same as one that is uploaded at once, and shows its old picture
// until then.

#include "app/render/live_texture.h"
#include "tests/support/flat_scene.h"
#include "tests/support/render_fixture.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <random>

namespace texplorer::render::live_texture_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Image randomImage(int width, int height, int depth = 1) {
    Image made = Image::uninitialised(PixelFormat::Rgb8, width, height, depth);
    std::mt19937 random(5); // NOLINT: the same picture each time
    std::ranges::generate(made.pixels, [&] { return static_cast<std::byte>(random() >> 24); });
    return made;
}

struct Part {
    const char* name;
    Target target;
    Image image;
    Compression compression;
    std::size_t bytes; // a frame
};

std::ostream& operator<<(std::ostream& out, const Part& part) {
    return out << part.name;
}

class UploadInParts : public test::RenderTest, public testing::WithParamInterface<Part> {};

TEST_P(UploadInParts, IsWhatAnUploadAtOnceIs) {
    const Part& part = GetParam();
    Texture texture;
    texture.internalFormat = InternalFormat::Rgb;
    texture.mipmaps = MipPolicy::Generated;
    texture.compression = part.compression;
    const auto levels = prepareLevels(texture, textureOf(part.image, {}), part.target);
    ASSERT_TRUE(levels.has_value());
    GlErrors errors;
    const TextureObject atOnce(part.target, *levels, "at once", errors);
    TextureObject inParts(part.target);
    UploadCursor cursor;
    int calls = 1;
    while (!inParts.upload(*levels, cursor, part.bytes, "in parts", errors))
        ++calls;
    EXPECT_GT(calls, 3);
    EXPECT_THAT(errors.sentences(), IsEmpty());
    const auto expected = atOnce.read();
    const auto found = inParts.read();
    ASSERT_TRUE(expected.has_value() && found.has_value());
    ASSERT_EQ(found->size(), expected->size());
    for (std::size_t i = 0; i < found->size(); ++i)
        EXPECT_EQ((*found)[i].surface, (*expected)[i].surface) << "level " << i;
}

INSTANTIATE_TEST_SUITE_P(
    All, UploadInParts,
    testing::Values(Part{"Picture", Target::Texture2D, randomImage(64, 50), Compression::FromFile, 1000},
                    Part{"Volume", Target::Texture3D, randomImage(16, 16, 24), Compression::FromFile, 4000},
                    Part{"ByTheDriver", Target::Texture2D, randomImage(64, 50), Compression::Driver, 1000}),
    [](const auto& test) { return test.param.name; });

/// Gives levels when the test lets it.
class HeldLevels final : public LevelsSource {
public:
    std::shared_ptr<const PreparedLevels> prepare(const LevelsRequest& request) override {
        if (cancelled)
            return std::make_shared<const PreparedLevels>(fail(ErrorCode::Cancelled, "cancelled"));
        if (!ready)
            return nullptr;
        return std::make_shared<const PreparedLevels>(
            prepareLevels(request.settings, *request.pictures.base, request.target));
    }
    bool isLive() const override { return true; }
    void uploaded(const LevelsRequest&, std::shared_ptr<const PreparedLevels> levels,
                  std::vector<TextureLevel> read) override {
        EXPECT_NE(levels, nullptr);
        ++givenBack;
        made = std::move(read);
    }
    bool ready = true;
    bool cancelled = false;
    int givenBack = 0;
    std::vector<TextureLevel> made;
};

class LiveScene : public test::RenderTest {
protected:
    LiveScene() {
        images.put("red", test::plainImage(4, 4, {255, 0, 0, 255}));
        images.put("green", test::plainImage(4, 4, {0, 255, 0, 255}));
        Texture& texture = scene.textures.front();
        texture.source = SourceKind::File;
        texture.file = "red";
    }
    glm::vec4 color() {
        const auto frame = renderer->draw(scene, images, 0, {8, 8}, &levels);
        problems = frame->problems;
        return test::colorAt(*renderer->read(), 4, 4);
    }
    static constexpr glm::vec4 red{1, 0, 0, 1};
    static constexpr glm::vec4 green{0, 1, 0, 1};

    Scene scene = test::texturedScene();
    HeldLevels levels;
};

TEST_F(LiveScene, TheOldPictureStaysUntilTheNextIsReady) {
    EXPECT_TRUE(test::isColor(color(), red));
    levels.ready = false;
    scene.textures.front().file = "green";
    EXPECT_TRUE(test::isColor(color(), red));
    EXPECT_THAT(problems, IsEmpty());
    levels.ready = true;
    EXPECT_TRUE(test::isColor(color(), green));
}

TEST_F(LiveScene, WhatIsCancelledIsSaidAndTheOldPictureStays) {
    EXPECT_TRUE(test::isColor(color(), red));
    levels.cancelled = true;
    scene.textures.front().file = "green";
    EXPECT_TRUE(test::isColor(color(), red));
    EXPECT_THAT(problems, ElementsAre(HasSubstr("before stays")));
    scene.textures.front().file = "red";
    EXPECT_TRUE(test::isColor(color(), red));
}

TEST_F(LiveScene, TellsWhatTheDriverMade) {
    images.put("random", randomImage(16, 16));
    scene.textures.front().file = "random";
    scene.textures.front().compression = Compression::Driver;
    (void)color();
    (void)color(); // the next frame tells it
    EXPECT_EQ(levels.givenBack, 1);
    ASSERT_EQ(levels.made.size(), 1U);
    EXPECT_EQ(byteCount(levels.made.front().surface), 16U * 8) << "16 blocks of DXT1";
}

} // namespace
} // namespace texplorer::render::live_texture_test

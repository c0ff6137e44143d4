// app/view/pretence.h: a driver that is treated as if it lacked something. What the renderers make of it.

#include "app/render/shader_renderer.h"
#include "app/view/driver_facts.h"
#include "app/view/pretence.h"
#include "tests/support/flat_scene.h"
#include "tests/support/render_fixture.h"
#include "texplorer/compare/difference.h"
#include "texplorer/reference/draw.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>

namespace texplorer::pretence_test {
namespace {

using namespace test;
using testing::ElementsAre;
using testing::IsEmpty;
using view::Capabilities;
using view::Pretence;

Capabilities wealthy() {
    Capabilities driver;
    driver.textureUnits = 8;
    driver.maxTextureSize = driver.max3DTextureSize = driver.maxCubeMapSize = 16384;
    driver.maxAnisotropy = 16;
    driver.s3tc = driver.rgtc = driver.floatTextures = driver.seamlessCubeMaps = driver.shaders =
        driver.textureBorders = true;
    return driver;
}

Capabilities lacking(const std::string& words, const Capabilities& driver) {
    const Result<Pretence> pretence = Pretence::parse({words});
    EXPECT_TRUE(pretence) << describe(pretence.error());
    return pretence ? pretence->of(driver) : driver;
}

// --- Words

struct Word {
    const char* text;
    bool (*isLacking)(const Capabilities& driver);
};
constexpr std::array words{
    Word{"no-multitexture", [](const Capabilities& c) { return c.textureUnits == 1; }},
    Word{"units=3", [](const Capabilities& c) { return c.textureUnits == 3; }},
    Word{"max-texture-size=256", [](const Capabilities& c) { return c.maxTextureSize == 256; }},
    Word{"max-3d-texture-size=64", [](const Capabilities& c) { return c.max3DTextureSize == 64; }},
    Word{"max-cube-map-size=32", [](const Capabilities& c) { return c.maxCubeMapSize == 32; }},
    Word{"no-npot", [](const Capabilities& c) { return !c.nonPowerOfTwo; }},
    Word{"no-s3tc", [](const Capabilities& c) { return !c.s3tc; }},
    Word{"no-rgtc", [](const Capabilities& c) { return !c.rgtc; }},
    Word{"no-float-textures", [](const Capabilities& c) { return !c.floatTextures; }},
    Word{"no-anisotropy", [](const Capabilities& c) { return c.maxAnisotropy == 1; }},
    Word{"max-anisotropy=4", [](const Capabilities& c) { return c.maxAnisotropy == 4; }},
    Word{"no-seamless-cube-maps", [](const Capabilities& c) { return !c.seamlessCubeMaps; }},
    Word{"no-shaders", [](const Capabilities& c) { return !c.shaders; }},
};

TEST(Pretence, TakesAwayWhatAWordSaysAndNothingElse) {
    for (const Word& word : words) {
        SCOPED_TRACE(word.text);
        const Capabilities driver = lacking(word.text, wealthy());
        EXPECT_EQ(driver.pretending, word.text);
        for (const Word& each : words)
            EXPECT_EQ(each.isLacking(driver), &each == &word) << each.text;
        EXPECT_EQ(Pretence::parse({word.text})->text(), word.text);
    }
    for (const view::PretenceRow& row : view::pretenceRows())
        EXPECT_EQ(
            std::ranges::count_if(
                words, [&](const Word& each) { return std::string_view(each.text).starts_with(row.word); }),
            1)
            << row.word;
}

TEST(Pretence, TakesSeveralWordsOfSeveralOptions) {
    const Result<Pretence> pretence = Pretence::parse({"no-s3tc,units=2", "no-rgtc"});
    ASSERT_TRUE(pretence);
    EXPECT_EQ(pretence->text(), "no-s3tc,units=2,no-rgtc");
    const Capabilities driver = pretence->of(wealthy());
    EXPECT_EQ(driver.pretending, "no-s3tc, units=2, no-rgtc");
    EXPECT_FALSE(driver.s3tc || driver.rgtc);
    EXPECT_EQ(driver.textureUnits, 2);
    EXPECT_EQ(Pretence::parse({})->of(wealthy()).pretending, "");
}

TEST(Pretence, GivesNothingThatTheDriverLacks) {
    Capabilities poor;
    poor.textureUnits = 2;
    poor.maxTextureSize = 64;
    const Capabilities driver = lacking("units=4,max-texture-size=1024,max-anisotropy=16,no-s3tc", poor);
    EXPECT_EQ(driver.textureUnits, 2);
    EXPECT_EQ(driver.maxTextureSize, 64);
    EXPECT_EQ(driver.maxAnisotropy, 1);
    EXPECT_FALSE(driver.s3tc);
}

TEST(Pretence, SaysWhatIsWrongWithAWord) {
    struct Case {
        const char* text;
        const char* sentence;
    };
    for (
        const auto& [text, sentence] :
        {Case{"no-s3ct", R"("no-s3ct" cannot be taken away; did you mean "no-s3tc"?)"},
         Case{"unit=2", R"("unit=2" cannot be taken away; did you mean "units"?)"},
         Case{"units", R"(expected units= and a whole number from 1 to 4, found "units")"},
         Case{"units=", R"(expected units= and a whole number from 1 to 4, found "units=")"},
         Case{"units=0", R"(expected units= and a whole number from 1 to 4, found "units=0")"},
         Case{"units=5", R"(expected units= and a whole number from 1 to 4, found "units=5")"},
         Case{"units=2x", R"(expected units= and a whole number from 1 to 4, found "units=2x")"},
         Case{
             "max-texture-size=99999999999",
             R"(expected max-texture-size= and a whole number from 1 to 16384, found "max-texture-size=99999999999")"},
         Case{"no-s3tc=1", R"(no-s3tc takes no number, found "no-s3tc=1")"},
         Case{"no-s3tc=", R"(no-s3tc takes no number, found "no-s3tc=")"}}) {
        const Result<Pretence> pretence = Pretence::parse({text});
        ASSERT_FALSE(pretence) << text;
        EXPECT_EQ(pretence.error().message, sentence);
        EXPECT_EQ(pretence.error().where, "--pretend");
        EXPECT_EQ(pretence.error().code, ErrorCode::OutOfRange);
    }
    for (const char* text : {"", "no-s3tc,", ",no-s3tc", "opengl"}) {
        const Result<Pretence> pretence = Pretence::parse({text});
        ASSERT_FALSE(pretence) << text;
        EXPECT_THAT(pretence.error().message, testing::HasSubstr("expected one of no-multitexture, units, "));
    }
}

TEST(Pretence, IsInTheFactsOfTheDriver) {
    const DriverFacts all = view::driverFacts(wealthy());
    for (const Word& word : words)
        EXPECT_EQ(view::driverFacts(lacking(word.text, wealthy())) == all,
                  std::string_view(word.text) == "no-shaders")
            << word.text;
}

TEST(Pretence, AloneIsADriverThatLacksNothingElse) {
    EXPECT_EQ(Pretence().facts(), DriverFacts());
    EXPECT_FALSE(Pretence::parse({"no-s3tc"})->limitsTextures());
    const Result<Pretence> small = Pretence::parse({"max-cube-map-size=16,units=2"});
    EXPECT_TRUE(small->limitsTextures());
    EXPECT_EQ(small->facts().maxCubeMapSize, 16);
    EXPECT_EQ(small->facts().textureUnits, 2);
}

// --- What is drawn then

class Pretending : public RenderTest {
protected:
    void pretend(const std::string& what) {
        auto made = makeRenderer(lacking(what, capabilities));
        ASSERT_TRUE(made) << describe(made.error());
        renderer = std::move(*made);
    }
};

TEST_F(Pretending, FewUnitsDrawsThoseAndNamesTheOthers) {
    images.put("image", plainImage(2, 2, {128, 128, 128, 255}));
    Scene scene = texturedScene(); // replaces
    for (std::size_t u = 1; u < maxUnits; ++u) {
        scene.passes[0].units[u] = scene.passes[0].units[0];
        scene.passes[0].units[u].envMode = EnvMode::Modulate;
    }
    const float half = 128.0F / 255;
    EXPECT_TRUE(isColor(onlyColor(scene), {half * half * half * half, half * half * half * half,
                                           half * half * half * half, 1}));
    EXPECT_THAT(problems, IsEmpty());
    pretend("units=3");
    EXPECT_TRUE(isColor(onlyColor(scene), {half * half * half, half * half * half, half * half * half, 1}));
    EXPECT_THAT(problems,
                ElementsAre("passes[0].units[3]: the driver has 3 texture units; drawn without this one"));
    pretend("no-multitexture");
    EXPECT_TRUE(isColor(onlyColor(scene), {half, half, half, 1}));
    EXPECT_THAT(problems,
                ElementsAre("passes[0].units[1]: the driver has 1 texture unit; drawn without this one",
                            "passes[0].units[2]: the driver has 1 texture unit; drawn without this one",
                            "passes[0].units[3]: the driver has 1 texture unit; drawn without this one"));
}

// What stands for multitexture where there is none: a pass more, that multiplies.
TEST_F(Pretending, NoMultitextureLeavesThePassesThatDoTheSame) {
    images.put("image", plainImage(2, 2, {128, 64, 255, 255}));
    Scene scene = texturedScene();
    scene.passes.push_back(scene.passes[0]);
    scene.passes[1].blend = true;
    scene.passes[1].blendSrc = BlendFactor::DstColor;
    scene.passes[1].blendDst = BlendFactor::Zero;
    scene.passes[1].depthFunc = CompareFunc::LessEqual;
    const Image whole = picture(scene);
    pretend("no-multitexture");
    EXPECT_EQ(picture(scene), whole);
    EXPECT_THAT(problems, IsEmpty());
}

TEST_F(Pretending, SmallTexturesRefusesTheOthersButNoPicture) {
    images.put("image", plainImage(64, 64, {255, 0, 0, 255}));
    Scene scene = texturedScene();
    pretend("max-texture-size=32");
    EXPECT_FALSE(picture(scene, 200).empty()); // larger than any texture
    EXPECT_THAT(problems, ElementsAre("textures[0]: 64 × 64 texels exceed the driver's 32 for GL_TEXTURE_2D; "
                                      "drawn without it"));
    images.put("image", plainImage(32, 32, {255, 0, 0, 255}));
    EXPECT_TRUE(isColor(onlyColor(scene), {1, 0, 0, 1}));
    EXPECT_THAT(problems, IsEmpty());
}

TEST_F(Pretending, SmallTexturesDrawsSmallerLevelsLikeTheReference) {
    TextureImage file;
    file.format = "DDS";
    file.levels = 3;
    file.surfaces = {plainImage(64, 64, {255, 0, 0, 255}), plainImage(32, 32, {0, 255, 0, 255}),
                     plainImage(16, 16, {0, 0, 255, 255})};
    images.put("image", std::move(file));
    Scene scene = texturedScene();
    scene.textures[0].oversize = Oversize::Smaller;
    struct Case {
        const char* pretended;
        std::array<float, 4> color;
        Sentence note;
    };
    for (const Case& each :
         {Case{"max-texture-size=64", {1, 0, 0, 1}, {}},
          Case{"max-texture-size=63",
               {0, 1, 0, 1},
               "textures[0]: 64 × 64 texels exceed the driver's 63 for GL_TEXTURE_2D: drawn "
               "from level 1, which has 32 × 32"},
          Case{"max-texture-size=4",
               {0, 0, 1, 1},
               "textures[0]: 64 × 64 texels exceed the driver's 4 for GL_TEXTURE_2D: scaled "
               "down to 4 × 4"}}) {
        SCOPED_TRACE(each.pretended);
        const std::vector<Sentence> notes =
            each.note.empty() ? std::vector<Sentence>() : std::vector{each.note};
        pretend(each.pretended);
        EXPECT_TRUE(isColor(onlyColor(scene), {each.color[0], each.color[1], each.color[2], 1}));
        EXPECT_EQ(std::vector<Sentence>(problems.begin(), problems.end()), notes);
        images.setLimits(Pretence::parse({each.pretended})->facts().limits());
        const Result<Frame> frame = reference::drawReference({scene, images, 0, 8, 8});
        ASSERT_TRUE(frame);
        for (std::size_t i = 0; i < 4; ++i)
            EXPECT_EQ(std::to_integer<int>(frame->image.at(4, 4)[i]), each.color.at(i) * 255);
        EXPECT_EQ(frame->problems, notes);
    }
}

TEST_F(Pretending, PowersOfTwoRefusesTheOthersUnlessTheyAreScaled) {
    images.put("image", plainImage(20, 16, {255, 0, 0, 255}));
    Scene scene = texturedScene();
    pretend("no-npot");
    (void)picture(scene);
    EXPECT_THAT(problems, ElementsAre("textures[0]: 20 × 16 texels: the driver supports powers of two only "
                                      "(no GL_ARB_texture_non_power_of_two); drawn without it"));
    scene.textures[0].npot = NpotPolicy::PowerOfTwo;
    EXPECT_TRUE(isColor(onlyColor(scene), {1, 0, 0, 1}));
    EXPECT_THAT(problems, IsEmpty());
}

TEST_F(Pretending, NoCompressionUploadsThePixels) {
    struct Case {
        BlockFormat format;
        const char* pretended;
        const char* other;
    };
    for (const auto& [format, pretended, other] :
         {Case{BlockFormat::Dxt1, "no-s3tc", "no-rgtc"}, Case{BlockFormat::Bc5, "no-rgtc", "no-s3tc"}}) {
        SCOPED_TRACE(pretended);
        BlockImage blocks = BlockImage::uninitialised(format, 4, 4);
        for (std::size_t i = 0; i < blocks.blocks.size(); ++i)
            blocks.blocks[i] = static_cast<std::byte>(37 * i + 200);
        TextureImage file;
        file.format = "DDS";
        file.surfaces.emplace_back(std::move(blocks));
        images.put("image", std::move(file));
        Scene scene = texturedScene();
        scene.textures[0].compression = Compression::FromFile;
        scene.textures[0].mipmaps = MipPolicy::FromFile;
        pretend(other);
        const Image whole = picture(scene, 32);
        EXPECT_THAT(problems, IsEmpty());
        pretend(pretended);
        const Image pixels = picture(scene, 32);
        EXPECT_THAT(problems, ElementsAre(testing::HasSubstr("uploaded decompressed")));
        const Result<Difference> apart = compare(whole, pixels, 2);
        ASSERT_TRUE(apart);
        EXPECT_EQ(apart->over, 0U) << apart->max;
    }
}

TEST_F(Pretending, NoAnisotropyFiltersWithout) {
    Scene scene = defaultScene();
    scene.models = {Model{}};
    scene.models[0].shape = Shape::Floor;
    const Image plain = picture(scene, 64);
    scene.textures[0].maxAnisotropy = 8;
    EXPECT_NE(picture(scene, 64), plain);
    pretend("no-anisotropy");
    EXPECT_EQ(picture(scene, 64), plain);
    EXPECT_THAT(problems,
                ElementsAre("textures[0]: an anisotropy of 8 exceeds the driver's 1; drawn with that"));
}

TEST_F(Pretending, NoShadersHasNoShaderRenderer) {
    const Capabilities poor = lacking("no-shaders", capabilities);
    EXPECT_FALSE(render::offeredRenderers(poor).has(RendererKind::Shader));
    EXPECT_TRUE(render::offeredRenderers(poor).has(RendererKind::Fixed));
    const auto refused = render::ShaderRenderer::create(poor);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().message,
              "the shader renderer needs OpenGL 3.3 with GLSL 3.30, which --pretend disables");
}

} // namespace
} // namespace texplorer::pretence_test

// Each row is a mistake, its finding and where it is shown, and what fixes it: the offered fix, or an edit.

#include "texplorer/diagnosis/diagnosis.h"
#include "texplorer/scene/params/params.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

namespace texplorer::diagnosis_test {
namespace {

struct Stage {
    Scene scene = defaultScene();
    ImageSource images;
    DriverFacts driver;

    Texture& texture() { return scene.textures[0]; }
    Pass& pass() { return scene.passes[0]; }
    Unit& unit(std::size_t index = 0) { return scene.passes[0].units[index]; }
    Combine& combine() {
        unit().envMode = EnvMode::Combine;
        return unit().combine;
    }
    void showFile(int width, int height, int levels = 1) {
        texture().source = SourceKind::File;
        texture().file = "image";
        TextureImage image;
        image.levels = levels;
        for (int level = 0; level < levels; ++level)
            image.surfaces.emplace_back(Image::uninitialised(PixelFormat::Rgba8, std::max(1, width >> level),
                                                             std::max(1, height >> level)));
        images.put("image", std::move(image));
    }
    /// A gradient from black at the bottom left to white at the top right, or squares of both.
    void showGreys(bool smooth) {
        texture().source = SourceKind::File;
        texture().file = "greys";
        Image image = Image::uninitialised(PixelFormat::Luminance8, 128, 128);
        for (int y = 0; y < 128; ++y) {
            for (int x = 0; x < 128; ++x)
                image.at(x, y)[0] = static_cast<std::byte>(smooth                     ? x + y
                                                           : (x / 8 + y / 8) % 2 == 0 ? 0
                                                                                      : 255);
        }
        images.put("greys", std::move(image));
    }
    [[nodiscard]] std::vector<Finding> findings() const { return diagnose(scene, images, driver); }
};

const Finding* find(const std::vector<Finding>& findings, std::string_view rule, std::string_view path) {
    for (const Finding& each : findings) {
        if (each.rule == rule && each.path == path)
            return &each;
    }
    return nullptr;
}

struct Row {
    const char* name;
    const char* rule;
    Severity severity;
    const char* path;
    const char* words; ///< part of the sentence
    void (*spoil)(Stage& s);
    void (*mend)(Stage& s) = nullptr; ///< nullptr: the finding's fixes do
};

void PrintTo(const Row& row, std::ostream* out) {
    *out << row.name;
}

class Diagnosis : public testing::TestWithParam<Row> {};

TEST_P(Diagnosis, FindsItAndNoLongerOnceItIsMended) {
    const Row& row = GetParam();
    Stage stage;
    row.spoil(stage);
    const std::vector<Finding> findings = stage.findings();
    const Finding* found = find(findings, row.rule, row.path);
    ASSERT_NE(found, nullptr);
    EXPECT_EQ(found->severity, row.severity);
    EXPECT_THAT(found->sentence, testing::HasSubstr(row.words));
    ASSERT_TRUE(row.mend || !found->fixes.empty());
    if (row.mend) {
        row.mend(stage);
        EXPECT_EQ(find(stage.findings(), row.rule, row.path), nullptr);
    }
    for (const Fix& fix : found->fixes) {
        Stage mended = stage;
        if (row.mend)
            row.spoil(mended);
        const Result<void> applied = apply(fix, mended.scene);
        ASSERT_TRUE(applied) << describe(applied.error());
        EXPECT_EQ(find(mended.findings(), row.rule, row.path), nullptr) << fix.label;
    }
}

using enum Severity;
constexpr float infinite = std::numeric_limits<float>::infinity();

void cubeOfFewTexels(Stage& s) {
    s.unit().target = Target::CubeMap;
    s.texture().pattern = Pattern::CubeFaces; // 128 x 128
    s.texture().baseLevel = 4;
    s.texture().wrapS = s.texture().wrapT = Wrap::ClampToEdge;
}

INSTANTIATE_TEST_SUITE_P(
    Texture, Diagnosis,
    testing::Values(
        Row{"NoFile", "missing-file", Error, "textures[0].file", "names none",
            [](Stage& s) { s.texture().source = SourceKind::File; },
            [](Stage& s) { s.texture().source = SourceKind::Pattern; }},
        Row{"FileNotThere", "missing-file", Error, "textures[0].file", "earth.jpg can't be found or read",
            [](Stage& s) {
                s.texture().source = SourceKind::File;
                s.texture().file = "earth.jpg";
            },
            [](Stage& s) { s.showFile(4, 4); }},
        Row{"NoMipmaps", "incomplete", Warning, "textures[0].minFilter", "level 1 is missing",
            [](Stage& s) { s.texture().mipmaps = MipPolicy::None; }},
        Row{"NoMipmapsByFilter", "incomplete", Warning, "textures[0].minFilter", "GL_LINEAR_MIPMAP_LINEAR",
            [](Stage& s) { s.texture().mipmaps = MipPolicy::None; },
            [](Stage& s) { s.texture().minFilter = MinFilter::Linear; }},
        Row{"OneMissing", "incomplete", Warning, "textures[0].mipmaps", "level 3 is missing",
            [](Stage& s) { s.texture().mipmaps = MipPolicy::Missing; }},
        Row{"BaseBeyondTheLevels", "incomplete", Warning, "textures[0].baseLevel", "base level is 50",
            [](Stage& s) { s.texture().baseLevel = 50; }},
        Row{"BaseAboveMax", "incomplete", Warning, "textures[0].baseLevel", "exceeds its maximal level 2",
            [](Stage& s) {
                s.texture().baseLevel = 3;
                s.texture().maxLevel = 2;
            }},
        Row{"BaseAboveTheFilesLast", "incomplete", Warning, "textures[0].baseLevel", "base level is 2",
            [](Stage& s) {
                s.showFile(8, 8, 2);
                s.texture().mipmaps = MipPolicy::FromFile;
                s.texture().baseLevel = 2;
            }},
        Row{"LodLimitsExchanged", "lod-range", Warning, "textures[0].minLod", "undefined",
            [](Stage& s) {
                s.texture().minLod = 3;
                s.texture().maxLod = 1;
            }},
        Row{"AnisotropyBeyondTheDriver", "anisotropy-limit", Warning, "textures[0].maxAnisotropy",
            "16 exceeds the driver's 8",
            [](Stage& s) {
                s.driver.maxAnisotropy = 8;
                s.texture().maxAnisotropy = 16;
            }},
        Row{"NoAnisotropyAtAll", "anisotropy-limit", Warning, "textures[0].maxAnisotropy",
            "has no anisotropic",
            [](Stage& s) {
                s.driver.maxAnisotropy = 1;
                s.texture().maxAnisotropy = 2;
            }},
        Row{"AnisotropyThatTheDriverDoesNotSurvive", "held-back", Warning, "textures[0].maxAnisotropy",
            "drawn without anisotropy",
            [](Stage& s) {
                s.driver.renderer = "llvmpipe (LLVM 15.0.6, 256 bits)";
                s.unit().target = Target::Texture1D;
                s.texture().maxAnisotropy = 2;
            }},
        Row{"AnisotropyThatTheDriverIgnores", "held-back", Warning, "textures[0].maxAnisotropy",
            "compares no depths",
            [](Stage& s) {
                s.driver.renderer = "llvmpipe (LLVM 15.0.6, 256 bits)";
                s.texture().internalFormat = InternalFormat::DepthComponent24;
                s.texture().compareMode = CompareMode::RToTexture;
                s.texture().maxAnisotropy = 2;
            }},
        Row{"AnisotropyWithoutEndAnywhere", "held-back-elsewhere", Note, "textures[0].maxAnisotropy",
            "q runs through 0",
            [](Stage& s) {
                s.texture().maxAnisotropy = 2;
                s.unit().texGenQ.enabled = true;
                s.unit().texGenQ.mode = TexGenMode::ObjectLinear;
                s.unit().texGenQ.objectPlane = {1, 0, 0, 0};
            }},
        Row{"AnisotropyWithoutEndLater", "held-back-elsewhere", Note, "textures[0].maxAnisotropy",
            "q runs through 0",
            [](Stage& s) {
                s.texture().maxAnisotropy = 2;
                MatrixStep row{.op = MatrixOp::Multiply};
                row.matrix[0].w = 1;
                row.matrix[3].w = -3.5F; // q = s - 3.5
                s.unit().matrix = {row,
                                   {.op = MatrixOp::Translate, .amount = {0, 0, 0}, .rate = {1.5F, 0, 0}}};
            }},
        Row{"AnisotropyWithoutEndAtAKey", "held-back-elsewhere", Note, "textures[0].maxAnisotropy",
            "q runs through 0",
            [](Stage& s) {
                s.texture().maxAnisotropy = 2;
                s.unit().texGenQ.enabled = true;
                s.unit().texGenQ.mode = TexGenMode::ObjectLinear;
                s.unit().texGenQ.objectPlane = {1, 0, 0, 10};
                s.scene.timeline.keys = {
                    {30, "passes[0].units[0].texGenQ.objectPlane", "1,0,0,10", Easing::Hold},
                    {31, "passes[0].units[0].texGenQ.objectPlane", "1,0,0,0", Easing::Hold}};
            }},
        Row{"NonPowerOfTwo", "non-power-of-two", Warning, "textures[0].npot", "6 × 4",
            [](Stage& s) {
                s.driver.nonPowerOfTwo = false;
                s.showFile(6, 4);
            }},
        Row{"TooLarge", "size-limit", Error, "textures[0].file", "64 × 2 texels exceed the driver's 32",
            [](Stage& s) {
                s.driver.maxTextureSize = 32;
                s.showFile(64, 2);
            },
            [](Stage& s) { s.showFile(32, 2); }},
        Row{"LevelTooLarge", "level-size-limit", Error, "textures[0].levels[1]",
            "64 × 2 texels exceed the driver's 32 for level 2",
            [](Stage& s) {
                s.driver.maxTextureSize = 128;
                s.showFile(64, 2);
                s.texture().source = SourceKind::Pattern;
                s.texture().mipmaps = MipPolicy::Given;
                s.texture().levels.resize(2);
                s.texture().levels[1] = {.source = SourceKind::File, .file = "image"};
            },
            [](Stage& s) { s.driver.maxTextureSize = 256; }},
        Row{"LevelThatTheDriverHasNot", "level-size-limit", Error, "textures[0].levels[14]",
            "the driver has no level 15",
            [](Stage& s) {
                s.driver.maxTextureSize = 16384; // level 14 is the last
                s.texture().mipmaps = MipPolicy::Given;
                s.texture().levels.resize(15);
            },
            [](Stage& s) { s.texture().levels.resize(14); }},
        Row{"FacesNotSquare", "incomplete", Warning, "textures[0].file",
            "must be square, and they have 8 × 4",
            [](Stage& s) {
                s.showFile(8, 4);
                s.unit().target = Target::CubeMap;
            },
            [](Stage& s) { s.showFile(24, 4); }},
        Row{"CubeTooLarge", "size-limit", Error, "textures[0].file", "64 × 64 texels exceed the driver's 32",
            [](Stage& s) {
                s.driver.maxCubeMapSize = 32;
                s.showFile(384, 64);
                s.unit().target = Target::CubeMap;
            },
            [](Stage& s) { s.showFile(192, 32); }},
        Row{"CubeSeams", "cube-seams", Warning, "textures[0].wrapS", "GL_REPEAT reads beyond the edge",
            [](Stage& s) { s.unit().target = Target::CubeMap; }},
        Row{"CubeSeamsOfT", "cube-seams", Warning, "textures[0].wrapT", "GL_CLAMP reads beyond the edge",
            [](Stage& s) {
                s.unit().target = Target::CubeMap;
                s.texture().wrapS = Wrap::ClampToEdge;
                s.texture().wrapT = Wrap::Clamp;
            },
            [](Stage& s) {
                s.texture().minFilter = MinFilter::Nearest;
                s.texture().magFilter = MagFilter::Nearest;
            }},
        Row{"CubeSeamsUnlessSeamless", "cube-seams", Warning, "textures[0].wrapS", "shows as a seam",
            [](Stage& s) { s.unit().target = Target::CubeMap; },
            [](Stage& s) { s.pass().seamlessCubeMap = true; }},
        Row{"CubeOfFewTexels", "cube-edges", Note, "passes[0].seamlessCubeMap",
            "each face of textures[0] has 8 × 8 texels", cubeOfFewTexels},
        Row{"CubeOfFewTexelsUnlessNearest", "cube-edges", Note, "passes[0].seamlessCubeMap",
            "filtered on its own", cubeOfFewTexels,
            [](Stage& s) {
                s.texture().minFilter = MinFilter::NearestMipmapLinear;
                s.texture().magFilter = MagFilter::Nearest;
            }},
        Row{"CubeOfFewTexelsUnlessMore", "cube-edges", Note, "passes[0].seamlessCubeMap", "seams show",
            cubeOfFewTexels, [](Stage& s) { s.texture().baseLevel = 0; }},
        Row{"NoSeamlessCubeMaps", "no-seamless-cube-maps", Warning, "passes[0].seamlessCubeMap",
            "the driver has no seamless cube maps",
            [](Stage& s) {
                cubeOfFewTexels(s);
                s.pass().seamlessCubeMap = true;
                s.driver.seamlessCubeMaps = false;
            }},
        Row{"NoSeamlessCubeMapsToOffer", "cube-edges", Note, "passes[0].seamlessCubeMap", "seams show",
            cubeOfFewTexels, [](Stage& s) { s.driver.seamlessCubeMaps = false; }},
        Row{"SeamlessWithoutACubeMap", "seamless-in-vain", Hint, "passes[0].seamlessCubeMap",
            "no unit of this pass shows a cube map", [](Stage&) {},
            [](Stage& s) { s.unit().target = Target::CubeMap; }},
        Row{"SeamlessUnderNearest", "seamless-in-vain", Hint, "passes[0].seamlessCubeMap",
            "GL_NEAREST reads one texel",
            [](Stage& s) {
                cubeOfFewTexels(s);
                s.texture().minFilter = MinFilter::Nearest;
                s.texture().magFilter = MagFilter::Nearest;
            },
            [](Stage& s) { s.texture().magFilter = MagFilter::Linear; }},
        Row{"WrapOfASeamlessCubeMap", "texture-setting", Hint, "textures[0].wrapS", "whatever the wrap modes",
            [](Stage& s) {
                cubeOfFewTexels(s);
                s.pass().seamlessCubeMap = true;
            },
            [](Stage& s) { s.pass().seamlessCubeMap = false; }},
        Row{"FlatDirection", "flat-direction", Warning, "passes[0].units[0].target", "r is 0 at every vertex",
            [](Stage& s) { s.unit().target = Target::CubeMap; }},
        Row{"FlatDirectionOfVertices", "flat-direction", Warning, "passes[0].units[0].target",
            "as a direction", [](Stage& s) { s.unit().target = Target::CubeMap; },
            [](Stage& s) {
                s.scene.models[0].texCoords[0].assign(24, {1, 1, 1, 1});
            }},
        Row{"GivenLevelsOnLlvmpipe", "rough-lambda", Note, "textures[0].minFilter", "up to 0.1 off",
            [](Stage& s) {
                s.driver.renderer = "llvmpipe (LLVM 15.0.6, 256 bits)";
                s.texture().mipmaps = MipPolicy::Given;
                s.texture().levels.resize(6);
            },
            [](Stage& s) { s.texture().mipmaps = MipPolicy::Generated; }},
        Row{"LostBorder", "lost-border", Warning, "textures[0].border", "the reference renderer shows",
            [](Stage& s) {
                s.driver.textureBorders = false;
                s.texture().border = 1;
            }},
        Row{"BorderNotSeen", "texture-setting", Hint, "textures[0].border", "no wrap mode shows the border",
            [](Stage& s) { s.texture().border = 1; },
            [](Stage& s) { s.texture().wrapT = Wrap::ClampToBorder; }},
        Row{"BorderNotSeenUnlessCutOff", "texture-setting", Hint, "textures[0].border", "no wrap mode",
            [](Stage& s) {
                s.texture().border = 1;
                s.showFile(64, 64);
            },
            [](Stage& s) { s.showFile(66, 66); }},
        Row{"OwnBorder", "own-border", Hint, "textures[0].borderColor", "a border of texels",
            [](Stage& s) { s.texture().border = 1; }, [](Stage& s) { s.driver.textureBorders = false; }},
        Row{"IgnoredHint", "ignored-hint", Warning, "view.perspectiveHint", "may ignore this hint",
            [](Stage& s) { s.scene.view.perspectiveHint = HintMode::Fastest; }},
        Row{"NoPerspective", "no-perspective", Hint, "view.perspectiveHint", "no perspective to correct",
            [](Stage& s) { s.scene.view.projection = Projection::Orthographic; },
            [](Stage& s) { s.scene.view.projection = Projection::Perspective; }},
        Row{"NoS3tc", "missing-format", Warning, "textures[0].compression", "DXT1",
            [](Stage& s) {
                s.driver.s3tc = false;
                s.texture().compression = Compression::Driver;
            },
            [](Stage& s) { s.driver.s3tc = true; }}),
    [](const auto& test) { return std::string(test.param.name); });

INSTANTIATE_TEST_SUITE_P(
    LevelsAndPreparation, Diagnosis,
    testing::Values(
        Row{"TooFewLevels", "incomplete", Warning, "textures[0].mipmaps", "level 2 is missing",
            [](Stage& s) {
                s.texture().mipmaps = MipPolicy::Given;
                s.texture().levels.resize(1);
            },
            [](Stage& s) { s.texture().levels.resize(6); }}, // below 64 x 64 texels
        Row{"TooFewLevelsUnlessTheyAreNotRead", "incomplete", Warning, "textures[0].mipmaps", "level 2",
            [](Stage& s) {
                s.texture().mipmaps = MipPolicy::Given;
                s.texture().levels.resize(1);
            },
            [](Stage& s) { s.texture().maxLevel = 1; }},
        Row{"LevelOfAnotherSize", "incomplete", Warning, "textures[0].levels[1].file",
            "level 2 should have 16 × 16 texels and has 8 × 2",
            [](Stage& s) {
                s.showFile(8, 2);
                s.texture().source = SourceKind::Pattern;
                s.texture().mipmaps = MipPolicy::Given;
                s.texture().levels.resize(6);
                s.texture().levels[1] = {.source = SourceKind::File, .file = "image"};
            },
            [](Stage& s) { s.texture().levels[1].source = SourceKind::Pattern; }},
        Row{"LevelWithoutAFile", "missing-part", Error, "textures[0].levels[0].file", "none is named",
            [](Stage& s) {
                s.texture().mipmaps = MipPolicy::Given;
                s.texture().levels = {{.source = SourceKind::File}};
            },
            [](Stage& s) { s.texture().mipmaps = MipPolicy::Generated; }},
        Row{"AlphaWithoutAFile", "missing-part", Error, "textures[0].preparation[0].file",
            "gone.png can't be found or read: the step is skipped",
            [](Stage& s) {
                s.texture().preparation = {
                    {.op = ImageOp::AlphaFrom, .source = SourceKind::File, .file = "gone.png"}};
            },
            [](Stage& s) { s.texture().preparation[0].op = ImageOp::Invert; }},
        Row{"DepthsThatAreNotPrepared", "depths-not-prepared", Hint, "textures[0].preparation",
            "not changed before they are compared",
            [](Stage& s) {
                s.texture().source = SourceKind::LightDepth;
                s.texture().internalFormat = InternalFormat::DepthComponent24;
                s.texture().preparation = {{.op = ImageOp::Invert}};
            },
            [](Stage& s) { s.texture().internalFormat = InternalFormat::Luminance; }},
        Row{"LevelsThatAreNotRead", "levels-not-read", Hint, "textures[0].levels",
            "not read with mipmaps=generated", [](Stage& s) { s.texture().levels.resize(1); },
            [](Stage& s) { s.texture().mipmaps = MipPolicy::Given; }},
        Row{"AlphaThatTheFormatDrops", "lost-alpha", Hint, "textures[0].preparation[0]",
            "GL_RGB keeps no alpha",
            [](Stage& s) {
                s.texture().internalFormat = InternalFormat::Rgb;
                s.texture().preparation = {{.op = ImageOp::AlphaFrom}};
            },
            [](Stage& s) { s.texture().internalFormat = InternalFormat::Rgba; }},
        Row{"AlphaThatIsMadeAgain", "lost-alpha", Hint, "textures[0].preparation[0]", "a later step",
            [](Stage& s) {
                s.texture().preparation = {{.op = ImageOp::AlphaFrom}, {.op = ImageOp::LuminanceToAlpha}};
            },
            [](Stage& s) { s.texture().preparation[1].op = ImageOp::Invert; }},
        Row{"AlphaBeforeAStencil", "lost-alpha", Hint, "textures[0].preparation[0]",
            "transparency=stencil replaces alpha",
            [](Stage& s) {
                s.texture().transparency = Transparency::Stencil;
                s.texture().preparation = {{.op = ImageOp::LuminanceToAlpha}};
            },
            [](Stage& s) { s.texture().transparency = Transparency::Alpha; }},
        Row{"FileOfALevelOfAPattern", "other-texture-choice", Unused, "textures[0].levels[0].file", "pattern",
            [](Stage& s) { s.texture().levels.resize(1); },
            [](Stage& s) { s.texture().levels[0].source = SourceKind::File; }},
        Row{"PatternOfAStepWithoutOne", "other-texture-choice", Unused, "textures[0].preparation[0].pattern",
            "invert", [](Stage& s) { s.texture().preparation = {{.op = ImageOp::Invert}}; },
            [](Stage& s) { s.texture().preparation[0].op = ImageOp::AlphaFrom; }},
        Row{"FactorOfAStepWithoutOne", "other-texture-choice", Unused, "textures[0].preparation[0].factor",
            "sharpen", [](Stage& s) { s.texture().preparation = {{.op = ImageOp::Sharpen}}; },
            [](Stage& s) { s.texture().preparation[0].op = ImageOp::Scale; }}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(DiagnosisOfAll, OffersAPatternForALevelOfAnotherSize) {
    Stage stage;
    stage.showFile(8, 2);
    stage.texture().source = SourceKind::Pattern;
    stage.texture().mipmaps = MipPolicy::Given;
    stage.texture().levels.resize(6);
    stage.texture().levels[1] = {.source = SourceKind::File, .file = "image"};
    const std::vector<Finding> findings = stage.findings();
    const Finding* found = find(findings, "incomplete", "textures[0].levels[1].file");
    ASSERT_NE(found, nullptr);
    ASSERT_FALSE(found->fixes.empty());
    EXPECT_EQ(found->fixes[0].label, "Put a pattern on level 2");
    ASSERT_TRUE(apply(found->fixes[0], stage.scene));
    EXPECT_EQ(find(stage.findings(), "incomplete", "textures[0].levels[1].file"), nullptr);
}

INSTANTIATE_TEST_SUITE_P(
    Format, Diagnosis,
    testing::Values(Row{"Bands", "banding", Note, "textures[0].internalFormat",
                        "GL_RGB4 has at most 16 steps",
                        [](Stage& s) {
                            s.showGreys(true);
                            s.texture().internalFormat = InternalFormat::Rgb4;
                        }},
                    Row{"BandsUnlessTheImageHasSteps", "banding", Note, "textures[0].internalFormat", "bands",
                        [](Stage& s) {
                            s.showGreys(true);
                            s.texture().internalFormat = InternalFormat::R3G3B2;
                        },
                        [](Stage& s) { s.showGreys(false); }},
                    Row{"BandsUnlessCompressed", "banding", Note, "textures[0].internalFormat", "bands",
                        [](Stage& s) {
                            s.showGreys(true);
                            s.texture().internalFormat = InternalFormat::Luminance4;
                        },
                        [](Stage& s) { s.texture().compression = Compression::Cached; }},
                    Row{"SrgbNotEncoded", "srgb-not-encoded", Note, "textures[0].internalFormat",
                        "darker than the image",
                        [](Stage& s) { s.texture().internalFormat = InternalFormat::Srgb8Alpha8; }},
                    Row{"SrgbLevels", "srgb-levels", Warning, "textures[0].mipGamma", "too dark",
                        [](Stage& s) { s.texture().internalFormat = InternalFormat::Sluminance8; }},
                    Row{"SrgbLevelsOfGlu", "srgb-levels", Warning, "textures[0].mipmaps", "too dark",
                        [](Stage& s) {
                            s.texture().internalFormat = InternalFormat::Sluminance8;
                            s.texture().mipmaps = MipPolicy::Glu;
                        }},
                    Row{"SrgbLevelsUnlessTheDriverMakesThem", "srgb-levels", Warning, "textures[0].mipGamma",
                        "GL_SRGB8", [](Stage& s) { s.texture().internalFormat = InternalFormat::Srgb8; },
                        [](Stage& s) { s.texture().mipmaps = MipPolicy::GenerateMipmap; }},
                    Row{"SrgbLevelsUnlessSeen", "srgb-levels", Warning, "textures[0].mipGamma", "GL_SRGB8",
                        [](Stage& s) { s.texture().internalFormat = InternalFormat::Srgb8; },
                        [](Stage& s) { s.texture().minFilter = MinFilter::Linear; }}),
    [](const auto& test) { return std::string(test.param.name); });

INSTANTIATE_TEST_SUITE_P(
    Setting, Diagnosis,
    testing::Values(
        Row{"FlipOfAPattern", "texture-setting", Hint, "textures[0].flip", "upright", [](Stage&) {},
            [](Stage& s) { s.showFile(4, 4); }},
        Row{"FormatOfCompressed", "texture-setting", Hint, "textures[0].internalFormat", "compressed",
            [](Stage& s) { s.texture().compression = Compression::Driver; },
            [](Stage& s) { s.unit().target = Target::Texture1D; }},
        Row{"ScalingAPowerOfTwo", "texture-setting", Hint, "textures[0].npot", "power of two", [](Stage&) {},
            [](Stage& s) { s.showFile(5, 4); }},
        Row{"WrapTOfALine", "texture-setting", Hint, "textures[0].wrapT", "only s",
            [](Stage& s) { s.unit().target = Target::Texture1D; },
            [](Stage& s) { s.unit().target = Target::Texture2D; }},
        Row{"WrapROfAPicture", "texture-setting", Hint, "textures[0].wrapR", "GL_TEXTURE_2D", [](Stage&) {},
            [](Stage& s) { s.unit().target = Target::Texture3D; }},
        Row{"BorderNotShown", "texture-setting", Hint, "textures[0].borderColor", "no wrap mode",
            [](Stage&) {}, [](Stage& s) { s.texture().wrapT = Wrap::ClampToBorder; }},
        Row{"BorderOfClampUnderNearest", "texture-setting", Hint, "textures[0].borderColor", "linear filter",
            [](Stage& s) {
                s.texture().wrapS = Wrap::Clamp;
                s.texture().minFilter = MinFilter::NearestMipmapLinear;
                s.texture().magFilter = MagFilter::Nearest;
            },
            [](Stage& s) { s.texture().magFilter = MagFilter::Linear; }},
        Row{"BorderOfRWithoutR", "texture-setting", Hint, "textures[0].borderColor", "no wrap mode",
            [](Stage& s) { s.texture().wrapR = Wrap::ClampToBorder; },
            [](Stage& s) { s.unit().target = Target::Texture3D; }},
        Row{"MipFilterUnread", "texture-setting", Hint, "textures[0].mipFilter",
            "GL_NEAREST reads no mipmaps", [](Stage& s) { s.texture().minFilter = MinFilter::Nearest; },
            [](Stage& s) { s.texture().minFilter = MinFilter::NearestMipmapNearest; }},
        Row{"MaxLevelUnread", "texture-setting", Hint, "textures[0].maxLevel", "GL_LINEAR reads no mipmaps",
            [](Stage& s) { s.texture().minFilter = MinFilter::Linear; },
            [](Stage& s) { s.texture().minFilter = MinFilter::LinearMipmapNearest; }},
        Row{"MinLodUnread", "texture-setting", Hint, "textures[0].minLod", "both filters are the same",
            [](Stage& s) { s.texture().minFilter = MinFilter::Linear; },
            [](Stage& s) { s.texture().magFilter = MagFilter::Nearest; }},
        Row{"LodBiasOfTheTextureUnread", "texture-setting", Hint, "textures[0].lodBias",
            "both filters are the same", [](Stage& s) { s.texture().minFilter = MinFilter::Linear; },
            [](Stage& s) { s.texture().magFilter = MagFilter::Nearest; }},
        Row{"MaxLodUnread", "texture-setting", Hint, "textures[0].maxLod", "both filters are the same",
            [](Stage& s) { s.texture().minFilter = MinFilter::Linear; },
            [](Stage& s) { s.texture().magFilter = MagFilter::Nearest; }},
        Row{"TextureNotShown", "texture-not-shown", Hint, "textures[0]", "no enabled unit",
            [](Stage& s) { s.unit().enabled = false; }, [](Stage& s) { s.unit(2).enabled = true; }},
        Row{"FileOfAPattern", "other-texture-choice", Unused, "textures[0].file", "pattern", [](Stage&) {},
            [](Stage& s) { s.showFile(4, 4); }},
        Row{"PatternOfAFile", "other-texture-choice", Unused, "textures[0].pattern", "file",
            [](Stage& s) { s.showFile(4, 4); }, [](Stage& s) { s.texture().source = SourceKind::Pattern; }},
        Row{"ColourWithoutStencil", "other-texture-choice", Unused, "textures[0].stencilColor", "file",
            [](Stage&) {}, [](Stage& s) { s.texture().transparency = Transparency::Stencil; }},
        Row{"FormatWithoutCompression", "other-texture-choice", Unused, "textures[0].compressedFormat",
            "file", [](Stage&) {}, [](Stage& s) { s.texture().compression = Compression::Driver; }},
        Row{"MipGammaOfColours", "other-texture-choice", Unused, "textures[0].mipGamma", "colored",
            [](Stage& s) { s.texture().mipmaps = MipPolicy::Colored; },
            [](Stage& s) { s.texture().mipmaps = MipPolicy::Generated; }},
        Row{"ScalingByGlu", "other-texture-choice", Unused, "textures[0].npot", "gluBuild2DMipmaps",
            [](Stage& s) { s.texture().mipmaps = MipPolicy::Glu; },
            [](Stage& s) { s.texture().mipmaps = MipPolicy::GenerateMipmap; }},
        Row{"FilterOfTheDriver", "other-texture-choice", Unused, "textures[0].mipFilter", "glGenerateMipmap",
            [](Stage& s) { s.texture().mipmaps = MipPolicy::GenerateMipmap; },
            [](Stage& s) { s.texture().mipmaps = MipPolicy::Generated; }},
        Row{"ScalingOfFileLevels", "other-texture-choice", Unused, "textures[0].npot", "file",
            [](Stage& s) { s.texture().mipmaps = MipPolicy::FromFile; },
            [](Stage& s) { s.texture().mipmaps = MipPolicy::None; }}),
    [](const auto& test) { return std::string(test.param.name); });

INSTANTIATE_TEST_SUITE_P(
    Unit, Diagnosis,
    testing::Values(
        Row{"NoSuchTexture", "missing-texture", Error, "passes[0].units[0].texture", "there is no texture 7",
            [](Stage& s) { s.unit().texture = 7; }},
        Row{"NegativeTexture", "missing-texture", Error, "passes[0].units[0].texture",
            "there is no texture -1", [](Stage& s) { s.unit().texture = -1; }},
        Row{"NoTextureAtAll", "missing-texture", Error, "passes[0].units[0].texture", "the scene has 0",
            [](Stage& s) { s.scene.textures.clear(); }},
        Row{"TooFewUnits", "unit-limit", Warning, "passes[0].units[2].enabled", "has 2 texture units",
            [](Stage& s) {
                s.driver.textureUnits = 2;
                s.unit(2).enabled = true;
            },
            [](Stage& s) { s.driver.textureUnits = 3; }},
        Row{"OneUnit", "unit-limit", Warning, "passes[0].units[1].enabled",
            "has 1 texture unit: drawn without this one; one more pass with its texture alone, blended "
            "with GL_DST_COLOR and GL_ZERO",
            [](Stage& s) {
                s.driver.textureUnits = 1;
                s.unit(1).enabled = true;
            }},
        Row{"OneUnitThatCombines", "unit-limit", Warning, "passes[0].units[1].enabled",
            "use more passes with blending instead of more units",
            [](Stage& s) {
                s.driver.textureUnits = 1;
                s.unit(1).enabled = true;
                s.unit(1).envMode = EnvMode::Combine;
            }},
        Row{"DecalOfLuminance", "undefined-decal", Warning, "passes[0].units[0].envMode",
            "GL_LUMINANCE texture",
            [](Stage& s) {
                s.unit().envMode = EnvMode::Decal;
                s.texture().internalFormat = InternalFormat::Luminance;
            }},
        Row{"DecalOfIntensity", "undefined-decal", Warning, "passes[0].units[0].envMode", "GL_INTENSITY",
            [](Stage& s) {
                s.unit().envMode = EnvMode::Decal;
                s.texture().internalFormat = InternalFormat::Intensity;
            },
            [](Stage& s) { s.texture().compression = Compression::Driver; }},
        Row{"CrossbarOfAUnitThatIsOff", "undefined-crossbar", Warning,
            "passes[0].units[0].combine.source1Rgb", "GL_TEXTURE2 is undefined: unit 2 is off",
            [](Stage& s) { s.combine().source1Rgb = CombineSource::Texture2; }},
        Row{"CrossbarOfAUnitWithoutTexture", "undefined-crossbar", Warning,
            "passes[0].units[0].combine.source1Rgb",
            "GL_TEXTURE2 is undefined: unit 2 has no complete texture",
            [](Stage& s) {
                s.combine().source1Rgb = CombineSource::Texture2;
                s.unit(2).enabled = true;
                s.unit(2).texture = 9;
            },
            [](Stage& s) { s.unit(2).texture = 0; }},
        Row{"CoordinatesWithoutDirection", "no-tangent", Warning, "passes[0].units[0].emboss.enabled",
            "at all of the 24 vertices of models[0] the coordinates give no direction on the surface",
            [](Stage& s) {
                s.scene.models[0].texCoords[0].assign(24, {0, 0, 0, 1});
                s.unit().emboss.enabled = true;
            },
            [](Stage& s) { s.unit().emboss.enabled = false; }},
        Row{"CoordinatesWithoutDirectionAtThePoles", "no-tangent", Warning,
            "passes[0].units[0].emboss.enabled",
            " vertices of models[1] the coordinates give no direction on the surface",
            [](Stage& s) { s.unit().emboss.enabled = true; },
            [](Stage& s) { s.scene.models[1].visible = false; }},
        Row{"CrossbarSwitchedOn", "undefined-crossbar", Warning, "passes[0].units[0].combine.source0Alpha",
            "GL_TEXTURE1", [](Stage& s) { s.combine().source0Alpha = CombineSource::Texture1; },
            [](Stage& s) { s.unit(1).enabled = true; }},
        Row{"CrossbarOfAnUnreadArgument", "undefined-crossbar", Warning,
            "passes[0].units[0].combine.source2Rgb", "unit 3",
            [](Stage& s) {
                s.combine().source2Rgb = CombineSource::Texture3;
                s.combine().rgb = CombineRgb::Interpolate;
            },
            [](Stage& s) { s.combine().rgb = CombineRgb::Modulate; }},
        Row{"ScaleOfZero", "collapsing-matrix", Warning, "passes[0].units[0].matrix[0].amount", "same t",
            [](Stage& s) {
                s.unit().matrix = {{MatrixOp::Scale, {2, 0, 0}}};
            }},
        Row{"AxisOfZero", "collapsing-matrix", Warning, "passes[0].units[0].matrix[0].amount", "length 0",
            [](Stage& s) {
                s.unit().matrix = {{MatrixOp::Rotate, {0, 0, 0}}};
            }},
        Row{"GeneratedQ", "zero-q", Warning, "passes[0].units[0].texGenQ.eyePlane", "q 0 everywhere",
            [](Stage& s) { s.unit().texGenQ.enabled = true; }},
        Row{"GeneratedQOfTheObject", "zero-q", Warning, "passes[0].units[0].texGenQ.objectPlane", "q 0",
            [](Stage& s) {
                s.unit().texGenQ.enabled = true;
                s.unit().texGenQ.mode = TexGenMode::ObjectLinear;
            }},
        Row{"EnvColor", "env-color", Hint, "passes[0].units[0].envColor", "GL_CONSTANT", [](Stage&) {},
            [](Stage& s) { s.unit().envMode = EnvMode::Blend; }},
        Row{"EnvColorOfAlphaBlend", "env-color", Hint, "passes[0].units[0].envColor", "GL_BLEND",
            [](Stage& s) {
                s.unit().envMode = EnvMode::Blend;
                s.texture().internalFormat = InternalFormat::Alpha;
            },
            [](Stage& s) { s.texture().internalFormat = InternalFormat::Luminance; }},
        Row{"EnvColorOfCombine", "env-color", Hint, "passes[0].units[0].envColor", "GL_COMBINE",
            [](Stage& s) { s.combine(); }, [](Stage& s) { s.combine().rgb = CombineRgb::Interpolate; }},
        Row{"LodBias", "lod-bias", Hint, "passes[0].units[0].lodBias", "no mipmaps",
            [](Stage& s) { s.texture().minFilter = MinFilter::Linear; },
            [](Stage& s) { s.texture().minFilter = MinFilter::Nearest; }},
        Row{"PlaneOfTheOtherMode", "generation", Hint, "passes[0].units[0].texGenS.objectPlane",
            "GL_EYE_LINEAR does not", [](Stage& s) { s.unit().texGenS.enabled = true; },
            [](Stage& s) { s.unit().texGenS.mode = TexGenMode::ObjectLinear; }},
        Row{"GenerationOff", "generation", Hint, "passes[0].units[0].texGenT.mode", "own coordinate",
            [](Stage&) {}, [](Stage& s) { s.unit().texGenT.enabled = true; }},
        Row{"GeneratedRUnread", "generation", Hint, "passes[0].units[0].texGenR.enabled", "GL_TEXTURE_2D",
            [](Stage& s) { s.unit().texGenR.enabled = true; },
            [](Stage& s) {
                s.unit().matrix.push_back({MatrixOp::Rotate, {1, 0, 0}});
            }},
        Row{"SecondArgument", "unread-argument", Hint, "passes[0].units[0].combine.operand1Rgb",
            "GL_REPLACE reads 1 argument", [](Stage& s) { s.combine().rgb = CombineRgb::Replace; },
            [](Stage& s) { s.combine().rgb = CombineRgb::Subtract; }},
        Row{"AlphaOfDot3", "unread-argument", Hint, "passes[0].units[0].combine.alpha", "GL_DOT3_RGBA",
            [](Stage& s) { s.combine().rgb = CombineRgb::Dot3Rgba; },
            [](Stage& s) { s.combine().rgb = CombineRgb::Dot3Rgb; }},
        Row{"CombineUnderModulate", "other-environment", Unused, "passes[0].units[0].combine", "GL_MODULATE",
            [](Stage&) {}, [](Stage& s) { s.combine(); }},
        Row{"UnitOff", "unit-off", Hint, "passes[0].units[0]", "the unit is off",
            [](Stage& s) {
                s.unit().enabled = false;
                s.unit().envMode = EnvMode::Replace;
            }},
        Row{"ItsTextureNotShown", "texture-not-shown", Hint, "textures[0]", "no enabled unit",
            [](Stage& s) { s.unit().enabled = false; }},
        Row{"OverruledByReplace", "overruled-unit", Hint, "passes[0].units[0]", "unit 1",
            [](Stage& s) {
                s.unit(1).enabled = true;
                s.unit(1).envMode = EnvMode::Replace;
            },
            [](Stage& s) { s.texture().internalFormat = InternalFormat::Rgb; }},
        Row{"OverruledUnlessAsked", "overruled-unit", Hint, "passes[0].units[0]", "unit 1",
            [](Stage& s) {
                s.unit(1).enabled = true;
                s.unit(1).envMode = EnvMode::Combine;
                s.unit(1).combine.source1Rgb = CombineSource::Texture;
                s.unit(1).combine.source1Alpha = CombineSource::Texture;
            },
            [](Stage& s) { s.unit(1).combine.source0Rgb = CombineSource::Texture0; }},
        Row{"OverruledByTwoTogether", "overruled-unit", Hint, "passes[0].units[0]", "unit 2",
            [](Stage& s) {
                s.unit(1).enabled = s.unit(2).enabled = true;
                for (std::size_t u = 1; u <= 2; ++u) {
                    s.unit(u).envMode = EnvMode::Combine;
                    s.unit(u).combine.rgb = CombineRgb::Replace;
                    s.unit(u).combine.alpha = CombineAlpha::Replace;
                }
                s.unit(1).combine.source0Alpha = CombineSource::Previous; // its colour is the texture's
                s.unit(2).combine.source0Rgb = CombineSource::Previous;   // its alpha is the texture's
            },
            [](Stage& s) { s.unit(2).combine.source0Alpha = CombineSource::Previous; }},
        Row{"OverruledButAskedForItsTexture", "overruled-unit", Hint, "passes[0].units[0].envMode", "unit 1",
            [](Stage& s) {
                s.unit(1).enabled = true;
                s.unit(1).envMode = EnvMode::Combine;
                s.unit(1).combine.rgb = CombineRgb::Replace;
                s.unit(1).combine.alpha = CombineAlpha::Replace;
                s.unit(1).combine.source0Rgb = CombineSource::Texture0;
            },
            [](Stage& s) { s.unit(1).combine.source0Alpha = CombineSource::Previous; }},
        Row{"OverruledUnlessTheDriverLacksTheUnit", "overruled-unit", Hint, "passes[0].units[0]", "unit 1",
            [](Stage& s) {
                s.unit(1).enabled = true;
                s.unit(1).envMode = EnvMode::Replace;
            },
            [](Stage& s) { s.driver.textureUnits = 1; }},
        Row{"TextureOfAnOverruledUnit", "overruled-texture", Hint, "textures[0]", "replace the result",
            [](Stage& s) {
                s.scene.textures.push_back(s.texture());
                s.unit(1).enabled = true;
                s.unit(1).texture = 1;
                s.unit(1).envMode = EnvMode::Replace;
            },
            [](Stage& s) { s.unit(1).texture = 0; }},
        Row{"OverruledUnlessItIsUndefined", "overruled-unit", Hint, "passes[0].units[0]", "unit 2",
            [](Stage& s) {
                s.unit(1).enabled = s.unit(2).enabled = true;
                s.unit(2).envMode = EnvMode::Combine;
                s.unit(2).combine.rgb = CombineRgb::Replace;
                s.unit(2).combine.alpha = CombineAlpha::Replace;
                s.unit(2).combine.source0Rgb = CombineSource::Texture1;
                s.unit(2).combine.source0Alpha = CombineSource::Texture1;
            },
            [](Stage& s) { s.unit(1).enabled = false; }},
        Row{"AngleOfAScale", "other-matrix-operation", Unused, "passes[0].units[0].matrix[0].angle", "rotate",
            [](Stage& s) {
                s.unit().matrix = {{MatrixOp::Scale, {1, 1, 1}}};
            },
            [](Stage& s) { s.unit().matrix[0].op = MatrixOp::Rotate; }}),
    [](const auto& test) { return std::string(test.param.name); });

INSTANTIATE_TEST_SUITE_P(
    Pass, Diagnosis,
    testing::Values(
        Row{"InfiniteCoordinate", "infinite-coordinate", Error, "models[0].texCoords0[1]",
            "the same is true of 1 more",
            [](Stage& s) {
                s.scene.models[0].texCoords[0] = {{0, 0, 0, 1}, {infinite, 0, 0, 1}, {0, NAN, 0, 1}};
            },
            [](Stage& s) { s.scene.models[0].texCoords[0].clear(); }},
        Row{"ZeroQ", "zero-q-of-vertex", Warning, "models[0].texCoords0[0]", "q of vertex 0 is 0",
            [](Stage& s) {
                s.scene.models[0].texCoords[0] = {{1, 1, 0, 0}};
            },
            [](Stage& s) { s.unit().enabled = false; }},
        Row{"NothingPassesAlpha", "nothing-passes", Warning, "passes[0].alphaFunc", "draws nothing",
            [](Stage& s) {
                s.pass().alphaTest = true;
                s.pass().alphaFunc = CompareFunc::Never;
            }},
        Row{"NothingPassesDepth", "nothing-passes", Warning, "passes[0].depthFunc", "draws nothing",
            [](Stage& s) { s.pass().depthFunc = CompareFunc::Never; }},
        Row{"SecondPassWithLess", "hidden-pass", Warning, "passes[1].depthFunc",
            "no depth is less than itself", [](Stage& s) { s.scene.passes.push_back(s.pass()); }},
        Row{"NoDepthTest", "no-depth-test", Warning, "passes[0].depthTest", "covers nearer surfaces",
            [](Stage& s) { s.pass().depthTest = false; }},
        Row{"NoDepthTestOfOneSquare", "no-depth-test", Warning, "passes[0].depthTest", "no depth test",
            [](Stage& s) { s.pass().depthTest = false; },
            [](Stage& s) {
                s.scene.models.resize(1);
                s.scene.models[0].shape = Shape::Quad;
            }},
        Row{"NoDepthTestOfSquaresBehindEachOther", "no-depth-test", Warning, "passes[0].depthTest",
            "no depth test",
            [](Stage& s) {
                s.pass().depthTest = false;
                s.scene.models.assign(2, {.shape = Shape::Quad});
                s.scene.models[1].position.z = -1;
            },
            [](Stage& s) {
                s.scene.models[1].position = {3, 0, 0};
            }},
        Row{"NoDepthTestOfWhatIsBlended", "no-depth-test", Warning, "passes[1].depthTest", "no depth test",
            [](Stage& s) {
                s.scene.passes.push_back({});
                s.scene.passes[1].blend = true;
            },
            [](Stage& s) { s.scene.passes[1].blendDst = BlendFactor::One; }},
        Row{"DepthFunc", "fragment-test", Hint, "passes[0].depthFunc", "off",
            [](Stage& s) { s.pass().depthTest = false; }, [](Stage& s) { s.pass().depthTest = true; }},
        Row{"AlphaFunc", "fragment-test", Hint, "passes[0].alphaFunc", "off", [](Stage&) {},
            [](Stage& s) { s.pass().alphaTest = true; }},
        Row{"AlphaRef", "fragment-test", Hint, "passes[0].alphaRef", "GL_ALWAYS compares nothing",
            [](Stage& s) { s.pass().alphaTest = true; },
            [](Stage& s) { s.pass().alphaFunc = CompareFunc::Greater; }},
        Row{"BlendFactor", "fragment-test", Hint, "passes[0].blendDst", "off", [](Stage&) {},
            [](Stage& s) { s.pass().blend = true; }},
        Row{"BlendThatReplaces", "fragment-test", Hint, "passes[0].blend", "as without",
            [](Stage& s) { s.pass().blend = true; }, [](Stage& s) { s.pass().blendDst = BlendFactor::One; }},
        Row{"Light", "light", Hint, "light", "no pass has lighting",
            [](Stage& s) { s.pass().lighting = false; }, [](Stage& s) { s.pass().lighting = true; }},
        Row{"ShininessWithoutLight", "light", Hint, "material.shininess", "no pass has lighting",
            [](Stage& s) { s.pass().lighting = false; }, [](Stage& s) { s.pass().lighting = true; }},
        Row{"ShininessOfNothing", "light", Hint, "material.shininess", "black",
            [](Stage& s) {
                s.scene.light.specular = {0, 0, 0, 1};
            },
            [](Stage& s) {
                s.scene.light.specular = {0, 1, 0, 1};
            }},
        Row{"LightOnADullMaterial", "light", Hint, "light.specular", "material's specular colour is black",
            [](Stage& s) {
                s.scene.material.specular = {0, 0, 0, 1};
            },
            [](Stage& s) {
                s.scene.material.specular = {1, 1, 1, 1};
            }},
        Row{"ColorUnderReplace", "color", Hint, "material.color", "replace the primary colour",
            [](Stage& s) { s.unit().envMode = EnvMode::Replace; },
            [](Stage& s) { s.texture().internalFormat = InternalFormat::Luminance; }}, // its alpha stays
        Row{"ColorUnderReplaceOfOnePass", "color", Hint, "material.color", "replace the primary colour",
            [](Stage& s) { s.unit().envMode = EnvMode::Replace; },
            [](Stage& s) {
                s.scene.passes.push_back(s.pass());
                s.scene.passes[1].units[0].enabled = false;
            }},
        Row{"LightingUnderReplace", "lighting", Hint, "passes[0].lighting", "replace the primary colour",
            [](Stage& s) { s.unit().envMode = EnvMode::Replace; },
            [](Stage& s) { s.scene.light.colorControl = ColorControl::SeparateSpecular; }},
        Row{"LightingUnderReplaceOfLuminance", "lighting", Hint, "passes[0].lighting", "primary colour",
            [](Stage& s) {
                s.unit().envMode = EnvMode::Replace;
                s.texture().internalFormat = InternalFormat::Luminance;
            },
            [](Stage& s) { s.texture().internalFormat = InternalFormat::Alpha; }},
        Row{"SpecularUnderReplace", "light", Hint, "material.specular", "replace the primary colour",
            [](Stage& s) { s.unit().envMode = EnvMode::Replace; },
            [](Stage& s) { s.scene.light.colorControl = ColorControl::SeparateSpecular; }},
        Row{"ShininessUnderReplace", "light", Hint, "material.shininess", "replace the primary colour",
            [](Stage& s) { s.unit().envMode = EnvMode::Replace; },
            [](Stage& s) { s.unit().envMode = EnvMode::Decal; }},
        Row{"DiffuseUnderReplaceAndSeparate", "light", Hint, "light.diffuse", "replace the primary colour",
            [](Stage& s) {
                s.unit().envMode = EnvMode::Replace;
                s.scene.light.colorControl = ColorControl::SeparateSpecular;
            },
            [](Stage& s) { s.unit().enabled = false; }},
        Row{"TwoSidesWithoutLight", "light", Hint, "light.twoSide", "replace the primary colour",
            [](Stage& s) { s.unit().envMode = EnvMode::Replace; },
            [](Stage& s) { s.unit().envMode = EnvMode::Modulate; }},
        Row{"TwoSidesOfClosedShapes", "two-sides", Hint, "light.twoSide", "closed and seen from outside",
            [](Stage&) {}, [](Stage& s) { s.scene.models[0].shape = Shape::Quad; }},
        Row{"TwoSidesWithoutADepthTest", "two-sides", Hint, "light.twoSide", "closed", [](Stage&) {},
            [](Stage& s) { s.pass().depthTest = false; }},
        Row{"TwoSidesSeenFromInside", "two-sides", Hint, "light.twoSide", "closed", [](Stage&) {},
            [](Stage& s) { s.scene.models[0].size = 9; }},
        Row{"TwoSidesOfAMirroredShape", "two-sides", Hint, "light.twoSide", "closed", [](Stage&) {},
            [](Stage& s) { s.scene.models[0].scale.y = -1; }},
        Row{"DarkBackOfASquare", "dark-back", Warning, "light.twoSide", "the back of models[0]",
            [](Stage& s) {
                s.scene.models[0].shape = Shape::Quad;
                s.scene.models[0].rotation = {0, 180, 0};
                s.scene.light.position = {0, 0, 1, 0};
            }},
        Row{"DarkBackUnlessTheLightIsThere", "dark-back", Warning, "light.twoSide", "stays dark",
            [](Stage& s) {
                s.scene.models[1].shape = Shape::Disk;
                s.scene.models[1].rotation = {0, 180, 0};
                s.scene.light.position = {0, 0, 1, 0};
            },
            [](Stage& s) {
                s.scene.light.position = {0, 0, -1, 0};
            }},
        Row{"DarkInsideOfACylinder", "dark-back", Warning, "light.twoSide", "the back of models[0]",
            [](Stage& s) {
                s.scene.models[0].shape = Shape::Cylinder;
                s.scene.models[0].rotation = {60, 0, 0};
            },
            [](Stage& s) {
                s.scene.models[0].rotation = {0, 0, 0};
                s.scene.view.elevation = 0;
            }},
        Row{"FogOfTheInitialState", "fog-of-no-use", Warning, "passes[0].fog.density", "everything is "
                                                                                       "hidden",
            [](Stage& s) { s.pass().fog.enabled = true; }},
        Row{"FogSquaredTooThick", "fog-of-no-use", Warning, "passes[0].fog.density", "everything is hidden",
            [](Stage& s) {
                s.pass().fog = {.enabled = true, .mode = FogMode::Exp2};
            }},
        Row{"FogWithoutDensity", "fog-of-no-use", Warning, "passes[0].fog.density", "hides nothing",
            [](Stage& s) {
                s.pass().fog = {.enabled = true, .density = 0};
            }},
        Row{"LinearFogOfTheInitialState", "fog-of-no-use", Warning, "passes[0].fog.end", "everything is "
                                                                                         "hidden",
            [](Stage& s) {
                s.pass().fog = {.enabled = true, .mode = FogMode::Linear};
            }},
        Row{"LinearFogBehindEverything", "fog-of-no-use", Warning, "passes[0].fog.end", "hides nothing",
            [](Stage& s) {
                s.pass().fog = {.enabled = true, .mode = FogMode::Linear, .start = 50, .end = 90};
            }},
        Row{"LinearFogBeforeAFlatThing", "fog-of-no-use", Warning, "passes[0].fog.end", "everything is "
                                                                                        "hidden",
            [](Stage& s) {
                s.scene.models.resize(1);
                s.scene.models[0] = {};
                s.scene.models[0].shape = Shape::Quad;
                s.scene.view.azimuth = s.scene.view.elevation = 0;
                s.pass().fog = {.enabled = true, .mode = FogMode::Linear};
            }},
        // The fix ends at the limit of its row, or there is none within it.
        Row{"LinearFogFarAway", "fog-of-no-use", Warning, "passes[0].fog.end", "everything is hidden",
            [](Stage& s) {
                s.scene.models.resize(1);
                s.scene.models[0].size = 100;
                s.scene.view.distance = 990;
                s.pass().fog = {.enabled = true, .mode = FogMode::Linear};
            }},
        Row{"LinearFogTooFarAway", "fog-of-no-use", Warning, "passes[0].fog.end", "everything is hidden",
            [](Stage& s) {
                s.scene.models.resize(1);
                s.scene.models[0].position.z = -1000;
                s.scene.view.distance = 1000;
                s.pass().fog = {.enabled = true, .mode = FogMode::Linear};
            }},
        Row{"FogBackwards", "fog-range", Warning, "passes[0].fog.end", "ends at 2, before it starts at 9",
            [](Stage& s) {
                s.pass().fog = {.enabled = true, .mode = FogMode::Linear, .start = 9, .end = 2};
            }},
        Row{"FogWithoutLength", "fog-range", Warning, "passes[0].fog.end", "divides by 0",
            [](Stage& s) {
                s.pass().fog = {.enabled = true, .mode = FogMode::Linear, .start = 5, .end = 5};
            }},
        Row{"FogOfAnotherColor", "fog-color", Warning, "passes[0].fog.color", "stand out",
            [](Stage& s) {
                s.scene.models[0].shape = Shape::Floor;
                s.pass().fog = {.enabled = true, .density = 0.1F, .color = {1, 0.5F, 0, 1}};
            }},
        Row{"StacksOfATeapot", "too-many-stacks", Warning, "models[0].stacks", "has at most 24",
            [](Stage& s) {
                s.scene.models[0].shape = Shape::Teapot;
                s.scene.models[0].stacks = 25;
            }},
        Row{"FogOff", "fog", Hint, "passes[0].fog.color", "the fog is off", [](Stage&) {},
            [](Stage& s) { s.pass().fog.enabled = true; }},
        Row{"DensityOfLinearFog", "fog", Hint, "passes[0].fog.density", "GL_LINEAR has a start",
            [](Stage& s) {
                s.pass().fog = {.enabled = true, .mode = FogMode::Linear, .end = 9};
            },
            [](Stage& s) { s.pass().fog.mode = FogMode::Exp; }},
        Row{"StartOfExponentialFog", "fog", Hint, "passes[0].fog.start", "GL_EXP2 has a density",
            [](Stage& s) {
                s.pass().fog = {.enabled = true, .mode = FogMode::Exp2, .density = 0.1F};
            },
            [](Stage& s) { s.pass().fog.mode = FogMode::Linear; }},
        Row{"PassOff", "pass-off", Hint, "passes[0]", "not drawn",
            [](Stage& s) { s.scene.passes[0].enabled = false; }},
        Row{"TextureOfAPassThatIsOff", "texture-not-shown", Hint, "textures[0]", "the pass that shows",
            [](Stage& s) { s.scene.passes[0].enabled = false; }},
        Row{"HiddenModel", "hidden-model", Hint, "models[1]", "hidden",
            [](Stage& s) { s.scene.models[1].visible = false; }},
        Row{"CoordinatesOfAUnitThatIsOff", "unread-coordinates", Hint, "models[0].texCoords2",
            "unit 2 is off",
            [](Stage& s) {
                s.scene.models[0].texCoords[2].assign(24, {1, 1, 0, 1});
            },
            [](Stage& s) { s.unit(2).enabled = true; }},
        Row{"CoordinatesOfAUnitThatMakesItsOwn", "unread-coordinates", Hint, "models[0].texCoords0",
            "unit 0 generates all of its coordinates",
            [](Stage& s) {
                s.scene.models[0].texCoords[0].assign(24, {1, 1, 0, 1});
                for (TexGen Unit::*each : {&Unit::texGenS, &Unit::texGenT, &Unit::texGenR, &Unit::texGenQ})
                    (s.unit().*each).enabled = true;
            },
            [](Stage& s) { s.unit().texGenQ.enabled = false; }},
        Row{"SlicesOfACube", "other-shape", Unused, "models[0].slices", "cube", [](Stage&) {},
            [](Stage& s) { s.scene.models[0].shape = Shape::Sphere; }}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(DiagnosisOfAll, TheDefaultSceneIsFreeOfErrorsAndWarnings) {
    for (const Finding& each : Stage().findings())
        EXPECT_GE(each.severity, Severity::Hint) << each.path << ": " << each.sentence;
}

TEST(DiagnosisOfAll, EveryPathIsThatOfAParameterOrOfAStruct) {
    Stage stage;
    stage.scene.passes.resize(2);
    stage.combine().rgb = CombineRgb::Dot3Rgba;
    stage.unit().matrix.resize(2);
    std::set<std::string> paths;
    forEachParam(stage.scene, [&](const std::string& path, const ParamRow&, const Value&) {
        for (std::size_t end = path.find('.'); end != std::string::npos; end = path.find('.', end + 1))
            paths.insert(path.substr(0, end));
        paths.insert(path);
    });
    const std::vector<Finding> findings = stage.findings();
    EXPECT_GT(findings.size(), 50U);
    for (const Finding& each : findings) {
        EXPECT_TRUE(paths.contains(each.path)) << each.path;
        EXPECT_FALSE(each.sentence.empty()) << each.path;
        EXPECT_FALSE(each.sentence.english().ends_with('.')) << each.sentence;
    }
    EXPECT_TRUE(std::ranges::is_sorted(findings, {}, &Finding::severity));
}

TEST(DiagnosisOfAll, AStructSpeaksForAllBelowIt) {
    const std::vector<Finding> findings = Stage().findings();
    const Finding* found = idleReasonOf(findings, "passes[0].units[0].combine.source0Rgb");
    ASSERT_NE(found, nullptr);
    EXPECT_EQ(found->path, "passes[0].units[0].combine");
    EXPECT_EQ(idleReasonOf(findings, "textures[0].minFilter"), nullptr);
    EXPECT_EQ(problemOf(findings, "textures[0].minFilter"), nullptr);
    EXPECT_EQ(idleReasonOf({{"r", Hint, "textures[1]", "s", {}}}, "textures[10].file"), nullptr);
}

TEST(DiagnosisOfAll, TheSwitchOfAUnitThatIsOffHasAnEffect) {
    Stage stage;
    stage.unit().enabled = false;
    const std::vector<Finding> findings = stage.findings();
    EXPECT_NE(idleReasonOf(findings, "passes[0].units[0].envMode"), nullptr);
    EXPECT_NE(idleReasonOf(findings, "passes[0].units[0].matrix[0].amount"), nullptr);
    EXPECT_EQ(idleReasonOf(findings, "passes[0].units[0].enabled"), nullptr);
}

TEST(DiagnosisOfAll, TheColorControlStillBringsTheHighlightBack) {
    Stage stage;
    stage.unit().envMode = EnvMode::Replace;
    EXPECT_EQ(idleReasonOf(stage.findings(), "light.colorControl"), nullptr);
    stage.scene.light.colorControl = ColorControl::SeparateSpecular;
    for (const char* path : {"light.position", "light.specular", "material.shininess", "passes[0].lighting"})
        EXPECT_EQ(idleReasonOf(stage.findings(), path), nullptr) << path;
}

TEST(DiagnosisOfAll, TheSwitchOfAHiddenModelHasAnEffect) {
    Stage stage;
    stage.scene.models[1].visible = false;
    EXPECT_NE(idleReasonOf(stage.findings(), "models[1].size"), nullptr);
    EXPECT_EQ(idleReasonOf(stage.findings(), "models[1].visible"), nullptr);
    EXPECT_EQ(idleReasonOf(stage.findings(), "models[0].size"), nullptr);
}

TEST(DiagnosisOfAll, ALaterPassIsMendedWithoutHidingIt) {
    Stage stage;
    stage.scene.passes.push_back({});
    const std::vector<Finding> before = stage.findings();
    const Finding* found = find(before, "no-depth-test", "passes[1].depthTest");
    ASSERT_NE(found, nullptr);
    ASSERT_TRUE(apply(found->fixes.front(), stage.scene));
    for (const Finding& each : stage.findings())
        EXPECT_GE(each.severity, Hint) << each.path << ": " << each.sentence;
}

std::vector<std::string> labelsOf(const std::vector<Fix>& fixes) {
    std::vector<std::string> labels;
    for (const Fix& each : fixes)
        labels.push_back(each.label);
    return labels;
}

TEST(DiagnosisOfIncompleteTextures, OffersEachSettingThatCompletes) {
    using testing::ElementsAre;
    const auto fixes = [](void (*spoil)(Stage&)) {
        Stage stage;
        spoil(stage);
        for (const Finding& each : stage.findings()) {
            if (each.rule == "incomplete")
                return labelsOf(each.fixes);
        }
        return std::vector<std::string>{};
    };
    EXPECT_THAT(fixes([](Stage& s) { s.texture().mipmaps = MipPolicy::None; }),
                ElementsAre("Generate mipmaps", "End at level 0", "Set GL_LINEAR"));
    EXPECT_THAT(fixes([](Stage& s) {
                    s.texture().mipmaps = MipPolicy::Missing; // level 3 isn't there
                    s.texture().minFilter = MinFilter::NearestMipmapLinear;
                }),
                ElementsAre("Generate mipmaps", "End at level 2", "Set GL_NEAREST"));
    EXPECT_THAT(fixes([](Stage& s) {
                    s.texture().baseLevel = 3;
                    s.texture().maxLevel = 2;
                }),
                ElementsAre("Begin at level 2", "End at level 6", "Set GL_LINEAR"));
    EXPECT_THAT(fixes([](Stage& s) { s.texture().baseLevel = 50; }), ElementsAre("Begin at level 0"));
    EXPECT_THAT(fixes([](Stage& s) {
                    s.texture().baseLevel = 50;
                    s.texture().mipmaps = MipPolicy::None;
                }),
                ElementsAre("Begin at level 0 and generate mipmaps", "Begin at level 0 and end at level 0",
                            "Begin at level 0 and set GL_LINEAR"));
    EXPECT_THAT(fixes([](Stage& s) {
                    s.showFile(8, 4);
                    s.unit().target = Target::CubeMap;
                }),
                testing::IsEmpty());
}

/// The light's shadows, as they should be.
void castShadows(Stage& s) {
    s.texture().source = SourceKind::LightDepth;
    s.texture().mipmaps = MipPolicy::None;
    s.texture().internalFormat = InternalFormat::DepthComponent24;
    s.texture().minFilter = MinFilter::Linear;
    s.texture().compareMode = CompareMode::RToTexture;
    s.unit().matrix = {{.op = MatrixOp::Translate, .amount = {0, 0, -0.005F}}, {.op = MatrixOp::Projector}};
    int axis = 0;
    for (TexGen* each : {&s.unit().texGenS, &s.unit().texGenT, &s.unit().texGenR, &s.unit().texGenQ}) {
        each->enabled = true;
        each->eyePlane = glm::vec4(0);
        each->eyePlane[axis++] = 1;
    }
}

/// A triangle with its own vertices that faces the viewer.
MeshData& triangle(Stage& s) {
    Model& model = s.scene.models[0];
    model = Model{.shape = Shape::Mesh, .attachment = Attachment::Eye};
    model.mesh.positions = {{0, 0, -3}, {1, 0, -3}, {0, 1, -3}};
    model.mesh.normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
    return model.mesh;
}

INSTANTIATE_TEST_SUITE_P(
    Vertices, Diagnosis,
    testing::Values(
        Row{"NormalWithoutLength", "zero-normal", Warning, "models[0].mesh.normals",
            "the normal of vertex 1 has length 0",
            [](Stage& s) {
                triangle(s).normals[1] = glm::vec3(0);
                s.pass().lighting = true;
            }},
        Row{"NormalsWithoutLength", "zero-normal", Warning, "models[0].mesh.normals",
            "the same is true of "
            "2 more",
            [](Stage& s) {
                triangle(s).normals.assign(3, glm::vec3(0));
                s.unit().texGenS = {.enabled = true, .mode = TexGenMode::SphereMap};
            }},
        Row{"NormalThatNothingReads", "zero-normal", Warning, "models[0].mesh.normals", "vertex 0",
            [](Stage& s) {
                triangle(s).normals[0] = glm::vec3(0);
                s.pass().lighting = true;
            },
            [](Stage& s) { s.pass().lighting = false; }},
        Row{"ReflectionAwayFromTheEye", "sphere-map-rim", Warning, "passes[0].units[0].texGenS",
            "at vertex 0 of models[0]",
            [](Stage& s) {
                triangle(s).normals[0] = {1, 0, 0}; // seen along the surface
                s.unit().texGenT = {.enabled = true, .mode = TexGenMode::SphereMap};
            },
            [](Stage& s) {
                s.scene.models[0].mesh.normals[0] = {0, 0, 1};
            }},
        Row{"CoordinatesFarAway", "far-coordinates", Note, "passes[0].units[0].matrix",
            "reach 871, 55744 texels",
            [](Stage& s) {
                s.unit().matrix = {{.op = MatrixOp::Translate, .amount = {870, 0, 0}}};
            },
            [](Stage& s) { s.unit().matrix[0].amount.x = 400; }},
        Row{"FogWithoutLengthOfAModelAtTheEye", "fog-range", Warning, "passes[0].fog.end", "divides by 0",
            [](Stage& s) {
                MeshData& mesh = triangle(s);
                // Rounding to a power of ten is not possible for this float.
                mesh.positions[0].z = mesh.positions[1].z = -1e-45F;
                mesh.positions[2].z = -5;
                s.scene.view.projection = Projection::Orthographic;
                s.pass().fog = {.enabled = true, .mode = FogMode::Linear, .start = 5, .end = 5};
            }},
        Row{"LineOfAMillionPixels", "long-line", Note, "models[0].mesh", "more than a million pixels",
            [](Stage& s) {
                triangle(s).primitive = Primitive::Lines;
                s.scene.models[0].mesh.positions[1].x = 1e6F;
            },
            [](Stage& s) { s.driver.renderer = "softpipe"; }}),
    [](const auto& test) { return test.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Depth, Diagnosis,
    testing::Values(
        Row{"DepthsOfAVolume", "depth-target", Error, "passes[0].units[0].target", "no depth textures for",
            [](Stage& s) {
                s.texture().internalFormat = InternalFormat::DepthComponent16;
                s.unit().target = Target::Texture3D;
            }},
        Row{"DepthsAsColors", "colored-depths", Warning, "textures[0].internalFormat", "greys of 8 bits",
            [](Stage& s) {
                castShadows(s);
                s.texture().internalFormat = InternalFormat::Rgba;
            }},
        Row{"DepthsNotCompared", "depths-as-they-are", Note, "textures[0].compareMode", "for shadows",
            [](Stage& s) {
                castShadows(s);
                s.texture().compareMode = CompareMode::None;
            }},
        Row{"RIsZero", "compares-nothing", Warning, "passes[0].units[0].texGenR.enabled", "0 everywhere",
            [](Stage& s) {
                s.texture().internalFormat = InternalFormat::DepthComponent16;
                s.texture().compareMode = CompareMode::RToTexture;
            }},
        Row{"NotInEyeCoordinates", "projects-nothing", Warning, "passes[0].units[0].matrix[0].op",
            "GL_EYE_LINEAR", [](Stage& s) { s.unit().matrix = {{.op = MatrixOp::Projector}}; }},
        Row{"OneOfFourNotGenerated", "projects-nothing", Warning, "passes[0].units[0].matrix[1].op",
            "eye coordinates",
            [](Stage& s) {
                castShadows(s);
                s.unit().texGenQ.enabled = false;
            }},
        Row{"ShadowsOfItself", "shadow-acne", Warning, "passes[0].units[0].matrix[0].op", "translates r",
            [](Stage& s) {
                castShadows(s);
                s.unit().matrix.erase(s.unit().matrix.begin());
            }},
        Row{"ShadowsMovedTheOtherWay", "shadow-acne", Warning, "passes[0].units[0].matrix[1].op",
            "translates r",
            [](Stage& s) {
                castShadows(s);
                s.unit().matrix[0].amount.z = 0.01F;
            }},
        Row{"LightInItsTarget", "light-in-target", Warning, "light.projector.target", "its own target",
            [](Stage& s) {
                castShadows(s);
                s.scene.light.position = {0, 0, -6, 1};
            }},
        Row{"LightWithoutDirection", "light-in-target", Warning, "light.position", "length 0",
            [](Stage& s) {
                castShadows(s);
                s.scene.light.position = {0, 0, 0, 0};
            }},
        Row{"NearBehindFar", "light-range", Warning, "light.projector.farthest",
            "greater than the "
            "nearest, 20",
            [](Stage& s) {
                castShadows(s);
                s.scene.light.projector.nearest = 20;
                s.scene.light.projector.farthest = 1;
            }},
        Row{"NearIsFar", "light-range", Warning, "light.projector.farthest", "greater than the nearest",
            [](Stage& s) {
                castShadows(s);
                s.scene.light.projector.nearest = s.scene.light.projector.farthest;
            }},
        Row{"BehindTheLight", "behind-the-light", Note, "passes[0].units[0].matrix[1]", "upside down",
            [](Stage& s) {
                castShadows(s);
                s.scene.light.position = {0, 0, -20,
                                          1}; // looks back at its target, and the models lie behind
                s.scene.light.projector.target = {0, 0, -40};
            },
            [](Stage& s) {
                s.scene.light.projector.target = {0, 0, -6};
            }},
        Row{"NothingProjected", "projector", Hint, "light.projector", "projector step", [](Stage&) {},
            castShadows},
        Row{"ComparingColors", "texture-setting", Hint, "textures[0].compareMode", "holds no depths",
            [](Stage&) {}, castShadows},
        Row{"FunctionWithoutComparing", "texture-setting", Hint, "textures[0].compareFunc",
            "nothing is compared: GL_NONE",
            [](Stage& s) { s.texture().internalFormat = InternalFormat::DepthComponent16; }, castShadows},
        Row{"SizeOfAPattern", "other-texture-choice", Unused, "textures[0].depthSize", "pattern",
            [](Stage&) {}, castShadows},
        Row{"DepthsCompressed", "texture-setting", Hint, "textures[0].compression", "no compressed depth",
            [](Stage& s) { s.texture().internalFormat = InternalFormat::DepthComponent16; },
            [](Stage& s) { s.texture().internalFormat = InternalFormat::Rgba; }}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(DiagnosisOfDepths, HasNothingToSayOfAShadowMap) {
    Stage stage;
    castShadows(stage);
    stage.pass().lighting = false; // the light is used anyway
    for (const Finding& each : stage.findings()) {
        EXPECT_GE(each.severity, Hint) << each.path << ": " << each.sentence;
        EXPECT_FALSE(each.path == "light" || each.path == "light.position" ||
                     each.path == "light.projector" || each.path == "passes[0].units[0].texGenR.enabled")
            << each.path << ": " << each.sentence;
    }
}

TEST(DiagnosisOfAll, AFixThatNoLongerFitsChangesNothing) {
    Scene scene = defaultScene();
    const Fix fix{"", {{"textures[0].baseLevel", "3"}, {"textures[5].baseLevel", "3"}}};
    EXPECT_FALSE(apply(fix, scene));
    EXPECT_EQ(scene, defaultScene());
}

} // namespace
} // namespace texplorer::diagnosis_test

#include "tests/core/diagnosis/mistakes.h"

namespace texplorer::test {
namespace {

using enum Severity;

/// A white disc on invisible black.
void blendADisc(Subject& s) {
    Image disc = Image::uninitialised(PixelFormat::LuminanceAlpha8, 16, 16);
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x)
            for (std::byte& each : disc.at(x, y))
                each = std::byte{(x - 8) * (x - 8) + (y - 8) * (y - 8) < 36 ? std::uint8_t{255}
                                                                            : std::uint8_t{0}};
    s.texture().source = SourceKind::File;
    s.texture().file = "disc.png";
    s.images.put("disc.png", std::move(disc));
    s.pass().blend = true;
    s.pass().blendSrc = BlendFactor::SrcAlpha;
    s.pass().blendDst = BlendFactor::OneMinusSrcAlpha;
}

/// One texel of eight is visible.
void testDots(Subject& s) {
    Image dots = Image::uninitialised(PixelFormat::LuminanceAlpha8, 64, 64);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            dots.at(x, y)[0] = std::byte{90};
            dots.at(x, y)[1] = std::byte{(x + 3 * y) % 8 == 0 ? std::uint8_t{255} : std::uint8_t{0}};
        }
    s.texture().source = SourceKind::File;
    s.texture().file = "dots.png";
    s.images.put("dots.png", std::move(dots));
    s.texture().mipmaps = MipPolicy::Generated;
    s.texture().minFilter = MinFilter::LinearMipmapLinear;
    s.pass().alphaTest = true;
    s.pass().alphaFunc = CompareFunc::Greater;
    s.pass().alphaRef = 0.5F;
}

constexpr std::array levelRows{
    Mistake{"TooFewLevels", "incomplete", Warning, "textures[0].mipmaps", "level 2 is missing",
            [](Subject& s) {
                s.texture().mipmaps = MipPolicy::Given;
                s.texture().levels.resize(1);
            },
            [](Subject& s) { s.texture().levels.resize(6); }}, // below 64 x 64 texels
    Mistake{"LevelsThatBeginTooLate", "incomplete", Warning, "textures[0].baseLevel", "base level is 50",
            [](Subject& s) {
                s.texture().baseLevel = 50;
                s.texture().mipmaps = MipPolicy::None;
            }},
    Mistake{"GivenLevelsThatBeginTooLate", "incomplete", Warning, "textures[0].baseLevel", "base level is 50",
            [](Subject& s) {
                s.showFile(8, 2);
                s.texture().source = SourceKind::Pattern;
                s.texture().baseLevel = 50;
                s.texture().mipmaps = MipPolicy::Given;
                s.texture().levels.resize(6);
                s.texture().levels[1] = {.source = SourceKind::File, .file = "image.png"};
            }},
    Mistake{"TooFewLevelsUnlessTheyAreNotRead", "incomplete", Warning, "textures[0].mipmaps", "level 2",
            [](Subject& s) {
                s.texture().mipmaps = MipPolicy::Given;
                s.texture().levels.resize(1);
            },
            [](Subject& s) { s.texture().maxLevel = 1; }},
    Mistake{"LevelOfAnotherSize", "incomplete", Warning, "textures[0].levels[1].file",
            "level 2 should have 16 × 16 texels and has 8 × 2",
            [](Subject& s) {
                s.showFile(8, 2);
                s.texture().source = SourceKind::Pattern;
                s.texture().mipmaps = MipPolicy::Given;
                s.texture().levels.resize(6);
                s.texture().levels[1] = {.source = SourceKind::File, .file = "image.png"};
            },
            [](Subject& s) { s.texture().levels[1].source = SourceKind::Pattern; }},
    Mistake{"LevelWithoutAFile", "missing-part", Error, "textures[0].levels[0].file", "none is named",
            [](Subject& s) {
                s.texture().mipmaps = MipPolicy::Given;
                s.texture().levels = {{.source = SourceKind::File}};
            },
            [](Subject& s) { s.texture().mipmaps = MipPolicy::Generated; }},
    Mistake{"AlphaWithoutAFile", "missing-part", Error, "textures[0].preparation[0].file",
            "gone.png can't be found or read: the step is skipped",
            [](Subject& s) {
                s.texture().preparation = {
                    {.op = ImageOp::AlphaFrom, .source = SourceKind::File, .file = "gone.png"}};
            },
            [](Subject& s) { s.texture().preparation[0].op = ImageOp::Invert; }},
    Mistake{"DepthsThatAreNotPrepared", "depths-not-prepared", Hint, "textures[0].preparation",
            "not changed before they are compared",
            [](Subject& s) {
                s.texture().source = SourceKind::LightDepth;
                s.texture().internalFormat = InternalFormat::DepthComponent24;
                s.texture().preparation = {{.op = ImageOp::Invert}};
            },
            [](Subject& s) { s.texture().internalFormat = InternalFormat::Luminance; }},
    Mistake{"LevelsThatAreNotRead", "levels-not-read", Hint, "textures[0].levels",
            "not read with the mipmaps \"Generated\"", [](Subject& s) { s.texture().levels.resize(1); },
            [](Subject& s) { s.texture().mipmaps = MipPolicy::Given; }},
    Mistake{"AlphaThatTheFormatDrops", "lost-alpha", Hint, "textures[0].preparation[0]",
            "GL_RGB keeps no alpha",
            [](Subject& s) {
                s.texture().internalFormat = InternalFormat::Rgb;
                s.texture().preparation = {{.op = ImageOp::AlphaFrom}};
            },
            [](Subject& s) { s.texture().internalFormat = InternalFormat::Rgba; }},
    Mistake{"AlphaThatIsMadeAgain", "lost-alpha", Hint, "textures[0].preparation[0]", "a later step",
            [](Subject& s) {
                s.texture().preparation = {{.op = ImageOp::AlphaFrom}, {.op = ImageOp::LuminanceToAlpha}};
            },
            [](Subject& s) { s.texture().preparation[1].op = ImageOp::Invert; }},
    Mistake{"AlphaThatColoursDoNotDependOn", "lost-alpha", Hint, "textures[0].preparation[0]", "a later step",
            [](Subject& s) {
                s.texture().preparation = {{.op = ImageOp::AlphaFrom},
                                           {.op = ImageOp::Swizzle, .alpha = ComponentSource::One}};
            },
            [](Subject& s) { s.texture().preparation[1].red = ComponentSource::Alpha; }},
    Mistake{"AlphaBeforeAStencil", "lost-alpha", Hint, "textures[0].preparation[0]",
            "the transparency \"Stencil by colour\" replaces alpha",
            [](Subject& s) {
                s.texture().transparency = Transparency::Stencil;
                s.texture().preparation = {{.op = ImageOp::LuminanceToAlpha}};
            },
            [](Subject& s) { s.texture().transparency = Transparency::Alpha; }},
    Mistake{"FileOfALevelOfAPattern", "other-texture-choice", Unused, "textures[0].levels[0].file",
            "Built-in", [](Subject& s) { s.texture().levels.resize(1); },
            [](Subject& s) { s.texture().levels[0].source = SourceKind::File; }},
    Mistake{"PatternOfAStepWithoutOne", "other-texture-choice", Unused, "textures[0].preparation[0].pattern",
            "Invert", [](Subject& s) { s.texture().preparation = {{.op = ImageOp::Invert}}; },
            [](Subject& s) { s.texture().preparation[0].op = ImageOp::AlphaFrom; }},
    Mistake{"FactorOfAStepWithoutOne", "other-texture-choice", Unused, "textures[0].preparation[0].factor",
            "Sharpen", [](Subject& s) { s.texture().preparation = {{.op = ImageOp::Sharpen}}; },
            [](Subject& s) { s.texture().preparation[0].op = ImageOp::Scale; }},
    Mistake{"OtherImageOfASwizzleOfOne", "other-texture-choice", Unused, "textures[0].preparation[0].source",
            "Swizzle", [](Subject& s) { s.texture().preparation = {{.op = ImageOp::Swizzle}}; },
            [](Subject& s) { s.texture().preparation[0].red = ComponentSource::OtherRed; }},
    Mistake{"CoverageOfTheDriver", "other-texture-choice", Unused, "textures[0].mipCoverage",
            "glGenerateMipmap", [](Subject& s) { s.texture().mipmaps = MipPolicy::GenerateMipmap; },
            [](Subject& s) { s.texture().mipmaps = MipPolicy::Generated; }},
    Mistake{"Fringe", "fringe", Note, "textures[0].preparation", "fringe", blendADisc},
    Mistake{"FringeOfTheNearest", "fringe", Note, "textures[0].preparation", "fringe", blendADisc,
            [](Subject& s) {
                s.texture().magFilter = MagFilter::Nearest;
                s.texture().minFilter = MinFilter::Nearest;
            }},
    Mistake{"PremultipliedButNotBlendedSo", "fringe", Note, "textures[0].preparation", "too dark",
            [](Subject& s) {
                blendADisc(s);
                s.texture().preparation = {{.op = ImageOp::Premultiply}};
            }},
    Mistake{"CoverageLost", "lost-coverage", Note, "textures[0].mipCoverage",
            "passes 13 % of the image, but only 0 % of level 1", testDots},
    Mistake{"CoverageLostByGlu", "lost-coverage", Note, "textures[0].mipmaps", "0 % of level 1",
            [](Subject& s) {
                testDots(s);
                s.texture().mipmaps = MipPolicy::Glu;
            }}};

} // namespace

std::span<const Mistake> levelMistakes() {
    return levelRows;
}

} // namespace texplorer::test

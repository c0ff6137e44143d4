#include "tests/core/diagnosis/mistakes.h"

namespace texplorer::test {
namespace {

using enum Severity;

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
            [](Subject& s) { s.texture().preparation[0].op = ImageOp::Scale; }}};

} // namespace

std::span<const Mistake> levelMistakes() {
    return levelRows;
}

} // namespace texplorer::test

#include "tests/core/diagnosis/mistakes.h"

namespace texplorer::test {
namespace {

using enum Severity;

void cubeOfFewTexels(Subject& s) {
    s.unit().target = Target::CubeMap;
    s.texture().pattern = Pattern::CubeFaces; // 128 x 128
    s.texture().baseLevel = 4;
    s.texture().wrapS = s.texture().wrapT = Wrap::ClampToEdge;
}

constexpr std::array textureRows{
    Mistake{"NoFile", "missing-file", Error, "textures[0].file", "names none",
            [](Subject& s) { s.texture().source = SourceKind::File; },
            [](Subject& s) { s.texture().source = SourceKind::Pattern; }},
    Mistake{"FileNotThere", "missing-file", Error, "textures[0].file", "earth.jpg can't be found or read",
            [](Subject& s) {
                s.texture().source = SourceKind::File;
                s.texture().file = "earth.jpg";
            },
            [](Subject& s) { s.showFile(4, 4); }},
    Mistake{"NoMipmaps", "incomplete", Warning, "textures[0].minFilter", "level 1 is missing",
            [](Subject& s) { s.texture().mipmaps = MipPolicy::None; }},
    Mistake{"NoMipmapsByFilter", "incomplete", Warning, "textures[0].minFilter", "GL_LINEAR_MIPMAP_LINEAR",
            [](Subject& s) { s.texture().mipmaps = MipPolicy::None; },
            [](Subject& s) { s.texture().minFilter = MinFilter::Linear; }},
    Mistake{"OneMissing", "incomplete", Warning, "textures[0].mipmaps", "level 3 is missing",
            [](Subject& s) { s.texture().mipmaps = MipPolicy::Missing; }},
    Mistake{"BaseBeyondTheLevels", "incomplete", Warning, "textures[0].baseLevel", "base level is 50",
            [](Subject& s) { s.texture().baseLevel = 50; }},
    Mistake{"BaseAboveMax", "incomplete", Warning, "textures[0].baseLevel", "exceeds its maximal level 2",
            [](Subject& s) {
                s.texture().baseLevel = 3;
                s.texture().maxLevel = 2;
            }},
    Mistake{"BaseAboveTheFilesLast", "incomplete", Warning, "textures[0].baseLevel", "base level is 2",
            [](Subject& s) {
                s.showFile(8, 8, 2);
                s.texture().mipmaps = MipPolicy::FromFile;
                s.texture().baseLevel = 2;
            }},
    Mistake{"LodLimitsExchanged", "lod-range", Warning, "textures[0].minLod", "undefined",
            [](Subject& s) {
                s.texture().minLod = 3;
                s.texture().maxLod = 1;
            }},
    Mistake{"AnisotropyBeyondTheDriver", "anisotropy-limit", Warning, "textures[0].maxAnisotropy",
            "16 exceeds the driver's 8",
            [](Subject& s) {
                s.driver.maxAnisotropy = 8;
                s.texture().maxAnisotropy = 16;
            }},
    Mistake{"NoAnisotropyAtAll", "anisotropy-limit", Warning, "textures[0].maxAnisotropy",
            "has no anisotropic",
            [](Subject& s) {
                s.driver.maxAnisotropy = 1;
                s.texture().maxAnisotropy = 2;
            }},
    Mistake{"AnisotropyThatTheDriverDoesNotSurvive", "held-back", Warning, "textures[0].maxAnisotropy",
            "drawn without anisotropy",
            [](Subject& s) {
                s.driver.renderer = "llvmpipe (LLVM 15.0.6, 256 bits)";
                s.unit().target = Target::Texture1D;
                s.texture().maxAnisotropy = 2;
            }},
    Mistake{"AnisotropyThatTheDriverIgnores", "held-back", Warning, "textures[0].maxAnisotropy",
            "compares no depths",
            [](Subject& s) {
                s.driver.renderer = "llvmpipe (LLVM 15.0.6, 256 bits)";
                s.texture().internalFormat = InternalFormat::DepthComponent24;
                s.texture().compareMode = CompareMode::RToTexture;
                s.texture().maxAnisotropy = 2;
            }},
    Mistake{"AnisotropyWithoutEndAnywhere", "held-back-elsewhere", Note, "textures[0].maxAnisotropy",
            "q runs through 0",
            [](Subject& s) {
                s.texture().maxAnisotropy = 2;
                s.unit().texGenQ.enabled = true;
                s.unit().texGenQ.mode = TexGenMode::ObjectLinear;
                s.unit().texGenQ.objectPlane = {1, 0, 0, 0};
            }},
    Mistake{
        "AnisotropyWithoutEndLater", "held-back-elsewhere", Note, "textures[0].maxAnisotropy",
        "q runs through 0",
        [](Subject& s) {
            s.texture().maxAnisotropy = 2;
            MatrixStep row{.op = MatrixOp::Multiply};
            row.matrix[0].w = 1;
            row.matrix[3].w = -3.5F; // q = s - 3.5
            s.unit().matrix = {row, {.op = MatrixOp::Translate, .amount = {0, 0, 0}, .rate = {1.5F, 0, 0}}};
        }},
    Mistake{"AnisotropyWithoutEndAtAKey", "held-back-elsewhere", Note, "textures[0].maxAnisotropy",
            "q runs through 0",
            [](Subject& s) {
                s.texture().maxAnisotropy = 2;
                s.unit().texGenQ.enabled = true;
                s.unit().texGenQ.mode = TexGenMode::ObjectLinear;
                s.unit().texGenQ.objectPlane = {1, 0, 0, 10};
                s.scene.timeline.keys = {
                    {30, "passes[0].units[0].texGenQ.objectPlane", "1,0,0,10", Easing::Hold},
                    {31, "passes[0].units[0].texGenQ.objectPlane", "1,0,0,0", Easing::Hold}};
            }},
    Mistake{"NonPowerOfTwo", "non-power-of-two", Warning, "textures[0].npot", "6 × 4",
            [](Subject& s) {
                s.driver.nonPowerOfTwo = false;
                s.showFile(6, 4);
            }},
    Mistake{"TooLarge", "size-limit", Error, "textures[0].file", "64 × 2 texels exceed the driver's 32",
            [](Subject& s) {
                s.driver.maxTextureSize = 32;
                s.showFile(64, 2);
            },
            [](Subject& s) { s.showFile(32, 2); }},
    Mistake{"TooLargeUnlessScaledDown", "size-limit", Error, "textures[0].file", "64 × 2 texels",
            [](Subject& s) {
                s.driver.maxTextureSize = 31;
                s.showFile(64, 2);
            }},
    Mistake{"TooLargeUnlessSmallerLevelsAreDrawn", "size-limit", Error, "textures[0].file", "64 × 2 texels",
            [](Subject& s) {
                s.driver.maxTextureSize = 31;
                s.showFile(64, 2);
            },
            [](Subject& s) { s.texture().oversize = Oversize::Smaller; }},
    Mistake{"DrawnSmaller", "drawn-smaller", Note, "textures[0].oversize", "scaled down to 16 × 1",
            [](Subject& s) {
                s.driver.maxTextureSize = 31;
                s.showFile(64, 2);
                s.texture().oversize = Oversize::Smaller;
            },
            [](Subject& s) { s.driver.maxTextureSize = 64; }},
    Mistake{"LevelTooLarge", "level-size-limit", Error, "textures[0].levels[1]",
            "64 × 2 texels exceed the driver's 32 for level 2",
            [](Subject& s) {
                s.driver.maxTextureSize = 128;
                s.showFile(64, 2);
                s.texture().source = SourceKind::Pattern;
                s.texture().mipmaps = MipPolicy::Given;
                s.texture().levels.resize(2);
                s.texture().levels[1] = {.source = SourceKind::File, .file = "image.png"};
            },
            [](Subject& s) { s.driver.maxTextureSize = 256; }},
    Mistake{"LevelThatTheDriverHasNot", "level-size-limit", Error, "textures[0].levels[14]",
            "the driver has no level 15",
            [](Subject& s) {
                s.driver.maxTextureSize = 16384; // level 14 is the last
                s.texture().mipmaps = MipPolicy::Given;
                s.texture().levels.resize(15);
            },
            [](Subject& s) { s.texture().levels.resize(14); }},
    Mistake{"FacesNotSquare", "incomplete", Warning, "textures[0].file",
            "must be square, and they have 8 × 4",
            [](Subject& s) {
                s.showFile(8, 4);
                s.unit().target = Target::CubeMap;
            },
            [](Subject& s) { s.showFile(24, 4); }},
    Mistake{"CubeTooLarge", "size-limit", Error, "textures[0].file", "64 × 64 texels exceed the driver's 32",
            [](Subject& s) {
                s.driver.maxCubeMapSize = 32;
                s.showFile(384, 64);
                s.unit().target = Target::CubeMap;
            },
            [](Subject& s) { s.showFile(192, 32); }},
    Mistake{"CubeSeams", "cube-seams", Warning, "textures[0].wrapS", "GL_REPEAT reads beyond the edge",
            [](Subject& s) { s.unit().target = Target::CubeMap; }},
    Mistake{"CubeSeamsOfT", "cube-seams", Warning, "textures[0].wrapT", "GL_CLAMP reads beyond the edge",
            [](Subject& s) {
                s.unit().target = Target::CubeMap;
                s.texture().wrapS = Wrap::ClampToEdge;
                s.texture().wrapT = Wrap::Clamp;
            },
            [](Subject& s) {
                s.texture().minFilter = MinFilter::Nearest;
                s.texture().magFilter = MagFilter::Nearest;
            }},
    Mistake{"CubeSeamsUnlessSeamless", "cube-seams", Warning, "textures[0].wrapS", "shows as a seam",
            [](Subject& s) { s.unit().target = Target::CubeMap; },
            [](Subject& s) { s.pass().seamlessCubeMap = true; }},
    Mistake{"CubeOfFewTexels", "cube-edges", Note, "passes[0].seamlessCubeMap",
            "each face of textures[0] has 8 × 8 texels", cubeOfFewTexels},
    Mistake{"CubeOfFewTexelsUnlessNearest", "cube-edges", Note, "passes[0].seamlessCubeMap",
            "filtered on its own", cubeOfFewTexels,
            [](Subject& s) {
                s.texture().minFilter = MinFilter::NearestMipmapLinear;
                s.texture().magFilter = MagFilter::Nearest;
            }},
    Mistake{"CubeOfFewTexelsUnlessMore", "cube-edges", Note, "passes[0].seamlessCubeMap", "seams show",
            cubeOfFewTexels, [](Subject& s) { s.texture().baseLevel = 0; }},
    Mistake{"NoSeamlessCubeMaps", "no-seamless-cube-maps", Warning, "passes[0].seamlessCubeMap",
            "the driver has no seamless cube maps",
            [](Subject& s) {
                cubeOfFewTexels(s);
                s.pass().seamlessCubeMap = true;
                s.driver.seamlessCubeMaps = false;
            }},
    Mistake{"NoSeamlessCubeMapsToOffer", "cube-edges", Note, "passes[0].seamlessCubeMap", "seams show",
            cubeOfFewTexels, [](Subject& s) { s.driver.seamlessCubeMaps = false; }},
    Mistake{"SeamlessWithoutACubeMap", "seamless-in-vain", Hint, "passes[0].seamlessCubeMap",
            "no unit of this pass shows a cube map", [](Subject&) {},
            [](Subject& s) { s.unit().target = Target::CubeMap; }},
    Mistake{"SeamlessUnderNearest", "seamless-in-vain", Hint, "passes[0].seamlessCubeMap",
            "GL_NEAREST reads one texel",
            [](Subject& s) {
                cubeOfFewTexels(s);
                s.texture().minFilter = MinFilter::Nearest;
                s.texture().magFilter = MagFilter::Nearest;
            },
            [](Subject& s) { s.texture().magFilter = MagFilter::Linear; }},
    Mistake{"WrapOfASeamlessCubeMap", "texture-setting", Hint, "textures[0].wrapS", "whatever the wrap modes",
            [](Subject& s) {
                cubeOfFewTexels(s);
                s.pass().seamlessCubeMap = true;
            },
            [](Subject& s) { s.pass().seamlessCubeMap = false; }},
    Mistake{"FlatDirection", "flat-direction", Warning, "passes[0].units[0].target", "r is 0 at every vertex",
            [](Subject& s) { s.unit().target = Target::CubeMap; }},
    Mistake{"FlatDirectionOfVertices", "flat-direction", Warning, "passes[0].units[0].target",
            "as a direction", [](Subject& s) { s.unit().target = Target::CubeMap; },
            [](Subject& s) {
                s.scene.models[0].texCoords[0].assign(24, {1, 1, 1, 1});
            }},
    Mistake{"GivenLevelsOnLlvmpipe", "rough-lambda", Note, "textures[0].minFilter", "up to 0.1 off",
            [](Subject& s) {
                s.driver.renderer = "llvmpipe (LLVM 15.0.6, 256 bits)";
                s.texture().mipmaps = MipPolicy::Given;
                s.texture().levels.resize(6);
            },
            [](Subject& s) { s.texture().mipmaps = MipPolicy::Generated; }},
    Mistake{"LostBorder", "lost-border", Warning, "textures[0].border", "the reference renderer shows",
            [](Subject& s) {
                s.driver.textureBorders = false;
                s.texture().border = 1;
            }},
    Mistake{"BorderNotSeen", "texture-setting", Hint, "textures[0].border", "no wrap mode shows the border",
            [](Subject& s) { s.texture().border = 1; },
            [](Subject& s) { s.texture().wrapT = Wrap::ClampToBorder; }},
    Mistake{"BorderNotSeenUnlessCutOff", "texture-setting", Hint, "textures[0].border", "no wrap mode",
            [](Subject& s) {
                s.texture().border = 1;
                s.showFile(64, 64);
            },
            [](Subject& s) { s.showFile(66, 66); }},
    Mistake{"OwnBorder", "own-border", Hint, "textures[0].borderColor", "a border of texels",
            [](Subject& s) { s.texture().border = 1; }, [](Subject& s) { s.driver.textureBorders = false; }},
    Mistake{"IgnoredHint", "ignored-hint", Warning, "view.perspectiveHint", "may ignore this hint",
            [](Subject& s) { s.scene.view.perspectiveHint = HintMode::Fastest; }},
    Mistake{"NoPerspective", "no-perspective", Hint, "view.perspectiveHint", "no perspective to correct",
            [](Subject& s) { s.scene.view.projection = Projection::Orthographic; },
            [](Subject& s) { s.scene.view.projection = Projection::Perspective; }},
    Mistake{"NoS3tc", "missing-format", Warning, "textures[0].compression", "DXT1",
            [](Subject& s) {
                s.driver.s3tc = false;
                s.texture().compression = Compression::Driver;
            },
            [](Subject& s) { s.driver.s3tc = true; }},
    Mistake{"NoFloats", "missing-format", Warning, "textures[0].internalFormat", "GL_RGBA16F_ARB",
            [](Subject& s) {
                s.driver.floatTextures = false;
                s.texture().internalFormat = InternalFormat::Rgba16F;
            },
            [](Subject& s) { s.driver.floatTextures = true; }}};

} // namespace

std::span<const Mistake> textureMistakes() {
    return textureRows;
}

} // namespace texplorer::test

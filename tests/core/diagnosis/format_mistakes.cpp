#include "tests/core/diagnosis/mistakes.h"

namespace texplorer::test {
namespace {

using enum Severity;

constexpr std::array formatRows{
    Mistake{"OrderAsInternalFormat", "format-refused", Error, "textures[0].internalFormat",
            "GL_INVALID_VALUE: GL_BGR is not an internal format",
            [](Subject& s) { s.texture().internalFormat = InternalFormat::Bgr; }},
    Mistake{"RefusedFormatUnlessCompressed", "format-refused", Error, "textures[0].internalFormat",
            "5 is not an internal format",
            [](Subject& s) { s.texture().internalFormat = InternalFormat::Components5; },
            [](Subject& s) { s.texture().compression = Compression::Cached; }},
    Mistake{"BorderOfTwo", "border-refused", Error, "textures[0].border",
            "borders of 0 and 1 texels, not of 2", [](Subject& s) { s.texture().border = 2; }},
    Mistake{"DriversChoice", "drivers-choice", Note, "textures[0].internalFormat",
            "what GL_COMPRESSED_RGB is stored as",
            [](Subject& s) { s.texture().internalFormat = InternalFormat::CompressedRgb; }},
    Mistake{"Bands", "banding", Note, "textures[0].internalFormat", "GL_RGB4 has at most 16 steps",
            [](Subject& s) {
                s.showGreys(true);
                s.texture().internalFormat = InternalFormat::Rgb4;
            }},
    Mistake{"BandsUnlessTheImageHasSteps", "banding", Note, "textures[0].internalFormat", "bands",
            [](Subject& s) {
                s.showGreys(true);
                s.texture().internalFormat = InternalFormat::R3G3B2;
            },
            [](Subject& s) { s.showGreys(false); }},
    Mistake{"BandsUnlessCompressed", "banding", Note, "textures[0].internalFormat", "bands",
            [](Subject& s) {
                s.showGreys(true);
                s.texture().internalFormat = InternalFormat::Luminance4;
            },
            [](Subject& s) { s.texture().compression = Compression::Cached; }},
    Mistake{"FloatsPassedOnToFog", "float-passed-on", Note, "passes[0].units[0].envMode",
            "a texel of GL_RGB32F_ARB",
            [](Subject& s) {
                s.texture().internalFormat = InternalFormat::Rgb32F;
                s.texture().upload.custom = true;
                s.unit().envMode = EnvMode::Replace;
                s.scene.passes[0].fog.enabled = true;
            },
            [](Subject& s) { s.scene.passes[0].fog.enabled = false; }},
    Mistake{"SrgbNotEncoded", "srgb-not-encoded", Note, "textures[0].internalFormat", "darker than the image",
            [](Subject& s) { s.texture().internalFormat = InternalFormat::Srgb8Alpha8; }},
    Mistake{"SrgbLevels", "srgb-levels", Note, "textures[0].mipGamma", "too dark",
            [](Subject& s) { s.texture().internalFormat = InternalFormat::Sluminance8; }},
    Mistake{"SrgbLevelsOfGlu", "srgb-levels", Note, "textures[0].mipmaps", "too dark",
            [](Subject& s) {
                s.texture().internalFormat = InternalFormat::Sluminance8;
                s.texture().mipmaps = MipPolicy::Glu;
            }},
    Mistake{"SrgbLevelsUnlessTheDriverMakesThem", "srgb-levels", Note, "textures[0].mipGamma", "GL_SRGB8",
            [](Subject& s) { s.texture().internalFormat = InternalFormat::Srgb8; },
            [](Subject& s) { s.texture().mipmaps = MipPolicy::GenerateMipmap; }},
    Mistake{"SrgbLevelsUnlessSeen", "srgb-levels", Note, "textures[0].mipGamma", "GL_SRGB8",
            [](Subject& s) { s.texture().internalFormat = InternalFormat::Srgb8; },
            [](Subject& s) { s.texture().minFilter = MinFilter::Linear; }}};

constexpr std::array settingRows{
    Mistake{"FlipOfAPattern", "texture-setting", Hint, "textures[0].flip", "upright", [](Subject&) {},
            [](Subject& s) { s.showFile(4, 4); }},
    Mistake{"FormatOfCompressed", "texture-setting", Hint, "textures[0].internalFormat", "compressed",
            [](Subject& s) { s.texture().compression = Compression::Driver; },
            [](Subject& s) { s.unit().target = Target::Texture1D; }},
    Mistake{"ScalingAPowerOfTwo", "texture-setting", Hint, "textures[0].npot", "power of two",
            [](Subject&) {}, [](Subject& s) { s.showFile(5, 4); }},
    Mistake{"WrapTOfALine", "texture-setting", Hint, "textures[0].wrapT", "only s",
            [](Subject& s) { s.unit().target = Target::Texture1D; },
            [](Subject& s) { s.unit().target = Target::Texture2D; }},
    Mistake{"WrapROfAPicture", "texture-setting", Hint, "textures[0].wrapR", "GL_TEXTURE_2D", [](Subject&) {},
            [](Subject& s) { s.unit().target = Target::Texture3D; }},
    Mistake{"BorderNotShown", "texture-setting", Hint, "textures[0].borderColor", "no wrap mode",
            [](Subject&) {}, [](Subject& s) { s.texture().wrapT = Wrap::ClampToBorder; }},
    Mistake{"BorderOfClampUnderNearest", "texture-setting", Hint, "textures[0].borderColor", "linear filter",
            [](Subject& s) {
                s.texture().wrapS = Wrap::Clamp;
                s.texture().minFilter = MinFilter::NearestMipmapLinear;
                s.texture().magFilter = MagFilter::Nearest;
            },
            [](Subject& s) { s.texture().magFilter = MagFilter::Linear; }},
    Mistake{"BorderOfRWithoutR", "texture-setting", Hint, "textures[0].borderColor", "no wrap mode",
            [](Subject& s) { s.texture().wrapR = Wrap::ClampToBorder; },
            [](Subject& s) { s.unit().target = Target::Texture3D; }},
    Mistake{"MipFilterUnread", "texture-setting", Hint, "textures[0].mipFilter",
            "GL_NEAREST reads no mipmaps", [](Subject& s) { s.texture().minFilter = MinFilter::Nearest; },
            [](Subject& s) { s.texture().minFilter = MinFilter::NearestMipmapNearest; }},
    Mistake{"MaxLevelUnread", "texture-setting", Hint, "textures[0].maxLevel", "GL_LINEAR reads no mipmaps",
            [](Subject& s) { s.texture().minFilter = MinFilter::Linear; },
            [](Subject& s) { s.texture().minFilter = MinFilter::LinearMipmapNearest; }},
    Mistake{"MinLodUnread", "texture-setting", Hint, "textures[0].minLod", "both filters are the same",
            [](Subject& s) { s.texture().minFilter = MinFilter::Linear; },
            [](Subject& s) { s.texture().magFilter = MagFilter::Nearest; }},
    Mistake{"LodBiasOfTheTextureUnread", "texture-setting", Hint, "textures[0].lodBias",
            "both filters are the same", [](Subject& s) { s.texture().minFilter = MinFilter::Linear; },
            [](Subject& s) { s.texture().magFilter = MagFilter::Nearest; }},
    Mistake{"MaxLodUnread", "texture-setting", Hint, "textures[0].maxLod", "both filters are the same",
            [](Subject& s) { s.texture().minFilter = MinFilter::Linear; },
            [](Subject& s) { s.texture().magFilter = MagFilter::Nearest; }},
    Mistake{"TextureNotShown", "texture-not-shown", Hint, "textures[0]", "no enabled unit",
            [](Subject& s) { s.unit().enabled = false; }, [](Subject& s) { s.unit(2).enabled = true; }},
    Mistake{"FileOfAPattern", "other-texture-choice", Unused, "textures[0].file", "Built-in", [](Subject&) {},
            [](Subject& s) { s.showFile(4, 4); }},
    Mistake{"PatternOfAFile", "other-texture-choice", Unused, "textures[0].pattern", "Image file",
            [](Subject& s) { s.showFile(4, 4); },
            [](Subject& s) { s.texture().source = SourceKind::Pattern; }},
    Mistake{"ColourWithoutStencil", "other-texture-choice", Unused, "textures[0].stencilColor",
            "As in the file", [](Subject&) {},
            [](Subject& s) { s.texture().transparency = Transparency::Stencil; }},
    Mistake{"FormatWithoutCompression", "other-texture-choice", Unused, "textures[0].compressedFormat",
            "As in the file", [](Subject&) {},
            [](Subject& s) { s.texture().compression = Compression::Driver; }},
    Mistake{"MipGammaOfColours", "other-texture-choice", Unused, "textures[0].mipGamma", "Coloured",
            [](Subject& s) { s.texture().mipmaps = MipPolicy::Colored; },
            [](Subject& s) { s.texture().mipmaps = MipPolicy::Generated; }},
    Mistake{"ScalingByGlu", "other-texture-choice", Unused, "textures[0].npot", "gluBuild2DMipmaps",
            [](Subject& s) { s.texture().mipmaps = MipPolicy::Glu; },
            [](Subject& s) { s.texture().mipmaps = MipPolicy::GenerateMipmap; }},
    Mistake{"FilterOfTheDriver", "other-texture-choice", Unused, "textures[0].mipFilter", "glGenerateMipmap",
            [](Subject& s) { s.texture().mipmaps = MipPolicy::GenerateMipmap; },
            [](Subject& s) { s.texture().mipmaps = MipPolicy::Generated; }},
    Mistake{"ScalingOfFileLevels", "other-texture-choice", Unused, "textures[0].npot", "From the file",
            [](Subject& s) { s.texture().mipmaps = MipPolicy::FromFile; },
            [](Subject& s) { s.texture().mipmaps = MipPolicy::None; }}};

} // namespace

std::span<const Mistake> formatMistakes() {
    return formatRows;
}

std::span<const Mistake> settingMistakes() {
    return settingRows;
}

} // namespace texplorer::test

#include "core/base/word.h"
#include "core/scene/params/param_builder.h"

namespace texplorer {
namespace {

using build::color;
using build::param;

constexpr std::array textureRows{
    param<&Texture::source>("source", "Image", "Source", "",
                            "Whether the image is built in or read from a file."),
    param<&Texture::pattern>("pattern", "Image", "Pattern", "",
                             "Which built-in image, where that is the source."),
    param<&Texture::file>("file", "Image", "File", "",
                          "The path of an image, relative to the scene file, where a file is the source."),
    param<&Texture::depthSize>("depthSize", "Image", "Shadow map size", "",
                               "How many texels the shadow map has on each side, where it is the source: "
                               "few make shadows jagged.",
                               {1, 2048, 1, "texels"}),
    param<&Texture::flip>(
        "flip", "Image", "Flip", "",
        "How a picture whose file begins at the top gets upright: OpenGL's first row is the "
        "bottom one."),
    param<&Texture::transparency>("transparency", "Image", "Transparency", "",
                                  "Where the image's alpha comes from: its file, or its colours."),
    color<&Texture::stencilColor>("stencilColor", "Image", "Stencil colour", "",
                                  "The colour that the stencil makes invisible; its alpha says nothing."),
    param<&Texture::internalFormat>(
        "internalFormat", "Image", "Internal format",
        "glTexImage{n}D({image}, level, {}, {extents}, border, format, GL_UNSIGNED_BYTE, pixels)",
        "Which components the texture keeps of the image; the environment treats each format differently."),
    param<&Texture::border>(
        "border", "Image", "Border",
        "glTexImage{n}D({image}, level, internalFormat, {extents}, {}, format, GL_UNSIGNED_BYTE, pixels)",
        "1: a ring of texels replaces the border colour: the outer ring of an image of 2^k + 2 texels a "
        "side; "
        "else, and of levels in a file, the edge once more.",
        {0, 1, 0.02F, {}}),
    param<&Texture::compression>(
        "compression", "Compression", "Compression", "",
        "Whether four by four texels share one small block, and who makes the blocks. A compressed texture "
        "has its own internal format."),
    param<&Texture::compressedFormat>(
        "compressedFormat", "Compression", "Format",
        "glTexImage{n}D({image}, level, {}, {extents}, border, format, GL_UNSIGNED_BYTE, pixels)",
        "What it is compressed to, by the driver or at run time; a file that is compressed has its own."),
    param<&Texture::compressionQuality>(
        "compressionQuality", "Compression", "Quality", "",
        "How much time is spent on each block where Texplorer compresses and then caches."),
    param<&Texture::magFilter>(
        "magFilter", "Filter", "Magnification", "glTexParameteri({target}, GL_TEXTURE_MAG_FILTER, {})",
        "How a colour is found where a texel covers more than a pixel: seen from close by."),
    param<&Texture::minFilter>(
        "minFilter", "Filter", "Minification", "glTexParameteri({target}, GL_TEXTURE_MIN_FILTER, {})",
        "How a colour is found where a pixel covers more than a texel: seen from afar. "
        "The four with MIPMAP in their name need mipmaps."),
    param<&Texture::wrapS>("wrapS", "Wrap", "Wrap s", "glTexParameteri({target}, GL_TEXTURE_WRAP_S, {})",
                           "What lies to the left and right of the image, where s leaves 0 to 1."),
    param<&Texture::wrapT>("wrapT", "Wrap", "Wrap t", "glTexParameteri({target}, GL_TEXTURE_WRAP_T, {})",
                           "What lies below and above the image, where t leaves 0 to 1."),
    param<&Texture::wrapR>("wrapR", "Wrap", "Wrap r", "glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_WRAP_R, {})",
                           "What lies before and behind a volume, where r leaves 0 to 1; 3D textures only."),
    color<&Texture::borderColor>(
        "borderColor", "Wrap", "Border colour", "glTexParameterfv({target}, GL_TEXTURE_BORDER_COLOR, {})",
        "What GL_CLAMP_TO_BORDER shows outside of the image, and half of GL_CLAMP's edge."),
    param<&Texture::mipmaps>("mipmaps", "Mipmaps", "Mipmaps", "",
                             "Where the smaller copies of the image come from, each half as wide and high."),
    param<&Texture::mipFilter>("mipFilter", "Mipmaps", "Mip filter", "",
                               "How a generated level is averaged from the one before it: sharper filters "
                               "ring, softer ones blur."),
    param<&Texture::mipGamma>("mipGamma", "Mipmaps", "Gamma-correct", "",
                              "Whether colours are averaged as light, by sRGB's curve: black and white then "
                              "give 188, not 128."),
    param<&Texture::npot>("npot", "Mipmaps", "Non-power-of-two", "",
                          "What is done with a size that is no power of two before levels are made."),
    param<&Texture::baseLevel>(
        "baseLevel", "Mipmaps", "Base level", "glTexParameteri({target}, GL_TEXTURE_BASE_LEVEL, {})",
        "The largest mip level that is used; 0 is the image itself.", {0, 1000, 0.05F, {}}),
    param<&Texture::maxLevel>("maxLevel", "Mipmaps", "Max level",
                              "glTexParameteri({target}, GL_TEXTURE_MAX_LEVEL, {})",
                              "The smallest mip level that is used. Levels beyond it need not exist.",
                              {0, 1000, 0.05F, {}, "no limit"}),
    param<&Texture::minLod>("minLod", "Mipmaps", "Min LOD",
                            "glTexParameterf({target}, GL_TEXTURE_MIN_LOD, {})",
                            "The level of detail never falls below this: 2 hides the two sharpest levels.",
                            {-1000, 1000, 0.02F, word("levels"), "no limit"}),
    param<&Texture::maxLod>(
        "maxLod", "Mipmaps", "Max LOD", "glTexParameterf({target}, GL_TEXTURE_MAX_LOD, {})",
        "The level of detail never rises above this: 0 keeps far surfaces sharp, and aliased.",
        {-1000, 1000, 0.02F, word("levels"), "no limit"}),
    param<&Texture::lodBias>(
        "lodBias", "Mipmaps", "LOD bias", "glTexParameterf({target}, GL_TEXTURE_LOD_BIAS, {})",
        "Added to the level of detail before the limits, beside the bias of the unit: above 0 blurs, below 0 "
        "sharpens and aliases.",
        {-16, 16, 0.02F, word("levels")}),
    param<&Texture::maxAnisotropy>(
        "maxAnisotropy", "Anisotropy", "Max anisotropy",
        "glTexParameterf({target}, GL_TEXTURE_MAX_ANISOTROPY_EXT, {})",
        "How long and thin the sampled patch may be. Above 1, surfaces that are seen at a "
        "slant stay sharp (GL_EXT_texture_filter_anisotropic).",
        {1, 16, 0.05F, {}}),
    param<&Texture::compareMode>(
        "compareMode", "Depth", "Compare mode", "glTexParameteri({target}, GL_TEXTURE_COMPARE_MODE, {})",
        "Of a depth texture: whether a sample is a depth, or says how r compares with it."),
    param<&Texture::compareFunc>(
        "compareFunc", "Depth", "Compare function", "glTexParameteri({target}, GL_TEXTURE_COMPARE_FUNC, {})",
        "Of a depth texture: what r has to be, compared with the stored depth, to give 1."),
    param<&Texture::depthMode>(
        "depthMode", "Depth", "Depth as", "glTexParameteri({target}, GL_DEPTH_TEXTURE_MODE, {})",
        "Of a depth texture: which components the depth, or the result of comparing, becomes."),
    param<&Texture::priority>(
        "priority", "Residency", "Priority", "glTexParameterf({target}, GL_TEXTURE_PRIORITY, {})",
        "How much the texture wants to stay in fast memory. No pixel changes by it.", {0, 1, 0.005F, {}}),
};
static_assert(textureRows.size() == 32);

constexpr ParamRow pictureSource(ParamRow row) {
    row.choices = pictureSourceRows;
    return row;
}

constexpr std::array givenLevelRows{
    pictureSource(param<&GivenLevel::source>("source", "Level", "Source", "",
                                             "Whether this level's image is built in or read from a file.")),
    param<&GivenLevel::pattern>("pattern", "Level", "Pattern", "",
                                "Which built-in image, scaled to the level's size."),
    param<&GivenLevel::file>(
        "file", "Level", "File", "",
        "The path of an image, relative to the scene file. It should have half the size of the level before."),
};
static_assert(givenLevelRows.size() == 3 && givenLevelRows.size() == build::memberCount<GivenLevel>());

constexpr std::array imageStepRows{
    param<&ImageStep::op>("op", "Step", "Operation", "", "What this step does to the image."),
    param<&ImageStep::factor>("factor", "Step", "Factor", "",
                              "What red, green, blue and alpha are multiplied by (GL_RED_SCALE and so on).",
                              {-16, 16, 0.01F, {}}),
    param<&ImageStep::bias>("bias", "Step", "Bias", "",
                            "What is added to red, green, blue and alpha afterwards (GL_RED_BIAS and so on).",
                            {-16, 16, 0.01F, {}}),
    param<&ImageStep::amount>("amount", "Step", "Amount", "", "How strongly it sharpens; 0 changes nothing.",
                              {0, 8, 0.01F, {}}),
    pictureSource(param<&ImageStep::source>(
        "source", "Step", "Alpha's source", "",
        "Whether the picture whose luminance becomes alpha is built in or a file.")),
    param<&ImageStep::pattern>("pattern", "Step", "Alpha's pattern", "",
                               "Which built-in image becomes alpha."),
    param<&ImageStep::file>("file", "Step", "Alpha's file", "",
                            "The path of the image that becomes alpha, relative to the scene file."),
};
static_assert(imageStepRows.size() == 7 && imageStepRows.size() == build::memberCount<ImageStep>());

} // namespace

const StructTable& textureTable() {
    static const std::array children{
        build::many<&Texture::levels>("levels", "Level", givenLevelTable(), 0, maxGivenLevels),
        build::many<&Texture::preparation>("preparation", "Image step", imageStepTable(), 0, maxImageSteps),
    };
    // The sampler state is one member of the texture, its base, and has a row for each of its own.
    static_assert(textureRows.size() + children.size() ==
                  build::memberCount<Texture>() - 1 + build::memberCount<SamplerState>());
    static const StructTable table{"Texture", textureRows, children};
    return table;
}

const StructTable& givenLevelTable() {
    static const StructTable table{"Level", givenLevelRows, {}};
    return table;
}

const StructTable& imageStepTable() {
    static const StructTable table{"ImageStep", imageStepRows, {}};
    return table;
}

} // namespace texplorer

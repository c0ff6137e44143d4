#include "texplorer/base/translatable.h"
#include "texplorer/scene/params/param_builder.h"

namespace texplorer {
namespace {

using build::color;
using build::param;

constexpr std::array textureRows{
    param<&Texture::source>("source", N_("Image"), N_("Source"), "",
                            N_("Whether the image is built in, read from a file or drawn.")),
    param<&Texture::pattern>("pattern", N_("Image"), N_("Pattern"), "",
                             N_("The built-in image, if that is the source.")),
    param<&Texture::file>(
        "file", N_("Image"), N_("File"), "",
        N_("The path of an image file, relative to the scene file, if a file is the source.")),
    param<&Texture::depthSize>("depthSize", N_("Image"), N_("Shadow map size"), "",
                               N_("The number of texels on each side of the shadow map, if that is the "
                                  "source. Few texels make jagged shadows."),
                               {1, 2048, 1, N_("texels")}),
    param<&Texture::picture>(
        "picture", N_("Image"), N_("Picture"), "",
        N_("The number of the picture. The passes with the same number in \"Draws in\" draw it."),
        {1, static_cast<float>(maxPictures), 0.02F, {}}),
    param<&Texture::pictureSize>("pictureSize", N_("Image"), N_("Picture size"), "",
                                 N_("The number of texels on each side of the picture."),
                                 {1, 2048, 1, N_("texels")}),
    param<&Texture::frames>("frames", N_("Image"), N_("Frames"), "",
                            N_("How often the picture is drawn, 1/30 s apart. A pass that reads a picture "
                               "before it is finished sees the frame before; the first sees black."),
                            {1, static_cast<float>(maxFrames), 0.05F, {}}),
    param<&Texture::pictureCall>(
        "pictureCall", N_("Image"), N_("Drawn by"), "",
        N_("The call by which a program fills the texture. The picture is the same.")),
    param<&Texture::flip>(
        "flip", N_("Image"), N_("Flip"), "",
        N_("How an image whose file begins with the top row is turned upright. OpenGL's first row is the "
           "bottom one.")),
    param<&Texture::transparency>("transparency", N_("Image"), N_("Transparency"), "",
                                  N_("Where the image's alpha comes from: its file, or its colours.")),
    color<&Texture::stencilColor>("stencilColor", N_("Image"), N_("Stencil colour"), "",
                                  N_("The colour that the stencil makes invisible. Its alpha is ignored.")),
    param<&Texture::internalFormat>(
        "internalFormat", N_("Image"), N_("Internal format"),
        "glTexImage{n}D({image}, level, {}, {extents}, border, format, GL_UNSIGNED_BYTE, pixels)",
        N_("The components of the image that the texture keeps. The environment treats each format "
           "differently.")),
    param<&Texture::border>(
        "border", N_("Image"), N_("Border"),
        "glTexImage{n}D({image}, level, internalFormat, {extents}, {}, format, GL_UNSIGNED_BYTE, pixels)",
        N_("1: a ring of texels replaces the border colour: the outer ring of an image with "
           "sides of 2^k + 2 texels, else its edge. 2 is GL_INVALID_VALUE."),
        {0, 2, 0.02F, {}}),
    param<&Texture::compression>(
        "compression", N_("Compression"), N_("Compression"), "",
        N_("Whether 4 × 4 texels share one small block, and what makes the blocks. A compressed texture has "
           "its own internal format.")),
    param<&Texture::compressedFormat>(
        "compressedFormat", N_("Compression"), N_("Format"),
        "glTexImage{n}D({image}, level, {}, {extents}, border, format, GL_UNSIGNED_BYTE, pixels)",
        N_("The format that the driver or Texplorer compresses to. A compressed file keeps its own.")),
    param<&Texture::compressionQuality>(
        "compressionQuality", N_("Compression"), N_("Quality"), "",
        N_("How much time Texplorer spends on each block when it compresses and caches.")),
    param<&Texture::magFilter>(
        "magFilter", N_("Filter"), N_("Magnification"),
        "glTexParameteri({target}, GL_TEXTURE_MAG_FILTER, {})",
        N_("How a colour is found where a texel covers more than one pixel, as seen from close by.")),
    param<&Texture::minFilter>(
        "minFilter", N_("Filter"), N_("Minification"), "glTexParameteri({target}, GL_TEXTURE_MIN_FILTER, {})",
        N_("How a colour is found where a pixel covers more than one texel, as seen from afar. The four with "
           "MIPMAP in their name need mipmaps.")),
    param<&Texture::wrapS>("wrapS", N_("Wrap"), N_("Wrap s"),
                           "glTexParameteri({target}, GL_TEXTURE_WRAP_S, {})",
                           N_("What is shown left and right of the image, where s is outside 0 to 1.")),
    param<&Texture::wrapT>("wrapT", N_("Wrap"), N_("Wrap t"),
                           "glTexParameteri({target}, GL_TEXTURE_WRAP_T, {})",
                           N_("What is shown below and above the image, where t is outside 0 to 1.")),
    param<&Texture::wrapR>("wrapR", N_("Wrap"), N_("Wrap r"),
                           "glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_WRAP_R, {})",
                           N_("What is shown in front of and behind a volume, where r is outside 0 to 1 (3D "
                              "textures only).")),
    color<&Texture::borderColor>(
        "borderColor", N_("Wrap"), N_("Border colour"),
        "glTexParameterfv({target}, GL_TEXTURE_BORDER_COLOR, {})",
        N_("The colour that GL_CLAMP_TO_BORDER shows outside the image, and half of the colour at GL_CLAMP's "
           "edge.")),
    param<&Texture::mipmaps>("mipmaps", N_("Mipmaps"), N_("Mipmaps"), "",
                             N_("Where the smaller copies of the image come from. Each is half as wide and "
                                "half as high.")),
    param<&Texture::mipFilter>("mipFilter", N_("Mipmaps"), N_("Mip filter"), "",
                               N_("How a level is averaged from the one before it. Sharper filters ring, "
                                  "softer ones blur.")),
    param<&Texture::mipGamma>("mipGamma", N_("Mipmaps"), N_("Gamma-correct"), "",
                              N_("Whether colours are averaged as amounts of light, by the sRGB curve. Black "
                                 "and white then give 188, not 128.")),
    param<&Texture::npot>("npot", N_("Mipmaps"), N_("Non-power-of-two"), "",
                          N_("What is done with a size that is not a power of two before levels are made.")),
    param<&Texture::baseLevel>(
        "baseLevel", N_("Mipmaps"), N_("Base level"), "glTexParameteri({target}, GL_TEXTURE_BASE_LEVEL, {})",
        N_("The largest mip level that is used; 0 is the image itself."), {0, 1000, 0.05F, {}}),
    param<&Texture::maxLevel>("maxLevel", N_("Mipmaps"), N_("Max level"),
                              "glTexParameteri({target}, GL_TEXTURE_MAX_LEVEL, {})",
                              N_("The smallest mip level that is used. Levels beyond it need not exist."),
                              {0, 1000, 0.05F, {}, N_("no limit")}),
    param<&Texture::minLod>("minLod", N_("Mipmaps"), N_("Min LOD"),
                            "glTexParameterf({target}, GL_TEXTURE_MIN_LOD, {})",
                            N_("The lower limit of the level of detail. 2 hides the two sharpest levels."),
                            {-1000, 1000, 0.02F, N_("levels"), N_("no limit")}),
    param<&Texture::maxLod>(
        "maxLod", N_("Mipmaps"), N_("Max LOD"), "glTexParameterf({target}, GL_TEXTURE_MAX_LOD, {})",
        N_("The upper limit of the level of detail. 0 keeps far surfaces sharp, and aliased."),
        {-1000, 1000, 0.02F, N_("levels"), N_("no limit")}),
    param<&Texture::lodBias>(
        "lodBias", N_("Mipmaps"), N_("LOD bias"), "glTexParameterf({target}, GL_TEXTURE_LOD_BIAS, {})",
        N_("Added to the level of detail before the limits, together with the bias of the unit. Above 0 "
           "blurs, below 0 sharpens and aliases."),
        {-16, 16, 0.02F, N_("levels")}),
    param<&Texture::mipCoverage>(
        "mipCoverage", N_("Mipmaps"), N_("Keep coverage"), "",
        N_("An alpha test's reference: alpha of each level is scaled so that as much of it passes as of the "
           "image itself. Far leaves then don't vanish."),
        {0, 1, 0.005F, {}, N_("off")}),
    param<&Texture::oversize>("oversize", N_("Mipmaps"), N_("Too large"), "",
                              N_("What is uploaded of an image that is larger than the driver's largest "
                                 "texture: nothing, or less of it.")),
    param<&Texture::maxAnisotropy>(
        "maxAnisotropy", N_("Anisotropy"), N_("Max anisotropy"),
        "glTexParameterf({target}, GL_TEXTURE_MAX_ANISOTROPY_EXT, {})",
        N_("The largest ratio of length to width of the sampled patch. Above 1, surfaces that are seen at a "
           "slant stay sharp (GL_EXT_texture_filter_anisotropic)."),
        {1, 16, 0.05F, {}}),
    param<&Texture::compareMode>(
        "compareMode", N_("Depth"), N_("Compare mode"),
        "glTexParameteri({target}, GL_TEXTURE_COMPARE_MODE, {})",
        N_("For a depth texture: whether a sample is the depth or the result of comparing r with it.")),
    param<&Texture::compareFunc>(
        "compareFunc", N_("Depth"), N_("Compare function"),
        "glTexParameteri({target}, GL_TEXTURE_COMPARE_FUNC, {})",
        N_("For a depth texture: how r must compare with the stored depth to give 1.")),
    param<&Texture::depthMode>(
        "depthMode", N_("Depth"), N_("Depth as"), "glTexParameteri({target}, GL_DEPTH_TEXTURE_MODE, {})",
        N_("For a depth texture: the components that receive the depth or the result of comparing.")),
    param<&Texture::priority>(
        "priority", N_("Residency"), N_("Priority"), "glTexParameterf({target}, GL_TEXTURE_PRIORITY, {})",
        N_("How important it is to keep the texture in fast memory. It changes no pixel."),
        {0, 1, 0.005F, {}}),
};
static_assert(textureRows.size() == 38);

constexpr ParamRow pictureSource(ParamRow row) {
    row.choices = pictureSourceRows;
    return row;
}

constexpr std::array givenLevelRows{
    pictureSource(
        param<&GivenLevel::source>("source", N_("Level"), N_("Source"), "",
                                   N_("Whether this level's image is built in or read from a file."))),
    param<&GivenLevel::pattern>("pattern", N_("Level"), N_("Pattern"), "",
                                N_("The built-in image, scaled to the size of the level.")),
    param<&GivenLevel::file>(
        "file", N_("Level"), N_("File"), "",
        N_("The path of an image file, relative to the scene file. It should have half the size of the level "
           "before.")),
};
static_assert(givenLevelRows.size() == 3 && givenLevelRows.size() == build::memberCount<GivenLevel>());

constexpr std::array imageStepRows{
    param<&ImageStep::op>("op", N_("Step"), N_("Operation"), "", N_("What this step does to the image.")),
    param<&ImageStep::factor>("factor", N_("Step"), N_("Factor"), "",
                              N_("The factors of red, green, blue and alpha (GL_RED_SCALE and so on)."),
                              {-16, 16, 0.01F, {}}),
    param<&ImageStep::bias>(
        "bias", N_("Step"), N_("Bias"), "",
        N_("Added to red, green, blue and alpha after the factors (GL_RED_BIAS and so on)."),
        {-16, 16, 0.01F, {}}),
    param<&ImageStep::amount>("amount", N_("Step"), N_("Amount"), "",
                              N_("How strongly the image is sharpened; for normals, how many texels high "
                                 "white is. 0 changes nothing, or makes a plane."),
                              {0, 8, 0.01F, {}}),
    param<&ImageStep::red>("red", N_("Step"), N_("Red from"), "",
                           N_("The component that becomes red, of this image or of the other one.")),
    param<&ImageStep::green>("green", N_("Step"), N_("Green from"), "",
                             N_("The component that becomes green, of this image or of the other one.")),
    param<&ImageStep::blue>("blue", N_("Step"), N_("Blue from"), "",
                            N_("The component that becomes blue, of this image or of the other one.")),
    param<&ImageStep::alpha>("alpha", N_("Step"), N_("Alpha from"), "",
                             N_("The component that becomes alpha, of this image or of the other one.")),
    param<&ImageStep::share>("share", N_("Step"), N_("Share"), "",
                             N_("The factor of width and height, and of a volume's depth; the result is "
                                "rounded down. 0.5 halves them."),
                             {0, 1, 0.005F, {}}),
    param<&ImageStep::width>("width", N_("Step"), N_("Width"), "",
                             N_("The width of the base level, which the others halve; 0: by the share."),
                             {0, 1024, 1, N_("texels"), N_("by the share")}),
    param<&ImageStep::height>("height", N_("Step"), N_("Height"), "",
                              N_("The height of the base level, which the others halve; 0: by the share."),
                              {0, 1024, 1, N_("texels"), N_("by the share")}),
    pictureSource(param<&ImageStep::source>(
        "source", N_("Step"), N_("Other source"), "",
        N_("Whether the other image, which the step reads, is built in or read from a file."))),
    param<&ImageStep::pattern>("pattern", N_("Step"), N_("Other pattern"), "",
                               N_("The other image, if it is built in.")),
    param<&ImageStep::file>("file", N_("Step"), N_("Other file"), "",
                            N_("The path of the other image's file, relative to the scene file.")),
};
constexpr std::array subimageRows{
    param<&Subimage::level>("level", N_("Subimage"), N_("Level"), "",
                            N_("The level that is changed; 0 is the base."),
                            {0, static_cast<float>(maxGivenLevels), 0.02F, {}}),
    param<&Subimage::x>("x", N_("Subimage"), N_("x offset"), "",
                        N_("The column where the part begins, counted from the left."),
                        {0, 16383, 0.2F, N_("texels")}),
    param<&Subimage::y>("y", N_("Subimage"), N_("y offset"), "",
                        N_("The row where the part begins, counted from t = 0."),
                        {0, 16383, 0.2F, N_("texels")}),
    param<&Subimage::z>(
        "z", N_("Subimage"), N_("z offset"), "",
        N_("The slice of a 3D texture where the part begins; of a cube map, the face, from 0 to 5."),
        {0, 16383, 0.2F, N_("texels")}),
    param<&Subimage::width>("width", N_("Subimage"), N_("Width"), "",
                            N_("The width of a built-in image; a file keeps its own."),
                            {1, 2048, 0.2F, N_("texels")}),
    param<&Subimage::height>("height", N_("Subimage"), N_("Height"), "",
                             N_("The height of a built-in image; a file keeps its own."),
                             {1, 2048, 0.2F, N_("texels")}),
    pictureSource(param<&Subimage::source>("source", N_("Subimage"), N_("Source"), "",
                                           N_("Whether the part's image is built in or read from a file."))),
    param<&Subimage::pattern>("pattern", N_("Subimage"), N_("Pattern"), "",
                              N_("The built-in image, scaled to the part.")),
    param<&Subimage::file>("file", N_("Subimage"), N_("File"), "",
                           N_("The path of an image file, relative to the scene file.")),
};
static_assert(subimageRows.size() == 9 && subimageRows.size() == build::memberCount<Subimage>());
static_assert(imageStepRows.size() == 14 && imageStepRows.size() == build::memberCount<ImageStep>());

} // namespace

const StructTable& textureTable() {
    static const std::array children{
        build::many<&Texture::levels>("levels", N_("Level"), givenLevelTable(), 0, maxGivenLevels),
        build::many<&Texture::preparation>("preparation", N_("Image step"), imageStepTable(), 0,
                                           maxImageSteps),
        build::many<&Texture::subimages>("subimages", N_("Subimage"), subimageTable(), 0, maxSubimages),
        build::single<&Texture::upload>("upload", N_("Upload"), uploadTable()),
    };
    // The sampler state is one member of the texture, its base, and has a row for each of its own.
    static_assert(textureRows.size() + children.size() ==
                  build::memberCount<Texture>() - 1 + build::memberCount<SamplerState>());
    static const StructTable table{N_("Texture"), textureRows, children};
    return table;
}

const StructTable& givenLevelTable() {
    static const StructTable table{N_("Level"), givenLevelRows, {}};
    return table;
}

const StructTable& subimageTable() {
    static const StructTable table{N_("Subimage"), subimageRows, {}};
    return table;
}

const StructTable& imageStepTable() {
    static const StructTable table{N_("ImageStep"), imageStepRows, {}};
    return table;
}

} // namespace texplorer

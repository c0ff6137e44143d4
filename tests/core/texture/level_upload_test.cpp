// Custom uploads: what of them becomes of a texture's levels.

#include "texplorer/image/depth_pixels.h"
#include "texplorer/image/float_pixels.h"
#include "texplorer/texture/image_source.h"
#include "texplorer/texture/level_plan.h"
#include "texplorer/texture/texture_levels.h"

#include <gmock/gmock.h>

namespace texplorer::level_upload_test {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::IsEmpty;

/// Greys 1, 2, 3, …, so that each byte of the memory is known by its value.
Image ramp(int width, int height) {
    Image image = Image::uninitialised(PixelFormat::Luminance8, width, height);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = static_cast<std::byte>(i + 1);
    return image;
}

Texture custom(TransferFormat format, int alignment = 4) {
    Texture texture;
    texture.flip = FlipMode::Pixels;
    texture.upload = {.custom = true, .format = format, .alignment = alignment};
    return texture;
}

const Image& levelOf(const TextureLevels& levels, std::size_t index) {
    return std::get<Image>(*levels.levels.at(index).surface);
}

/// The reds of a level's row.
std::vector<int> redsOf(const TextureLevels& levels, std::size_t index, int row) {
    const Image& image = levelOf(levels, index);
    std::vector<int> reds;
    for (int x = 0; x < image.width; ++x)
        reds.push_back(std::to_integer<int>(image.at(x, row)[0]));
    return reds;
}

std::string problemOf(const Texture& texture, const TextureImage& image) {
    const Result<TextureLevels> levels = prepareLevels(texture, image);
    return levels ? "" : describe(levels.error());
}

// Rows of 3 bytes, where OpenGL expects them at multiples of 4; beyond the end there are zeros.
TEST(WrongAlignment, ShearsTheImage) {
    const TextureImage image = textureOf(ramp(3, 3), "PNG");
    const TextureLevels levels = *prepareLevels(custom(TransferFormat::Luminance), image);
    EXPECT_THAT(redsOf(levels, 0, 0), ElementsAre(1, 2, 3));
    EXPECT_THAT(redsOf(levels, 0, 1), ElementsAre(5, 6, 7));
    EXPECT_THAT(redsOf(levels, 0, 2), ElementsAre(9, 0, 0));
    ASSERT_TRUE(levels.levels[0].memory);
    EXPECT_EQ(levels.levels[0].held, 9U);
    EXPECT_EQ(levels.levels[0].memory->size(), 11U) << "the call reads two rows of 4 bytes and 3 more";
    EXPECT_EQ(levels.call->layout.format, TransferFormat::Luminance);
    const TextureLevels tight = *prepareLevels(custom(TransferFormat::Luminance, 1), image);
    EXPECT_THAT(redsOf(tight, 0, 2), ElementsAre(7, 8, 9));
}

TEST(RowsOfBmp, BeginAtMultiplesOfFourBytesWithBlueFirst) {
    Image image = Image::uninitialised(PixelFormat::Rgb8, 1, 2);
    for (std::size_t i = 0; i < 6; ++i)
        image.pixels[i] = static_cast<std::byte>(10 * i);
    const TextureLevels swapped = *prepareLevels(custom(TransferFormat::Rgb), textureOf(image, "BMP"));
    EXPECT_THAT(redsOf(swapped, 0, 0), ElementsAre(20));
    EXPECT_THAT(redsOf(swapped, 0, 1), ElementsAre(50));
    const TextureLevels right = *prepareLevels(custom(TransferFormat::Bgr), textureOf(image, "BMP"));
    EXPECT_THAT(redsOf(right, 0, 1), ElementsAre(30));
}

// A program that makes all levels uploads each; a driver and GLU make theirs of what was read.
TEST(OtherLevels, AreReadOrMadeOfWhatWasRead) {
    Image image = Image::uninitialised(PixelFormat::Rgb8, 2, 2); // blue
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = static_cast<std::byte>(i % 3 == 2 ? 200 : 0);
    for (const MipPolicy policy : {MipPolicy::Generated, MipPolicy::GenerateMipmap, MipPolicy::Glu}) {
        Texture texture = custom(TransferFormat::Bgr, 1);
        texture.mipmaps = policy;
        const TextureLevels levels = *prepareLevels(texture, textureOf(image, "PNG"));
        ASSERT_EQ(levels.levels.size(), 2U);
        EXPECT_THAT(redsOf(levels, 1, 0), ElementsAre(200)) << rowOf(policy).name;
        EXPECT_EQ(levels.levels[0].memory != nullptr, policy != MipPolicy::Glu);
        EXPECT_EQ(levels.levels[1].memory != nullptr, policy == MipPolicy::Generated);
    }
    Texture sheared = custom(TransferFormat::Luminance);
    sheared.mipmaps = MipPolicy::Generated;
    const TextureLevels own = *prepareLevels(sheared, textureOf(ramp(6, 6), "PNG"));
    EXPECT_THAT(redsOf(own, 1, 1), Each(testing::Gt(0))) << "its rows are at 4, and not at 3 of 9 bytes";
    sheared.mipmaps = MipPolicy::GenerateMipmap;
    const TextureLevels made = *prepareLevels(sheared, textureOf(ramp(6, 6), "PNG"));
    EXPECT_EQ(redsOf(made, 1, 2).back(), 0) << "the mean of bytes beyond the end";
}

TEST(CallsThatOpenGlRefuses, AreNamed) {
    const TextureImage image = textureOf(ramp(2, 2), "PNG");
    Texture texture = custom(TransferFormat::Bgr);
    texture.upload.type = TransferType::UnsignedShort565;
    EXPECT_EQ(problemOf(texture, image),
              "GL_INVALID_OPERATION: GL_UNSIGNED_SHORT_5_6_5 takes GL_RGB, not GL_BGR");
    const TexturePictures pictures(std::make_shared<const TextureImage>(image));
    EXPECT_THAT(planLevels(texture, pictures, Target::Texture2D).levels, IsEmpty());
    EXPECT_EQ(problemOf(custom(TransferFormat::DepthComponent), image),
              "GL_INVALID_OPERATION: GL_DEPTH_COMPONENT is for depth textures, not for GL_RGBA");
    Texture depth = custom(TransferFormat::Luminance);
    depth.internalFormat = InternalFormat::DepthComponent16;
    EXPECT_EQ(problemOf(depth, image),
              "GL_INVALID_OPERATION: GL_DEPTH_COMPONENT16 takes GL_DEPTH_COMPONENT, not GL_LUMINANCE");
    Texture impossible = custom(TransferFormat::Rgb);
    impossible.upload.memory = MemoryRows::Layout;
    impossible.upload.memoryType = TransferType::UnsignedShort565;
    EXPECT_EQ(problemOf(impossible, image),
              "the memory's type GL_UNSIGNED_SHORT_5_6_5 does not hold the components of GL_RGBA");
}

TEST(ArgumentsThatOpenGlRefuses, AreNamed) {
    const TextureImage image = textureOf(ramp(2, 2), "PNG");
    const TexturePictures pictures(std::make_shared<const TextureImage>(image));
    Texture texture;
    texture.internalFormat = InternalFormat::Bgra;
    EXPECT_EQ(problemOf(texture, image), "GL_INVALID_VALUE: GL_BGRA is not an internal format");
    EXPECT_THAT(planLevels(texture, pictures, Target::Texture2D).levels, IsEmpty());
    texture.compression = Compression::Cached; // has another internal format
    EXPECT_TRUE(prepareLevels(texture, image));
    texture = {};
    texture.border = 2;
    EXPECT_EQ(problemOf(texture, image), "GL_INVALID_VALUE: OpenGL has borders of 0 and 1 texels, not of 2");
    EXPECT_EQ(planLevels(texture, pictures, Target::Texture2D).refusal.english(),
              "GL_INVALID_VALUE: OpenGL has borders of 0 and 1 texels, not of 2");
}

// What the program holds of the base: after the preparation, before GLU scales it.
TEST(PlansOfUploads, HaveTheMemoryOfTheBase) {
    const TexturePictures pictures(std::make_shared<const TextureImage>(textureOf(ramp(5, 3), "PNG")));
    Texture texture = custom(TransferFormat::LuminanceAlpha);
    texture.preparation = {{.op = ImageOp::LuminanceToAlpha}};
    texture.mipmaps = MipPolicy::Glu;
    texture.border = 1;
    const LevelPlan plan = planLevels(texture, pictures, Target::Texture2D);
    ASSERT_TRUE(plan.upload);
    EXPECT_EQ(plan.upload->memory.pixels.format, TransferFormat::LuminanceAlpha);
    EXPECT_EQ(plan.upload->extent, (PixelExtent{7, 5, 1}));
    EXPECT_EQ(plan.upload->refusal, "");
    const TextureLevels levels = *prepareLevels(texture, pictures, Target::Texture2D);
    EXPECT_FALSE(levels.levels[0].memory);
    texture.upload.custom = false;
    EXPECT_FALSE(planLevels(texture, pictures, Target::Texture2D).upload);
}

TEST(CallsThatReadTooMuch, AreRefused) {
    Texture texture = custom(TransferFormat::Rgba);
    texture.upload.type = TransferType::Float;
    texture.upload.rowLength = 4096;
    texture.upload.skipRows = 4096;
    EXPECT_EQ(problemOf(texture, textureOf(ramp(16, 16), "PNG")),
              "the call would read 269418752 bytes; at most 268435456 are read");
}

TEST(DepthTextures, ReadDepths) {
    Texture texture = custom(TransferFormat::DepthComponent, 1);
    texture.internalFormat = InternalFormat::DepthComponent16;
    const TextureLevels levels = *prepareLevels(texture, textureOf(ramp(3, 1), "PNG"));
    ASSERT_EQ(levelOf(levels, 0).format, PixelFormat::Depth32);
    EXPECT_EQ(greyOfDepth(depthAt(levelOf(levels, 0).at(2, 0).data())), 3);
}

TEST(FormatsOfFewBits, AreUploadedAsTheyAreStored) {
    Texture texture = custom(TransferFormat::Luminance, 1);
    texture.internalFormat = InternalFormat::Rgba4;
    const TextureLevels levels = *prepareLevels(texture, textureOf(ramp(3, 1), "PNG"));
    EXPECT_FALSE(levels.levels[0].memory) << "the driver would store 8 bits of it";
    EXPECT_THAT(redsOf(levels, 0, 0), Each(0));
}

TEST(Blocks, HaveNoFormatToBeTold) {
    Texture texture = custom(TransferFormat::Bgr);
    texture.compression = Compression::Cached;
    Texture plain = texture;
    plain.upload = {};
    const TextureImage image = textureOf(ramp(4, 4), "PNG");
    EXPECT_EQ(*prepareLevels(texture, image)->levels[0].surface,
              *prepareLevels(plain, image)->levels[0].surface);
}

TEST(UploadsThatFit, AreNotCustom) {
    Texture texture = custom(TransferFormat::Bgr);
    texture.upload.custom = false;
    const TextureLevels levels = *prepareLevels(texture, textureOf(ramp(3, 3), "PNG"));
    EXPECT_FALSE(levels.call);
    EXPECT_EQ(levelOf(levels, 0), ramp(3, 3));
}

/// A texture of floats whose texels are 4 c - 1 of the image's components c.
Texture ofFloats(InternalFormat format) {
    Texture texture = custom(TransferFormat::Luminance, 1);
    texture.internalFormat = format;
    texture.upload.scale = glm::vec4(4);
    texture.upload.bias = glm::vec4(-1);
    return texture;
}

std::vector<float> floatRedsOf(const TextureLevels& levels, std::size_t index) {
    const Image& image = levelOf(levels, index);
    EXPECT_EQ(image.format, PixelFormat::RgbaFloat);
    std::vector<float> reds;
    for (int x = 0; x < image.width; ++x)
        reds.push_back(floatsAt(image.at(x, 0).data())[0]);
    return reds;
}

TEST(FloatFormats, KeepWhatScaleAndBiasMake) {
    Image line = Image::uninitialised(PixelFormat::Luminance8, 4, 1);
    line.pixels = {std::byte{0}, std::byte{51}, std::byte{102}, std::byte{255}};
    const TextureImage image = textureOf(line, "PNG");
    Texture texture = ofFloats(InternalFormat::Rgb32F);
    EXPECT_THAT(floatRedsOf(*prepareLevels(texture, image), 0),
                testing::Pointwise(testing::FloatNear(1e-6F), {-1.0F, -0.2F, 0.6F, 3.0F}));
    texture.mipmaps = MipPolicy::GenerateMipmap; // of what is stored
    const TextureLevels chain = *prepareLevels(texture, image);
    ASSERT_EQ(chain.levels.size(), 3U);
    EXPECT_TRUE(chain.madeByDriver);
    EXPECT_THAT(floatRedsOf(chain, 1), testing::Pointwise(testing::FloatNear(1e-6F), {-0.6F, 1.8F}));
    texture.internalFormat = InternalFormat::Rgb16F; // steps of 2^-11 above 0.5 and of 2^-13 above 0.125
    EXPECT_THAT(floatRedsOf(*prepareLevels(texture, image), 0),
                testing::ElementsAre(-1, -1638 / 8192.0F, 1229 / 2048.0F, 3));
    texture.internalFormat = InternalFormat::Rgb;
    EXPECT_THAT(redsOf(*prepareLevels(texture, image), 0, 0), testing::ElementsAre(0, 0, 153, 255));
}

TEST(FloatFormats, AreReplacedInPart) {
    Texture texture = ofFloats(InternalFormat::Rgba32F);
    texture.subimages = {{.x = 1, .width = 1, .height = 1}};
    ImageSource images;
    Image line = Image::uninitialised(PixelFormat::Luminance8, 2, 1);
    line.pixels = {std::byte{255}, std::byte{255}};
    images.put("line", textureOf(line, "PNG"));
    texture.source = SourceKind::File;
    texture.file = "line";
    const TextureLevels levels = *prepareLevels(texture, images.picturesOf(texture), Target::Texture2D);
    EXPECT_EQ(floatRedsOf(levels, 0)[0], 3);
    EXPECT_LE(floatRedsOf(levels, 0)[1], 1) << "its pixels are neither scaled nor biased";
}

} // namespace
} // namespace texplorer::level_upload_test

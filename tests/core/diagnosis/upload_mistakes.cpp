#include "tests/core/diagnosis/mistakes.h"

#include <bit>

namespace texplorer::test {
namespace {

using enum Severity;

/// A custom upload that fits an image of 15 × 4 pixels: its rows of RGB are 45 bytes.
Upload& custom(Subject& s, PixelFormat format = PixelFormat::Rgb8, std::string_view file = "PNG") {
    s.texture().source = SourceKind::File;
    s.texture().file = "image.png";
    s.texture().mipmaps = MipPolicy::Generated;
    TextureImage image;
    image.format = file;
    image.surfaces.emplace_back(Image::uninitialised(format, 15, 4));
    s.texture().upload = fittingUpload({}, memoryOf({}, format, file), 15, false);
    s.images.put("image.png", std::move(image));
    return s.texture().upload;
}

void holdFloats(Subject& s) {
    Upload& upload = custom(s);
    upload.memory = MemoryRows::Layout;
    upload.memoryFormat = TransferFormat::Rgb;
    upload.memoryType = upload.type = TransferType::Float;
}

constexpr std::array uploadRows{
    Mistake{"SlantedRows", "upload-rows", Warning, "textures[0].upload.alignment",
            "rows are 45 bytes, OpenGL expects 48: the picture is slanted",
            [](Subject& s) { custom(s).alignment = 4; }},
    Mistake{"SlantedRowsOfALengthRatherThanAnAlignment", "upload-rows", Warning,
            "textures[0].upload.rowLength", "rows are 48 bytes, OpenGL expects 44", // 8 would make 48 of it
            [](Subject& s) { custom(s, PixelFormat::Rgb8, "BMP").rowLength = 14; }},
    Mistake{"SlantedRowsOfALength", "upload-rows", Warning, "textures[0].upload.rowLength",
            "rows are 45 bytes, OpenGL expects 48", [](Subject& s) { custom(s).rowLength = 16; }},
    Mistake{"RowsOfALengthThatFitsByItsAlignment", "upload-rows", Warning, "textures[0].upload.alignment",
            "rows are 48 bytes, OpenGL expects 45",
            [](Subject& s) { custom(s, PixelFormat::Rgb8, "BMP").alignment = 1; }},
    Mistake{"SlantedUnlessALine", "upload-rows", Warning, "textures[0].upload.alignment", "slanted",
            [](Subject& s) { custom(s).alignment = 8; },
            [](Subject& s) { s.unit().target = Target::Texture1D; }},
    Mistake{"BlueFirst", "upload-pixels", Warning, "textures[0].upload.format",
            "the bytes are in blue-first order, GL_BGR: as GL_RGB, red and blue are exchanged",
            [](Subject& s) { custom(s, PixelFormat::Rgb8, "TGA").format = TransferFormat::Rgb; }},
    Mistake{"RedFirst", "upload-pixels", Warning, "textures[0].upload.format",
            "the memory has GL_RGBA, but glTexImage is told GL_BGRA",
            [](Subject& s) { custom(s, PixelFormat::Rgba8).format = TransferFormat::Bgra; }},
    Mistake{"TooManyComponents", "upload-pixels", Warning, "textures[0].upload.format",
            "the memory has GL_RGB; GL_RGBA has another number",
            [](Subject& s) { custom(s).format = TransferFormat::Rgba; }},
    Mistake{"AlphaOfAStepUncounted", "upload-pixels", Warning, "textures[0].upload.format",
            "the memory has GL_RGBA; GL_RGB has another number",
            [](Subject& s) {
                custom(s);
                s.texture().preparation = {{.op = ImageOp::LuminanceToAlpha}};
            }},
    Mistake{"AnotherType", "upload-pixels", Warning, "textures[0].upload.type",
            "the memory has GL_UNSIGNED_BYTE, but glTexImage is told GL_FLOAT",
            [](Subject& s) { custom(s).type = TransferType::Float; }},
    Mistake{"AnotherTypeUnlessItHasTheSameBytes", "upload-pixels", Warning, "textures[0].upload.type",
            "GL_UNSIGNED_INT_8_8_8_8",
            [](Subject& s) { custom(s, PixelFormat::Rgba8).type = TransferType::UnsignedInt8888; },
            [](Subject& s) {
                s.texture().upload.type = std::endian::native == std::endian::little
                                              ? TransferType::UnsignedInt8888Rev
                                              : TransferType::UnsignedByte;
            }},
    Mistake{"SwappedBytes", "upload-pixels", Warning, "textures[0].upload.swapBytes",
            "in this processor's order",
            [](Subject& s) {
                holdFloats(s);
                s.texture().upload.swapBytes = true;
            }},
    Mistake{"DepthsOfColours", "upload-pixels", Warning, "textures[0].upload.format",
            "GL_DEPTH_COMPONENT has another number of components",
            [](Subject& s) {
                custom(s).format = TransferFormat::DepthComponent;
                s.texture().internalFormat = InternalFormat::DepthComponent16;
            }},
    Mistake{"ReadsBeyondTheEnd", "upload-end", Warning, "textures[0].upload.skipRows",
            "the call reads 225 bytes, the memory has 180", [](Subject& s) { custom(s).skipRows = 1; }},
    Mistake{"ReadsMoreComponentsThanThereAre", "upload-end", Warning, "textures[0].upload.format",
            "the call reads 240 bytes, the memory has 180",
            [](Subject& s) { custom(s).format = TransferFormat::Rgba; }},
    Mistake{"AlignmentThatIsNone", "upload-alignment", Warning, "textures[0].upload.alignment",
            "3 is GL_INVALID_VALUE, and 4 stays", [](Subject& s) { custom(s).alignment = 3; }},
    Mistake{"AlignmentOfMemoryThatIsNone", "upload-alignment", Warning, "textures[0].upload.memoryAlignment",
            "not of 7: 4 is used",
            [](Subject& s) {
                holdFloats(s);
                s.texture().upload.memoryAlignment = 7;
            }},
    Mistake{"RefusedType", "upload-refused", Error, "textures[0].upload.type",
            "GL_INVALID_OPERATION: GL_UNSIGNED_SHORT_5_6_5 takes GL_RGB, not GL_BGR",
            [](Subject& s) {
                custom(s).format = TransferFormat::Bgr;
                s.texture().upload.type = TransferType::UnsignedShort565;
            }},
    Mistake{"RefusedFormat", "upload-refused", Error, "textures[0].upload.format",
            "GL_DEPTH_COMPONENT is for depth textures",
            [](Subject& s) { custom(s).format = TransferFormat::DepthComponent; }},
    Mistake{"ImpossibleMemory", "upload-refused", Error, "textures[0].upload.memoryType",
            "does not hold the components of GL_RGB",
            [](Subject& s) {
                holdFloats(s);
                s.texture().upload.memoryType = TransferType::UnsignedShort4444;
            }},
    Mistake{"SignedNumbers", "upload-signed", Note, "textures[0].upload.type",
            "OpenGL 2.1 makes (2c + 1) / 255", [](Subject& s) { custom(s).type = TransferType::Byte; },
            [](Subject& s) { s.texture().upload.type = TransferType::UnsignedByte; }},
    Mistake{"ScaledBeyondOne", "upload-limited", Note, "textures[0].upload.scale",
            "may become larger than 1, and GL_RGBA stores them as 1",
            [](Subject& s) { custom(s).scale = glm::vec4(1, 1.5F, 1, 1); },
            [](Subject& s) { s.texture().internalFormat = InternalFormat::Rgba16F; }},
    Mistake{"BiasedBelowZero", "upload-limited", Note, "textures[0].upload.bias",
            "may become less than 0, and GL_RGBA stores them as 0",
            [](Subject& s) { custom(s).bias = glm::vec4(0, 0, -0.25F, 0); },
            [](Subject& s) { s.texture().upload.scale.b = 0.5F, s.texture().upload.bias.b = 0.25F; }},
    Mistake{"UploadOfBlocks", "texture-setting", Hint, "textures[0].upload", "glCompressedTexImage",
            [](Subject& s) {
                custom(s);
                s.texture().compression = Compression::Cached;
            },
            [](Subject& s) { s.texture().compression = Compression::Driver; }},
    Mistake{"UploadOfTheLightsView", "texture-setting", Hint, "textures[0].upload", "the light sees",
            [](Subject& s) { s.texture().source = SourceKind::LightDepth; },
            [](Subject& s) { s.texture().source = SourceKind::Pattern; }},
    Mistake{"FormatOfNoCustomUpload", "other-texture-choice", Unused, "textures[0].upload.format",
            "the custom upload is off", [](Subject&) {}, [](Subject& s) { custom(s); }},
    Mistake{"MemoryOfAFile", "other-texture-choice", Unused, "textures[0].upload.memoryType",
            "As in the file", [](Subject& s) { custom(s); }, holdFloats}};

} // namespace

std::span<const Mistake> uploadMistakes() {
    return uploadRows;
}

} // namespace texplorer::test

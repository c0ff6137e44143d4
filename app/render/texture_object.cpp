#include "app/render/texture_object.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <limits>
#include <string>

namespace texplorer::render {

namespace {

/// A sized format, so that what is stored has eight bits a component on every driver (table 3.16).
GLint sizedFormat(BaseFormat format) {
    switch (format) {
    case BaseFormat::Alpha:
        return GL_ALPHA8;
    case BaseFormat::Luminance:
        return GL_LUMINANCE8;
    case BaseFormat::LuminanceAlpha:
        return GL_LUMINANCE8_ALPHA8;
    case BaseFormat::Intensity:
        return GL_INTENSITY8;
    case BaseFormat::Rgb:
        return GL_RGB8;
    case BaseFormat::Rgba:
        return GL_RGBA8;
    }
    return GL_RGBA8;
}

GLenum pixelFormat(PixelFormat format) {
    switch (format) {
    case PixelFormat::Alpha8:
        return GL_ALPHA;
    case PixelFormat::Luminance8:
        return GL_LUMINANCE;
    case PixelFormat::LuminanceAlpha8:
        return GL_LUMINANCE_ALPHA;
    case PixelFormat::Rgb8:
        return GL_RGB;
    case PixelFormat::Rgba8:
        return GL_RGBA;
    }
    return GL_RGBA;
}

/// How many times slower the driver compresses than it copies.
constexpr std::size_t driverSlowness = 8;

/// Returns the name of the call, for a message. Without `pixels` the level is made, but has no content yet.
const char* uploadImage(Target target, GLint level, GLint stored, const Image& image,
                        const std::byte* pixels) {
    const GLenum given = pixelFormat(image.format);
    switch (target) {
    case Target::Texture1D:
        glTexImage1D(GL_TEXTURE_1D, level, stored, image.width, 0, given, GL_UNSIGNED_BYTE, pixels);
        return "glTexImage1D";
    case Target::Texture2D:
        glTexImage2D(GL_TEXTURE_2D, level, stored, image.width, image.height, 0, given, GL_UNSIGNED_BYTE,
                     pixels);
        return "glTexImage2D";
    case Target::Texture3D:
        glTexImage3D(GL_TEXTURE_3D, level, stored, image.width, image.height, image.depth, 0, given,
                     GL_UNSIGNED_BYTE, pixels);
        return "glTexImage3D";
    }
    return "";
}

const char* uploadImage(Target target, GLint level, GLint stored, const Image& image) {
    return uploadImage(target, level, stored, image, image.pixels.data());
}

/// Some rows of a picture, or slices of a volume.
const char* uploadRows(Target target, GLint level, const Image& image, int first, int count) {
    const GLenum given = pixelFormat(image.format);
    if (target == Target::Texture3D) {
        glTexSubImage3D(GL_TEXTURE_3D, level, 0, 0, first, image.width, image.height, count, given,
                        GL_UNSIGNED_BYTE, image.pixels.data() + image.offset(0, 0, first));
        return "glTexSubImage3D";
    }
    glTexSubImage2D(GL_TEXTURE_2D, level, 0, first, image.width, count, given, GL_UNSIGNED_BYTE,
                    image.pixels.data() + image.offset(0, first, 0));
    return "glTexSubImage2D";
}

const char* uploadBlocks(GLint level, const BlockImage& image) {
    glCompressedTexImage2D(GL_TEXTURE_2D, level, static_cast<GLenum>(image.format), image.width, image.height,
                           0, static_cast<GLsizei>(image.blocks.size()), image.blocks.data());
    return "glCompressedTexImage2D";
}

GLint enumerant(auto value) {
    return static_cast<GLint>(value);
}

} // namespace

TextureObject::TextureObject(Target target)
    : handle_(TextureHandle::create())
    , target_(static_cast<GLenum>(target)) {}

TextureObject::TextureObject(Target target, BaseFormat format, const TextureLevels& levels,
                             std::string_view where, GlErrors& errors)
    : TextureObject(target) {
    UploadCursor cursor{format, 0, 0};
    static_cast<void>(upload(levels, cursor, std::numeric_limits<std::size_t>::max(), where, errors));
}

bool TextureObject::upload(const TextureLevels& levels, UploadCursor& cursor, std::size_t bytes,
                           std::string_view where, GlErrors& errors) {
    const auto target = static_cast<Target>(target_);
    const GLint stored = levels.driverFormat ? enumerant(*levels.driverFormat) : sizedFormat(cursor.format);
    const std::size_t slowness = levels.driverFormat ? driverSlowness : 1;
    std::size_t left = std::max<std::size_t>(1, bytes / slowness);
    glBindTexture(target_, handle_.name());
    while (left > 0 && cursor.level < levels.levels.size()) {
        const auto& [number, surface] = levels.levels[cursor.level];
        const Image* image = std::get_if<Image>(&surface);
        const int rows = !image                        ? 1
                         : target == Target::Texture3D ? image->depth
                         : target == Target::Texture2D ? image->height
                                                       : 1;
        const std::size_t all = byteCount(surface);
        const char* call = nullptr;
        if (cursor.row == 0 && (all <= left || rows == 1)) {
            call = image ? uploadImage(target, number, stored, *image)
                         : uploadBlocks(number, std::get<BlockImage>(surface));
            left -= std::min(left, all);
            ++cursor.level;
        } else {
            if (cursor.row == 0)
                uploadImage(target, number, stored, *image, nullptr);
            const std::size_t perRow = std::max<std::size_t>(1, all / static_cast<std::size_t>(rows));
            // Four rows at least, and a multiple of four: blocks can't be uploaded in part.
            const int fitting = static_cast<int>(std::min<std::size_t>(left / perRow, 1U << 20)) / 4 * 4;
            const int count = std::min(std::max(4, fitting), rows - cursor.row);
            call = uploadRows(target, number, *image, cursor.row, count);
            left -= std::min(left, perRow * static_cast<std::size_t>(count));
            cursor.row += count;
            if (cursor.row == rows) {
                cursor.row = 0;
                ++cursor.level;
            }
        }
        errors.check(std::string(where) + ": " + call + " level " + std::to_string(number));
    }
    return cursor.level == levels.levels.size();
}

void TextureObject::apply(const Texture& texture, float maxAnisotropy, std::string_view where,
                          GlErrors& errors) {
    if (applied_ == texture)
        return errors.add(applyErrors_.sentences());
    applied_ = texture;
    applyErrors_ = {};
    glBindTexture(target_, handle_.name());
    glTexParameteri(target_, GL_TEXTURE_MAG_FILTER, enumerant(texture.magFilter));
    glTexParameteri(target_, GL_TEXTURE_MIN_FILTER, enumerant(texture.minFilter));
    glTexParameteri(target_, GL_TEXTURE_WRAP_S, enumerant(texture.wrapS));
    glTexParameteri(target_, GL_TEXTURE_WRAP_T, enumerant(texture.wrapT));
    glTexParameteri(target_, GL_TEXTURE_WRAP_R, enumerant(texture.wrapR));
    glTexParameterfv(target_, GL_TEXTURE_BORDER_COLOR, glm::value_ptr(texture.borderColor));
    glTexParameteri(target_, GL_TEXTURE_BASE_LEVEL, texture.baseLevel);
    glTexParameteri(target_, GL_TEXTURE_MAX_LEVEL, texture.maxLevel);
    glTexParameterf(target_, GL_TEXTURE_MIN_LOD, texture.minLod);
    glTexParameterf(target_, GL_TEXTURE_MAX_LOD, texture.maxLod);
    glTexParameterf(target_, GL_TEXTURE_PRIORITY, texture.priority);
    if (maxAnisotropy > 1) // else the driver does not know the parameter
        glTexParameterf(target_, GL_TEXTURE_MAX_ANISOTROPY_EXT,
                        std::clamp(texture.maxAnisotropy, 1.0F, maxAnisotropy));
    applyErrors_.check(std::string(where) + ": glTexParameter");
    errors.add(applyErrors_.sentences());
}

Result<std::vector<TextureLevel>> TextureObject::read() const {
    GLint largest = 0;
    glGetIntegerv(target_ == GL_TEXTURE_3D ? GL_MAX_3D_TEXTURE_SIZE : GL_MAX_TEXTURE_SIZE, &largest);
    const int mostLevels = mipLevelCount(largest, 1); // to ask for a level beyond is an error
    std::vector<TextureLevel> levels;
    glBindTexture(target_, handle_.name());
    const auto ask = [this](GLint level, GLenum what) {
        GLint value = 0;
        glGetTexLevelParameteriv(target_, level, what, &value);
        return value;
    };
    for (GLint level = 0; level < mostLevels; ++level) {
        const int width = ask(level, GL_TEXTURE_WIDTH);
        if (width == 0)
            continue;
        const int height = ask(level, GL_TEXTURE_HEIGHT);
        const int depth = ask(level, GL_TEXTURE_DEPTH);
        if (ask(level, GL_TEXTURE_COMPRESSED) == GL_FALSE) {
            Image image =
                Image::uninitialised(PixelFormat::Rgba8, width, std::max(height, 1), std::max(depth, 1));
            glGetTexImage(target_, level, GL_RGBA, GL_UNSIGNED_BYTE, image.pixels.data());
            levels.push_back({level, std::move(image)});
            continue;
        }
        const auto format = static_cast<std::uint32_t>(ask(level, GL_TEXTURE_INTERNAL_FORMAT));
        const EnumRow* row = findRow(blockFormatRows, format);
        if (!row)
            return fail(ErrorCode::Unsupported, "the driver holds level " + std::to_string(level) +
                                                    " in a compressed format that Texplorer does not know: " +
                                                    std::to_string(format));
        BlockImage image = BlockImage::uninitialised(static_cast<BlockFormat>(format), width, height);
        const auto size = static_cast<std::size_t>(ask(level, GL_TEXTURE_COMPRESSED_IMAGE_SIZE));
        if (size != image.blocks.size())
            return fail(ErrorCode::Driver, "level " + std::to_string(level) + " should have " +
                                               std::to_string(image.blocks.size()) +
                                               " bytes of blocks, the driver says " + std::to_string(size));
        glGetCompressedTexImage(target_, level, image.blocks.data());
        levels.push_back({level, std::move(image)});
    }
    GlErrors errors;
    if (!errors.check("glGetTexImage, glGetCompressedTexImage"))
        return fail(ErrorCode::Driver, errors.sentences().front());
    return levels;
}

} // namespace texplorer::render

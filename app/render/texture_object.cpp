#include "app/render/texture_object.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
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

/// Returns the name of the call, for a message.
const char* uploadLevel(Target target, GLint level, BaseFormat format, const Image& image) {
    const GLint stored = sizedFormat(format);
    const GLenum given = pixelFormat(image.format);
    switch (target) {
    case Target::Texture1D:
        glTexImage1D(GL_TEXTURE_1D, level, stored, image.width, 0, given, GL_UNSIGNED_BYTE,
                     image.pixels.data());
        return "glTexImage1D";
    case Target::Texture2D:
        glTexImage2D(GL_TEXTURE_2D, level, stored, image.width, image.height, 0, given, GL_UNSIGNED_BYTE,
                     image.pixels.data());
        return "glTexImage2D";
    case Target::Texture3D:
        glTexImage3D(GL_TEXTURE_3D, level, stored, image.width, image.height, image.depth, 0, given,
                     GL_UNSIGNED_BYTE, image.pixels.data());
        return "glTexImage3D";
    }
    return "";
}

GLint enumerant(auto value) {
    return static_cast<GLint>(value);
}

} // namespace

TextureObject::TextureObject(Target target, BaseFormat format, const MipChain& chain, std::string_view where,
                             GlErrors& errors)
    : handle_(TextureHandle::create())
    , target_(static_cast<GLenum>(target)) {
    glBindTexture(target_, handle_.name());
    for (std::size_t level = 0; level < chain.size(); ++level) {
        const char* call = uploadLevel(target, static_cast<GLint>(level), format, chain[level]);
        errors.check(std::string(where) + ": " + call + " level " + std::to_string(level));
    }
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

} // namespace texplorer::render

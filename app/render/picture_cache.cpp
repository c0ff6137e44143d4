#include "app/render/picture_cache.h"

#include "app/render/gl_errors.h"
#include "app/render/rgba_pixels.h"

#include <new>

namespace texplorer::render {
namespace {

/// Returns an empty handle if GL refused it. Restores the bound texture.
TextureHandle upload(const Image& image, PictureCache::Use use) {
    const Image pixels = image.format == PixelFormat::Rgba8 ? Image() : asRgba8(image, BaseFormat::Rgba);
    GLint bound = 0;
    glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
    TextureHandle texture = TextureHandle::create();
    glBindTexture(GL_TEXTURE_2D, texture.name());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER,
                    use == PictureCache::Use::Enlarged ? GL_NEAREST : GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, image.width, image.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 (pixels.empty() ? image : pixels).pixels.data());
    glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(bound));
    GlErrors errors; // errors of pictures in panels are not reported
    return errors.check("glTexImage2D") ? std::move(texture) : TextureHandle();
}

} // namespace

view::PictureHandle PictureCache::show(const std::shared_ptr<const Image>& image, Use use) {
    if (!image || image->empty())
        return view::PictureHandle::None;
    try {
        const auto [slot, isNew] = slots_.try_emplace(image);
        slot->second.frame = frame_;
        if (isNew)
            slot->second.texture = upload(*image, use);
        return handleOf(slot->second.texture.name());
    } catch (const std::bad_alloc&) {
        return view::PictureHandle::None;
    }
}

void PictureCache::endFrame() {
    std::erase_if(slots_, [this](const auto& entry) { return entry.second.frame != frame_; });
    ++frame_;
}

} // namespace texplorer::render

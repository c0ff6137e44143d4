#include "app/render/render_target.h"

#include "app/render/gl_errors.h"

#include <array>
#include <string>

namespace texplorer::render {

namespace {

// Some drivers can only draw with depth packed with a stencil. It is attached as depth only; the stencil is
// never used.
constexpr auto depthFormats = std::to_array<GLenum>({GL_DEPTH_COMPONENT24, GL_DEPTH24_STENCIL8});

} // namespace

Result<void> RenderTarget::bind(view::Size size) {
    if (size != size_) {
        *this = RenderTarget(); // free the old one first: both may not fit
        if (Result<void> made = resize(size); !made) {
            *this = RenderTarget();
            return made;
        }
    }
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    return {};
}

Result<void> RenderTarget::resize(view::Size size) {
    GlErrors errors;
    color_ = TextureHandle::create();
    glBindTexture(GL_TEXTURE_2D, color_.name());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);  // there are no mipmaps
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST); // a view may enlarge its pixels
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, size.width, size.height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glBindTexture(GL_TEXTURE_2D, 0);

    depth_ = RenderbufferHandle::create();
    framebuffer_ = FramebufferHandle::create();
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color_.name(), 0);

    GLenum status = GL_FRAMEBUFFER_UNSUPPORTED;
    for (const GLenum format : depthFormats) {
        if (status == GL_FRAMEBUFFER_COMPLETE)
            break;
        glBindRenderbuffer(GL_RENDERBUFFER, depth_.name());
        glRenderbufferStorage(GL_RENDERBUFFER, format, size.width, size.height);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.name());
        status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    }
    const Sentence what(N_("a picture of {0} pixels with 24 bits of depth"), ProperName{asText(size)});
    if (!errors.check("glTexImage2D, glRenderbufferStorage"))
        return fail(ErrorCode::Driver,
                    Sentence("the driver can't create {0}: {1}", what, errors.sentences().front()));
    if (status != GL_FRAMEBUFFER_COMPLETE)
        return fail(
            ErrorCode::Driver,
            Sentence("the driver can't draw into {0}: glCheckFramebufferStatus says {1}", what, status));
    size_ = size;
    return {};
}

} // namespace texplorer::render

#include "app/render/gl_handle.h"
#include "tests/support/render_fixture.h"

#include <gtest/gtest.h>

namespace texplorer::render::gl_handle_test {
namespace {

class Handles : public test::RenderTest {};

template<class Handle>
void checkLifetime(GLboolean (*exists)(GLuint), void (*bind)(GLuint)) {
    { const Handle empty; } // does nothing
    GLuint name = 0;
    {
        Handle first = Handle::create();
        name = first.name();
        bind(name); // only then the object exists
        ASSERT_TRUE(exists(name));
        Handle second = std::move(first);
        EXPECT_EQ(second.name(), name);
        Handle third;
        EXPECT_FALSE(third);
        third = std::move(second);
        EXPECT_EQ(third.name(), name);
        EXPECT_TRUE(exists(name));
        bind(0);
    }
    EXPECT_FALSE(exists(name));

    Handle kept = Handle::create();
    name = kept.name();
    bind(name);
    bind(0);
    kept = Handle(); // what a handle held is deleted when it gets something else
    EXPECT_FALSE(exists(name));
    EXPECT_EQ(glGetError(), unsigned{GL_NO_ERROR});
}

TEST_F(Handles, OfTextures) {
    checkLifetime<TextureHandle>([](GLuint name) { return glIsTexture(name); },
                                 [](GLuint name) { glBindTexture(GL_TEXTURE_2D, name); });
}
TEST_F(Handles, OfBuffers) {
    checkLifetime<BufferHandle>([](GLuint name) { return glIsBuffer(name); },
                                [](GLuint name) { glBindBuffer(GL_ARRAY_BUFFER, name); });
}
TEST_F(Handles, OfFramebuffers) {
    checkLifetime<FramebufferHandle>([](GLuint name) { return glIsFramebuffer(name); },
                                     [](GLuint name) { glBindFramebuffer(GL_FRAMEBUFFER, name); });
}
TEST_F(Handles, OfRenderbuffers) {
    checkLifetime<RenderbufferHandle>([](GLuint name) { return glIsRenderbuffer(name); },
                                      [](GLuint name) { glBindRenderbuffer(GL_RENDERBUFFER, name); });
}

} // namespace
} // namespace texplorer::render::gl_handle_test

// The off-screen context by itself: what it promises, and which sizes are refused.

#include "app/offscreen/context.h"
#include "app/render/capabilities.h"

#include <GL/glew.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

namespace texplorer::offscreen_test {
namespace {

using testing::HasSubstr;

TEST(OffscreenContext, GivesEverythingThatTexplorerNeeds) {
    const auto context = offscreen::Context::create({16, 8});
    ASSERT_TRUE(context) << describe(context.error());
    const auto capabilities = render::loadCapabilities();
    ASSERT_TRUE(capabilities) << describe(capabilities.error());
    EXPECT_THAT(capabilities->renderer, HasSubstr("llvmpipe"));
    EXPECT_GE(capabilities->maxTextureSize, 2048);
    EXPECT_GE(capabilities->max3DTextureSize, 256);
    EXPECT_GE(capabilities->textureUnits, 4);
    EXPECT_GE(capabilities->maxAnisotropy, 2);
    EXPECT_TRUE(capabilities->s3tc);
}

TEST(OffscreenContext, WithoutAContextCapabilitiesSayWhatIsNeeded) {
    { const auto context = offscreen::Context::create({4, 4}); }
    const auto capabilities = render::loadCapabilities();
    ASSERT_FALSE(capabilities);
    EXPECT_EQ(capabilities.error().code, ErrorCode::Driver);
    EXPECT_THAT(capabilities.error().message, HasSubstr("OpenGL 2.1"));
}

TEST(OffscreenContext, CanBeMovedAndMadeAgain) {
    auto first = offscreen::Context::create({4, 4});
    ASSERT_TRUE(first);
    offscreen::Context moved = std::move(*first);
    EXPECT_TRUE(render::loadCapabilities());
    auto second = offscreen::Context::create({4, 4});
    ASSERT_TRUE(second);
    moved = std::move(*second); // destroys the first while the second is current
    EXPECT_TRUE(render::loadCapabilities());
}

TEST(OffscreenContext, HasAFramebufferOfItsSizeWithTheBottomRowFirst) {
    const auto context = offscreen::Context::create({16, 8});
    ASSERT_TRUE(context) << describe(context.error());
    ASSERT_TRUE(render::loadCapabilities());
    std::array<GLint, 4> viewport{};
    glGetIntegerv(GL_VIEWPORT, viewport.data());
    EXPECT_THAT(viewport, testing::ElementsAre(0, 0, 16, 8));
    std::array<GLint, 2> bits{};
    glGetIntegerv(GL_DEPTH_BITS, bits.data());
    glGetIntegerv(GL_ALPHA_BITS, &bits[1]);
    EXPECT_GE(bits[0], 24);
    EXPECT_EQ(bits[1], 8);

    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT);
    glEnable(GL_SCISSOR_TEST);
    glScissor(15, 0, 1, 1); // the right end of the bottom row
    glClearColor(1, 0.6F, 0.2F, 0.4F);
    glClear(GL_COLOR_BUFFER_BIT);
    std::array<std::array<std::array<GLubyte, 4>, 16>, 8> rows{};
    glReadPixels(0, 0, 16, 8, GL_RGBA, GL_UNSIGNED_BYTE, rows.data());
    EXPECT_THAT(rows[0][15], testing::ElementsAre(255, 153, 51, 102));
    rows[0][15] = {};
    EXPECT_THAT(rows, testing::Each(testing::Each(testing::Each(0))));
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST(OffscreenContext, IsOneOfThoseThatThereAreByItsName) {
    const std::vector<view::ContextChoice> all = offscreen::Context::all();
    ASSERT_FALSE(all.empty());
    for (const view::ContextChoice& each : all)
        EXPECT_EQ(view::ContextChoice::parse(each.text(), "--context").value(), each);
    const auto first = offscreen::Context::create({4, 4}, all.front());
    EXPECT_TRUE(first) << describe(first.error());
}

TEST(OffscreenContext, OfAnotherLibraryIsRefused) {
    using Kind = view::ContextChoice::Kind;
    const bool osmesa = offscreen::Context::all().front().kind == Kind::Osmesa;
    const auto other = offscreen::Context::create({4, 4}, {osmesa ? Kind::Egl : Kind::Osmesa, 0});
    ASSERT_FALSE(other);
    EXPECT_EQ(other.error().code, ErrorCode::Unsupported);
    EXPECT_EQ(other.error().message, osmesa ? "OSMesa has no context egl" : "EGL has no context osmesa");
}

TEST(ContextChoice, IsReadAsItIsWritten) {
    for (const char* text : {"auto", "osmesa", "egl", "egl:surfaceless", "egl:0", "egl:12"})
        EXPECT_EQ(view::ContextChoice::parse(text, "--context").value().text(), text);
    EXPECT_EQ(view::ContextChoice().text(), "auto");
    for (const char* text :
         {"", "Egl", "egl:", "egl:-1", "egl:+1", "egl: 1", "egl:1 ", "egl:99999999999", "glx"}) {
        const auto refused = view::ContextChoice::parse(text, "here");
        ASSERT_FALSE(refused) << text;
        EXPECT_EQ(refused.error().where, "here");
        EXPECT_THAT(refused.error().message, testing::EndsWith("found \"" + std::string(text) + "\""));
    }
}

struct SizeCase {
    const char* name;
    view::Size size;
};

class RefusedSize : public testing::TestWithParam<SizeCase> {};

TEST_P(RefusedSize, IsNamedWithTheLimit) {
    const auto [width, height] = GetParam().size;
    const auto context = offscreen::Context::create({width, height});
    ASSERT_FALSE(context);
    EXPECT_EQ(context.error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(context.error().message, "an off-screen framebuffer has 1 × 1 to 16384 × 16384 pixels, not " +
                                           std::to_string(width) + " × " + std::to_string(height));
}

INSTANTIATE_TEST_SUITE_P(All, RefusedSize,
                         testing::Values(SizeCase{"NoWidth", {0, 4}}, SizeCase{"NoHeight", {4, 0}},
                                         SizeCase{"Negative", {-1, 4}}, SizeCase{"Huge", {100000, 100000}},
                                         SizeCase{"OneTooMany", {4, 16385}}),
                         [](const auto& test) { return std::string(test.param.name); });

} // namespace
} // namespace texplorer::offscreen_test

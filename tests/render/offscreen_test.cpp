// The off-screen context by itself: what OSMesa promises, and which sizes are refused.

#include "app/offscreen/context.h"
#include "app/render/capabilities.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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
    EXPECT_EQ(context.error().message, "an off-screen framebuffer has 1 x 1 to 16384 x 16384 pixels, not " +
                                           std::to_string(width) + " x " + std::to_string(height));
}

INSTANTIATE_TEST_SUITE_P(All, RefusedSize,
                         testing::Values(SizeCase{"NoWidth", {0, 4}}, SizeCase{"NoHeight", {4, 0}},
                                         SizeCase{"Negative", {-1, 4}}, SizeCase{"Huge", {100000, 100000}},
                                         SizeCase{"OneTooMany", {4, 16385}}),
                         [](const auto& test) { return std::string(test.param.name); });

} // namespace
} // namespace texplorer::offscreen_test

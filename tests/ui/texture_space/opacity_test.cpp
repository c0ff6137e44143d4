#include "app/ui/texture_space/opacity.h"

#include <gtest/gtest.h>

#include <memory>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace texplorer::ui::opacity_test {
namespace {

struct Case {
    const char* name;
    PixelFormat format;
    std::vector<int> pixels; ///< of two
    bool opaque;
    void (*edit)(Texture&) = [](Texture&) {};

    friend std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.name; }
};

std::shared_ptr<const TextureImage> imageOf(const Case& c) {
    Image image{c.format, 2, 1, 1, {}};
    for (const int each : c.pixels)
        image.pixels.push_back(static_cast<std::byte>(each));
    TextureImage made;
    made.surfaces.emplace_back(std::move(image));
    return std::make_shared<const TextureImage>(std::move(made));
}

class OpacityTest : public testing::TestWithParam<Case> {};

TEST_P(OpacityTest, IsKnownFromTexelsAndSettings) {
    Texture texture;
    GetParam().edit(texture);
    EXPECT_EQ(Opacity().isOpaque(texture, imageOf(GetParam())), GetParam().opaque);
}

const std::vector rgba{1, 2, 3, 255, 5, 6, 7, 255};

INSTANTIATE_TEST_SUITE_P(
    All, OpacityTest,
    testing::Values(Case{"Rgb", PixelFormat::Rgb8, {1, 2, 3, 4, 5, 6}, true},
                    Case{"Rgba", PixelFormat::Rgba8, rgba, true},
                    Case{
                        "TheLastTexelIsSeenThrough", PixelFormat::Rgba8, {1, 2, 3, 255, 5, 6, 7, 254}, false},
                    Case{"TheFirstTexelIsSeenThrough", PixelFormat::Rgba8, {1, 2, 3, 0, 5, 6, 7, 255}, false},
                    Case{"Luminance", PixelFormat::Luminance8, {0, 0}, true},
                    Case{"LuminanceAlpha", PixelFormat::LuminanceAlpha8, {0, 255, 0, 255}, true},
                    Case{"LuminanceHalfAlpha", PixelFormat::LuminanceAlpha8, {255, 255, 255, 128}, false},
                    Case{"Alpha", PixelFormat::Alpha8, {255, 255}, false},
                    Case{"AlphaOfTheColours", PixelFormat::Rgba8, rgba, false,
                         [](Texture& texture) { texture.transparency = Transparency::Blend1; }},
                    Case{"AlphaOfAColour", PixelFormat::Rgba8, rgba, false,
                         [](Texture& texture) { texture.transparency = Transparency::Stencil; }},
                    Case{"Prepared", PixelFormat::Rgba8, rgba, false,
                         [](Texture& texture) { texture.preparation.emplace_back(); }},
                    // OpenGL 2.1, table 3.15: INTENSITY's alpha is its red.
                    Case{"Intensity", PixelFormat::Rgba8, rgba, false,
                         [](Texture& texture) { texture.internalFormat = InternalFormat::Intensity; }}),
    [](const auto& each) { return std::string(each.param.name); });

TEST(Opacity, AnotherImageIsLookedAtAnew) {
    Opacity opacity;
    const Case seenThrough{"", PixelFormat::Rgba8, {1, 2, 3, 0, 5, 6, 7, 255}, false};
    EXPECT_TRUE(opacity.isOpaque({}, imageOf({"", PixelFormat::Rgba8, rgba, true})));
    EXPECT_FALSE(opacity.isOpaque({}, imageOf(seenThrough)));
    EXPECT_FALSE(opacity.isOpaque({}, nullptr));
}

} // namespace
} // namespace texplorer::ui::opacity_test

// The level that the reference finds for each pixel against the one that OpenGL reads there: its coloured
// levels say which it was.

#include "tests/support/floor_scene.h"
#include "tests/support/render_fixture.h"
#include "texplorer/image/mip_colors.h"
#include "texplorer/reference/level_map.h"

#include <cmath>
#include <optional>

namespace texplorer::level_map_test {
namespace {

using namespace test;

/// The level whose colour a pixel has.
std::optional<int> levelOf(ByteView pixel) {
    for (int level = 0; level < 8; ++level) {
        const auto color = mipColor(level);
        bool isIt = true;
        for (std::size_t i = 0; i < 3; ++i)
            isIt = isIt && std::abs(std::to_integer<int>(pixel[i]) - int{color[i]}) <= 1;
        if (isIt)
            return level;
    }
    return std::nullopt;
}

class LevelMapAndOpenGl : public RenderTest, public testing::WithParamInterface<Shape> {};

TEST_P(LevelMapAndOpenGl, ReadTheSameLevels) {
    Scene scene = floorScene();
    scene.models[0].shape = GetParam();
    Texture& texture = scene.textures[0];
    texture.pattern = Pattern::MipColors;
    texture.mipmaps = MipPolicy::Colored;
    texture.minFilter = MinFilter::NearestMipmapNearest;
    texture.magFilter = MagFilter::Nearest;
    scene.passes[0].units[0].envMode = EnvMode::Replace;
    constexpr int extent = 128;
    const Image drawn = picture(scene, extent);
    const Result<reference::LevelMap> map = reference::levelMap({scene, images, 0, extent, extent}, {});
    ASSERT_TRUE(map) << describe(map.error());
    int same = 0;
    int atBorders = 0;
    for (int y = 0; y < extent; ++y) {
        for (int x = 0; x < extent; ++x) {
            const reference::PixelLevels* pixel = map->at(x, y);
            if (!pixel)
                continue;
            const std::optional<int> level = levelOf(drawn.at(x, y));
            if (!level) // the edge of the model: the picture has the background there
                continue;
            if (level == pixel->first) {
                ++same;
                continue;
            }
            ++atBorders;
            // Half-way between two levels a driver's λ may fall on the other side: by what its precision
            // leaves, and where it takes the same derivatives for 2 x 2 pixels of a curved surface.
            EXPECT_NEAR(std::abs(pixel->lambda - std::floor(pixel->lambda) - 0.5F), 0, 0.2F)
                << x << ", " << y;
            EXPECT_EQ(std::abs(*level - pixel->first), 1) << x << ", " << y;
        }
    }
    EXPECT_GT(same, 1500);
    EXPECT_LT(atBorders, same / 25);
}

INSTANTIATE_TEST_SUITE_P(All, LevelMapAndOpenGl,
                         testing::Values(Shape::Floor, Shape::Quad, Shape::Sphere, Shape::Cube),
                         [](const auto& test) { return std::string(rowOf(test.param).name); });

} // namespace
} // namespace texplorer::level_map_test

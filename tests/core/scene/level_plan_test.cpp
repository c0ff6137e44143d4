// The plan says what prepareLevels then does, for every policy, target and kind of file.

#include "core/s3tc/encode.h"
#include "core/scene/level_plan.h"
#include "core/scene/texture_levels.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace texplorer {
namespace {

TextureImage imageOf(int width, int height, int depth, int levels, bool blocks) {
    TextureImage texture;
    texture.levels = levels;
    texture.topFirst = true;
    for (int level = 0; level < levels; ++level) {
        const auto extent = [&](int base) { return std::max(1, base >> level); };
        Image image = Image::uninitialised(PixelFormat::Rgba8, extent(width), extent(height), extent(depth));
        std::ranges::fill(image.pixels, std::byte{128});
        if (blocks)
            texture.surfaces.emplace_back(*encodeBlocks(image, BlockFormat::Dxt1, EncodeQuality::Fast));
        else
            texture.surfaces.emplace_back(std::move(image));
    }
    return texture;
}

TEST(LevelPlan, AgreesWithTheLevelsThatAreMade) {
    int compared = 0;
    for (const TextureImage& image :
         {imageOf(8, 4, 1, 1, false), imageOf(7, 5, 1, 3, false), imageOf(6, 3, 4, 2, false),
          imageOf(1, 1, 1, 1, false), imageOf(16, 8, 1, 3, true), imageOf(12, 6, 1, 1, true)}) {
        for (const EnumRow& mipmaps : mipPolicyRows)
            for (const EnumRow& npot : npotPolicyRows)
                for (const EnumRow& compression : compressionRows)
                    for (const EnumRow& flip : flipModeRows)
                        for (const EnumRow& target : targetRows) {
                            Texture texture;
                            texture.mipmaps = static_cast<MipPolicy>(mipmaps.value);
                            texture.npot = static_cast<NpotPolicy>(npot.value);
                            texture.compression = static_cast<Compression>(compression.value);
                            texture.flip = static_cast<FlipMode>(flip.value);
                            const auto aim = static_cast<Target>(target.value);
                            const LevelPlan plan = planLevels(texture, image, aim);
                            const Result<TextureLevels> made = prepareLevels(texture, image, aim);
                            ASSERT_TRUE(made) << describe(made.error());
                            std::vector<PlannedLevel> levels;
                            std::optional<BlockFormat> blocks = made->driverFormat;
                            for (const TextureLevel& each : made->levels) {
                                const Surface& surface = each.surface;
                                levels.push_back(
                                    {each.number, widthOf(surface), heightOf(surface), depthOf(surface)});
                                if (const auto* kept = std::get_if<BlockImage>(&surface))
                                    blocks = kept->format;
                            }
                            EXPECT_EQ(plan.levels, levels)
                                << mipmaps.name << " " << npot.name << " " << target.name;
                            EXPECT_EQ(plan.blocks, blocks) << mipmaps.name << " " << flip.name;
                            EXPECT_EQ(plan.lastLevel, made->lastLevel);
                            ++compared;
                        }
    }
    EXPECT_EQ(compared, 6 * 5 * 2 * 4 * 5 * 3);
}

TEST(LevelPlan, OfNothingIsEmpty) {
    EXPECT_TRUE(planLevels({}, {}, Target::Texture2D).levels.empty());
}

} // namespace
} // namespace texplorer

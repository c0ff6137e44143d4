// The plan says what prepareLevels then does, for every policy, target and kind of file.

#include "texplorer/s3tc/encode.h"
#include "texplorer/texture/level_plan.h"
#include "texplorer/texture/texture_levels.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace texplorer::level_plan_test {
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

void expectAgreement(const Texture& texture, const TexturePictures& pictures, Target target) {
    const LevelPlan plan = planLevels(texture, pictures, target);
    const Result<TextureLevels> made = prepareLevels(texture, pictures, target);
    ASSERT_TRUE(made) << describe(made.error());
    std::vector<PlannedLevel> levels;
    std::optional<BlockFormat> blocks = made->driverFormat;
    for (const TextureLevel& each : made->levels) {
        if (each.face != 0)
            continue; // the others are like it
        const Surface& surface = each.surface;
        const int axes = axesOf(target);
        const int both = 2 * made->border;
        levels.push_back({each.number, widthOf(surface) - both, heightOf(surface) - (axes > 1 ? both : 0),
                          depthOf(surface) - (axes > 2 ? both : 0)});
        if (const auto* kept = std::get_if<BlockImage>(&surface))
            blocks = kept->format;
    }
    EXPECT_EQ(plan.levels, levels) << rowOf(texture.mipmaps).name << " " << rowOf(texture.npot).name << " "
                                   << rowOf(target).name << " " << texture.border;
    EXPECT_EQ(plan.blocks, blocks) << rowOf(texture.mipmaps).name << " " << rowOf(texture.flip).name;
    EXPECT_EQ(plan.lastLevel, made->lastLevel);
    EXPECT_EQ(plan.border, made->border);
}

TEST(LevelPlan, AgreesWithTheLevelsThatAreMade) {
    int compared = 0;
    std::vector<std::pair<Target, int>> targets; // with and without a border
    for (const EnumRow& row : targetRows) {
        for (const int border : {0, 1})
            targets.emplace_back(static_cast<Target>(row.value), border);
    }
    const std::vector<std::vector<ImageStep>> preparations{
        {}, {{.op = ImageOp::Resize, .share = 0.7F}, {.op = ImageOp::Resize, .share = 1, .height = 5}}};
    for (const TextureImage& image :
         {imageOf(8, 4, 1, 1, false), imageOf(7, 5, 1, 3, false), imageOf(6, 3, 4, 2, false),
          imageOf(1, 1, 1, 1, false), imageOf(16, 8, 1, 3, true), imageOf(12, 6, 1, 1, true),
          imageOf(10, 6, 1, 1, false), imageOf(6, 6, 3, 1, false), imageOf(24, 18, 1, 4, false),
          imageOf(4, 24, 1, 1, true)}) {
        TexturePictures shared(std::make_shared<const TextureImage>(image));
        shared.limits = {5, 3, 4};
        for (const std::vector<ImageStep>& steps : preparations)
            for (const EnumRow& mipmaps : mipPolicyRows)
                for (const EnumRow& npot : npotPolicyRows)
                    for (const EnumRow& compression : compressionRows)
                        for (const EnumRow& flip : flipModeRows)
                            for (const auto& [target, border] : targets) {
                                Texture texture;
                                texture.preparation = steps;
                                texture.border = border;
                                texture.mipmaps = static_cast<MipPolicy>(mipmaps.value);
                                texture.npot = static_cast<NpotPolicy>(npot.value);
                                texture.compression = static_cast<Compression>(compression.value);
                                texture.flip = static_cast<FlipMode>(flip.value);
                                for (const EnumRow& oversize : oversizeRows) {
                                    texture.oversize = static_cast<Oversize>(oversize.value);
                                    expectAgreement(texture, shared, target);
                                    ++compared;
                                }
                            }
    }
    EXPECT_EQ(compared, 10 * 2 * 9 * 2 * 4 * 5 * 4 * 2 * 2);
}

TEST(LevelPlan, OfAFileThatIsResizedIsComplete) {
    const TexturePictures shared(std::make_shared<const TextureImage>(imageOf(64, 32, 1, 7, false)));
    Texture texture;
    texture.mipmaps = MipPolicy::FromFile;
    texture.preparation = {{.op = ImageOp::Resize, .share = 0.3F}}; // 19.2 × 9.6
    const LevelPlan plan = planLevels(texture, shared, Target::Texture2D);
    ASSERT_EQ(plan.levels.size(), 5U);
    for (const PlannedLevel& each : plan.levels)
        EXPECT_EQ(each, levelAbove({0, 19, 9, 1}, each.number));
    texture.preparation = {{.op = ImageOp::Resize, .share = 0.5F, .width = 20}};
    EXPECT_EQ(planLevels(texture, shared, Target::Texture2D).levels[2], (PlannedLevel{2, 5, 4, 1}));
}

TEST(LevelPlan, OfNothingIsEmpty) {
    EXPECT_TRUE(planLevels({}, {}, Target::Texture2D).levels.empty());
}

} // namespace
} // namespace texplorer::level_plan_test

#include "texplorer/s3tc/encode.h"
#include "texplorer/s3tc/surface_pixels.h"
#include "texplorer/s3tc/texture_flip.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>

namespace texplorer::texture_flip_test {
namespace {

using testing::StartsWith;

/// Red grows to the right and green upwards.
Image ramp(int width, int height, int depth = 1) {
    Image image = Image::uninitialised(PixelFormat::Rgb8, width, height, depth);
    for (int z = 0; z < depth; ++z)
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                image.at(x, y, z)[0] = static_cast<std::byte>(255 * x / width);
                image.at(x, y, z)[1] = static_cast<std::byte>(255 * y / height);
                image.at(x, y, z)[2] = static_cast<std::byte>(z);
            }
    return image;
}

TextureImage rampOf(std::initializer_list<int> extents, int faces, bool compressed) {
    TextureImage texture;
    texture.faces = faces;
    texture.levels = static_cast<int>(extents.size());
    for (int face = 0; face < faces; ++face)
        for (const int extent : extents) {
            if (compressed)
                texture.surfaces.emplace_back(
                    encodeBlocks(ramp(extent, extent), BlockFormat::Dxt1, EncodeQuality::Fast).value());
            else
                texture.surfaces.emplace_back(ramp(extent, extent));
        }
    return texture;
}

/// Where the texel at `at` comes from.
int source(int at, int extent, bool turned) {
    return turned ? extent - 1 - at : at;
}

/// The largest difference of a component from the original turned around.
int farthest(const Surface& turned, const Surface& original, FlipAxis axis) {
    const Image now = toImage(turned);
    const Image then = toImage(original);
    int worst = 0;
    for (int z = 0; z < then.depth; ++z)
        for (int y = 0; y < then.height; ++y)
            for (int x = 0; x < then.width; ++x) {
                const auto found = now.at(x, y, z);
                const auto expected = then.at(source(x, then.width, axis != FlipAxis::Vertical),
                                              source(y, then.height, axis != FlipAxis::Horizontal), z);
                for (std::size_t i = 0; i < found.size(); ++i)
                    worst = std::max(
                        worst, std::abs(std::to_integer<int>(found[i]) - std::to_integer<int>(expected[i])));
            }
    return worst;
}

constexpr FlipAxis axes[]{FlipAxis::Vertical, FlipAxis::Horizontal, FlipAxis::Both};

TEST(TextureFlip, TurnsEveryLevelAndFaceAndLosesNothing) {
    for (const bool compressed : {false, true}) {
        for (const FlipAxis axis : axes) {
            const TextureImage original = rampOf({16, 8, 4, 2, 1}, 6, compressed);
            TextureImage texture = original;
            const Result<void> turned = flip(texture, {.axis = axis});
            ASSERT_TRUE(turned) << turned.error().message;
            for (std::size_t i = 0; i < texture.surfaces.size(); ++i) {
                EXPECT_EQ(farthest(texture.surfaces[i], original.surfaces[i], axis), 0) << i;
                EXPECT_EQ(texture.surfaces[i].index(), compressed ? 1U : 0U) << "blocks stay blocks";
            }
            EXPECT_NE(texture.surfaces, original.surfaces);
            ASSERT_TRUE(flip(texture, {.axis = axis}));
            EXPECT_EQ(texture.surfaces, original.surfaces) << "twice is not at all";
        }
    }
}

TEST(TextureFlip, TurnsEverySliceOfAVolume) {
    for (const FlipAxis axis : axes) {
        TextureImage volume;
        volume.surfaces.emplace_back(ramp(3, 5, 4));
        const Surface original = volume.surfaces.front();
        ASSERT_TRUE(flip(volume, {.axis = axis}));
        EXPECT_EQ(farthest(volume.surfaces.front(), original, axis), 0);
    }
}

TEST(TextureFlip, LeavesAllAsItWasWhereOneLevelWouldLose) {
    for (const FlipAxis axis : axes) {
        const TextureImage original = rampOf({12, 6, 3, 1}, 1, true);
        TextureImage texture = original;
        const Result<void> turned = flip(texture, {.axis = axis});
        ASSERT_FALSE(turned);
        EXPECT_EQ(turned.error().code, ErrorCode::Unsupported);
        EXPECT_THAT(turned.error().message, StartsWith("level 1: "));
        EXPECT_EQ(texture.surfaces, original.surfaces);
    }
}

TEST(TextureFlip, CompressesAgainOnlyWhatWouldLose) {
    for (const FlipAxis axis : axes) {
        const TextureImage original = rampOf({12, 6, 3, 1}, 1, true);
        TextureImage texture = original;
        const Result<void> turned = flip(texture, {.axis = axis, .lossy = true});
        ASSERT_TRUE(turned) << turned.error().message;
        for (const std::size_t lossless : {0U, 2U, 3U})
            EXPECT_EQ(farthest(texture.surfaces[lossless], original.surfaces[lossless], axis), 0) << lossless;
        EXPECT_LE(farthest(texture.surfaces[1], original.surfaces[1], axis), 100)
            << "212 where it isn't turned";
    }
}

TEST(TextureFlip, TakesBackWhatItCompressedAgain) {
    TextureImage texture = rampOf({12, 6}, 2, true);
    std::get<BlockImage>(texture.surfaces[3]).blocks.pop_back();
    const TextureImage original = texture;
    const Result<void> turned = flip(texture, {.lossy = true});
    ASSERT_FALSE(turned);
    EXPECT_EQ(turned.error().code, ErrorCode::Malformed);
    EXPECT_EQ(texture.surfaces, original.surfaces);
}

TEST(TextureFlip, StopsWhenItIsAskedTo) {
    std::stop_source stop;
    stop.request_stop();
    TextureImage texture = rampOf({12, 6}, 1, true);
    const TextureImage original = texture;
    const Result<void> turned = flip(texture, {.lossy = true, .stop = stop.get_token()});
    ASSERT_FALSE(turned);
    EXPECT_EQ(turned.error().code, ErrorCode::Cancelled);
    EXPECT_EQ(texture.surfaces, original.surfaces);
}

TEST(TextureFlip, RefusesPixelsThatAreNotThere) {
    TextureImage outline = rampOf({4}, 1, false);
    std::get<Image>(outline.surfaces.front()).pixels.clear();
    const Result<void> turned = flip(outline);
    ASSERT_FALSE(turned);
    EXPECT_EQ(turned.error().code, ErrorCode::Malformed);
    EXPECT_EQ(turned.error().message, "level 0: expected 48 bytes of pixels, found 0");
}

} // namespace
} // namespace texplorer::texture_flip_test

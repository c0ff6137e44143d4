// Checks the sentence of each preset by numbers from the reference's picture.

#include "texplorer/diagnosis/diagnosis.h"
#include "texplorer/preset/preset.h"
#include "texplorer/reference/draw.h"
#include "texplorer/scene/animation.h"
#include "texplorer/scene/model_mesh.h"
#include "texplorer/texture/image_source.h"
#include "texplorer/texture/texture_levels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <optional>
#include <set>

namespace texplorer::preset_pictures_test {
namespace {

constexpr int extent = 96;

using Color = std::array<int, 3>;

Scene with(std::string_view name, Scene scene = defaultScene()) {
    const Result<void> done = applyPreset(*findPreset(name), scene);
    EXPECT_TRUE(done) << name << ": " << describe(done.error());
    return scene;
}

Image drawn(const Scene& scene, double time = 0) {
    const Result<Frame> frame = reference::drawReference({scene, {}, time, extent, extent});
    EXPECT_TRUE(frame) << describe(frame.error());
    return frame ? frame->image : Image::uninitialised(PixelFormat::Rgba8, extent, extent);
}

Color colorAt(const Image& image, int x, int y) {
    const ByteView pixel = image.at(x, y);
    return {std::to_integer<int>(pixel[0]), std::to_integer<int>(pixel[1]), std::to_integer<int>(pixel[2])};
}

/// The share of pixels that satisfy a condition.
double shareOf(const Image& image, const std::function<bool(Color)>& holds) {
    int count = 0;
    for (int y = 0; y < extent; ++y) {
        for (int x = 0; x < extent; ++x)
            count += holds(colorAt(image, x, y));
    }
    return static_cast<double>(count) / (extent * extent);
}

bool isBackground(Color color) {
    return color == Color{28, 33, 41}; // 0.11, 0.13 and 0.16 of 255
}

/// Far from grey.
bool isColorful(Color color) {
    const auto [least, most] = std::minmax({color[0], color[1], color[2]});
    return !isBackground(color) && most - least > 40;
}

double meanOf(const Image& image) {
    double sum = 0;
    for (int y = 0; y < extent; ++y) {
        for (int x = 0; x < extent; ++x) {
            const Color color = colorAt(image, x, y);
            sum += color[0] + color[1] + color[2];
        }
    }
    return sum / (3.0 * extent * extent);
}

/// How much neighbours in a row differ, of the rows from `low` on.
double roughnessOf(const Image& image, int low = 0, int high = extent) {
    double sum = 0;
    for (int y = low; y < high; ++y) {
        for (int x = 0; x + 1 < extent; ++x)
            sum += std::abs(colorAt(image, x, y)[1] - colorAt(image, x + 1, y)[1]);
    }
    return sum / ((high - low) * (extent - 1));
}

/// The share of the pixels that differ by more than 2/255.
double differenceOf(const Image& a, const Image& b) {
    int count = 0;
    for (int y = 0; y < extent; ++y) {
        for (int x = 0; x < extent; ++x) {
            const Color one = colorAt(a, x, y);
            const Color other = colorAt(b, x, y);
            count += std::abs(one[0] - other[0]) > 2 || std::abs(one[1] - other[1]) > 2 ||
                     std::abs(one[2] - other[2]) > 2;
        }
    }
    return static_cast<double>(count) / (extent * extent);
}

TEST(PresetPictures, AlphaTestLetsTheFarSidesBeSeenAndBlendingHidesThem) {
    const Image tested = drawn(with("alpha-test"));
    const Image blended = drawn(with("alpha-blending"));
    const double before = shareOf(drawn(defaultScene()), isBackground);
    EXPECT_GT(shareOf(tested, isBackground), before + 0.03) << "holes";
    EXPECT_GT(shareOf(blended, isBackground), before + 0.03);
    int hidden = 0;
    for (int y = 0; y < extent; ++y) {
        for (int x = 0; x < extent; ++x)
            hidden += isBackground(colorAt(blended, x, y)) && !isBackground(colorAt(tested, x, y));
    }
    EXPECT_GT(hidden, 50) << "far sides that only the alpha test lets through";
}

TEST(PresetPictures, ACutOutHasNothingLeftOfItsSquare) {
    const Image image = drawn(with("cut-out"));
    const auto isAt = [&](int x, int y) { return !isBackground(colorAt(image, x, y)); };
    // The square reaches from 12 to 84: 2 of the 2.62 units that are visible of its plane from a distance of
    // 3.6.
    EXPECT_FALSE(isAt(14, 82) || isAt(82, 82)) << "the sky around the tree";
    EXPECT_TRUE(isAt(48, 60)) << "its crown";
    EXPECT_GT(shareOf(image, isBackground), 0.5);
    EXPECT_LT(shareOf(image, isBackground), 0.95);
}

TEST(PresetPictures, AGlowTakesNothingAway) {
    const Image before = drawn(defaultScene());
    const Image glow = drawn(with("additive-glow"));
    for (int y = 0; y < extent; ++y) {
        for (int x = 0; x < extent; ++x) {
            for (std::size_t i = 0; i < 3; ++i)
                EXPECT_GE(colorAt(glow, x, y)[i], colorAt(before, x, y)[i]) << x << ", " << y;
        }
    }
    EXPECT_GT(meanOf(glow), meanOf(before) + 5);
}

TEST(PresetPictures, AnImageOnAnotherUnitIsOneColour) {
    const auto colorsOf = [](Scene scene) {
        scene.passes[0].lighting = false;
        const Image image = drawn(scene);
        std::set<Color> colors;
        for (int y = 0; y < extent; ++y) {
            for (int x = 0; x < extent; ++x)
                colors.insert(colorAt(image, x, y));
        }
        colors.erase({28, 33, 41}); // the background
        return colors;
    };
    const Scene wrong = with("wrong-unit");
    EXPECT_EQ(wrong.models[0].noTexCoord[1].size(), meshOf(wrong.models[0]).vertices.size());
    EXPECT_EQ(colorsOf(wrong).size(), 1U);
    EXPECT_GT(colorsOf(with("wrong-unit-cure", wrong)).size(), 1U);
    for (const Finding& finding : diagnose(wrong, {})) {
        for (const Fix& fix : finding.severity == Severity::Warning ? finding.fixes : std::vector<Fix>()) {
            Scene fixed = wrong;
            ASSERT_TRUE(apply(fix, fixed)) << fix.label;
            EXPECT_GT(colorsOf(fixed).size(), 1U) << fix.label;
        }
    }
}

TEST(PresetPictures, ATileBleedsUntilItsCoordinatesStayInside) {
    // The tile is blue. Its neighbours are cyan, red, green and magenta.
    const auto foreign = [](const Scene& scene) {
        return shareOf(drawn(scene),
                       [](Color c) { return !isBackground(c) && 5 * std::max(c[0], c[1]) > 4 * c[2]; });
    };
    Scene bleeding = with("atlas-bleeding");
    const double share = foreign(bleeding);
    EXPECT_GT(share, 0.02);
    const Scene cured = with("atlas-bleeding-cure", bleeding);
    EXPECT_EQ(foreign(cured), 0);
    bleeding.textures[0].baseLevel = 6;
    EXPECT_GT(foreign(bleeding), 1.5 * share) << "texels of twice the width";
}

TEST(PresetPictures, ScrollingComesBackAfterAPeriodOfTheBoard) {
    const Image start = drawn(defaultScene());
    const Scene scene = with("scroll");
    EXPECT_EQ(differenceOf(drawn(scene, 0), start), 0);
    EXPECT_GT(differenceOf(drawn(scene, 0.5), start), 0.1) << "an eighth: one square of eight";
    EXPECT_LT(differenceOf(drawn(scene, 1), start), 0.01) << "a quarter: two squares, which is a period";
}

/// The image of a point of the plane under the matrix of unit 0.
glm::vec2 moved(const Scene& scene, glm::vec2 point, double time) {
    const glm::vec4 to =
        textureMatrix(scene.passes[0].units[0].matrix, time, scene.light) * glm::vec4(point, 0, 1);
    return {to.x, to.y};
}

void expectAt(glm::vec2 found, glm::vec2 expected) {
    EXPECT_NEAR(found.x, expected.x, 1e-5);
    EXPECT_NEAR(found.y, expected.y, 1e-5);
}

TEST(PresetPictures, WhatTurnsTurnsAboutItsPivot) {
    const Scene spin = with("spin");
    const Scene centred = with("rotate-centre");
    for (const double time : {0.0, 1.0, 2.0, 7.3}) {
        expectAt(moved(spin, {0, 0}, time), {0, 0});
        expectAt(moved(centred, {0.5F, 0.5F}, time), {0.5F, 0.5F});
    }
    expectAt(moved(spin, {1, 0}, 2), {0, 1}); // 90 degrees
    expectAt(moved(centred, {1, 0.5F}, 2), {0.5F, 1});
    expectAt(moved(centred, {1, 1}, 8), {1, 1});
}

TEST(PresetPictures, APulseSwellsAlongAnAxisThatTurnsAndKeepsItsBounds) {
    const Scene scene = with("pulse");
    expectAt(moved(scene, {1.5F, 0.5F}, 0), {1.2F, 0.5F});   // 0.7 along s
    expectAt(moved(scene, {0.5F, 1.5F}, 0), {0.5F, 1.8F});   // 1.3 along t
    expectAt(moved(scene, {1.5F, 0.5F}, 1.5), {1.8F, 0.5F}); // after 90 degrees the other way round
    expectAt(moved(scene, {0.5F, 1.5F}, 1.5), {0.5F, 1.2F});
    expectAt(moved(scene, {1.5F, 0.5F}, 3), {1.2F, 0.5F});
    expectAt(moved(scene, {0.5F, 0.5F}, 0.77), {0.5F, 0.5F});
}

/// The sphere alone, in the middle.
Scene oneSphere() {
    Scene scene = defaultScene();
    scene.models[0].visible = false;
    scene.models[1].position = {};
    return scene;
}

TEST(PresetPictures, ASphereMapGoesWithTheEye) {
    const auto orbited = [](Scene scene) {
        scene.view.azimuth += 77;
        return drawn(scene);
    };
    const Scene mapped = with("sphere-map", oneSphere());
    const double plain = differenceOf(drawn(oneSphere()), orbited(oneSphere()));
    EXPECT_GT(plain, 0.08);
    EXPECT_LT(differenceOf(drawn(mapped), orbited(mapped)), plain / 3);
}

TEST(PresetPictures, ContoursHaveOneColourAtOneHeight) {
    Scene scene = with("contours");
    scene.passes[0].lighting = false;
    scene.view.projection = Projection::Orthographic;
    scene.view.elevation = 0;        // heights are rows of pixels
    scene.models[1].visible = false; // its size and its heights differ
    const Image image = drawn(scene);
    for (int y = 0; y < extent; ++y) {
        std::optional<Color> first;
        for (int x = 0; x < extent; ++x) {
            const Color color = colorAt(image, x, y);
            if (isBackground(color))
                continue;
            if (!first)
                first = color;
            EXPECT_NEAR(color[0], (*first)[0], 4) << x << ", " << y;
        }
    }
    EXPECT_GT(shareOf(image, [](Color c) { return c[0] > 200; }), 0.01);
    EXPECT_GT(shareOf(image, [](Color c) { return c[0] < 100 && !isBackground(c); }), 0.01);
}

TEST(PresetPictures, AReflectionHasTheColoursOfTheFaces) {
    EXPECT_EQ(shareOf(drawn(defaultScene()), isColorful), 0) << "a board of black and white";
    EXPECT_GT(shareOf(drawn(with("reflection")), isColorful), 0.1);
}

TEST(PresetPictures, AProjectorThrowsItsPictureOnTheModels) {
    EXPECT_GT(shareOf(drawn(with("projector")), isColorful), 0.05);
}

TEST(PresetPictures, AShadowIsDark) {
    const Scene shadowed = with("shadow-map");
    Scene lit = shadowed;
    lit.passes[0].units[1].enabled = false;
    const Image shadows = drawn(shadowed);
    const Image light = drawn(lit);
    EXPECT_LT(meanOf(shadows), meanOf(light) - 2);
    for (int y = 0; y < extent; ++y) {
        for (int x = 0; x < extent; ++x)
            EXPECT_LE(colorAt(shadows, x, y)[1], colorAt(light, x, y)[1]) << x << ", " << y;
    }
}

TEST(PresetPictures, ADecalLeavesTheColourAround) {
    const auto isOrange = [](Color c) { return c[0] > 2 * c[2] && c[0] > c[1] + 20; };
    EXPECT_EQ(shareOf(drawn(defaultScene()), isOrange), 0);
    EXPECT_GT(shareOf(drawn(with("decal")), isOrange), 0.05);
    EXPECT_LT(shareOf(drawn(with("decal")), isOrange),
              1 - shareOf(drawn(defaultScene()), isBackground) - 0.02);
}

TEST(PresetPictures, ADetailAddsGrain) {
    Scene smooth = defaultScene();
    smooth.textures[0].pattern = Pattern::Planet;
    EXPECT_GT(roughnessOf(drawn(with("detail", smooth))), 1.2 * roughnessOf(drawn(smooth)));
}

TEST(PresetPictures, ReliefIsGreyBrightTowardsTheLightAndDarkAway) {
    const Image image = drawn(with("emboss"));
    EXPECT_EQ(shareOf(image, isColorful), 0);
    EXPECT_GT(shareOf(image, [](Color c) { return c[0] > 140; }), 0.01);
    EXPECT_GT(shareOf(image, [](Color c) { return c[0] < 114 && !isBackground(c); }), 0.01);
    EXPECT_GT(shareOf(image, [](Color c) { return std::abs(c[0] - 127) < 6; }), 0.05) << "flat";
}

TEST(PresetPictures, ShimmerIsRoughFarAwayAndItsCureSmooth) {
    const Scene shimmer = with("shimmer");
    const int far = extent / 2;
    const double rough = roughnessOf(drawn(shimmer), far, far + 12);
    EXPECT_GT(rough, 20);
    EXPECT_LT(roughnessOf(drawn(with("shimmer-cure", shimmer)), far, far + 12), rough / 3);
}

TEST(PresetPictures, FringeIsDarkerThanTheTreeAndTheBackgroundAndItsCuresAreNot) {
    const auto isDark = [](Color c) { return c[1] < 250; }; // green and white have 255
    const Scene fringe = with("fringe");
    EXPECT_GT(shareOf(drawn(fringe), isDark), 0.02);
    EXPECT_EQ(shareOf(drawn(with("fringe-cure", fringe)), isDark), 0);
    EXPECT_EQ(shareOf(drawn(with("fringe-premultiplied", fringe)), isDark), 0);
}

/// The share of neighbours in a row that differ by one step.
double stepsOf(const Image& image) {
    int steps = 0;
    for (int y = 0; y < extent; ++y) {
        for (int x = 0; x + 1 < extent; ++x) {
            const Color one = colorAt(image, x, y);
            const Color other = colorAt(image, x + 1, y);
            steps += !isBackground(one) && !isBackground(other) && std::abs(one[0] - other[0]) > 12;
        }
    }
    return static_cast<double>(steps) / (extent * extent);
}

TEST(PresetPictures, BlocksHaveStepsAndTheirCureNone) {
    const Scene blocks = with("blocks");
    const double steps = stepsOf(drawn(blocks));
    EXPECT_GT(steps, 0.005);
    EXPECT_LT(stepsOf(drawn(with("blocks-cure", blocks))), steps / 2);
}

TEST(PresetPictures, ASeamIsMagentaAndItsCureHasNone) {
    const auto isMagenta = [](Color c) { return c[0] > c[1] + 30 && c[2] > c[1] + 30; };
    const Scene seam = with("seam");
    EXPECT_GT(shareOf(drawn(seam), isMagenta), 0.005);
    EXPECT_EQ(shareOf(drawn(with("seam-cure", seam)), isMagenta), 0);
}

/// The base level as OpenGL has read it.
Image readOf(const Scene& scene) {
    const Texture& texture = scene.textures[0];
    return std::get<Image>(*prepareLevels(texture, *ImageSource{}.find(texture))->levels.front().surface);
}

TEST(PresetPictures, ASlantedPictureMovesByOneTexelInEachRow) {
    const Image read = readOf(with("slanted"));
    const Image pattern = drawPattern(Pattern::UvTemplate);
    for (const int y : {0, 1, 100, 511}) {
        for (const int x : {0, 1, 510}) {
            const std::ptrdiff_t place = std::ptrdiff_t{y} * 511 + x;
            EXPECT_EQ(colorAt(read, x, y),
                      colorAt(pattern, static_cast<int>(place % 512), static_cast<int>(place / 512)))
                << x << ", " << y;
        }
    }
}

TEST(PresetPictures, SwappedColoursHaveRedForBlue) {
    const Image read = readOf(with("swapped-colours"));
    const Image planet = drawPattern(Pattern::Planet);
    for (const int x : {0, 100, 511}) {
        const Color color = colorAt(planet, x, 128);
        EXPECT_EQ(colorAt(read, x, 128), (Color{color[2], color[1], color[0]})) << x;
    }
    const auto isBlue = [](Color c) { return c[2] > c[0] + 40; };
    Scene right = with("swapped-colours");
    right.textures[0].upload = {};
    const double seas = shareOf(drawn(right), isBlue);
    EXPECT_GT(seas, 0.05);
    EXPECT_LT(shareOf(drawn(with("swapped-colours")), isBlue), seas / 3);
}

TEST(PresetPictures, TexturesWithoutAnImageOrLevelsShowNothing) {
    Scene off = with("no-levels");
    off.passes[0].units[0].enabled = false;
    EXPECT_EQ(drawn(with("no-levels")), drawn(off));
    EXPECT_EQ(drawn(with("wrong-format")), drawn(off));
    Scene cured = with("no-levels");
    cured.textures[0].minFilter = MinFilter::Linear;
    EXPECT_NE(drawn(cured), drawn(off));
}

TEST(PresetPictures, ANetVanishesInTheDistanceAndItsCureStays) {
    const auto farShare = [](const Scene& scene) {
        const Image image = drawn(scene);
        int count = 0;
        for (int y = extent * 7 / 16; y < extent * 9 / 16; ++y) {
            for (int x = 0; x < extent; ++x)
                count += !isBackground(colorAt(image, x, y));
        }
        return static_cast<double>(count) / (extent * extent / 8);
    };
    const Scene net = with("vanishing");
    EXPECT_LT(farShare(net), 0.01);
    EXPECT_GT(farShare(with("vanishing-cure", net)), 0.05);
}

TEST(PresetPictures, ATreeStandsOnItsHeadUntilItIsTurned) {
    const auto isGround = [](Color c) { return c[0] > c[1]; }; // brown, below the green of the sky
    const Scene wrong = with("upside-down");
    const Image down = drawn(wrong);
    const Image up = drawn(with("upside-down-cure", wrong));
    EXPECT_TRUE(isGround(colorAt(up, 20, 20))); // row 0 is the bottom one
    EXPECT_FALSE(isGround(colorAt(up, 20, 76)));
    EXPECT_FALSE(isGround(colorAt(down, 20, 20)));
    EXPECT_TRUE(isGround(colorAt(down, 20, 76)));
}

TEST(PresetPictures, LevelsHaveColours) {
    Scene plain = with("coloured-levels");
    plain.textures[0].mipmaps = MipPolicy::Generated;
    EXPECT_EQ(shareOf(drawn(plain), isColorful), 0);
    EXPECT_GT(shareOf(drawn(with("coloured-levels")), isColorful), 0.2);
}

TEST(PresetPictures, AnisotropyKeepsWhatIsFarAwaySharp) {
    const Scene sharp = with("anisotropy");
    Scene plain = sharp;
    plain.textures[0].maxAnisotropy = 1;
    const int far = extent / 2;
    EXPECT_GT(roughnessOf(drawn(sharp), far - 12, far + 12),
              1.5 * roughnessOf(drawn(plain), far - 12, far + 12));
}

} // namespace
} // namespace texplorer::preset_pictures_test

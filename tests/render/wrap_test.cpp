// Wrap modes outside of [0, 1] against section 3.8.7 and 3.8.8 of the OpenGL 2.1 specification.

#include "tests/support/flat_scene.h"
#include "tests/support/render_fixture.h"

#include <gmock/gmock.h>

#include <string_view>

namespace texplorer::wrap_test {
namespace {

using namespace test;

// Every letter has a share in every component, so that a half of each can't be mistaken for anything else.
glm::vec4 colorOf(char letter) {
    switch (letter) {
    case 'A':
        return {1.0F, 0.2F, 0.0F, 0.4F};
    case 'B':
        return {0.2F, 0.6F, 0.4F, 0.8F};
    case 'C':
        return {0.4F, 0.0F, 1.0F, 0.2F};
    case 'D':
        return {0.6F, 1.0F, 0.2F, 1.0F};
    default: // 'K', the border
        return {0.0F, 0.4F, 0.8F, 0.6F};
    }
}

Texel texelOf(char letter) {
    const glm::vec4 color = colorOf(letter) * 255.0F + 0.5F;
    return {static_cast<int>(color.r), static_cast<int>(color.g), static_cast<int>(color.b),
            static_cast<int>(color.a)};
}

/// "AB" is half A, half B.
glm::vec4 mixOf(std::string_view letters) {
    glm::vec4 sum{0};
    for (const char letter : letters)
        sum += colorOf(letter);
    return sum / static_cast<float>(letters.size());
}

struct Case {
    const char* name;
    Wrap wrap;
    // Two texels, A B, nearest: the sample is at texel -1's centre, or at texel 2's.
    std::string_view nearestLow;
    std::string_view nearestHigh;
    // Four texels, A B C D, linear: the sample is half-way between texels -2 and -1, or between 4 and 5.
    std::string_view linearLow;
    std::string_view linearHigh;
};

enum class Axis { S, T, R };

class WrapMode : public RenderTest, public testing::WithParamInterface<std::tuple<Case, Axis>> {
protected:
    glm::vec4 sample(float coordinate, int texels, MagFilter filter) {
        const auto [row, axis] = GetParam();
        const Image line = texels == 2
                               ? rgbaImage(2, 1, 1, {texelOf('A'), texelOf('B')})
                               : rgbaImage(4, 1, 1, {texelOf('A'), texelOf('B'), texelOf('C'), texelOf('D')});
        Image image = line;
        std::swap(image.width, axis == Axis::T ? image.height : axis == Axis::R ? image.depth : image.width);
        images.put("image", image);

        Scene scene = texturedScene();
        Texture& texture = scene.textures[0];
        texture.magFilter = filter;
        texture.minFilter = filter == MagFilter::Nearest ? MinFilter::Nearest : MinFilter::Linear;
        texture.borderColor = colorOf('K');
        (axis == Axis::S ? texture.wrapS : axis == Axis::T ? texture.wrapT : texture.wrapR) = row.wrap;
        scene.passes[0].units[0].target = axis == Axis::R ? Target::Texture3D : Target::Texture2D;
        glm::vec4 at{0.5F, 0.5F, 0.5F, 1};
        at[static_cast<int>(axis)] = coordinate;
        scene.models[0].texCoords[0] = quadCoords(at);
        const glm::vec4 found = onlyColor(scene);
        EXPECT_THAT(problems, testing::IsEmpty());
        return found;
    }
};

TEST_P(WrapMode, NearestBelowZero) {
    EXPECT_TRUE(isColor(sample(-0.25F, 2, MagFilter::Nearest), mixOf(std::get<Case>(GetParam()).nearestLow)));
}
TEST_P(WrapMode, NearestAboveOne) {
    EXPECT_TRUE(isColor(sample(1.25F, 2, MagFilter::Nearest), mixOf(std::get<Case>(GetParam()).nearestHigh)));
}
TEST_P(WrapMode, LinearBelowZero) {
    EXPECT_TRUE(isColor(sample(-0.25F, 4, MagFilter::Linear), mixOf(std::get<Case>(GetParam()).linearLow)));
}
TEST_P(WrapMode, LinearAboveOne) {
    EXPECT_TRUE(isColor(sample(1.25F, 4, MagFilter::Linear), mixOf(std::get<Case>(GetParam()).linearHigh)));
}

INSTANTIATE_TEST_SUITE_P(
    All, WrapMode,
    testing::Combine(
        testing::Values(Case{"Repeat", Wrap::Repeat, "B", "A", "CD", "AB"},
                        Case{"MirroredRepeat", Wrap::MirroredRepeat, "A", "B", "AB", "CD"},
                        Case{"ClampToEdge", Wrap::ClampToEdge, "A", "B", "A", "D"},
                        Case{"ClampToBorder", Wrap::ClampToBorder, "K", "K", "K", "K"},
                        // Clamped to 0 and 1, on the rim: half of the 2-texel footprint lies in the border.
                        Case{"Clamp", Wrap::Clamp, "A", "B", "KA", "DK"}),
        testing::Values(Axis::S, Axis::T, Axis::R)),
    [](const auto& test) {
        return std::string(std::get<Case>(test.param).name) +
               "STR"[static_cast<int>(std::get<Axis>(test.param))];
    });

} // namespace
} // namespace texplorer::wrap_test

#include "core/conform/judge.h"
#include "core/conform/skip.h"
#include "core/conform/surfaces.h"

#include <gtest/gtest.h>

namespace texplorer::conform::judge_test {
namespace {

constexpr Rule none{"none", 2, 1, Tolerance::None, 1, 1, ""};
constexpr Rule edge{"edge", 2, 1, Tolerance::TexelEdge, 1, 1, ""};
constexpr Rule lambda{"lambda", 2, 1, Tolerance::Lambda, 1, 1, ""};

class Judging : public testing::Test {
protected:
    Image draw(const Scene& scene) { return reference->draw(scene)->image; }
    Judgement judged(const Rule& rule, const Scene& scene, const Scene& drawnAs) {
        return *judge(rule, scene, draw(scene), draw(drawnAs), *reference);
    }
    std::unique_ptr<Explainer> reference = referenceRenderer();
};

/// A checkerboard, one texel a pixel, whose pixels' centres are `offset` texels behind an edge.
Scene boardWithEdgesAt(float offset) {
    Dice dice("board", 1, 1);
    Scene scene = texturedQuad({Pattern::Checker, 0, 64, 64}, dice);
    scene.models[0].texCoords[0].clear();
    for (const Vertex& vertex : makeMesh({Shape::Quad}).vertices)
        scene.models[0].texCoords[0].emplace_back(
            (vertex.position.x > 0 ? 1.0F : 0.0F) + (offset - 0.5F) / 64, 0.5F / 64, 0, 1);
    return scene;
}

TEST_F(Judging, TakesUnitsWithoutATextureAsTheyAre) {
    Scene scene = boardWithEdgesAt(0.005F);
    scene.passes[0].units[1].enabled = true;
    for (const int texture : {-1, 1, 5}) {
        scene.passes[0].units[1].texture = texture;
        EXPECT_EQ(movedByTexelError(scene, ImageSource()).size(), 4U);
        EXPECT_EQ(judged(edge, scene, boardWithEdgesAt(-0.005F)).unexplained, 0U);
        EXPECT_EQ(skipOf(scene, {RendererKind::Reference, RendererKind::Fixed}, {"llvmpipe", "", "", {}}),
                  nullptr);
    }
}

TEST_F(Judging, GrantsTheNeighbourNextToAnEdge) {
    const Scene near = boardWithEdgesAt(0.005F);
    const Scene beyond = boardWithEdgesAt(-0.005F);
    const Judgement strict = judged(none, near, beyond);
    EXPECT_GT(strict.difference.over, 0U);
    EXPECT_EQ(strict.unexplained, strict.difference.over);
    EXPECT_EQ(judged(edge, near, beyond).unexplained, 0U);
    EXPECT_EQ(judged(edge, near, beyond).difference.over, strict.difference.over);
}

TEST_F(Judging, GrantsNoTexelThatIsFurtherAway) {
    const Scene far = boardWithEdgesAt(0.02F);
    const Judgement judgement = judged(edge, far, boardWithEdgesAt(-0.02F));
    EXPECT_GT(judgement.difference.over, 0U);
    EXPECT_EQ(judgement.unexplained, judgement.difference.over);
}

Scene trilinearFloor() {
    Dice dice("floor", 1, 1);
    Scene scene = surface(Shape::Floor, dice);
    scene.textures[0].pattern = Pattern::MipColors;
    scene.textures[0].mipmaps = MipPolicy::Colored;
    return scene;
}

TEST_F(Judging, GrantsLambdaItsError) {
    const Scene scene = trilinearFloor();
    Scene biased = scene;
    biased.passes[0].units[0].lodBias = 0.015F; // 1/64 is 0.0156
    const Judgement judgement = judged(lambda, scene, biased);
    EXPECT_GT(judgement.difference.over, 100U);
    EXPECT_EQ(judgement.unexplained, 0U);
}

TEST_F(Judging, GrantsLambdaNoMore) {
    const Scene scene = trilinearFloor();
    Scene biased = scene;
    biased.passes[0].units[0].lodBias = 0.1F;
    const Judgement judgement = judged(lambda, scene, biased);
    EXPECT_GT(judgement.unexplained, judgement.difference.over / 2);
}

// llvmpipe clamps them to the edge under GL_LINEAR; under GL_NEAREST, and clamped, they can be compared.
TEST(Skipping, NamesACubeMapsOtherWraps) {
    Dice dice("cube", 1, 1);
    Scene scene = texturedQuad({Pattern::CubeFaces, 0, 64, 64}, dice);
    scene.passes[0].units[0].target = Target::CubeMap;
    Texture& texture = scene.textures[0];
    const auto nameOf = [&](const Pair& pair, const char* driver) {
        const Skip* skip = skipOf(scene, pair, {driver, "", "", {}});
        return skip ? skip->name : std::string_view();
    };
    constexpr Pair withReference{RendererKind::Reference, RendererKind::Fixed};
    for (const bool linear : {false, true}) {
        for (const Wrap wrap : {Wrap::ClampToEdge, Wrap::Repeat, Wrap::ClampToBorder}) {
            texture.minFilter = linear ? MinFilter::Linear : MinFilter::Nearest;
            texture.wrapT = wrap;
            texture.wrapS = Wrap::ClampToEdge;
            const bool differs = linear && wrap != Wrap::ClampToEdge;
            EXPECT_EQ(nameOf(withReference, "llvmpipe (LLVM 15)"), differs ? "cube-wrap" : "");
            EXPECT_EQ(nameOf(withReference, "another"), "");
            EXPECT_EQ(nameOf({RendererKind::Shader, RendererKind::Fixed}, "llvmpipe (LLVM 15)"), "");
        }
    }
}

// A texel of a file is as large as the file says.
TEST_F(Judging, MovesByTheTexelsOfFiles) {
    Scene scene = boardWithEdgesAt(0.005F);
    scene.textures[0].source = SourceKind::File;
    scene.textures[0].file = "16.bmp";
    ImageSource images;
    images.put("16.bmp", Image::uninitialised(PixelFormat::Rgba8, 16, 16));
    const Scene moved = movedByTexelError(scene, images).front();
    EXPECT_EQ(moved.passes[0].units[0].matrix[0].amount.x, -1.0F / 128 / 16);
}

TEST_F(Judging, RefusesPicturesOfTwoSizes) {
    const Scene scene = trilinearFloor();
    EXPECT_FALSE(judge(none, scene, draw(scene), Image::uninitialised(PixelFormat::Rgba8, 1, 1), *reference));
}

} // namespace
} // namespace texplorer::conform::judge_test

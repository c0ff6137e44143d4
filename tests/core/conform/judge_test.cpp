#include "texplorer/conform/feature.h"
#include "texplorer/conform/judge.h"
#include "texplorer/conform/skip.h"
#include "texplorer/conform/surfaces.h"
#include "texplorer/scene/params/json.h"

#include <gtest/gtest.h>

#include <array>

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

// Far from 0 a coordinate has fewer bits. These are 870 repeats away, where 2^-20 of a coordinate are 0.053
// texels.
TEST_F(Judging, GrantsMoreToCoordinatesThatAreFarAway) {
    const auto farAway = [](float offset) {
        Scene scene = boardWithEdgesAt(offset);
        for (glm::vec4& each : scene.models[0].texCoords[0].edit())
            each.s += 870;
        return scene;
    };
    const Judgement near = judged(edge, boardWithEdgesAt(0.03F), boardWithEdgesAt(-0.02F));
    EXPECT_GT(near.difference.over, 0U);
    EXPECT_EQ(near.unexplained, near.difference.over);
    const Judgement far = judged(edge, farAway(0.03F), farAway(-0.02F));
    EXPECT_GT(far.difference.over, 0U);
    EXPECT_EQ(far.unexplained, 0U);
    EXPECT_GT(judged(edge, farAway(0.3F), farAway(-0.3F)).unexplained, 0U);
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

// Of two faces of a cube the far one is blended over, and is at a lambda of about 2.5: which of two levels it
// reads counts for the pixel, too. What llvmpipe draws there, from the upper left.
TEST_F(Judging, GrantsLambdaItsErrorInEveryFragmentThatIsSeen) {
    const Result<Scene> scene = parseScene(R"({"version": 1, "models": [{"position": [1, 1, 1]}],
        "textures": [{"minFilter": "GL_LINEAR_MIPMAP_NEAREST", "mipmaps": "generated", "lodBias": 1.4}],
        "passes": [{"blend": true, "blendDst": "GL_ONE_MINUS_SRC_COLOR", "units": [{"enabled": true}]}]})");
    ASSERT_TRUE(scene) << describe(scene.error());
    struct Pixel {
        int x;
        int y;
        std::array<int, 3> color;
    };
    Image theirs = draw(*scene);
    for (const auto& [x, y, color] :
         {Pixel{28, 42, {237, 238, 238}}, {51, 11, {34, 39, 47}}, {24, 20, {166, 168, 171}}}) {
        for (std::size_t c = 0; c < 3; ++c)
            theirs.at(x, extent - 1 - y)[c] = static_cast<std::byte>(color[c]);
    }
    const Judgement judgement = *judge(lambda, *scene, draw(*scene), theirs, *reference);
    EXPECT_EQ(judgement.difference.over, 3U);
    EXPECT_EQ(judgement.unexplained, 0U);
}

/// A square that covers the picture, with 3 texels a pixel, turned by 30 degrees: the least rho of
/// OpenGL 2.1, section 3.8.8, is log2(cos 30) = -0.2075 below the ideal one, the largest log2(2 cos 30) =
/// 0.7925 above.
Scene turnedBoard() {
    Dice dice("turned", 1, 1);
    Scene scene = texturedQuad({Pattern::MipColors, 0, 64, 64}, dice);
    scene.models[0].texCoords[0].clear();
    for (const Vertex& vertex : makeMesh({Shape::Quad}).vertices)
        scene.models[0].texCoords[0].emplace_back(vertex.position.x > 0 ? 1.0F : 0.0F,
                                                  vertex.position.y > 0 ? 1.0F : 0.0F, 0, 1);
    scene.textures[0].mipmaps = MipPolicy::Colored;
    scene.textures[0].minFilter = MinFilter::LinearMipmapLinear;
    scene.passes[0].units[0].matrix = {{.op = MatrixOp::Scale, .amount = {3, 3, 1}},
                                       {.op = MatrixOp::Rotate, .amount = {0, 0, 1}, .angle = 30}};
    return scene;
}

Scene biased(Scene scene, float bias) {
    scene.passes[0].units[0].lodBias += bias;
    return scene;
}

TEST_F(Judging, GrantsEitherEndOfRho) {
    const Scene scene = turnedBoard();
    for (const auto method : {reference::RhoMethod::Lower, reference::RhoMethod::Upper}) {
        const Image theirs = reference->drawBy(scene, method)->image;
        const Judgement judgement = *judge(lambda, scene, draw(scene), theirs, *reference);
        EXPECT_EQ(judgement.rho, method);
        EXPECT_EQ(judgement.difference.over, 0U);
        EXPECT_EQ(judgement.unexplained, 0U);
        ASSERT_TRUE(judgement.redrawn);
        EXPECT_EQ(compare(*judgement.redrawn, theirs, lambda.bound)->over, 0U);
    }
    const Judgement same = judged(lambda, scene, scene);
    EXPECT_EQ(same.rho, reference::RhoMethod::Ideal);
    EXPECT_FALSE(same.redrawn);
}

TEST_F(Judging, GrantsWhatLiesBetweenTheEndsOfRho) {
    const Scene scene = turnedBoard();
    for (const float bias : {-0.1F, 0.3F, 0.5F}) {
        const Image theirs = draw(biased(scene, bias));
        const Judgement judgement = *judge(lambda, scene, draw(scene), theirs, *reference, RhoRange::Any);
        EXPECT_GT(judgement.difference.over, 3000U) << bias;
        EXPECT_EQ(judgement.unexplained, 0U) << bias;
        EXPECT_EQ(judgement.withinRho, judgement.difference.over) << bias;
        // A driver whose rho is known takes no other one.
        const Judgement strict = *judge(lambda, scene, draw(scene), theirs, *reference, RhoRange::Ends);
        EXPECT_EQ(strict.unexplained, strict.difference.over) << bias;
    }
    EXPECT_EQ(rhoRangeOf({"llvmpipe (LLVM 15.0.6, 256 bits)", "", "", {}}), RhoRange::Ends);
    EXPECT_EQ(rhoRangeOf({"softpipe", "", "", {}}), RhoRange::Ends);
    EXPECT_EQ(rhoRangeOf({"AMD Radeon", "", "", {}}), RhoRange::Any);
}

// The arithmetic that llvmpipe is granted takes up to 0.0861 from the lower end, 6 bits are added to both.
TEST_F(Judging, GrantsNothingBeyondTheEndsOfRho) {
    const Scene scene = turnedBoard();
    for (const float bias : {-0.2075F - 0.13F, 0.7925F + 0.05F}) {
        const Judgement judgement =
            *judge(lambda, scene, draw(scene), draw(biased(scene, bias)), *reference, RhoRange::Any);
        EXPECT_GT(judgement.difference.over, 3000U) << bias;
        EXPECT_EQ(judgement.unexplained, judgement.difference.over) << bias;
    }
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

TEST(Skipping, NamesClampWhereTheFiltersDiffer) {
    Dice dice("clamp", 1, 1);
    Scene scene = texturedQuad({Pattern::Checker, 0, 64, 64}, dice);
    Texture& texture = scene.textures[0];
    texture.magFilter = MagFilter::Nearest;
    constexpr Pair pair{RendererKind::Reference, RendererKind::Fixed};
    for (const Wrap wrap : {Wrap::Clamp, Wrap::Repeat}) {
        for (const MinFilter filter : {MinFilter::Linear, MinFilter::Nearest}) {
            texture.wrapS = wrap;
            texture.wrapT = Wrap::ClampToEdge;
            texture.minFilter = filter;
            const Skip* skip = skipOf(scene, pair, {"llvmpipe (LLVM 15)", "", "", {}});
            const bool differs = wrap == Wrap::Clamp && filter == MinFilter::Linear;
            EXPECT_EQ(skip ? skip->name : std::string_view(), differs ? "mixed-clamp" : "");
        }
    }
}

// What softpipe was seen to do, on scenes that another driver is compared by.
TEST(Skipping, NamesWhatSoftpipeDoesOtherwise) {
    const auto with = [](auto change) {
        Dice dice("softpipe", 1, 1);
        Scene scene = texturedQuad({Pattern::Checker, 0, 64, 64}, dice);
        change(scene, scene.textures[0], scene.passes[0]);
        return scene;
    };
    const std::pair<const char*, Scene> rows[] = {
        {"filtered-depths", with([](Scene&, Texture& texture, Pass&) {
             texture.internalFormat = InternalFormat::DepthComponent24;
             texture.compareMode = CompareMode::RToTexture;
             texture.minFilter = MinFilter::Linear;
         })},
        {"mirrored-slices", with([](Scene&, Texture& texture, Pass& pass) {
             pass.units[0].target = Target::Texture3D;
             texture.wrapR = Wrap::MirroredRepeat;
             texture.magFilter = MagFilter::Linear;
         })},
        {"half-way", with([](Scene&, Texture& texture, Pass&) {
             texture.minFilter = MinFilter::LinearMipmapNearest;
             texture.magFilter = MagFilter::Nearest;
             texture.maxLod = 2.5F;
         })},
        {"ellipse-of-one-level", with([](Scene&, Texture& texture, Pass&) {
             texture.minFilter = MinFilter::LinearMipmapNearest;
             texture.magFilter = MagFilter::Nearest;
             texture.maxAnisotropy = 4;
         })},
        {"mirrored-ellipse", with([](Scene&, Texture& texture, Pass&) {
             texture.minFilter = MinFilter::LinearMipmapLinear;
             texture.wrapS = Wrap::MirroredRepeat;
             texture.maxAnisotropy = 4;
         })},
        {"seamless-corners", with([](Scene&, Texture& texture, Pass& pass) {
             pass.units[0].target = Target::CubeMap;
             pass.seamlessCubeMap = true;
             texture.minFilter = MinFilter::Linear;
         })},
        {"unrounded-alpha", with([](Scene&, Texture&, Pass& pass) {
             pass.alphaTest = true;
             pass.alphaRef = 0.3F;
         })},
        {"whole-pixels", with([](Scene& scene, Texture&, Pass&) {
             scene.models[0].shape = Shape::Mesh;
             scene.models[0].mesh.primitive = Primitive::Lines;
         })},
    };
    DriverFacts facts;
    facts.maxAnisotropy = 16;
    constexpr Pair pair{RendererKind::Reference, RendererKind::Fixed};
    for (const auto& [name, scene] : rows) {
        const Skip* skip = skipOf(scene, pair, {"softpipe", "", "", facts});
        EXPECT_EQ(skip ? skip->name : std::string_view(), name);
        const Skip* other = skipOf(scene, pair, {"llvmpipe (LLVM 15)", "", "", facts});
        const bool isOfBoth = name == std::string_view("mirrored-ellipse");
        EXPECT_EQ(other && other->name == name, isOfBoth) << name;
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

// Of 1000 pixels 200 may be over 16, and 50 of these over 128.
TEST_F(Judging, AllowsFewerPixelsToBeFarOff) {
    struct Row {
        int over; ///< pixels that are off by 128
        int far;  ///< by 129
        bool isAllowed;
    };
    for (const auto& [over, far, isAllowed] : {Row{199, 0, true}, Row{201, 0, false}, Row{150, 49, true},
                                               Row{140, 51, false}, Row{0, 51, false}}) {
        Image ours = Image::uninitialised(PixelFormat::Rgba8, 40, 25);
        std::ranges::fill(ours.pixels, std::byte{0});
        Image theirs = ours;
        for (int i = 0; i < over + far; ++i)
            theirs.pixels[static_cast<std::size_t>(4 * i)] = static_cast<std::byte>(i < far ? 129 : 128);
        const Result<Judgement> judgement = judge(rules::ellipse, Scene{}, ours, theirs, *reference);
        ASSERT_TRUE(judgement) << describe(judgement.error());
        EXPECT_EQ(judgement->far, static_cast<std::size_t>(far));
        EXPECT_EQ(judgement->isAllowed(rules::ellipse), isAllowed) << over << " and " << far;
    }
}

TEST_F(Judging, RefusesPicturesOfTwoSizes) {
    const Scene scene = trilinearFloor();
    EXPECT_FALSE(judge(none, scene, draw(scene), Image::uninitialised(PixelFormat::Rgba8, 1, 1), *reference));
}

} // namespace
} // namespace texplorer::conform::judge_test

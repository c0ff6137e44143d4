// Numbers that can be worked out by hand; and every pixel of small pictures, which the probe must give the
// very bytes that are drawn.

#include "tests/core/reference/textures.h"
#include "texplorer/reference/explain/explanation_steps.h"
#include "texplorer/reference/probe.h"
#include "texplorer/scene/tex_coords.h"

#include <glm/common.hpp>
#include <gmock/gmock.h>

#include <limits>

namespace texplorer::reference::probe_test {
namespace {

using namespace test;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

/// A square that fills the picture exactly, without perspective, with a texture of 2 x 2 texels: 0, 0.2, 0.4
/// and 1 of grey, the lowest row first. Replaces the incoming colour.
struct Flat {
    Scene scene;
    ImageSource images;

    Flat() {
        scene.view.projection = Projection::Orthographic;
        scene.view.fieldOfView = 90;
        scene.view.distance = 1;
        scene.models.resize(1);
        scene.models[0].shape = Shape::Quad;
        scene.textures.resize(1);
        scene.textures[0].source = SourceKind::File;
        scene.textures[0].file = "four";
        scene.textures[0].minFilter = MinFilter::Linear;
        scene.passes[0].units[0].enabled = true;
        scene.passes[0].units[0].envMode = EnvMode::Replace;
        images.put("four", Image{PixelFormat::Luminance8,
                                 2,
                                 2,
                                 1,
                                 {std::byte{0}, std::byte{51}, std::byte{102}, std::byte{255}}});
    }

    [[nodiscard]] Explanation at(int x, int y, int extent = 4) const {
        const Result<Explanation> found = probe({scene, images, 0, extent, extent}, {x, y});
        EXPECT_TRUE(found) << describe(found.error());
        return found.value_or(Explanation{});
    }
    [[nodiscard]] FragmentExplanation fragment(int x, int y, int extent = 4) const {
        const Explanation found = at(x, y, extent);
        EXPECT_EQ(found.fragments.size(), 1U);
        return found.fragments.empty() ? FragmentExplanation{} : found.fragments[0];
    }
    [[nodiscard]] UnitExplanation unit(int x, int y) const {
        const FragmentExplanation found = fragment(x, y);
        EXPECT_EQ(found.units.size(), 1U);
        return found.units.empty() ? UnitExplanation{} : found.units[0];
    }
};

// ---- Numbers by hand ----

// Two bytes a row, of which OpenGL expects four: the upper row begins beyond the end.
TEST(Probe, FollowsATexelToItsBytes) {
    Flat flat;
    flat.scene.textures[0].flip = FlipMode::Pixels;
    flat.scene.textures[0].magFilter = MagFilter::Nearest;
    EXPECT_FALSE(flat.unit(0, 0).uploaded);
    flat.scene.textures[0].upload = {.custom = true, .format = TransferFormat::Luminance};
    const auto textAt = [&](int x, int y) {
        std::string text;
        for (const Step& step : stepsOf(flat.fragment(x, y)).steps) {
            for (const StepRow& row : step.rows) {
                if (step.kind == StepKind::Texels)
                    text += row.label.english() + '\n';
            }
        }
        return text;
    };
    EXPECT_THAT(textAt(3, 0), HasSubstr("memory at byte 1: 51, l, read as l\n"));
    EXPECT_THAT(textAt(3, 3), HasSubstr("memory at byte 5: beyond its end, 0\n"));
}

// The square is sent as (0, 0), (1, 0), (1, 1), (0, 1). Its triangles are 0 1 3 and 1 2 3, and without
// glTexCoord of vertex 3 the upper one has (1, 0), (1, 1) and again (1, 1).
TEST(Probe, TellsWhoseCoordinatesAVertexWithoutGlTexCoordHas) {
    Flat flat;
    flat.scene.models[0].noTexCoord[0] = {3};
    const FragmentExplanation fragment = flat.fragment(3, 3);
    ASSERT_EQ(fragment.vertices.size(), 3U);
    EXPECT_EQ(fragment.shape, Shape::Quad);
    EXPECT_EQ(fragment.vertices[0].vertex, 1U);
    EXPECT_EQ(fragment.vertices[1].vertex, 2U);
    EXPECT_EQ(fragment.vertices[2].vertex, 3U);
    const std::vector<CoordinateSteps>& coords = fragment.units.at(0).vertices;
    EXPECT_EQ(coords[1].of, 2U);
    EXPECT_EQ(coords[2].of, 2U);
    EXPECT_EQ(coords[2].given, glm::vec4(1, 1, 0, 1));
    // Pixel (3, 3) is 1/8 below the top: t is 7/8 of it, and s is 1 everywhere.
    EXPECT_TRUE(isNear(fragment.units[0].pixel.given, {1, 0.875F, 0, 1}));

    flat.scene.models[0].noTexCoord[0] = {0, 1, 2, 3};
    const UnitExplanation unit = flat.unit(0, 0);
    EXPECT_EQ(unit.vertices[0].of, std::nullopt);
    EXPECT_EQ(unit.pixel.given, glm::vec4(0, 0, 0, 1));
    // Between four texels, of which GL_REPEAT finds three at the other rims: (0 + 0.2 + 0.4 + 1) / 4.
    EXPECT_NEAR(unit.sample.color.r, 0.4F, 1e-6F);
}

// The centre of pixel (0, 0) of 4 x 4 is at s = t = 1/8, u = v = 1/4 of 2 texels: a quarter of a texel below
// the centre of texel 0, which leaves it three quarters of the weight and gives one to its neighbour, that
// GL_REPEAT finds at the other rim.
TEST(Probe, FindsTheTexelsAndTheirWeights) {
    const UnitExplanation unit = Flat().unit(0, 0);
    EXPECT_TRUE(isNear(unit.pixel.given, {0.125F, 0.125F, 0, 1}));
    EXPECT_EQ(unit.coords, glm::vec3(0.125F, 0.125F, 0));
    std::array<std::array<float, 2>, 2> weights{};
    for (const Tap& tap : unit.sample.taps)
        weights.at(static_cast<std::size_t>(tap.index.y)).at(static_cast<std::size_t>(tap.index.x)) +=
            tap.weight;
    EXPECT_FLOAT_EQ(weights[0][0], 9.0F / 16);
    EXPECT_FLOAT_EQ(weights[0][1], 3.0F / 16);
    EXPECT_FLOAT_EQ(weights[1][0], 3.0F / 16);
    EXPECT_FLOAT_EQ(weights[1][1], 1.0F / 16);
    // 9/16 * 0 + 3/16 * 0.2 + 3/16 * 0.4 + 1/16 * 1
    EXPECT_TRUE(isNear(unit.sample.color, {0.175F, 0.175F, 0.175F, 1}));
    ASSERT_EQ(unit.extents.size(), 1U);
    EXPECT_EQ(unit.extents[0].size, glm::ivec3(2, 2, 1));
}

// Two texels on four pixels: half a texel a pixel, lambda = log2(1/2).
TEST(Probe, FindsTheLevelOfDetail) {
    Flat flat;
    flat.scene.passes[0].units[0].lodBias = 0.375F;
    flat.scene.textures[0].lodBias = -0.125F;
    flat.scene.textures[0].minLod = -0.5F;
    const UnitExplanation unit = flat.unit(2, 1);
    EXPECT_FLOAT_EQ(unit.derivatives.dx.s, 0.25F);
    EXPECT_FLOAT_EQ(unit.derivatives.dy.t, 0.25F);
    EXPECT_NEAR(unit.sample.lod.rho, 0.5, 1e-6);
    EXPECT_FLOAT_EQ(unit.sample.lod.base, -1);
    EXPECT_EQ(unit.lodBias, 0.375F);
    EXPECT_EQ(unit.sampler.lodBias, -0.125F);
    EXPECT_EQ(unit.sample.lod.bias, 0.25F);
    EXPECT_FLOAT_EQ(unit.sample.lod.biased, -0.75F);
    EXPECT_FLOAT_EQ(unit.sample.lod.lambda, -0.5F);
    EXPECT_TRUE(unit.sample.lod.magnified);
}

// The middle of the middle pixel of 3 x 3 is where the four texels meet: each is right.
TEST(Probe, GivesWhatIsAsRightOnATie) {
    Flat flat;
    flat.scene.textures[0].minFilter = MinFilter::Nearest;
    flat.scene.textures[0].magFilter = MagFilter::Nearest;
    const Explanation found = flat.at(1, 1, 3);
    std::vector<PixelBytes> all = found.asRight;
    all.push_back(found.bytes);
    EXPECT_THAT(all, testing::UnorderedElementsAre(PixelBytes{0, 0, 0, 255}, PixelBytes{51, 51, 51, 255},
                                                   PixelBytes{102, 102, 102, 255},
                                                   PixelBytes{255, 255, 255, 255}));
    EXPECT_EQ(found.fragments.at(0).units.at(0).ties.others.size(), 3U);
    EXPECT_THAT(flat.at(0, 0, 4).asRight, testing::IsEmpty());
    flat.scene.textures[0].magFilter = MagFilter::Linear;
    EXPECT_THAT(flat.at(1, 1, 3).asRight, testing::IsEmpty());
}

/// So many triangles over the whole picture, one on the other; those from number `hidden` on behind the
/// others.
Flat pileOf(int count, int hidden) {
    Flat flat;
    Model& model = flat.scene.models[0];
    model.shape = Shape::Mesh;
    model.mesh.primitive = Primitive::Triangles;
    model.mesh.positions = {{-3, -1, 0},     {3, -1, 0},     {0, 5, 0},
                            {-3, -1, -0.5F}, {3, -1, -0.5F}, {0, 5, -0.5F}};
    for (int i = 0; i < count; ++i)
        for (int corner = 0; corner < 3; ++corner)
            model.mesh.indices.push_back(i < hidden ? corner : corner + 3);
    flat.scene.passes[0].depthTest = true;
    flat.scene.passes[0].depthFunc = CompareFunc::LessEqual;
    return flat;
}

// All are drawn, and the last ones are explained, up to that which one sees.
TEST(Probe, ExplainsNoMoreFragmentsThanItSays) {
    const Explanation all = pileOf(500, 500).at(1, 1);
    EXPECT_EQ(all.fragmentCount, 500U);
    EXPECT_EQ(all.firstFragment, 500 - maxExplainedFragments);
    ASSERT_EQ(all.fragments.size(), maxExplainedFragments);
    EXPECT_EQ(all.seen(), &all.fragments.back());
    EXPECT_EQ(all.fragments.back().part, 499U);
    const Explanation hidden = pileOf(500, 100).at(1, 1);
    EXPECT_EQ(hidden.fragmentCount, 500U);
    EXPECT_EQ(hidden.firstFragment, 100 - maxExplainedFragments);
    ASSERT_EQ(hidden.fragments.size(), maxExplainedFragments);
    EXPECT_EQ(hidden.seen(), &hidden.fragments.back());
    EXPECT_EQ(hidden.bytes, all.bytes);
    const Explanation few = pileOf(5, 5).at(1, 1);
    EXPECT_EQ(few.fragments.size(), 5U);
    EXPECT_EQ(few.fragmentCount, 5U);
    EXPECT_EQ(few.bytes, all.bytes);
}

TEST(Probe, SaysWhichTexelsAreTheBorder) {
    Flat flat;
    flat.scene.textures[0].wrapS = flat.scene.textures[0].wrapT = Wrap::Clamp;
    flat.scene.textures[0].borderColor = {1, 0, 0, 1};
    float border = 0;
    for (const Tap& tap : flat.unit(0, 2).sample.taps)
        border += tap.border ? tap.weight : 0;
    EXPECT_FLOAT_EQ(border, 0.25F); // the texels to the left of s = 0
}

TEST(Probe, GivesTheCornersTheirShares) {
    const FragmentExplanation fragment = Flat().fragment(3, 1);
    float sum = 0;
    glm::vec4 clip(0);
    for (const VertexExplanation& vertex : fragment.vertices) {
        sum += vertex.weight;
        clip += vertex.weight * vertex.clip;
    }
    EXPECT_FLOAT_EQ(sum, 1);
    // (3.5, 1.5) of 4 x 4 pixels in normalised device coordinates.
    EXPECT_NEAR(clip.x / clip.w, 0.75F, 1e-5F);
    EXPECT_NEAR(clip.y / clip.w, -0.25F, 1e-5F);
    EXPECT_EQ(fragment.shape, Shape::Quad);
    EXPECT_FALSE(fragment.face.empty());
    EXPECT_FALSE(fragment.clipped);
}

TEST(Probe, DividesByQ) {
    Flat flat;
    flat.scene.models[0].texCoords[0] = TexCoords(4, {1, 3, 0, 4});
    const UnitExplanation unit = flat.unit(1, 1);
    EXPECT_TRUE(isNear(unit.pixel.transformed, {1, 3, 0, 4}));
    EXPECT_EQ(unit.coords, glm::vec3(0.25F, 0.75F, 0));
}

TEST(Probe, GeneratesAndTransformsCoordinates) {
    Flat flat;
    Unit& unit = flat.scene.passes[0].units[0];
    unit.texGenS = {true, TexGenMode::ObjectLinear, {2, 0, 0, 3}, {}};
    unit.matrix = {{.op = MatrixOp::Translate, .amount = {0, 0.5F, 0}}};
    const UnitExplanation found = flat.unit(3, 0);
    EXPECT_THAT(found.generates, ElementsAre(true, false, false, false));
    // x runs from -1 to 1: 0.75 at the centre of the last pixel. t is the square's own, 0 to 1.
    EXPECT_TRUE(isNear(found.pixel.given, {0.875F, 0.125F, 0, 1}));
    EXPECT_TRUE(isNear(found.pixel.generated, {4.5F, 0.125F, 0, 1}));
    EXPECT_TRUE(isNear(found.pixel.transformed, {4.5F, 0.625F, 0, 1}));
    for (const CoordinateSteps& corner : found.vertices) {
        EXPECT_TRUE(isNear({corner.generated.s, 0, 0, 0}, {2 * (2 * corner.given.s - 1) + 3, 0, 0, 0}));
        EXPECT_TRUE(isNear(corner.transformed, corner.generated + glm::vec4(0, 0.5F, 0, 0)));
    }
}

TEST(Probe, SaysWhoseTheStepsOfTheMatrixAre) {
    Flat flat;
    flat.scene.passes.push_back(flat.scene.passes[0]);
    flat.scene.passes[0].units[0].matrix = {{.op = MatrixOp::Translate, .amount = {0, 0.5F, 0}}};
    flat.scene.passes[1].units[0].matrixStart = MatrixStart::Push;
    flat.scene.models[0].units[0].matrix.assign(2, {.op = MatrixOp::Scale, .amount = {2, 1, 1}});
    const UnitExplanation found = flat.at(3, 0).fragments.at(1).units.at(0);
    EXPECT_TRUE(isNear(found.pixel.transformed, {3.5F, 0.625F, 0, 1}));
    ASSERT_EQ(found.matrixParts.size(), 2U);
    EXPECT_EQ(found.matrixParts[0].pass, 0);
    EXPECT_EQ(found.matrixParts[0].model, -1);
    EXPECT_EQ(found.matrixParts[0].steps, 1U);
    EXPECT_EQ(found.matrixParts[1].pass, 1);
    EXPECT_EQ(found.matrixParts[1].model, 0);
    EXPECT_EQ(found.matrixParts[1].steps, 2U);
}

// The light stands to the right: (0.6, 0, 0.8). s grows to the right, too, and t upwards.
TEST(Probe, MovesCoordinatesTowardsTheLight) {
    Flat flat;
    flat.scene.light.position = {3, 0, 4, 0};
    Unit& unit = flat.scene.passes[0].units[0];
    EXPECT_FALSE(flat.unit(3, 0).embosses);
    EXPECT_TRUE(isNear(flat.unit(3, 0).pixel.embossed, {0.875F, 0.125F, 0, 1}));
    unit.emboss = {true, 0.1F, LightCarrier::Inverse};
    unit.matrix = {{.op = MatrixOp::Translate, .amount = {0, 0.5F, 0}}};
    UnitExplanation found = flat.unit(3, 0);
    EXPECT_TRUE(found.embosses);
    EXPECT_TRUE(isNear(found.pixel.given, {0.875F, 0.125F, 0, 1}));
    EXPECT_TRUE(isNear(found.pixel.embossed, {0.935F, 0.125F, 0, 1}));
    EXPECT_TRUE(isNear(found.pixel.generated, {0.935F, 0.125F, 0, 1}));
    EXPECT_TRUE(isNear(found.pixel.transformed, {0.935F, 0.625F, 0, 1}));
    EXPECT_NEAR(found.coords.s, 0.935F, 1e-5F);
    // What is generated takes the place of what was moved.
    unit.texGenS = {true, TexGenMode::ObjectLinear, {2, 0, 0, 3}, {}};
    found = flat.unit(3, 0);
    EXPECT_TRUE(isNear(found.pixel.embossed, {0.935F, 0.125F, 0, 1}));
    EXPECT_TRUE(isNear(found.pixel.generated, {4.5F, 0.125F, 0, 1}));
}

/// The same with vertices of its own, at the centres of these pixels of 4 x 4.
struct FlatMesh : Flat {
    FlatMesh(Primitive primitive, const std::vector<glm::vec2>& pixels) {
        MeshData& mesh = scene.models[0].mesh;
        scene.models[0].shape = Shape::Mesh;
        mesh.primitive = primitive;
        for (const glm::vec2& pixel : pixels)
            mesh.positions.emplace_back((pixel + 0.5F) / 2.0F - 1.0F, 0);
    }
};

// From pixel 0 to pixel 3: a third of the way at pixel 1.
TEST(Probe, ExplainsALine) {
    FlatMesh flat(Primitive::Lines, {{0, 3}, {3, 3}, {0, 1}, {3, 1}});
    Model& model = flat.scene.models[0];
    model.mesh.colors = {{0, 0, 0, 1}, {0, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 0.25F}};
    model.mesh.texCoords = {{0, 0, 0, 1}, {0, 0, 0, 1}, {0, 0.25F, 0, 1}, {3, 0.25F, 0, 1}};
    const FragmentExplanation fragment = flat.fragment(1, 1);
    EXPECT_EQ(fragment.shape, Shape::Mesh);
    EXPECT_EQ(fragment.part, 1U);
    EXPECT_EQ(fragment.face, "Line 2");
    EXPECT_TRUE(fragment.coloredVertices);
    EXPECT_TRUE(isNear(fragment.primary, {2.0F / 3, 1.0F / 3, 0, 0.75F}));
    ASSERT_EQ(fragment.vertices.size(), 2U);
    EXPECT_EQ(fragment.vertices[0].vertex, 2U);
    EXPECT_EQ(fragment.vertices[1].vertex, 3U);
    EXPECT_NEAR(fragment.vertices[0].weight, 2.0F / 3, 1e-5F);
    EXPECT_NEAR(fragment.vertices[1].weight, 1.0F / 3, 1e-5F);
    EXPECT_EQ(fragment.vertices[1].primary, glm::vec4(0, 1, 0, 0.25F));
    ASSERT_EQ(fragment.units.size(), 1U);
    ASSERT_EQ(fragment.units[0].vertices.size(), 2U);
    EXPECT_TRUE(isNear(fragment.units[0].pixel.given, {1, 0.25F, 0, 1}));
    EXPECT_NEAR(fragment.units[0].derivatives.dx.s, 1, 1e-5F);
    EXPECT_NEAR(fragment.units[0].derivatives.dy.s, 0, 1e-5F);
    EXPECT_TRUE(flat.at(3, 1).fragments.empty()) << "it ends in that pixel's diamond";
    EXPECT_TRUE(flat.at(1, 2).fragments.empty());
    // Three pixels wide: those above and below are the same.
    model.lineWidth = 3;
    EXPECT_EQ(flat.at(1, 2).fragments.size(), 2U) << "both reach it";
    const FragmentExplanation below = flat.fragment(1, 0);
    EXPECT_TRUE(isNear(below.primary, {2.0F / 3, 1.0F / 3, 0, 0.75F}));
    EXPECT_NEAR(below.vertices[0].weight, 2.0F / 3, 1e-5F);
}

TEST(Probe, ExplainsAPoint) {
    FlatMesh flat(Primitive::Points, {{0, 0}, {2, 2}});
    Model& model = flat.scene.models[0];
    model.mesh.texCoords = {{0, 0, 0, 1}, {0.75F, 0.25F, 0, 1}};
    model.pointSize = 3;
    flat.scene.material.color = {0.5F, 0.25F, 1, 1};
    const FragmentExplanation fragment = flat.fragment(3, 1);
    EXPECT_EQ(fragment.part, 1U);
    EXPECT_EQ(fragment.face, "Points");
    EXPECT_FALSE(fragment.coloredVertices);
    EXPECT_EQ(fragment.primary, glm::vec4(0.5F, 0.25F, 1, 1));
    ASSERT_EQ(fragment.vertices.size(), 1U);
    EXPECT_EQ(fragment.vertices[0].vertex, 1U);
    EXPECT_FLOAT_EQ(fragment.vertices[0].weight, 1);
    ASSERT_EQ(fragment.units.size(), 1U);
    EXPECT_EQ(fragment.units[0].coords, glm::vec3(0.75F, 0.25F, 0));
    EXPECT_EQ(fragment.units[0].derivatives.dx, glm::vec3(0));
    EXPECT_EQ(flat.at(1, 1).fragments.size(), 2U) << "both squares";
}

// 0 1 2, then 2 1 3: the last vertex is the last one of the strip.
TEST(Probe, SaysWhichPartOfAStripItIs) {
    const FlatMesh flat(Primitive::TriangleStrip,
                        {{-0.5F, -0.5F}, {3.5F, -0.5F}, {-0.5F, 3.5F}, {3.5F, 3.5F}});
    const FragmentExplanation first = flat.fragment(0, 0);
    EXPECT_EQ(first.part, 0U);
    const FragmentExplanation second = flat.fragment(3, 3);
    EXPECT_EQ(second.part, 1U);
    ASSERT_EQ(second.vertices.size(), 3U);
    EXPECT_EQ(second.vertices[0].vertex, 2U);
    EXPECT_EQ(second.vertices[1].vertex, 1U);
    EXPECT_EQ(second.vertices[2].vertex, 3U);
}

TEST(Probe, FindsTheModelsThatAPassNames) {
    Flat flat;
    flat.scene.models.resize(3, flat.scene.models[0]);
    flat.scene.passes[0].models = {2, 0};
    const Explanation found = flat.at(1, 1);
    ASSERT_EQ(found.fragments.size(), 2U);
    EXPECT_EQ(found.fragments[0].model, 2);
    EXPECT_EQ(found.fragments[1].model, 0);
    flat.scene.models[2].visible = false;
    EXPECT_EQ(flat.fragment(1, 1).model, 0);
}

// Of a material of the model's own, which tracks no colour: 0.25 of the scene's ambient light, and what it
// shines.
TEST(Probe, TakesTheModelsOwnMaterial) {
    Flat flat;
    flat.scene.passes[0].lighting = true;
    flat.scene.light.position = {0, 0, -1, 0}; // from behind
    flat.scene.light.modelAmbient = {0.5F, 0.5F, 0.5F, 1};
    flat.scene.material.emission = {1, 1, 1, 1};
    Model& model = flat.scene.models[0];
    model.ownMaterial = true;
    model.material.colorMaterial = false;
    model.material.ambient = {0.25F, 0.25F, 0.25F, 1};
    model.material.diffuse = {1, 1, 1, 0.5F};
    model.material.emission = {0.5F, 0, 0.125F, 1};
    const FragmentExplanation fragment = flat.fragment(0, 0);
    for (const VertexExplanation& vertex : fragment.vertices) {
        ASSERT_TRUE(vertex.lighting);
        EXPECT_TRUE(isNear({vertex.lighting->emission, 0}, {0.5F, 0, 0.125F, 0}));
        EXPECT_TRUE(isNear({vertex.lighting->scene, 0}, {0.125F, 0.125F, 0.125F, 0}));
    }
    EXPECT_TRUE(isNear(fragment.primary, {0.625F, 0.125F, 0.25F, 0.5F}));
}

// The square faces the viewer, and so does the light: n . VP = n . h = 1.
TEST(Probe, TakesTheLightApart) {
    Flat flat;
    flat.scene.passes[0].lighting = true;
    flat.scene.light.ambient = {0.1F, 0.1F, 0.1F, 1};
    flat.scene.light.diffuse = {0.5F, 0.25F, 0, 1};
    flat.scene.light.modelAmbient = {0.2F, 0.2F, 0.2F, 1};
    flat.scene.light.colorControl = ColorControl::SeparateSpecular;
    flat.scene.material.color = {0.5F, 1, 1, 0.75F};
    flat.scene.material.specular = {0.25F, 0.25F, 0.25F, 1};
    flat.scene.passes[0].units[0].envMode = EnvMode::Modulate;
    const FragmentExplanation fragment = flat.fragment(0, 0);
    for (const VertexExplanation& vertex : fragment.vertices) {
        ASSERT_TRUE(vertex.lighting);
        EXPECT_TRUE(isNear({vertex.lighting->scene, 0}, {0.1F, 0.2F, 0.2F, 0}));
        EXPECT_TRUE(isNear({vertex.lighting->ambient, 0}, {0.05F, 0.1F, 0.1F, 0}));
        EXPECT_TRUE(isNear({vertex.lighting->diffuse, 0}, {0.25F, 0.25F, 0, 0}));
        EXPECT_TRUE(isNear({vertex.lighting->specular, 0}, {0.25F, 0.25F, 0.25F, 0}));
        EXPECT_FLOAT_EQ(vertex.lighting->nDotVP, 1);
    }
    EXPECT_TRUE(isNear(fragment.primary, {0.4F, 0.55F, 0.3F, 0.75F}));
    EXPECT_TRUE(isNear(fragment.secondary, {0.25F, 0.25F, 0.25F, 0}));
    // times 0.175 of the texture, and the secondary colour
    EXPECT_TRUE(isNear(fragment.textured, {0.07F, 0.09625F, 0.0525F, 0.75F}));
    EXPECT_TRUE(isNear(fragment.color, {0.32F, 0.34625F, 0.3025F, 0.75F}));
    ASSERT_EQ(fragment.units.size(), 1U);
    EXPECT_EQ(fragment.units[0].equations.color.symbols, "Cv = Cp * Cs");
    EXPECT_EQ(fragment.units[0].equations.color.numbers.at(0), "0.4 * 0.175 = 0.07");
}

// The eye is at a distance of 1 from the square's plane: (3 - 1) / (3 - -1) of a colour is left.
TEST(Probe, TakesTheFogApart) {
    Flat flat;
    flat.scene.passes[0].units[0].enabled = false;
    flat.scene.material.color = {0.5F, 1, 0, 0.75F};
    EXPECT_FALSE(flat.fragment(0, 0).fog);
    flat.scene.passes[0].fog = {true, FogMode::Linear, 1, -1, 3, {1, 0.5F, 2, 0}};
    const FragmentExplanation fragment = flat.fragment(0, 0);
    ASSERT_TRUE(fragment.fog);
    EXPECT_FLOAT_EQ(fragment.fog->distance, 1);
    EXPECT_FLOAT_EQ(fragment.fog->factor, 0.5F);
    EXPECT_THAT(fragment.fog->equation.numbers, ElementsAre("(3 - 1) / (3 - -1) = 0.5"));
    EXPECT_TRUE(isNear(fragment.summed, {0.5F, 1, 0, 0.75F}));
    EXPECT_TRUE(isNear(fragment.color, {0.75F, 0.75F, 0.5F, 0.75F}));
    EXPECT_FLOAT_EQ(fragment.alphaTest.value, 0.75F);
}

TEST(Probe, SaysWhichSideIsSeen) {
    Flat flat;
    flat.scene.passes[0].lighting = true;
    flat.scene.light.modelAmbient = {0, 0, 0, 1};
    for (const bool turned : {false, true}) {
        for (const bool twoSide : {false, true}) {
            flat.scene.models[0].rotation = {0, turned ? 180.0F : 0.0F, 0};
            flat.scene.light.twoSide = twoSide;
            const FragmentExplanation fragment = flat.fragment(1, 1);
            EXPECT_EQ(fragment.fromBehind, turned);
            EXPECT_EQ(fragment.twoSided, twoSide);
            const float cosine = turned && !twoSide ? 0 : 1;
            EXPECT_TRUE(isNear(fragment.primary, {cosine, cosine, cosine, 1}));
            float shares = 0;
            for (const VertexExplanation& vertex : fragment.vertices) {
                ASSERT_TRUE(vertex.lighting);
                EXPECT_FLOAT_EQ(vertex.lighting->nDotVP, cosine);
                EXPECT_TRUE(isNear(vertex.primary, {cosine, cosine, cosine, 1}));
                shares += vertex.weight;
            }
            EXPECT_NEAR(shares, 1, 1e-5F);
        }
    }
}

TEST(Probe, ComparesWhatTheTestsCompare) {
    Flat flat;
    Pass& pass = flat.scene.passes[0];
    pass.depthTest = pass.alphaTest = true;
    pass.alphaFunc = CompareFunc::Less;
    pass.alphaRef = 0.5F;
    flat.scene.view.background = {0, 0, 1, 1};
    FragmentExplanation fragment = flat.fragment(0, 0);
    EXPECT_EQ(fragment.outcome, FragmentOutcome::FailedAlphaTest);
    EXPECT_FLOAT_EQ(fragment.alphaTest.value, 1);
    EXPECT_FLOAT_EQ(fragment.alphaTest.with, 0.5F);
    EXPECT_THAT(fragment.after, ElementsAre(0, 0, 255, 255));

    pass.alphaTest = false;
    flat.scene.passes.push_back(pass); // the same again is not LESS
    const Explanation both = flat.at(0, 0);
    ASSERT_EQ(both.fragments.size(), 2U);
    EXPECT_EQ(both.fragments[0].outcome, FragmentOutcome::Drawn);
    EXPECT_EQ(both.fragments[0].depthTest.with, (1U << 24) - 1);
    EXPECT_EQ(both.fragments[1].outcome, FragmentOutcome::FailedDepthTest);
    EXPECT_EQ(both.fragments[1].depthTest.value, both.fragments[0].depthTest.value);
    EXPECT_EQ(both.fragments[1].depthTest.with, both.fragments[0].depthTest.value);
    EXPECT_EQ(both.seen(), &both.fragments[0]);

    flat.scene.passes[0].enabled = false;
    const Explanation one = flat.at(0, 0);
    ASSERT_EQ(one.fragments.size(), 1U);
    EXPECT_EQ(one.fragments[0].pass, 1);
    EXPECT_EQ(one.fragments[0].outcome, FragmentOutcome::Drawn);
}

TEST(Probe, Blends) {
    Flat flat;
    Pass& pass = flat.scene.passes[0];
    pass.blend = true;
    pass.blendSrc = BlendFactor::SrcAlpha;
    pass.blendDst = BlendFactor::OneMinusSrcAlpha;
    flat.scene.view.background = {1, 1, 1, 1};
    flat.scene.textures[0].internalFormat = InternalFormat::Intensity;
    const BlendExplanation blend = flat.fragment(0, 0).blend;
    EXPECT_TRUE(isNear(blend.source, glm::vec4(0.175F)));
    EXPECT_TRUE(isNear(blend.sourceWeight, glm::vec4(0.175F)));
    EXPECT_TRUE(isNear(blend.destinationWeight, glm::vec4(0.825F)));
    EXPECT_TRUE(isNear(blend.result, glm::vec4(0.175F * 0.175F + 0.825F)));
}

TEST(Probe, SaysWhyAUnitDoesNothing) {
    Flat flat;
    flat.scene.textures[0].minFilter = MinFilter::LinearMipmapLinear; // and there is one level
    flat.scene.passes[0].units[2].enabled = true;
    flat.scene.passes[0].units[2].texture = 7;
    const FragmentExplanation fragment = flat.fragment(0, 0);
    EXPECT_TRUE(fragment.units.empty());
    ASSERT_EQ(fragment.idle.size(), 2U);
    EXPECT_EQ(fragment.idle[0].unit, 0);
    EXPECT_THAT(fragment.idle[0].reason, HasSubstr("textures[0] is incomplete: "));
    EXPECT_EQ(fragment.idle[1].unit, 2);
    EXPECT_THAT(fragment.idle[1].reason, HasSubstr("no textures[7]"));
}

TEST(Probe, FindsTheBackgroundWhereNothingIsDrawn) {
    Flat flat;
    flat.scene.models.clear();
    flat.scene.view.background = {1, 0.2F, 0, 1};
    const Explanation found = flat.at(1, 2);
    EXPECT_TRUE(found.fragments.empty());
    EXPECT_EQ(found.seen(), nullptr);
    EXPECT_THAT(found.bytes, ElementsAre(255, 51, 0, 255));
}

struct Refused {
    const char* name;
    int width;
    int height;
    PixelPlace pixel;
    const char* expected;
};
class BadPixel : public testing::TestWithParam<Refused> {};
TEST_P(BadPixel, IsRefusedWithItsNumbers) {
    const auto& [name, width, height, pixel, expected] = GetParam();
    const Result<Explanation> found = probe({defaultScene(), {}, 0, width, height}, pixel);
    ASSERT_FALSE(found);
    EXPECT_EQ(found.error().code, ErrorCode::OutOfRange);
    EXPECT_THAT(found.error().message, HasSubstr(expected));
}
INSTANTIATE_TEST_SUITE_P(
    All, BadPixel,
    testing::Values(Refused{"Left", 8, 4, {-1, 0}, "8 × 4 has no pixel -1, 0"},
                    Refused{"Right", 8, 4, {8, 0}, "8 × 4 has no pixel 8, 0"},
                    Refused{"Above", 8, 4, {0, 4}, "8 × 4 has no pixel 0, 4"},
                    Refused{"Far", 8, 4, {0, std::numeric_limits<int>::min()}, "has no pixel 0, -2147483648"},
                    Refused{"NoPicture", 0, 4, {0, 0}, "1 × 1 to 16384 × 16384"},
                    Refused{"TooLarge", 20000, 4, {0, 0}, "1 × 1 to 16384 × 16384"}),
    [](const auto& test) { return std::string(test.param.name); });

// ---- What is explained is what is drawn ----

struct Case {
    const char* name;
    void (*change)(Scene& scene);
    AnisotropyMethod anisotropy = AnisotropyMethod::Probes;
};
class EveryPixel : public testing::TestWithParam<Case> {};

TEST_P(EveryPixel, HasTheBytesOfThePicture) {
    const auto& [name, change, anisotropy] = GetParam();
    Scene scene = defaultScene();
    change(scene);
    constexpr int width = 40;
    constexpr int height = 24;
    const DrawRequest request{scene, {}, 0.75, width, height, anisotropy};
    const Result<Frame> drawn = drawReference(request);
    ASSERT_TRUE(drawn);
    ReferenceRenderer renderer;
    std::size_t fragments = 0;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const Result<Explanation> found = renderer.probe(request, {x, y});
            ASSERT_TRUE(found) << describe(found.error());
            for (std::size_t i = 0; i < 4; ++i)
                ASSERT_EQ(found->bytes[i], std::to_integer<int>(drawn->image.at(x, y)[i])) << x << ", " << y;
            EXPECT_EQ(found->problems, drawn->problems);
            fragments += found->fragments.size();
            PixelBytes before{};
            for (std::size_t i = 0; i < 4; ++i)
                before[i] = static_cast<std::uint8_t>(
                    std::clamp(scene.view.background[static_cast<int>(i)], 0.0F, 1.0F) * 255 + 0.5F);
            for (const FragmentExplanation& fragment : found->fragments) {
                EXPECT_EQ(fragment.before, before);
                before = fragment.after;
                // The steps add up to what is drawn.
                const glm::vec4 sum = glm::clamp(fragment.textured + fragment.secondary, 0.0F, 1.0F);
                EXPECT_TRUE(isNear(sum, fragment.summed, 2e-3F)) << x << ", " << y;
                EXPECT_TRUE(fragment.fog || fragment.summed == fragment.color);
                for (const UnitExplanation& unit : fragment.units) {
                    float weights = 0;
                    for (const Tap& tap : unit.sample.taps)
                        weights += tap.weight;
                    EXPECT_NEAR(weights, 1, 1e-4F) << x << ", " << y;
                    EXPECT_EQ(unit.inputs.source, unit.sample.color);
                }
            }
            EXPECT_EQ(before, found->bytes);
        }
    }
    EXPECT_GT(fragments, 50U);
}

void showOnly(Scene& scene, Shape shape) {
    scene.models.resize(1);
    scene.models[0] = Model{};
    scene.models[0].shape = shape;
}

/// Eight vertices in two rows, with all that a vertex may have, near to the camera and far away.
void showMesh(Scene& scene, Primitive primitive) {
    showOnly(scene, Shape::Mesh);
    MeshData& mesh = scene.models[0].mesh;
    mesh.primitive = primitive;
    for (int i = 0; i < 8; ++i) {
        const auto at = static_cast<float>(i);
        mesh.positions.emplace_back(at / 2 - 1.75F, i % 2 == 0 ? -1.5F : 1.25F, 2 - at / 2);
        mesh.normals.emplace_back(at / 8 - 0.5F, 0.25F, 1);
        mesh.colors.emplace_back(at / 8, 1 - at / 8, i % 2 == 0 ? 0.25F : 1.0F, 1);
        mesh.texCoords.emplace_back(at / 2, i % 2 == 0 ? 0 : 2, 0, 1 + at / 8);
    }
    scene.models[0].lineWidth = 5;
    scene.models[0].pointSize = 4;
}

INSTANTIATE_TEST_SUITE_P(
    Models, EveryPixel,
    testing::Values(Case{"Points",
                         [](Scene& it) {
                             showMesh(it, Primitive::Points);
                             it.models[0].pointSize = 7;
                         }},
                    Case{"Lines", [](Scene& it) { showMesh(it, Primitive::Lines); }},
                    Case{"ThinLines",
                         [](Scene& it) {
                             showMesh(it, Primitive::LineLoop);
                             it.models[0].lineWidth = 1;
                         }},
                    Case{"EvenLines",
                         [](Scene& it) {
                             showMesh(it, Primitive::LineStrip);
                             it.models[0].lineWidth = 4;
                             it.passes[0].lighting = false;
                         }},
                    Case{"FlatLines",
                         [](Scene& it) {
                             showMesh(it, Primitive::LineLoop);
                             it.material.shadeModel = ShadeModel::Flat;
                         }},
                    Case{"LinesAcrossTheEye",
                         [](Scene& it) {
                             showMesh(it, Primitive::LineStrip);
                             it.view.distance = 1;
                         }},
                    Case{"LinesStraightAcross",
                         [](Scene& it) {
                             showMesh(it, Primitive::LineStrip);
                             it.view.perspectiveHint = HintMode::Fastest;
                         }},
                    Case{"BlendedPoints",
                         [](Scene& it) {
                             showMesh(it, Primitive::Points);
                             it.models[0].pointSize = 12;
                             it.passes[0].blend = true;
                             it.passes[0].blendSrc = BlendFactor::OneMinusDstColor;
                             it.passes[0].blendDst = BlendFactor::One;
                         }},
                    Case{"Fan", [](Scene& it) { showMesh(it, Primitive::TriangleFan); }},
                    Case{"QuadStrip",
                         [](Scene& it) {
                             showMesh(it, Primitive::QuadStrip);
                             it.material.shadeModel = ShadeModel::Flat;
                         }},
                    Case{"Torus", [](Scene& it) { showOnly(it, Shape::Torus); }},
                    Case{"Teapot",
                         [](Scene& it) {
                             showOnly(it, Shape::Teapot);
                             it.models[0].slices = 8;
                             it.models[0].stacks = minStacks;
                         }},
                    Case{"Cone",
                         [](Scene& it) {
                             showOnly(it, Shape::Cylinder);
                             it.models[0].topRadius = 0;
                             it.models[0].scale = {1.5F, 1, 0.5F};
                         }},
                    Case{"Embossed",
                         [](Scene& it) {
                             it.passes[0].units[0].emboss = {true, 0.1F, LightCarrier::Inverse};
                             it.passes[0].units[1] = it.passes[0].units[0];
                             it.passes[0].units[1].emboss.carrier = LightCarrier::Transpose;
                         }},
                    Case{"Materials",
                         [](Scene& it) {
                             it.material.colorMaterial = false;
                             it.models[1].ownMaterial = true;
                             it.models[1].material.emission = {0.5F, 0.25F, 0, 1};
                         }},
                    Case{"NamedModels",
                         [](Scene& it) {
                             it.passes.resize(2, it.passes[0]);
                             it.passes[0].models = {1};
                             it.passes[1].models = {1, 0};
                             it.passes[1].depthFunc = CompareFunc::LessEqual;
                         }},
                    Case{"BeforeTheEye",
                         [](Scene& it) {
                             it.view.roll = 30;
                             it.models[0].attachment = Attachment::Eye;
                             it.models[0].position.z = -5;
                             it.models[0].rotationOrder = RotationOrder::Xzy;
                         }}),
    [](const auto& test) { return std::string(test.param.name); });

INSTANTIATE_TEST_SUITE_P(
    All, EveryPixel,
    testing::Values(Case{"Default", [](Scene&) {}},
                    Case{"Fog",
                         [](Scene& it) {
                             it.passes[0].fog = {true, FogMode::Exp2, 0.15F, 0, 1, {0.5F, 0.75F, 2, 1}};
                         }},
                    Case{"FogStraightAcross",
                         [](Scene& it) {
                             showOnly(it, Shape::Floor);
                             it.view.perspectiveHint = HintMode::Fastest;
                             it.passes[0].fog = {true, FogMode::Linear, 1, 3, 30, {0.5F, 0.75F, 2, 1}};
                         }},
                    Case{"TwoSides",
                         [](Scene& it) {
                             showOnly(it, Shape::Cylinder);
                             it.models[0].rotation = {50, 0, 0};
                             it.light.twoSide = true;
                             it.light.colorControl = ColorControl::SeparateSpecular;
                         }},
                    Case{"Floor", [](Scene& it) { showOnly(it, Shape::Floor); }},
                    Case{"Anisotropic",
                         [](Scene& it) {
                             showOnly(it, Shape::Floor);
                             it.textures[0].maxAnisotropy = 8;
                         }},
                    Case{"AnisotropicEllipse",
                         [](Scene& it) {
                             showOnly(it, Shape::Floor);
                             it.textures[0].maxAnisotropy = 8;
                         },
                         AnisotropyMethod::Ellipse},
                    Case{"Affine",
                         [](Scene& it) {
                             showOnly(it, Shape::Floor);
                             it.view.perspectiveHint = HintMode::Fastest;
                         }},
                    Case{"CubeMap",
                         [](Scene& it) {
                             it.passes[0].units[0].target = Target::CubeMap;
                             it.textures[0].pattern = Pattern::CubeFaces;
                             for (TexGen Unit::*each : {&Unit::texGenS, &Unit::texGenT, &Unit::texGenR})
                                 it.passes[0].units[0].*each = {true, TexGenMode::NormalMap, {}, {}};
                         }},
                    Case{"SeamlessCubeMap",
                         [](Scene& it) {
                             it.passes[0].seamlessCubeMap = true;
                             it.passes[0].units[0].target = Target::CubeMap;
                             it.textures[0].pattern = Pattern::CubeFaces;
                             it.textures[0].baseLevel = 6;
                             it.textures[0].maxAnisotropy = 4;
                             for (TexGen Unit::*each : {&Unit::texGenS, &Unit::texGenT, &Unit::texGenR})
                                 it.passes[0].units[0].*each = {true, TexGenMode::NormalMap, {}, {}};
                         }},
                    Case{"Border",
                         [](Scene& it) {
                             it.textures[0].border = 1;
                             it.textures[0].wrapS = it.textures[0].wrapT = Wrap::Clamp;
                         }},
                    Case{"EyeInside", [](Scene& it) { it.view.distance = 0.5F; }},
                    Case{"Flat",
                         [](Scene& it) {
                             it.material.shadeModel = ShadeModel::Flat;
                             it.models[1].spin = {10, 20, 30};
                         }},
                    Case{"SeparateSpecular",
                         [](Scene& it) { it.light.colorControl = ColorControl::SeparateSpecular; }},
                    Case{"TwoPasses",
                         [](Scene& it) {
                             it.passes.push_back(it.passes[0]);
                             it.passes[1].blend = true;
                             it.passes[1].blendSrc = BlendFactor::OneMinusDstColor;
                             it.passes[1].blendDst = BlendFactor::One;
                             it.passes[1].depthFunc = CompareFunc::LessEqual;
                             it.passes[1].units[0].texGenS = {true, TexGenMode::SphereMap, {}, {}};
                             it.passes[1].units[0].texGenT = {true, TexGenMode::SphereMap, {}, {}};
                         }},
                    Case{"Transparent",
                         [](Scene& it) {
                             it.material.color.a = 0.4F;
                             it.passes[0].depthTest = false;
                             it.passes[0].blend = true;
                             it.passes[0].blendSrc = BlendFactor::SrcAlpha;
                             it.passes[0].blendDst = BlendFactor::OneMinusSrcAlpha;
                         }},
                    Case{"AlphaTest",
                         [](Scene& it) {
                             it.textures[0].internalFormat = InternalFormat::Intensity;
                             it.passes[0].alphaTest = true;
                             it.passes[0].alphaFunc = CompareFunc::Greater;
                             it.passes[0].alphaRef = 0.6F;
                         }},
                    Case{"Combine",
                         [](Scene& it) {
                             Unit& first = it.passes[0].units[0];
                             Unit& second = it.passes[0].units[1];
                             second = first;
                             second.envMode = EnvMode::Combine;
                             second.combine.rgb = CombineRgb::Dot3Rgba;
                             second.combine.source1Rgb = CombineSource::Texture0;
                             second.combine.rgbScale = CombineScale::Two;
                             second.matrix = {{.op = MatrixOp::Rotate, .amount = {0, 0, 1}, .angle = 30}};
                         }},
                    Case{"Incomplete", [](Scene& it) { it.textures[0].mipmaps = MipPolicy::None; }},
                    Case{"NanCoordinates",
                         [](Scene& it) {
                             it.models[0].texCoords[0] = TexCoords(24, glm::vec4(nan));
                             it.models[1].position.x = infinity;
                         }}),
    [](const auto& test) { return std::string(test.param.name); });

} // namespace
} // namespace texplorer::reference::probe_test

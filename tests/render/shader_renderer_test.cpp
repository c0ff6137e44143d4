// The shader renderer against fixed function, and while its files are edited.

#include "app/render/fixed_renderer.h"
#include "app/render/shader_renderer.h"
#include "tests/support/flat_scene.h"
#include "tests/support/render_fixture.h"
#include "tests/support/temp_dir.h"
#include "texplorer/files/file_io.h"
#include "texplorer/glsl/shader_pieces.h"
#include "texplorer/mesh/mesh.h"
#include "texplorer/reference/draw.h"
#include "texplorer/scene/params/json.h"

#include <gmock/gmock.h>

#include <chrono>
#include <random>
#include <thread>

namespace texplorer::shader_renderer_test {
namespace {

using namespace test;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class Dice {
public:
    explicit Dice(unsigned seed)
        : engine_(seed) {}
    int below(int count) { return static_cast<int>(engine_() % static_cast<unsigned>(count)); }
    bool chance(int oneIn) { return below(oneIn) == 0; }
    float number(float low, float high) {
        return low + (high - low) * static_cast<float>(below(1024)) / 1023.0F;
    }
    glm::vec4 color() { return {number(0, 1), number(0, 1), number(0, 1), number(0, 1)}; }
    template<Enumerated E>
    E any() {
        const std::span<const EnumRow> rows = EnumTable<E>::rows;
        return static_cast<E>(rows[static_cast<std::size_t>(below(static_cast<int>(rows.size())))].value);
    }

private:
    std::minstd_rand engine_;
};

CombineSource anySource(Dice& dice, int units) {
    // The texture of a disabled unit is undefined.
    const auto source = dice.any<CombineSource>();
    const auto first = static_cast<int>(CombineSource::Texture0);
    return static_cast<int>(source) - first >= units && static_cast<int>(source) - first < maxUnits
               ? CombineSource::Previous
               : source;
}

Combine anyCombine(Dice& dice, int units) {
    Combine c;
    c.rgb = dice.any<CombineRgb>();
    c.alpha = dice.any<CombineAlpha>();
    for (CombineSource* source :
         {&c.source0Rgb, &c.source1Rgb, &c.source2Rgb, &c.source0Alpha, &c.source1Alpha, &c.source2Alpha})
        *source = anySource(dice, units);
    for (OperandRgb* operand : {&c.operand0Rgb, &c.operand1Rgb, &c.operand2Rgb})
        *operand = dice.any<OperandRgb>();
    for (OperandAlpha* operand : {&c.operand0Alpha, &c.operand1Alpha, &c.operand2Alpha})
        *operand = dice.any<OperandAlpha>();
    c.rgbScale = dice.any<CombineScale>();
    c.alphaScale = dice.any<CombineScale>();
    return c;
}

void generate(Dice& dice, TexGen& generated, std::span<const EnumRow> modes) {
    generated.enabled = dice.chance(4);
    const int mode = dice.below(static_cast<int>(modes.size()));
    generated.mode = static_cast<TexGenMode>(modes[static_cast<std::size_t>(mode)].value);
    generated.objectPlane = dice.color();
    generated.eyePlane = dice.color();
}

Unit anyUnit(Dice& dice, int texture, int units) {
    Unit unit;
    unit.enabled = true;
    unit.texture = texture;
    unit.target = dice.any<Target>();
    unit.envMode = dice.any<EnvMode>();
    unit.envColor = dice.color();
    unit.combine = anyCombine(dice, units);
    // Mesa keeps the bias of fixed function in 256ths, a shader's as it is.
    unit.lodBias = dice.chance(4) ? static_cast<float>(dice.below(512) - 256) / 256 : 0;
    generate(dice, unit.texGenS, EnumTable<TexGenMode>::rows);
    generate(dice, unit.texGenT, EnumTable<TexGenMode>::rows);
    generate(dice, unit.texGenR, texGenModesOfR);
    if (dice.chance(3))
        unit.matrix = {{.op = dice.any<MatrixOp>(),
                        .amount = {dice.number(0.5F, 2), dice.number(0.5F, 2), dice.number(0.5F, 2)},
                        .angle = dice.number(0, 360)}};
    return unit;
}

Scene anyScene(unsigned seed) {
    Dice dice(seed);
    Scene scene = defaultScene();
    scene.view.azimuth = dice.number(-90, 90);
    scene.view.elevation = dice.number(-40, 40);
    scene.view.background = dice.color();
    scene.material = {.color = dice.color(),
                      .colorMaterial = !dice.chance(3),
                      .ambient = dice.color(),
                      .diffuse = dice.color(),
                      .specular = dice.color(),
                      .emission = dice.chance(2) ? glm::vec4(0, 0, 0, 1) : dice.color(),
                      .shininess = dice.number(0, 40),
                      .shadeModel = dice.any<ShadeModel>()};
    scene.light = {
        .position = {dice.number(-3, 3), dice.number(-3, 3), dice.number(0, 3), dice.chance(2) ? 0.0F : 1.0F},
        .ambient = dice.color(),
        .diffuse = dice.color(),
        .specular = dice.color(),
        .colorControl = dice.any<ColorControl>(),
        .localViewer = dice.chance(2)};
    Pass& pass = scene.passes[0];
    pass.lighting = dice.chance(2);
    pass.alphaTest = dice.chance(4);
    pass.alphaFunc = dice.any<CompareFunc>();
    pass.alphaRef = dice.number(0, 1);
    const int units = 1 + dice.below(3);
    scene.textures.resize(static_cast<std::size_t>(units), scene.textures[0]);
    for (int i = 0; i < units; ++i) {
        Texture& texture = scene.textures[static_cast<std::size_t>(i)];
        texture.pattern = dice.any<Pattern>();
        texture.internalFormat = internalFormat(dice.any<BaseFormat>());
        texture.minFilter = dice.any<MinFilter>();
        texture.magFilter = dice.any<MagFilter>();
        texture.wrapS = dice.any<Wrap>();
        texture.wrapT = dice.any<Wrap>();
        texture.wrapR = dice.any<Wrap>();
        texture.borderColor = dice.color();
        // Incomplete with four of the six filters. Only with one unit: the texture of another unit would be
        // undefined.
        if (units == 1 && dice.chance(4))
            texture.mipmaps = MipPolicy::None;
        const Unit& unit = pass.units[static_cast<std::size_t>(i)] = anyUnit(dice, i, units);
        // Faces that are not square are incomplete, too.
        for (Image image = drawPattern(texture.pattern);
             unit.target == Target::CubeMap && image.width != image.height;
             image = drawPattern(texture.pattern))
            texture.pattern = dice.any<Pattern>();
    }
    return scene;
}

/// How many pixels differ by more than one 255th.
int differing(const Image& a, const Image& b) {
    int count = 0;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x)
            count += isColor(colorAt(a, x, y), colorAt(b, x, y)) ? 0 : 1;
    return count;
}

class ShaderAgainstFixed : public RenderTest {
protected:
    Image drawnBy(render::SceneRenderer& other, const Scene& scene, int extent) {
        const Result<view::Frame> frame = other.draw(scene, images, 0, {extent, extent});
        EXPECT_TRUE(frame) << describe(frame.error());
        EXPECT_THAT(frame->problems, IsEmpty());
        return other.read().value_or(Image());
    }
};

// Everything is exact except for the picture's rounding, unless a coordinate is on the edge between two
// texels for a whole face: where r is 0, in the middle of a face of a cube map. There the last bit decides;
// the allowed share of pixels is for this.
TEST_F(ShaderAgainstFixed, AnySceneIsTheSameWithinARounding) {
    constexpr int extent = 96;
    constexpr int scenes = 36;
    auto fixed = render::FixedRenderer::create(capabilities);
    auto shader = render::ShaderRenderer::create(capabilities);
    ASSERT_TRUE(fixed && shader);
    int inAll = 0;
    int exact = 0;
    for (unsigned seed = 1; seed <= scenes; ++seed) {
        const Scene scene = anyScene(seed);
        const int different = differing(drawnBy(*fixed, scene, extent), drawnBy(*shader, scene, extent));
        EXPECT_LE(different, extent * extent / 200) << "scene " << seed << ": " << writeScene(scene);
        inAll += different;
        exact += different == 0 ? 1 : 0;
    }
    EXPECT_LE(inAll, scenes * extent * extent / 10000);
    EXPECT_GE(exact, scenes * 9 / 10);
}

/// Cases where a driver's arithmetic is no reference: its result for vectors without a direction is
/// undefined.
class ShaderAgainstReference : public RenderTest {
protected:
    void agree(const Scene& scene) {
        constexpr int extent = 32;
        auto shader = render::ShaderRenderer::create(capabilities);
        ASSERT_TRUE(shader);
        const Result<view::Frame> frame = shader->draw(scene, images, 0, {extent, extent});
        ASSERT_TRUE(frame) << describe(frame.error());
        EXPECT_THAT(frame->problems, IsEmpty());
        const Result<Frame> drawn = reference::drawReference({scene, images, 0, extent, extent});
        ASSERT_TRUE(drawn);
        EXPECT_LE(differing(shader->read().value_or(Image()), drawn->image), extent * extent / 100);
    }
    static Scene litScene() {
        Scene scene = flatScene();
        scene.passes[0].lighting = true;
        scene.light.diffuse = {0.25F, 0.5F, 0.75F, 1};
        scene.material.specular = {1, 1, 1, 1};
        scene.material.shininess = 8;
        return scene;
    }
};

TEST_F(ShaderAgainstReference, ALightWithoutADirectionGivesAmbientLight) {
    Scene scene = litScene();
    scene.light.position = {0, 0, 0, 0};
    agree(scene);
    scene.light.localViewer = true;
    agree(scene);
}

// The light is behind the surface, opposite to the viewer: their half-way vector has no direction.
TEST_F(ShaderAgainstReference, ALightOppositeToTheViewerGivesNoHighlight) {
    Scene scene = litScene();
    scene.light.position = {0, 0, -1, 0};
    scene.models[0].rotation = {0, 180, 0};
    agree(scene);
}

TEST_F(ShaderAgainstReference, AVertexAtTheEyeHasNoDirection) {
    for (const TexGenMode mode : {TexGenMode::SphereMap, TexGenMode::ReflectionMap}) {
        Scene scene = texturedScene();
        scene.textures[0].source = SourceKind::Pattern;
        scene.textures[0].pattern = Pattern::UvTemplate;
        const Vertex corner = makeMesh({Shape::Quad}).vertices.front();
        scene.models[0].position = glm::vec3(0, 0, scene.view.distance) - corner.position;
        scene.passes[0].units[0].texGenS = {.enabled = true, .mode = mode};
        scene.passes[0].units[0].texGenT = {.enabled = true, .mode = mode};
        agree(scene);
    }
}

// Red -1 times white is clamped to 0 before the next unit adds to it.
TEST_F(ShaderAgainstReference, NegativeTexelsDoNotReachTheNextUnit) {
    for (const BlockFormat format : {BlockFormat::Bc4Signed, BlockFormat::Bc5Signed}) {
        BlockImage blocks = BlockImage::uninitialised(format, 4, 4);
        std::ranges::fill(blocks.blocks, std::byte{0});
        for (std::size_t i = 0; i < blocks.blocks.size(); i += 8)
            blocks.blocks[i] = blocks.blocks[i + 1] = std::byte{0x81}; // both ends -127
        TextureImage file;
        file.surfaces.emplace_back(std::move(blocks));
        images.put("signed", std::move(file));
        images.put("image", plainImage(1, 1, {128, 64, 32, 255}));
        for (const EnvMode mode : {EnvMode::Modulate, EnvMode::Replace, EnvMode::Blend, EnvMode::Add}) {
            Scene scene = texturedScene();
            scene.textures.push_back(scene.textures[0]);
            scene.textures[0].file = "signed";
            scene.passes[0].units[0].envMode = mode;
            scene.passes[0].units[0].envColor = {1, 1, 1, 1};
            scene.passes[0].units[1] = {.enabled = true, .texture = 1, .envMode = EnvMode::Add};
            scene.material.color = {0.5F, 0.5F, 0.5F, 1};
            agree(scene);
        }
    }
}

/// A folder with the shaders; a test can replace one of their lines.
class EditedShaders : public RenderTest {
protected:
    void SetUp() override {
        RenderTest::SetUp();
        for (const glsl::ShaderFile& file : glsl::embeddedShaderFiles())
            ASSERT_TRUE(writeFileAtomically(folder.path() / file.name, viewBytes(file.text)));
        auto made = render::ShaderRenderer::create(capabilities, {folder.path(), {}});
        ASSERT_TRUE(made);
        renderer = std::move(*made);
    }

    void replace(const char* name, std::string_view from, std::string_view to) {
        std::string text = readText(folder.path() / name).value();
        const std::size_t at = text.find(from);
        ASSERT_NE(at, std::string::npos);
        text.replace(at, from.size(), to);
        ASSERT_TRUE(writeFileAtomically(folder.path() / name, viewBytes(text)));
    }

    /// Draws until the picture has this colour: a watcher has to notice that a file has changed.
    bool becomes(glm::vec4 color) {
        return within([&] { return bool(isColor(onlyColor(flatScene()), color)); });
    }
    bool within(auto condition) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
        while (!condition()) {
            if (std::chrono::steady_clock::now() > end)
                return false;
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        return true;
    }

    test::TempDir folder;
};

TEST_F(EditedShaders, AreReadWhileTheyChange) {
    EXPECT_TRUE(isColor(onlyColor(flatScene()), {1, 1, 1, 1}));
    replace("fragment.glsl", "fragmentColor = color;", "fragmentColor = vec4(0.2, 0.4, 0.6, 1.0);");
    EXPECT_TRUE(becomes({0.2F, 0.4F, 0.6F, 1}));
    EXPECT_THAT(problems, IsEmpty());
}

TEST_F(EditedShaders, ThatDoNotCompileAreNamedAndTheLastGoodOnesStay) {
    replace("fragment.glsl", "fragmentColor = color;", "fragmentColor = vec4(0.2, 0.4, 0.6, 1.0);");
    EXPECT_TRUE(becomes({0.2F, 0.4F, 0.6F, 1}));
    replace("vertex.glsl", "clamp(color, 0.0, 1.0)", "clamp(colour, 0.0, 1.0)");
    EXPECT_TRUE(within([&] {
        EXPECT_TRUE(isColor(onlyColor(flatScene()), {0.2F, 0.4F, 0.6F, 1}));
        return !problems.empty();
    }));
    const std::string text = readText(folder.path() / "vertex.glsl").value();
    const auto line =
        std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(text.find("clamp(colour")),
                   '\n') +
        1;
    EXPECT_THAT(problems,
                testing::Contains(HasSubstr("passes[0]: vertex.glsl:" + std::to_string(line) + ": ")));
    EXPECT_THAT(problems, testing::Contains(HasSubstr("colour")));

    replace("vertex.glsl", "clamp(colour", "clamp(color");
    EXPECT_TRUE(within([&] {
        EXPECT_TRUE(isColor(onlyColor(flatScene()), {0.2F, 0.4F, 0.6F, 1}));
        return problems.empty();
    }));
}

TEST_F(EditedShaders, ThatAreGoneAreSaid) {
    std::filesystem::remove(folder.path() / "combine.glsl");
    auto made = render::ShaderRenderer::create(capabilities, {folder.path(), {}});
    ASSERT_TRUE(made);
    renderer = std::move(*made);
    EXPECT_TRUE(isColor(onlyColor(flatScene()), {1, 1, 1, 1}));
    EXPECT_THAT(problems, ElementsAre(testing::AllOf(HasSubstr("combine.glsl"), HasSubstr("own shaders"))));
}

TEST_F(EditedShaders, ThatGoWhileOneLooksStay) {
    replace("fragment.glsl", "fragmentColor = color;", "fragmentColor = vec4(0.2, 0.4, 0.6, 1.0);");
    EXPECT_TRUE(becomes({0.2F, 0.4F, 0.6F, 1}));
    std::filesystem::remove(folder.path() / "combine.glsl");
    EXPECT_TRUE(within([&] {
        EXPECT_TRUE(isColor(onlyColor(flatScene()), {0.2F, 0.4F, 0.6F, 1}));
        return !problems.empty();
    }));
    EXPECT_THAT(problems, ElementsAre(testing::AllOf(HasSubstr("combine.glsl"), HasSubstr("stay"))));
}

} // namespace
} // namespace texplorer::shader_renderer_test

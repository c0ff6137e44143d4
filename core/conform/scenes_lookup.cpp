#include "texplorer/conform/feature.h"
#include "texplorer/conform/scenes.h"
#include "texplorer/conform/surfaces.h"

#include <algorithm>
#include <utility>

namespace texplorer::conform::scenes {

namespace {

constexpr Source volume{Pattern::Marble, 0, 32, 32};
constexpr Source line{Pattern::ColorLine, 0, 8, 1};

/// A quad that shows a picture, a line or a volume.
Scene quadOf(Target target, const Source& picture, Dice& values) {
    Scene scene = texturedQuad(target == Target::Texture1D   ? line
                               : target == Target::Texture3D ? volume
                                                             : picture,
                               values);
    scene.passes[0].units[0].target = target;
    return scene;
}

/// The plane over a flat quad along which a coordinate runs as placeTexels() would have it: u = first + 1/32
/// + step / 8 texels a pixel, to the right by `right` and upwards by `up` steps.
glm::vec4 planeOf(int texels, int right, int up, int first) {
    // A pixel is 1/32 wide. Both axes together: (2 i + 1) right / 16 + (2 j + 1) up / 16 + 1/32.
    const auto size = static_cast<float>(texels);
    const float x = static_cast<float>(right) * 4 / size;
    const float y = static_cast<float>(up) * 4 / size;
    return {x, y, 0, x + y + (static_cast<float>(first) + 1.0F / 32) / size};
}

TexGen generated(TexGenMode mode, glm::vec4 plane) {
    // On a flat quad the eye is at distance 1 before the model: z differs, x and y don't.
    return {true, mode, plane, plane};
}

} // namespace

Scene wrap(int number, Dice& state, Dice& values) {
    const Wrap s = pick<Wrap>(number);
    const Wrap t = pick<Wrap>(number);
    // Three pictures to a volume and a line.
    const int other = state.below(5);
    const Target target = other == 3 ? Target::Texture3D : other == 4 ? Target::Texture1D : Target::Texture2D;
    Scene scene = quadOf(target, state.of(coloredSources), values);
    Texture& texture = scene.textures[0];
    texture.wrapS = s;
    texture.wrapT = t;
    texture.wrapR = state.any<Wrap>();
    texture.borderColor = values.color();
    return scene;
}

Scene wrapLinear(int number, Dice& state, Dice& values) {
    Scene scene = wrap(number, state, values);
    scene.textures[0].magFilter = MagFilter::Linear;
    scene.textures[0].minFilter = MinFilter::Linear;
    return scene;
}

Scene linearTexGen(int number, Dice& state, Dice& values) {
    const TexGenMode mode = number % 2 == 0 ? TexGenMode::ObjectLinear : TexGenMode::EyeLinear;
    const Target target = number / 2 % 3 == 2 ? Target::Texture3D : Target::Texture2D;
    const Source picture = state.of(coloredSources);
    Scene scene = quadOf(target, picture, values);
    const Source& source = target == Target::Texture3D ? volume : picture;
    Unit& unit = scene.passes[0].units[0];
    const auto plane = [&](int texels) {
        const int right = values.below(17) - 8;
        const int up = values.below(17) - 8;
        return planeOf(texels, right, up, values.below(4 * texels) - 2 * texels);
    };
    unit.texGenS = generated(mode, plane(source.width));
    unit.texGenT = generated(number / 6 % 2 == 0 ? mode : TexGenMode::ObjectLinear, plane(source.height));
    if (target == Target::Texture3D) // a whole number of slices from one slice's middle to another's
        unit.texGenR = generated(mode, {0, 0, 0, (static_cast<float>(values.below(32)) + 0.5F) / 32});
    // Both planes say the same of a model that is where it was made, and something else once it has moved.
    if (values.chance(2))
        scene.models[0].position.z = values.number(-0.1F, 0.1F);
    return scene;
}

Scene mappedTexGen(int number, Dice& state, Dice& values) {
    const TexGenMode mode = pick<TexGenMode>(number);
    const bool divides = number % 2 == 1;
    Scene scene = texturedQuad(state.of(coloredSources), values);
    Unit& unit = scene.passes[0].units[0];
    for (TexGen* each : {&unit.texGenS, &unit.texGenT})
        *each = {true,
                 mode,
                 {values.number(-1, 1), values.number(-1, 1), 0.25F, values.number(-1, 1)},
                 {values.number(-1, 1), values.number(-1, 1), 0.25F, values.number(-1, 1)}};
    if (divides) {
        const glm::vec4 q{values.number(-0.3F, 0.3F), values.number(-0.3F, 0.3F), 0, 1};
        unit.texGenQ = generated(number / 2 % 2 == 0 ? TexGenMode::ObjectLinear : TexGenMode::EyeLinear, q);
    }
    unit.matrix = {{.op = MatrixOp::Translate, .amount = {values.number(0, 1), values.number(0, 1), 0}},
                   {.op = MatrixOp::Scale, .amount = {values.number(0.5F, 2), values.number(0.5F, 2), 1}}};
    return scene;
}

Scene texGenOnShapes(int number, Dice& state, Dice& values) {
    const TexGenMode mode = pick<TexGenMode>(number);
    Scene scene = surface(pick<Shape>(number), values);
    setSource(scene.textures[0], state.of(coloredSources));
    scene.textures[0].magFilter = MagFilter::Linear;
    scene.textures[0].minFilter = MinFilter::Linear;
    Unit& unit = scene.passes[0].units[0];
    for (TexGen* each : {&unit.texGenS, &unit.texGenT})
        *each = {true,
                 mode,
                 {values.number(-1, 1), values.number(-1, 1), values.number(-1, 1), 0.5F},
                 {values.number(-1, 1), values.number(-1, 1), values.number(-1, 1), 0.5F}};
    return scene;
}

Scene matrix(int number, Dice& state, Dice& values) {
    const MatrixOp first = pick<MatrixOp>(number);
    const MatrixOp second = pick<MatrixOp>(number);
    Scene scene = texturedQuad(state.of(coloredSources), values);
    const auto step = [&](MatrixOp op) {
        MatrixStep made{.op = op};
        if (op == MatrixOp::Multiply || op == MatrixOp::Load) {
            made.matrix = planeMatrix(values);
            return made;
        }
        if (op == MatrixOp::Rotate) {
            made.amount = {0, 0, 1};
            made.angle = values.number(0, 360);
        } else {
            made.amount = {values.number(0.5F, 2), values.number(0.5F, 2), values.number(0.5F, 2)};
        }
        if (values.chance(2))
            made.pivot = {values.number(-1, 1), values.number(-1, 1), 0};
        return made;
    };
    scene.passes[0].units[0].matrix = {step(first), step(second)};
    // Every vertex with a q of its own: s / q is no longer a plane over the quad.
    if (state.chance(2))
        std::ranges::for_each(scene.models[0].texCoords[0].edit(),
                              [&](glm::vec4& coord) { coord *= values.number(0.5F, 2); });
    return scene;
}

/// Two halves of the picture, drawn by three passes, of which one sees the last.
Scene matrixStack(int number, Dice& state, Dice& values) {
    const MatrixStart second = pick<MatrixStart>(number);
    const MatrixStart last = pick<MatrixStart>(number);
    Scene scene = texturedQuad(state.of(coloredSources), values);
    const auto step = [&]() -> MatrixStep {
        if (values.chance(2))
            return {.op = MatrixOp::Translate, .amount = {values.number(0, 1), values.number(0, 1), 0}};
        return {.op = MatrixOp::Scale, .amount = {values.number(0.5F, 2), values.number(0.5F, 2), 1}};
    };
    scene.models[0].scale.x = 0.5F;
    scene.models.push_back(scene.models[0]);
    float side = -0.5F;
    for (Model& model : scene.models) {
        model.position.x = std::exchange(side, -side);
        model.pushMatrix = state.chance(2);
        if (!state.chance(3))
            model.units[0].matrix = {step()};
    }
    scene.passes.resize(3, scene.passes[0]);
    scene.passes[1].units[0].matrixStart = second;
    scene.passes[2].units[0].matrixStart = last;
    for (Pass& pass : scene.passes)
        pass.units[0].matrix = {step()};
    return scene;
}

Scene projector(int number, Dice& state, Dice& values) {
    constexpr std::array shapes{Shape::Sphere, Shape::Cube, Shape::Torus, Shape::Mesh, Shape::Cylinder};
    const bool shadows = number % 2 == 0;
    const bool parallel = number / 2 % 2 == 0;
    Scene scene = surface(shapes[static_cast<std::size_t>(number / 4) % shapes.size()], values);
    scene.models.push_back(scene.models[0]); // which one of them may hide from the light
    scene.models[0].position = {values.number(-1, 0), values.number(-1, 0), values.number(-1, 0)};
    scene.models[1].position = {values.number(0, 1), values.number(0, 1), values.number(0, 1)};
    Light& light = scene.light;
    light.position = {values.number(-2, 2), values.number(-2, 2), 1, parallel ? 0.0F : 1.0F};
    light.projector = {{0, 0, -scene.view.distance}, values.number(30, 60), 0.5F, 10};
    Texture& texture = scene.textures[0];
    texture.mipmaps = MipPolicy::None;
    texture.magFilter = state.chance(2) ? MagFilter::Linear : MagFilter::Nearest;
    texture.minFilter = texture.magFilter == MagFilter::Linear ? MinFilter::Linear : MinFilter::Nearest;
    texture.wrapS = state.any<Wrap>();
    texture.wrapT = state.any<Wrap>();
    texture.borderColor = values.color();
    Unit& unit = scene.passes[0].units[0];
    if (shadows) {
        texture.source = SourceKind::LightDepth;
        texture.depthSize = state.chance(2) ? 64 : 100;
        texture.internalFormat =
            state.chance(2) ? InternalFormat::DepthComponent24 : InternalFormat::DepthComponent16;
        texture.compareMode = CompareMode::RToTexture;
        unit.matrix = {{.op = MatrixOp::Translate, .amount = {0, 0, -0.02F}}};
    }
    unit.matrix.push_back({.op = MatrixOp::Projector});
    int axis = 0;
    for (TexGen* each : {&unit.texGenS, &unit.texGenT, &unit.texGenR, &unit.texGenQ}) {
        glm::vec4 plane(0);
        plane[axis++] = 1;
        *each = {true, TexGenMode::EyeLinear, {}, plane};
    }
    return scene;
}

Scene subimages(int number, Dice& state, Dice& values) {
    const Source source = state.of(coloredSources);
    Scene scene = texturedQuad(source, values);
    Texture& texture = scene.textures[0];
    for (int i = 0; i <= number % 3; ++i) {
        Subimage part;
        part.level = state.chance(8) ? 12 : source.level;
        part.width = 1 + state.below(source.width / 2);
        part.height = 1 + state.below(source.height / 2);
        part.x = state.below(source.width - part.width + (state.chance(4) ? 4 : 1));
        part.y = state.below(source.height - part.height + (state.chance(4) ? 4 : 1));
        part.pattern = state.of(coloredSources).pattern;
        texture.subimages.push_back(part);
    }
    return scene;
}

/// A pass draws the picture, which has as many pixels as the window, so that a quad covers both exactly.
Scene pictures(int number, Dice& state, Dice& values) {
    constexpr Source picture{Pattern::Checker, 0, extent, extent}; // its size
    Scene scene = texturedQuad(state.of(coloredSources), values);
    Model shown = scene.models[0];
    placeTexels(shown, 0, picture, values);
    scene.models.push_back(std::move(shown));
    Texture texture;
    texture.source = SourceKind::Picture;
    texture.pictureSize = extent;
    texture.magFilter = MagFilter::Nearest;
    texture.minFilter = MinFilter::Nearest;
    texture.wrapS = state.any<Wrap>();
    texture.wrapT = state.any<Wrap>();
    texture.borderColor = values.color();
    texture.internalFormat = internalFormat(state.any<BaseFormat>());
    scene.textures.push_back(std::move(texture));
    scene.view.background = values.color();
    scene.passes.resize(2, scene.passes[0]);
    scene.passes[0].picture = 1;
    scene.passes[0].models = {0};
    scene.passes[1].models = {1};
    scene.passes[1].units[0].texture = 1;
    if (number % 2 == 1) { // shows itself, as the frame before left it
        scene.textures[1].frames = 1 + state.below(3);
        placeTexels(scene.models[0], 1, picture, values);
        Unit& before = scene.passes[0].units[1];
        before.enabled = true;
        before.texture = 1;
        before.envMode = EnvMode::Add;
    }
    return scene;
}

} // namespace texplorer::conform::scenes

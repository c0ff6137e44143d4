#include "texplorer/conform/made_files.h"
#include "texplorer/conform/scenes.h"
#include "texplorer/conform/surfaces.h"

namespace texplorer::conform::scenes {

namespace {

constexpr std::array mipmapFilters{MinFilter::NearestMipmapNearest, MinFilter::LinearMipmapNearest,
                                   MinFilter::NearestMipmapLinear, MinFilter::LinearMipmapLinear};

Scene filtered(int& number, MagFilter mag, MinFilter min, Dice& state, Dice& values) {
    Scene scene = surface(pick<Shape>(number), values);
    Texture& texture = scene.textures[0];
    texture.magFilter = mag;
    texture.minFilter = min;
    texture.wrapS = state.any<Wrap>();
    texture.wrapT = state.any<Wrap>();
    texture.borderColor = values.color();
    return scene;
}

/// Bias, the limits of lambda, and which levels there are.
void limitLod(Scene& scene, Dice& values) {
    Texture& texture = scene.textures[0];
    // Each bias in 256ths: some drivers keep no more of it.
    scene.passes[0].units[0].lodBias = static_cast<float>(values.below(1025) - 512) / 256;
    if (values.chance(2))
        texture.minLod = values.number(-1, 3);
    if (values.chance(2))
        texture.maxLod = texture.minLod > -100 ? texture.minLod + values.number(0, 3) : values.number(0, 5);
    if (values.chance(3))
        texture.baseLevel = values.below(4);
    if (values.chance(3))
        texture.maxLevel = texture.baseLevel + values.below(4);
    if (values.chance(2))
        texture.lodBias = static_cast<float>(values.below(513) - 256) / 256;
}

} // namespace

Scene nearest(int number, Dice& state, Dice& values) {
    return filtered(number, MagFilter::Nearest, MinFilter::Nearest, state, values);
}

Scene linear(int number, Dice& state, Dice& values) {
    return filtered(number, MagFilter::Linear, MinFilter::Linear, state, values);
}

Scene magnification(int number, Dice& state, Dice& values) {
    const bool nearIsLinear = number % 2 == 0;
    number /= 2;
    return filtered(number, nearIsLinear ? MagFilter::Linear : MagFilter::Nearest,
                    nearIsLinear ? MinFilter::Nearest : MinFilter::Linear, state, values);
}

Scene mipmapNearest(int number, Dice& state, Dice& values) {
    const MagFilter mag = pick<MagFilter>(number);
    const MinFilter min = number % 2 == 0 ? MinFilter::NearestMipmapNearest : MinFilter::LinearMipmapNearest;
    number /= 2;
    return filtered(number, mag, min, state, values);
}

Scene trilinear(int number, Dice& state, Dice& values) {
    const MagFilter mag = pick<MagFilter>(number);
    const MinFilter min = number % 2 == 0 ? MinFilter::NearestMipmapLinear : MinFilter::LinearMipmapLinear;
    number /= 2;
    return filtered(number, mag, min, state, values);
}

Scene lodOfOneLevel(int number, Dice& state, Dice& values) {
    Scene scene = mipmapNearest(number, state, values);
    limitLod(scene, values);
    return scene;
}

Scene lodOfTwoLevels(int number, Dice& state, Dice& values) {
    Scene scene = trilinear(number, state, values);
    limitLod(scene, values);
    return scene;
}

Scene levelSettings(int number, Dice& state, Dice& values) {
    // Some without sense: levels that aren't there, a last one before the first.
    constexpr std::array levels{0, 1, 2, 3, 5, 6, 7, 200, 1000};
    constexpr std::array lods{-1000.0F, -1.0F, 0.0F, 0.5F, 1.0F, 2.25F, 6.0F, 1000.0F};
    constexpr std::array policies{MipPolicy::FromFile,  MipPolicy::Missing,  MipPolicy::FromFile,
                                  MipPolicy::Generated, MipPolicy::FromFile, MipPolicy::None};
    const auto turn = static_cast<std::size_t>(number);
    const MinFilter min = turn % 5 == 4 ? MinFilter::Linear : state.of(mipmapFilters);
    Scene scene = filtered(number, state.any<MagFilter>(), min, state, values);
    Texture& texture = scene.textures[0];
    texture.mipmaps = policies[turn % policies.size()];
    if (texture.mipmaps == MipPolicy::FromFile) {
        texture.source = SourceKind::File;
        texture.file = madeFiles[turn / 2 % madeFiles.size()].name;
    }
    texture.baseLevel = values.chance(2) ? 0 : values.of(levels);
    texture.maxLevel = values.chance(2) ? 1000 : values.of(levels);
    texture.minLod = values.chance(2) ? -1000 : values.of(lods);
    texture.maxLod = values.chance(2) ? 1000 : values.of(lods);
    if (texture.minLod > texture.maxLod) // lambda is undefined then (equation 3.19)
        std::swap(texture.minLod, texture.maxLod);
    return scene;
}

Scene anisotropy(int number, Dice& state, Dice& values) {
    const MinFilter min = number % 2 == 0 ? MinFilter::LinearMipmapLinear : MinFilter::LinearMipmapNearest;
    number /= 2;
    Scene scene = filtered(number, MagFilter::Linear, min, state, values);
    scene.view.elevation = values.number(8, 20); // the flatter, the longer the ellipses
    scene.textures[0].maxAnisotropy = static_cast<float>(2 << values.below(4));
    return scene;
}

Scene targets(int number, Dice& state, Dice& values) {
    const Target target = number % 2 == 0 ? Target::Texture3D : Target::Texture1D;
    number /= 2;
    Scene scene = surface(pick<Shape>(number), values);
    Texture& texture = scene.textures[0];
    texture.pattern = target == Target::Texture3D ? Pattern::Marble : Pattern::ColorLine;
    texture.minFilter = MinFilter::Linear;
    texture.wrapR = state.any<Wrap>();
    Unit& unit = scene.passes[0].units[0];
    unit.target = target;
    if (target == Target::Texture3D) // r of a mesh is 0 everywhere
        unit.texGenR = {
            true, TexGenMode::ObjectLinear, {values.number(-1, 1), 0.3F, values.number(-1, 1), 0.5F}, {}};
    return scene;
}

Scene cubeMap(int number, Dice& state, Dice& values) {
    const bool linear = number % 2 == 1;
    const TexGenMode mode = number / 2 % 2 == 0 ? TexGenMode::ReflectionMap : TexGenMode::NormalMap;
    number /= 4;
    Scene scene = surface(number % 2 == 0 ? Shape::Sphere : Shape::Cube, values);
    Texture& texture = scene.textures[0];
    texture.pattern = Pattern::CubeFaces;
    texture.magFilter = linear ? MagFilter::Linear : MagFilter::Nearest;
    texture.minFilter = linear ? MinFilter::Linear : MinFilter::Nearest;
    // Half of them as they are used, so that GL_LINEAR is compared on llvmpipe, too (skip.cpp).
    const bool usual = state.chance(2);
    texture.wrapS = usual ? Wrap::ClampToEdge : state.any<Wrap>();
    texture.wrapT = usual ? Wrap::ClampToEdge : state.any<Wrap>();
    texture.borderColor = values.color();
    if (!usual) { // large texels: what lies beyond the edge of a face is half of one
        texture.mipmaps = MipPolicy::Generated;
        texture.baseLevel = 5;
    }
    Unit& unit = scene.passes[0].units[0];
    unit.target = Target::CubeMap;
    for (TexGen* each : {&unit.texGenS, &unit.texGenT, &unit.texGenR})
        *each = {true, mode, {}, {}};
    unit.matrix = {{.op = MatrixOp::Rotate, // the sky turns
                    .amount = {values.number(0, 1), values.number(0, 1), values.number(0.1F, 1)},
                    .angle = values.number(0, 360)}};
    return scene;
}

Scene seamless(int number, Dice& state, Dice& values) {
    const TexGenMode mode = number % 2 == 0 ? TexGenMode::ReflectionMap : TexGenMode::NormalMap;
    number /= 2;
    Scene scene = surface(number % 2 == 0 ? Shape::Sphere : Shape::Cube, values);
    number /= 2;
    Texture& texture = scene.textures[0];
    texture.pattern = Pattern::CubeFaces;
    // One level alone: which one a reflection is minified to is another question.
    const bool linear = number % 4 != 3;
    texture.magFilter = linear ? MagFilter::Linear : MagFilter::Nearest;
    texture.minFilter = linear ? MinFilter::Linear : MinFilter::Nearest;
    texture.mipmaps = MipPolicy::Generated;
    texture.baseLevel = 3 + number % 5; // 16 texels along an edge to one, so that edges are wide
    texture.wrapS = state.any<Wrap>();  // which count no more
    texture.wrapT = state.any<Wrap>();
    texture.borderColor = values.color();
    scene.passes[0].seamlessCubeMap = true;
    Unit& unit = scene.passes[0].units[0];
    unit.target = Target::CubeMap;
    for (TexGen* each : {&unit.texGenS, &unit.texGenT, &unit.texGenR})
        *each = {true, mode, {}, {}};
    unit.matrix = {{.op = MatrixOp::Rotate, // edges and corners everywhere
                    .amount = {values.number(0, 1), values.number(0, 1), values.number(0.1F, 1)},
                    .angle = values.number(0, 360)}};
    return scene;
}

Scene border(int number, Dice& state, Dice& values) {
    const Wrap s = pick<Wrap>(number);
    const bool linear = number % 2 == 1;
    Scene scene = texturedQuad({Pattern::Checker, 0, 64, 64}, values);
    Texture& texture = scene.textures[0];
    texture.border = 1;
    texture.wrapS = s;
    texture.wrapT = state.any<Wrap>();
    texture.magFilter = linear ? MagFilter::Linear : MagFilter::Nearest;
    texture.minFilter = linear ? MinFilter::Linear : MinFilter::Nearest;
    return scene;
}

Scene hint(int number, Dice& state, Dice& values) {
    // Nothing here is cut by the near plane: no rule defines what straight means on both sides of a cut.
    const Shape shape = number % 2 == 0 ? Shape::Cube : Shape::Quad;
    Scene scene = surface(shape, values);
    scene.view.perspectiveHint = HintMode::Fastest;
    scene.view.distance += 1;
    Texture& texture = scene.textures[0];
    texture.magFilter = MagFilter::Nearest;
    texture.minFilter = MinFilter::Nearest;
    texture.wrapS = state.any<Wrap>();
    return scene;
}

Scene compression(int number, Dice& /*state*/, Dice& values) {
    constexpr std::array sources{Source{Pattern::Tree, 3, 32, 32}, Source{Pattern::Brick, 4, 16, 16}};
    const bool byDriver = number % 2 == 1;
    number /= 2;
    const CompressedFormat format = pick<CompressedFormat>(number);
    Scene scene = texturedQuad(sources[static_cast<std::size_t>(number) % sources.size()], values);
    scene.textures[0].compression = byDriver ? Compression::Driver : Compression::Cached;
    scene.textures[0].compressedFormat = format;
    scene.textures[0].compressionQuality = EncodeQuality::Fast;
    return scene;
}

Scene incomplete(int number, Dice& state, Dice& values) {
    Scene scene = texturedQuad(state.of(coloredSources), values);
    scene.textures[0].baseLevel = 0;
    scene.textures[0].mipmaps = number % 2 == 0 ? MipPolicy::None : MipPolicy::Missing;
    scene.textures[0].minFilter = mipmapFilters[static_cast<std::size_t>(number / 2) % mipmapFilters.size()];
    return scene;
}

Scene givenLevels(int number, Dice& state, Dice& values) {
    // Complete, with too few levels that are read, with too few that aren't, with one of another size.
    enum class Chain : std::uint8_t { Complete, Short, Limited, WrongSize };
    constexpr std::array chains{Chain::Complete, Chain::Complete, Chain::Limited,
                                Chain::Short,    Chain::Complete, Chain::WrongSize};
    constexpr int full = 8; // levels above a base of 256 texels
    const auto turn = static_cast<std::size_t>(number);
    const Chain chain = chains[turn % chains.size()];
    Scene scene = filtered(number, state.any<MagFilter>(), state.of(mipmapFilters), state, values);
    Texture& texture = scene.textures[0];
    texture.pattern = Pattern::Brick;
    texture.mipmaps = MipPolicy::Given;
    const int count = chain == Chain::Short || chain == Chain::Limited ? 1 + values.below(full - 1) : full;
    for (int level = 0; level < count; ++level)
        texture.levels.push_back({.pattern = values.any<Pattern>()});
    if (chain == Chain::Limited)
        texture.maxLevel = count;
    if (chain == Chain::WrongSize) { // 64 x 64 texels
        GivenLevel& wrong = texture.levels[static_cast<std::size_t>(values.below(full) & ~1)];
        wrong.source = SourceKind::File;
        wrong.file = madeFiles[0].name;
    }
    return scene;
}

} // namespace texplorer::conform::scenes

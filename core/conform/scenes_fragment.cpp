#include "texplorer/conform/scenes.h"
#include "texplorer/conform/surfaces.h"

#include <algorithm>
#include <ranges>

namespace texplorer::conform::scenes {

namespace {

CombineSource anySource(Dice& state, int units) {
    // The texture of a unit that is off is undefined.
    const auto source = state.any<CombineSource>();
    const int unit = static_cast<int>(source) - static_cast<int>(CombineSource::Texture0);
    return unit >= units && unit < maxUnits ? CombineSource::Previous : source;
}

Combine anyCombine(int& number, Dice& state, int units) {
    Combine c;
    c.rgb = pick<CombineRgb>(number);
    c.alpha = state.any<CombineAlpha>();
    for (CombineSource* source :
         {&c.source0Rgb, &c.source1Rgb, &c.source2Rgb, &c.source0Alpha, &c.source1Alpha, &c.source2Alpha})
        *source = anySource(state, units);
    for (OperandRgb* operand : {&c.operand0Rgb, &c.operand1Rgb, &c.operand2Rgb})
        *operand = state.any<OperandRgb>();
    for (OperandAlpha* operand : {&c.operand0Alpha, &c.operand1Alpha, &c.operand2Alpha})
        *operand = state.any<OperandAlpha>();
    c.rgbScale = pick<CombineScale>(number);
    c.alphaScale = state.any<CombineScale>();
    return c;
}

/// Lets so many units show pictures, one after the other. Those of the units that it adds.
std::vector<Source> addUnits(Scene& scene, int count, Dice& state, Dice& values) {
    std::vector<Source> added;
    scene.textures.resize(static_cast<std::size_t>(count), scene.textures[0]);
    for (std::size_t u = 1; u < static_cast<std::size_t>(count); ++u) {
        const Source source = state.of(coloredSources);
        setSource(scene.textures[u], source);
        placeTexels(scene.models[0], u, source, values);
        Unit& unit = scene.passes[0].units[u];
        unit.enabled = true;
        unit.texture = static_cast<int>(u);
        added.push_back(source);
    }
    return added;
}

/// Two smaller quads in the plane of the first one, with colours of their own. Their sides lie between
/// pixels.
void addQuads(Scene& scene, const std::vector<Source>& sources, Dice& values) {
    const auto place = [&] { return static_cast<float>(values.below(33) - 16) / 32; };
    for (const float size : {0.5F, 0.25F}) {
        Model quad = scene.models[0];
        quad.size = size;
        quad.position = {place(), place(), 0};
        quad.ownMaterial = true;
        quad.material.color = values.color();
        for (std::size_t u = 0; u < sources.size(); ++u)
            placeTexels(quad, u, sources[u], values);
        scene.models.push_back(quad);
    }
}

/// One to `max` of the three quads, in any order.
std::vector<int> someQuads(int max, Dice& state) {
    std::vector<int> left{0, 1, 2};
    std::vector<int> chosen;
    for (int count = 1 + state.below(max); count > 0; --count) {
        const auto next = left.begin() + state.below(static_cast<int>(left.size()));
        chosen.push_back(*next);
        left.erase(next);
    }
    return chosen;
}

constexpr std::array definedDecals{BaseFormat::Rgb, BaseFormat::Rgba};

/// An environment mode and a base format, of which the tables say what they do.
void setEnvironment(Unit& unit, Texture& texture, Dice& state) {
    unit.envMode = state.any<EnvMode>();
    texture.internalFormat =
        internalFormat(unit.envMode == EnvMode::Decal ? state.of(definedDecals) : state.any<BaseFormat>());
}

/// Those whose numbers aren't 255ths of a colour.
constexpr auto unusualFormats = [] {
    constexpr auto isOne = [](const FormatFacts& facts) {
        return (hasFewBits(facts.format) || isSrgb(facts.format)) && !isGenericCompressed(facts.format);
    };
    std::array<InternalFormat, std::ranges::count_if(formatFacts, isOne)> formats{};
    std::ranges::transform(formatFacts | std::views::filter(isOne), formats.begin(), &FormatFacts::format);
    return formats;
}();

constexpr auto formatsOfFloats = [] {
    constexpr auto isOne = [](const FormatFacts& facts) { return isFloat(facts.format); };
    std::array<InternalFormat, std::ranges::count_if(formatFacts, isOne)> formats{};
    std::ranges::transform(formatFacts | std::views::filter(isOne), formats.begin(), &FormatFacts::format);
    return formats;
}();

/// One that the format has; rarely a signed one, which only OpenGL's renderers are compared with.
TransferType typeFor(TransferFormat format, Dice& values) {
    constexpr std::array signedTypes{TransferType::Byte, TransferType::Short, TransferType::Int};
    for (;;) {
        const auto type = values.any<TransferType>();
        const bool isSigned = std::ranges::find(signedTypes, type) != signedTypes.end();
        if (checkLayout({format, type}) && (!isSigned || values.chance(4)))
            return type;
    }
}

} // namespace

Scene internalFormats(int number, Dice& state, Dice& values) {
    const auto format = static_cast<std::size_t>(number) % unusualFormats.size();
    const bool linear = static_cast<std::size_t>(number) / unusualFormats.size() % 2 == 1;
    Scene scene = texturedQuad(state.of(coloredSources), values);
    Texture& texture = scene.textures[0];
    texture.internalFormat = unusualFormats[format];
    texture.magFilter = linear ? MagFilter::Linear : MagFilter::Nearest;
    texture.minFilter = linear ? MinFilter::Linear : MinFilter::Nearest;
    texture.wrapS = state.any<Wrap>();
    texture.wrapT = state.any<Wrap>();
    texture.borderColor = values.color(); // which has all its bits, and no curve
    return scene;
}

Scene preparation(int number, Dice& state, Dice& values) {
    const auto first = pick<ImageOp>(number);
    Scene scene = texturedQuad(state.of(coloredSources), values);
    std::vector<ImageStep>& steps = scene.textures[0].preparation;
    for (int left = 1 + number % 3; left > 0; --left) {
        ImageStep step{.op = steps.empty() ? first : values.any<ImageOp>()};
        for (int i = 0; i < 4; ++i) {
            step.factor[i] = values.number(-1, 2);
            step.bias[i] = values.number(-0.5F, 1);
        }
        step.amount = values.number(0, 3);
        step.pattern = values.any<Pattern>();
        for (ComponentSource* source : {&step.red, &step.green, &step.blue, &step.alpha})
            *source = values.any<ComponentSource>();
        step.share = values.number(0.2F, 1);
        steps.push_back(step);
    }
    return scene;
}

Scene floatFormats(int number, Dice& state, Dice& values) {
    Scene scene = internalFormats(0, state, values);
    Texture& texture = scene.textures[0];
    texture.internalFormat = formatsOfFloats[static_cast<std::size_t>(number) % formatsOfFloats.size()];
    const bool linear = static_cast<std::size_t>(number) / formatsOfFloats.size() % 2 == 1;
    texture.magFilter = linear ? MagFilter::Linear : MagFilter::Nearest;
    texture.minFilter = linear ? MinFilter::Linear : MinFilter::Nearest;
    Upload& upload = texture.upload;
    upload.custom = true;
    upload.memory = MemoryRows::Layout;
    upload.memoryType = values.chance(2) ? TransferType::Float : TransferType::UnsignedByte;
    upload.type = upload.memoryType;
    for (int i = 0; i < 4; ++i) {
        upload.scale[i] = values.number(0.5F, 4);
        upload.bias[i] = values.number(-2, 1);
    }
    Unit& unit = scene.passes[0].units[0];
    const BaseFormat base = baseFormat(texture.internalFormat);
    unit.envMode = state.any<EnvMode>();
    if (unit.envMode == EnvMode::Decal && std::ranges::find(definedDecals, base) == definedDecals.end())
        unit.envMode = EnvMode::Modulate;
    unit.combine = anyCombine(number, state, 1);
    unit.envColor = values.color();
    return scene;
}

Scene upload(int number, Dice& state, Dice& values) {
    constexpr std::array alignments{1, 2, 4, 8};
    const Source source = state.of(coloredSources);
    Scene scene = texturedQuad(source, values);
    Texture& texture = scene.textures[0];
    Upload& upload = texture.upload;
    upload.custom = true;
    upload.format = pick<TransferFormat>(number);
    const bool isOfDepths = upload.format == TransferFormat::DepthComponent;
    if (isOfDepths)
        texture.internalFormat = InternalFormat::DepthComponent24;
    upload.type = typeFor(upload.format, values);
    upload.alignment = values.of(alignments);
    upload.memory = values.chance(4) ? MemoryRows::File : MemoryRows::Layout;
    const bool fits = values.chance(2);
    upload.memoryFormat = fits ? upload.format : values.any<TransferFormat>();
    upload.memoryType = fits ? upload.type : typeFor(upload.memoryFormat, values);
    upload.memoryAlignment = fits ? upload.alignment : values.of(alignments);
    if (values.chance(2)) // rows of an odd length, which begin at each alignment elsewhere
        upload.rowLength = source.width + values.below(8);
    upload.skipRows = values.below(4);
    upload.skipPixels = values.below(4);
    upload.swapBytes = values.chance(3);
    if (values.chance(2) && !isOfDepths) {
        for (int i = 0; i < 4; ++i) {
            upload.scale[i] = values.number(-1, 2);
            upload.bias[i] = values.number(-0.5F, 1);
        }
    }
    return scene;
}

Scene depthTextures(int number, Dice& state, Dice& values) {
    // Depths of 0 and 1 can be met exactly: r beyond them is clamped. Of the others none is.
    constexpr Source ofZeroAndOne{Pattern::Checker, 0, 64, 64};
    constexpr std::array askForEquals{CompareFunc::Equal, CompareFunc::NotEqual, CompareFunc::LessEqual,
                                      CompareFunc::GreaterEqual};
    constexpr std::array ends{-0.25F, 0.0F, 0.5F, 1.0F, 1.25F};
    const CompareFunc function = pick<CompareFunc>(number);
    const DepthMode mode = pick<DepthMode>(number);
    const bool meets = std::ranges::find(askForEquals, function) != askForEquals.end();
    Scene scene = texturedQuad(meets && !state.chance(3) ? ofZeroAndOne : state.of(coloredSources), values);
    Texture& texture = scene.textures[0];
    texture.internalFormat =
        state.chance(2) ? InternalFormat::DepthComponent24 : InternalFormat::DepthComponent16;
    texture.compareMode = state.chance(6) ? CompareMode::None : CompareMode::RToTexture;
    texture.compareFunc = function;
    texture.depthMode = mode;
    const bool linear = state.chance(2);
    texture.magFilter = linear ? MagFilter::Linear : MagFilter::Nearest;
    texture.minFilter = linear ? MinFilter::Linear : MinFilter::Nearest;
    texture.wrapS = state.any<Wrap>();
    texture.wrapT = state.any<Wrap>();
    texture.borderColor = values.color();
    Unit& unit = scene.passes[0].units[0];
    unit.target = state.chance(4) ? Target::Texture1D : Target::Texture2D;
    unit.envMode = state.chance(2) ? EnvMode::Modulate : EnvMode::Replace;
    // Along one axis r runs through fractions of powers of two, which no other 255th is.
    const float first = values.of(ends);
    const float last = values.of(ends);
    const bool across = values.chance(2);
    const Mesh quad = makeMesh({Shape::Quad});
    TexCoords& coords = scene.models[0].texCoords[0].edit();
    for (std::size_t i = 0; i < coords.size(); ++i) {
        const glm::vec3& place = quad.vertices[i].position;
        coords[i].p = (across ? place.x : place.y) > 0 ? last : first;
    }
    return scene;
}

Scene environment(int number, Dice& state, Dice& values) {
    Scene scene = texturedQuad(state.of(coloredSources), values);
    Unit& unit = scene.passes[0].units[0];
    unit.envMode = pick<EnvMode>(number);
    scene.textures[0].internalFormat = internalFormat(pick<BaseFormat>(number));
    unit.envColor = values.color();
    return scene;
}

Scene combine(int number, Dice& state, Dice& values) {
    const int count = 1 + number % 3;
    number /= 3;
    Scene scene = texturedQuad(state.of(coloredSources), values);
    addUnits(scene, count, state, values);
    for (int u = 0; u < count; ++u) {
        Unit& unit = scene.passes[0].units[static_cast<std::size_t>(u)];
        unit.envMode = EnvMode::Combine;
        unit.combine = anyCombine(number, state, count);
        unit.envColor = values.color();
    }
    return scene;
}

Scene units(int number, Dice& state, Dice& values) {
    const int count = 2 + number % 3;
    Scene scene = texturedQuad(state.of(coloredSources), values);
    addUnits(scene, count, state, values);
    for (std::size_t u = 0; u < static_cast<std::size_t>(count); ++u) {
        Unit& unit = scene.passes[0].units[u];
        setEnvironment(unit, scene.textures[u], state);
        unit.combine = anyCombine(number, state, count);
        unit.envColor = values.color();
    }
    return scene;
}

Scene alphaTest(int number, Dice& state, Dice& values) {
    Scene scene = texturedQuad(state.of(coloredSources), values);
    Pass& pass = scene.passes[0];
    pass.alphaTest = true;
    pass.alphaFunc = pick<CompareFunc>(number);
    // Both are rounded to 8 bits (section 4.1.4): a quarter more or less changes nothing.
    pass.alphaRef = (static_cast<float>(values.below(256)) + values.number(-0.25F, 0.25F)) / 255;
    return scene;
}

Scene blend(int number, Dice& state, Dice& values) {
    constexpr std::array sourceFactors{BlendFactor::Zero,     BlendFactor::One,
                                       BlendFactor::SrcAlpha, BlendFactor::OneMinusSrcAlpha,
                                       BlendFactor::DstAlpha, BlendFactor::OneMinusDstAlpha,
                                       BlendFactor::DstColor, BlendFactor::OneMinusDstColor};
    Scene scene = texturedQuad(state.of(coloredSources), values);
    Pass& pass = scene.passes[0];
    pass.blend = true;
    pass.blendSrc = sourceFactors[static_cast<std::size_t>(number) % sourceFactors.size()];
    number /= static_cast<int>(sourceFactors.size());
    pass.blendDst = pick<BlendFactor>(number);
    return scene;
}

Scene passes(int number, Dice& state, Dice& values) {
    const Source first = state.of(coloredSources);
    Scene scene = texturedQuad(first, values);
    const std::vector<Source> added = addUnits(scene, 2, state, values);
    const bool named = number / 2 % 2 == 1;
    if (named)
        addQuads(scene, {first, added[0]}, values);
    const int count = 2 + number % 2;
    scene.passes.resize(static_cast<std::size_t>(count), scene.passes[0]);
    for (std::size_t i = 0; i < scene.passes.size(); ++i) {
        Pass& pass = scene.passes[i];
        pass.depthTest = true;
        pass.depthFunc = i == 0 ? CompareFunc::Less : i == 1 ? CompareFunc::Equal : CompareFunc::LessEqual;
        pass.blend = i > 0;
        pass.blendSrc = state.chance(2) ? BlendFactor::One : BlendFactor::SrcAlpha;
        pass.blendDst = state.chance(2) ? BlendFactor::SrcColor : BlendFactor::OneMinusSrcAlpha;
        for (std::size_t u = 0; u < 2; ++u) {
            pass.units[u].envMode = state.chance(2) ? EnvMode::Modulate : EnvMode::Replace;
            pass.units[u].enabled = u == 0 || state.chance(2);
            pass.units[u].texture = state.below(2) == 0 ? static_cast<int>(u) : 1 - static_cast<int>(u);
        }
        pass.enabled = !state.chance(5);
        if (named)
            pass.models = someQuads(i == 0 ? 3 : 1, state); // so that each blended pass rounds once
    }
    return scene;
}

Scene mixture(int number, Dice& state, Dice& values) {
    Scene scene = surface(pick<Shape>(number), values);
    if (state.chance(2))
        setLight(scene, values);
    scene.light.colorControl = state.any<ColorControl>();
    scene.material.shadeModel = state.any<ShadeModel>();
    const bool floor = scene.models[0].shape == Shape::Floor;
    const float steep = floor ? 0.005F : 0.1F; // q stays above 0 on the whole of it
    const int count = 1 + state.below(3);
    scene.textures.resize(static_cast<std::size_t>(count), scene.textures[0]);
    scene.passes.resize(1 + static_cast<std::size_t>(state.below(2)), scene.passes[0]);
    for (std::size_t u = 0; u < static_cast<std::size_t>(count); ++u) {
        Texture& texture = scene.textures[u];
        texture.pattern = u == 0 ? texture.pattern : Pattern::Checker;
        texture.minFilter = state.any<MinFilter>();
        texture.magFilter = state.any<MagFilter>();
        texture.wrapS = state.any<Wrap>();
        texture.wrapT = state.any<Wrap>();
        texture.borderColor = values.color();
        if (state.chance(4))
            texture.compression = Compression::Cached;
        texture.compressedFormat = state.any<CompressedFormat>();
        texture.compressionQuality = EncodeQuality::Fast;
        Unit unit;
        unit.enabled = true;
        unit.texture = static_cast<int>(u);
        setEnvironment(unit, texture, state);
        if (texture.compression == Compression::Cached && unit.envMode == EnvMode::Decal)
            unit.envMode = EnvMode::Modulate;
        int which = state.below(1000);
        unit.combine = anyCombine(which, state, count);
        unit.envColor = values.color();
        if (state.chance(3))
            unit.texGenS = {true, state.any<TexGenMode>(), values.color(), values.color()};
        // However one looks at the floor, its normal's x is 0: a rounding error would choose between the
        // first texel and the last.
        if (floor && unit.texGenS.mode == TexGenMode::NormalMap)
            unit.texGenS.mode = TexGenMode::EyeLinear;
        if (state.chance(4))
            unit.texGenQ = {true,
                            static_cast<TexGenMode>(state.of(texGenModesOfQ).value),
                            {values.number(-steep, steep), 0, values.number(-steep, steep), 1},
                            {values.number(-steep, steep), 0, 0, 1}};
        if (state.chance(3))
            unit.matrix = {
                {.op = state.any<MatrixOp>(),
                 .amount = {values.number(0.5F, 2), values.number(0.5F, 2), values.number(0.5F, 2)},
                 .angle = values.number(0, 360),
                 .matrix = planeMatrix(values)}};
        if (state.chance(4))
            unit.emboss = {true, values.number(0.02F, 0.2F), state.any<LightCarrier>()};
        for (Pass& pass : scene.passes)
            pass.units[u] = unit;
    }
    if (scene.passes.size() > 1) {
        scene.passes[1].depthFunc = CompareFunc::LessEqual;
        scene.passes[1].blend = true;
        scene.passes[1].blendSrc = BlendFactor::SrcAlpha;
        scene.passes[1].blendDst = BlendFactor::OneMinusSrcAlpha;
    }
    return scene;
}

} // namespace texplorer::conform::scenes

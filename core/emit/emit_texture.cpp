#include "texplorer/base/sentence_format.h"
#include "texplorer/diagnosis/applied_texture.h"
#include "texplorer/emit/emission.h"
#include "texplorer/gl/argument_names.h"
#include "texplorer/gl/core_format.h"
#include "texplorer/reference/sampling/lod.h"
#include "texplorer/scene/drawn_models.h"
#include "texplorer/scene/params/keys.h"

#include <fmt/core.h>

#include <algorithm>

namespace texplorer::emit {
namespace {

/// Whether a target and an internal format have what a row of glTexParameter sets.
bool hasEffect(const ParamRow& row, const Texture& texture, Target target, const Emission& emission) {
    if (emission.isCore &&
        (row.member == memberId<&Texture::priority> || row.member == memberId<&Texture::depthMode>))
        return false; // which the core profile doesn't know
    if (row.member == memberId<&Texture::wrapR>)
        return target == Target::Texture3D;
    if (row.member == memberId<&Texture::wrapT>)
        return target != Target::Texture1D;
    const bool isOfDepths = row.member == memberId<&Texture::compareMode> ||
                            row.member == memberId<&Texture::compareFunc> ||
                            row.member == memberId<&Texture::depthMode>;
    return !isOfDepths || isDepth(texture.internalFormat);
}

/// Where its picture comes from.
std::string originOf(const Texture& texture) {
    switch (texture.source) {
    case SourceKind::Pattern:
        return fmt::format("the pattern \"{}\"", rowOf(texture.pattern).name);
    case SourceKind::File:
        return texture.file.empty() ? "no file" : fmt::format("\"{}\"", texture.file);
    case SourceKind::LightDepth:
    case SourceKind::Picture:
        break;
    }
    return std::string(rowOf(texture.source).label);
}

/// What the base formats are that the core profile has no more, table 3.20 of OpenGL 2.1.
void writeSwizzle(Emission& emission, const reference::SampledTexture& shape, Target target) {
    const std::string_view words = coreFormatOf(shape.internalFormat).swizzle;
    if (words.empty())
        return;
    emission.writer.add(fmt::format("const GLint swizzle[] = {{{}}}; /* what a shader gets: {} */", words,
                                    rowOf(shape.format).name));
    emission.writer.add(
        fmt::format("glTexParameteriv({}, GL_TEXTURE_SWIZZLE_RGBA, swizzle);", rowOf(target).name));
}

/// As the flavour has it.
Texture adapted(Emission& emission, std::size_t object) {
    const std::size_t index = emission.objects[object].texture;
    Texture texture = emission.scene.textures[index];
    if (emission.isCore) { // which has no GL_CLAMP
        constexpr std::array wraps{&SamplerState::wrapS, &SamplerState::wrapT, &SamplerState::wrapR};
        const auto others = emission.keys.decided(
            emission.scene, samplerPaths(index),
            [&](const Scene& scene) {
                const Texture& given = scene.textures[index];
                const Wrap other = readsNearestAlone(given) ? Wrap::ClampToEdge : Wrap::ClampToBorder;
                std::array<std::optional<Wrap>, 3> found;
                for (std::size_t i = 0; i < wraps.size(); ++i) {
                    if (given.*wraps.at(i) == Wrap::Clamp)
                        found.at(i) = other;
                }
                return found;
            },
            N_("OpenGL 3.3 has no GL_CLAMP"));
        for (std::size_t i = 0; i < wraps.size(); ++i)
            texture.*wraps.at(i) = others.at(i).value_or(texture.*wraps.at(i));
    }
    texture.baseLevel = std::max(0, texture.baseLevel); // OpenGL refuses another
    return texture;
}

/// The calls of glTexParameter.
void writeParameters(Emission& emission, const Texture& texture, std::size_t object) {
    static const Texture initial;
    const auto [index, target] = emission.objects[object];
    const std::string variable = fmt::format("texture{}", object);
    const Holder holder{textureTable(), &texture, &initial, elementOf<&Scene::textures>(index),
                        variable,       variable, target};
    for (const ParamRow& row : holder.table.params) {
        if (row.glCall.starts_with("glTexParameter") && hasEffect(row, texture, target, emission))
            emission.writer.row(holder, row);
    }
}

/// The first unit that shows an object, or that may, as its texture is another one at times.
std::optional<std::size_t> unitOf(const Emission& emission, const TextureObject& object) {
    for (std::size_t p = 0; p < emission.scene.passes.size(); ++p) {
        const Pass& pass = emission.scene.passes[p];
        for (std::size_t u = 0; u < maxUnits && drawsAnything(emission.scene, pass); ++u) {
            const Unit& unit = pass.units[u];
            if (unit.enabled && unit.target == object.target &&
                (static_cast<std::size_t>(unit.texture) == object.texture ||
                 emission.keys.moves(unitPath(p, u, {keyOf<&Unit::texture>()}))))
                return u;
        }
    }
    return std::nullopt;
}

/// The maximum level that OpenGL is given, where it isn't the scene's.
std::optional<int> givenMaxLevel(Emission& emission, std::size_t object) {
    const std::size_t index = emission.objects[object].texture;
    const auto& code = emission.texels[object];
    if (!code || !*code)
        return std::nullopt;
    const auto given = [&](const Scene& scene) -> std::optional<int> {
        const Texture& texture = scene.textures[index];
        const int level = appliedTexture(texture, (*code)->shape, (*code)->lastLevel, {}).texture.maxLevel;
        return level == texture.maxLevel ? std::nullopt : std::optional(level);
    };
    const Sentence anotherLevel = N_("OpenGL is given another maximum level than the scene's");
    const std::optional<int> level =
        emission.keys.decided(emission.scene,
                              texturePaths(index, {keyOf<&Texture::baseLevel>(), keyOf<&Texture::maxLevel>(),
                                                   keyOf<&Texture::minFilter>()}),
                              given, anotherLevel);
    if (const std::string path = texturePaths(index, {keyOf<&Texture::maxLevel>()}).front();
        level && emission.keys.moves(path))
        emission.keys.refuse(path, anotherLevel);
    return level;
}

/// Where a renderer gives OpenGL another than the scene's.
void writeMaxLevel(Emission& emission, const Holder& holder, std::size_t object) {
    const Texture& texture = emission.scene.textures[emission.objects[object].texture];
    if (texture.source == SourceKind::LightDepth && !isShadowMap(emission, object))
        return;
    const std::optional<int> level = givenMaxLevel(emission, object);
    if (!level)
        return;
    const bool isFew = *level < texture.maxLevel;
    emission.writer.add(
        {call("glTexParameteri"),
         plain(fmt::format("({}, {}, {}); ", rowOf(holder.target).name,
                           glNameOf(*findParam(textureTable(), keyOf<&Texture::maxLevel>())), *level)),
         {Part::Kind::Comment,
          isFew ? "/* there are no more levels */" : "/* at least the base level, or Mesa crashes */"}});
}

void writeTexture(Emission& emission, std::size_t object) {
    static const Texture initial;
    const auto [index, target] = emission.objects[object];
    const Texture texture = adapted(emission, object);
    const std::string variable = fmt::format("texture{}", object);
    const Holder holder{textureTable(), &texture, &initial, elementOf<&Scene::textures>(index),
                        variable,       variable, target};
    CodeWriter& writer = emission.writer;
    writer.heading(fmt::format("texture {}: {}", index, originOf(texture)));
    writer.open(fmt::format("static void loadTexture{}(void)", object));
    writer.add(
        callWith("glBindTexture", {plain(fmt::format("{}, textures[{}]", rowOf(target).name, object))}));
    const auto& code = emission.texels[object];
    // The driver makes levels above the base level alone.
    const bool levelsFirst = code && *code && isMadeByDriver((*code)->mipmaps) &&
                             emission.keys.decided(
                                 emission.scene, texturePaths(index, {keyOf<&Texture::baseLevel>()}),
                                 [i = index](const Scene& scene) { return scene.textures[i].baseLevel > 0; },
                                 N_("the driver makes the levels only once"));
    if (levelsFirst)
        writeTexels(emission, holder, object);
    writeParameters(emission, texture, object);
    if (emission.isCore && emission.texels[object] && *emission.texels[object])
        writeSwizzle(emission, (*emission.texels[object])->shape, target);
    writeMaxLevel(emission, holder, object);
    if (!levelsFirst)
        writeTexels(emission, holder, object);
    writer.close();
}

} // namespace

std::vector<TextureObject> textureObjectsOf(const Scene& scene, const KeyFrames& keys) {
    std::vector<TextureObject> pairs; // as they are shown
    for (std::size_t p = 0; p < scene.passes.size(); ++p) {
        for (std::size_t u = 0; u < maxUnits; ++u) {
            const Unit& unit = scene.passes[p].units[u];
            const std::string path = unitPath(p, u, {keyOf<&Unit::texture>()});
            for (const int texture : keys.indicesOf(path, unit.texture)) {
                const auto index = static_cast<std::size_t>(texture);
                if (scene.passes[p].enabled && unit.enabled && index < scene.textures.size())
                    pairs.push_back({index, unit.target});
            }
        }
    }
    std::vector<TextureObject> objects;
    for (std::size_t i = 0; i < scene.textures.size(); ++i) {
        const auto first = std::ranges::find(pairs, i, &TextureObject::texture);
        objects.push_back(first == pairs.end() ? TextureObject{i, Target::Texture2D} : *first);
    }
    for (const TextureObject& pair : pairs) {
        if (std::ranges::find(objects, pair) == objects.end())
            objects.push_back(pair);
    }
    return objects;
}

std::vector<std::string> texturePaths(std::size_t texture, std::initializer_list<std::string> keys) {
    std::vector<std::string> paths;
    for (const std::string& key : keys)
        paths.push_back(fmt::format("{}.{}", elementOf<&Scene::textures>(texture), key));
    return paths;
}

std::vector<std::string> samplerPaths(std::size_t texture) {
    return texturePaths(texture,
                        {keyOf<&Texture::minFilter>(), keyOf<&Texture::magFilter>(), keyOf<&Texture::wrapS>(),
                         keyOf<&Texture::wrapT>(), keyOf<&Texture::wrapR>()});
}

bool readsNearestAlone(const Texture& texture) {
    return texture.magFilter == MagFilter::Nearest && !reference::isLinear(texture.minFilter);
}

void writeTextures(Emission& emission) {
    const std::size_t count = emission.objects.size();
    if (count > emission.leftOut.size())
        emission.atStart.add(fmt::format("static GLuint textures[{}];", count));
    for (std::size_t i = 0; i < count; ++i) {
        if (!emission.leftOut.contains(i))
            writeTexture(emission, i);
    }
}

void writeMovingTextures(Emission& emission) {
    CodeWriter& writer = emission.writer;
    for (std::size_t i = 0; i < emission.objects.size(); ++i) {
        const TextureObject& object = emission.objects[i];
        const std::optional<std::size_t> unit = unitOf(emission, object);
        if (!unit || emission.leftOut.contains(i) ||
            !writer.movesBelow(elementOf<&Scene::textures>(object.texture) + "."))
            continue;
        static_cast<void>(givenMaxLevel(emission, i));
        const std::size_t start = writer.size();
        writer.heading(fmt::format("texture {}", object.texture));
        writer.add(fmt::format("glActiveTexture({});", textureUnitName(*unit)),
                   emission.isCore || emission.activeUnit != static_cast<int>(*unit));
        writer.add(fmt::format("glBindTexture({}, textures[{}]);", rowOf(object.target).name, i));
        const std::size_t size = writer.size();
        writer.take(Taking::Moving);
        writeParameters(emission, adapted(emission, i), i);
        writer.take(Taking::All);
        if (writer.size() == size)
            writer.truncate(start);
        else
            emission.activeUnit = static_cast<int>(*unit);
    }
}

} // namespace texplorer::emit

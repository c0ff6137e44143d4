#include "core/emit/emission.h"
#include "core/scene/params/keys.h"

#include <fmt/core.h>

#include <algorithm>

namespace texplorer::emit {
namespace {

/// Whether a target and an internal format have what a row of glTexParameter sets.
bool hasEffect(const ParamRow& row, const Texture& texture, Target target) {
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
        break;
    }
    return std::string(rowOf(texture.source).label);
}

void writeTexture(Emission& emission, std::size_t object) {
    static const Texture initial;
    const auto [index, target] = emission.objects[object];
    const Texture& texture = emission.scene.textures[index];
    const std::string variable = fmt::format("texture{}", object);
    const Holder holder{textureTable(), &texture, &initial, elementOf<&Scene::textures>(index),
                        variable,       variable, target};
    CodeWriter& writer = emission.writer;
    writer.heading(fmt::format("texture {}: {}", index, originOf(texture)));
    writer.open(fmt::format("static void loadTexture{}(void)", object));
    writer.add(
        callWith("glBindTexture", {plain(fmt::format("{}, textures[{}]", rowOf(target).name, object))}));
    for (const ParamRow& row : holder.table.params) {
        if (row.glCall.starts_with("glTexParameter") && hasEffect(row, texture, target))
            writer.row(holder, row);
    }
    writeTexels(emission, holder, object);
    writer.close();
}

} // namespace

std::vector<TextureObject> textureObjectsOf(const Scene& scene) {
    std::vector<TextureObject> pairs; // as they are shown
    for (const Pass& pass : scene.passes) {
        for (const Unit& unit : pass.units) {
            if (pass.enabled && unit.enabled &&
                static_cast<std::size_t>(unit.texture) < scene.textures.size())
                pairs.push_back({static_cast<std::size_t>(unit.texture), unit.target});
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

void writeTextures(Emission& emission) {
    const std::size_t count = emission.objects.size();
    if (count > 0)
        emission.atStart.add(fmt::format("static GLuint textures[{}];", count));
    for (std::size_t i = 0; i < count; ++i)
        writeTexture(emission, i);
}

} // namespace texplorer::emit

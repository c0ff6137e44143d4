#include "app/ui/model/level_edits.h"

#include "texplorer/scene/params/keys.h"
#include "texplorer/scene/params/param_text.h"

#include <fmt/core.h>

#include <tuple>
#include <utility>

namespace texplorer::ui {
namespace {

/// Continues the step of a drag.
void drag(const Session& session, Sentence name, std::string path, std::string value) {
    submit(session, {.name = std::move(name),
                     .edits = {edit::Set{path, std::move(value)}},
                     .path = path,
                     .continues = true});
}

template<auto Member, class Value>
void setOfTexture(const Session& session, Value value, const char* name) {
    const Texture* texture = boundTexture(session);
    if (!texture || texture->*Member == value)
        return;
    const auto index = static_cast<std::size_t>(selectedUnit(session).texture);
    drag(session, name, fmt::format("{}.{}", elementOf<&Scene::textures>(index), keyOf<Member>()),
         formatNumber(static_cast<float>(value)));
}

Texture& textureIn(Scene& scene, int index) {
    return scene.textures.at(static_cast<std::size_t>(index));
}

bool reads(const Texture& texture, int base, int max) {
    return texture.baseLevel == base && texture.maxLevel == max;
}

} // namespace

void followForced(Session& session) {
    std::optional<ForcedLevel>& forced = session.document.forced;
    const Texture* texture = boundTexture(session);
    if (forced && (!texture || selectedUnit(session).texture != forced->texture ||
                   !reads(*texture, forced->level, forced->level)))
        forced.reset();
}

void toggleForced(Session& session, int level) {
    const Texture* texture = boundTexture(session);
    if (!texture)
        return;
    followForced(session);
    std::optional<ForcedLevel>& forced = session.document.forced;
    const bool isForced = reads(*texture, level, level);
    std::pair levels{level, level};
    if (isForced)
        levels = forced ? std::pair{forced->baseLevel, forced->maxLevel} : std::pair{0, noMaxLevel};
    if (isForced)
        forced.reset();
    else if (forced) // from one level to the next: the first range is restored in the end
        forced->level = level;
    else
        forced = {selectedUnit(session).texture, level, texture->baseLevel, texture->maxLevel};
    submit(session, isForced ? N_("Read the previous levels") : Sentence("Read level {0} alone", level),
           [levels, index = selectedUnit(session).texture](Scene& scene) {
               std::tie(textureIn(scene, index).baseLevel, textureIn(scene, index).maxLevel) = levels;
           });
}

void setBaseLevel(const Session& session, int level) {
    setOfTexture<&Texture::baseLevel>(session, level, N_("Set base level"));
}

void setMaxLevel(const Session& session, int level) {
    setOfTexture<&Texture::maxLevel>(session, level, N_("Set max level"));
}

void setMinLod(const Session& session, float lod) {
    setOfTexture<&Texture::minLod>(session, lod, N_("Set min LOD"));
}

void setMaxLod(const Session& session, float lod) {
    setOfTexture<&Texture::maxLod>(session, lod, N_("Set max LOD"));
}

void setTextureBias(const Session& session, float bias) {
    setOfTexture<&Texture::lodBias>(session, bias, N_("Set LOD bias"));
}

void setUnitBias(const Session& session, float bias) {
    if (selectedUnit(session).lodBias != bias)
        drag(session, N_("Set LOD bias of the unit"),
             fmt::format("{}.{}", selectedUnitPath(session), keyOf<&Unit::lodBias>()), formatNumber(bias));
}

float biasOf(const Session& session) {
    const Texture* texture = boundTexture(session);
    return (texture ? texture->lodBias : 0) + selectedUnit(session).lodBias;
}

bool limitsLevels(const Session& session) {
    const Texture* texture = boundTexture(session);
    return texture && (!reads(*texture, 0, noMaxLevel) || texture->minLod != noMinLod ||
                       texture->maxLod != noMaxLod || texture->lodBias != 0 || biasOf(session) != 0);
}

void readAllLevels(const Session& session) {
    const Selection& at = session.look.selection;
    submit(session, "Read all levels", [&at](Scene& scene) {
        Unit& unit = selectedUnit(scene, at);
        unit.lodBias = 0;
        const Texture initial;
        Texture& texture = textureIn(scene, unit.texture);
        texture.baseLevel = initial.baseLevel;
        texture.maxLevel = initial.maxLevel;
        texture.minLod = initial.minLod;
        texture.maxLod = initial.maxLod;
        texture.lodBias = initial.lodBias;
    });
}

} // namespace texplorer::ui

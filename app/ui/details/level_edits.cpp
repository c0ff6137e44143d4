#include "app/ui/details/level_edits.h"

#include "core/scene/params/keys.h"

#include <fmt/core.h>

#include <tuple>
#include <utility>

namespace texplorer::ui {
namespace {

template<auto Member, class Value>
void setOfTexture(Session& session, Value value, const char* what) {
    Texture* texture = boundTexture(session);
    if (!texture || texture->*Member == value)
        return;
    texture->*Member = value;
    recordEdit(
        session, what,
        fmt::format("{}.{}",
                    elementOf<&Scene::textures>(static_cast<std::size_t>(selectedUnit(session).texture)),
                    keyOf<Member>()));
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
    Texture* texture = boundTexture(session);
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
    sealEdit(session);
    std::tie(texture->baseLevel, texture->maxLevel) = levels;
    recordEdit(session, isForced ? "Read the previous levels" : fmt::format("Read level {} alone", level));
    sealEdit(session);
}

void setBaseLevel(Session& session, int level) {
    setOfTexture<&Texture::baseLevel>(session, level, "Set base level");
}

void setMaxLevel(Session& session, int level) {
    setOfTexture<&Texture::maxLevel>(session, level, "Set max level");
}

void setMinLod(Session& session, float lod) {
    setOfTexture<&Texture::minLod>(session, lod, "Set min LOD");
}

void setMaxLod(Session& session, float lod) {
    setOfTexture<&Texture::maxLod>(session, lod, "Set max LOD");
}

void setTextureBias(Session& session, float bias) {
    setOfTexture<&Texture::lodBias>(session, bias, "Set LOD bias");
}

void setUnitBias(Session& session, float bias) {
    Unit& unit = selectedUnit(session);
    if (unit.lodBias == bias)
        return;
    unit.lodBias = bias;
    recordEdit(session, "Set LOD bias of the unit",
               fmt::format("{}.{}", selectedUnitPath(session), keyOf<&Unit::lodBias>()));
}

float biasOf(const Session& session) {
    const Texture* texture = boundTexture(session);
    const Selection& at = session.window.selection;
    const Pass& pass = session.document.scene.passes[static_cast<std::size_t>(at.pass)];
    return (texture ? texture->lodBias : 0) + pass.units[static_cast<std::size_t>(at.unit)].lodBias;
}

bool limitsLevels(const Session& session) {
    const Texture* texture = boundTexture(session);
    return texture && (!reads(*texture, 0, noMaxLevel) || texture->minLod != noMinLod ||
                       texture->maxLod != noMaxLod || texture->lodBias != 0 || biasOf(session) != 0);
}

void readAllLevels(Session& session) {
    Texture* texture = boundTexture(session);
    if (!texture)
        return;
    sealEdit(session);
    const Texture initial;
    texture->baseLevel = initial.baseLevel;
    texture->maxLevel = initial.maxLevel;
    texture->minLod = initial.minLod;
    texture->maxLod = initial.maxLod;
    texture->lodBias = initial.lodBias;
    selectedUnit(session).lodBias = 0;
    recordEdit(session, "Read all levels");
    sealEdit(session);
}

} // namespace texplorer::ui

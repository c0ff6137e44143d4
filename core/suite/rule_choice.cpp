#include "texplorer/suite/rule_choice.h"

#include "texplorer/conform/report_words.h"
#include "texplorer/conform/rule.h"
#include "texplorer/reference/sampling/lod.h"
#include "texplorer/scene/drawn_models.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

namespace texplorer::suite {
namespace {

namespace rules = conform::rules;

constexpr std::array<const conform::Rule*, 12> ruleRows{
    &rules::exact,
    &rules::passes,
    &rules::blocks,
    &rules::texelEdge,
    &rules::texelEdgeOnQuads,
    &rules::levelChoice,
    &rules::levelBlend,
    &rules::foreignLevels,
    &rules::ellipse,
    &rules::outline,
    &rules::lines,
    &rules::lastBit,
};

constexpr auto allRuleNames = [] {
    std::array<std::string_view, ruleRows.size() + 2> names{"auto", "none"};
    for (std::size_t i = 0; i < ruleRows.size(); ++i)
        names[i + 2] = ruleRows[i]->name;
    return names;
}();

/// What a scene uses of what rules are about.
struct Uses {
    int passes = 0;
    bool textures = false;
    bool anisotropy = false;
    bool foreignLevels = false; ///< that aren't made of each other
    bool blendedLevels = false;
    bool chosenLevels = false; ///< or one filter near and another one far
    bool lines = false;
};

void addTexture(Uses& uses, const Texture& texture) {
    const bool hasLevels = reference::wantsMipmaps(texture.minFilter);
    const bool isForeign = texture.mipmaps == MipPolicy::Given || texture.mipmaps == MipPolicy::Colored ||
                           texture.mipmaps == MipPolicy::FromFile || isMadeByDriver(texture.mipmaps);
    uses.textures = true;
    uses.anisotropy = uses.anisotropy || texture.maxAnisotropy > 1;
    uses.foreignLevels = uses.foreignLevels || (hasLevels && isForeign);
    uses.blendedLevels = uses.blendedLevels || reference::blendsLevels(texture.minFilter);
    uses.chosenLevels = uses.chosenLevels || hasLevels ||
                        reference::isLinear(texture.minFilter) != (texture.magFilter == MagFilter::Linear);
}

bool drawsLines(const Model& model) {
    const Primitive primitive = model.mesh.primitive;
    return model.shape == Shape::Mesh &&
           (primitive == Primitive::Points || primitive == Primitive::Lines ||
            primitive == Primitive::LineStrip || primitive == Primitive::LineLoop);
}

Uses usesOf(const Scene& scene) {
    Uses uses;
    for (const Pass& pass : scene.passes) {
        if (!pass.enabled)
            continue;
        ++uses.passes;
        for (const Unit& unit : pass.units) {
            const auto texture = static_cast<std::size_t>(unit.texture); // of a negative number: beyond all
            if (unit.enabled && texture < scene.textures.size())
                addTexture(uses, scene.textures[texture]);
        }
        for (const std::size_t model : drawnModels(scene, pass))
            uses.lines = uses.lines || drawsLines(scene.models[model]);
    }
    return uses;
}

} // namespace

std::span<const std::string_view> ruleNames() {
    return allRuleNames;
}

const conform::Rule* findRule(std::string_view name) {
    const auto found =
        std::ranges::find_if(ruleRows, [name](const conform::Rule* each) { return each->name == name; });
    return found == ruleRows.end() ? nullptr : *found;
}

std::string ruleLimits() {
    std::string text;
    std::vector<std::string> said;
    for (const conform::Rule* row : ruleRows) {
        const std::string limit = conform::allowedOfScene(*row);
        if (std::ranges::find(said, limit) != said.end())
            continue;
        said.push_back(limit);
        std::vector<std::string_view> names;
        for (const conform::Rule* each : ruleRows) {
            if (conform::allowedOfScene(*each) == limit)
                names.push_back(each->name);
        }
        text += fmt::format("{}{} ({})", text.empty() ? "" : "; ", limit, fmt::join(names, ", "));
    }
    return text;
}

const conform::Rule& ruleFor(const Scene& scene) {
    const Uses uses = usesOf(scene);
    if (uses.anisotropy)
        return rules::ellipse;
    if (uses.foreignLevels)
        return rules::foreignLevels;
    if (uses.blendedLevels || (uses.textures && uses.passes > 1)) // as the feature "mixture" has it
        return rules::levelBlend;
    if (uses.chosenLevels)
        return rules::levelChoice;
    if (uses.lines)
        return rules::lines;
    return uses.textures ? rules::texelEdge : rules::outline;
}

} // namespace texplorer::suite

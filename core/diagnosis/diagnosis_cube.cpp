// Cube maps: what happens at the edges of their faces.

#include "texplorer/diagnosis/diagnosis_rules.h"
#include "texplorer/reference/sampling/lod.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace texplorer::diagnosis {
namespace {

bool isLinearSomewhere(const Texture& texture) {
    return texture.magFilter == MagFilter::Linear || reference::isLinear(texture.minFilter);
}

/// Whether coordinates from 0 to 1 reach what is beyond the edge.
bool leaves(Wrap wrap) {
    return wrap != Wrap::ClampToEdge && wrap != Wrap::MirroredRepeat;
}

/// "passes[0].seamlessCubeMap"
std::string seamlessPath(std::size_t pass) {
    return fmt::format("{}.{}", elementOf<&Scene::passes>(pass), keyOf<&Pass::seamlessCubeMap>());
}

/// In every pass that shows the texture.
Fix acrossEdges(const Case& about, std::size_t texture) {
    Fix fix{N_("Filter across the edges"), {}};
    forEachUnit(about.scene, [&](const Unit& unit, const std::string&, std::size_t p) {
        const edit::Set set{seamlessPath(p), "true"};
        if (unit.enabled && std::cmp_equal(unit.texture, texture) &&
            std::ranges::find(fix.assignments, set) == fix.assignments.end())
            fix.assignments.push_back(set);
    });
    return fix;
}

/// Section 3.8.7 wraps s and t of the one face that is hit: GL_REPEAT blends opposite edges.
void cubeSeams(const Case& about, Report& report) {
    for (std::size_t i = 0; i < about.textures.size(); ++i) {
        const Texture& texture = about.scene.textures[i];
        const bool linear = isLinearSomewhere(texture);
        if (!about.textures[i].shown || about.textures[i].seamless ||
            !about.textures[i].hasTarget(Target::CubeMap) || !linear ||
            (!leaves(texture.wrapS) && !leaves(texture.wrapT)))
            continue;
        const std::string path = elementOf<&Scene::textures>(i) + ".";
        const bool ofS = leaves(texture.wrapS);
        const std::string edge = nameOf(Wrap::ClampToEdge);
        std::vector<Fix> fixes{
            {N_("Clamp to the edges"),
             {{path + keyOf<&Texture::wrapS>(), edge}, {path + keyOf<&Texture::wrapT>(), edge}}}};
        if (about.driver.seamlessCubeMaps)
            fixes.push_back(acrossEdges(about, i));
        report.add(
            path + (ofS ? keyOf<&Texture::wrapS>() : keyOf<&Texture::wrapT>()),
            Sentence(
                "{0} reads beyond the edge of each face of a cube map, which shows as a seam; some drivers "
                "always use {1}",
                named(ofS ? texture.wrapS : texture.wrapT), named(Wrap::ClampToEdge)),
            std::move(fixes));
    }
}

/// The textures that the pass shows as cube maps.
std::vector<std::size_t> cubeMapsOf(const Case& about, const Pass& pass) {
    std::vector<std::size_t> maps;
    for (const Unit& unit : pass.units) {
        if (about.works(unit) && unit.target == Target::CubeMap)
            maps.push_back(static_cast<std::size_t>(unit.texture));
    }
    return maps;
}

/// Clamped to its edges, each face blends less and less of a texel towards them: where texels are large one
/// sees it.
void cubeEdges(const Case& about, Report& report) {
    constexpr int few = 16; // texels along an edge: a texel is 6 degrees wide
    for (std::size_t p = 0; p < about.scene.passes.size(); ++p) {
        const Pass& pass = about.scene.passes[p];
        if (!pass.enabled || pass.seamlessCubeMap || !about.driver.seamlessCubeMaps)
            continue;
        for (const std::size_t map : cubeMapsOf(about, pass)) {
            const Texture& texture = about.scene.textures[map];
            const auto& levels = about.textures[map].as(Target::CubeMap)->plan.levels;
            const auto base = std::ranges::find(levels, texture.baseLevel, &PlannedLevel::number);
            if (base == levels.end() || base->width > few || !isLinearSomewhere(texture) ||
                leaves(texture.wrapS) || leaves(texture.wrapT)) // which is said already
                continue;
            report.add(seamlessPath(p),
                       Sentence("each face of textures[{0}] has {1} × {2} texels and is filtered on its "
                                "own: seams show along the edges of the cube",
                                map, base->width, base->height),
                       acrossEdges(about, map));
            break;
        }
    }
}

void noSeamlessCubeMaps(const Case& about, Report& report) {
    for (std::size_t p = 0; p < about.scene.passes.size(); ++p) {
        const Pass& pass = about.scene.passes[p];
        if (pass.enabled && pass.seamlessCubeMap && !about.driver.seamlessCubeMaps &&
            std::ranges::any_of(
                pass.units, [](const Unit& unit) { return unit.enabled && unit.target == Target::CubeMap; }))
            report.add(seamlessPath(p), N_("the driver has no seamless cube maps: drawn without"),
                       Fix{N_("Do without"), {{seamlessPath(p), "false"}}});
    }
}

void seamlessInVain(const Case& about, Report& report) {
    for (std::size_t p = 0; p < about.scene.passes.size(); ++p) {
        const Pass& pass = about.scene.passes[p];
        if (!pass.enabled)
            continue;
        const std::vector<std::size_t> maps = cubeMapsOf(about, pass);
        if (maps.empty())
            report.add(seamlessPath(p), N_("no unit of this pass shows a cube map"));
        else if (std::ranges::none_of(maps, [&](std::size_t map) {
                     const Texture& texture = about.scene.textures[map];
                     return isLinearSomewhere(texture) || leaves(texture.wrapS) || leaves(texture.wrapT);
                 }))
            report.add(seamlessPath(p),
                       Sentence("{0} reads one texel, of the face that is hit", named(MagFilter::Nearest)));
    }
}

constexpr std::array cubeRuleRows{
    Rule{"cube-seams", Severity::Warning, cubeSeams},
    Rule{"cube-edges", Severity::Note, cubeEdges},
    Rule{"no-seamless-cube-maps", Severity::Warning, noSeamlessCubeMaps, true},
    Rule{"seamless-in-vain", Severity::Hint, seamlessInVain},
};

} // namespace

std::span<const Rule> cubeRules() {
    return cubeRuleRows;
}

} // namespace texplorer::diagnosis

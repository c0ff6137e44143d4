// Texture units: what they ask for and can't have, what the environment leaves undefined, and what changes
// nothing.

#include "texplorer/diagnosis/color_flow.h"
#include "texplorer/gl/combine_arguments.h"
#include "texplorer/scene/drawn_models.h"
#include "texplorer/scene/emboss.h"
#include "texplorer/scene/model_mesh.h"
#include "texplorer/scene/params/param_text.h"
#include "texplorer/scene/sent_vertices.h"
#include "texplorer/scene/tex_coords.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace texplorer::diagnosis {
namespace {

struct Generated {
    Key key;
    TexGen Unit::*state;
};
constexpr std::array<Generated, 4> generated{{{keyOf<&Unit::texGenS>, &Unit::texGenS},
                                              {keyOf<&Unit::texGenT>, &Unit::texGenT},
                                              {keyOf<&Unit::texGenR>, &Unit::texGenR},
                                              {keyOf<&Unit::texGenQ>, &Unit::texGenQ}}};

void missingTexture(const Case& about, Report& report) {
    const std::size_t count = about.textures.size();
    forEachUnit(about.scene, [&](const Unit& unit, const std::string& path, std::size_t) {
        if (!unit.enabled || about.textureOf(unit))
            return;
        Fix fix{N_("Switch the unit off"), {{path + keyOf<&Unit::enabled>(), "false"}}};
        if (count > 0)
            fix = {N_("Bind texture 0"), {{path + keyOf<&Unit::texture>(), "0"}}};
        report.add(path + keyOf<&Unit::texture>(),
                   Sentence("there is no texture {0}, the scene has {1}", unit.texture, count),
                   std::move(fix));
    });
}

/// A pass that blends does what a unit's environment does, where that is a product or a sum.
Sentence insteadOfUnit(EnvMode mode) {
    struct Row {
        EnvMode mode;
        BlendFactor source;
        BlendFactor destination;
    };
    constexpr std::array rows{Row{EnvMode::Modulate, BlendFactor::DstColor, BlendFactor::Zero},
                              Row{EnvMode::Add, BlendFactor::One, BlendFactor::One},
                              Row{EnvMode::Decal, BlendFactor::SrcAlpha, BlendFactor::OneMinusSrcAlpha}};
    const auto* found = std::ranges::find(rows, mode, &Row::mode);
    return found == rows.end()
               ? N_("use more passes with blending instead of more units")
               : Sentence("one more pass with its texture alone, blended with {0} and {1}, does the same",
                          named(found->source), named(found->destination));
}

void unitLimit(const Case& about, Report& report) {
    const auto limit = static_cast<std::size_t>(std::max(0, about.driver.textureUnits));
    for (std::size_t p = 0; p < about.scene.passes.size(); ++p) {
        for (std::size_t u = limit; u < maxUnits; ++u) {
            const Unit& unit = about.scene.passes[p].units[u];
            if (!about.scene.passes[p].enabled || !unit.enabled)
                continue;
            const std::string path = unitPath(p, u) + keyOf<&Unit::enabled>();
            report.add(path,
                       Sentence("the driver has {0}: drawn without this one; {1}",
                                Sentence::plural("{0} texture unit", "{0} texture units", limit),
                                insteadOfUnit(unit.envMode)),
                       Fix{N_("Switch the unit off"), {{path, "false"}}});
        }
    }
}

/// Table 3.21 has no entry for DECAL with these base formats.
void undefinedDecal(const Case& about, Report& report) {
    forEachUnit(about.scene, [&](const Unit& unit, const std::string& path, std::size_t) {
        const TextureFacts* texture = about.textureOf(unit);
        const TargetFacts* facts = texture ? texture->as(unit.target) : nullptr;
        if (!unit.enabled || unit.envMode != EnvMode::Decal || !facts || facts->format == BaseFormat::Rgb ||
            facts->format == BaseFormat::Rgba)
            return;
        report.add(
            path + keyOf<&Unit::envMode>(),
            Sentence("{0} of a {1} texture is undefined: it needs {2} or {3}", named(unit.envMode),
                     named(facts->format), named(BaseFormat::Rgb), named(BaseFormat::Rgba)),
            Fix{Sentence("Make it {0}", named(BaseFormat::Rgba)),
                {{fmt::format("{}.{}", elementOf<&Scene::textures>(static_cast<std::size_t>(unit.texture)),
                              keyOf<&Texture::internalFormat>()),
                  nameOf(BaseFormat::Rgba)}}});
    });
}

/// Whether r can be anything but 0 when it comes from the models: the meshes have none.
bool modelsHaveR(const Scene& scene, std::size_t unit) {
    return std::ranges::any_of(scene.models, [&](const Model& model) {
        const SharedList<glm::vec4>& own = model.texCoords[unit];
        const SharedList<glm::vec4>& list =
            own.empty() && model.shape == Shape::Mesh ? model.mesh.texCoords : own;
        return std::ranges::any_of(list, [](const glm::vec4& each) { return each.z != 0; });
    });
}

void flatDirection(const Case& about, Report& report) {
    for (std::size_t p = 0; p < about.scene.passes.size(); ++p) {
        for (std::size_t u = 0; u < maxUnits; ++u) {
            const Unit& unit = about.scene.passes[p].units[u];
            if (!about.scene.passes[p].enabled || !unit.enabled || unit.target != Target::CubeMap ||
                unit.texGenR.enabled || hasMatrix(about.scene, p, u) || modelsHaveR(about.scene, u))
                continue;
            Fix fix{N_("Reflect"), {}};
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const std::string own = unitPath(p, u) + generated[axis].key();
                fix.assignments.push_back(
                    {fmt::format("{}.{}", own, keyOf<&TexGen::mode>()), nameOf(TexGenMode::ReflectionMap)});
                fix.assignments.push_back({fmt::format("{}.{}", own, keyOf<&TexGen::enabled>()), "true"});
            }
            report.add(
                unitPath(p, u) + keyOf<&Unit::target>(),
                Sentence("a cube map uses s, t and r as a direction, but r is 0 at every vertex: only a line "
                         "around the sides of the cube is seen; {0} or {1} generates all three",
                         named(TexGenMode::ReflectionMap), named(TexGenMode::NormalMap)),
                std::move(fix));
        }
    }
}

/// GL's initial planes for q are 0: enabled alone, they divide by zero.
void generatedZeroQ(const Case& about, Report& report) {
    forEachUnit(about.scene, [&](const Unit& unit, const std::string& path, std::size_t) {
        const TexGen& q = unit.texGenQ;
        const bool object = q.mode == TexGenMode::ObjectLinear;
        if (!unit.enabled || !q.enabled || (object ? q.objectPlane : q.eyePlane) != glm::vec4(0))
            return;
        const std::string plane = path + (object ? pathOf<&Unit::texGenQ, &TexGen::objectPlane>()
                                                 : pathOf<&Unit::texGenQ, &TexGen::eyePlane>());
        report.add(plane, N_("this plane makes q 0 everywhere, but s, t and r are divided by q"),
                   Fix{N_("Make q 1"), {{plane, "0,0,0,1"}}});
    });
}

/// A scene's list of units may choose all but the one thing that counts.
void unitOff(const Case& about, Report& report) {
    forEachUnit(about.scene, [&](const Unit& unit, const std::string& path, std::size_t) {
        if (unit.enabled)
            return;
        std::vector<Fix> fixes;
        if (about.textureOf(unit))
            fixes = {{N_("Switch the unit on"), {{path + keyOf<&Unit::enabled>(), "true"}}}};
        report.add(path.substr(0, path.size() - 1), N_("the unit is off"), std::move(fixes));
    });
}

bool readsConstant(const Case& about, const Unit& unit) {
    const TextureFacts* texture = about.textureOf(unit);
    const TargetFacts* facts = texture ? texture->as(unit.target) : nullptr;
    if (unit.envMode == EnvMode::Blend) // table 3.22: an alpha texture leaves the colour alone
        return !facts || facts->format != BaseFormat::Alpha;
    if (unit.envMode != EnvMode::Combine)
        return false;
    return std::ranges::any_of(argumentsOf(unit.combine), [](const Argument& each) {
        return each.read && each.source == CombineSource::Constant;
    });
}

void noEnvColor(const Case& about, Report& report) {
    forEachUnit(about.scene, [&](const Unit& unit, const std::string& path, std::size_t) {
        if (!readsConstant(about, unit))
            report.add(path + keyOf<&Unit::envColor>(),
                       Sentence("the environment colour is used only by {0} and by {1}'s {2}",
                                named(EnvMode::Blend), named(EnvMode::Combine),
                                named(CombineSource::Constant)));
    });
}

void noLodBias(const Case& about, Report& report) {
    forEachUnit(about.scene, [&](const Unit& unit, const std::string& path, std::size_t) {
        if (!about.textureOf(unit))
            return;
        const Texture& texture = about.scene.textures[static_cast<std::size_t>(unit.texture)];
        if (static_cast<std::uint32_t>(texture.minFilter) == static_cast<std::uint32_t>(texture.magFilter))
            report.add(
                path + keyOf<&Unit::lodBias>(),
                Sentence("{0} reads no mipmaps, and both filters are the same", named(texture.minFilter)));
    });
}

bool comparesDepths(const Texture& texture) {
    return isDepth(texture.internalFormat) && texture.compareMode == CompareMode::RToTexture;
}

void noGeneration(const Case& about, Report& report) {
    forEachUnit(about.scene, [&](const Unit& unit, const std::string& path, std::size_t p) {
        for (const Generated& each : generated) {
            const TexGen& state = unit.*each.state;
            const std::string own = fmt::format("{}{}.", path, each.key());
            const Sentence reason = state.enabled
                                        ? Sentence("{0} does not read this plane", named(state.mode))
                                        : N_("the vertex's own coordinate is taken");
            if (!state.enabled)
                report.add(own + keyOf<&TexGen::mode>(), reason);
            if (!state.enabled || state.mode != TexGenMode::ObjectLinear)
                report.add(own + keyOf<&TexGen::objectPlane>(), reason);
            if (!state.enabled || state.mode != TexGenMode::EyeLinear)
                report.add(own + keyOf<&TexGen::eyePlane>(), reason);
        }
        // Without a matrix that could carry them over, coordinates that the target has not are lost.
        const bool compares = about.textureOf(unit) &&
                              comparesDepths(about.scene.textures[static_cast<std::size_t>(unit.texture)]);
        const int axes = compares ? 3 : coordinatesOf(unit.target); // r is compared
        const auto index = static_cast<std::size_t>(&unit - about.scene.passes[p].units.data());
        for (int axis = axes; axis < 3 && !hasMatrix(about.scene, p, index); ++axis) {
            const Generated& each = generated[static_cast<std::size_t>(axis)];
            if ((unit.*each.state).enabled)
                report.add(fmt::format("{}{}.{}", path, each.key(), keyOf<&TexGen::enabled>()),
                           Sentence("{0} ignores this coordinate", named(unit.target)));
        }
    });
}

/// The later unit that ends what leaves this one, or nothing where some of it reaches the fragment.
std::optional<std::size_t> overrulerOf(const Case& about, const Pass& pass, std::size_t unit) {
    const auto limit = static_cast<std::size_t>(std::max(0, about.driver.textureUnits));
    ColorFlow flow = wholeColor;
    for (std::size_t later = unit + 1; later < std::min<std::size_t>(maxUnits, limit); ++later) {
        if (!about.works(pass.units[later]))
            continue;
        flow = flowThrough(about, pass, pass.units[later], flow, {});
        if (!flow.all().any())
            return later;
    }
    return std::nullopt;
}

/// Whether a crossbar takes this unit's texture.
bool isAsked(const Case& about, const Pass& pass, std::size_t asked) {
    return std::ranges::any_of(pass.units, [&](const Unit& unit) {
        return about.works(unit) && unit.envMode == EnvMode::Combine &&
               std::ranges::any_of(argumentsOf(unit.combine), [&](const Argument& each) {
                   return each.read && crossbarUnit(each.source) == asked;
               });
    });
}

void overruledUnit(const Case& about, Report& report) {
    forEachUnit(about.scene, [&](const Unit& unit, const std::string& path, std::size_t p) {
        const Pass& pass = about.scene.passes[p];
        const auto index = static_cast<std::size_t>(&unit - pass.units.data());
        const auto later = about.works(unit) ? overrulerOf(about, pass, index) : std::nullopt;
        if (!later)
            return;
        const Sentence reason = Sentence("unit {0} replaces the result of the units before it", *later);
        if (!isAsked(about, pass, index) && !isLeftMatrixRead(about.scene, p, index))
            return report.add(path.substr(0, path.size() - 1), reason);
        for (const Key key : {keyOf<&Unit::envMode>, keyOf<&Unit::envColor>, keyOf<&Unit::combine>})
            report.add(path + key(), reason); // its texture or its matrix is read elsewhere
    });
}

void overruledTexture(const Case& about, Report& report) {
    for (std::size_t i = 0; i < about.textures.size(); ++i) {
        bool reaches = !about.textures[i].shown;
        forEachUnit(about.scene, [&](const Unit& unit, const std::string&, std::size_t p) {
            if (!unit.enabled || unit.texture != static_cast<int>(i))
                return;
            const Pass& pass = about.scene.passes[p];
            const auto index = static_cast<std::size_t>(&unit - pass.units.data());
            reaches |= !about.works(unit) || isAsked(about, pass, index) || !overrulerOf(about, pass, index);
        });
        if (!reaches)
            report.add(elementOf<&Scene::textures>(i),
                       N_("later units replace the result of those that show it"));
    }
}

/// Coordinates that are the same all over a triangle, or along it, say no direction to move into.
void noTangent(const Case& about, Report& report) {
    for (std::size_t p = 0; p < about.scene.passes.size(); ++p) {
        const Pass& pass = about.scene.passes[p];
        for (std::size_t u = 0; u < maxUnits; ++u) {
            if (!pass.units[u].enabled || !pass.units[u].emboss.enabled)
                continue;
            for (const std::size_t m : drawnModels(about.scene, pass)) {
                const SentModel model(about.scene.models[m]);
                const Mesh mesh = meshOf(*model);
                const auto tangents = tangentsOf(mesh, effectiveTexCoords(*model, mesh, static_cast<int>(u)));
                const auto missing =
                    static_cast<std::size_t>(std::ranges::count_if(tangents, [](const Tangents& each) {
                        return each.s == glm::vec3(0) || each.t == glm::vec3(0);
                    }));
                if (missing > 0)
                    report.add(
                        fmt::format("{}{}.{}", unitPath(p, u), keyOf<&Unit::emboss>(),
                                    keyOf<&Emboss::enabled>()),
                        missing == tangents.size()
                            ? Sentence("at all of the {0} vertices of models[{1}] the coordinates give no "
                                       "direction on the surface, so they don't follow the light",
                                       missing, m)
                            : Sentence("at {0} of the {1} vertices of models[{2}] the coordinates give no "
                                       "direction on the surface, so they don't follow the light",
                                       missing, tangents.size(), m));
            }
        }
    }
}

void embossOff(const Case& about, Report& report) {
    forEachUnit(about.scene, [&](const Unit& unit, const std::string& path, std::size_t) {
        if (unit.emboss.enabled)
            return;
        for (const Key key : {keyOf<&Emboss::depth>, keyOf<&Emboss::carrier>})
            report.add(fmt::format("{}{}.{}", path, keyOf<&Unit::emboss>(), key()),
                       N_("these coordinates don't follow the light"));
    });
}

constexpr std::array unitRuleRows{
    Rule{"missing-texture", Severity::Error, missingTexture, true},
    Rule{"unit-limit", Severity::Warning, unitLimit, true},
    Rule{"undefined-decal", Severity::Warning, undefinedDecal},
    Rule{"zero-q", Severity::Warning, generatedZeroQ},
    Rule{"flat-direction", Severity::Warning, flatDirection},
    Rule{"unit-off", Severity::Hint, unitOff},
    Rule{"no-tangent", Severity::Warning, noTangent},
    Rule{"emboss", Severity::Hint, embossOff},
    Rule{"env-color", Severity::Hint, noEnvColor},
    Rule{"lod-bias", Severity::Hint, noLodBias},
    Rule{"generation", Severity::Hint, noGeneration},
    Rule{"overruled-unit", Severity::Hint, overruledUnit},
    Rule{"overruled-texture", Severity::Hint, overruledTexture},
};

} // namespace

std::span<const Rule> unitRules() {
    return unitRuleRows;
}

} // namespace texplorer::diagnosis

// Shaders, uniforms and tests of a pass: OpenGL 3.3, core profile.

#include "texplorer/emit/glsl_emission.h"
#include "texplorer/gl/argument_names.h"
#include "texplorer/glsl/vertex_attributes.h"
#include "texplorer/reference/sampling/lod.h"
#include "texplorer/scene/drawn_models.h"
#include "texplorer/scene/model_mesh.h"
#include "texplorer/scene/params/keys.h"

#include <fmt/core.h>
#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace texplorer::emit {
namespace {

std::vector<Part> lightPart(const glm::vec4& color, const std::string& key) {
    return numbers({&color.x, 3}, fmt::format("{}.{}", keyOf<&Scene::light>(), key));
}

/// Clamped as OpenGL does; what it changes names no parameter.
std::vector<Part> colorParts(Emission& emission, const std::string& path, std::size_t count) {
    const auto given = [&](const Scene& scene) { return std::get<glm::vec4>(paramAt(scene, path)->value); };
    const auto clamped = [&](const Scene& scene) { return glm::clamp(given(scene), 0.0F, 1.0F); };
    const Sentence outside = N_("some of its values are below 0 or above 1");
    const bool isSame = emission.keys.decided(
        emission.scene, {path}, [&](const Scene& scene) { return clamped(scene) == given(scene); }, outside);
    const glm::vec4 color = clamped(emission.scene);
    if (!isSame && emission.keys.moves(path))
        emission.keys.refuse(path, outside);
    return numbers({&color.x, count}, isSame ? path : std::string());
}

/// A row of the material that a shader may ask for.
struct MaterialRow {
    std::string_view uniform;
    std::string_view suffix;
    std::vector<Part> (*values)(const Material& material, const std::string& path);
};

template<auto Member, int count>
std::vector<Part> materialNumbers(const Material& material, const std::string& path) {
    return numbers({&(material.*Member).x, count}, fmt::format("{}.{}", path, keyOf<Member>()));
}
std::vector<Part> shininessNumber(const Material& material, const std::string& path) {
    return {number(material.shininess, fmt::format("{}.{}", path, keyOf<&Material::shininess>()))};
}
std::vector<Part> colorMaterialSwitch(const Material& material, const std::string& path) {
    return {{Part::Kind::Switch, std::string(booleanName(material.colorMaterial)),
             fmt::format("{}.{}", path, keyOf<&Material::colorMaterial>())}};
}
constexpr std::array materialRows{
    MaterialRow{"colorMaterial", "1i", colorMaterialSwitch},
    MaterialRow{"materialAmbient", "3f", materialNumbers<&Material::ambient, 3>},
    MaterialRow{"materialDiffuse", "4f", materialNumbers<&Material::diffuse, 4>},
    MaterialRow{"materialSpecular", "3f", materialNumbers<&Material::specular, 3>},
    MaterialRow{"materialEmission", "3f", materialNumbers<&Material::emission, 3>},
    MaterialRow{"shininess", "1f", shininessNumber},
};

std::string materialPath(const Scene& scene, std::size_t model) {
    return scene.models[model].ownMaterial
               ? fmt::format("{}.{}", elementOf<&Scene::models>(model), keyOf<&Model::material>())
               : keyOf<&Scene::material>();
}

std::string colorPath(const Scene& scene, std::size_t model) {
    return fmt::format("{}.{}", materialPath(scene, model), keyOf<&Material::color>());
}

std::string wordsOf(const std::vector<Part>& parts) {
    return textOf(Line{parts});
}

/// Whether all models that a pass draws say the same of it, at all times.
bool isShared(const Emission& emission, const std::vector<std::size_t>& models, const MaterialRow& row) {
    const auto partsOf = [&](std::size_t model) {
        return row.values(materialOf(emission.scene, emission.scene.models[model]),
                          materialPath(emission.scene, model));
    };
    const std::vector<Part> first = partsOf(models.front());
    return std::ranges::all_of(models, [&](std::size_t model) {
        const std::vector<Part> parts = partsOf(model);
        const bool move = emission.keys.moves(parts[0].path) || emission.keys.moves(first[0].path);
        return wordsOf(parts) == wordsOf(first) && (!move || parts[0].path == first[0].path);
    });
}

bool hasOwnColors(const Model& model) {
    return model.shape == Shape::Mesh && !model.mesh.colors.empty();
}

/// Of vertices without colours, in any pass: one for all.
bool hasOneColor(const GlslEmission& glsl) {
    const Scene& scene = glsl.emission.scene;
    std::optional<glm::vec4> color;
    for (const GlslPass& pass : glsl.passes) {
        for (const std::size_t model : drawnModels(scene, scene.passes[pass.index])) {
            const glm::vec4 own = materialOf(scene, scene.models[model]).color;
            const std::string path = colorPath(scene, model);
            if (hasOwnColors(scene.models[model]) || (color && *color != own) ||
                glsl.emission.keys.moves(path))
                return false;
            color = own;
        }
    }
    return true;
}

void writeColor(GlslEmission& glsl, std::size_t model) {
    const Scene& scene = glsl.emission.scene;
    std::vector<Part> parts{plain(fmt::format("{}, ", glsl::colorAttribute))};
    append(parts, materialNumbers<&Material::color, 4>(materialOf(scene, scene.models[model]),
                                                       materialPath(scene, model)));
    glsl.emission.writer.add(callWith("glVertexAttrib4f", std::move(parts)));
}

/// A uniform's call where the shaders have it and the writer takes it: `suffix` "3f" for glUniform3f.
void writeUniform(GlslEmission& glsl, const GlslPass& pass, std::string_view suffix, std::string_view name,
                  std::vector<Part> values) {
    if (!pass.uniforms.contains(name))
        return;
    if (!glsl.emission.writer.takes(values))
        return;
    std::vector<Part> parts{plain(fmt::format("glGetUniformLocation({}, \"{}\"), ", pass.program, name))};
    append(parts, std::move(values));
    glsl.emission.writer.add(callWith(fmt::format("glUniform{}", suffix), std::move(parts)));
}

/// A unit's bias where its sum with the texture's is limited, below equation 3.18 of OpenGL 2.1.
std::optional<float> limitedBias(Emission& emission, std::size_t pass, std::size_t index) {
    const std::string own = unitPath(pass, index, {keyOf<&Unit::lodBias>()});
    const std::string texture = unitPath(pass, index, {keyOf<&Unit::texture>()});
    std::vector<std::string> paths{own, texture};
    for (const int shown : emission.keys.indicesOf(texture, emission.scene.passes[pass].units[index].texture))
        paths.push_back(texturePaths(static_cast<std::size_t>(shown), {keyOf<&Texture::lodBias>()}).front());
    const Sentence isLimited = N_("the sum of the two biases reaches its limit");
    const auto limited = emission.keys.decided(
        emission.scene, paths,
        [&](const Scene& scene) -> std::optional<float> {
            constexpr float limit = reference::SampleOptions{}.maxBias;
            const Unit& unit = scene.passes[pass].units[index];
            const float bias = scene.textures[static_cast<std::size_t>(unit.texture)].lodBias;
            const float sum = bias + unit.lodBias;
            return std::abs(sum) > limit ? std::optional(std::copysign(limit, sum) - bias) : std::nullopt;
        },
        isLimited);
    if (limited && emission.keys.moves(own))
        emission.keys.refuse(own, isLimited);
    return limited;
}

void writeUnitUniforms(GlslEmission& glsl, const GlslPass& pass, std::size_t index) {
    const Unit& unit = glsl.emission.scene.passes[pass.index].units[index];
    const std::string path = unitPath(pass.index, index);
    writeUniform(glsl, pass, "1i", fmt::format("texture{}", index), {plain(fmt::format("{}", index))});
    writeUniform(glsl, pass, "4f", fmt::format("environmentColor{}", index),
                 colorParts(glsl.emission, fmt::format("{}.{}", path, keyOf<&Unit::envColor>()), 4));
    const std::optional<float> limited = limitedBias(glsl.emission, pass.index, index);
    writeUniform(glsl, pass, "1f", fmt::format("lodBias{}", index),
                 {number(limited.value_or(unit.lodBias),
                         limited ? std::string() : fmt::format("{}.{}", path, keyOf<&Unit::lodBias>()))});
    for (const auto& [state, key, letter] : generatedCoordinates) {
        const TexGen& generated = unit.*state;
        const bool isObject = generated.mode == TexGenMode::ObjectLinear;
        const glm::vec4& plane = isObject ? generated.objectPlane : generated.eyePlane;
        writeUniform(glsl, pass, "4f", fmt::format("plane{}{}", index, letter),
                     numbers({&plane.x, 4}, fmt::format("{}.{}.{}", path, key(),
                                                        isObject ? keyOf<&TexGen::objectPlane>()
                                                                 : keyOf<&TexGen::eyePlane>())));
    }
    writeGlslMatrix(glsl, pass, index, MatrixTime::Once);
}

/// Of 255, as OpenGL compares alpha of 8 bits.
std::vector<Part> alphaReference(const Emission& emission, std::size_t pass) {
    const float reference = emission.scene.passes[pass].alphaRef;
    const std::string path = fmt::format("{}.{}", elementOf<&Scene::passes>(pass), keyOf<&Pass::alphaRef>());
    if (!emission.keys.moves(path))
        return {number(std::round(std::clamp(reference, 0.0F, 1.0F) * 255))};
    return {plain("roundf("), number(reference, path), plain(" * 255.0f)")};
}

void addUniforms(std::set<std::string, std::less<>>& names, std::string_view source) {
    constexpr std::string_view word = "\nuniform ";
    for (std::size_t at = source.find(word); at != std::string_view::npos; at = source.find(word, at + 1)) {
        const std::size_t end = source.find(';', at);
        const std::size_t begin = source.rfind(' ', end) + 1;
        names.emplace(source.substr(begin, end - begin));
    }
}

} // namespace

void writeStage(CodeWriter& writer, const std::string& name, const std::string& text) {
    writer.add(fmt::format("static const char {}[] =", name));
    writer.indent();
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        std::string line;
        for (const char c : text.substr(at, end - at))
            line += c == '"' || c == '\\' ? std::string{'\\', c} : std::string{c};
        at = end + 1;
        writer.add(fmt::format("\"{}\\n\"{}", line, at >= text.size() ? ";" : ""));
    }
    writer.outdent();
}

void findUniforms(GlslPass& pass) {
    addUniforms(pass.uniforms, pass.source.vertex.text);
    addUniforms(pass.uniforms, pass.source.fragment.text);
}

void writeShaders(GlslEmission& glsl, const GlslPass& pass) {
    CodeWriter& writer = glsl.emission.writer;
    const Pass& drawn = glsl.emission.scene.passes[pass.index];
    writer.heading(pass.variable.empty() ? std::string("shaders")
                   : drawn.name.empty()  ? fmt::format("shaders of pass {}", pass.index)
                                         : fmt::format("shaders of pass {}: {}", pass.index, drawn.name));
    writeStage(writer, joined(pass.variable, "vertexShader"), pass.source.vertex.text);
    writer.heading("for every pixel");
    writeStage(writer, joined(pass.variable, "fragmentShader"), pass.source.fragment.text);
    glsl.emission.atStart.add(fmt::format("static GLuint {};", pass.program));
}

void writeGlslPassSetup(GlslEmission& glsl, const GlslPass& pass) {
    Emission& emission = glsl.emission;
    const Pass& drawn = emission.scene.passes[pass.index];
    CodeWriter& writer = emission.writer;
    emission.use(CFunction::NewProgram);
    writer.heading(pass.variable.empty() ? std::string("the program and what no frame changes of it")
                                         : fmt::format("the program of pass {}", pass.index));
    writer.add(fmt::format("{} = newProgram({}, {});", pass.program, joined(pass.variable, "vertexShader"),
                           joined(pass.variable, "fragmentShader")));
    writer.add(fmt::format("glUseProgram({});", pass.program));
    writeGlslUniforms(glsl, pass);
    if (&pass == &glsl.passes.front() && hasOneColor(glsl))
        writeColor(glsl, drawnModels(glsl.emission.scene, drawn).front());
}

void writeGlslUniforms(GlslEmission& glsl, const GlslPass& pass) {
    const Scene& scene = glsl.emission.scene;
    const Pass& drawn = scene.passes[pass.index];
    const Light& light = scene.light;
    writeUniform(glsl, pass, "4f", "lightPosition",
                 numbers({&light.position.x, 4}, pathOf<&Scene::light, &Light::position>()));
    writeUniform(glsl, pass, "3f", "lightAmbient", lightPart(light.ambient, keyOf<&Light::ambient>()));
    writeUniform(glsl, pass, "3f", "lightDiffuse", lightPart(light.diffuse, keyOf<&Light::diffuse>()));
    writeUniform(glsl, pass, "3f", "lightSpecular", lightPart(light.specular, keyOf<&Light::specular>()));
    writeUniform(glsl, pass, "3f", "modelAmbient",
                 lightPart(light.modelAmbient, keyOf<&Light::modelAmbient>()));
    const std::vector<std::size_t> models = drawnModels(scene, drawn);
    for (const MaterialRow& row : materialRows) {
        if (isShared(glsl.emission, models, row))
            writeUniform(glsl, pass, row.suffix, row.uniform,
                         row.values(materialOf(scene, scene.models[models.front()]),
                                    materialPath(scene, models.front())));
    }
    const std::string fog = fmt::format("{}.{}", elementOf<&Scene::passes>(pass.index), keyOf<&Pass::fog>());
    const auto fogNumber = [&](float value, const std::string& key) {
        return std::vector<Part>{number(value, fmt::format("{}.{}", fog, key))};
    };
    writeUniform(glsl, pass, "3f", "fogColor",
                 colorParts(glsl.emission, fmt::format("{}.{}", fog, keyOf<&Fog::color>()), 3));
    writeUniform(glsl, pass, "1f", "fogDensity", fogNumber(drawn.fog.density, keyOf<&Fog::density>()));
    writeUniform(glsl, pass, "1f", "fogStart", fogNumber(drawn.fog.start, keyOf<&Fog::start>()));
    writeUniform(glsl, pass, "1f", "fogEnd", fogNumber(drawn.fog.end, keyOf<&Fog::end>()));
    writeUniform(glsl, pass, "1f", "alphaReference", alphaReference(glsl.emission, pass.index));
    for (std::size_t i = 0; i < maxUnits; ++i) {
        if (pass.units[i])
            writeUnitUniforms(glsl, pass, i);
    }
}

void writeGlslPassState(GlslEmission& glsl, const GlslPass& pass) {
    static const Pass initial;
    Emission& emission = glsl.emission;
    CodeWriter& writer = emission.writer;
    const Pass& drawn = emission.scene.passes[pass.index];
    const std::string path = elementOf<&Scene::passes>(pass.index);
    const Holder holder{passTable(), &drawn, &initial, path, "pass", pass.variable};
    if (pass.variable.empty())
        writer.heading("tests, blending and textures");
    const bool hasCube = std::any_of(pass.units.begin(), pass.units.end(), [&](const auto& unit) {
        return unit &&
               drawn.units[static_cast<std::size_t>(&unit - pass.units.data())].target == Target::CubeMap;
    });
    for (const MemberId member :
         {memberId<&Pass::depthTest>, memberId<&Pass::depthFunc>, memberId<&Pass::blend>,
          memberId<&Pass::blendSrc>, memberId<&Pass::blendDst>, memberId<&Pass::seamlessCubeMap>}) {
        if ((member == memberId<&Pass::seamlessCubeMap> && !hasCube) ||
            (member == memberId<&Pass::depthFunc> && !drawn.depthTest) ||
            ((member == memberId<&Pass::blendSrc> || member == memberId<&Pass::blendDst>)&&!drawn.blend))
            continue;
        const auto row = std::ranges::find(holder.table.params, member, &ParamRow::member);
        if (!pass.variable.empty() || hasShadowMaps(glsl))
            writer.forget(fmt::format("{}.{}", holder.state, row->key)); // whatever the frame before left
        writer.row(holder, *row);
    }
    for (std::size_t i = 0; i < maxUnits; ++i) {
        if (!pass.units[i])
            continue;
        const Unit& unit = drawn.units[i];
        std::vector<Part> bound = bindingCall(emission, unit, unitPath(pass.index, i));
        if (!writer.takes(bound))
            continue;
        writer.add(fmt::format("glActiveTexture({});", textureUnitName(i)));
        writer.add(std::move(bound));
    }
}

void writeGlslMaterial(GlslEmission& glsl, const GlslPass& pass, std::size_t model) {
    const Scene& scene = glsl.emission.scene;
    const std::vector<std::size_t> models = drawnModels(scene, scene.passes[pass.index]);
    for (const MaterialRow& row : materialRows) {
        if (!isShared(glsl.emission, models, row))
            writeUniform(glsl, pass, row.suffix, row.uniform,
                         row.values(materialOf(scene, scene.models[model]), materialPath(scene, model)));
    }
    if (!hasOneColor(glsl) && !hasOwnColors(scene.models[model]))
        writeColor(glsl, model);
}

} // namespace texplorer::emit

#include "core/emit/emit.h"

#include "core/emit/emission.h"
#include "core/gl/argument_names.h"
#include "core/scene/drawn_models.h"
#include "core/scene/params/keys.h"

#include <fmt/core.h>

#include <algorithm>

namespace texplorer::emit {
namespace {

/// Whether anything looks at normals: light, and coordinates that reflect.
bool looksAtNormals(const Pass& pass) {
    const auto reflects = [](const TexGen& generated) {
        return generated.enabled && generated.mode != TexGenMode::ObjectLinear &&
               generated.mode != TexGenMode::EyeLinear;
    };
    return pass.enabled && (pass.lighting || std::ranges::any_of(pass.units, [&](const Unit& unit) {
                                return unit.enabled && (reflects(unit.texGenS) || reflects(unit.texGenT) ||
                                                        reflects(unit.texGenR) || reflects(unit.texGenQ));
                            }));
}

/// Of fog, only what its mode looks at.
bool hasEffect(const ParamRow& row, const Fog& fog) {
    if (row.member == memberId<&Fog::enabled>)
        return true;
    const bool isLinear = fog.mode == FogMode::Linear;
    if (row.member == memberId<&Fog::density>)
        return fog.enabled && !isLinear;
    if (row.member == memberId<&Fog::start> || row.member == memberId<&Fog::end>)
        return fog.enabled && isLinear;
    return fog.enabled;
}

/// A driver of OpenGL 2.1 doesn't know the name.
bool hasCubeMap(const Pass& pass) {
    return std::ranges::any_of(
        pass.units, [](const Unit& unit) { return unit.enabled && unit.target == Target::CubeMap; });
}

void writePassState(Emission& emission, std::size_t index) {
    static const Pass initial;
    const Pass& pass = emission.scene.passes[index];
    const std::string path = elementOf<&Scene::passes>(index);
    CodeWriter& writer = emission.writer;
    if (emission.passVariable(index).empty())
        writer.heading("lighting, tests, blending and fog");
    else if (pass.name.empty())
        writer.heading(fmt::format("pass {}", index));
    else
        writer.heading(fmt::format("pass {}: {}", index, pass.name));
    const Holder holder{passTable(), &pass, &initial, path, "pass", emission.passVariable(index)};
    for (const ParamRow& row : holder.table.params) {
        const bool isUnknown = row.member == memberId<&Pass::seamlessCubeMap> && !hasCubeMap(pass);
        if (!row.glCall.empty() && !isUnknown)
            writer.row(holder, row);
    }
    const std::string& fog = keyOf<&Pass::fog>();
    const Holder fogHolder{fogTable(),   &pass.fog,
                           &initial.fog, fmt::format("{}.{}", path, fog),
                           fog,          joined(holder.variable, fog)};
    for (const ParamRow& row : fogHolder.table.params) {
        if (hasEffect(row, pass.fog))
            writer.row(fogHolder, row);
    }
}

} // namespace

Emission::Emission(const Scene& drawn)
    : scene(drawn)
    , objects(textureObjectsOf(drawn))
    , needsNormals(std::ranges::any_of(drawn.passes, looksAtNormals)) {
    for (std::size_t i = 0; i < drawn.models.size(); ++i)
        models.push_back(formOf(drawn, i));
}

std::string Emission::passVariable(std::size_t pass) const {
    const auto drawn =
        std::ranges::count_if(scene.passes, [&](const Pass& each) { return drawsAnything(scene, each); });
    return drawn > 1 ? fmt::format("pass{}", pass) : std::string();
}

std::vector<Line> callsOf(const Scene& scene) {
    Emission emission(scene);
    CodeWriter& writer = emission.writer;
    writeTextures(emission);
    for (std::size_t m = 0; m < scene.models.size(); ++m)
        writeModelData(emission, m);
    const bool hasQuadric =
        std::ranges::find(emission.models, Drawing::Quadric, &ModelForm::drawing) != emission.models.end();
    if (hasQuadric) {
        writer.heading("quadrics with texture coordinates");
        writer.add("GLUquadric* quadric = gluNewQuadric();");
        writer.add(fmt::format("gluQuadricTexture(quadric, {});", booleanName(true)));
    }
    writeProjection(emission);
    writeLight(emission);
    writeCamera(emission);
    writeMaterial(emission);
    for (std::size_t p = 0; p < scene.passes.size(); ++p) {
        if (!drawsAnything(scene, scene.passes[p]))
            continue;
        writePassState(emission, p);
        writeUnits(emission, p);
        for (const std::size_t model : drawnModels(scene, scene.passes[p]))
            writeModel(emission, p, model);
    }
    if (hasQuadric)
        writer.add("gluDeleteQuadric(quadric);");
    return std::move(writer).take();
}

std::string_view includes() {
    return "#define GL_GLEXT_PROTOTYPES\n"
           "#include <GL/gl.h>\n"
           "#include <GL/glext.h>\n"
           "#include <GL/glu.h>\n"
           "#include <stddef.h>\n";
}

} // namespace texplorer::emit

// Textures that show what the light sees: a framebuffer object without colours, drawn into in every frame.

#include "texplorer/emit/glsl_emission.h"
#include "texplorer/scene/animation.h"
#include "texplorer/scene/drawn_models.h"
#include "texplorer/scene/params/keys.h"

#include <fmt/core.h>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

namespace texplorer::emit {
namespace {

constexpr std::string_view vertexStage = R"(#version 330 core
layout(location = 0) in vec3 position;
uniform mat4 modelViewProjection; // the light's

void main() {
    gl_Position = modelViewProjection * vec4(position, 1.0);
}
)";
constexpr std::string_view fragmentStage = R"(#version 330 core
// Depths alone: there is no colour.
void main() {
}
)";

std::vector<std::size_t> seenByLight(const Emission& emission) {
    std::vector<std::size_t> maps;
    for (std::size_t i = 0; i < emission.objects.size(); ++i) {
        if (emission.scene.textures[emission.objects[i].texture].source == SourceKind::LightDepth &&
            !emission.leftOut.contains(i))
            maps.push_back(i);
    }
    return maps;
}

} // namespace

bool hasShadowMaps(const GlslEmission& glsl) {
    return !seenByLight(glsl.emission).empty();
}

void writeGlslShadowShaders(GlslEmission& glsl) {
    if (!hasShadowMaps(glsl))
        return;
    CodeWriter& writer = glsl.emission.writer;
    writer.heading("shaders for the depths that the light sees");
    writeStage(writer, "shadowVertexShader", std::string(vertexStage));
    writeStage(writer, "shadowFragmentShader", std::string(fragmentStage));
    glsl.emission.atStart.add("static GLuint shadowProgram;");
}

void writeGlslShadowSetup(GlslEmission& glsl) {
    if (!hasShadowMaps(glsl))
        return;
    glsl.emission.use(CFunction::NewProgram);
    glsl.emission.writer.add("shadowProgram = newProgram(shadowVertexShader, shadowFragmentShader);");
}

void writeGlslShadowMaps(GlslEmission& glsl) {
    Emission& emission = glsl.emission;
    CodeWriter& writer = emission.writer;
    const Scene& scene = emission.scene;
    for (const std::size_t map : seenByLight(emission)) {
        const Texture& texture = scene.textures[emission.objects[map].texture];
        const Part size =
            whole(texture.depthSize,
                  fmt::format("{}.{}", elementOf<&Scene::textures>(emission.objects[map].texture),
                              keyOf<&Texture::depthSize>()));
        writer.heading("the depths that the light sees");
        writer.open(fmt::format("static void drawShadowMap{}(Matrix view{})", map,
                                spinsInLight(emission) ? ", double seconds" : ""));
        writer.comment("from eye coordinates to what the light sees");
        const glm::dmat4 matrix = emission.keys.decided(
            scene, lightPaths(),
            [](const Scene& other) {
                const LightView light = lightView(other.light);
                return light.projection * light.view;
            },
            computedLight);
        writer.matrix("const Matrix light = {{", doubles(matrix), "}};");
        writer.add(fmt::format("glBindFramebuffer(GL_FRAMEBUFFER, shadowMap{});", map));
        writer.add(callWith("glViewport", {plain("0, 0, "), size, plain(", "), size}));
        writer.add("glUseProgram(shadowProgram);");
        writer.add("glEnable(GL_DEPTH_TEST);");
        writer.add("glDepthFunc(GL_LESS);");
        writer.add("glClear(GL_DEPTH_BUFFER_BIT);");
        glsl.hasModelMatrix = false;
        for (const std::size_t model : modelsInLight(scene))
            writeGlslShape(glsl, model);
        glsl.hasModelMatrix = false;
        writer.add("glBindFramebuffer(GL_FRAMEBUFFER, 0);");
        writer.close();
    }
}

void writeGlslShadowCalls(GlslEmission& glsl) {
    CodeWriter& writer = glsl.emission.writer;
    for (const std::size_t map : seenByLight(glsl.emission)) {
        writer.add(
            fmt::format("drawShadowMap{}(view{});", map, spinsInLight(glsl.emission) ? ", seconds" : ""));
        if (spinsInLight(glsl.emission))
            static_cast<void>(writer.seconds());
    }
    if (hasShadowMaps(glsl))
        writer.add("glViewport(0, 0, width, height);");
}

} // namespace texplorer::emit

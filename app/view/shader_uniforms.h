#pragma once

// The uniforms of the shaders of core/glsl, which are the same for OpenGL and OpenGL ES. `Program` has a function
// set(name, value), which ignores names that it does not have.

#include "texplorer/glsl/shader_source.h"
#include "texplorer/scene/animation.h"
#include "texplorer/scene/model_mesh.h"
#include "texplorer/scene/scene.h"
#include "texplorer/scene/texture_matrix.h"

#include <fmt/core.h>
#include <glm/common.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace texplorer::view {

/// Sets the light, the fog and the alpha test, which are the same for every model and unit.
template<class Program>
void setPass(const Program& program, const Scene& scene, const Pass& pass) {
    const Light& light = scene.light;
    program.set("lightPosition", light.position);
    program.set("lightAmbient", glm::vec3(light.ambient));
    program.set("lightDiffuse", glm::vec3(light.diffuse));
    program.set("lightSpecular", glm::vec3(light.specular));
    program.set("modelAmbient", glm::vec3(light.modelAmbient));
    program.set("fogColor", glm::clamp(glm::vec3(pass.fog.color), 0.0F, 1.0F));
    program.set("fogDensity", pass.fog.density);
    program.set("fogStart", pass.fog.start);
    program.set("fogEnd", pass.fog.end);
    program.set("alphaReference", std::round(std::clamp(pass.alphaRef, 0.0F, 1.0F) * 255));
}

/// Sets the environment and the planes of a unit.
template<class Program>
void setUnit(const Program& program, std::size_t index, const Unit& unit) {
    const auto setPlane = [&](const char* coordinate, const TexGen& generated) {
        program.set(fmt::format("plane{}{}", index, coordinate),
                    generated.mode == TexGenMode::ObjectLinear ? generated.objectPlane : generated.eyePlane);
    };
    program.set(fmt::format("environmentColor{}", index), glm::clamp(unit.envColor, 0.0F, 1.0F));
    setPlane("s", unit.texGenS);
    setPlane("t", unit.texGenT);
    setPlane("r", unit.texGenR);
    setPlane("q", unit.texGenQ);
}

/// Sets the material and the matrices of a model, the `modelIndex`th of the scene, for a pass.
template<class Program>
void setModel(const Program& program, const Scene& scene, std::size_t pass, std::size_t modelIndex,
              const glm::mat4& projection, const glsl::SampledUnits& units, double time) {
    const Model& model = scene.models[modelIndex];
    const Material& material = materialOf(scene, model);
    program.set("colorMaterial", material.colorMaterial ? 1 : 0);
    program.set("materialAmbient", glm::vec3(material.ambient));
    program.set("materialDiffuse", material.diffuse);
    program.set("materialSpecular", glm::vec3(material.specular));
    program.set("materialEmission", glm::vec3(material.emission));
    program.set("shininess", material.shininess);
    const glm::mat4 modelView = modelViewMatrix(scene.view, model, time);
    program.set("modelView", modelView);
    program.set("modelViewProjection", projection * modelView);
    program.set("normalMatrix", glm::transpose(glm::inverse(glm::mat3(modelView))));
    glm::mat4 flipped(1); // t -> 1 - t: for a texture that was uploaded upside down
    flipped[1].y = -1;
    flipped[3].y = 1;
    for (std::size_t u = 0; u < units.size(); ++u) {
        if (!units[u])
            continue;
        const glm::mat4 matrix = textureMatrix(scene, pass, u, modelIndex, time);
        program.set(fmt::format("textureMatrix{}", u),
                    units[u]->lateFlip == LateFlip::Matrix ? flipped * matrix : matrix);
    }
}

} // namespace texplorer::view

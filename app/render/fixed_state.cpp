#include "app/render/fixed_state.h"

#include "core/scene/animation.h"

#include <GL/glew.h>
#include <glm/gtc/type_ptr.hpp>

#include <array>

namespace texplorer::render {

namespace {

constexpr auto targets =
    std::to_array<GLenum>({GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP});

struct GeneratedCoordinate {
    GLenum coordinate;
    GLenum enable;
    TexGen Unit::*state;
};

constexpr auto generatedCoordinates = std::to_array<GeneratedCoordinate>({
    {GL_S, GL_TEXTURE_GEN_S, &Unit::texGenS},
    {GL_T, GL_TEXTURE_GEN_T, &Unit::texGenT},
    {GL_R, GL_TEXTURE_GEN_R, &Unit::texGenR},
    {GL_Q, GL_TEXTURE_GEN_Q, &Unit::texGenQ},
});

void setEnabled(GLenum what, bool on) {
    if (on)
        glEnable(what);
    else
        glDisable(what);
}

/// One environment parameter that is an enumerator.
template<class E>
void setEnv(GLenum name, E value) {
    glTexEnvi(GL_TEXTURE_ENV, name, static_cast<GLint>(value));
}

void applyCombine(const Combine& combine) {
    setEnv(GL_COMBINE_RGB, combine.rgb);
    setEnv(GL_SRC0_RGB, combine.source0Rgb);
    setEnv(GL_OPERAND0_RGB, combine.operand0Rgb);
    setEnv(GL_SRC1_RGB, combine.source1Rgb);
    setEnv(GL_OPERAND1_RGB, combine.operand1Rgb);
    setEnv(GL_SRC2_RGB, combine.source2Rgb);
    setEnv(GL_OPERAND2_RGB, combine.operand2Rgb);
    setEnv(GL_RGB_SCALE, combine.rgbScale);
    setEnv(GL_COMBINE_ALPHA, combine.alpha);
    setEnv(GL_SRC0_ALPHA, combine.source0Alpha);
    setEnv(GL_OPERAND0_ALPHA, combine.operand0Alpha);
    setEnv(GL_SRC1_ALPHA, combine.source1Alpha);
    setEnv(GL_OPERAND1_ALPHA, combine.operand1Alpha);
    setEnv(GL_SRC2_ALPHA, combine.source2Alpha);
    setEnv(GL_OPERAND2_ALPHA, combine.operand2Alpha);
    setEnv(GL_ALPHA_SCALE, combine.alphaScale);
}

void applyFog(const Fog& fog) {
    glFogi(GL_FOG_MODE, static_cast<GLint>(fog.mode));
    glFogf(GL_FOG_DENSITY, fog.density);
    glFogf(GL_FOG_START, fog.start);
    glFogf(GL_FOG_END, fog.end);
    glFogfv(GL_FOG_COLOR, glm::value_ptr(fog.color));
}

/// t becomes what r is.
constexpr glm::mat4 rAsT{1, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1};

void applyTexGen(const GeneratedCoordinate& row, const TexGen& generated) {
    setEnabled(row.enable, generated.enabled);
    if (!generated.enabled)
        return;
    glTexGeni(row.coordinate, GL_TEXTURE_GEN_MODE, static_cast<GLint>(generated.mode));
    glTexGenfv(row.coordinate, GL_OBJECT_PLANE, glm::value_ptr(generated.objectPlane));
    glTexGenfv(row.coordinate, GL_EYE_PLANE, glm::value_ptr(generated.eyePlane));
}

} // namespace

void applyLight(const Light& light) {
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, glm::value_ptr(light.modelAmbient));
    glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, static_cast<GLint>(light.colorControl));
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, light.localViewer ? 1 : 0);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, light.twoSide ? 1 : 0);

    glLightfv(GL_LIGHT0, GL_POSITION, glm::value_ptr(light.position));
    glLightfv(GL_LIGHT0, GL_AMBIENT, glm::value_ptr(light.ambient));
    glLightfv(GL_LIGHT0, GL_DIFFUSE, glm::value_ptr(light.diffuse));
    glLightfv(GL_LIGHT0, GL_SPECULAR, glm::value_ptr(light.specular));
    glLightf(GL_LIGHT0, GL_CONSTANT_ATTENUATION, 1);
    glLightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 0);
    glLightf(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, 0);
    glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 180);
    glEnable(GL_LIGHT0);

    glEnable(GL_NORMALIZE); // models are scaled
}

void applyMaterial(const Material& material) {
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, glm::value_ptr(material.specular));
    glMaterialfv(GL_FRONT_AND_BACK, GL_EMISSION, glm::value_ptr(material.emission));
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, material.shininess);
    if (material.colorMaterial) {
        // The mode first: enabling copies the current colour at once into what the mode names
        // (section 2.14.3).
        glColorMaterial(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE);
        glColor4fv(glm::value_ptr(material.color));
        glEnable(GL_COLOR_MATERIAL);
    } else {
        glDisable(GL_COLOR_MATERIAL);
        glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT, glm::value_ptr(material.ambient));
        glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, glm::value_ptr(material.diffuse));
        glColor4fv(glm::value_ptr(material.color));
    }
}

void applyFixedPass(const Pass& pass) {
    setEnabled(GL_LIGHTING, pass.lighting);
    setEnabled(GL_ALPHA_TEST, pass.alphaTest);
    glAlphaFunc(static_cast<GLenum>(pass.alphaFunc), pass.alphaRef);
    setEnabled(GL_FOG, pass.fog.enabled);
    if (pass.fog.enabled)
        applyFog(pass.fog);
}

void switchUnitOff(int index) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(index));
    for (const GLenum target : targets)
        glDisable(target);
    glClientActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(index));
    glDisableClientState(GL_TEXTURE_COORD_ARRAY);
}

void applyUnit(int index, const Unit& unit, const BoundTexture& texture, double time, const Light& light) {
    switchUnitOff(index); // a pass before this one may have used another target, which could take precedence
    const auto target = static_cast<GLenum>(unit.target);
    glBindTexture(target, texture.name);
    glEnable(target);
    setEnv(GL_TEXTURE_ENV_MODE, unit.envMode);
    if (unit.envMode == EnvMode::Combine)
        applyCombine(unit.combine);
    glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, glm::value_ptr(unit.envColor));
    glTexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, unitBias(unit, texture));
    for (const GeneratedCoordinate& row : generatedCoordinates)
        applyTexGen(row, unit.*row.state);
    glMatrixMode(GL_TEXTURE);
    glLoadIdentity();
    if (texture.compares && unit.target == Target::Texture1D)
        glMultMatrixf(glm::value_ptr(rAsT)); // which Mesa 22.3 compares; a line asks for t otherwise never
    if (texture.lateFlip == LateFlip::Matrix) {
        glTranslatef(0, 1, 0);
        glScalef(1, -1, 1);
    }
    glMultMatrixf(glm::value_ptr(textureMatrix(unit.matrix, time, light)));
}

} // namespace texplorer::render

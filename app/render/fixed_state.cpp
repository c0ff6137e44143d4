#include "app/render/fixed_state.h"

#include "texplorer/scene/animation.h"

#include <GL/glew.h>
#include <glm/gtc/type_ptr.hpp>
#include <glm/trigonometric.hpp>

#include <array>
#include <cmath>

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

/// Sets an environment parameter that is an enumerator.
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

void applyTexGen(const GeneratedCoordinate& row, const TexGen& generated) {
    setEnabled(row.enable, generated.enabled);
    if (!generated.enabled)
        return;
    glTexGeni(row.coordinate, GL_TEXTURE_GEN_MODE, static_cast<GLint>(generated.mode));
    glTexGenfv(row.coordinate, GL_OBJECT_PLANE, glm::value_ptr(generated.objectPlane));
    glTexGenfv(row.coordinate, GL_EYE_PLANE, glm::value_ptr(generated.eyePlane));
}

void translate(glm::vec3 offset) {
    glTranslatef(offset.x, offset.y, offset.z);
}

/// Does not call GL for an angle of 0 or without an axis, for which the result is undefined.
void rotate(float degrees, glm::vec3 axis) {
    if (degrees != 0 && axis != glm::vec3(0))
        glRotatef(degrees, axis.x, axis.y, axis.z);
}

/// Removes whole turns of an animated angle before it is rounded to a float.
float angleAt(float start, float rate, double time) {
    return rate == 0 ? start : static_cast<float>(std::fmod(double{start} + double{rate} * time, 360.0));
}

/// From eye coordinates to the light's picture: see MatrixOp::Projector.
void multiplyProjector(const Light& light) {
    const LightView seen = lightView(light);
    glTranslatef(0.5F, 0.5F, 0.5F); // what glViewport and glDepthRange do to a picture
    glScalef(0.5F, 0.5F, 0.5F);
    if (light.position.w == 0)
        glOrtho(-seen.extent, seen.extent, -seen.extent, seen.extent, seen.nearest, seen.farthest);
    else
        glFrustum(-seen.extent, seen.extent, -seen.extent, seen.extent, seen.nearest, seen.farthest);
    glMultMatrixf(glm::value_ptr(glm::mat4(seen.view)));
}

} // namespace

void applyProjection(const View& view, float aspect) {
    const auto [near, far] = clipPlanes(view);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    if (view.projection == Projection::Orthographic) {
        const double height = halfHeightAtTarget(view);
        const double width = height * double{aspect};
        glOrtho(-width, width, -height, height, -far, far);
    } else {
        const double height = near * std::tan(glm::radians(double{view.fieldOfView}) / 2);
        const double width = height * double{aspect};
        glFrustum(-width, width, -height, height, near, far);
    }
    glMatrixMode(GL_MODELVIEW);
}

void applyModelView(const View& view, const Model& model, double time) {
    constexpr std::array axes{glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, 1)};
    glLoadIdentity();
    if (model.attachment != Attachment::Eye) {
        glTranslatef(0, 0, -view.distance);
        rotate(view.roll, axes[2]);
        rotate(view.elevation, axes[0]);
        rotate(-view.azimuth, axes[1]);
        if (view.target != glm::vec3(0))
            translate(-view.target);
    }
    if (model.position != glm::vec3(0))
        translate(model.position);
    for (const int axis : rotationAxes(model.rotationOrder))
        rotate(angleAt(model.rotation[axis], model.spin[axis], time),
               axes.at(static_cast<std::size_t>(axis)));
    if (model.size != 1)
        glScalef(model.size, model.size, model.size);
    if (model.scale != glm::vec3(1))
        glScalef(model.scale.x, model.scale.y, model.scale.z);
}

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
        // Set the mode first: glEnable copies the current colour at once to the properties that the mode
        // names (section 2.14.3).
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

void applyMatrixStep(const MatrixStep& step, double time, const Light& light) {
    const glm::vec3 amount(glm::dvec3(step.amount) + glm::dvec3(step.rate) * time);
    const bool pivots =
        (step.op == MatrixOp::Rotate || step.op == MatrixOp::Scale) && step.pivot != glm::vec3(0);
    if (pivots)
        translate(step.pivot);
    switch (step.op) {
    case MatrixOp::Translate:
        translate(amount);
        break;
    case MatrixOp::Rotate:
        rotate(angleAt(step.angle, step.angleRate, time), amount);
        break;
    case MatrixOp::Scale:
        glScalef(amount.x, amount.y, amount.z);
        break;
    case MatrixOp::Multiply:
    case MatrixOp::Load: // the matrix that it replaces has been loaded
        glMultMatrixf(glm::value_ptr(step.matrix));
        break;
    case MatrixOp::Projector:
        multiplyProjector(light);
        break;
    }
    if (pivots)
        translate(-step.pivot);
}

void applyUnit(int index, const Unit& unit, const BoundTexture& texture) {
    switchUnitOff(index); // an earlier pass may have used another target, which could take precedence
    const auto target = static_cast<GLenum>(unit.target);
    glBindTexture(target, texture.name);
    if (texture.hasDepths)
        glTexParameteri(target, GL_DEPTH_TEXTURE_MODE, static_cast<GLint>(texture.format));
    glEnable(target);
    setEnv(GL_TEXTURE_ENV_MODE, unit.envMode);
    if (unit.envMode == EnvMode::Combine)
        applyCombine(unit.combine);
    glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, glm::value_ptr(unit.envColor));
    glTexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, unitBias(unit, texture));
    for (const GeneratedCoordinate& row : generatedCoordinates)
        applyTexGen(row, unit.*row.state);
}

} // namespace texplorer::render

#include "app/render/state_guard.h"

#include <glm/gtc/type_ptr.hpp>

#include <array>

namespace texplorer::render {

namespace {

constexpr auto switchedOff = std::to_array<GLenum>({
    GL_ALPHA_TEST,
    GL_BLEND,
    GL_COLOR_LOGIC_OP,
    GL_COLOR_MATERIAL,
    GL_COLOR_SUM,
    GL_CULL_FACE,
    GL_DEPTH_TEST,
    GL_DITHER,
    GL_FOG,
    GL_LIGHTING,
    GL_NORMALIZE,
    GL_POLYGON_SMOOTH,
    GL_POLYGON_STIPPLE,
    GL_POLYGON_OFFSET_FILL,
    GL_RESCALE_NORMAL,
    GL_SCISSOR_TEST,
    GL_STENCIL_TEST,
});

constexpr auto textureTargets =
    std::to_array<GLenum>({GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP});
constexpr auto generatedCoordinates =
    std::to_array<GLenum>({GL_TEXTURE_GEN_S, GL_TEXTURE_GEN_T, GL_TEXTURE_GEN_R, GL_TEXTURE_GEN_Q});

constexpr auto clientArrays = std::to_array<GLenum>({
    GL_COLOR_ARRAY,
    GL_EDGE_FLAG_ARRAY,
    GL_FOG_COORD_ARRAY,
    GL_INDEX_ARRAY,
    GL_NORMAL_ARRAY,
    GL_SECONDARY_COLOR_ARRAY,
    GL_VERTEX_ARRAY,
});

constexpr auto pixelStoreZeros = std::to_array<GLenum>({
    GL_UNPACK_SWAP_BYTES,
    GL_UNPACK_LSB_FIRST,
    GL_UNPACK_ROW_LENGTH,
    GL_UNPACK_IMAGE_HEIGHT,
    GL_UNPACK_SKIP_PIXELS,
    GL_UNPACK_SKIP_ROWS,
    GL_UNPACK_SKIP_IMAGES,
    GL_PACK_SWAP_BYTES,
    GL_PACK_LSB_FIRST,
    GL_PACK_ROW_LENGTH,
    GL_PACK_IMAGE_HEIGHT,
    GL_PACK_SKIP_PIXELS,
    GL_PACK_SKIP_ROWS,
    GL_PACK_SKIP_IMAGES,
});

constexpr auto pixelScales =
    std::to_array<GLenum>({GL_RED_SCALE, GL_GREEN_SCALE, GL_BLUE_SCALE, GL_ALPHA_SCALE});
constexpr auto pixelBiases = std::to_array<GLenum>({GL_RED_BIAS, GL_GREEN_BIAS, GL_BLUE_BIAS, GL_ALPHA_BIAS});

GLint integer(GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

glm::mat4 matrix(GLenum name) {
    glm::mat4 value(1);
    glGetFloatv(name, glm::value_ptr(value));
    return value;
}

void loadMatrix(GLenum mode, const glm::mat4& value) {
    glMatrixMode(mode);
    glLoadMatrixf(glm::value_ptr(value));
}

GLuint nameOf(GLint binding) {
    return static_cast<GLuint>(binding);
}

GLenum unitEnum(std::size_t unit) {
    return GL_TEXTURE0 + static_cast<GLenum>(unit);
}

// GLEW loads these only with their extension, which a driver need not list if its version includes them.
bool hasVertexArrays() {
    return glBindVertexArray != nullptr && (GLEW_VERSION_3_0 || GLEW_ARB_vertex_array_object);
}
bool hasSamplers() {
    return glBindSampler != nullptr && (GLEW_VERSION_3_3 || GLEW_ARB_sampler_objects);
}
bool hasSeamlessCubeMaps() {
    return GLEW_VERSION_3_2 || GLEW_ARB_seamless_cube_map;
}
bool hasProvokingVertex() {
    return glProvokingVertex != nullptr && (GLEW_VERSION_3_2 || GLEW_ARB_provoking_vertex);
}

} // namespace

StateGuard::StateGuard() {
    save();
    unbind();

    // The stacks have at least 16 places, which a caller may have filled. Then there is nothing to pop.
    const GLint depth = integer(GL_ATTRIB_STACK_DEPTH);
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    pushed_ = integer(GL_ATTRIB_STACK_DEPTH) > depth;
    const GLint clientDepth = integer(GL_CLIENT_ATTRIB_STACK_DEPTH);
    glPushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
    clientPushed_ = integer(GL_CLIENT_ATTRIB_STACK_DEPTH) > clientDepth;

    setInitialValues();
}

void StateGuard::save() {
    program_ = integer(GL_CURRENT_PROGRAM);
    drawFramebuffer_ = integer(GL_DRAW_FRAMEBUFFER_BINDING);
    readFramebuffer_ = integer(GL_READ_FRAMEBUFFER_BINDING);
    renderbuffer_ = integer(GL_RENDERBUFFER_BINDING);
    arrayBuffer_ = integer(GL_ARRAY_BUFFER_BINDING);
    packBuffer_ = integer(GL_PIXEL_PACK_BUFFER_BINDING);
    unpackBuffer_ = integer(GL_PIXEL_UNPACK_BUFFER_BINDING);
    clientActiveTexture_ = integer(GL_CLIENT_ACTIVE_TEXTURE);
    activeTexture_ = integer(GL_ACTIVE_TEXTURE);
    colorSum_ = glIsEnabled(GL_COLOR_SUM) == GL_TRUE;
    fogSource_ = integer(GL_FOG_COORD_SRC);
    seamless_ = hasSeamlessCubeMaps() && glIsEnabled(GL_TEXTURE_CUBE_MAP_SEAMLESS) == GL_TRUE;
    if (hasVertexArrays())
        vertexArray_ = integer(GL_VERTEX_ARRAY_BINDING);
    if (hasProvokingVertex())
        provokingVertex_ = integer(GL_PROVOKING_VERTEX);

    // Matrices are not pushed: their stacks may have only two places.
    projection_ = matrix(GL_PROJECTION_MATRIX);
    modelView_ = matrix(GL_MODELVIEW_MATRIX);

    units_.resize(static_cast<std::size_t>(integer(GL_MAX_TEXTURE_UNITS)));
    for (std::size_t i = 0; i < units_.size(); ++i) {
        glActiveTexture(unitEnum(i));
        units_[i] = {integer(GL_TEXTURE_BINDING_1D),
                     integer(GL_TEXTURE_BINDING_2D),
                     integer(GL_TEXTURE_BINDING_3D),
                     integer(GL_TEXTURE_BINDING_CUBE_MAP),
                     hasSamplers() ? integer(GL_SAMPLER_BINDING) : 0,
                     matrix(GL_TEXTURE_MATRIX)};
    }
}

// Call it before the attributes are pushed: glPushAttrib saves the parameters of every bound texture, and
// glPopAttrib would undo our changes if one of them is ours.
void StateGuard::unbind() {
    for (std::size_t i = 0; i < units_.size(); ++i) {
        glActiveTexture(unitEnum(i));
        for (const GLenum target : textureTargets)
            glBindTexture(target, 0);
        if (hasSamplers())
            glBindSampler(static_cast<GLuint>(i), 0);
    }
    glUseProgram(0);
    if (hasVertexArrays())
        glBindVertexArray(0);
}

void StateGuard::setInitialValues() const {
    for (const GLenum each : switchedOff)
        glDisable(each);
    for (GLint i = 0; i < integer(GL_MAX_CLIP_PLANES); ++i)
        glDisable(GL_CLIP_PLANE0 + static_cast<GLenum>(i));
    for (GLint i = 0; i < integer(GL_MAX_LIGHTS); ++i)
        glDisable(GL_LIGHT0 + static_cast<GLenum>(i));
    if (GLEW_ARB_vertex_program)
        glDisable(GL_VERTEX_PROGRAM_ARB);
    if (GLEW_ARB_fragment_program)
        glDisable(GL_FRAGMENT_PROGRAM_ARB);
    if (hasProvokingVertex())
        glProvokingVertex(GL_LAST_VERTEX_CONVENTION);
    if (hasSeamlessCubeMaps())
        glDisable(GL_TEXTURE_CUBE_MAP_SEAMLESS);

    for (std::size_t i = 0; i < units_.size(); ++i) {
        glActiveTexture(unitEnum(i));
        for (const GLenum target : textureTargets)
            glDisable(target);
        for (const GLenum coordinate : generatedCoordinates)
            glDisable(coordinate);
        glClientActiveTexture(unitEnum(i));
        glDisableClientState(GL_TEXTURE_COORD_ARRAY);
    }
    for (const GLenum array : clientArrays)
        glDisableClientState(array);
    for (GLint i = 0; i < integer(GL_MAX_VERTEX_ATTRIBS); ++i)
        glDisableVertexAttribArray(static_cast<GLuint>(i));

    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glFrontFace(GL_CCW);
    glFogi(GL_FOG_COORD_SRC, GL_FRAGMENT_DEPTH);
    glDepthRange(0, 1);
    glDepthMask(GL_TRUE);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glBlendEquation(GL_FUNC_ADD);

    for (const GLenum each : pixelStoreZeros)
        glPixelStorei(each, 0);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    glPixelTransferi(GL_MAP_COLOR, GL_FALSE);
    for (const GLenum scale : pixelScales)
        glPixelTransferf(scale, 1);
    for (const GLenum bias : pixelBiases)
        glPixelTransferf(bias, 0);
}

StateGuard::~StateGuard() {
    // The draw and read buffers that glPopAttrib restores belong to the framebuffers that are bound at that
    // time.
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, nameOf(drawFramebuffer_));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, nameOf(readFramebuffer_));
    glBindRenderbuffer(GL_RENDERBUFFER, nameOf(renderbuffer_));
    loadMatrix(GL_PROJECTION, projection_);
    loadMatrix(GL_MODELVIEW, modelView_);
    for (std::size_t i = 0; i < units_.size(); ++i) {
        glActiveTexture(unitEnum(i));
        loadMatrix(GL_TEXTURE, units_[i].matrix);
    }
    if (hasProvokingVertex())
        glProvokingVertex(static_cast<GLenum>(provokingVertex_));

    if (clientPushed_)
        glPopClientAttrib();
    if (pushed_)
        glPopAttrib();
    if (hasSeamlessCubeMaps()) // Mesa 22.3 does not restore these three
        (seamless_ ? glEnable : glDisable)(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    if (colorSum_)
        glEnable(GL_COLOR_SUM);
    glFogi(GL_FOG_COORD_SRC, fogSource_);

    for (std::size_t i = 0; i < units_.size(); ++i) {
        glActiveTexture(unitEnum(i));
        glBindTexture(GL_TEXTURE_1D, nameOf(units_[i].texture1D));
        glBindTexture(GL_TEXTURE_2D, nameOf(units_[i].texture2D));
        glBindTexture(GL_TEXTURE_3D, nameOf(units_[i].texture3D));
        glBindTexture(GL_TEXTURE_CUBE_MAP, nameOf(units_[i].textureCube));
        if (hasSamplers())
            glBindSampler(static_cast<GLuint>(i), nameOf(units_[i].sampler));
    }
    glActiveTexture(static_cast<GLenum>(activeTexture_));
    glClientActiveTexture(static_cast<GLenum>(clientActiveTexture_));
    glBindBuffer(GL_PIXEL_PACK_BUFFER, nameOf(packBuffer_));
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, nameOf(unpackBuffer_));
    if (hasVertexArrays())
        glBindVertexArray(nameOf(vertexArray_));
    glBindBuffer(GL_ARRAY_BUFFER, nameOf(arrayBuffer_));
    glUseProgram(nameOf(program_));
}

} // namespace texplorer::render

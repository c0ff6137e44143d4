// A caller that has everything set to something else gets the same picture, and finds its state as it was.

#include "app/render/cost_meter.h"
#include "app/render/gl_handle.h"
#include "app/render/state_guard.h"
#include "tests/support/flat_scene.h"
#include "tests/support/render_fixture.h"

#include <gmock/gmock.h>

#include <map>
#include <string>
#include <vector>

namespace texplorer::render::state_guard_test {
namespace {

using namespace test;

struct Query {
    const char* name;
    GLenum value;
    std::size_t count = 1;
};

#define TEXPLORER_GL(name) #name, name
constexpr std::array queries{
    Query{TEXPLORER_GL(GL_ACTIVE_TEXTURE)},
    Query{TEXPLORER_GL(GL_ALPHA_TEST)},
    Query{TEXPLORER_GL(GL_ALPHA_TEST_FUNC)},
    Query{TEXPLORER_GL(GL_ALPHA_TEST_REF)},
    Query{TEXPLORER_GL(GL_ARRAY_BUFFER_BINDING)},
    Query{TEXPLORER_GL(GL_ATTRIB_STACK_DEPTH)},
    Query{TEXPLORER_GL(GL_BLEND)},
    Query{TEXPLORER_GL(GL_BLEND_DST)},
    Query{TEXPLORER_GL(GL_BLEND_EQUATION)},
    Query{TEXPLORER_GL(GL_BLEND_SRC)},
    Query{TEXPLORER_GL(GL_CLIENT_ACTIVE_TEXTURE)},
    Query{TEXPLORER_GL(GL_CLIENT_ATTRIB_STACK_DEPTH)},
    Query{TEXPLORER_GL(GL_CLIP_PLANE0)},
    Query{TEXPLORER_GL(GL_COLOR_ARRAY)},
    Query{TEXPLORER_GL(GL_COLOR_CLEAR_VALUE), 4},
    Query{TEXPLORER_GL(GL_COLOR_MATERIAL)},
    Query{TEXPLORER_GL(GL_COLOR_SUM)},
    Query{TEXPLORER_GL(GL_COLOR_WRITEMASK), 4},
    Query{TEXPLORER_GL(GL_CULL_FACE)},
    Query{TEXPLORER_GL(GL_CURRENT_COLOR), 4},
    Query{TEXPLORER_GL(GL_CURRENT_PROGRAM)},
    Query{TEXPLORER_GL(GL_DEPTH_CLEAR_VALUE)},
    Query{TEXPLORER_GL(GL_DEPTH_FUNC)},
    Query{TEXPLORER_GL(GL_DEPTH_RANGE), 2},
    Query{TEXPLORER_GL(GL_DEPTH_TEST)},
    Query{TEXPLORER_GL(GL_DEPTH_WRITEMASK)},
    Query{TEXPLORER_GL(GL_DITHER)},
    Query{TEXPLORER_GL(GL_DRAW_BUFFER)},
    Query{TEXPLORER_GL(GL_DRAW_FRAMEBUFFER_BINDING)},
    Query{TEXPLORER_GL(GL_ELEMENT_ARRAY_BUFFER_BINDING)},
    Query{TEXPLORER_GL(GL_FOG)},
    Query{TEXPLORER_GL(GL_FOG_COLOR), 4},
    Query{TEXPLORER_GL(GL_FOG_COORD_SRC)},
    Query{TEXPLORER_GL(GL_FOG_DENSITY)},
    Query{TEXPLORER_GL(GL_FOG_END)},
    Query{TEXPLORER_GL(GL_FOG_MODE)},
    Query{TEXPLORER_GL(GL_FOG_START)},
    Query{TEXPLORER_GL(GL_FRONT_FACE)},
    Query{TEXPLORER_GL(GL_LIGHT0)},
    Query{TEXPLORER_GL(GL_LIGHT1)},
    Query{TEXPLORER_GL(GL_LIGHTING)},
    Query{TEXPLORER_GL(GL_LIGHT_MODEL_AMBIENT), 4},
    Query{TEXPLORER_GL(GL_LIGHT_MODEL_COLOR_CONTROL)},
    Query{TEXPLORER_GL(GL_LIGHT_MODEL_TWO_SIDE)},
    Query{TEXPLORER_GL(GL_MAP_COLOR)},
    Query{TEXPLORER_GL(GL_MATRIX_MODE)},
    Query{TEXPLORER_GL(GL_MODELVIEW_MATRIX), 16},
    Query{TEXPLORER_GL(GL_MODELVIEW_STACK_DEPTH)},
    Query{TEXPLORER_GL(GL_NORMALIZE)},
    Query{TEXPLORER_GL(GL_PACK_ALIGNMENT)},
    Query{TEXPLORER_GL(GL_PACK_ROW_LENGTH)},
    Query{TEXPLORER_GL(GL_PACK_SKIP_ROWS)},
    Query{TEXPLORER_GL(GL_PIXEL_PACK_BUFFER_BINDING)},
    Query{TEXPLORER_GL(GL_PIXEL_UNPACK_BUFFER_BINDING)},
    Query{TEXPLORER_GL(GL_POLYGON_MODE), 2},
    Query{TEXPLORER_GL(GL_PROJECTION_MATRIX), 16},
    Query{TEXPLORER_GL(GL_PROJECTION_STACK_DEPTH)},
    Query{TEXPLORER_GL(GL_PROVOKING_VERTEX)},
    Query{TEXPLORER_GL(GL_READ_BUFFER)},
    Query{TEXPLORER_GL(GL_READ_FRAMEBUFFER_BINDING)},
    Query{TEXPLORER_GL(GL_RED_SCALE)},
    Query{TEXPLORER_GL(GL_RENDERBUFFER_BINDING)},
    Query{TEXPLORER_GL(GL_SCISSOR_BOX), 4},
    Query{TEXPLORER_GL(GL_SCISSOR_TEST)},
    Query{TEXPLORER_GL(GL_SHADE_MODEL)},
    Query{TEXPLORER_GL(GL_STENCIL_TEST)},
    Query{TEXPLORER_GL(GL_TEXTURE_CUBE_MAP_SEAMLESS)},
    Query{TEXPLORER_GL(GL_UNPACK_ALIGNMENT)},
    Query{TEXPLORER_GL(GL_UNPACK_ROW_LENGTH)},
    Query{TEXPLORER_GL(GL_VERTEX_ARRAY)},
    Query{TEXPLORER_GL(GL_VERTEX_ARRAY_BINDING)},
    Query{TEXPLORER_GL(GL_VERTEX_ARRAY_POINTER)},
    Query{TEXPLORER_GL(GL_VIEWPORT), 4},
};
constexpr std::array unitQueries{
    Query{TEXPLORER_GL(GL_CURRENT_TEXTURE_COORDS), 4},
    Query{TEXPLORER_GL(GL_SAMPLER_BINDING)},
    Query{TEXPLORER_GL(GL_TEXTURE_1D)},
    Query{TEXPLORER_GL(GL_TEXTURE_2D)},
    Query{TEXPLORER_GL(GL_TEXTURE_3D)},
    Query{TEXPLORER_GL(GL_TEXTURE_BINDING_1D)},
    Query{TEXPLORER_GL(GL_TEXTURE_BINDING_2D)},
    Query{TEXPLORER_GL(GL_TEXTURE_BINDING_3D)},
    Query{TEXPLORER_GL(GL_TEXTURE_BINDING_CUBE_MAP)},
    Query{TEXPLORER_GL(GL_TEXTURE_CUBE_MAP)},
    Query{TEXPLORER_GL(GL_TEXTURE_GEN_S)},
    Query{TEXPLORER_GL(GL_TEXTURE_MATRIX), 16},
    Query{TEXPLORER_GL(GL_TEXTURE_STACK_DEPTH)},
};
#undef TEXPLORER_GL

using Snapshot = std::map<std::string, std::vector<double>>;

std::vector<double> ask(const Query& query) {
    std::vector<double> values(query.count);
    if (query.value == GL_VERTEX_ARRAY_POINTER) {
        void* pointer = nullptr;
        glGetPointerv(query.value, &pointer);
        values[0] = static_cast<double>(reinterpret_cast<std::uintptr_t>(pointer));
    } else {
        glGetDoublev(query.value, values.data());
    }
    return values;
}

/// Asks for everything; changes no state but the active unit, which it sets back.
Snapshot snapshot() {
    Snapshot found;
    for (const Query& query : queries)
        found[query.name] = ask(query);
    const auto active = static_cast<GLenum>(found["GL_ACTIVE_TEXTURE"][0]);
    for (unsigned unit = 0; unit < 8; ++unit) {
        glActiveTexture(GL_TEXTURE0 + unit);
        const std::string where = "unit " + std::to_string(unit) + " ";
        for (const Query& query : unitQueries)
            found[where + query.name] = ask(query);
        GLint mode = 0;
        glGetTexEnviv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, &mode);
        std::vector<float> color(4);
        glGetTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, color.data());
        GLfloat bias = 0;
        glGetTexEnvfv(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, &bias);
        found[where + "environment"] = {double(mode), double(bias), double(color[0]), double(color[3])};
    }
    glActiveTexture(active);
    std::vector<float> light(4);
    glGetLightfv(GL_LIGHT0, GL_POSITION, light.data());
    found["light position"].assign(light.begin(), light.end());
    glGetMaterialfv(GL_FRONT, GL_DIFFUSE, light.data());
    found["material diffuse"].assign(light.begin(), light.end());
    EXPECT_EQ(glGetError(), unsigned{GL_NO_ERROR});
    return found;
}

/// Objects and state that a caller may have lying about: as much as possible is not what it is initially.
class Caller {
public:
    Caller() {
        glGenVertexArrays(1, &vertexArray_);
        glGenSamplers(1, &sampler_);
        setTextures();
        setFramebuffer();
        setMatrices();
        setFragments();
        setLight();
        setVertices();
        setPixels();
    }
    ~Caller() {
        glDeleteVertexArrays(1, &vertexArray_);
        glDeleteSamplers(1, &sampler_);
        glDeleteProgram(program_);
    }
    Caller(const Caller&) = delete;
    Caller& operator=(const Caller&) = delete;

    [[nodiscard]] GLuint texture() const { return texture2D_.name(); }

private:
    void setTextures() {
        for (const unsigned unit : {0U, 1U, 5U}) {
            glActiveTexture(GL_TEXTURE0 + unit);
            glBindTexture(GL_TEXTURE_1D, texture1D_.name());
            glBindTexture(GL_TEXTURE_2D, texture2D_.name());
            glBindTexture(GL_TEXTURE_3D, texture3D_.name());
            glBindTexture(GL_TEXTURE_CUBE_MAP, textureCube_.name());
            glEnable(GL_TEXTURE_2D);
            glEnable(GL_TEXTURE_CUBE_MAP);
            glEnable(GL_TEXTURE_GEN_S);
            glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_ADD);
            glTexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, 3);
            glBindSampler(unit, sampler_);
        }
        glSamplerParameteri(sampler_, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
        glSamplerParameteri(sampler_, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        // Complete, so that each would show if it stayed on.
        constexpr std::array<std::uint8_t, 4> white{255, 255, 255, 255};
        glTexImage1D(GL_TEXTURE_1D, 0, GL_RGBA8, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, white.data());
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, white.data());
        glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA8, 1, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, white.data());
        for (GLenum face = 0; face < 6; ++face)
            glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, GL_RGBA8, 1, 1, 0, GL_RGBA,
                         GL_UNSIGNED_BYTE, white.data());
        glActiveTexture(GL_TEXTURE2);
    }
    void setFramebuffer() {
        glBindRenderbuffer(GL_RENDERBUFFER, renderbuffer_.name());
        glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, 4, 4);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, GL_RENDERBUFFER,
                                  renderbuffer_.name());
        glDrawBuffer(GL_COLOR_ATTACHMENT1);
        glBindFramebuffer(GL_READ_FRAMEBUFFER, otherFramebuffer_.name());
        glFramebufferRenderbuffer(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT2, GL_RENDERBUFFER,
                                  renderbuffer_.name());
        glReadBuffer(GL_COLOR_ATTACHMENT2);
    }
    static void setMatrices() {
        glMatrixMode(GL_PROJECTION);
        glScalef(2, 3, 4);
        glMatrixMode(GL_MODELVIEW);
        glPushMatrix();
        glTranslatef(1, 2, 3);
        glActiveTexture(GL_TEXTURE1);
        glMatrixMode(GL_TEXTURE);
        glRotatef(30, 0, 0, 1);
        glActiveTexture(GL_TEXTURE2);
    }
    static void setFragments() {
        for (const GLenum each :
             std::to_array<GLenum>({GL_ALPHA_TEST, GL_BLEND, GL_CLIP_PLANE0, GL_COLOR_SUM, GL_CULL_FACE,
                                    GL_DEPTH_TEST, GL_FOG, GL_SCISSOR_TEST, GL_STENCIL_TEST,
                                    GL_COLOR_LOGIC_OP, GL_POLYGON_STIPPLE, GL_TEXTURE_CUBE_MAP_SEAMLESS}))
            glEnable(each);
        constexpr std::array<double, 4> nothing{0, 0, 0, -1};
        glClipPlane(GL_CLIP_PLANE0, nothing.data());
        glAlphaFunc(GL_NEVER, 0.5F);
        glBlendFunc(GL_ZERO, GL_ONE);
        glBlendEquation(GL_FUNC_SUBTRACT);
        glColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_FALSE);
        glClearColor(1, 0, 1, 0.5F);
        glClearDepth(0.25);
        glDepthFunc(GL_NEVER);
        glDepthMask(GL_FALSE);
        glDepthRange(1, 0);
        glScissor(0, 0, 1, 1);
        glViewport(1, 2, 3, 4);
        glPolygonMode(GL_FRONT_AND_BACK, GL_POINT);
        glCullFace(GL_FRONT_AND_BACK);
        glFrontFace(GL_CW);
        glShadeModel(GL_FLAT);
        glProvokingVertex(GL_FIRST_VERTEX_CONVENTION);
        glSecondaryColor3f(1, 1, 1);
        glFogi(GL_FOG_COORD_SRC, GL_FOG_COORD);
        glFogCoordf(7);
    }
    static void setLight() {
        for (const GLenum each : std::to_array<GLenum>({GL_LIGHTING, GL_LIGHT1, GL_COLOR_MATERIAL}))
            glEnable(each);
        glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
        glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
        glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 1);
        glLightf(GL_LIGHT0, GL_CONSTANT_ATTENUATION, 9);
        constexpr std::array<float, 4> emission{1, 1, 1, 1};
        glMaterialfv(GL_FRONT_AND_BACK, GL_EMISSION, emission.data());
        glColorMaterial(GL_FRONT, GL_SPECULAR);
        glColor4f(0.1F, 0.2F, 0.3F, 0.4F);
    }
    void setVertices() {
        glBindBuffer(GL_ARRAY_BUFFER, buffer_.name());
        glBufferData(GL_ARRAY_BUFFER, 1 << 16, nullptr, GL_STATIC_DRAW);
        // Generic attribute 0 takes the place of the vertex array, also where no vertex array object is
        // bound.
        glEnableVertexAttribArray(0);
        glVertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, 0, nullptr);
        glBindVertexArray(vertexArray_);
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer_.name());
        for (const GLenum each : std::to_array<GLenum>(
                 {GL_COLOR_ARRAY, GL_SECONDARY_COLOR_ARRAY, GL_VERTEX_ARRAY, GL_EDGE_FLAG_ARRAY}))
            glEnableClientState(each);
        glVertexPointer(2, GL_FLOAT, 0, reinterpret_cast<void*>(std::size_t{64}));
        glEnableVertexAttribArray(3);
        glClientActiveTexture(GL_TEXTURE3);
        glEnableClientState(GL_TEXTURE_COORD_ARRAY);
        program_ = glCreateProgram();
        const GLuint shader = glCreateShader(GL_FRAGMENT_SHADER);
        const char* source = "void main() { gl_FragColor = vec4(1.0, 0.0, 1.0, 0.5); }";
        glShaderSource(shader, 1, &source, nullptr);
        glCompileShader(shader);
        glAttachShader(program_, shader);
        glLinkProgram(program_);
        glDeleteShader(shader);
        glUseProgram(program_);
    }
    void setPixels() {
        glBindBuffer(GL_PIXEL_PACK_BUFFER, packBuffer_.name());
        glBindBuffer(GL_PIXEL_UNPACK_BUFFER, buffer_.name());
        glPixelStorei(GL_PACK_ALIGNMENT, 8);
        glPixelStorei(GL_PACK_ROW_LENGTH, 77);
        glPixelStorei(GL_PACK_SKIP_ROWS, 3);
        glPixelStorei(GL_UNPACK_ALIGNMENT, 2);
        glPixelStorei(GL_UNPACK_ROW_LENGTH, 55);
        glPixelStorei(GL_UNPACK_SWAP_BYTES, GL_TRUE);
        glPixelTransferf(GL_RED_SCALE, 0.5F);
        glPixelTransferf(GL_GREEN_BIAS, 0.5F);
    }

    TextureHandle texture1D_ = TextureHandle::create();
    TextureHandle texture2D_ = TextureHandle::create();
    TextureHandle texture3D_ = TextureHandle::create();
    TextureHandle textureCube_ = TextureHandle::create();
    BufferHandle buffer_ = BufferHandle::create();
    BufferHandle packBuffer_ = BufferHandle::create();
    FramebufferHandle framebuffer_ = FramebufferHandle::create();
    FramebufferHandle otherFramebuffer_ = FramebufferHandle::create();
    RenderbufferHandle renderbuffer_ = RenderbufferHandle::create();
    GLuint vertexArray_ = 0;
    GLuint sampler_ = 0;
    GLuint program_ = 0;
};

/// Uses as much as a scene can.
Scene richScene() {
    Scene scene = defaultScene();
    scene.textures.push_back(scene.textures[0]);
    scene.textures[1].pattern = Pattern::Marble;
    scene.material.shadeModel = ShadeModel::Flat;
    scene.light.colorControl = ColorControl::SeparateSpecular;
    scene.light.twoSide = true;
    scene.passes[0].fog = {true, FogMode::Linear, 1, 4, 9, {0.4F, 0.5F, 0.6F, 1}};
    Unit& second = scene.passes[0].units[1];
    second.enabled = true;
    second.texture = 1;
    second.target = Target::Texture3D;
    second.matrix = {{.op = MatrixOp::Rotate, .amount = {0, 0, 1}, .angle = 30}};
    Pass overlay = scene.passes[0];
    overlay.depthFunc = CompareFunc::LessEqual;
    overlay.blend = true;
    overlay.blendDst = BlendFactor::One;
    overlay.units[1].enabled = false;
    overlay.units[0].lodBias = 1;
    scene.passes.push_back(overlay);
    return scene;
}

class BorrowedState : public RenderTest {};

TEST_F(BorrowedState, IsReturned) {
    const Caller caller;
    const Snapshot before = snapshot();
    (void)picture(richScene(), 32, 1);
    EXPECT_THAT(problems, testing::IsEmpty());
    const Snapshot after = snapshot();
    for (const auto& [name, values] : before)
        EXPECT_EQ(after.at(name), values) << name;
}

TEST_F(BorrowedState, IsReturnedBetweenMeasurementsOfTheCost) {
    const Caller caller;
    const Snapshot before = snapshot();
    CostMeter meter(capabilities, {}, 1);
    view::TextureCosts costs;
    while (meter.measure(costs, std::chrono::milliseconds(0))) {
        const Snapshot after = snapshot();
        for (const auto& [name, values] : before)
            ASSERT_EQ(after.at(name), values) << name;
    }
    EXPECT_EQ(costs.front().times.b.size(), 1U);
}

TEST_F(BorrowedState, DoesNotReachThePicture) {
    const Image expected = picture(richScene(), 64, 1);
    auto fresh = makeRenderer(capabilities);
    ASSERT_TRUE(fresh);
    renderer = std::move(*fresh);
    const Caller caller;
    EXPECT_EQ(picture(richScene(), 64, 1), expected);
    EXPECT_EQ(picture(richScene(), 64, 1), expected);
}

TEST_F(BorrowedState, IsReturnedWhereTheCallerHasFilledTheAttributeStack) {
    GLint places = 0;
    glGetIntegerv(GL_MAX_ATTRIB_STACK_DEPTH, &places);
    for (GLint i = 0; i < places; ++i)
        glPushAttrib(GL_CURRENT_BIT);
    (void)picture(flatScene());
    EXPECT_THAT(problems, testing::ElementsAre("glPushAttrib: GL_STACK_OVERFLOW (A stack is full.)"));
    GLint depth = 0;
    glGetIntegerv(GL_ATTRIB_STACK_DEPTH, &depth);
    EXPECT_EQ(depth, places);
}

// glPopAttrib sets the parameters of bound textures back: ours must keep what they were given in between.
TEST_F(BorrowedState, ParametersOfATextureThatTheCallerHasBoundStayChanged) {
    const TextureHandle texture = TextureHandle::create();
    glBindTexture(GL_TEXTURE_2D, texture.name());
    {
        const StateGuard guard;
        glBindTexture(GL_TEXTURE_2D, texture.name());
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP);
    }
    GLint bound = 0;
    glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
    EXPECT_EQ(static_cast<GLuint>(bound), texture.name());
    GLint wrap = 0;
    glGetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, &wrap);
    EXPECT_EQ(wrap, GL_CLAMP);
}

} // namespace
} // namespace texplorer::render::state_guard_test

#include "app/render/capabilities.h"

#include "app/render/gl_errors.h"
#include "app/render/gl_functions.h"

#include <GL/glew.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace texplorer::render {

namespace {

constexpr const char* neededVersion = "GL_VERSION_2_1";
constexpr std::array neededFramebuffers{"GL_VERSION_3_0", "GL_ARB_framebuffer_object"};
constexpr const char* anisotropy = "GL_EXT_texture_filter_anisotropic";
constexpr const char* s3tc = "GL_EXT_texture_compression_s3tc";
constexpr std::array rgtc{"GL_VERSION_3_0", "GL_ARB_texture_compression_rgtc"};
constexpr std::array floatTextures{"GL_VERSION_3_0", "GL_ARB_texture_float"};
constexpr std::array seamlessCubeMaps{"GL_VERSION_3_2", "GL_ARB_seamless_cube_map"};

/// GLEW checks for all names of a string; here any one of them is enough.
bool has(const char* name) {
    return glewIsSupported(name);
}

std::string text(GLenum name) {
    const GLubyte* found = glGetString(name);
    return found ? reinterpret_cast<const char*>(found) : "";
}

int integer(GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

/// Whether a texture keeps the border texels of its image. Restores the bound texture.
bool keepsBorders() {
    GLint bound = 0;
    glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 3, 3, 1, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    GLint border = 0;
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_BORDER, &border);
    glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(bound));
    glDeleteTextures(1, &name);
    return GlErrors().check(N_("glTexImage2D with a border")) && border == 1;
}

/// glewInit() checks GLX after it has loaded every OpenGL function. Without GLX, under OSMesa and Wayland, it
/// returns one of two errors that do not concern OpenGL.
bool functionsAreLoaded(GLenum status) {
    return status == GLEW_OK || status == GLEW_ERROR_GLX_VERSION_11_ONLY ||
           status == GLEW_ERROR_NO_GLX_DISPLAY;
}

} // namespace

bool hasFixedFunctions() {
    glPushAttrib(GL_CURRENT_BIT); // because attributes are kept on stacks
    glPopAttrib();
    return GlErrors().check("glPushAttrib");
}

view::Capabilities namedCapabilities() {
    view::Capabilities capabilities;
    capabilities.vendor = text(GL_VENDOR);
    capabilities.renderer = text(GL_RENDERER);
    capabilities.version = text(GL_VERSION);
    capabilities.maxTextureSize = integer(GL_MAX_TEXTURE_SIZE);
    return capabilities;
}

Result<view::Capabilities> loadCapabilities() {
    const auto needs = [](const Sentence& but) {
        return Sentence("Texplorer needs OpenGL 2.1 with framebuffer objects; {0}", but);
    };
    if (const GLenum status = glewInit(); !functionsAreLoaded(status))
        return fail(ErrorCode::Driver,
                    needs(Sentence("no functions of OpenGL could be loaded: {0}",
                                   reinterpret_cast<const char*>(glewGetErrorString(status)))));
    static_cast<void>(GlErrors().check("glewInit")); // GLEW queries features that a core profile has removed

    view::Capabilities capabilities = namedCapabilities();
    const Sentence offer(N_("{0} offers version {1}"), ProperName{capabilities.renderer},
                         ProperName{capabilities.version});
    if (!has(neededVersion))
        return fail(ErrorCode::Unsupported, needs(offer));
    if (std::ranges::none_of(neededFramebuffers, has))
        return fail(ErrorCode::Unsupported, needs(Sentence("{0} without GL_ARB_framebuffer_object", offer)));

    const std::span<const GlFunction> functions = glFunctions();
    const auto missing = std::ranges::find_if(
        functions, [](const GlFunction& each) { return each.needed && !each.isLoaded(); });
    if (missing != functions.end())
        return fail(ErrorCode::Unsupported,
                    needs(Sentence("{0} without the function {1} ({2})", offer, ProperName{missing->name},
                                   ProperName{missing->source})));

    capabilities.s3tc = has(s3tc);
    capabilities.rgtc = std::ranges::any_of(rgtc, has);
    capabilities.floatTextures = std::ranges::any_of(floatTextures, has);
    capabilities.seamlessCubeMaps = std::ranges::any_of(seamlessCubeMaps, has);
    capabilities.shaders = has("GL_VERSION_3_3");
    capabilities.max3DTextureSize = integer(GL_MAX_3D_TEXTURE_SIZE);
    capabilities.maxCubeMapSize = integer(GL_MAX_CUBE_MAP_TEXTURE_SIZE);
    capabilities.textureUnits = integer(GL_MAX_TEXTURE_UNITS);
    if (!GlErrors().check("glGetIntegerv") || capabilities.textureUnits < 1 || !hasFixedFunctions())
        return fail(ErrorCode::Unsupported,
                    needs(Sentence("{0} without fixed functions (a core profile)", offer)));
    capabilities.textureBorders = keepsBorders();
    if (has(anisotropy))
        glGetFloatv(GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT, &capabilities.maxAnisotropy);
    return capabilities;
}

} // namespace texplorer::render

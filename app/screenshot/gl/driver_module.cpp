// What contexts there are and what each says of itself, for texshot drivers.

#include "app/offscreen/context.h"
#include "app/render/capabilities.h"
#include "app/render/driver_cache.h"
#include "app/screenshot/gl/driver_report.h"

#include <GL/glew.h>

#include <sstream>

namespace texplorer::screenshot {
namespace {

std::string stringOf(GLenum name) {
    const GLubyte* found = glGetString(name);
    return found ? reinterpret_cast<const char*>(found) : "";
}

/// A core profile has no list in one piece.
std::vector<std::string> extensionNames() {
    std::vector<std::string> names;
    std::istringstream list(stringOf(GL_EXTENSIONS));
    for (std::string name; list >> name;)
        names.push_back(name);
    GLint count = 0;
    if (names.empty() && glGetStringi)
        glGetIntegerv(GL_NUM_EXTENSIONS, &count);
    for (GLint i = 0; i < count; ++i) {
        if (const GLubyte* name = glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(i)))
            names.emplace_back(reinterpret_cast<const char*>(name));
    }
    return names;
}

Result<DriverReport> reportOn(const view::ContextChoice& choice) {
    const Result<offscreen::Context> context = offscreen::Context::create({1, 1}, choice);
    if (!context)
        return fail(context.error());
    const Result<view::Capabilities> whole = render::loadCapabilities();
    const view::Capabilities found = whole ? *whole : render::namedCapabilities();
    return DriverReport{.renderer = found.renderer,
                        .vendor = found.vendor,
                        .version = found.version,
                        .shadingLanguage = stringOf(GL_SHADING_LANGUAGE_VERSION),
                        .isCore = !whole && !render::hasFixedFunctions(),
                        .maxTextureSize = found.maxTextureSize,
                        .maxAnisotropy = found.maxAnisotropy,
                        .s3tc = found.s3tc,
                        .textureBorders = found.textureBorders,
                        .extensions = extensionNames(),
                        .lack = whole ? Sentence() : whole.error().message};
}

} // namespace
} // namespace texplorer::screenshot

extern "C" [[gnu::visibility("default")]] void
texshotContexts(std::vector<texplorer::view::ContextChoice>& contexts) {
    contexts = texplorer::offscreen::Context::all();
}

extern "C" [[gnu::visibility("default")]] void
texshotDriver(const texplorer::view::ContextChoice& choice,
              texplorer::Result<texplorer::screenshot::DriverReport>& report) {
    texplorer::render::setUpDriverCache();
    report = texplorer::screenshot::reportOn(choice);
}

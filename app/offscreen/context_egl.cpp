#include "app/offscreen/context.h"
#include "app/offscreen/egl_display.h"
#include "app/offscreen/gl_lookup.h"
#include "app/offscreen/own_framebuffer.h"

#include <fmt/core.h>

#include <EGL/eglext.h>
#include <array>
#include <cstdlib>
#include <string>

namespace texplorer::offscreen {

namespace {

using Kind = view::ContextChoice::Kind;

enum class Profile {
    Compatibility, ///< what a context has that asks for nothing
    Core,          ///< so that who asks for its capabilities can be told what there is instead
};

constexpr std::array coreAttributes{EGL_CONTEXT_MAJOR_VERSION,
                                    3,
                                    EGL_CONTEXT_MINOR_VERSION,
                                    2,
                                    EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                    EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                    EGL_NONE};
constexpr std::array configAttributes{EGL_SURFACE_TYPE,
                                      EGL_PBUFFER_BIT,
                                      EGL_RENDERABLE_TYPE,
                                      EGL_OPENGL_BIT,
                                      EGL_RED_SIZE,
                                      8,
                                      EGL_GREEN_SIZE,
                                      8,
                                      EGL_BLUE_SIZE,
                                      8,
                                      EGL_ALPHA_SIZE,
                                      8,
                                      EGL_NONE};

tl::unexpected<Error> refusal(const char* function) {
    return fail(ErrorCode::Driver, fmt::format("{} says {}", function, eglError()));
}

} // namespace

struct Context::State {
    EGLDisplay display;
    EGLContext context = EGL_NO_CONTEXT;
    EGLSurface surface = EGL_NO_SURFACE; // where the driver wants one; nothing is drawn there

    explicit State(EGLDisplay opened)
        : display(opened) {}
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    ~State() {
        if (context != EGL_NO_CONTEXT && eglGetCurrentContext() == context)
            eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (surface != EGL_NO_SURFACE)
            eglDestroySurface(display, surface);
        if (context != EGL_NO_CONTEXT)
            eglDestroyContext(display, context);
    }

    /// Makes the context current.
    Result<void> open(Profile profile, view::Size size) {
        const std::array wanted{EGL_WIDTH, size.width, EGL_HEIGHT, size.height, EGL_NONE};
        EGLConfig config = nullptr;
        EGLint count = 0;
        if (!eglBindAPI(EGL_OPENGL_API))
            return refusal("eglBindAPI(EGL_OPENGL_API)");
        if (!eglChooseConfig(display, configAttributes.data(), &config, 1, &count))
            return refusal("eglChooseConfig");
        if (count < 1)
            return fail(ErrorCode::Unsupported,
                        "there is no configuration with OpenGL and eight bits of RGBA");
        context = eglCreateContext(display, config, EGL_NO_CONTEXT,
                                   profile == Profile::Core ? coreAttributes.data() : nullptr);
        if (context == EGL_NO_CONTEXT)
            return refusal("eglCreateContext");
        if (getenv("PB") ||
            !hasExtension(eglQueryString(display, EGL_EXTENSIONS), "EGL_KHR_surfaceless_context")) {
            surface = eglCreatePbufferSurface(display, config, wanted.data());
            if (surface == EGL_NO_SURFACE)
                return refusal("eglCreatePbufferSurface");
        }
        return eglMakeCurrent(display, surface, surface, context) ? Result<void>()
                                                                  : refusal("eglMakeCurrent");
    }
};

Context::Context(std::unique_ptr<State> state)
    : state_(std::move(state)) {}
Context::Context(Context&&) noexcept = default;
Context& Context::operator=(Context&&) noexcept = default;
Context::~Context() = default;

std::vector<view::ContextChoice> Context::all() {
    return eglPlaces({Kind::Egl, 0});
}

Result<Context> Context::create(view::Size size, const view::ContextChoice& choice) {
    if (choice.kind == Kind::Osmesa)
        return fail(ErrorCode::Unsupported, fmt::format("EGL has no context {}", choice.text()));
    const std::vector<view::ContextChoice> places = eglPlaces(choice);
    std::string reasons;
    for (const Profile profile : {Profile::Compatibility, Profile::Core}) {
        for (const view::ContextChoice& place : places) {
            const Result<EGLDisplay> display = openEglDisplay(place);
            auto state = std::make_unique<State>(display.value_or(EGL_NO_DISPLAY));
            const Result<void> opened = display ? state->open(profile, size) : fail(display.error());
            if (opened) {
                if (const Result<void> bound = getenv("PB") ? Result<void>() : bindOwnFramebuffer(size);
                    !bound)
                    return fail(bound.error());
                return Context(std::move(state));
            }
            if (profile == Profile::Compatibility) // of a core profile the reasons are the same
                reasons += fmt::format("{}{}: {}", reasons.empty() ? "" : "; ", place.text(),
                                       opened.error().message);
        }
    }
    return fail(ErrorCode::Driver, fmt::format("EGL gave no context of OpenGL ({})", reasons));
}

AnyFunction findGlFunction(const char* name) {
    return eglGetProcAddress(name);
}

} // namespace texplorer::offscreen

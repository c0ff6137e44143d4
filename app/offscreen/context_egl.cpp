#include "app/offscreen/context.h"
#include "app/offscreen/egl_display.h"
#include "app/offscreen/gl_lookup.h"
#include "texplorer/base/sentence_format.h"

#include <GL/gl.h>
#include <fmt/core.h>

#include <EGL/eglext.h>
#include <array>
#include <string>
#include <utility>

namespace texplorer::offscreen {

namespace {

using Kind = view::ContextChoice::Kind;

enum class Profile {
    Compatibility, ///< the profile of a context without attributes
    Core,          ///< used to report what the driver has instead
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
                                      EGL_DEPTH_SIZE,
                                      24,
                                      EGL_NONE};
constexpr view::Size minSize{1, 1};

tl::unexpected<Error> refusal(const char* function) {
    return fail(ErrorCode::Driver, Sentence("{0} says {1}", function, eglError()));
}

} // namespace

struct Context::State {
    EGLDisplay display;
    EGLConfig config = nullptr;
    EGLContext context = EGL_NO_CONTEXT;
    EGLSurface surface = EGL_NO_SURFACE; // a pbuffer

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

    /// Creates the context and makes it current with the smallest framebuffer.
    Result<void> open(Profile profile) {
        EGLint count = 0;
        if (!eglBindAPI(EGL_OPENGL_API))
            return refusal("eglBindAPI(EGL_OPENGL_API)");
        if (!eglChooseConfig(display, configAttributes.data(), &config, 1, &count))
            return refusal("eglChooseConfig");
        if (count < 1)
            return fail(ErrorCode::Unsupported,
                        "there is no configuration for OpenGL and pbuffers with 8 bits "
                        "of each of RGBA and 24 of depth");
        context = eglCreateContext(display, config, EGL_NO_CONTEXT,
                                   profile == Profile::Core ? coreAttributes.data() : nullptr);
        return context == EGL_NO_CONTEXT ? refusal("eglCreateContext") : bind(minSize);
    }

    /// Replaces the framebuffer. The maximum size is known once the context is current.
    Result<void> resize(view::Size size) {
        if (size == minSize)
            return {};
        std::array<GLint, 2> limit{};
        glGetIntegerv(GL_MAX_VIEWPORT_DIMS, limit.data());
        if (size.width < 1 || size.height < 1 || size.width > limit[0] || size.height > limit[1])
            return fail(ErrorCode::OutOfRange,
                        Sentence("an off-screen framebuffer has 1 × 1 to {0} pixels, not {1}",
                                 asText(view::Size{limit[0], limit[1]}), asText(size)));
        if (Result<void> bound = bind(size); !bound)
            return bound;
        glViewport(0, 0, size.width, size.height); // set by the first framebuffer of a context
        glScissor(0, 0, size.width, size.height);
        return {};
    }

private:
    Result<void> bind(view::Size size) {
        const std::array attributes{EGL_WIDTH, size.width, EGL_HEIGHT, size.height, EGL_NONE};
        EGLSurface made = eglCreatePbufferSurface(display, config, attributes.data());
        if (made == EGL_NO_SURFACE)
            return refusal("eglCreatePbufferSurface");
        std::swap(made, surface);
        const bool isCurrent = eglMakeCurrent(display, surface, surface, context) == EGL_TRUE;
        Result<void> result = isCurrent ? Result<void>() : refusal("eglMakeCurrent");
        if (made != EGL_NO_SURFACE)
            eglDestroySurface(display, made);
        return result;
    }
};

Context::Context(std::unique_ptr<State> state, const view::ContextChoice& kind)
    : state_(std::move(state))
    , kind_(kind) {}
Context::Context(Context&&) noexcept = default;
Context& Context::operator=(Context&&) noexcept = default;
Context::~Context() = default;

std::vector<view::ContextChoice> Context::all() {
    return eglPlaces({Kind::Egl, 0});
}

Result<Context> Context::create(view::Size size, const view::ContextChoice& choice) {
    if (choice.kind == Kind::Osmesa)
        return fail(ErrorCode::Unsupported, Sentence("EGL has no context {0}", choice.text()));
    const std::vector<view::ContextChoice> places = eglPlaces(choice);
    std::string reasons;
    for (const Profile profile : {Profile::Compatibility, Profile::Core}) {
        for (const view::ContextChoice& place : places) {
            const Result<EGLDisplay> display = openEglDisplay(place);
            auto state = std::make_unique<State>(display.value_or(EGL_NO_DISPLAY));
            const Result<void> opened = display ? state->open(profile) : fail(display.error());
            if (opened) {
                if (const Result<void> resized = state->resize(size); !resized)
                    return fail(resized.error());
                return Context(std::move(state), place);
            }
            if (profile == Profile::Compatibility) // a core profile fails for the same reasons
                reasons += fmt::format("{}{}: {}", reasons.empty() ? "" : "; ", place.text(),
                                       opened.error().message);
        }
    }
    return fail(ErrorCode::Driver, Sentence("EGL made no OpenGL context ({0})", reasons));
}

AnyFunction findGlFunction(const char* name) {
    return eglGetProcAddress(name);
}

} // namespace texplorer::offscreen

#include "app/offscreen/context.h"
#include "app/offscreen/gl_lookup.h"
#include "texplorer/base/bytes.h"

#include <GL/osmesa.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <new>
#include <string>
#include <type_traits>

namespace texplorer::offscreen {

namespace {

/// The Gallium drivers that draw into memory. OSMesa crashes with any other name.
constexpr std::array drivers{"llvmpipe", "softpipe"};

Result<void> checkDriverName() {
    const char* name = std::getenv("GALLIUM_DRIVER"); // NOLINT(concurrency-mt-unsafe): no thread changes it
    if (!name || *name == '\0' ||
        std::ranges::any_of(drivers, [&](const char* each) { return std::strcmp(each, name) == 0; }))
        return {};
    return fail(
        ErrorCode::Unsupported,
        Sentence("GALLIUM_DRIVER names the driver \"{0}\"; without a display, only llvmpipe and softpipe are "
                 "available",
                 name));
}

} // namespace

struct Context::State {
    std::unique_ptr<std::remove_pointer_t<OSMesaContext>, void (*)(OSMesaContext)> context{
        nullptr, OSMesaDestroyContext};
    Bytes pixels; // Mesa draws into this for as long as the context is current

    State() = default;
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    ~State() {
        if (context && OSMesaGetCurrentContext() == context.get())
            OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
    }
};

Context::Context(std::unique_ptr<State> state, const view::ContextChoice& kind)
    : state_(std::move(state))
    , kind_(kind) {}
Context::Context(Context&&) noexcept = default;
Context& Context::operator=(Context&&) noexcept = default;
Context::~Context() = default;

std::vector<view::ContextChoice> Context::all() {
    return {{view::ContextChoice::Kind::Osmesa, 0}};
}

Result<Context> Context::create(view::Size size, const view::ContextChoice& choice) {
    using Kind = view::ContextChoice::Kind;
    if (choice.kind != Kind::Auto && choice.kind != Kind::Osmesa)
        return fail(ErrorCode::Unsupported, Sentence("OSMesa has no context {0}", choice.text()));
    if (const Result<void> known = checkDriverName(); !known)
        return fail(known.error());
    GLint limit = 0;
    OSMesaGetIntegerv(OSMESA_MAX_WIDTH, &limit);
    if (size.width < 1 || size.height < 1 || size.width > limit || size.height > limit)
        return fail(ErrorCode::OutOfRange,
                    Sentence("an off-screen framebuffer has 1 × 1 to {0} pixels, not {1}",
                             asText(view::Size{limit, limit}), asText(size)));

    const int attributes[] = {
        OSMESA_FORMAT, OSMESA_RGBA, OSMESA_DEPTH_BITS, 24, OSMESA_PROFILE, OSMESA_COMPAT_PROFILE, 0};
    auto state = std::make_unique<State>();
    state->context.reset(OSMesaCreateContextAttribs(attributes, nullptr));
    if (!state->context)
        return fail(ErrorCode::Driver, "OSMesa made no context of the OpenGL compatibility profile");

    try {
        state->pixels.resize(std::size_t{4} * static_cast<std::size_t>(size.width) *
                             static_cast<std::size_t>(size.height));
    } catch (const std::bad_alloc&) {
        return fail(ErrorCode::TooLarge,
                    Sentence("not enough memory for an off-screen framebuffer of {0} pixels", asText(size)));
    }
    if (!OSMesaMakeCurrent(state->context.get(), state->pixels.data(), GL_UNSIGNED_BYTE, size.width,
                           size.height))
        return fail(ErrorCode::Driver,
                    Sentence("OSMesa refused to draw into a framebuffer of {0} pixels", asText(size)));
    return Context(std::move(state), {Kind::Osmesa, 0});
}

AnyFunction findGlFunction(const char* name) {
    return OSMesaGetProcAddress(name);
}

} // namespace texplorer::offscreen

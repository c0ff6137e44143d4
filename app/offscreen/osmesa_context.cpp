#include "app/offscreen/osmesa_context.h"

#include "core/base/bytes.h"

#include <GL/osmesa.h>

#include <new>
#include <string>
#include <type_traits>

namespace texplorer::offscreen {

namespace {

struct DestroyContext {
    void operator()(OSMesaContext context) const { OSMesaDestroyContext(context); }
};
using Context = std::unique_ptr<std::remove_pointer_t<OSMesaContext>, DestroyContext>;

} // namespace

struct OsmesaContext::State {
    Context context;
    Bytes pixels; // Mesa draws into this for as long as the context is current

    State() = default;
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    ~State() {
        if (context && OSMesaGetCurrentContext() == context.get())
            OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
    }
};

OsmesaContext::OsmesaContext(std::unique_ptr<State> state)
    : state_(std::move(state)) {}
OsmesaContext::OsmesaContext(OsmesaContext&&) noexcept = default;
OsmesaContext& OsmesaContext::operator=(OsmesaContext&&) noexcept = default;
OsmesaContext::~OsmesaContext() = default;

Result<OsmesaContext> OsmesaContext::create(render::Size size) {
    GLint limit = 0;
    OSMesaGetIntegerv(OSMESA_MAX_WIDTH, &limit);
    if (size.width < 1 || size.height < 1 || size.width > limit || size.height > limit)
        return fail(ErrorCode::OutOfRange, "an off-screen framebuffer has 1 x 1 to " +
                                               asText(render::Size{limit, limit}) + " pixels, not " +
                                               asText(size));

    const int attributes[] = {
        OSMESA_FORMAT, OSMESA_RGBA, OSMESA_DEPTH_BITS, 24, OSMESA_PROFILE, OSMESA_COMPAT_PROFILE, 0};
    auto state = std::make_unique<State>();
    state->context.reset(OSMesaCreateContextAttribs(attributes, nullptr));
    if (!state->context)
        return fail(ErrorCode::Driver, "OSMesa gave no context of the OpenGL compatibility profile");

    try {
        state->pixels.resize(std::size_t{4} * static_cast<std::size_t>(size.width) *
                             static_cast<std::size_t>(size.height));
    } catch (const std::bad_alloc&) {
        return fail(ErrorCode::TooLarge,
                    "there is no memory for an off-screen framebuffer of " + asText(size) + " pixels");
    }
    if (!OSMesaMakeCurrent(state->context.get(), state->pixels.data(), GL_UNSIGNED_BYTE, size.width,
                           size.height))
        return fail(ErrorCode::Driver,
                    "OSMesa refused to draw into a framebuffer of " + asText(size) + " pixels");
    return OsmesaContext(std::move(state));
}

} // namespace texplorer::offscreen

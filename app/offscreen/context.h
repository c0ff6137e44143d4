#pragma once

// OpenGL without a display. Two libraries define this class, one by OSMesa and one by EGL: a program or
// module links one of them, for both bring a libGL's worth of gl* functions.

#include "app/view/context_choice.h"
#include "app/view/size.h"
#include "core/base/result.h"

#include <memory>
#include <vector>

namespace texplorer::offscreen {

/// A context that is current on the thread that created it, until it is destroyed: of the compatibility
/// profile, or where the driver has none of that, a core profile. It has its own framebuffer of `size`
/// pixels: eight bits of each of RGBA, 24 of depth.
class Context {
public:
    /// `choice`: Auto is whatever this library has. The error says what was tried and what went wrong.
    [[nodiscard]] static Result<Context> create(view::Size size, const view::ContextChoice& choice = {});

    /// Every context that create() may be asked for by itself, whether or not it gives one: OSMesa; EGL's
    /// surfaceless platform and its devices.
    [[nodiscard]] static std::vector<view::ContextChoice> all();

    /// What create() came by: Osmesa, EglSurfaceless or EglDevice.
    [[nodiscard]] const view::ContextChoice& kind() const { return kind_; }

    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
    Context(Context&&) noexcept;
    Context& operator=(Context&&) noexcept;
    ~Context();

private:
    struct State;
    Context(std::unique_ptr<State> state, const view::ContextChoice& kind);
    std::unique_ptr<State> state_;
    view::ContextChoice kind_;
};

} // namespace texplorer::offscreen

#pragma once

// OpenGL without a display. Two libraries define this class, one by OSMesa and one by EGL. A program or
// module links one of them, because both define the gl* functions.

#include "app/view/context_choice.h"
#include "app/view/size.h"
#include "texplorer/base/result.h"

#include <memory>
#include <vector>

namespace texplorer::offscreen {

/// An OpenGL context, current on the thread that created it until it is destroyed. It has the compatibility
/// profile, or a core profile if the driver has no other. Its framebuffer has `size` pixels with 8 bits per
/// component of RGBA and a 24-bit depth buffer.
class Context {
public:
    /// `choice`: Auto tries all that this library has. The error lists what was tried and what failed.
    [[nodiscard]] static Result<Context> create(view::Size size, const view::ContextChoice& choice = {});

    /// Every context that create() accepts explicitly, whether or not it works here: OSMesa; EGL's
    /// surfaceless platform and its devices.
    [[nodiscard]] static std::vector<view::ContextChoice> all();

    /// The kind of the created context: Osmesa, EglSurfaceless or EglDevice.
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

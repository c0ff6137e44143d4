#pragma once

#include "app/stage/event.h"
#include "texplorer/base/clock.h"
#include "texplorer/base/result.h"

#include <imgui.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace texplorer::explorer {

/// How a window creates its OpenGL context.
enum class ContextApi : std::uint8_t {
    Native, ///< the display's default: GLX on X11, EGL on Wayland
    Egl,
};

/// The program's only window. Its OpenGL context is current on the thread that created it.
class Window {
public:
    /// Fails if there is no display, or if the display lacks something; the error says what.
    [[nodiscard]] static Result<Window> open(view::Size size, const std::string& title,
                                             ContextApi context = ContextApi::Native);
    Window(Window&&) noexcept;
    Window& operator=(Window&&) noexcept;
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;
    ~Window();

    /// The events since the last call, in their order.
    [[nodiscard]] std::vector<stage::Event> takeEvents();
    /// The current state. `takeEvents` reports changes.
    [[nodiscard]] stage::Surface surface() const;

    /// Sleeps until an event arrives.
    void wait();
    /// Sleeps for `seconds` or until an event arrives. With 0 or less it processes pending events and
    /// returns.
    void wait(double seconds);

    /// Ends a wait. Can be called on any thread.
    static void wake();

    /// Sets a function for a lost connection to the display (X11). It runs on the thread that notices the
    /// loss; then the program ends with status 1. Stays set until the process ends.
    static void whenDisplayIsLost(void (*action)());

    [[nodiscard]] double frameSeconds() const; ///< how long the monitor shows a frame
    [[nodiscard]] static double now() { return steadySeconds(); }

    /// Switches to full screen on the monitor that shows most of the window, or back to the previous
    /// position.
    void fillScreen(bool fills);
    void setTitle(const std::string& title);
    void setCursor(ImGuiMouseCursor cursor);
    [[nodiscard]] std::string clipboard() const;
    void setClipboard(const std::string& text);
    void swap();

private:
    struct State;
    struct Callbacks;
    explicit Window(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

} // namespace texplorer::explorer

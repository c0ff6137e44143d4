#pragma once

#include "app/stage/event.h"
#include "core/base/clock.h"
#include "core/base/result.h"

#include <imgui.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace texplorer::explorer {

/// How a window gets its OpenGL.
enum class ContextApi : std::uint8_t {
    Native, ///< as the display has it: GLX on X11, EGL on Wayland
    Egl,
};

/// The one window of the program, with an OpenGL context that is current on the thread that made it.
class Window {
public:
    /// The error says that there is no display, or what the display lacks.
    [[nodiscard]] static Result<Window> open(view::Size size, const std::string& title,
                                             ContextApi context = ContextApi::Native);
    Window(Window&&) noexcept;
    Window& operator=(Window&&) noexcept;
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;
    ~Window();

    /// What has happened since the last call, in that order.
    [[nodiscard]] std::vector<stage::Event> takeEvents();
    /// As it is now. `takeEvents` says when it has changed.
    [[nodiscard]] stage::Surface surface() const;

    /// Sleeps until something happens.
    void wait();
    /// Sleeps for `seconds`, or less where something happens. 0 or less: takes what is there and returns.
    void wait(double seconds);

    /// Ends a wait, from any thread: there is news to show.
    static void wake();

    /// What is done on X11 when the display goes away, on the thread that notices it; then the program ends
    /// with status 1. For the rest of the process.
    static void whenDisplayIsLost(void (*action)());

    [[nodiscard]] double frameSeconds() const; ///< how long the monitor shows a frame
    [[nodiscard]] static double now() { return steadySeconds(); }

    /// Over the whole monitor that most of it is on, or as it was before that.
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

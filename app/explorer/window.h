#pragma once

#include "app/view/frame.h"
#include "core/base/result.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

struct GLFWwindow;

namespace texplorer::explorer {

/// The one window of the program, with an OpenGL context that is current on the thread that made it. Input
/// goes to Dear ImGui, whose GLFW backend must be initialised for `handle()` before the first event is waited
/// for.
class Window {
public:
    /// The error says that there is no display, or what the display lacks.
    [[nodiscard]] static Result<Window> open(view::Size size, const std::string& title);
    Window(Window&&) noexcept;
    Window& operator=(Window&&) noexcept;
    ~Window();

    [[nodiscard]] GLFWwindow* handle() const;

    /// What has happened since the last call.
    struct Events {
        bool any = false; ///< something that asks for a new picture
        bool close = false;
        bool scaleChanged = false;
        std::vector<std::filesystem::path> dropped;
    };
    [[nodiscard]] Events takeEvents();

    /// Gives Dear ImGui the keys that one frame can take. True where more are waiting for the next one.
    bool feedKeys();

    /// Sleeps until something happens.
    void wait();
    /// Sleeps for `seconds`, or less where something happens. 0 or less: takes what is there and returns.
    void wait(double seconds);

    /// Ends a wait, from any thread.
    static void wake();

    [[nodiscard]] bool isHidden() const;          ///< minimised, or without a single pixel
    [[nodiscard]] view::Size size() const;        ///< in screen coordinates, in which the mouse is measured
    [[nodiscard]] view::Size framebuffer() const; ///< in pixels
    [[nodiscard]] float contentScale() const;     ///< pixels of the monitor to those of a plain one
    [[nodiscard]] double frameSeconds() const;    ///< how long the monitor shows a frame
    [[nodiscard]] double now() const;             ///< seconds on a clock that only goes forwards

    void setTitle(const std::string& title);
    void swap();

private:
    struct State;
    explicit Window(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

} // namespace texplorer::explorer

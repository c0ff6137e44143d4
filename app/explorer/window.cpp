#include "app/explorer/window.h"

#include "app/render/driver_cache.h"
#include "app/ui/state/min_window_size.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cctype>
#include <cstdlib>
#include <dlfcn.h>
#include <map>
#include <optional>
#include <utility>

namespace texplorer::explorer {
namespace {

std::string lastGlfwError;
std::atomic<bool> woken = false; // set by any thread; there is one window

void rememberError(int /*code*/, const char* description) {
    lastGlfwError = description;
}

constexpr double minRefreshRate = 60; // hertz; virtual displays report less, or 0

/// Pointer shapes other than the arrow.
constexpr std::array cursorShapes{std::pair{ImGuiMouseCursor_TextInput, GLFW_IBEAM_CURSOR},
                                  std::pair{ImGuiMouseCursor_ResizeNS, GLFW_VRESIZE_CURSOR},
                                  std::pair{ImGuiMouseCursor_ResizeEW, GLFW_HRESIZE_CURSOR},
                                  std::pair{ImGuiMouseCursor_Hand, GLFW_HAND_CURSOR}};

} // namespace

struct Window::State {
    GLFWwindow* window = nullptr;
    std::vector<stage::Event> events; // events from the callbacks, for the loop
    stage::Surface surface;           // the last known state
    stage::Modifiers modifiers;       // the last known state: not every callback reports it
    std::string title;
    std::optional<std::array<int, 4>> windowed; // x, y, width and height before full screen
    std::map<ImGuiMouseCursor, GLFWcursor*> cursors;
    ImGuiMouseCursor cursor = ImGuiMouseCursor_Arrow;

    void happened(stage::Event event) { events.push_back(std::move(event)); }

    State() = default;
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    ~State() {
        for (const auto& [shape, made] : cursors)
            glfwDestroyCursor(made);
        if (window)
            glfwDestroyWindow(window);
        glfwTerminate();
    }
};

/// GLFW's callbacks.
struct Window::Callbacks {
    static State& stateOf(GLFWwindow* window) {
        return *static_cast<State*>(glfwGetWindowUserPointer(window));
    }
    static void install(GLFWwindow* window);
};

namespace {

/// GLFW names keys by their position on a US keyboard; shortcuts go by the printed character.
int printedKey(int key, int scancode) {
    if (key < GLFW_KEY_A || key > GLFW_KEY_Z)
        return key;
    const char* name = glfwGetKeyName(key, scancode);
    if (!name || name[0] == '\0' || name[1] != '\0' || !std::isalpha(static_cast<unsigned char>(name[0])))
        return key;
    return std::toupper(static_cast<unsigned char>(name[0]));
}

stage::Modifiers modifiersOf(int mods) {
    const auto has = [mods](int modifier) { return (mods & modifier) != 0; };
    return {has(GLFW_MOD_CONTROL), has(GLFW_MOD_SHIFT), has(GLFW_MOD_ALT), has(GLFW_MOD_SUPER)};
}

/// The left and right key of each modifier.
struct ModifierKeys {
    bool stage::Modifiers::*modifier;
    int left;
    int right;
};
constexpr std::array modifierKeys{
    ModifierKeys{&stage::Modifiers::control, GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL},
    ModifierKeys{&stage::Modifiers::shift, GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT},
    ModifierKeys{&stage::Modifiers::alt, GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT},
    ModifierKeys{&stage::Modifiers::super, GLFW_KEY_LEFT_SUPER, GLFW_KEY_RIGHT_SUPER}};

/// After a key event, which may be for a modifier itself: some systems report the modifiers from before it.
stage::Modifiers modifiersAfter(GLFWwindow* window, int key, int mods) {
    stage::Modifiers modifiers = modifiersOf(mods);
    for (const ModifierKeys& keys : modifierKeys) {
        if (key == keys.left || key == keys.right)
            modifiers.*keys.modifier =
                glfwGetKey(window, keys.left) == GLFW_PRESS || glfwGetKey(window, keys.right) == GLFW_PRESS;
    }
    return modifiers;
}

stage::KeyChanged::Kind kindOf(int action) {
    using Kind = stage::KeyChanged::Kind;
    return action == GLFW_RELEASE ? Kind::Release : action == GLFW_PRESS ? Kind::Press : Kind::Repeat;
}

stage::PointerMoved pointerAt(double x, double y) {
    return {static_cast<float>(x), static_cast<float>(y)};
}

} // namespace

void Window::Callbacks::install(GLFWwindow* window) {
    glfwSetWindowFocusCallback(window, [](GLFWwindow* w, int focused) {
        stateOf(w).happened(stage::FocusChanged{focused == GLFW_TRUE});
    });
    glfwSetCursorEnterCallback(window, [](GLFWwindow* w, int entered) {
        if (entered == GLFW_FALSE) // a pointer that enters also moves
            stateOf(w).happened(stage::PointerLeft{});
    });
    glfwSetCursorPosCallback(window,
                             [](GLFWwindow* w, double x, double y) { stateOf(w).happened(pointerAt(x, y)); });
    glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int mods) {
        stateOf(w).modifiers = modifiersOf(mods);
        stateOf(w).happened(stage::ButtonChanged{button, action == GLFW_PRESS, stateOf(w).modifiers});
    });
    glfwSetScrollCallback(window, [](GLFWwindow* w, double x, double y) {
        stateOf(w).happened(
            stage::WheelTurned{static_cast<float>(x), static_cast<float>(y), stateOf(w).modifiers});
    });
    glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int scancode, int action, int mods) {
        stateOf(w).modifiers = modifiersAfter(w, key, mods);
        stateOf(w).happened(
            stage::KeyChanged{kindOf(action), printedKey(key, scancode), stateOf(w).modifiers});
    });
    glfwSetCharCallback(window, [](GLFWwindow* w, unsigned character) {
        stateOf(w).happened(stage::TextEntered{character});
    });
    glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { stateOf(w).happened(stage::Refresh{}); });
    glfwSetWindowCloseCallback(window, [](GLFWwindow* w) {
        glfwSetWindowShouldClose(w, GLFW_FALSE); // the panels may have to ask first
        stateOf(w).happened(stage::CloseAsked{});
    });
    glfwSetDropCallback(window, [](GLFWwindow* w, int count, const char** paths) {
        stateOf(w).happened(stage::FilesDropped{{paths, paths + count}});
    });
}

Result<Window> Window::open(view::Size size, const std::string& title, ContextApi context) {
    render::setUpDriverCache();
    // EGL would assume that GLFW's display is of this kind. GLFW knows the kind, and Mesa crashes with a
    // wrong one.
    static_cast<void>(::unsetenv("EGL_PLATFORM")); // NOLINT(concurrency-mt-unsafe): no other thread runs yet
    glfwSetErrorCallback(rememberError);
    if (!glfwInit())
        return fail(ErrorCode::Driver, Sentence("no display can be opened ({0})", lastGlfwError));
    auto state = std::make_unique<State>();
    state->title = title;
    float scale = 1;
    if (GLFWmonitor* monitor = glfwGetPrimaryMonitor()) {
        int x = 0;
        int y = 0;
        int width = 0;
        int height = 0;
        glfwGetMonitorWorkarea(monitor, &x, &y, &width, &height);
        glfwGetMonitorContentScale(monitor, &scale, nullptr);
        if (width > 0 && height > 0) { // GLFW_SCALE_TO_MONITOR multiplies by the scale
            size.width = std::min(size.width, static_cast<int>(static_cast<float>(width) / scale));
            size.height = std::min(size.height, static_cast<int>(static_cast<float>(height) / scale));
        }
    }
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    if (context == ContextApi::Egl)
        glfwWindowHint(GLFW_CONTEXT_CREATION_API, GLFW_EGL_CONTEXT_API);
    const auto create = [&] {
        state->window = glfwCreateWindow(size.width, size.height, title.c_str(), nullptr, nullptr);
    };
    create();
    if (!state->window) { // drivers without the old features create no lower version
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 2);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
        create();
    }
    if (!state->window)
        return fail(ErrorCode::Driver, Sentence("no window with OpenGL{0} can be opened ({1})",
                                                context == ContextApi::Egl ? " by EGL" : "", lastGlfwError));
    glfwSetWindowSizeLimits(state->window, ui::minWindowSize.width, ui::minWindowSize.height, GLFW_DONT_CARE,
                            GLFW_DONT_CARE);
    glfwSetWindowUserPointer(state->window, state.get());
    glfwMakeContextCurrent(state->window);
    glfwSwapInterval(1);
    Callbacks::install(state->window);
    if (glfwGetWindowAttrib(state->window, GLFW_HOVERED) ==
        GLFW_TRUE) { // set before the callbacks were installed
        double x = 0;
        double y = 0;
        glfwGetCursorPos(state->window, &x, &y);
        state->happened(pointerAt(x, y));
    }
    Window window(std::move(state));
    window.state_->surface = window.surface();
    return window;
}

Window::Window(std::unique_ptr<State> state)
    : state_(std::move(state)) {}
Window::Window(Window&&) noexcept = default;
Window& Window::operator=(Window&&) noexcept = default;
Window::~Window() = default;

std::vector<stage::Event> Window::takeEvents() {
    if (const stage::Surface now = surface(); now != state_->surface) {
        state_->surface = now;
        state_->happened(stage::SurfaceChanged{now});
    }
    if (woken.exchange(false))
        state_->happened(stage::Refresh{});
    return std::exchange(state_->events, {});
}

void Window::wait() {
    glfwWaitEvents();
}

void Window::wait(double seconds) {
    if (seconds > 0)
        glfwWaitEventsTimeout(seconds);
    else
        glfwPollEvents();
}

void Window::wake() {
    woken = true;
    glfwPostEmptyEvent();
}

stage::Surface Window::surface() const {
    GLFWwindow* window = state_->window;
    stage::Surface surface;
    glfwGetWindowSize(window, &surface.size.width, &surface.size.height);
    glfwGetFramebufferSize(window, &surface.pixels.width, &surface.pixels.height);
    float scale = 1;
    glfwGetWindowContentScale(window, &scale, nullptr);
    surface.scale = scale > 0 ? scale : 1;
    surface.visible = glfwGetWindowAttrib(window, GLFW_ICONIFIED) == GLFW_FALSE;
    return surface;
}

void Window::whenDisplayIsLost(void (*action)()) {
    // Xlib would call exit(), possibly on a worker thread: that destroys objects that other threads, also
    // those of the driver, still use. The function is looked up by name because GLFW may be built without X11
    // or may load it itself.
    using Handler = int (*)(void* display);
    using SetHandler = Handler (*)(Handler);
    static void (*last)() = nullptr;
    last = action;
    void* xlib = ::dlopen("libX11.so.6", RTLD_LAZY | RTLD_NOLOAD);
    const auto set = xlib ? reinterpret_cast<SetHandler>(::dlsym(xlib, "XSetIOErrorHandler")) : nullptr;
    if (set)
        set([](void* /*display*/) -> int {
            last();
            std::_Exit(EXIT_FAILURE);
        });
}

double Window::frameSeconds() const {
    const GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    const GLFWvidmode* mode = monitor ? glfwGetVideoMode(const_cast<GLFWmonitor*>(monitor)) : nullptr;
    return 1 / std::max(minRefreshRate, mode ? static_cast<double>(mode->refreshRate) : 0);
}

namespace {

/// The monitor that contains the largest part of a rectangle; nullptr if there is none.
GLFWmonitor* monitorOf(const std::array<int, 4>& place) {
    int count = 0;
    GLFWmonitor** monitors = glfwGetMonitors(&count);
    GLFWmonitor* best = nullptr;
    long long most = -1;
    for (int i = 0; i < count; ++i) {
        int x = 0;
        int y = 0;
        glfwGetMonitorPos(monitors[i], &x, &y);
        const GLFWvidmode* mode = glfwGetVideoMode(monitors[i]);
        if (!mode)
            continue;
        const auto shared = [](int from, int length, int otherFrom, int otherLength) {
            return std::max(0, std::min(from + length, otherFrom + otherLength) - std::max(from, otherFrom));
        };
        const long long area = static_cast<long long>(shared(place[0], place[2], x, mode->width)) *
                               shared(place[1], place[3], y, mode->height);
        if (area > most) {
            most = area;
            best = monitors[i];
        }
    }
    return best;
}

} // namespace

void Window::fillScreen(bool fills) {
    if (fills == state_->windowed.has_value())
        return;
    GLFWwindow* window = state_->window;
    if (!fills) {
        const auto [x, y, width, height] = *std::exchange(state_->windowed, std::nullopt);
        glfwSetWindowMonitor(window, nullptr, x, y, width, height, GLFW_DONT_CARE);
        return;
    }
    std::array<int, 4> place{};
    glfwGetWindowPos(window, place.data(), &place[1]);
    glfwGetWindowSize(window, &place[2], &place[3]);
    GLFWmonitor* monitor = monitorOf(place);
    const GLFWvidmode* mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
    if (!mode)
        return;
    state_->windowed = place;
    glfwSetWindowMonitor(window, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
    glfwSwapInterval(1); // some drivers reset it
}

void Window::setTitle(const std::string& title) {
    if (title == state_->title)
        return;
    state_->title = title;
    glfwSetWindowTitle(state_->window, title.c_str());
}

void Window::setCursor(ImGuiMouseCursor cursor) {
    if (cursor == state_->cursor)
        return;
    state_->cursor = cursor;
    const auto* shape = std::ranges::find(cursorShapes, cursor, [](const auto& each) { return each.first; });
    GLFWcursor* made = nullptr; // an arrow
    if (shape != cursorShapes.end()) {
        GLFWcursor*& kept = state_->cursors[cursor];
        if (!kept)
            kept = glfwCreateStandardCursor(shape->second);
        made = kept;
    }
    glfwSetCursor(state_->window, made);
}

std::string Window::clipboard() const {
    const char* text = glfwGetClipboardString(state_->window);
    return text ? text : "";
}

void Window::setClipboard(const std::string& text) {
    glfwSetClipboardString(state_->window, text.c_str());
}

void Window::swap() {
    glfwSwapBuffers(state_->window);
}

} // namespace texplorer::explorer

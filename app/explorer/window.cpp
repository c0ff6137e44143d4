#include "app/explorer/window.h"

#include "app/render/driver_cache.h"
#include "app/ui/widgets/input_queue.h"
#include "app/ui/window/smallest_window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <imgui.h>

#include <algorithm>
#include <atomic>
#include <cctype>
#include <deque>
#include <utility>

namespace texplorer::explorer {
namespace {

std::string lastGlfwError;
std::atomic<bool> woken = false; // by any thread, for the one window

void rememberError(int /*code*/, const char* description) {
    lastGlfwError = description;
}

constexpr double slowestMonitor = 60; // hertz; virtual displays report less, or nothing

/// What the callbacks leave for the loop.
struct Inbox {
    Window::Events events;
    std::deque<ui::KeyEvent> keys;
};

} // namespace

struct Window::State {
    GLFWwindow* window = nullptr;
    Inbox inbox;
    std::string title;

    ~State() {
        if (window)
            glfwDestroyWindow(window);
        glfwTerminate();
    }
};

namespace {

Inbox& inboxOf(GLFWwindow* window) {
    return *static_cast<Inbox*>(glfwGetWindowUserPointer(window));
}

/// The window's events, marked: something has happened.
Window::Events& happened(GLFWwindow* window) {
    Window::Events& events = inboxOf(window).events;
    events.any = true;
    return events;
}

/// GLFW names keys by their place on an American keyboard; shortcuts are meant by what is printed on them.
int printedKey(int key, int scancode) {
    if (key < GLFW_KEY_A || key > GLFW_KEY_Z)
        return key;
    const char* name = glfwGetKeyName(key, scancode);
    if (!name || name[0] == '\0' || name[1] != '\0' || !std::isalpha(static_cast<unsigned char>(name[0])))
        return key;
    return std::toupper(static_cast<unsigned char>(name[0]));
}

void installCallbacks(GLFWwindow* window) {
    glfwSetWindowFocusCallback(window, [](GLFWwindow* w, int focused) {
        happened(w);
        ImGui_ImplGlfw_WindowFocusCallback(w, focused);
    });
    glfwSetCursorEnterCallback(window, [](GLFWwindow* w, int entered) {
        happened(w);
        ImGui_ImplGlfw_CursorEnterCallback(w, entered);
    });
    glfwSetCursorPosCallback(window, [](GLFWwindow* w, double, double) {
        happened(w);
        // The pointer may have been inside before anyone listened for its entering.
        ImGui_ImplGlfw_CursorEnterCallback(w, GLFW_TRUE);
    });
    glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int mods) {
        happened(w);
        ImGui_ImplGlfw_MouseButtonCallback(w, button, action, mods);
    });
    glfwSetScrollCallback(window, [](GLFWwindow* w, double x, double y) {
        happened(w);
        ImGui_ImplGlfw_ScrollCallback(w, x, y);
    });
    glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int scancode, int action, int) {
        using Kind = ui::KeyEvent::Kind;
        const Kind kind = action == GLFW_RELEASE ? Kind::Release
                          : action == GLFW_PRESS ? Kind::Press
                                                 : Kind::Repeat;
        happened(w);
        inboxOf(w).keys.push_back({kind, printedKey(key, scancode), scancode});
    });
    glfwSetCharCallback(window, [](GLFWwindow* w, unsigned codepoint) {
        happened(w);
        inboxOf(w).keys.push_back({ui::KeyEvent::Kind::Character, static_cast<int>(codepoint)});
    });
    glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { happened(w); });
    glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { happened(w); });
    glfwSetWindowIconifyCallback(window, [](GLFWwindow* w, int) { happened(w); });
    glfwSetWindowContentScaleCallback(window,
                                      [](GLFWwindow* w, float, float) { happened(w).scaleChanged = true; });
    glfwSetWindowCloseCallback(window, [](GLFWwindow* w) {
        glfwSetWindowShouldClose(w, GLFW_FALSE); // the panels may have to ask first
        happened(w).close = true;
    });
    glfwSetDropCallback(window, [](GLFWwindow* w, int count, const char** paths) {
        Window::Events& events = happened(w);
        events.dropped.insert(events.dropped.end(), paths, paths + count);
    });
}

} // namespace

Result<Window> Window::open(view::Size size, const std::string& title) {
    render::setUpDriverCache();
    glfwSetErrorCallback(rememberError);
    if (!glfwInit())
        return fail(ErrorCode::Driver, "no display can be opened (" + lastGlfwError + ")");
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
    state->window = glfwCreateWindow(size.width, size.height, title.c_str(), nullptr, nullptr);
    if (!state->window)
        return fail(ErrorCode::Driver, "no window with OpenGL can be opened (" + lastGlfwError + ")");
    glfwSetWindowSizeLimits(state->window, ui::smallestWindow.width, ui::smallestWindow.height,
                            GLFW_DONT_CARE, GLFW_DONT_CARE);
    glfwSetWindowUserPointer(state->window, &state->inbox);
    glfwMakeContextCurrent(state->window);
    glfwSwapInterval(1);
    installCallbacks(state->window);
    return Window(std::move(state));
}

Window::Window(std::unique_ptr<State> state)
    : state_(std::move(state)) {}
Window::Window(Window&&) noexcept = default;
Window& Window::operator=(Window&&) noexcept = default;
Window::~Window() = default;

GLFWwindow* Window::handle() const {
    return state_->window;
}

Window::Events Window::takeEvents() {
    Events events = std::exchange(state_->inbox.events, {});
    events.any |= woken.exchange(false);
    return events;
}

bool Window::feedKeys() {
    using Kind = ui::KeyEvent::Kind;
    std::deque<ui::KeyEvent>& keys = state_->inbox.keys;
    const ImGuiIO& io = ImGui::GetIO();
    for (std::size_t left = ui::eventsForOneFrame(keys, io.WantTextInput && !io.KeyCtrl); left > 0; --left) {
        const ui::KeyEvent event = keys.front();
        keys.pop_front();
        if (event.kind == Kind::Character)
            ImGui_ImplGlfw_CharCallback(state_->window, static_cast<unsigned>(event.code));
        else
            ImGui_ImplGlfw_KeyCallback(state_->window, event.code, event.scancode,
                                       event.kind == Kind::Release ? GLFW_RELEASE
                                       : event.kind == Kind::Press ? GLFW_PRESS
                                                                   : GLFW_REPEAT,
                                       0);
    }
    return !keys.empty();
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
    woken = true; // something is new: Dear ImGui needs some frames for that, too
    glfwPostEmptyEvent();
}

bool Window::isHidden() const {
    const view::Size pixels = framebuffer();
    return glfwGetWindowAttrib(state_->window, GLFW_ICONIFIED) == GLFW_TRUE || pixels.width < 1 ||
           pixels.height < 1;
}

view::Size Window::size() const {
    view::Size size;
    glfwGetWindowSize(state_->window, &size.width, &size.height);
    return size;
}

view::Size Window::framebuffer() const {
    view::Size size;
    glfwGetFramebufferSize(state_->window, &size.width, &size.height);
    return size;
}

float Window::contentScale() const {
    float scale = 1;
    glfwGetWindowContentScale(state_->window, &scale, nullptr);
    return scale > 0 ? scale : 1;
}

double Window::frameSeconds() const {
    const GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    const GLFWvidmode* mode = monitor ? glfwGetVideoMode(const_cast<GLFWmonitor*>(monitor)) : nullptr;
    return 1 / std::max(slowestMonitor, mode ? static_cast<double>(mode->refreshRate) : 0);
}

double Window::now() const {
    return glfwGetTime();
}

void Window::setTitle(const std::string& title) {
    if (title == state_->title)
        return;
    state_->title = title;
    glfwSetWindowTitle(state_->window, title.c_str());
}

void Window::swap() {
    glfwSwapBuffers(state_->window);
}

} // namespace texplorer::explorer

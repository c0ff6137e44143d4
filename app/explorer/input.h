#pragma once

struct GLFWwindow;

namespace texplorer::explorer {

/// Dear ImGui's GLFW backend: mouse, keyboard, clipboard and cursors of a window. The ImGui context must
/// exist, and outlive it.
class Input {
public:
    explicit Input(GLFWwindow* window);
    ~Input();
    Input(const Input&) = delete;
    Input& operator=(const Input&) = delete;

    /// Right before ImGui::NewFrame.
    static void feed();
};

} // namespace texplorer::explorer

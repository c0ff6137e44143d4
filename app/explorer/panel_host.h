#pragma once

struct GLFWwindow;

namespace texplorer::explorer {

/// Dear ImGui with its GLFW and OpenGL2 backends, for a window whose context is current.
class PanelHost {
public:
    PanelHost(GLFWwindow* window, float scale);
    ~PanelHost();
    PanelHost(const PanelHost&) = delete;
    PanelHost& operator=(const PanelHost&) = delete;

    /// Between two frames: fonts and metrics for another content scale.
    void setScale(float scale);

    void beginFrame();
    /// Draws what the panels have collected since `beginFrame` into the window's framebuffer.
    void endFrame(int width, int height);
};

} // namespace texplorer::explorer

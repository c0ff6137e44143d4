#include "app/explorer/input.h"

#include <backends/imgui_impl_glfw.h>

namespace texplorer::explorer {

Input::Input(GLFWwindow* window) {
    ImGui_ImplGlfw_InitForOpenGL(window, false); // the window's callbacks call the backend's
}

Input::~Input() {
    ImGui_ImplGlfw_Shutdown();
}

void Input::feed() {
    ImGui_ImplGlfw_NewFrame();
}

} // namespace texplorer::explorer

#include "app/explorer/panel_host.h"

#include "app/ui/theme.h"

#include <GL/glew.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl2.h>
#include <imgui.h>

namespace texplorer::explorer {

PanelHost::PanelHost(GLFWwindow* window, float scale) {
    ImGui::CreateContext();
    ui::applyTheme(scale);
    ImGui_ImplGlfw_InitForOpenGL(window, false); // the window's callbacks call the backend's
    ImGui_ImplOpenGL2_Init();
}

PanelHost::~PanelHost() {
    ImGui_ImplOpenGL2_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

void PanelHost::setScale(float scale) {
    ImGui_ImplOpenGL2_DestroyFontsTexture();
    ui::applyTheme(scale);
    ImGui_ImplOpenGL2_CreateFontsTexture();
}

void PanelHost::beginFrame() {
    ImGui_ImplOpenGL2_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
}

void PanelHost::endFrame(int width, int height) {
    ImGui::Render();
    glViewport(0, 0, width, height);
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL2_RenderDrawData(ImGui::GetDrawData());
}

} // namespace texplorer::explorer

#pragma once

#include "app/ui/model/view_frame.h"
#include "app/view/pass_shader.h"
#include "core/image/image.h"

#include <imgui.h>

#include <functional>
#include <memory>
#include <span>
#include <string>

namespace texplorer::ui {

/// The GL textures that the panels show. The panels make no GL call themselves.
struct Pictures {
    std::span<const ViewFrame> frames;          ///< of shownRenderers, at Layout::picture's size; never empty
    const ViewDifference* difference = nullptr; ///< of those that are compared; nullptr: not known
    std::span<const std::string> problems = {}; ///< sentences: what the renderers said
    /// Of each pass, where WindowState::shownTab asks for them or shaders draw; nullptr: there is none.
    std::span<const std::shared_ptr<const view::PassShader>> shaders = {};
    unsigned texture = 0; ///< the base level of boundTexture(session), nearest filtering; 0: none
    /// Switches blending off, or back on where ImDrawCmd::UserCallbackData isn't null: a picture's alpha must
    /// not let the window shine through. (ImDrawCallback_ResetRenderState won't do: the OpenGL2 backend of
    /// Dear ImGui 1.86 pushes its matrices once more with each.)
    ImDrawCallback setBlending = nullptr;
    /// A GL texture that shows an image with its alpha, valid until the end of the frame; 0: none can be had.
    std::function<unsigned(const std::shared_ptr<const Image>& image)> textureOf = {};
};

} // namespace texplorer::ui

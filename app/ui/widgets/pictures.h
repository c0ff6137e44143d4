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

/// The pictures that the panels show. They make no GL call themselves.
struct Pictures {
    std::span<const ViewFrame> frames;          ///< of shownRenderers, at Layout::picture's size; never empty
    const ViewDifference* difference = nullptr; ///< of those that are compared; nullptr: not known
    std::span<const std::string> problems = {}; ///< sentences: what the renderers said
    /// Of each pass, where the tab GLSL is shown or shaders draw; nullptr: there is none.
    std::span<const std::shared_ptr<const view::PassShader>> shaders = {};
    /// The base level of boundTexture(session), nearest filtering.
    view::PictureHandle texture = view::PictureHandle::None;
    /// Switches blending off, or back on where ImDrawCmd::UserCallbackData isn't null: a picture's alpha must
    /// not let the window shine through. (ImDrawCallback_ResetRenderState won't do: the OpenGL2 backend of
    /// Dear ImGui 1.86 pushes its matrices once more with each.)
    ImDrawCallback setBlending = nullptr;
    /// Keeps a picture of an image with its alpha until the end of the frame. Empty: there is no place for
    /// any.
    std::function<view::PictureHandle(const std::shared_ptr<const Image>& image)> keep = {};
    /// The same of what is shown so large that one sees its texels: nearest filtering. An image is kept in
    /// one of the two ways.
    std::function<view::PictureHandle(const std::shared_ptr<const Image>& image)> keepTexels = {};

    [[nodiscard]] view::PictureHandle show(const std::shared_ptr<const Image>& image) const {
        return keep ? keep(image) : view::PictureHandle::None;
    }
    [[nodiscard]] view::PictureHandle showTexels(const std::shared_ptr<const Image>& image) const {
        return keepTexels ? keepTexels(image) : view::PictureHandle::None;
    }
};

/// As Dear ImGui passes it on to the host's backend.
[[nodiscard]] inline ImTextureID textureId(view::PictureHandle picture) {
    return reinterpret_cast<ImTextureID>( // NOLINT(performance-no-int-to-ptr): it is no pointer
        static_cast<std::uintptr_t>(picture));
}

} // namespace texplorer::ui

#pragma once

#include "app/ui/state/view_frame.h"
#include "app/view/pass_shader.h"
#include "texplorer/base/sentence.h"
#include "texplorer/image/image.h"

#include <imgui.h>

#include <functional>
#include <memory>
#include <span>

namespace texplorer::ui {

/// The pictures that the panels show. Panels do not call GL themselves.
struct Pictures {
    std::span<const ViewFrame>
        frames; ///< in the order of shownRenderers, with Layout::picture's size; never empty
    const ViewDifference* difference = nullptr; ///< of the compared ones; nullptr: not known
    std::span<const Sentence> problems = {};    ///< the renderers' problems
    /// One per pass, if the tab GLSL is shown or shaders draw; nullptr: none.
    std::span<const std::shared_ptr<const view::PassShader>> shaders = {};
    /// The base level of boundTexture(session), nearest filtering.
    view::PictureHandle texture = view::PictureHandle::None;
    /// Switches blending off, or on again if ImDrawCmd::UserCallbackData is not null: a picture's alpha must
    /// not let the window show through. (ImDrawCallback_ResetRenderState does not work: with each, the
    /// OpenGL2 backend of Dear ImGui 1.86 pushes its matrices once more.)
    ImDrawCallback setBlending = nullptr;
    /// Makes a picture of an image with its alpha, valid until the end of the frame. Empty: not supported.
    std::function<view::PictureHandle(const std::shared_ptr<const Image>& image)> keep = {};
    /// The same for pictures that are enlarged to show their texels: nearest filtering. Use an image always
    /// in the same way.
    std::function<view::PictureHandle(const std::shared_ptr<const Image>& image)> keepTexels = {};

    [[nodiscard]] view::PictureHandle show(const std::shared_ptr<const Image>& image) const {
        return keep ? keep(image) : view::PictureHandle::None;
    }
    [[nodiscard]] view::PictureHandle showTexels(const std::shared_ptr<const Image>& image) const {
        return keepTexels ? keepTexels(image) : view::PictureHandle::None;
    }
};

/// The type that Dear ImGui passes to the host's backend.
[[nodiscard]] inline ImTextureID textureId(view::PictureHandle picture) {
    return reinterpret_cast<ImTextureID>( // NOLINT(performance-no-int-to-ptr): it is no pointer
        static_cast<std::uintptr_t>(picture));
}

/// Draws a small picture of an image, if the host makes one.
inline void drawImage(const Pictures& pictures, const std::shared_ptr<const Image>& image, ImVec2 low,
                      ImVec2 high, ImU32 tint = IM_COL32_WHITE) {
    if (const view::PictureHandle picture = pictures.show(image); picture != view::PictureHandle::None)
        ImGui::GetWindowDrawList()->AddImage(textureId(picture), low, high, {0, 1}, {1, 0},
                                             tint); // row 0 is the bottom one
}

/// The same in the middle of a room: `scale` pixels for each of the image's.
inline void drawImageIn(const Pictures& pictures, const std::shared_ptr<const Image>& image, ImVec2 low,
                        ImVec2 room, float scale, ImU32 tint = IM_COL32_WHITE) {
    const ImVec2 size(static_cast<float>(image->width) * scale, static_cast<float>(image->height) * scale);
    const ImVec2 at(low.x + (room.x - size.x) / 2, low.y + (room.y - size.y) / 2);
    drawImage(pictures, image, at, {at.x + size.x, at.y + size.y}, tint);
}

} // namespace texplorer::ui

#pragma once

#include "app/view/capabilities.h"
#include "app/view/frame.h"
#include "app/ui/window/layout.h"
#include "app/ui/view/rendered_view.h"
#include "app/ui/model/session.h"

#include <imgui.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace texplorer::ui {

/// The GL textures that the panels show. The workbench makes no GL call itself.
struct Pictures {
    std::span<const RenderedView> views; ///< of shownRenderers, at Layout::picture's size; never empty
    const RenderedDifference* difference = nullptr; ///< of those that are compared; nullptr: not known
    std::span<const std::string> problems = {};     ///< sentences: what the renderers said
    /// Of each pass, where Session::shownTab asks for them or shaders draw; nullptr: there is none.
    std::span<const std::shared_ptr<const view::PassShader>> shaders = {};
    unsigned texture = 0; ///< the base level of boundTexture(session), nearest filtering; 0: none
    /// Switches blending off, or back on where ImDrawCmd::UserCallbackData isn't null: a picture's alpha must
    /// not let the window shine through. (ImDrawCallback_ResetRenderState won't do: the OpenGL2 backend of
    /// Dear ImGui 1.86 pushes its matrices once more with each.)
    ImDrawCallback setBlending = nullptr;
    /// A GL texture that shows an image with its alpha, valid until the end of the frame; 0: none can be had.
    std::function<unsigned(const std::shared_ptr<const Image>& image)> textureOf = {};
};

/// What the window asks of its host.
struct Requests {
    bool quit = false;
    bool fading = false;     ///< the next frame differs without any input: the window darkens behind a dialog
    bool unfinished = false; ///< textures are still being uploaded: the next frame differs, too
    std::string title;
};

/// Draws the whole window between ImGui::NewFrame and ImGui::Render; edits the session as the user says. A
/// frame is:
///   layout = layoutFor(…, session.columns, gridOf(session.views)); settle(session, layout); frame =
///   renderer.draw(session.scene, …); ImGui::NewFrame(); drawWorkbench(…); ImGui::Render().
/// Dear ImGui needs two or three frames until new windows have their sizes.
Requests drawWorkbench(Session& session, const Pictures& pictures, const view::Capabilities& capabilities,
                       const Layout& layout);

/// The user wants to close the window: asks first where something would be lost.
void requestQuit(Session& session);

/// Files were dropped onto the window: a scene, images. Asks first where a scene would replace unsaved
/// changes.
void requestOpen(Session& session, std::vector<std::filesystem::path> files);

} // namespace texplorer::ui

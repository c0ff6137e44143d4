#pragma once

#include "app/ui/details/details_panel.h"
#include "app/ui/parameters/parameters_panel.h"
#include "app/ui/texture_space/texture_space_panel.h"
#include "app/ui/window/dialogs.h"
#include "app/ui/window/window_parts.h"

#include <string>

namespace texplorer::ui {

/// The state of each panel; Dear ImGui's context has their scroll positions.
struct PanelStates {
    ParametersState parameters;
    TextureSpaceState textureSpace;
    DetailsState details;
    DialogsState dialogs;
    KeyboardFocus keyboard;
    std::size_t documents = 0; ///< Session::documents when they were last drawn
    float textWheel = 0;       ///< see resizeTextByWheel
    bool hadPopup = false;     ///< a menu or list was open at the end of the last frame
};

/// The window's requests to its host.
struct Requests {
    bool quit = false;
    bool fading = false; ///< the next frame differs even without input: the window darkens behind a dialog
    bool unfinished = false; ///< textures, letters or answers are pending: the next frame differs as well
    std::string title;
};

/// Draws the whole window between ImGui::NewFrame and ImGui::Render, after `settle` and the renderers; edits
/// the session as the user says. Dear ImGui needs two or three frames until new windows have their sizes.
Requests drawWorkbench(Session& session, PanelStates& states, const Pictures& pictures,
                       const view::Capabilities& capabilities, const Layout& layout);

} // namespace texplorer::ui

#pragma once

#include "app/ui/view/show.h"
#include "app/ui/window/workbench.h"

namespace texplorer::ui {

// The parts of the window, one file each. All are called between ImGui::NewFrame and ImGui::Render.

void drawMenuBar(Session& session, const Layout& layout);
/// Who draws the picture, in the menu bar; nothing where `available` is too narrow.
void drawRendererChoice(Session& session, float available);
void drawPlaybackControls(Session& session);
[[nodiscard]] float leastPlaybackWidth(); ///< they are left out of a bar with less room
void drawParametersPanel(Session& session, const Layout& layout);
void textureSection(Session& session); ///< the texture that is bound to the selected unit
/// That the selected unit shares its texture, with a way to give it its own; nothing where it doesn't. `id`
/// tells two such notes apart.
void sharingNote(Session& session, const char* id);
/// "unit 0, unit 2 of pass 1": units that are on and show the texture of a unit of the selected pass.
[[nodiscard]] std::string sharersText(const Session& session, int unit);
void combineSection(Session& session);     ///< of the selected unit, whose mode is GL_COMBINE
void coordinatesSection(Session& session); ///< generated ones, of the selected unit
void drawViewPanel(Session& session, const Pictures& pictures, const Layout& layout);
void drawTextureSpacePanel(Session& session, const Pictures& pictures, const Layout& layout);
void drawDetailsPanel(Session& session, const Pictures& pictures, const Layout& layout); ///< the tabs
/// A list of the scene's models; there must be one.
void modelChoice(Session& session, float width);
void drawVerticesTab(Session& session);
void drawCommandsTab(Session& session);
void drawGlslTab(Session& session, const Pictures& pictures);
void drawExplainTab(Session& session, const Pictures& pictures);
void drawFileTab(Session& session);
void drawMemoryTab(Session& session, const Pictures& pictures);
void drawStatusBar(Session& session, const Pictures& pictures, const view::Capabilities& capabilities,
                   const Layout& layout);
void drawDialogs(Session& session, const Pictures& pictures);
void drawRestore(Session& session, const Pictures& pictures); ///< a dialog; there must be an offer
void handleShortcuts(Session& session, const Layout& layout);

/// A window that fills a rectangle and can't be moved. To be closed with ImGui::End().
void beginPanel(const char* name, const Rect& rect, ImGuiWindowFlags flags = 0);

// What menus, keys and buttons share.
void askOpenScene(Session& session);
void askOpenImage(Session& session);
void askNewScene(Session& session);
void save(Session& session);
void askSaveAs(Session& session);

/// The camera as it was at the start, fitted to the view.
void resetCamera(Session& session, const Layout& layout);
void frameAll(Session& session, const Layout& layout);
void show(Session& session, const ShowRow& row, const Layout& layout); ///< selects what is shown, too

} // namespace texplorer::ui

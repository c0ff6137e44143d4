#include "app/ui/window/workbench.h"

#include "app/ui/model/findings.h"
#include "app/ui/model/unsaved_work.h"
#include "app/ui/parameters/parameters_panel.h"
#include "app/ui/view/view_panel.h"
#include "app/ui/widgets/panel.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_places.h"
#include "app/ui/window/menu_bar.h"
#include "app/ui/window/shortcuts.h"
#include "app/ui/window/status_bar.h"
#include "app/view/driver_facts.h"

#include <imgui_internal.h> // how far the darkening behind a dialog has got

#include <algorithm>
#include <utility>

namespace texplorer::ui {
namespace {

/// A strip between two panels that one drags. Returns the mouse's way since the last frame, along its axis.
float seam(const char* name, const Rect& rect, bool vertical) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, ImGui::GetStyleColorVec4(ImGuiCol_MenuBarBg));
    beginPanel(name, rect, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    float moved = 0;
    if (rect.width > 0 && rect.height > 0) {
        ImGui::InvisibleButton("grip", {static_cast<float>(rect.width), static_cast<float>(rect.height)});
        noteItem(name);
        if (ImGui::IsItemHovered() || ImGui::IsItemActive()) {
            ImGui::SetMouseCursor(vertical ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
            ImGui::GetWindowDrawList()->AddRectFilled(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(),
                                                      ImGui::GetColorU32(ImGuiCol_SeparatorHovered));
        }
        if (ImGui::IsItemActive())
            moved = vertical ? ImGui::GetIO().MouseDelta.x : ImGui::GetIO().MouseDelta.y;
    }
    ImGui::End();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
    return moved;
}

bool isPopupOpen() {
    return ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
}

void drawSeams(Session& session, const Layout& layout) {
    const float left = seam("left seam", layout.leftSeam, true);
    const float right = seam("right seam", layout.rightSeam, true);
    const float middle = seam("middle seam", layout.middleSeam, false);
    const float least = 1;
    if (left != 0)
        session.window.columns.parameters =
            std::max(least, (static_cast<float>(layout.parameters.width) + left) / layout.scale);
    if (right != 0)
        session.window.columns.details =
            std::max(least, (static_cast<float>(layout.texture.width) - right) / layout.scale);
    if (middle != 0) {
        const float whole = static_cast<float>(std::max(1, layout.texture.height + layout.details.height));
        session.window.columns.split =
            std::clamp((static_cast<float>(layout.texture.height) + middle) / whole, 0.15F, 0.85F);
    }
}

/// What can be drawn: where only the reference draws, it is not for the driver to say.
DriverFacts factsFor(const Session& session, const view::Capabilities& capabilities) {
    const std::vector<RendererKind> shown = shownRenderers(session.window.view);
    const bool asksGl =
        std::ranges::any_of(shown, [](RendererKind renderer) { return renderer != RendererKind::Reference; });
    return asksGl || shown.empty() ? view::driverFacts(capabilities) : DriverFacts{};
}

} // namespace

Requests drawWorkbench(Session& session, PanelStates& states, const Pictures& pictures,
                       const view::Capabilities& capabilities, const Layout& layout) {
    forgetPlaces();
    const bool popup = isPopupOpen(); // a key that ends it is not a shortcut as well
    drawMenuBar(session, layout);
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Left))
        session.window.shownParam.clear();
    diagnoseSession(session, factsFor(session, capabilities));
    settle(session, layout); // an edit may have taken away what is selected
    askAboutPicture(session, pictures.frames.front().frame.size);
    drawParametersPanel(session, layout, pictures);
    settle(session, layout);
    drawViewPanel(session, pictures, layout);
    drawTextureSpacePanel(session, states.textureSpace, pictures, layout);
    drawDetailsPanel(session, states.details, pictures, layout);
    drawStatusBar(session, pictures, capabilities, layout);
    drawSeams(session, layout);
    if (!popup)
        handleShortcuts(session, layout); // after the panels: a key may come with the mouse's release
    drawDialogs(session, states.dialogs, pictures);
    if (const std::optional<Fix> fix = std::exchange(session.window.wantedFix, std::nullopt))
        applyFix(session, *fix);
    followEdits(session);
    const float dimmed = ImGui::GetCurrentContext()->DimBgRatio;
    const bool fading = dimmed > 0 && dimmed < 1;
    Requests requests{session.window.quitConfirmed, fading, false, windowTitle(session.document)};
    session.window.quitConfirmed = false;
    // Arrows, Enter and Escape work in an open menu or list. Elsewhere Space plays, and dialogs have their
    // own keys.
    ImGuiIO& io = ImGui::GetIO();
    const bool navigates = session.window.dialog == Dialog::None && isPopupOpen();
    io.ConfigFlags = navigates ? io.ConfigFlags | ImGuiConfigFlags_NavEnableKeyboard
                               : io.ConfigFlags & ~ImGuiConfigFlags_NavEnableKeyboard;
    return requests;
}

} // namespace texplorer::ui

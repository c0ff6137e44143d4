#include "app/ui/window/workbench.h"

#include "app/view/driver_facts.h"
#include "app/ui/model/findings.h"
#include "app/ui/window/panels.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/view/probed_pixel.h"
#include "app/ui/widgets/theme.h"

#include <imgui_internal.h> // how far the darkening behind a dialog has got

#include <algorithm>

namespace texplorer::ui {
namespace {

/// A strip between two panels that one drags. Returns the mouse's way since the last frame, along its axis.
float seam(Session& session, const char* name, const Rect& rect, bool vertical) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, ImGui::GetStyleColorVec4(ImGuiCol_MenuBarBg));
    beginPanel(name, rect, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    float moved = 0;
    if (rect.width > 0 && rect.height > 0) {
        ImGui::InvisibleButton("grip", {static_cast<float>(rect.width), static_cast<float>(rect.height)});
        noteItem(session, name);
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
    const float left = seam(session, "left seam", layout.leftSeam, true);
    const float right = seam(session, "right seam", layout.rightSeam, true);
    const float middle = seam(session, "middle seam", layout.middleSeam, false);
    const float least = 1;
    if (left != 0)
        session.columns.parameters =
            std::max(least, (static_cast<float>(layout.parameters.width) + left) / layout.scale);
    if (right != 0)
        session.columns.details =
            std::max(least, (static_cast<float>(layout.texture.width) - right) / layout.scale);
    if (middle != 0) {
        const float whole = static_cast<float>(std::max(1, layout.texture.height + layout.details.height));
        session.columns.split =
            std::clamp((static_cast<float>(layout.texture.height) + middle) / whole, 0.15F, 0.85F);
    }
}

/// What can be drawn: where only the reference draws, it is not for the driver to say.
DriverFacts factsFor(const Session& session, const view::Capabilities& capabilities) {
    const std::vector<RendererKind> shown = shownRenderers(session.views);
    const bool asksGl =
        std::ranges::any_of(shown, [](RendererKind renderer) { return renderer != RendererKind::Reference; });
    return asksGl || shown.empty() ? view::driverFacts(capabilities) : DriverFacts{};
}

} // namespace

void beginPanel(const char* name, const Rect& rect, ImGuiWindowFlags flags) {
    ImGui::SetNextWindowPos({static_cast<float>(rect.x), static_cast<float>(rect.y)});
    ImGui::SetNextWindowSize({static_cast<float>(rect.width), static_cast<float>(rect.height)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
    ImGui::Begin(name, nullptr,
                 flags | ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    ImGui::PopStyleVar();
}

Requests drawWorkbench(Session& session, const Pictures& pictures, const view::Capabilities& capabilities,
                       const Layout& layout) {
    if (session.probe)
        session.probe->items.clear();
    const bool popup = isPopupOpen(); // a key that ends it is not a shortcut as well
    drawMenuBar(session, layout);
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Left))
        session.shownParam.clear();
    diagnoseSession(session, factsFor(session, capabilities));
    settle(session, layout); // an edit may have taken away what is selected
    askAboutPicture(session, pictures);
    drawParametersPanel(session, layout);
    settle(session, layout);
    drawViewPanel(session, pictures, layout);
    drawTextureSpacePanel(session, pictures, layout);
    drawDetailsPanel(session, pictures, layout);
    drawStatusBar(session, pictures, capabilities, layout);
    drawSeams(session, layout);
    if (!popup)
        handleShortcuts(session, layout); // after the panels: a key may come with the mouse's release
    drawDialogs(session, pictures);
    followEdits(session);
    const float dimmed = ImGui::GetCurrentContext()->DimBgRatio;
    const bool fading = dimmed > 0 && dimmed < 1;
    Requests requests{session.quitConfirmed, fading, false, windowTitle(session)};
    session.quitConfirmed = false;
    // Arrows, Enter and Escape work in an open menu or list. Elsewhere Space plays, and dialogs have their
    // own keys.
    ImGuiIO& io = ImGui::GetIO();
    const bool navigates = session.dialog == Dialog::None && isPopupOpen();
    io.ConfigFlags = navigates ? io.ConfigFlags | ImGuiConfigFlags_NavEnableKeyboard
                               : io.ConfigFlags & ~ImGuiConfigFlags_NavEnableKeyboard;
    return requests;
}

} // namespace texplorer::ui

#include "app/ui/window/workbench.h"

#include "app/ui/editor/editor.h"
#include "app/ui/files/inspected_file.h"
#include "app/ui/files/lessons.h"
#include "app/ui/files/unsaved_work.h"
#include "app/ui/model/explaining.h"
#include "app/ui/model/findings.h"
#include "app/ui/model/level_edits.h"
#include "app/ui/model/level_view.h"
#include "app/ui/model/preview.h"
#include "app/ui/model/table_colors.h"
#include "app/ui/model/timeline_edits.h"
#include "app/ui/view/view_panel.h"
#include "app/ui/widgets/keys.h"
#include "app/ui/widgets/panel.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_places.h"
#include "app/ui/window/notes.h"
#include "app/ui/window/shortcuts.h"
#include "app/ui/window/text_size.h"
#include "app/view/driver_facts.h"

#include <imgui_internal.h> // the progress of the darkening behind a dialog

#include <algorithm>
#include <array>
#include <utility>

namespace texplorer::ui {
namespace {

/// A seam between two panels that can be dragged. `moved` gets the mouse's movement since the last frame
/// along the axis; a double click resets the seam.
struct SeamRow {
    const char* name;
    Rect Layout::*rect;
    bool vertical;
    float Seams::*member;
    float (*moved)(const Layout& layout, float way);
};

constexpr float minColumn = 1;

float shareOf(int length, float way, int whole) {
    return std::clamp((static_cast<float>(length) + way) / static_cast<float>(std::max(1, whole)), 0.15F,
                      0.85F);
}

constexpr std::array seamRows{
    SeamRow{N_("left seam"), &Layout::leftSeam, true, &Seams::parameters,
            [](const Layout& layout, float way) {
                return std::max(minColumn,
                                (static_cast<float>(layout.parameters.width) + way) / layout.scale);
            }},
    SeamRow{N_("right seam"), &Layout::rightSeam, true, &Seams::details,
            [](const Layout& layout, float way) {
                const int width = layout.window.right() - layout.rightSeam.right();
                return std::max(minColumn, (static_cast<float>(width) - way) / layout.scale);
            }},
    SeamRow{N_("middle seam"), &Layout::middleSeam, false, &Seams::split,
            [](const Layout& layout, float way) {
                return shareOf(layout.texture.height, way, layout.texture.height + layout.rightDock.height);
            }},
    SeamRow{N_("below seam"), &Layout::belowSeam, false, &Seams::below,
            [](const Layout& layout, float way) {
                return shareOf(layout.status.y - layout.belowSeam.bottom(), -way,
                               layout.status.y - layout.menu.bottom()); // of either dock
            }},
};

void drawSeam(const Session& session, const SeamRow& row, const Layout& layout) {
    const Rect& rect = layout.*row.rect;
    if (rect.isEmpty())
        return;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    beginBar(row.name, rect, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::InvisibleButton("grip", {static_cast<float>(rect.width), static_cast<float>(rect.height)});
    noteItem(row.name);
    if (ImGui::IsItemHovered() || ImGui::IsItemActive()) {
        ImGui::SetMouseCursor(row.vertical ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
        ImGui::GetWindowDrawList()->AddRectFilled(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(),
                                                  ImGui::GetColorU32(ImGuiCol_SeparatorHovered));
    }
    const ImVec2 delta = ImGui::GetIO().MouseDelta;
    const float way = row.vertical ? delta.x : delta.y;
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))
        rearrange(session, [&row](Workspace& workspace) { workspace.seams.*row.member = 0; });
    else if (ImGui::IsItemActive() && way != 0)
        rearrange(session, [&row, to = row.moved(layout, way)](Workspace& workspace) {
            workspace.seams.*row.member = to;
        });
    ImGui::End();
    ImGui::PopStyleVar();
}

/// Resets the panels' state that belongs to a document.
void forgetDocument(PanelStates& states) {
    states.textureSpace.drag = PlaneDrag::None;
    states.textureSpace.pressed.reset();
    states.textureSpace.move.reset();
    states.details.levels.zoom = 1;
    states.details.levels.face = 0;
    states.details.explain.fragmentOf.reset();
    states.details.timeline.chosen.reset();
    EnvironmentTableState& table = states.details.figures.environments;
    table.fragment.reset();
    table.texel.reset();
    table.constant.reset();
}

bool isPopupOpen() {
    return ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
}

/// The limits of drawing: if only the reference draws, the driver does not matter.
DriverFacts factsFor(const Session& session, const view::Capabilities& capabilities) {
    const std::vector<RendererKind> shown = shownRenderers(session.view);
    const bool asksGl =
        std::ranges::any_of(shown, [](RendererKind renderer) { return renderer != RendererKind::Reference; });
    return asksGl || shown.empty() ? view::driverFacts(capabilities) : DriverFacts{};
}

/// What the panels of the last frame have noted is from now on of this one. Returns whether a menu or list is
/// open.
bool beginFrame(Session& session, PanelStates& states, const Layout& layout) {
    forgetPlaces();
    session.out.keyTaken = false;
    session.out.movesVertices = false;
    // A key that closes it is not a shortcut as well; Dear ImGui may have closed it before this frame began.
    const bool popup = isPopupOpen() || (states.hadPopup && !states.keyboard.walks);
    if (!popup)
        moveKeyboardFocus(session, states.keyboard);
    takeLessonKeys(session, popup);
    session.window.hoveredParam = std::exchange(session.out.hoveredParam, {});
    const bool helpsBelow = session.settings.helpBelow && session.asking.dialog == Dialog::None;
    beginHints(helpsBelow ? hintRoom(layout) : 0);
    return popup;
}

/// Opens the tab or the settings that were asked for.
void showWanted(Session& session, const Layout& layout) {
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Left))
        session.look.shownParam.clear();
    Workspace& workspace = session.settings.workspace;
    if (std::exchange(session.window.stepWants, false) && layout.isStacked) { // its text stays
        session.window.wantedTab.reset();
        session.out.wantedSection.reset();
        session.out.wantedParam.clear();
    }
    if (const std::optional<Tab> wanted = std::exchange(session.window.wantedTab, std::nullopt))
        showTab(workspace, *wanted);
    if (session.out.wantedSection || !session.out.wantedParam.empty() || session.out.wantsSearch) {
        workspace.parameters = true;
        workspace.sheet = Panel::Parameters;
        if (layout.parameters.isEmpty()) // or behind what is maximised
            workspace.maximised = Maximised::None;
    }
}

/// Whether it has room: a narrow window shows one panel.
bool isSeenTab(const Session& session, const Layout& layout, Tab tab) {
    const Workspace& workspace = session.settings.workspace;
    return isShown(workspace, tab) && !layout.of(dockOf(workspace, tab)).isEmpty();
}

/// Frees the memory of workers for tabs and figures that are not visible.
void restUnseen(Session& session, const Layout& layout) {
    const auto isSeen = [&](Figure figure) {
        return session.window.figure == figure && isSeenTab(session, layout, Tab::Figures);
    };
    if (!isSeen(Figure::Environments))
        workers(session).environments->rest();
    if (!isSeen(Figure::Sheet))
        workers(session).sheet->rest();
    if (!isSeenTab(session, layout, Tab::Commands))
        workers(session).programs->rest();
}

/// Whether a diagnosis takes longer than a frame: while the camera is moved, it waits.
bool hasLargeMesh(const Scene& scene) {
    return std::ranges::any_of(
        scene.models, [](const Model& model) { return model.mesh.positions.size() > maxMeshVertices; });
}

/// Updates what is known of the scene: findings, the explained pixel, level pictures.
void followDocument(Session& session, PanelStates& states, const Pictures& pictures,
                    const view::Capabilities& capabilities, const Layout& layout) {
    if (std::exchange(states.documents, session.documents) != session.documents)
        forgetDocument(states);
    session.look.explaining.isOpen = isSeenTab(session, layout, Tab::Explain);
    session.document.images.setLimits(view::driverFacts(capabilities).limits());
    if (!ImGui::IsAnyMouseDown() || !hasLargeMesh(session.document.scene))
        diagnoseSession(session, factsFor(session, capabilities));
    followForced(session);
    if (isSeenTab(session, layout, Tab::File))
        followFile(session);
    askAboutTextures(session);
    askAboutPicture(session, pictures.frames.front().frame.size);
    askAboutTable(session, pictures.frames.front().frame.size);
    askAboutLevels(session, pictures.frames.front().frame.size);
    restUnseen(session, layout);
}

void drawPanels(const Session& session, PanelStates& states, const Pictures& pictures, const Layout& layout) {
    if (!layout.parameters.isEmpty())
        drawParametersPanel(session, states.parameters, pictures, layout);
    if (!layout.view.isEmpty())
        drawViewPanel(session, pictures, layout);
    else if (session.look.levels.hovered)
        act(session, [](Session& changed) { changed.look.levels.hovered.reset(); });
    drawNotes(session, layout);
    drawSheets(session, layout);
    if (!layout.texture.isEmpty())
        drawTextureSpacePanel(session, states.textureSpace, pictures, layout);
    for (const DockRow& row : dockRows)
        drawDock(session, states.details, pictures, layout, row.dock);
}

void drawSeams(const Session& session, PanelStates& states, const Layout& layout) {
    for (const SeamRow& row : seamRows)
        drawSeam(session, row, layout);
    drawDraggedTab(session, states.details, layout);
}

/// After the panels: a key may arrive together with a mouse release.
void handleKeys(const Session& session, PanelStates& states, const Pictures& pictures, const Layout& layout,
                bool popup) {
    movePixelWithKeys(session, layout, pictures.frames.front().frame.size);
    drawTour(session, layout, !popup);
    if (popup)
        return;
    handleShortcuts(session, layout);
    resizeTextByWheel(session, states.textWheel, layout);
}

/// Arrows, Enter and Escape work in an open menu or list, and in a panel reached by F6. Elsewhere Space
/// plays, Tab maximises the view, and dialogs have their own keys.
void chooseKeyboard(const Session& session, PanelStates& states) {
    ImGuiIO& io = ImGui::GetIO();
    const bool dialog = session.asking.dialog != Dialog::None;
    states.hadPopup = isPopupOpen();
    const bool navigates = !dialog && (states.hadPopup || states.keyboard.walks);
    io.ConfigFlags = navigates ? io.ConfigFlags | ImGuiConfigFlags_NavEnableKeyboard
                               : io.ConfigFlags & ~ImGuiConfigFlags_NavEnableKeyboard;
    letTabMove(navigates || io.WantTextInput || dialog);
}

Requests endFrame(Session& session, PanelStates& states) {
    const float dimmed = ImGui::GetCurrentContext()->DimBgRatio;
    Requests requests{std::exchange(session.asking.quitConfirmed, false), dimmed > 0 && dimmed < 1,
                      std::exchange(session.out.isOutdated, false), windowTitle(session.document)};
    chooseKeyboard(session, states);
    return requests;
}

} // namespace

Requests drawWorkbench(Session& session, PanelStates& states, const Pictures& pictures,
                       const view::Capabilities& capabilities, const Layout& layout) {
    const bool popup = beginFrame(session, states, layout);
    drawMenuBar(session, layout);
    showWanted(session, layout);
    followLesson(session, {{layout.picture.width, layout.picture.height}, capabilities.textureUnits});
    followDocument(session, states, pictures, capabilities, layout);
    drawPanels(session, states, pictures, layout);
    drawStatusBar(session, pictures, capabilities, layout, endHints()); // later help is a tooltip
    drawSeams(session, states, layout);
    handleKeys(session, states, pictures, layout, popup);
    drawDialogs(session, states.dialogs, pictures);
    drawSpotlight(session, layout);
    takeRequests(session);
    endPreview(session);
    followEdits(session);
    return endFrame(session, states);
}

} // namespace texplorer::ui

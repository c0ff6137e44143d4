#include "app/ui/view/camera.h"
#include "app/ui/window/panels.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/view/show.h"

namespace texplorer::ui {
namespace {

bool item(Session& session, const std::string& label, const char* keys, bool enabled = true,
          bool marked = false) {
    const bool pressed = ImGui::MenuItem(label.c_str(), keys, marked, enabled);
    noteItem(session, "menu:" + label);
    return pressed;
}

bool menu(Session& session, const char* label) {
    const bool open = ImGui::BeginMenu(label);
    noteItem(session, std::string("menu:") + label);
    return open;
}

std::string withName(const char* verb, std::string_view name) {
    return name.empty() ? verb : std::string(verb) + " " + std::string(name);
}

template<class Struct>
void resetTo(Session& session, Struct& target, const char* what, Struct initial = {}) {
    target = std::move(initial);
    sealEdit(session);
    recordEdit(session, what);
    sealEdit(session);
}

/// GL's initial texture parameters; the image stays.
Texture withInitialParameters(const Texture& texture) {
    Texture initial;
    initial.source = texture.source;
    initial.pattern = texture.pattern;
    initial.file = texture.file;
    return initial;
}

void resetEverything(Session& session) {
    Scene& scene = session.scene;
    for (Texture& texture : scene.textures)
        texture = withInitialParameters(texture);
    for (Pass& pass : scene.passes) {
        for (Unit& unit : pass.units)
            unit = Unit{.enabled = unit.enabled, .target = unit.target, .texture = unit.texture};
    }
    scene.light = {};
    scene.material = {};
    sealEdit(session);
    recordEdit(session, "Reset everything");
    sealEdit(session);
}

void fileMenu(Session& session) {
    if (item(session, "New", nullptr))
        askNewScene(session);
    if (item(session, "Open scene…", "Ctrl+O"))
        askOpenScene(session);
    if (item(session, "Open image…", "Ctrl+I"))
        askOpenImage(session);
    ImGui::Separator();
    if (item(session, "Save", "Ctrl+S"))
        save(session);
    if (item(session, "Save as…", "Ctrl+Shift+S"))
        askSaveAs(session);
    ImGui::Separator();
    if (item(session, "Quit", "Ctrl+Q"))
        requestQuit(session);
}

void editMenu(Session& session) {
    const History& history = session.history;
    if (item(session, withName("Undo", history.undoName()), "Ctrl+Z", history.canUndo()))
        undo(session);
    if (item(session, withName("Redo", history.redoName()), "Ctrl+Shift+Z", history.canRedo()))
        redo(session);
    ImGui::Separator();
    ImGui::TextDisabled("Reset to GL's initial values");
    Texture* texture = boundTexture(session);
    if (item(session, "Texture parameters", nullptr, texture != nullptr))
        resetTo(session, *texture, "Reset texture", withInitialParameters(*texture));
    if (item(session, "Texture unit", nullptr)) {
        Unit& unit = selectedUnit(session);
        resetTo(session, unit, "Reset unit",
                Unit{.enabled = unit.enabled, .target = unit.target, .texture = unit.texture});
    }
    if (item(session, "Everything but models and view", nullptr))
        resetEverything(session);
}

void viewMenu(Session& session, const Layout& layout) {
    const auto shown = shownNow(session.scene);
    for (const ShowRow& row : showRows) {
        if (item(session, std::string("Show ") + row.label, nullptr, true, shown == row.show))
            show(session, row, layout);
    }
    ImGui::Separator();
    int key = 0;
    for (const EnumRow& row : EnumTable<RendererKind>::rows) {
        const auto renderer = static_cast<RendererKind>(row.value);
        const bool chosen = !isComparing(session.views) && session.views.renderer == renderer;
        if (item(session, "Drawn by: " + std::string(row.label), std::to_string(++key).c_str(), true, chosen))
            showOne(session.views, renderer);
    }
    if (item(session, "Compare", std::to_string(++key).c_str(), true, isComparing(session.views)))
        showComparison(session.views);
    using reference::AnisotropyMethod;
    for (const EnumRow& row : EnumTable<AnisotropyMethod>::rows) {
        const auto method = static_cast<AnisotropyMethod>(row.value);
        if (item(session, "Anisotropy of the reference: " + std::string(row.label), nullptr, true,
                 session.views.anisotropy == method))
            session.views.anisotropy = method;
        helpTip(row.help);
    }
    ImGui::Separator();
    if (item(session, "Magnifier", "M", true, session.views.magnifies))
        session.views.magnifies = !session.views.magnifies;
    if (item(session, "Picture pixel for pixel", "0", session.views.zoom.factor > 1))
        session.views.zoom = {};
    ImGui::Separator();
    if (item(session, "Frame the models", "F"))
        frameAll(session, layout);
    if (item(session, "Reset camera", "Home"))
        resetCamera(session, layout);
}

} // namespace

void drawMenuBar(Session& session, const Layout& layout) {
    ImGui::PushStyleVar(
        ImGuiStyleVar_FramePadding,
        {ImGui::GetStyle().FramePadding.x,
         std::max(0.0F, (static_cast<float>(layout.menu.height) - ImGui::GetFontSize()) / 2)});
    beginPanel("Menu", layout.menu,
               ImGuiWindowFlags_MenuBar | ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    if (ImGui::BeginMenuBar()) {
        ImGui::PopStyleVar();
        if (menu(session, "File")) {
            fileMenu(session);
            ImGui::EndMenu();
        }
        if (menu(session, "Edit")) {
            editMenu(session);
            ImGui::EndMenu();
        }
        if (menu(session, "View")) {
            viewMenu(session, layout);
            ImGui::EndMenu();
        }
        if (menu(session, "Help")) {
            if (item(session, "Keys and mouse, about…", "F1"))
                session.dialog = Dialog::Help;
            ImGui::EndMenu();
        }
        drawRendererChoice(session,
                           ImGui::GetContentRegionMax().x - ImGui::GetCursorPosX() - leastPlaybackWidth());
        drawPlaybackControls(session);
        ImGui::EndMenuBar();
    } else {
        ImGui::PopStyleVar();
    }
    ImGui::End();
}

} // namespace texplorer::ui

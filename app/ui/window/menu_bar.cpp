#include "app/ui/window/menu_bar.h"

#include "app/ui/model/asking.h"
#include "app/ui/model/examples.h"
#include "app/ui/view/framing.h"
#include "app/ui/view/renderer_choice.h"
#include "app/ui/widgets/panel.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/window/playback_controls.h"

#include <fmt/core.h>

namespace texplorer::ui {
namespace {

bool item(const std::string& label, const char* keys, bool enabled = true, bool marked = false) {
    const bool pressed = ImGui::MenuItem(label.c_str(), keys, marked, enabled);
    noteItem("menu:" + label);
    return pressed;
}

bool menu(const char* label) {
    const bool open = ImGui::BeginMenu(label);
    noteItem(std::string("menu:") + label);
    return open;
}

std::string withName(const char* verb, std::string_view name) {
    return name.empty() ? verb : fmt::format("{} {}", verb, name);
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
    Scene& scene = session.document.scene;
    for (Texture& texture : scene.textures)
        texture = withInitialParameters(texture);
    for (Pass& pass : scene.passes) {
        for (Unit& unit : pass.units)
            unit = Unit{.enabled = unit.enabled, .target = unit.target, .texture = unit.texture};
    }
    for (Model& model : scene.models) {
        model.ownMaterial = false;
        model.material = {};
        model.lineWidth = model.pointSize = 1;
    }
    scene.light = {};
    scene.material = {};
    sealEdit(session);
    recordEdit(session, "Reset everything");
    sealEdit(session);
}

void examplesMenu(Session& session) {
    const bool open = ImGui::BeginMenu("Examples");
    noteItem("menu:Examples");
    if (!open)
        return;
    for (const Example& example : examples()) {
        if (item(example.title, nullptr))
            askExample(session, example.file);
        helpTip(example.help);
    }
    ImGui::EndMenu();
}

void fileMenu(Session& session) {
    if (item("New", nullptr))
        askNewScene(session);
    examplesMenu(session);
    if (item("Open scene…", "Ctrl+O"))
        askOpenScene(session);
    if (item("Open image…", "Ctrl+I"))
        askOpenImage(session);
    ImGui::Separator();
    if (item("Save", "Ctrl+S"))
        save(session);
    if (item("Save as…", "Ctrl+Shift+S"))
        askSaveAs(session);
    ImGui::Separator();
    if (item("Quit", "Ctrl+Q"))
        requestQuit(session);
}

void editMenu(Session& session) {
    const History& history = session.document.history;
    if (item(withName("Undo", history.undoName()), "Ctrl+Z", history.canUndo()))
        undo(session);
    if (item(withName("Redo", history.redoName()), "Ctrl+Shift+Z", history.canRedo()))
        redo(session);
    ImGui::Separator();
    ImGui::TextDisabled("Reset to GL's initial values");
    Texture* texture = boundTexture(session);
    if (item("Texture parameters", nullptr, texture != nullptr))
        resetTo(session, *texture, "Reset texture", withInitialParameters(*texture));
    if (item("Texture unit", nullptr)) {
        Unit& unit = selectedUnit(session);
        resetTo(session, unit, "Reset unit",
                Unit{.enabled = unit.enabled, .target = unit.target, .texture = unit.texture});
    }
    if (item("Everything but models and view", nullptr))
        resetEverything(session);
}

void viewMenu(Session& session, const Layout& layout) {
    const auto shown = shownNow(session.document.scene);
    for (const ShowRow& row : showRows) {
        if (item(std::string("Show ") + row.label, nullptr, true, shown == row.show))
            show(session, row, layout);
    }
    ImGui::Separator();
    int key = 0;
    for (const EnumRow& row : EnumTable<RendererKind>::rows) {
        const auto renderer = static_cast<RendererKind>(row.value);
        const bool chosen = !isComparing(session.window.view) && session.window.view.renderer == renderer;
        if (item("Drawn by: " + std::string(row.label), std::to_string(++key).c_str(),
                 session.window.view.offered.has(renderer), chosen))
            showOne(session.window.view, renderer);
        helpTip(helpOf(session.window.view, row));
    }
    if (item("Compare", std::to_string(++key).c_str(), canCompare(session.window.view),
             isComparing(session.window.view)))
        showComparison(session.window.view);
    using reference::AnisotropyMethod;
    for (const EnumRow& row : EnumTable<AnisotropyMethod>::rows) {
        const auto method = static_cast<AnisotropyMethod>(row.value);
        if (item("Anisotropy of the reference: " + std::string(row.label), nullptr, true,
                 session.window.view.anisotropy == method))
            session.window.view.anisotropy = method;
        helpTip(row.help);
    }
    ImGui::Separator();
    if (item("Magnifier", "M", true, session.window.view.magnifies))
        session.window.view.magnifies = !session.window.view.magnifies;
    if (item("Picture pixel for pixel", "0", session.window.view.zoom.factor > 1))
        session.window.view.zoom = {};
    ImGui::Separator();
    if (item("Frame the models", "F"))
        frameAll(session, layout);
    if (item("Reset camera", "Home"))
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
        if (menu("File")) {
            fileMenu(session);
            ImGui::EndMenu();
        }
        if (menu("Edit")) {
            editMenu(session);
            ImGui::EndMenu();
        }
        if (menu("View")) {
            viewMenu(session, layout);
            ImGui::EndMenu();
        }
        if (menu("Help")) {
            if (item("Keys and mouse, about…", "F1"))
                session.window.dialog = Dialog::Help;
            ImGui::EndMenu();
        }
        drawRendererChoice(session.window.view,
                           ImGui::GetContentRegionMax().x - ImGui::GetCursorPosX() - leastPlaybackWidth());
        drawPlaybackControls(session);
        ImGui::EndMenuBar();
    } else {
        ImGui::PopStyleVar();
    }
    ImGui::End();
}

} // namespace texplorer::ui

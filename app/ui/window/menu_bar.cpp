#include "app/ui/window/menu_bar.h"

#include "app/ui/language/translate.h"
#include "app/ui/model/asking.h"
#include "app/ui/model/lesson_list.h"
#include "app/ui/model/lesson_run.h"
#include "app/ui/model/scene_files.h"
#include "app/ui/view/false_color_view.h"
#include "app/ui/view/framing.h"
#include "app/ui/view/renderer_choice.h"
#include "app/ui/widgets/panel.h"
#include "app/ui/widgets/panel_menus.h"
#include "app/ui/widgets/param_tips.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/program_menu.h"
#include "app/ui/window/comfort.h"
#include "app/ui/window/kept_controls.h"
#include "app/ui/window/notes.h"
#include "app/ui/window/playback_controls.h"
#include "app/ui/window/presets_menu.h"
#include "app/ui/window/shortcuts.h"
#include "core/base/count.h"
#include "core/lesson/example.h"

#include <fmt/core.h>

namespace texplorer::ui {
namespace {

/// `keys`: the shortcut, "Ctrl+S".
bool item(const std::string& name, const std::string& keys = {}, bool enabled = true, bool marked = false) {
    const bool pressed = ImGui::MenuItem(label(name).c_str(), keys.c_str(), marked, enabled);
    noteItem("menu:" + name);
    return pressed;
}

bool menu(const char* name) {
    const bool open = ImGui::BeginMenu(label(name));
    noteItem(std::string("menu:") + name);
    return open;
}

/// GL's initial texture parameters; the image is kept.
Texture withInitialParameters(const Texture& texture) {
    Texture initial;
    initial.source = texture.source;
    initial.pattern = texture.pattern;
    initial.file = texture.file;
    return initial;
}

Unit withInitialParameters(const Unit& unit) {
    return {.enabled = unit.enabled, .target = unit.target, .texture = unit.texture};
}

void resetEverything(Scene& scene) {
    for (Texture& texture : scene.textures)
        texture = withInitialParameters(texture);
    for (Pass& pass : scene.passes) {
        for (Unit& unit : pass.units)
            unit = withInitialParameters(unit);
    }
    for (Model& model : scene.models) {
        model.ownMaterial = false;
        model.material = {};
        model.lineWidth = model.pointSize = 1;
    }
    scene.light = {};
    scene.material = {};
}

void examplesMenu(const Session& session) {
    if (!menu("Examples"))
        return;
    for (const Example& example : examples()) {
        if (item(example.title))
            act(session, [&example](Session& s) { askExample(s, example.file); });
        helpTip(example.help);
    }
    ImGui::EndMenu();
}

void drawLessonsMenu(const Session& session) {
    const Language language = catalogueInUse() ? catalogueInUse()->language() : Language::English;
    for (const LessonTitle& each : lessonTitles(language)) {
        const LessonProgress progress = progressOf(session, each.name, each.steps);
        const bool isOpen = session.window.lesson && session.window.lesson->key == each.name;
        const std::string count = fmt::format("{}/{}", progress.done, progress.steps);
        if (ImGui::MenuItem(fmt::format("{}###{}", each.title, each.name).c_str(), count.c_str(), isOpen))
            act(session, [name = each.name](Session& s) { askLesson(s, name); });
        noteItem("menu:lesson:" + each.name);
        helpTip(each.about);
    }
    ImGui::Separator();
    if (item("Leave the lesson", {}, session.window.lesson != nullptr))
        act(session, [](Session& s) { closeLesson(s); });
    if (item("Save my answers…", {}, !session.window.settings.lessons.empty()))
        act(session, askSaveAnswers);
    if (item("Copy my answers", {}, !session.window.settings.lessons.empty())) {
        ImGui::SetClipboardText(answersText(session).c_str());
        act(session, [](Session& s) { tell(s, "Copied your answers of all lessons as JSON."); });
    }
}

/// `hasLessons`: lessons have no menu of their own and are listed here.
void fileMenu(const Session& session, bool hasLessons) {
    if (item("New"))
        act(session, askNewScene);
    examplesMenu(session);
    if (hasLessons && menu("Lessons")) {
        drawLessonsMenu(session);
        ImGui::EndMenu();
    }
    if (item("Open scene…", keysOf(session, "open scene")))
        act(session, askOpenScene);
    if (item("Open image…", keysOf(session, "open image")))
        act(session, [](Session& s) { askOpenImage(s); });
    if (menu("Open recent")) {
        recentItems(session);
        ImGui::EndMenu();
    }
    ImGui::Separator();
    if (item("Save", keysOf(session, "save")))
        act(session, save);
    if (item("Save as…", keysOf(session, "save as")))
        act(session, askSaveAs);
    if (menu("Export as program")) {
        programMenuItems(session);
        ImGui::EndMenu();
    }
    ImGui::Separator();
    if (item("Picture of the view", keysOf(session, "view picture")))
        change(session, [](WindowState& window) { window.wantedCapture = Capture::View; });
    helpTip("Writes the view as a PNG file to your pictures folder.");
    if (item("Picture of the window", keysOf(session, "window picture")))
        change(session, [](WindowState& window) { window.wantedCapture = Capture::Window; });
    helpTip("Writes the whole window as a PNG file to your pictures folder.");
    if (item("Sheet of variations…"))
        act(session, showSheet);
    helpTip("Draws the scene with every pair of values of two parameters. Right-click a parameter to put it "
            "there.");
    if (item("Record animation…"))
        change(session, [](WindowState& window) { window.dialog = Dialog::Record; });
    helpTip("Writes an animation as GIF, WebP or PNG, in the background.");
    if (item("Copy link to this scene"))
        act(session, copySceneLink);
    helpTip("Copies the scene as a text for a mail or a chat. Paste it to open the scene. Image files are "
            "named, not included.");
    if (item("Paste scene", keysOf(session, "paste")))
        act(session, pasteScene);
    helpTip("Opens the scene of a copied link.");
    ImGui::Separator();
    if (item("Quit", keysOf(session, "quit")))
        act(session, requestQuit);
}

/// Its tooltip says what would be lost.
void resetItem(const Session& session) {
    const Document& document = session.document;
    const std::size_t count = changesBetween(document.saved, document.scene).size();
    if (item(document.file.empty() ? "Reset to the start" : "Reset to the file", {}, count > 0))
        resetToSaved(session);
    helpTip(count == 0
                ? std::string("The scene has not changed.")
                : fmt::format("Reverts the changes of {}. Undo restores them.", countOf(count, "setting")));
}

void editMenu(const Session& session, const Layout& layout) {
    const History& history = session.document.history;
    const std::string_view undone = history.undoName();
    const std::string_view redone = history.redoName();
    if (item(undone.empty() ? std::string("Undo") : fmt::format("Undo {}", undone), keysOf(session, "undo"),
             history.canUndo()))
        session.out.requests.emplace_back(Undo{});
    if (item(redone.empty() ? std::string("Redo") : fmt::format("Redo {}", redone), keysOf(session, "redo"),
             history.canRedo()))
        session.out.requests.emplace_back(Redo{});
    ImGui::Separator();
    if (item("Copy as texshot command"))
        act(session, [layout](Session& s) { copyTexshotCommand(s, layout); });
    helpTip("Copies a command that draws this view without a window, for scripts.");
    ImGui::Separator();
    resetItem(session);
    caption("Reset to GL's initial values");
    const Selection& at = session.window.selection;
    if (item("Texture parameters", {}, boundTexture(session) != nullptr))
        submit(session, "Reset texture", [&](Scene& scene) {
            Texture& texture = scene.textures[static_cast<std::size_t>(selectedUnit(scene, at).texture)];
            texture = withInitialParameters(texture);
        });
    if (item("Texture unit"))
        submit(session, "Reset unit", [&](Scene& scene) {
            Unit& unit = selectedUnit(scene, at);
            unit = withInitialParameters(unit);
        });
    if (item("Everything but models and view"))
        submit(session, "Reset everything", resetEverything);
}

std::string_view shortcutOf(RendererKind renderer) {
    constexpr std::array names{"fixed", "shader", "reference"};
    return names[static_cast<std::size_t>(renderer)];
}

/// For presentations.
void presentingItems(const Session& session) {
    if (item("Note", keysOf(session, "note")))
        act(session, addNoteInTheMiddle);
    helpTip("Adds a text over the view. Drag it, double-click to edit, Delete removes it. The key adds it "
            "at the pointer.");
    if (item("Clear notes", {}, !session.window.notes.list.empty()))
        act(session, clearNotes);
    if (item("Spotlight", keysOf(session, "spotlight"), true, session.window.spotlight))
        change(session, [](WindowState& window) { window.spotlight = !window.spotlight; });
    helpTip("Dims everything except the surroundings of the pointer, for presentations.");
}

/// A choice that OpenGL leaves open and the reference supports both ways; `title` has a placeholder for its
/// label.
template<Enumerated E>
void methodItems(const Session& session, const char* title, E ViewSettings::*chosen) {
    for (const EnumRow& row : EnumTable<E>::rows) {
        const auto method = static_cast<E>(row.value);
        if (item(fmt::format(fmt::runtime(title), row.label), {}, true,
                 session.window.view.*chosen == method))
            change(session, [chosen, method](WindowState& window) { window.view.*chosen = method; });
        helpTip(row.help);
    }
}

void viewMenu(const Session& session, const Layout& layout) {
    const auto shown = shownNow(session.document.scene);
    for (const ShowRow& row : showRows) {
        if (item(fmt::format("Show {}", row.label), {}, true, shown == row.show))
            show(session, row, layout);
    }
    ImGui::Separator();
    for (const EnumRow& row : EnumTable<RendererKind>::rows) {
        const auto renderer = static_cast<RendererKind>(row.value);
        const bool chosen =
            !comparesRenderers(session.window.view) && session.window.view.renderer == renderer;
        if (item(fmt::format("Drawn by: {}", row.label), keysOf(session, shortcutOf(renderer)),
                 session.window.view.offered.has(renderer), chosen))
            change(session, [renderer](WindowState& window) { showOne(window.view, renderer); });
        helpTip(helpOf(session.window.view, row));
    }
    if (item("Compare", keysOf(session, "compare"), canCompare(session.window.view),
             comparesRenderers(session.window.view)))
        change(session, [](WindowState& window) { showComparison(window.view); });
    methodItems(session, "Anisotropy of the reference: {}", &ViewSettings::anisotropy);
    methodItems(session, "rho of the reference: {}", &ViewSettings::rho);
    ImGui::Separator();
    if (menu("Picture or false colours")) {
        shownItems(session);
        ImGui::EndMenu();
    }
    if (item("Magnifier", keysOf(session, "magnifier"), true, session.window.view.magnifies))
        change(session, [](WindowState& window) { window.view.magnifies = !window.view.magnifies; });
    if (item("Picture pixel for pixel", keysOf(session, "pixel for pixel"),
             session.window.view.zoom.factor > 1))
        change(session, [](WindowState& window) { window.view.zoom = {}; });
    ImGui::Separator();
    presentingItems(session);
    ImGui::Separator();
    if (item("OpenGL's names", {}, true, session.window.settings.glNames))
        change(session, [](WindowState& window) { window.settings.glNames = !window.settings.glNames; });
    helpTip("Shows OpenGL's names for parameters and choices.");
    comfortItems(session);
    ImGui::Separator();
    layoutsMenu(session);
    panelsMenu(session);
    ImGui::Separator();
    if (item("Frame the models", keysOf(session, "frame")))
        frameAll(session, layout);
    if (item("Reset camera", keysOf(session, "reset camera")))
        resetCamera(session, layout);
}

/// The choice of the renderer, and A: as large as the room next to the clock allows. If there is little room,
/// only the renderer is shown, and the clock has only buttons; A has its menu.
void drawChoices(const Session& session) {
    constexpr float minList = 4.5F; // in heights of a letter
    const ViewSettings& settings = session.window.view;
    const float whole = ImGui::GetContentRegionMax().x - ImGui::GetCursorPosX();
    const float available = whole - minPlaybackWidth();
    for (const RendererForm form : rendererForms) {
        const float width = rendererChoiceWidth(settings, form);
        if (width + keptControlsWidth(session) > available)
            continue;
        drawRendererChoice(session, form, width);
        return drawKeptControls(session, available - width);
    }
    const float min = ImGui::GetFontSize() * minList;
    const float max = available >= min ? available : whole - playbackButtonsWidth();
    if (max >= min)
        drawRendererChoice(session, RendererForm::List, max);
}

constexpr float minWidthWithLessons = 46; // in heights of a letter

} // namespace

void drawMenuBar(const Session& session, const Layout& layout) {
    ImGui::PushStyleVar(
        ImGuiStyleVar_FramePadding,
        {ImGui::GetStyle().FramePadding.x,
         std::max(0.0F, (static_cast<float>(layout.menu.height) - ImGui::GetFontSize()) / 2)});
    beginPanel("Menu", layout.menu,
               ImGuiWindowFlags_MenuBar | ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    if (ImGui::BeginMenuBar()) {
        ImGui::PopStyleVar();
        // Without room next to the clock, lessons are in the menu File.
        const bool isWide =
            static_cast<float>(layout.menu.width) > ImGui::GetFontSize() * minWidthWithLessons;
        if (menu("File")) {
            fileMenu(session, !isWide);
            ImGui::EndMenu();
        }
        if (menu("Edit")) {
            editMenu(session, layout);
            ImGui::EndMenu();
        }
        if (menu("View")) {
            viewMenu(session, layout);
            ImGui::EndMenu();
        }
        if (isWide && menu("Lessons")) {
            drawLessonsMenu(session);
            ImGui::EndMenu();
        }
        if (menu("Presets")) {
            drawPresetsMenu(session);
            ImGui::EndMenu();
        }
        if (menu("A/B")) {
            drawKeptMenu(session);
            ImGui::EndMenu();
        }
        if (menu("Help")) {
            if (item("Keys and mouse, about…", keysOf(session, "help")))
                change(session, [](WindowState& window) { window.dialog = Dialog::Help; });
            if (item("Tour"))
                change(session, [](WindowState& window) { window.tour = 0; });
            helpTip("Explains the window in five steps");
            ImGui::EndMenu();
        }
        drawChoices(session);
        drawPlaybackControls(session);
        ImGui::EndMenuBar();
    } else {
        ImGui::PopStyleVar();
    }
    ImGui::End();
}

} // namespace texplorer::ui

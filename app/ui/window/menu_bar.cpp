#include "app/ui/files/answers.h"
#include "app/ui/files/asking.h"
#include "app/ui/files/replaced_document.h"
#include "app/ui/files/scene_files.h"
#include "app/ui/files/texshot_command.h"
#include "app/ui/language/translate.h"
#include "app/ui/model/lesson_list.h"
#include "app/ui/model/notice.h"
#include "app/ui/model/preset_edits.h"
#include "app/ui/model/sheet_choice.h"
#include "app/ui/state/lesson_records.h"
#include "app/ui/view/framing.h"
#include "app/ui/view/pane_drawing.h"
#include "app/ui/view/renderer_choice.h"
#include "app/ui/widgets/panel.h"
#include "app/ui/widgets/panel_menus.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/popups.h"
#include "app/ui/widgets/program_menu.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/window/notes.h"
#include "app/ui/window/shortcuts.h"
#include "app/ui/window/text_size.h"
#include "app/ui/window/window_parts.h"
#include "texplorer/base/sentence.h"
#include "texplorer/lesson/example.h"
#include "texplorer/scene/storage/scene_link.h"
#include "texplorer/text/printable.h"

#include <fmt/core.h>

#include <cmath>

namespace texplorer::ui {
namespace {

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

/// An item that does the same as the shortcut with this name.
void shortcutItem(const Session& session, const Layout& layout, const Sentence& name,
                  std::string_view shortcut, bool enabled = true, bool marked = false) {
    const Shortcut& row = shortcutOf(shortcut);
    if (menuItem(name, keysOf(session, shortcut), enabled, marked))
        act(session, [&row, layout](Session& s) { row.act(s, layout); });
}

void examplesItems(const Session& session) {
    for (const Example& example : examples()) {
        if (menuItem(example.title))
            act(session, [&example](Session& s) { askExample(s, example.file); });
        helpTip(example.help);
    }
}

void lessonsItems(const Session& session) {
    const Language language = catalogueInUse() ? catalogueInUse()->language() : Language::English;
    for (const LessonTitle& each : lessonTitles(language)) {
        const LessonProgress progress = progressOf(session.settings, each.name, each.steps);
        const bool isOpen = session.lesson && session.lesson->key == each.name;
        const std::string count = fmt::format("{}/{}", progress.done, progress.steps);
        if (ImGui::MenuItem(fmt::format("{}###{}", each.title, each.name).c_str(), count.c_str(), isOpen))
            act(session, [name = each.name](Session& s) { askLesson(s, name); });
        item("menu:lesson:" + each.name, ProperName{each.about});
    }
    ImGui::Separator();
    if (menuItem("Leave the lesson", {}, session.lesson.has_value()))
        act(session, [](Session& s) { closeLesson(s); });
    if (menuItem("Save my answers…", {}, !session.settings.lessons.empty()))
        act(session, askSaveAnswers);
    if (menuItem("Copy my answers", {}, !session.settings.lessons.empty())) {
        ImGui::SetClipboardText(answersText(session.settings).c_str());
        act(session, [](Session& s) { tell(s, "Copied your answers of all lessons as JSON."); });
    }
}

/// A file's name is not translated, and "##" in it has no special meaning.
bool fileItem(const std::filesystem::path& file) {
    const std::string name = printable(file.filename().string());
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const bool pressed = ImGui::Selectable("##file", false, 0, {ImGui::CalcTextSize(name.c_str()).x, 0});
    noteItem("menu:" + name);
    ImGui::GetWindowDrawList()->AddText(at, color::text, name.c_str());
    return pressed;
}

void recentItems(const Session& session) {
    const Settings& settings = session.settings;
    if (settings.recentFiles.empty()) {
        dimText("No files opened yet");
        return;
    }
    for (const std::filesystem::path& file : settings.recentFiles) {
        ImGui::PushID(static_cast<int>(&file - settings.recentFiles.data()));
        if (fileItem(file))
            act(session, [file](Session& s) { requestOpen(s, {file}); });
        helpTip(ProperName{file.string()});
        ImGui::PopID();
    }
    ImGui::Separator();
    if (menuItem("Forget these files"))
        act(session, [](Session& changed) { changed.settings.recentFiles.clear(); });
}

void copyTexshotCommand(Session& session, const Layout& layout) {
    const Result<std::string> command =
        texshotCommand(session, {std::max(1, layout.picture.width), std::max(1, layout.picture.height)});
    if (!command)
        return say(session, Sentence("No command can draw this scene: {0}.", command.error().message));
    ImGui::SetClipboardText(command->c_str());
    tell(session, "Copied a command that draws this view without a window.");
}

void copySceneLink(Session& session) {
    const Result<std::string> link = sceneLink(session);
    if (!link)
        return say(session, link.error());
    ImGui::SetClipboardText(link->c_str());
    tell(session, Sentence("Copied the scene as a text of {0} letters. Paste it into Texplorer to open "
                           "the scene.",
                           link->size()));
}

/// `hasLessons`: lessons have no menu of their own and are listed here.
void fileItems(const Session& session, const Layout& layout, bool hasLessons) {
    shortcutItem(session, layout, "New", "new scene");
    menuOf("Examples", [&] { examplesItems(session); });
    if (hasLessons)
        menuOf("Lessons", [&] { lessonsItems(session); });
    shortcutItem(session, layout, "Open scene…", "open scene");
    shortcutItem(session, layout, "Open image…", "open image");
    menuOf("Open recent", [&] { recentItems(session); });
    ImGui::Separator();
    shortcutItem(session, layout, "Save", "save");
    shortcutItem(session, layout, "Save as…", "save as");
    saveTextureItem(session);
    menuOf("Export as program", [&] { programMenuItems(session); });
    ImGui::Separator();
    shortcutItem(session, layout, "Picture of the view", "view picture");
    helpTip("Writes the view as a PNG file to your pictures folder.");
    shortcutItem(session, layout, "Picture of the window", "window picture");
    helpTip("Writes the whole window as a PNG file to your pictures folder.");
    if (menuItem("Sheet of variations…"))
        act(session, showSheet);
    helpTip("Draws the scene with every pair of values of two parameters. Right-click a parameter to put it "
            "there.");
    if (menuItem("Record animation…"))
        act(session, [](Session& changed) { changed.asking.dialog = Dialog::Record; });
    helpTip("Writes an animation as GIF, WebP or PNG, in the background.");
    if (menuItem("Copy link to this scene"))
        act(session, copySceneLink);
    helpTip("Copies the scene as a text for a mail or a chat. Paste it to open the scene. Image files are "
            "named, not included.");
    shortcutItem(session, layout, "Paste scene", "paste");
    helpTip("Opens the scene of a copied link.");
    ImGui::Separator();
    shortcutItem(session, layout, "Quit", "quit");
}

/// Its tooltip says what would be lost.
void resetItem(const Session& session) {
    const Document& document = session.document;
    const std::size_t count = changesBetween(document.saved, document.scene).size();
    if (menuItem(document.file.empty() ? "Reset to the start" : N_("Reset to the file"), {}, count > 0))
        resetToSaved(session);
    helpTip(count == 0 ? "The scene has not changed."
                       : Sentence("Reverts the changes of {0}. Undo restores them.",
                                  Sentence::plural("{0} setting", "{0} settings", count)));
}

void editItems(const Session& session, const Layout& layout) {
    const History& history = session.document.history;
    const Sentence undone = history.undoName();
    const Sentence redone = history.redoName();
    shortcutItem(session, layout, undone.empty() ? "Undo" : Sentence("Undo {0}", undone), "undo",
                 history.canUndo());
    shortcutItem(session, layout, redone.empty() ? "Redo" : Sentence("Redo {0}", redone), "redo",
                 history.canRedo());
    ImGui::Separator();
    if (menuItem("Copy as texshot command"))
        act(session, [layout](Session& s) { copyTexshotCommand(s, layout); });
    helpTip("Copies a command that draws this view without a window, for scripts.");
    ImGui::Separator();
    resetItem(session);
    caption("Reset to GL's initial values");
    const Selection& at = session.look.selection;
    if (menuItem("Texture parameters", {}, boundTexture(session) != nullptr))
        submit(session, "Reset texture", [&](Scene& scene) {
            Texture& texture = scene.textures[static_cast<std::size_t>(selectedUnit(scene, at).texture)];
            texture = withInitialParameters(texture);
        });
    if (menuItem("Texture unit"))
        submit(session, "Reset unit", [&](Scene& scene) {
            Unit& unit = selectedUnit(scene, at);
            unit = withInitialParameters(unit);
        });
    if (menuItem("Everything but models and view"))
        submit(session, "Reset everything", resetEverything);
}

std::string_view shortcutNameOf(RendererKind renderer) {
    constexpr std::array names{"fixed", "shader", "reference"};
    return names[static_cast<std::size_t>(renderer)];
}

/// For presentations.
void presentingItems(const Session& session, const Layout& layout) {
    if (menuItem("Note", keysOf(session, "note")))
        act(session, addNoteInTheMiddle);
    helpTip("Adds a text over the view. Drag it, double-click to edit, Delete removes it. The key adds it "
            "at the pointer.");
    if (menuItem("Clear notes", {}, !session.look.notes.list.empty()))
        act(session, clearNotes);
    shortcutItem(session, layout, "Spotlight", "spotlight", true, session.window.spotlight);
    helpTip("Dims everything except the surroundings of the pointer, for presentations.");
}

/// A choice that OpenGL leaves open and the reference supports both ways; `title` has a placeholder for its
/// label.
template<Enumerated E>
void methodItems(const Session& session, Sentence::Key<std::string_view> title, E ViewSettings::*chosen) {
    for (const EnumRow& row : EnumTable<E>::rows) {
        const auto method = static_cast<E>(row.value);
        if (menuChoice(Sentence(title, row.label), session.view.*chosen == method))
            act(session, [chosen, method](Session& changed) { changed.view.*chosen = method; });
        helpTip(row.help);
    }
}

/// A menu of the rows of a setting.
void choiceItems(const Session& session, const char* title, const auto& rows, auto value, auto setting) {
    menuOf(title, [&] {
        for (const auto& row : rows) {
            if (menuChoice(row.label, session.settings.*setting == row.*value))
                act(session, [&row, value, setting](Session& s) { s.settings.*setting = row.*value; });
        }
    });
}

/// Themes, text sizes, the place of help and full screen.
void comfortItems(const Session& session, const Layout& layout) {
    const Settings& settings = session.settings;
    choiceItems(session, N_("Theme"), themeRows, &ThemeRow::theme, &Settings::theme);
    choiceItems(session, N_("Language"), languageRows, &LanguageRow::language, &Settings::language);
    menuOf("Text size", [&] {
        shortcutItem(session, layout, "Larger", N_("larger text"), settings.textPercent < Settings::maxText);
        shortcutItem(session, layout, "Smaller", N_("smaller text"),
                     settings.textPercent > Settings::minText);
        shortcutItem(session, layout, "Usual", "usual text");
        ImGui::Separator();
        for (const int size : textSizes) {
            if (menuChoice(fmt::format("{} %", size), settings.textPercent == size))
                act(session, [size](Session& changed) { changed.settings.textPercent = size; });
        }
    });
    if (menuChoice(N_("Large controls"), settings.largeControls))
        act(session,
            [](Session& changed) { changed.settings.largeControls = !changed.settings.largeControls; });
    helpTip("Buttons, rows and menus large enough for fingers");
    if (menuChoice(N_("Help in the status bar"), settings.helpBelow))
        act(session, [](Session& changed) { changed.settings.helpBelow = !changed.settings.helpBelow; });
    helpTip("Explains what is under the pointer at the lower edge of the window, not in a tooltip.");
    shortcutItem(session, layout, "Full screen", N_("full screen"), true, session.window.fillsScreen);
    shortcutItem(session, layout, "View alone", N_("view alone"), true,
                 maximisedOf(settings.workspace) == Maximised::View);
}

void viewItems(const Session& session, const Layout& layout) {
    const auto shown = shownNow(session.document.scene);
    for (const ShowRow& row : showRows) {
        if (menuChoice(Sentence("Show {0}", row.label), shown == row.show))
            show(session, row, layout);
    }
    ImGui::Separator();
    for (const EnumRow& row : EnumTable<RendererKind>::rows) {
        const auto renderer = static_cast<RendererKind>(row.value);
        const bool chosen = !comparesRenderers(session.view) && session.view.renderer == renderer;
        shortcutItem(session, layout, Sentence("Drawn by: {0}", row.label), shortcutNameOf(renderer),
                     session.view.offered.has(renderer), chosen);
        helpTip(helpOf(session.view, row));
    }
    shortcutItem(session, layout, "Compare", "compare", canCompare(session.view),
                 comparesRenderers(session.view));
    methodItems(session, N_("Anisotropy of the reference: {0}"), &ViewSettings::anisotropy);
    methodItems(session, N_("rho of the reference: {0}"), &ViewSettings::rho);
    ImGui::Separator();
    menuOf("Picture or false colours", [&] { shownItems(session); });
    shortcutItem(session, layout, "Magnifier", "magnifier", true, session.view.magnifies);
    shortcutItem(session, layout, "Picture pixel for pixel", N_("pixel for pixel"),
                 session.view.zoom.factor > 1);
    ImGui::Separator();
    presentingItems(session, layout);
    ImGui::Separator();
    if (menuChoice(N_("OpenGL's names"), session.settings.glNames))
        act(session, [](Session& changed) { changed.settings.glNames = !changed.settings.glNames; });
    helpTip("Shows OpenGL's names for parameters and choices.");
    comfortItems(session, layout);
    ImGui::Separator();
    menuOf("Layout", [&] { layoutItems(session); });
    menuOf("Panels", [&] { panelItems(session); });
    ImGui::Separator();
    shortcutItem(session, layout, "Frame the models", "frame");
    shortcutItem(session, layout, "Reset camera", "reset camera");
}

/// Grouped, each previewed while the pointer rests on it. They are many, and one column leaves the picture
/// free.
void presetsItems(const Session& session) {
    const ImVec2 spacing = ImGui::GetStyle().ItemSpacing;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing,
                        {spacing.x, targetHeight() > 0 ? spacing.y : std::floor(spacing.y / 4)});
    std::string_view group;
    for (const Preset& preset : presets()) {
        if (preset.group != group) {
            group = preset.group;
            caption(group);
        }
        if (ImGui::MenuItem(label(preset.label).c_str()))
            choosePreset(session, preset);
        noteItem(fmt::format("preset:{}", preset.name));
        if (ImGui::IsItemHovered())
            previewPreset(session, preset);
        helpTip(Sentence("{0}\n{1}", preset.help, preset.look));
    }
    ImGui::PopStyleVar();
}

void helpItems(const Session& session, const Layout& layout) {
    shortcutItem(session, layout, "Keys and mouse, about…", "help");
    if (menuItem("Tour"))
        act(session, [](Session& changed) { changed.window.tour = 0; });
    helpTip("Explains the window in five steps");
}

/// The choice of the renderer, and A: as large as the room next to the clock allows. If there is little room,
/// only the renderer is shown, and the clock has only buttons; A has its menu.
void drawChoices(const Session& session) {
    constexpr float minList = 4.5F; // in heights of a letter
    const ViewSettings& settings = session.view;
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
    beginPanel(N_("Menu"), layout.menu,
               ImGuiWindowFlags_MenuBar | ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    if (ImGui::BeginMenuBar()) {
        ImGui::PopStyleVar();
        beginEntries();
        // Without room next to the clock, lessons are in the menu File.
        const bool isWide =
            static_cast<float>(layout.menu.width) > ImGui::GetFontSize() * minWidthWithLessons;
        menuOf("File", [&] { fileItems(session, layout, !isWide); });
        menuOf("Edit", [&] { editItems(session, layout); });
        menuOf("View", [&] { viewItems(session, layout); });
        if (isWide)
            menuOf("Lessons", [&] { lessonsItems(session); });
        menuOf("Presets", [&] { presetsItems(session); });
        menuOf("A/B", [&] { drawKeptMenu(session); });
        menuOf("Help", [&] { helpItems(session, layout); });
        endEntries();
        drawChoices(session);
        drawPlaybackControls(session);
        ImGui::EndMenuBar();
    } else {
        ImGui::PopStyleVar();
    }
    ImGui::End();
}

} // namespace texplorer::ui

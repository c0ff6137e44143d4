#include "app/ui/window/comfort.h"

#include "app/ui/language/translate.h"
#include "app/ui/model/asking.h"
#include "app/ui/model/scene_files.h"
#include "app/ui/model/texshot_command.h"
#include "app/ui/widgets/param_tips.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/window/shortcuts.h"
#include "core/scene/storage/scene_link.h"
#include "core/text/printable.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace texplorer::ui {
namespace {

constexpr std::array textSizes{75, 90, 100, 110, 125, 150, 175, 200, 225, 250};
static_assert(textSizes.front() == Settings::minText && textSizes.back() == Settings::maxText);

bool comfortItem(const std::string& name, const std::string& keys = {}, bool marked = false,
                 bool enabled = true) {
    const bool pressed = ImGui::MenuItem(label(name).c_str(), keys.c_str(), marked, enabled);
    noteItem("menu:" + name);
    return pressed;
}

bool comfortMenu(const char* name) {
    const bool open = ImGui::BeginMenu(label(name));
    noteItem(std::string("menu:") + name);
    return open;
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

} // namespace

void changeTextSize(Session& session, int steps) {
    int& percent = session.window.settings.textPercent;
    // Between two sizes, the next one in that direction.
    const auto* above = std::ranges::upper_bound(textSizes, percent);
    const auto* from = std::ranges::lower_bound(textSizes, percent);
    const auto index = steps > 0 ? above - textSizes.begin() + steps - 1 : from - textSizes.begin() + steps;
    percent = textSizes[static_cast<std::size_t>(
        std::clamp<std::ptrdiff_t>(index, 0, static_cast<std::ptrdiff_t>(textSizes.size()) - 1))];
}

void resizeTextByWheel(const Session& session, float& turned, const Layout& layout) {
    const ImGuiIO& io = ImGui::GetIO();
    const Workspace& workspace = session.window.settings.workspace;
    const auto isOver = [&](const Rect& rect) { return rect.contains(io.MousePos.x, io.MousePos.y); };
    const bool zooms = isOver(layout.canvas) || isOver(layout.texture) ||
                       (isShown(workspace, Tab::Levels) && isOver(layout.of(dockOf(workspace, Tab::Levels))));
    if (!io.KeyCtrl || session.window.dialog != Dialog::None || zooms) {
        turned = 0;
        return;
    }
    turned += io.MouseWheel; // the notches of a touchpad are small
    const int steps = static_cast<int>(turned);
    turned -= static_cast<float>(steps);
    if (steps != 0)
        act(session, [steps](Session& s) { changeTextSize(s, steps); });
}

void comfortItems(const Session& session) {
    const Settings& settings = session.window.settings;
    if (comfortMenu("Theme")) {
        for (const ThemeRow& row : themeRows) {
            if (comfortItem(row.label, {}, settings.theme == row.theme))
                change(session, [&row](WindowState& window) { window.settings.theme = row.theme; });
        }
        ImGui::EndMenu();
    }
    if (comfortMenu("Language")) {
        for (const LanguageRow& row : languageRows) {
            if (comfortItem(row.label, {}, settings.language == row.language))
                change(session, [&row](WindowState& window) { window.settings.language = row.language; });
        }
        ImGui::EndMenu();
    }
    if (comfortMenu("Text size")) {
        if (comfortItem("Larger", keysOf(session, "larger text"), false,
                        settings.textPercent < Settings::maxText))
            act(session, [](Session& s) { changeTextSize(s, 1); });
        if (comfortItem("Smaller", keysOf(session, "smaller text"), false,
                        settings.textPercent > Settings::minText))
            act(session, [](Session& s) { changeTextSize(s, -1); });
        if (comfortItem("Usual", keysOf(session, "usual text")))
            change(session,
                   [](WindowState& window) { window.settings.textPercent = Settings{}.textPercent; });
        ImGui::Separator();
        for (const int size : textSizes) {
            if (comfortItem(fmt::format("{} %", size), {}, settings.textPercent == size))
                change(session, [size](WindowState& window) { window.settings.textPercent = size; });
        }
        ImGui::EndMenu();
    }
    if (comfortItem("Help in the status bar", {}, settings.helpBelow))
        change(session, [](WindowState& window) { window.settings.helpBelow = !window.settings.helpBelow; });
    helpTip("Explains what is under the pointer at the lower edge of the window, not in a tooltip.");
    if (comfortItem("Full screen", keysOf(session, "full screen"), session.window.fillsScreen))
        change(session, [](WindowState& window) { window.fillsScreen = !window.fillsScreen; });
    if (comfortItem("View alone", keysOf(session, "view alone"),
                    maximisedOf(settings.workspace) == Maximised::View))
        rearrange(session, [](Workspace& workspace) { toggleMaximised(workspace, Maximised::View); });
}

void copyTexshotCommand(Session& session, const Layout& layout) {
    const Result<std::string> command =
        texshotCommand(session, {std::max(1, layout.picture.width), std::max(1, layout.picture.height)});
    if (!command)
        return say(session, fmt::format("No command can draw this scene: {}.", command.error().message));
    ImGui::SetClipboardText(command->c_str());
    tell(session, "Copied a command that draws this view without a window.");
}

void copySceneLink(Session& session) {
    const Result<std::string> link = sceneLink(session);
    if (!link)
        return say(session, link.error());
    ImGui::SetClipboardText(link->c_str());
    tell(session, fmt::format("Copied the scene as a text of {} letters. Paste it into Texplorer to open "
                              "the scene.",
                              link->size()));
}

void pasteScene(Session& session) {
    const char* text = ImGui::GetClipboardText();
    if (!text || !isSceneLink(text))
        return say(session, "The clipboard has no link to a scene.");
    if (const Result<void> opened = openSceneLink(session, text); !opened)
        say(session, fmt::format("The scene can't be pasted: {}.", describe(opened.error())));
}

void recentItems(const Session& session) {
    const Settings& settings = session.window.settings;
    if (settings.recentFiles.empty()) {
        dimText("No files opened yet");
        return;
    }
    for (const std::filesystem::path& file : settings.recentFiles) {
        ImGui::PushID(static_cast<int>(&file - settings.recentFiles.data()));
        if (fileItem(file))
            act(session, [file](Session& s) { requestOpen(s, {file}); });
        helpTip(file.string());
        ImGui::PopID();
    }
    ImGui::Separator();
    if (comfortItem("Forget these files"))
        change(session, [](WindowState& window) { window.settings.recentFiles.clear(); });
}

} // namespace texplorer::ui

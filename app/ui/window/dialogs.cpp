#include "app/ui/window/dialogs.h"

#include "app/ui/model/asking.h"
#include "app/ui/model/scene_files.h"
#include "app/ui/widgets/keys.h"
#include "app/ui/widgets/modal.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/window/recovery_dialog.h"
#include "app/ui/window/shortcuts.h"
#include "core/base/printable.h"
#include "core/codec/registry.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace texplorer::ui {
namespace {

struct Line {
    const char* keys;
    const char* effect;
};

constexpr std::array mouseLines{
    Line{"Drag", "orbit the camera"},
    Line{"Shift + drag, right drag", "move it sideways"},
    Line{"Wheel", "go nearer or farther"},
    Line{"Click with Explain open", "explain the pixel under the mouse"},
    Line{"Ctrl + wheel, Ctrl + drag", "enlarge the pixels of the picture, move it"},
    Line{"Click, Shift + click", "pick the nearest vertex, choose several"},
    Line{"Double click", "frame all models"},
    Line{"Right click on a setting", "back to GL's initial value, or pin it to Essentials"},
    Line{"Double click on a number", "type it"},
};

/// What is no shortcut: it needs the pointer, or goes on while it is held.
constexpr std::array otherKeys{
    Line{"Arrow keys, with Shift", "move the explained pixel by one, by ten"},
    Line{"F6, Shift+F6",
         "to the next panel: arrows walk among its controls, Space works them; Escape ends it"},
    Line{"hold E", "explain the pixel under the mouse"},
    Line{"G, R, S over texture space", "move, rotate, scale the chosen vertices; A chooses all, F shows all"},
    Line{"Arrow keys there, with Shift", "move them by a texel, by 1/4"},
};

/// The dialogs in which one chooses a file.
struct BrowserRow {
    Dialog dialog;
    const char* title;
    bool saving;
    bool thumbnails; ///< and with them the extensions of images, not of scenes
};

constexpr std::array browserRows{
    BrowserRow{Dialog::OpenScene, "Open a scene", false, false},
    BrowserRow{Dialog::OpenImage, "Open an image", false, true},
    BrowserRow{Dialog::SaveScene, "Save the scene", true, false},
};

std::vector<std::string> imageExtensions() {
    std::vector<std::string> extensions;
    for (const CodecRow& row : codecRows())
        std::ranges::copy(extensionsOf(row), std::back_inserter(extensions));
    return extensions;
}

void beginBrowsing(DialogsState& state, const Session& session) {
    const Dialog dialog = session.window.dialog;
    if (std::exchange(state.browsed, dialog) == dialog)
        return;
    const BrowserRow& row = *std::ranges::find(browserRows, dialog, &BrowserRow::dialog);
    beginBrowsing(state.browser, row.title,
                  row.thumbnails ? imageExtensions() : std::vector<std::string>{".json"}, row.saving,
                  session.document.file);
    state.browser.thumbnails = row.thumbnails;
}

void drawDiscard(Session& session) {
    if (!beginModal("Unsaved changes"))
        return;
    const std::string name =
        session.document.file.empty() ? "This scene" : session.document.file.filename().string();
    ImGui::TextUnformatted((printable(name) + " has changes that are not saved.").c_str());
    ImGui::Dummy({0, ImGui::GetFontSize() * 0.5F});
    const ImVec2 size(ImGui::GetFontSize() * 7.5F, 0);
    const bool keep = ImGui::Button("Save", size) || ImGui::IsKeyPressed(key::enter, false);
    noteItem("discard:save");
    ImGui::SameLine();
    const bool drop = ImGui::Button("Don't save", size);
    noteItem("discard:drop");
    ImGui::SameLine();
    const bool stay = ImGui::Button("Cancel", size) || ImGui::IsKeyPressed(key::escape, false);
    noteItem("discard:cancel");
    if (keep || drop || stay) {
        ImGui::CloseCurrentPopup();
        session.window.dialog = Dialog::None;
    }
    ImGui::EndPopup();
    if (stay) {
        session.window.pending = Pending::None;
        session.window.readyScene.reset();
    } else if (drop)
        finishPending(session);
    else if (keep)
        save(session);
}

/// A line for each file, with its reason: there may be hundreds.
void drawRefused(Session& session) {
    if (!beginModal("Files that could not be opened"))
        return;
    const float em = ImGui::GetFontSize();
    const std::size_t count = session.window.refused.size();
    ImGui::TextUnformatted(count == 1 ? "One file could not be opened, the others were."
                                      : fmt::format("{} files could not be opened.", count).c_str());
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float width = std::min(em * 46, display.x * 0.9F);
    const float height = std::min(display.y * 0.6F, em * 2.9F * static_cast<float>(count) + em);
    ImGui::PushStyleColor(ImGuiCol_ChildBg, color::ground);
    ImGui::BeginChild("refused", {width, height}, true);
    for (const Error& each : session.window.refused) {
        ImGui::PushTextWrapPos(0);
        ImGui::TextUnformatted(printable(describe(each)).c_str());
        ImGui::PopTextWrapPos();
        noteItem("refused:" + each.where);
    }
    ImGui::EndChild();
    ImGui::PopStyleColor();
    const bool read = ImGui::Button("Close", {em * 7, 0}) || ImGui::IsKeyPressed(key::escape, false) ||
                      ImGui::IsKeyPressed(key::enter, false);
    noteItem("refused:close");
    if (read) {
        session.window.refused.clear();
        session.window.dialog = Dialog::None;
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

/// What is to be said or asked without the user's having asked for it comes when nothing else is open.
void openWaitingDialog(Session& session) {
    if (session.window.dialog != Dialog::None || session.window.pending != Pending::None)
        return;
    if (!session.window.refused.empty())
        session.window.dialog = Dialog::Refused;
    else if (const UnsavedWork* unsaved = session.services.unsaved;
             unsaved && !unsaved->recovery.offers().empty() && session.document.loads.empty())
        session.window.dialog = Dialog::Restore;
}

/// What one does, and what comes of it: a table of two columns, to be closed with ImGui::EndTable() where
/// true.
bool beginHelpLines(const char* id) {
    if (!ImGui::BeginTable(id, 2, ImGuiTableFlags_NoSavedSettings))
        return false;
    ImGui::TableSetupColumn("keys", ImGuiTableColumnFlags_WidthFixed);
    ImGui::TableSetupColumn("effect", ImGuiTableColumnFlags_WidthStretch);
    return true;
}

void helpLine(const char* keys, const char* effect) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(keys);
    ImGui::TableNextColumn();
    ImGui::PushTextWrapPos(0);
    ImGui::TextDisabled("%s", effect);
    ImGui::PopTextWrapPos();
}

void drawMouse() {
    if (!beginHelpLines("mouse"))
        return;
    for (const Line& line : mouseLines)
        helpLine(line.keys, line.effect);
    ImGui::EndTable();
}

/// A row for each thing that keys do, with all keys that do it.
void drawKeys() {
    if (!beginHelpLines("keys"))
        return;
    const std::span<const Shortcut> rows = shortcuts();
    for (auto row = rows.begin(); row != rows.end();) {
        std::string keys = labelOf(*row);
        const char* effect = row->effect;
        for (++row; row != rows.end() && row->name.empty(); ++row) {
            if (const std::string other = labelOf(*row); keys.find(other) == std::string::npos)
                keys += ", " + other;
        }
        helpLine(keys.c_str(), effect);
    }
    for (const Line& line : otherKeys)
        helpLine(line.keys, line.effect);
    ImGui::EndTable();
}

struct Legend {
    const char* text;
    ThemeColor ink;
};

constexpr std::array legends{
    Legend{"s, x", color::s},
    Legend{"t, y", color::t},
    Legend{"r, z", color::r},
    Legend{"q, w", color::q},
    Legend{"chosen vertex", color::chosen},
    Legend{"explained pixel and its texels", color::probed},
    Legend{"changed from the initial value", color::changed},
    Legend{"something is wrong", color::problem},
};

void drawColors() {
    for (const Legend& legend : legends) {
        ImGui::PushStyleColor(ImGuiCol_Text, legend.ink);
        ImGui::Text("● %s", legend.text);
        ImGui::PopStyleColor();
    }
}

void drawHelp(Session& session) {
    if (!beginModal("Texplorer"))
        return;
    const float em = ImGui::GetFontSize();
    ImGui::PushTextWrapPos(std::min(em * 60, ImGui::GetIO().DisplaySize.x * 0.9F));
    ImGui::TextUnformatted(
        "See what each texture parameter of OpenGL does: change it on the left, look at the middle, "
        "find the texture coordinates on the right. Rest the pointer on anything: the lower edge of the "
        "window says what it is, and its OpenGL call.");
    ImGui::PopTextWrapPos();
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float room = std::max(em * 6, display.y * 0.92F - em * 9); // below the words, above the button
    const ImVec2 half(std::min(em * 31, display.x * 0.45F), std::min(em * 50, room));
    ImGui::BeginChild("left", half);
    caption("Keys");
    drawKeys();
    ImGui::EndChild();
    ImGui::SameLine();
    ImGui::BeginChild("right", half);
    caption("Mouse");
    drawMouse();
    caption("Colours");
    drawColors();
    ImGui::EndChild();
    if (ImGui::Button("Close", {em * 7, 0}) || ImGui::IsKeyPressed(key::escape, false) ||
        ImGui::IsKeyPressed(key::enter, false)) {
        session.window.dialog = Dialog::None;
        ImGui::CloseCurrentPopup();
    }
    noteItem("help:close");
    ImGui::EndPopup();
}

Result<void> answer(Session& session, Dialog dialog, const std::filesystem::path& chosen) {
    if (dialog == Dialog::OpenScene)
        return openScene(session, chosen);
    if (dialog == Dialog::SaveScene)
        return saveScene(session, chosen);
    const std::string param = std::exchange(session.window.imageParam, {});
    if (param.empty())
        importImage(session, chosen);
    else
        chooseFile(session, param, chosen);
    return {};
}

void drawBrowserDialog(Session& session, DialogsState& state, const Pictures& pictures) {
    beginBrowsing(state, session);
    std::filesystem::path chosen;
    const Dialog dialog = session.window.dialog;
    const Browsing browsing = drawFileBrowser(state.browser, session.services.files, pictures, chosen);
    if (browsing == Browsing::Open)
        return;
    session.window.dialog = Dialog::None;
    if (browsing == Browsing::Cancelled) {
        session.window.pending = Pending::None;
        return;
    }
    const Result<void> result = answer(session, dialog, chosen);
    if (!result) { // back to the list, which says what was wrong
        session.window.dialog = dialog;
        state.browser.error = result.error().message;
        state.browser.focusName = true;
        return;
    }
    session.window.notice = {};
    if (dialog == Dialog::SaveScene)
        finishPending(session);
}

} // namespace

void drawDialogs(Session& session, DialogsState& state, const Pictures& pictures) {
    openWaitingDialog(session);
    const Dialog dialog = session.window.dialog;
    if (std::ranges::find(browserRows, dialog, &BrowserRow::dialog) != browserRows.end())
        drawBrowserDialog(session, state, pictures);
    else if (dialog == Dialog::Discard)
        drawDiscard(session);
    else if (dialog == Dialog::Help)
        drawHelp(session);
    else if (dialog == Dialog::Restore)
        drawRestore(session, pictures);
    else if (dialog == Dialog::Refused)
        drawRefused(session);
    if (session.window.dialog != state.browsed) // the next one begins anew
        state.browsed = Dialog::None;
}

} // namespace texplorer::ui

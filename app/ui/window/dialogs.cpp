#include "app/ui/window/dialogs.h"

#include "app/ui/model/asking.h"
#include "app/ui/model/scene_files.h"
#include "app/ui/widgets/keys.h"
#include "app/ui/widgets/modal.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/window/recovery_dialog.h"
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
    Line{"hold E, click with Explain open", "explain the pixel under the mouse"},
    Line{"Ctrl + wheel, Ctrl + drag", "enlarge the pixels of the picture, move it"},
    Line{"Click", "pick the nearest vertex"},
    Line{"Double click", "frame all models"},
    Line{"Right click on a value", "reset it to GL's initial value"},
    Line{"Double click on a number", "type it"},
};

constexpr std::array keyLines{
    Line{"Ctrl+Z, Ctrl+Shift+Z", "undo, redo (Ctrl+Y too)"},
    Line{"Ctrl+O, Ctrl+I", "open a scene, open an image"},
    Line{"Ctrl+S, Ctrl+Shift+S", "save, save as"},
    Line{"Space", "play or pause"},
    Line{"1, 2, 3, 4", "draw by fixed function, by shaders, by the reference; compare"},
    Line{"M", "magnifier: the pixels under the mouse and their colours"},
    Line{"0", "no longer enlarge the pixels"},
    Line{"Escape", "let go of the picked texel, then of the explained pixel"},
    Line{"F", "frame all models"},
    Line{"Home", "reset the camera"},
    Line{"Ctrl+Q", "quit"},
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

void lines(const char* id, std::span<const Line> rows) {
    if (!ImGui::BeginTable(id, 2, ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_NoSavedSettings))
        return;
    for (const Line& line : rows) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(line.keys);
        ImGui::TableNextColumn();
        ImGui::Dummy({ImGui::GetFontSize(), 0});
        ImGui::SameLine();
        ImGui::TextDisabled("%s", line.effect);
    }
    ImGui::EndTable();
}

void drawHelp(Session& session) {
    if (!beginModal("Texplorer"))
        return;
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * 32);
    ImGui::TextUnformatted(
        "See what each texture parameter of OpenGL does: change it on the left, look at the middle, "
        "find the texture coordinates on the right. Every control says its GL call when the mouse "
        "rests on it.");
    ImGui::PopTextWrapPos();
    caption("Mouse");
    lines("mouse", mouseLines);
    caption("Keys");
    lines("keys", keyLines);
    caption("Colours");
    constexpr std::array names{"s, x", "t, y", "r, z", "q, w"};
    for (int i = 0; i < 4; ++i) {
        ImGui::PushStyleColor(ImGuiCol_Text, componentColor(i));
        ImGui::Text("● %s", names[static_cast<std::size_t>(i)]);
        ImGui::PopStyleColor();
        ImGui::SameLine();
    }
    ImGui::PushStyleColor(ImGuiCol_Text, color::chosen);
    ImGui::TextUnformatted("● chosen vertex");
    ImGui::PopStyleColor();
    ImGui::SameLine();
    ImGui::PushStyleColor(ImGuiCol_Text, color::changed);
    ImGui::TextUnformatted("● changed from the initial value");
    ImGui::PopStyleColor();
    ImGui::Dummy({0, ImGui::GetFontSize() * 0.4F});
    if (ImGui::Button("Close", {ImGui::GetFontSize() * 7, 0}) || ImGui::IsKeyPressed(key::escape, false) ||
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

#include "app/ui/model/document.h"
#include "app/ui/widgets/keys.h"
#include "app/ui/widgets/modal.h"
#include "app/ui/window/panels.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/theme.h"
#include "core/base/printable.h"
#include "core/codec/registry.h"

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

std::vector<std::string> imageExtensions() {
    std::vector<std::string> extensions;
    for (const CodecRow& row : codecRows())
        std::ranges::copy(extensionsOf(row), std::back_inserter(extensions));
    return extensions;
}

void browse(Session& session, Dialog dialog, const char* title, std::vector<std::string> extensions,
            bool saving) {
    session.dialog = dialog;
    beginBrowsing(session.browser, title, std::move(extensions), saving, session.file);
    session.browser.thumbnails = dialog == Dialog::OpenImage && session.background != nullptr;
}

void finishPending(Session& session) {
    const Pending pending = session.pending;
    session.pending = Pending::None;
    switch (pending) {
    case Pending::None:
        break;
    case Pending::NewScene:
        newScene(session);
        break;
    case Pending::OpenScene:
        browse(session, Dialog::OpenScene, "Open a scene", {".json"}, false);
        break;
    case Pending::OpenFiles: {
        const std::vector<std::filesystem::path> files = std::move(session.pendingFiles);
        session.pendingFiles.clear();
        report(session, openFiles(session, files), files.front());
        break;
    }
    case Pending::ShowScene:
        if (const std::shared_ptr<Load> ready = std::exchange(session.readyScene, nullptr)) {
            ready->before = session.scene; // the user has answered
            showLoadedScene(session, std::move(*ready));
        }
        break;
    case Pending::Quit:
        session.quitConfirmed = true;
        break;
    }
}

void askAboutChanges(Session& session, Pending next) {
    session.pending = next;
    if (isDirty(session))
        session.dialog = Dialog::Discard;
    else
        finishPending(session);
}

void drawDiscard(Session& session) {
    if (!beginModal("Unsaved changes"))
        return;
    const std::string name = session.file.empty() ? "This scene" : session.file.filename().string();
    ImGui::TextUnformatted((printable(name) + " has changes that are not saved.").c_str());
    ImGui::Dummy({0, ImGui::GetFontSize() * 0.5F});
    const ImVec2 size(ImGui::GetFontSize() * 7.5F, 0);
    const bool keep = ImGui::Button("Save", size) || ImGui::IsKeyPressed(key::enter, false);
    noteItem(session, "discard:save");
    ImGui::SameLine();
    const bool drop = ImGui::Button("Don't save", size);
    noteItem(session, "discard:drop");
    ImGui::SameLine();
    const bool stay = ImGui::Button("Cancel", size) || ImGui::IsKeyPressed(key::escape, false);
    noteItem(session, "discard:cancel");
    if (keep || drop || stay) {
        ImGui::CloseCurrentPopup();
        session.dialog = Dialog::None;
    }
    ImGui::EndPopup();
    if (stay) {
        session.pending = Pending::None;
        session.readyScene.reset();
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
    const std::size_t count = session.refused.size();
    ImGui::TextUnformatted(count == 1 ? "One file could not be opened, the others were."
                                      : (std::to_string(count) + " files could not be opened.").c_str());
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float width = std::min(em * 46, display.x * 0.9F);
    const float height = std::min(display.y * 0.6F, em * 2.9F * static_cast<float>(count) + em);
    ImGui::PushStyleColor(ImGuiCol_ChildBg, color::ground);
    ImGui::BeginChild("refused", {width, height}, true);
    for (const Error& each : session.refused) {
        ImGui::PushTextWrapPos(0);
        ImGui::TextUnformatted(printable(describe(each)).c_str());
        ImGui::PopTextWrapPos();
        noteItem(session, "refused:" + each.where);
    }
    ImGui::EndChild();
    ImGui::PopStyleColor();
    const bool read = ImGui::Button("Close", {em * 7, 0}) || ImGui::IsKeyPressed(key::escape, false) ||
                      ImGui::IsKeyPressed(key::enter, false);
    noteItem(session, "refused:close");
    if (read) {
        session.refused.clear();
        session.dialog = Dialog::None;
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

/// What is to be said or asked without the user's having asked for it comes when nothing else is open.
void openWaitingDialog(Session& session) {
    if (session.dialog != Dialog::None || session.pending != Pending::None)
        return;
    if (!session.refused.empty())
        session.dialog = Dialog::Refused;
    else if (session.unsaved && !session.unsaved->recovery.offers().empty() && session.loads.empty())
        session.dialog = Dialog::Restore;
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
        session.dialog = Dialog::None;
        ImGui::CloseCurrentPopup();
    }
    noteItem(session, "help:close");
    ImGui::EndPopup();
}

void drawBrowserDialog(Session& session, const Pictures& pictures) {
    std::filesystem::path chosen;
    const Dialog dialog = session.dialog;
    const Browsing browsing = drawFileBrowser(session, pictures, chosen);
    if (browsing == Browsing::Open)
        return;
    session.dialog = Dialog::None;
    if (browsing == Browsing::Cancelled) {
        session.pending = Pending::None;
        return;
    }
    const Result<void> result = dialog == Dialog::OpenScene   ? openScene(session, chosen)
                                : dialog == Dialog::OpenImage ? importImage(session, chosen)
                                                              : saveScene(session, chosen);
    if (!result) { // back to the list, which says what was wrong
        session.dialog = dialog;
        session.browser.error = result.error().message;
        session.browser.focusName = true;
        return;
    }
    session.notice = {};
    if (dialog == Dialog::SaveScene)
        finishPending(session);
}

} // namespace

void askOpenScene(Session& session) {
    askAboutChanges(session, Pending::OpenScene);
}

void askOpenImage(Session& session) {
    browse(session, Dialog::OpenImage, "Open an image", imageExtensions(), false);
}

void askNewScene(Session& session) {
    askAboutChanges(session, Pending::NewScene);
}

void askSaveAs(Session& session) {
    browse(session, Dialog::SaveScene, "Save the scene", {".json"}, true);
}

void save(Session& session) {
    if (session.file.empty())
        return askSaveAs(session);
    const Result<void> saved = saveScene(session, session.file);
    report(session, saved);
    if (saved) {
        session.notice = {};
        finishPending(session);
    } else {
        session.pending = Pending::None;
    }
}

void requestQuit(Session& session) {
    askAboutChanges(session, Pending::Quit);
}

void requestOpen(Session& session, std::vector<std::filesystem::path> files) {
    if (files.size() == 1) {
        if (const Result<bool> scene = holdsScene(files.front()); !scene)
            return say(session, scene.error());
    }
    const bool replaces = std::ranges::any_of(
        files, [](const std::filesystem::path& file) { return holdsScene(file).value_or(false); });
    if (files.empty())
        return;
    if (!replaces)
        return report(session, openFiles(session, files), files.front());
    session.pendingFiles = std::move(files);
    askAboutChanges(session, Pending::OpenFiles);
}

void drawDialogs(Session& session, const Pictures& pictures) {
    openWaitingDialog(session);
    switch (session.dialog) {
    case Dialog::None:
        break;
    case Dialog::OpenScene:
    case Dialog::OpenImage:
    case Dialog::SaveScene:
        drawBrowserDialog(session, pictures);
        break;
    case Dialog::Discard:
        drawDiscard(session);
        break;
    case Dialog::Help:
        drawHelp(session);
        break;
    case Dialog::Restore:
        drawRestore(session, pictures);
        break;
    case Dialog::Refused:
        drawRefused(session);
        break;
    }
}

} // namespace texplorer::ui

#include "app/ui/document.h"
#include "app/ui/keys.h"
#include "app/ui/panels.h"
#include "app/ui/param_widgets.h"
#include "app/ui/theme.h"
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
    case Pending::OpenFile:
        report(session, openFile(session, session.pendingFile), session.pendingFile);
        break;
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

/// A modal in the middle of the window, as large as its content. To be closed with ImGui::EndPopup() where
/// true.
bool beginModal(const char* title) {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    if (!ImGui::IsPopupOpen(title))
        ImGui::OpenPopup(title);
    ImGui::SetNextWindowPos({display.x / 2, display.y / 2}, ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::SetNextWindowSizeConstraints({0, 0}, {display.x * 0.96F, display.y * 0.94F});
    return ImGui::BeginPopupModal(title, nullptr,
                                  ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove |
                                      ImGuiWindowFlags_NoSavedSettings);
}

void drawDiscard(Session& session) {
    if (!beginModal("Unsaved changes"))
        return;
    const std::string name = session.file.empty() ? "This scene" : session.file.filename().string();
    ImGui::TextUnformatted((name + " has changes that are not saved.").c_str());
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

void requestOpen(Session& session, const std::filesystem::path& path) {
    const Result<bool> scene = holdsScene(path);
    if (!scene)
        return say(session, scene.error());
    session.pendingFile = path;
    if (!*scene)
        return report(session, importImage(session, path), path);
    askAboutChanges(session, Pending::OpenFile);
}

void drawDialogs(Session& session, const Pictures& pictures) {
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
    }
}

} // namespace texplorer::ui

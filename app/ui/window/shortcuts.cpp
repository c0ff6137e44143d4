#include "app/ui/window/shortcuts.h"

#include "app/ui/files/asking.h"
#include "app/ui/files/scene_files.h"
#include "app/ui/language/translate.h"
#include "app/ui/model/explaining.h"
#include "app/ui/model/kept.h"
#include "app/ui/model/lesson_key_edits.h"
#include "app/ui/model/notice.h"
#include "app/ui/model/timeline_edits.h"
#include "app/ui/view/framing.h"
#include "app/ui/view/renderer_choice.h"
#include "app/ui/widgets/keys.h"
#include "app/ui/window/notes.h"
#include "app/ui/window/text_size.h"
#include "texplorer/scene/storage/scene_link.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cassert>

namespace texplorer::ui {
namespace {

template<RendererKind renderer>
void drawBy(Session& session, const Layout& /*layout*/) {
    showOne(session.view, renderer);
    if (!session.view.offered.has(renderer))
        say(session, helpOf(session.view, rowOf(renderer)));
}

/// One after the other.
void letGo(Session& session, const Layout& /*layout*/) {
    if (session.window.spotlight)
        session.window.spotlight = false;
    else if (maximisedOf(session.settings.workspace) != Maximised::None)
        session.settings.workspace.maximised = Maximised::None;
    else if (session.look.explaining.texel)
        clearTexel(session);
    else if (session.look.explaining.pinned)
        session.look.explaining.pinned.reset();
    else
        session.look.explaining.pixel.reset();
}

/// Reports errors.
void pasteScene(Session& session) {
    const char* text = ImGui::GetClipboardText();
    if (!text || !isSceneLink(text))
        return say(session, N_("The clipboard has no link to a scene."));
    if (const Result<void> opened = openSceneLink(session, text); !opened)
        say(session, Sentence("The scene can't be pasted: {0}.", describe(opened.error())));
}

/// For actions that need no layout.
template<void (*act)(Session& session)>
void runs(Session& session, const Layout& /*layout*/) {
    act(session);
}

template<class Asked>
void asks(Session& session, const Layout& /*layout*/) {
    session.out.requests.emplace_back(Asked{});
}

template<int steps>
void resizeText(Session& session) {
    changeTextSize(session, steps);
}

template<int steps>
void walkKeys(Session& session) {
    goToKey(session, steps);
}

constexpr std::array shortcutRows{
    Shortcut{"undo", 'Z', true, false, N_("undo the last edit"), asks<Undo>, true},
    Shortcut{"redo", 'Z', true, true, N_("redo the last undone edit"), asks<Redo>, true},
    Shortcut{"", 'Y', true, false, N_("redo the last undone edit"), asks<Redo>, true},
    Shortcut{N_("new scene"), 'N', true, false, N_("start a new scene"), runs<askNewScene>},
    Shortcut{N_("open scene"), 'O', true, false, N_("open a scene"), runs<askOpenScene>},
    Shortcut{N_("open image"), 'I', true, false, N_("open an image"),
             [](Session& s, const Layout&) { askOpenImage(s); }},
    Shortcut{"save", 'S', true, false, N_("save the scene"), runs<save>},
    Shortcut{N_("save as"), 'S', true, true, N_("save under another name"), runs<askSaveAs>},
    Shortcut{"paste", 'V', true, false, N_("open the scene of a link in the clipboard"), runs<pasteScene>},
    Shortcut{"search", 'F', true, false, N_("search the parameters"),
             [](Session& s, const Layout&) { s.out.wantsSearch = true; }},
    Shortcut{"quit", 'Q', true, false, N_("quit Texplorer"), runs<requestQuit>},
    Shortcut{"play", key::space, false, false, N_("play or pause"),
             [](Session& s, const Layout&) { s.look.playback.playing = !s.look.playback.playing; }},
    Shortcut{"previous-key", ',', false, false, N_("go to the previous key frame"), runs<walkKeys<-1>>, true},
    Shortcut{"next-key", '.', false, false, N_("go to the next key frame"), runs<walkKeys<1>>, true},
    Shortcut{"fixed", '1', false, false, N_("draw with OpenGL's fixed function"),
             drawBy<RendererKind::Fixed>},
    Shortcut{"shader", '2', false, false, N_("draw with shaders"), drawBy<RendererKind::Shader>},
    Shortcut{"reference", '3', false, false, N_("draw with the reference"), drawBy<RendererKind::Reference>},
    Shortcut{"compare", '4', false, false, N_("compare two renderers"),
             [](Session& s, const Layout&) { showComparison(s.view); }},
    Shortcut{"keep", 'K', false, false, N_("keep the scene as A"), runs<keepAsA>},
    Shortcut{"flip", 'T', false, false, N_("switch between A and now"), runs<flipKept>},
    Shortcut{"split", 'T', false, true, N_("split A and now"), runs<splitKept>},
    Shortcut{"magnifier", 'M', false, false, N_("magnifier: the pixels under the mouse and their colours"),
             [](Session& s, const Layout&) { s.view.magnifies = !s.view.magnifies; }},
    Shortcut{N_("pixel for pixel"), '0', false, false, N_("reset the enlargement"),
             [](Session& s, const Layout&) { s.view.zoom = {}; }},
    Shortcut{"note", 'N', false, false, N_("add a note over the view at the pointer"), addNoteAtPointer},
    Shortcut{"spotlight", 'L', false, false, N_("spotlight: dim everything except near the pointer"),
             [](Session& s, const Layout&) { s.window.spotlight = !s.window.spotlight; }},
    Shortcut{"frame", 'F', false, false, N_("frame all models"),
             [](Session& s, const Layout& layout) { frameAll(s, layout); }},
    Shortcut{N_("reset camera"), key::home, false, false, N_("reset the camera"),
             [](Session& s, const Layout& layout) { resetCamera(s, layout); }},
    Shortcut{
        N_("let go"), key::escape, false, false,
        N_("release the spotlight, the maximised panel, the picked texel, the pinned pixel or the explained "
           "pixel"),
        letGo},
    Shortcut{N_("larger text"), '=', true, false, N_("larger text"), runs<resizeText<1>>, true},
    Shortcut{"", '=', true, true, N_("larger text"), runs<resizeText<1>>, true},
    Shortcut{"", key::keypadPlus, true, false, N_("larger text"), runs<resizeText<1>>, true},
    Shortcut{N_("smaller text"), '-', true, false, N_("smaller text"), runs<resizeText<-1>>, true},
    Shortcut{"", key::keypadMinus, true, false, N_("smaller text"), runs<resizeText<-1>>, true},
    Shortcut{N_("usual text"), '0', true, false, N_("text of normal size"),
             [](Session& s, const Layout&) { s.settings.textPercent = Settings{}.textPercent; }},
    Shortcut{N_("view alone"), key::tab, false, false, N_("show only the view, and back"),
             [](Session& s, const Layout&) { toggleMaximised(s.settings.workspace, Maximised::View); }},
    Shortcut{N_("full screen"), key::f11, false, false, N_("full screen"),
             [](Session& s, const Layout&) { s.window.fillsScreen = !s.window.fillsScreen; }},
    Shortcut{N_("window picture"), key::f12, false, false, N_("write a picture of the window"),
             [](Session& s, const Layout&) { s.window.wantedCapture = Capture::Window; }},
    Shortcut{N_("view picture"), key::f12, false, true, N_("write a picture of the view"),
             [](Session& s, const Layout&) { s.window.wantedCapture = Capture::View; }},
    Shortcut{"help", key::f1, false, false, N_("keys and mouse"),
             [](Session& s, const Layout&) { s.asking.dialog = Dialog::Help; }},
};

struct KeyName {
    int key;
    const char* name;
};

constexpr std::array keyNames{
    KeyName{key::space, N_("Space")},
    KeyName{key::escape, N_("Escape")},
    KeyName{key::tab, N_("Tab")},
    KeyName{key::home, N_("Home")},
    KeyName{'=', "+"},
    KeyName{'-', "−"},
    KeyName{key::keypadPlus, "+"},
    KeyName{key::keypadMinus, "−"},
    KeyName{key::f1, "F1"},
    KeyName{key::f11, "F11"},
    KeyName{key::f12, "F12"},
};

std::string nameOfKey(int key) {
    const auto* named = std::ranges::find(keyNames, key, &KeyName::key);
    return named != keyNames.end() ? named->name : std::string(1, static_cast<char>(key));
}

} // namespace

std::span<const Shortcut> shortcuts() {
    return shortcutRows;
}

const Shortcut& shortcutOf(std::string_view name) {
    const auto* row = std::ranges::find(shortcutRows, name, &Shortcut::name);
    assert(row != shortcutRows.end());
    return *row;
}

std::string labelOf(const Shortcut& shortcut) {
    std::string label;
    if (shortcut.control)
        label += N_("Ctrl+");
    if (shortcut.shift)
        label += N_("Shift+");
    return label + tr(nameOfKey(shortcut.key));
}

bool isTaken(const Session& session, const Shortcut& shortcut) {
    return !shortcut.control && !shortcut.shift && isTakenByLesson(session, nameOfKey(shortcut.key));
}

std::string keysOf(const Session& session, std::string_view name) {
    const Shortcut& row = shortcutOf(name);
    return isTaken(session, row) ? std::string() : labelOf(row);
}

void handleShortcuts(const Session& session, const Layout& layout) {
    const ImGuiIO& io = ImGui::GetIO();
    // A dialog has its own keys, a text field its own undo, and undo must not interfere with a drag.
    if (session.asking.dialog != Dialog::None || io.WantTextInput || ImGui::IsAnyItemActive() ||
        session.out.keyTaken)
        return;
    for (const Shortcut& row : shortcutRows) {
        if (io.KeyCtrl == row.control && io.KeyShift == row.shift && !io.KeyAlt && !io.KeySuper &&
            isKeyPressed(row.key, row.repeats))
            act(session, [&row, layout](Session& s) { row.act(s, layout); });
    }
}

} // namespace texplorer::ui

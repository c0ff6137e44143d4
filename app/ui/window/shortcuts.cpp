#include "app/ui/window/shortcuts.h"

#include "app/ui/model/asking.h"
#include "app/ui/model/scene_files.h"
#include "app/ui/view/framing.h"
#include "app/ui/view/renderer_choice.h"
#include "app/ui/widgets/keys.h"

namespace texplorer::ui {

void handleShortcuts(Session& session, const Layout& layout) {
    const ImGuiIO& io = ImGui::GetIO();
    // A dialog has its own keys, a text field its own undo, and a drag is not to be undone under the hand.
    if (session.window.dialog != Dialog::None || io.WantTextInput || ImGui::IsAnyItemActive())
        return;
    const auto pressed = [](int code, bool repeat = false) { return ImGui::IsKeyPressed(code, repeat); };
    if (io.KeyCtrl) {
        if (pressed('Z', true))
            io.KeyShift ? redo(session) : undo(session);
        if (pressed('Y', true))
            redo(session);
        if (pressed('O'))
            askOpenScene(session);
        if (pressed('I'))
            askOpenImage(session);
        if (pressed('S'))
            io.KeyShift ? askSaveAs(session) : save(session);
        if (pressed('Q'))
            requestQuit(session);
        return;
    }
    if (pressed(key::space))
        session.window.playback.playing = !session.window.playback.playing;
    int digit = '1';
    for (const EnumRow& row : EnumTable<RendererKind>::rows) {
        if (!pressed(digit++))
            continue;
        const auto renderer = static_cast<RendererKind>(row.value);
        showOne(session.window.view, renderer);
        if (!session.window.view.offered.has(renderer))
            say(session, helpOf(session.window.view, row));
    }
    if (pressed(digit))
        showComparison(session.window.view);
    if (pressed('M'))
        session.window.view.magnifies = !session.window.view.magnifies;
    if (pressed('0'))
        session.window.view.zoom = {};
    if (pressed(key::escape)) { // one after the other
        if (session.window.explaining.texel)
            clearTexel(session);
        else
            session.window.explaining.pixel.reset();
    }
    if (pressed('F'))
        frameAll(session, layout);
    if (pressed(key::home))
        resetCamera(session, layout);
    if (pressed(key::f1))
        session.window.dialog = Dialog::Help;
}

} // namespace texplorer::ui

#include "app/ui/view/camera.h"
#include "app/ui/widgets/keys.h"
#include "app/ui/window/panels.h"
#include "app/ui/view/probed_pixel.h"

#include <algorithm>

namespace texplorer::ui {

namespace {

float aspectOf(const Layout& layout) {
    return static_cast<float>(layout.picture.width) / static_cast<float>(layout.picture.height);
}

} // namespace

void resetCamera(Session& session, const Layout& layout) {
    session.scene.view = defaultScene().view;
    fitDistance(session.scene, session.playback.time, aspectOf(layout));
    recordEdit(session, "Reset camera");
}

void frameAll(Session& session, const Layout& layout) {
    frameModels(session.scene, session.playback.time, aspectOf(layout));
    recordEdit(session, "Frame the models");
}

void show(Session& session, const ShowRow& row, const Layout& layout) {
    showOnly(session.scene, row.show, session.playback.time, aspectOf(layout));
    sealEdit(session);
    recordEdit(session, std::string("Show ") + row.label);
    sealEdit(session);
    const auto shown = std::ranges::find(session.scene.models, true, &Model::visible);
    session.selection.model = static_cast<int>(shown - session.scene.models.begin());
    session.selection.vertex.reset();
}

void handleShortcuts(Session& session, const Layout& layout) {
    const ImGuiIO& io = ImGui::GetIO();
    // A dialog has its own keys, a text field its own undo, and a drag is not to be undone under the hand.
    if (session.dialog != Dialog::None || io.WantTextInput || ImGui::IsAnyItemActive())
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
        session.playback.playing = !session.playback.playing;
    int digit = '1';
    for (const EnumRow& row : EnumTable<RendererKind>::rows) {
        if (pressed(digit++))
            showOne(session.views, static_cast<RendererKind>(row.value));
    }
    if (pressed(digit))
        showComparison(session.views);
    if (pressed('M'))
        session.views.magnifies = !session.views.magnifies;
    if (pressed('0'))
        session.views.zoom = {};
    if (pressed(key::escape)) { // one after the other
        if (session.explaining.texel)
            clearTexel(session);
        else
            session.explaining.pixel.reset();
    }
    if (pressed('F'))
        frameAll(session, layout);
    if (pressed(key::home))
        resetCamera(session, layout);
    if (pressed(key::f1))
        session.dialog = Dialog::Help;
}

} // namespace texplorer::ui

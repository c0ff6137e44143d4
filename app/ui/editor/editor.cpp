#include "app/ui/editor/editor.h"

#include "app/ui/editor/followed_selection.h"
#include "app/ui/model/explaining.h"
#include "app/ui/model/notice.h"
#include "app/ui/model/requests.h"
#include "app/ui/model/session.h"
#include "app/ui/model/timeline_edits.h"
#include "texplorer/scene/animation.h"

#include <algorithm>
#include <utility>

namespace texplorer::ui {
namespace {

/// Records the document's scene for undo.
void record(Session& session, const Step& step) {
    Document& document = session.document;
    if (session.look.notice.isGood)
        session.look.notice = {}; // messages about earlier actions are out of date
    if (!step.continues)
        document.history.seal();
    document.history.record(document.scene, step.name);
    if (!step.continues)
        document.history.seal();
    document.lastChanged = step.path;
}

bool appliesPreset(const Step& step) {
    return std::ranges::any_of(
        step.edits, [](const Edit& each) { return std::holds_alternative<edit::ApplyPreset>(each); });
}

void selectAfter(Session& session, const Step& step) {
    Selection& selection = session.look.selection;
    bool renumbered = false;
    for (const Edit& each : step.edits)
        renumbered |= follow(selection, each);
    const int model = step.select ? std::exchange(selection, *step.select).model : selection.model;
    if (selection.model != model || appliesPreset(step))
        leaveHiddenModel(session);
    bringSelectionBack(session);
    if (renumbered)
        clearTexel(session); // it may belong to another model or pass
}

void showStep(Session& session, const Scene& scene) {
    session.document.scene = scene;
    showPresent(session);
    leaveHiddenModel(session);
    bringSelectionBack(session);
    session.document.lastChanged.clear();
}

void take(Session& session, EndStep /*end*/) {
    session.document.history.seal();
}

void take(Session& session, DropStep /*drop*/) {
    showStep(session, session.document.history.takeBack());
}

void take(Session& session, Undo /*undo*/) {
    if (session.document.history.canUndo())
        showStep(session, session.document.history.undo());
}

void take(Session& session, Redo /*redo*/) {
    if (session.document.history.canRedo())
        showStep(session, session.document.history.redo());
}

void take(Session& session, const Action& action) {
    action(session);
}

void take(Session& session, GoToStep to) {
    showStep(session, session.document.history.goTo(to.step));
}

void take(Session& session, const Step& step) {
    Scene& scene = session.document.scene;
    Playback& playback = session.look.playback;
    const bool moved = isAnimated(scene);
    const Result<bool> keyed =
        makeEditsAt(scene, step.edits, {.shown = playback.time, .key = presentKeyTime(session)});
    if (!keyed)
        return say(session, keyed.error());
    record(session, step);
    if (*keyed)
        holdTime(session);
    else if (!moved && appliesPreset(step) && isAnimated(scene))
        playback.playing = true;
    showPresent(session);
    selectAfter(session, step);
    if (!step.says.empty())
        tell(session, step.says);
}

} // namespace

void takeRequests(Session& session) {
    // An action may make further requests; if it replaces the document, later ones are not for the new one.
    std::vector<Request>& waiting = session.out.requests;
    while (!waiting.empty()) {
        const std::size_t document = session.documents;
        for (const Request& request : std::exchange(waiting, {})) {
            if (session.documents == document || std::holds_alternative<Action>(request))
                std::visit([&](const auto& each) { take(session, each); }, request);
        }
    }
}

} // namespace texplorer::ui

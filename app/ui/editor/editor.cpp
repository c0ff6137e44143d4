#include "app/ui/editor/editor.h"

#include "app/ui/editor/followed_selection.h"
#include "app/ui/model/explaining.h"
#include "app/ui/model/notice.h"
#include "app/ui/model/preview.h"
#include "app/ui/model/requests.h"
#include "app/ui/model/session.h"
#include "app/ui/model/timeline_edits.h"
#include "texplorer/scene/animation.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>

namespace texplorer::ui {
namespace {

/// Removes a message about an earlier state of the scene.
void removeGoodNotice(Session& session) {
    if (session.look.notice.isGood)
        session.look.notice = {};
}

/// Records the document's scene for undo.
void record(Session& session, const Step& step, std::optional<Reselection> reselects) {
    Document& document = session.document;
    if (!step.continues)
        document.history.seal();
    document.history.record(document.scene, step.name, std::move(reselects));
    if (!step.continues)
        document.history.seal();
    document.lastChanged = step.path;
}

bool appliesPreset(const Step& step) {
    return std::ranges::any_of(
        step.edits, [](const Edit& each) { return std::holds_alternative<edit::ApplyPreset>(each); });
}

/// Returns true if the selected objects have other indices.
bool selectAfter(Session& session, const Step& step) {
    Selection& selection = session.look.selection;
    bool renumbered = false;
    for (const Edit& each : step.edits)
        renumbered |= follow(selection, each);
    const int model = step.select ? std::exchange(selection, *step.select).model : selection.model;
    if (selection.model != model || appliesPreset(step))
        leaveHiddenModel(session);
    bringSelectionBack(session);
    return renumbered;
}

/// Undoes or redoes.
void moveInHistory(Session& session, const std::function<void(History&, Selection&)>& move) {
    Document& document = session.document;
    Selection& selection = session.look.selection;
    const int model = selection.model;
    const int pass = selection.pass;
    move(document.history, selection);
    document.scene = document.history.current();
    showPresent(session);
    leaveHiddenModel(session);
    bringSelectionBack(session);
    if (selection.model != model || selection.pass != pass)
        clearTexel(session);
    removeGoodNotice(session);
    restPreview(session);
    document.lastChanged.clear();
}

void take(Session& session, EndStep /*end*/) {
    session.document.history.seal();
}

void take(Session& session, DropStep /*drop*/) {
    moveInHistory(session, [](History& history, Selection& selection) { history.takeBack(selection); });
}

void take(Session& session, Undo /*undo*/) {
    moveInHistory(session, [](History& history, Selection& selection) { history.undo(selection); });
}

void take(Session& session, Redo /*redo*/) {
    moveInHistory(session, [](History& history, Selection& selection) { history.redo(selection); });
}

void take(Session& session, const Action& action) {
    action(session);
}

void take(Session& session, GoToStep to) {
    moveInHistory(session,
                  [&to](History& history, Selection& selection) { history.goTo(to.step, selection); });
}

void take(Session& session, const Step& step) {
    Scene& scene = session.document.scene;
    Playback& playback = session.look.playback;
    const bool moved = isAnimated(scene);
    const Result<bool> keyed =
        makeEditsAt(scene, step.edits, {.shown = playback.time, .key = presentKeyTime(session)});
    if (!keyed)
        return say(session, keyed.error());
    session.document.images.fillMeshes(scene);
    removeGoodNotice(session);
    restPreview(session);
    if (*keyed)
        holdTime(session);
    else if (!moved && appliesPreset(step) && isAnimated(scene))
        playback.playing = true;
    showPresent(session);
    Reselection reselection{.before = session.look.selection};
    const bool renumbered = selectAfter(session, step);
    if (renumbered)
        clearTexel(session); // it may belong to another model or pass
    reselection.after = session.look.selection;
    record(session, step, renumbered || step.select ? std::optional(std::move(reselection)) : std::nullopt);
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

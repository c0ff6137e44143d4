#include "app/ui/editor/editor.h"

#include "app/ui/editor/followed_selection.h"
#include "app/ui/model/explaining.h"
#include "app/ui/model/scene_files.h"
#include "app/ui/model/session.h"
#include "app/ui/model/timeline_edits.h"
#include "core/scene/animation.h"

#include <algorithm>
#include <utility>

namespace texplorer::ui {
namespace {

bool appliesPreset(const Step& step) {
    return std::ranges::any_of(
        step.edits, [](const Edit& each) { return std::holds_alternative<edit::ApplyPreset>(each); });
}

void selectAfter(Session& session, const Step& step) {
    Selection& selection = session.window.selection;
    bool renumbered = false;
    for (const Edit& each : step.edits)
        renumbered |= follow(selection, each);
    if (step.select)
        selection = *step.select;
    if (step.select || appliesPreset(step))
        leaveHiddenModel(session);
    bringSelectionBack(session);
    if (renumbered)
        clearTexel(session); // it may belong to another model or pass
}

void take(Session& session, const Step& step) {
    endStanding(session);
    Scene& scene = session.document.scene;
    Playback& playback = session.window.playback;
    const bool moved = isAnimated(scene);
    const Result<bool> keyed =
        makeEditsAt(scene, step.edits, {.shown = playback.time, .key = presentKeyTime(session)});
    if (!keyed)
        return say(session, keyed.error());
    if (!step.continues)
        sealEdit(session);
    recordScene(session, step.name, step.path);
    if (!step.continues)
        sealEdit(session);
    selectAfter(session, step);
    if (*keyed)
        holdTime(session);
    else if (!moved && appliesPreset(step) && isAnimated(scene))
        playback.playing = true;
    if (!step.says.empty())
        tell(session, step.says);
}

} // namespace

void takeSteps(Session& session) {
    for (const Step& step : std::exchange(session.steps, {})) {
        if (step.edits.empty())
            sealEdit(session);
        else
            take(session, step);
    }
}

} // namespace texplorer::ui

#include "app/ui/editor/editor.h"

#include "app/ui/editor/followed_selection.h"
#include "app/ui/model/explaining.h"
#include "app/ui/model/scene_files.h"
#include "app/ui/model/session.h"
#include "app/ui/model/timeline_edits.h"
#include "core/scene/animation.h"
#include "core/scene/params/keys.h"

#include <algorithm>
#include <utility>

namespace texplorer::ui {
namespace {

bool appliesPreset(const Step& step) {
    return std::ranges::any_of(
        step.edits, [](const Edit& each) { return std::holds_alternative<edit::ApplyPreset>(each); });
}

/// Whether objects of the scene have other numbers afterwards, so that a texel may belong to another one.
bool renumbers(const Edit& edit) {
    return std::visit(
        [](const auto& each) {
            if constexpr (requires { each.list; })
                return each.list == keyOf<&Scene::models>() || each.list == keyOf<&Scene::passes>();
            else
                return false;
        },
        edit);
}

void selectAfter(Session& session, const Step& step) {
    Selection& selection = session.window.selection;
    for (const Edit& each : step.edits)
        follow(selection, each);
    if (step.select)
        selection = *step.select;
    if (step.select || appliesPreset(step))
        leaveHiddenModel(session);
    bringSelectionBack(session);
    if (std::ranges::any_of(step.edits, renumbers))
        clearTexel(session);
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
